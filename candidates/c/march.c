/* The march of the struck fibre, eqns (1)-(7) of the paper, in plain C written for speed.
 *
 * Transverse impact of one clamped fibre in the x-y plane with the linear law. Structure of arrays, so
 * that the compiler can vectorise the loops. Every operation is the paper's, rounded once and in the
 * paper's order: the result equals that of the reference to the bit. README.md has the command line and
 * the compiler's flags.
 */
#define _POSIX_C_SOURCE 199309L /* clock_gettime */
#include "march.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "conform.h"

/* Elements that are carried through all loops before the next ones: they stay in the first-level
 * cache between the loops (256 elements * 8 arrays * 8 bytes = 16 KiB). */
enum { BLOCK = 256 };

typedef struct {
    double length, density, area, modulus, velocity, courant; /* m, kg/m3, m2, Pa, m/s, 1 */
    size_t elements, steps;
    int all;         /* visit every element, also those ahead of the wavefront */
    int keep_length; /* take (6) of the step before for (5) */
} Scene;

/* (2) for nodes 1..count of a block: pointers are to node 1 of the block, tensions to element 0. */
static void velocities(size_t count, double a, double *restrict vx, double *restrict vy,
                       const double *restrict tx, const double *restrict ty)
{
    for (size_t e = 0; e < count; e++) {
        vx[e] = eqn_2(vx[e], tx[e + 1], tx[e], a);
        vy[e] = eqn_2(vy[e], ty[e + 1], ty[e], a);
    }
}

/* Positions of `count` nodes. */
static void move(size_t count, double dt, double *restrict x, double *restrict y,
                 const double *restrict vx, const double *restrict vy)
{
    for (size_t i = 0; i < count; i++) {
        x[i] = moved(x[i], vx[i], dt);
        y[i] = moved(y[i], vy[i], dt);
    }
}

/* Elements of a block, the literal form: (5) from the stored positions of t-1, (6) from them and
 * the velocities of t. The positions are moved afterwards. */
static void elements_literal(size_t count, double dt, double stiffness, const double *restrict x,
                             const double *restrict y, const double *restrict vx,
                             const double *restrict vy, double *restrict strain,
                             double *restrict tx, double *restrict ty)
{
    for (size_t e = 0; e < count; e++) {
        double previous = length_2(x[e + 1] - x[e], y[e + 1] - y[e]);                   /* (5) */
        double dx = moved(x[e + 1], vx[e + 1], dt) - moved(x[e], vx[e], dt);
        double dy = moved(y[e + 1], vy[e + 1], dt) - moved(y[e], vy[e], dt);
        double now = length_2(dx, dy);                                                  /* (6) */
        strain[e] = eqn_4(strain[e], now, previous);
        double tension = eqn_7(stiffness, strain[e]);
        tx[e] = dx * (tension / now); /* as a vector along the element */
        ty[e] = dy * (tension / now);
    }
}

/* The same with engineering strain in the place of (4), nodes moved beforehand: (5) is not asked for. */
static void elements_engineering(size_t count, double stiffness, const double *restrict x,
                                 const double *restrict y, const double *restrict unstrained,
                                 double *restrict strain, double *restrict tx, double *restrict ty)
{
    for (size_t e = 0; e < count; e++) {
        double dx = x[e + 1] - x[e];
        double dy = y[e + 1] - y[e];
        double now = length_2(dx, dy);                                                  /* (6) */
        strain[e] = engineering_strain(now, unstrained[e]);
        double tension = eqn_7(stiffness, strain[e]);
        tx[e] = dx * (tension / now);
        ty[e] = dy * (tension / now);
    }
}

/* The literal form with --keep-length, nodes moved beforehand: the length that (5) asks for is, bit for bit,
 * the one that (6) gave a step ago. */
static void elements_keeping(size_t count, double stiffness, const double *restrict x,
                             const double *restrict y, double *restrict length,
                             double *restrict strain, double *restrict tx, double *restrict ty)
{
    for (size_t e = 0; e < count; e++) {
        double dx = x[e + 1] - x[e];
        double dy = y[e + 1] - y[e];
        double previous = length[e];                                                    /* (5) */
        double now = length_2(dx, dy);                                                  /* (6) */
        strain[e] = eqn_4(strain[e], now, previous);
        double tension = eqn_7(stiffness, strain[e]);
        tx[e] = dx * (tension / now);
        ty[e] = dy * (tension / now);
        length[e] = now;
    }
}

/* Block after block outward: a block's (2) needs only tensions of its own elements and of the next one,
 * none of which has been advanced yet. */
void step(Fibre *f, size_t window, double velocity, Way way, const Crossover *crossover)
{
    Constants c = f->constants;
    double dt = c.time_step;
    f->vx[0] = 0.0 * velocity; /* it travels along (0, 1); backward this is -0 */
    f->vy[0] = velocity;
    if (way != LITERAL) move(1, dt, f->x, f->y, f->vx, f->vy);
    for (size_t first = 0; first < window; first += BLOCK) {
        size_t count = window - first < BLOCK ? window - first : BLOCK;
        size_t free = count - (first + count == c.elements); /* the clamped node never moves */
        double *x = f->x + first, *y = f->y + first, *vx = f->vx + first, *vy = f->vy + first;
        double *tx = f->tension_x + first, *ty = f->tension_y + first, *strain = f->strain + first;
        velocities(free, c.a, vx + 1, vy + 1, tx, ty);
        if (crossover && first < crossover->node && crossover->node <= first + free) {
            size_t ix = crossover->node;
            f->vx[ix] = eqn_17(f->vx[ix], crossover->push);
            f->vy[ix] = eqn_18(f->vy[ix], crossover->push);
        }
        if (way == LITERAL) {
            elements_literal(count, dt, c.stiffness, x, y, vx, vy, strain, tx, ty);
            move(count, dt, x, y, vx, vy);
        } else {
            move(free, dt, x + 1, y + 1, vx + 1, vy + 1);
            if (way == KEEPING) {
                elements_keeping(count, c.stiffness, x, y, f->length + first, strain, tx, ty);
            } else {
                elements_engineering(count, c.stiffness, x, y, f->length + first, strain, tx, ty);
            }
        }
    }
    if (way == LITERAL) move(1, dt, f->x + window, f->y + window, f->vx + window, f->vy + window);
}

/* The whole run; returns the number of elements visited. */
static uint64_t march(Fibre *f, const Scene *scene)
{
    uint64_t visited = 0;
    size_t elements = f->constants.elements, window = scene->all ? elements : 1;
    for (size_t t = 0; t < scene->steps; t++) {
        step(f, window, scene->velocity, scene->keep_length ? KEEPING : LITERAL, NULL);
        visited += window;
        double last = eqn_7(f->constants.stiffness, f->strain[window - 1]);
        if (window < elements && last != 0.0) {
            window++; /* the wave has entered the last element visited */
        }
    }
    return visited;
}

Constants constants(double length, size_t elements, double density, double area, double modulus)
{
    double spacing = length / (double)elements;
    return (Constants){.elements = elements, .spacing = spacing, .mass = density * area * spacing,
                       .stiffness = modulus * area,
                       .crossing_time = spacing / sqrt(modulus / density)};
}

Constants with_time_step(Constants c, double time_step)
{
    c.time_step = time_step;
    c.a = time_step / c.mass;
    return c;
}

size_t stride(size_t elements) { return (elements + 1 + 7) / 8 * 8; }

Fibre fibre(Constants c, double *memory)
{
    size_t s = stride(c.elements);
    return (Fibre){.constants = c,
                   .x = memory, .y = memory + s, .vx = memory + 2 * s, .vy = memory + 3 * s,
                   .tension_x = memory + 4 * s, .tension_y = memory + 5 * s,
                   .strain = memory + 6 * s, .length = memory + 7 * s};
}

void at_rest(Fibre *f)
{
    size_t elements = f->constants.elements;
    for (size_t i = 0; i <= elements; i++) {
        f->x[i] = (double)i * f->constants.spacing;
        f->y[i] = f->vx[i] = f->vy[i] = 0.0;
        f->tension_x[i] = f->tension_y[i] = f->strain[i] = 0.0;
    }
    for (size_t e = 0; e < elements; e++) { /* (5) at step one, and L_0 */
        f->length[e] = length_2(f->x[e + 1] - f->x[e], f->y[e + 1] - f->y[e]);
    }
}

/* FNV-1a, 64 bits, over the little-endian bytes of a double. */
static uint64_t fnv(uint64_t hash, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    for (int byte = 0; byte < 8; byte++) {
        hash = (hash ^ (bits >> 8 * byte & 0xff)) * 0x100000001b3u;
    }
    return hash;
}

static uint64_t checksum(const Fibre *f)
{
    uint64_t hash = 0xcbf29ce484222325u;
    size_t elements = f->constants.elements;
    for (size_t i = 0; i <= elements; i++) hash = fnv(fnv(hash, f->x[i]), f->y[i]);
    for (size_t i = 0; i <= elements; i++) hash = fnv(fnv(hash, f->vx[i]), f->vy[i]);
    for (size_t e = 0; e < elements; e++) hash = fnv(hash, f->strain[e]);
    return hash;
}

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(int argc, char **argv)
{
    if (argc == 2 && !strcmp(argv[1], "--conform")) return conform(stdin, stdout);
    Scene s = {0};
    double elements = 0, steps = 0, repeat = 1;
    struct { const char *name; double *value; } flags[] = {
        {"--length", &s.length}, {"--elements", &elements}, {"--density", &s.density},
        {"--area", &s.area}, {"--modulus", &s.modulus}, {"--velocity", &s.velocity},
        {"--courant", &s.courant}, {"--steps", &steps}, {"--repeat", &repeat}};
    size_t known = sizeof flags / sizeof *flags;
    for (int i = 1; i < argc; i++) {
        size_t k = 0;
        char *end = "";
        while (k < known && strcmp(argv[i], flags[k].name)) k++;
        if (k < known && i + 1 < argc) *flags[k].value = strtod(argv[++i], &end);
        else if (!strcmp(argv[i], "--all")) s.all = 1;
        else if (!strcmp(argv[i], "--keep-length")) s.keep_length = 1;
        else end = "?";
        if (*end) return fprintf(stderr, "march: do not understand %s\n", argv[i]), 1;
    }
    if (!(s.length > 0 && elements >= 2 && s.density > 0 && s.area > 0 && s.modulus > 0
          && s.courant > 0 && steps >= 1 && repeat >= 1)) {
        fputs("usage: march --length M --elements N --density KG/M3 --area M2 --modulus PA"
              " --velocity M/S --courant A --steps N [--all] [--keep-length] [--repeat K]\n"
              "       march --conform\n", stderr);
        return 1;
    }
    s.elements = (size_t)elements;
    s.steps = (size_t)steps;
    double *memory = aligned_alloc(64, 8 * stride(s.elements) * sizeof *memory);
    if (!memory) return fputs("march: out of memory\n", stderr), 1;
    Constants c = constants(s.length, s.elements, s.density, s.area, s.modulus);
    Fibre f = fibre(with_time_step(c, s.courant * c.crossing_time), memory);           /* (20) */
    uint64_t visited = 0;
    double best = INFINITY;
    for (double k = 0; k < repeat; k++) {
        at_rest(&f);
        double start = seconds();
        visited = march(&f, &s);
        best = fmin(best, seconds() - start);
    }
    printf("{\"steps\":%zu,\"element_steps\":%llu,\"seconds\":%.9g,\"checksum\":\"%016llx\","
           "\"plateau_strain\":%.17g}\n", s.steps, (unsigned long long)visited, best,
           (unsigned long long)checksum(&f), f.strain[s.elements / 4]);
    free(memory);
    return 0;
}
