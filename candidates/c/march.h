/* The primary fibre: structure of arrays in the x-y plane, marched by march.c. */
#ifndef MARCH_H
#define MARCH_H

#include <stddef.h>

#include "equations.h"

/* What no step changes of a fibre. */
typedef struct {
    size_t elements;
    double spacing, mass, stiffness; /* dx, m; lumped mass dm, kg; modulus*area, N */
    double crossing_time;            /* dx/c, s */
    double time_step, a;             /* dt, s; A = dt/dm, s/kg */
} Constants;

typedef struct {
    Constants constants;
    double *x, *y, *vx, *vy;                /* at nodes, 0..elements */
    double *tension_x, *tension_y, *strain; /* of the element from node e to e+1 */
    double *length;                         /* of the element: see Way */
} Fibre;

/* How the elements are worked out. */
typedef enum {
    LITERAL,    /* (5), (6), (4), (7) */
    KEEPING,    /* the same; (5) is `length`, kept from (6) of the step before */
    ENGINEERING /* (6) and strain L/L_0 - 1 with `length` for L_0 */
} Way;

/* (17) and (18) at one node. */
typedef struct {
    size_t node;
    Push push;
} Crossover;

/* All but the time step. */
Constants constants(double length, size_t elements, double density, double area, double modulus);

Constants with_time_step(Constants constants, double time_step);

/* Doubles in each array: whole cache lines. */
size_t stride(size_t elements);

/* `memory`, aligned to a cache line, holds the eight arrays. */
Fibre fibre(Constants constants, double *memory);

void at_rest(Fibre *f);

/* One time step over the first `window` elements; `velocity` is the projectile's, `crossover`
 * NULL where there is none. */
void step(Fibre *f, size_t window, double velocity, Way way, const Crossover *crossover);

#endif
