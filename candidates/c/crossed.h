/* Two crossed fibres and a projectile: a step and a run. */
#ifndef CROSSED_H
#define CROSSED_H

#include <stdint.h>

#include "march.h"

typedef struct { double x, y, z; } Vector;

/* The secondary fibre, from the crossover to its clamp. */
typedef struct {
    Constants constants;
    Vector *position, *velocity, *pull; /* of nodes 0..elements; tension of elements, as a vector, N */
    double *strain, *unstrained;        /* of elements; 1, m */
} Secondary;

typedef struct {
    Fibre primary;
    Secondary secondary;
    int is_crossed, is_engineering, has_mass;
    double at, slide_factor;      /* m, 1 */
    double impact_velocity, mass; /* of the projectile, m/s, kg */
    uint64_t steps_to_run;

    uint64_t step;
    double velocity; /* of the projectile in the next step, m/s */
    size_t node;     /* ix */
    uint64_t moves;
} System;

typedef enum { COMPLETED, DIVERGED, CROSSOVER_LEFT } Outcome;

/* The system as it is at impact. */
void at_impact(System *s);

/* One time step. After DIVERGED the system is amid the step. */
Outcome step_system(System *s);

/* From impact to the end of the scene. What has DIVERGED stands as before that step. */
Outcome run(System *s);

/* The tension of each element as a vector, from its magnitude and the element as it lies. */
Vector along(double dx, double dy, double dz, double tension);

#endif
