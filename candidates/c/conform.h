/* The conversation of docs/conformance.md. */
#ifndef CONFORM_H
#define CONFORM_H

#include <stdio.h>

/* Answers each line of `in` on `out` until there is none. Returns the program's exit code. */
int conform(FILE *in, FILE *out);

#endif
