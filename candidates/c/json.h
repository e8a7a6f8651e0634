/* A small reader of JSON: one text becomes one flat list of values.
 *
 * A value stands before all that it holds; an object holds its keys and their values in turn. Nothing
 * is copied: strings are places in the text, with their escapes as they came. Nesting deeper than
 * JSON_DEPTH is refused.
 */
#ifndef JSON_H
#define JSON_H

#include <stddef.h>
#include <stdint.h>

enum { JSON_DEPTH = 64 };

#define JSON_NONE SIZE_MAX /* no such value; every function takes it for one */

typedef enum { JSON_OTHER, JSON_NUMBER, JSON_STRING, JSON_ARRAY, JSON_OBJECT } JsonKind;

typedef struct {
    JsonKind kind;     /* JSON_OTHER: null, true, false */
    size_t start, end; /* where it is in the text, with its quotes and brackets */
    size_t count;      /* of an array: values; of an object: keys */
    size_t next;       /* index of the value behind it and all that it holds */
    double number;
} JsonValue;

typedef struct {
    const char *text;
    JsonValue *values; /* values[0] is the whole */
    size_t used, room;
} Json;

/* Reads text[0..length), which a NUL must follow. Returns NULL, or what is wrong. `json` may have been
 * used before: its memory is used again. */
const char *json_read(Json *json, const char *text, size_t length);

/* The value of a key, or JSON_NONE. */
size_t json_member(const Json *json, size_t object, const char *key);

/* The first value of an array; the others follow by `next`. JSON_NONE unless there are `count`. */
size_t json_items(const Json *json, size_t array, size_t count);

/* Whether it is this string. */
int json_is(const Json *json, size_t value, const char *string);

/* A number, or one of the strings "inf", "-inf", "NaN". Returns whether it is one. */
int json_double(const Json *json, size_t value, double *number);

#endif
