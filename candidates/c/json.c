#include "json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    Json *json;
    size_t at, length;
    const char *error;
} Reader;

static const char *const no_json = "not JSON";

static char here(const Reader *r) { return r->at < r->length ? r->json->text[r->at] : '\0'; }

static int take(Reader *r, char c)
{
    if (here(r) != c || r->at >= r->length) return 0;
    r->at++;
    return 1;
}

static void skip_space(Reader *r)
{
    while (take(r, ' ') || take(r, '\t') || take(r, '\n') || take(r, '\r')) continue;
}

/* A new value that begins here; its index. */
static size_t begin(Reader *r, JsonKind kind)
{
    Json *j = r->json;
    if (j->used == j->room) {
        size_t room = j->room ? 2 * j->room : 256;
        JsonValue *values =
            room <= SIZE_MAX / sizeof *values ? realloc(j->values, room * sizeof *values) : NULL;
        if (!values) {
            r->error = "out of memory";
            return JSON_NONE;
        }
        j->values = values;
        j->room = room;
    }
    j->values[j->used] = (JsonValue){.kind = kind, .start = r->at, .number = NAN};
    return j->used++;
}

static size_t digits(Reader *r)
{
    size_t from = r->at;
    while (here(r) >= '0' && here(r) <= '9') r->at++;
    return r->at - from;
}

static int number(Reader *r, double *value)
{
    size_t from = r->at;
    take(r, '-');
    if (!take(r, '0') && !digits(r)) return 0;
    if (take(r, '.') && !digits(r)) return 0;
    if (take(r, 'e') || take(r, 'E')) {
        if (!take(r, '+')) take(r, '-');
        if (!digits(r)) return 0;
    }
    *value = strtod(r->json->text + from, NULL);
    return 1;
}

static int hexadecimal(char c)
{
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

static int string(Reader *r)
{
    if (!take(r, '"')) return 0;
    while (r->at < r->length && here(r) != '"') {
        if ((unsigned char)here(r) < 0x20) return 0;
        if (take(r, '\\')) {
            if (here(r) == 'u') {
                for (int i = 0; i < 4; i++) {
                    r->at++;
                    if (!hexadecimal(here(r))) return 0;
                }
            } else if (here(r) == '\0' || !strchr("\"\\/bfnrt", here(r))) {
                return 0;
            }
        }
        r->at++;
    }
    return take(r, '"');
}

static int word(Reader *r, const char *text)
{
    size_t length = strlen(text);
    if (r->length - r->at < length || memcmp(r->json->text + r->at, text, length)) return 0;
    r->at += length;
    return 1;
}

static int value(Reader *r, int depth);

static int key(Reader *r)
{
    skip_space(r);
    size_t index = begin(r, JSON_STRING);
    if (index == JSON_NONE || !string(r)) return 0;
    r->json->values[index].end = r->at;
    r->json->values[index].next = r->json->used;
    skip_space(r);
    return take(r, ':');
}

/* What stands between the brackets of an array or object; how many. */
static int held(Reader *r, int is_object, int depth, size_t *count)
{
    char close = is_object ? '}' : ']';
    r->at++;
    skip_space(r);
    *count = 0;
    if (take(r, close)) return 1;
    do {
        if (is_object && !key(r)) return 0;
        if (!value(r, depth + 1)) return 0;
        ++*count;
    } while (take(r, ','));
    return take(r, close);
}

/* One value and the space around it. */
static int value(Reader *r, int depth)
{
    if (depth > JSON_DEPTH) {
        r->error = "nested too deeply";
        return 0;
    }
    skip_space(r);
    char c = here(r);
    JsonKind kind = c == '{' ? JSON_OBJECT : c == '[' ? JSON_ARRAY : c == '"' ? JSON_STRING
                    : c == '-' || (c >= '0' && c <= '9') ? JSON_NUMBER : JSON_OTHER;
    size_t index = begin(r, kind), count = 0;
    double x = NAN;
    if (index == JSON_NONE) return 0;
    int whole = kind == JSON_NUMBER   ? number(r, &x)
                : kind == JSON_STRING ? string(r)
                : kind == JSON_OTHER  ? word(r, "null") || word(r, "true") || word(r, "false")
                                      : held(r, kind == JSON_OBJECT, depth, &count);
    if (!whole) return 0;
    JsonValue *v = r->json->values + index;
    v->end = r->at;
    v->count = count;
    v->number = x;
    v->next = r->json->used;
    skip_space(r);
    return 1;
}

const char *json_read(Json *json, const char *text, size_t length)
{
    Reader r = {.json = json, .length = length};
    json->text = text;
    json->used = 0;
    if (value(&r, 0) && r.at == length) return NULL;
    return r.error ? r.error : no_json;
}

static const JsonValue *of_kind(const Json *json, size_t value, JsonKind kind)
{
    if (value == JSON_NONE || json->values[value].kind != kind) return NULL;
    return json->values + value;
}

int json_is(const Json *json, size_t value, const char *string)
{
    const JsonValue *v = of_kind(json, value, JSON_STRING);
    size_t length = strlen(string);
    return v && v->end - v->start == length + 2 && !memcmp(json->text + v->start + 1, string, length);
}

size_t json_member(const Json *json, size_t object, const char *key)
{
    const JsonValue *v = of_kind(json, object, JSON_OBJECT);
    if (!v) return JSON_NONE;
    size_t at = object + 1;
    for (size_t i = 0; i < v->count; i++) {
        if (json_is(json, at, key)) return at + 1;
        at = json->values[at + 1].next;
    }
    return JSON_NONE;
}

size_t json_items(const Json *json, size_t array, size_t count)
{
    const JsonValue *v = of_kind(json, array, JSON_ARRAY);
    return v && count && v->count == count ? array + 1 : JSON_NONE;
}

int json_double(const Json *json, size_t value, double *number)
{
    const JsonValue *v = of_kind(json, value, JSON_NUMBER);
    if (v) *number = v->number;
    else if (json_is(json, value, "inf")) *number = INFINITY;
    else if (json_is(json, value, "-inf")) *number = -INFINITY;
    else if (json_is(json, value, "NaN")) *number = NAN;
    else return 0;
    return 1;
}
