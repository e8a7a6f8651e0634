/* The single-fibre march, eqns (1)-(7) of the paper, in plain C written for speed.
 *
 * Transverse impact of one clamped fibre in the x-y plane: linear law, incremental strain (4),
 * projectile of constant velocity. Structure of arrays, so that the compiler can vectorise the
 * loops. Every operation is the paper's, rounded once and in the paper's order: the result equals
 * that of the reference to the bit. README.md has the command line and the compiler's flags.
 */
#define _POSIX_C_SOURCE 199309L /* clock_gettime */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Elements that are carried through all loops before the next ones: they stay in the first-level
 * cache between the loops (256 elements * 8 arrays * 8 bytes = 16 KiB). */
enum { BLOCK = 256 };

typedef struct {
    double length, density, area, modulus, velocity, courant; /* m, kg/m3, m2, Pa, m/s, 1 */
    size_t elements, steps;
    int all;         /* visit every element, also those ahead of the wavefront */
    int keep_length; /* take (6) of the step before for (5) */
} Scene;

typedef struct {
    size_t elements;
    double spacing, time_step, a, stiffness;    /* dx, dt, A = dt/dm, modulus*area */
    double *x, *y, *vx, *vy;                    /* at nodes, 0..elements */
    double *tension_x, *tension_y, *strain;     /* of the element from node e to e+1 */
    double *length;                             /* of the element a step ago, if it is kept */
} Fibre;

/* (2) for nodes 1..count of a block: pointers are to node 1 of the block, tensions to element 0. */
static void velocities(size_t count, double a, double *restrict vx, double *restrict vy,
                       const double *restrict tx, const double *restrict ty)
{
    for (size_t e = 0; e < count; e++) {
        vx[e] = vx[e] + (tx[e + 1] - tx[e]) * a;                                        /* (2) */
        vy[e] = vy[e] + (ty[e + 1] - ty[e]) * a;
    }
}

/* Positions of `count` nodes. */
static void move(size_t count, double dt, double *restrict x, double *restrict y,
                 const double *restrict vx, const double *restrict vy)
{
    for (size_t i = 0; i < count; i++) {
        x[i] = x[i] + vx[i] * dt;
        y[i] = y[i] + vy[i] * dt;
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
        double old_dx = x[e + 1] - x[e];
        double old_dy = y[e + 1] - y[e];
        double previous = sqrt(old_dx * old_dx + old_dy * old_dy);                      /* (5) */
        double dx = (x[e + 1] + vx[e + 1] * dt) - (x[e] + vx[e] * dt);
        double dy = (y[e + 1] + vy[e + 1] * dt) - (y[e] + vy[e] * dt);
        double now = sqrt(dx * dx + dy * dy);                                           /* (6) */
        strain[e] = (strain[e] + now / previous) - 1.0;                                 /* (4) */
        double tension = stiffness * strain[e];                                         /* (7) */
        tx[e] = dx * (tension / now); /* as a vector along the element */
        ty[e] = dy * (tension / now);
    }
}

/* The same with --keep-length, nodes moved beforehand: the length that (5) asks for is, bit for bit,
 * the one that (6) gave a step ago. */
static void elements_keeping(size_t count, double stiffness, const double *restrict x,
                             const double *restrict y, double *restrict length,
                             double *restrict strain, double *restrict tx, double *restrict ty)
{
    for (size_t e = 0; e < count; e++) {
        double dx = x[e + 1] - x[e];
        double dy = y[e + 1] - y[e];
        double previous = length[e];                                                    /* (5) */
        double now = sqrt(dx * dx + dy * dy);                                           /* (6) */
        strain[e] = (strain[e] + now / previous) - 1.0;                                 /* (4) */
        double tension = stiffness * strain[e];                                         /* (7) */
        tx[e] = dx * (tension / now);
        ty[e] = dy * (tension / now);
        length[e] = now;
    }
}

/* One time step over the first `window` elements. Block after block outward: a block's (2) needs
 * only tensions of its own elements and of the next one, none of which has been advanced yet. */
static void step(Fibre *f, size_t window, const Scene *scene)
{
    double dt = f->time_step;
    f->vx[0] = 0.0;
    f->vy[0] = scene->velocity;
    if (scene->keep_length) move(1, dt, f->x, f->y, f->vx, f->vy);
    for (size_t first = 0; first < window; first += BLOCK) {
        size_t count = window - first < BLOCK ? window - first : BLOCK;
        size_t free = count - (first + count == f->elements); /* the clamped node never moves */
        double *x = f->x + first, *y = f->y + first, *vx = f->vx + first, *vy = f->vy + first;
        double *tx = f->tension_x + first, *ty = f->tension_y + first, *strain = f->strain + first;
        velocities(free, f->a, vx + 1, vy + 1, tx, ty);
        if (scene->keep_length) {
            move(free, dt, x + 1, y + 1, vx + 1, vy + 1);
            elements_keeping(count, f->stiffness, x, y, f->length + first, strain, tx, ty);
        } else {
            elements_literal(count, dt, f->stiffness, x, y, vx, vy, strain, tx, ty);
            move(count, dt, x, y, vx, vy);
        }
    }
    if (!scene->keep_length) {
        move(1, dt, f->x + window, f->y + window, f->vx + window, f->vy + window);
    }
}

/* The whole run; returns the number of elements visited. */
static uint64_t march(Fibre *f, const Scene *scene)
{
    uint64_t visited = 0;
    size_t window = scene->all ? f->elements : 1;
    for (size_t t = 0; t < scene->steps; t++) {
        step(f, window, scene);
        visited += window;
        double last = f->stiffness * f->strain[window - 1];
        if (window < f->elements && last != 0.0) {
            window++; /* the wave has entered the last element visited */
        }
    }
    return visited;
}

/* `memory` holds the eight arrays, each `stride` doubles long. */
static Fibre fibre(const Scene *s, double *memory, size_t stride)
{
    double wave_speed = sqrt(s->modulus / s->density);
    double spacing = s->length / (double)s->elements;
    double time_step = s->courant * (spacing / wave_speed);                            /* (20) */
    double mass = s->density * s->area * spacing;
    return (Fibre){.elements = s->elements, .spacing = spacing, .time_step = time_step,
                   .a = time_step / mass, .stiffness = s->modulus * s->area,
                   .x = memory, .y = memory + stride,
                   .vx = memory + 2 * stride, .vy = memory + 3 * stride,
                   .tension_x = memory + 4 * stride, .tension_y = memory + 5 * stride,
                   .strain = memory + 6 * stride, .length = memory + 7 * stride};
}

static void at_rest(Fibre *f)
{
    for (size_t i = 0; i <= f->elements; i++) {
        f->x[i] = (double)i * f->spacing;
        f->y[i] = f->vx[i] = f->vy[i] = 0.0;
        f->tension_x[i] = f->tension_y[i] = f->strain[i] = 0.0;
    }
    for (size_t e = 0; e < f->elements; e++) {
        double dx = f->x[e + 1] - f->x[e];
        double dy = f->y[e + 1] - f->y[e];
        f->length[e] = sqrt(dx * dx + dy * dy);                             /* (5) at step one */
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
    for (size_t i = 0; i <= f->elements; i++) hash = fnv(fnv(hash, f->x[i]), f->y[i]);
    for (size_t i = 0; i <= f->elements; i++) hash = fnv(fnv(hash, f->vx[i]), f->vy[i]);
    for (size_t e = 0; e < f->elements; e++) hash = fnv(hash, f->strain[e]);
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
              " --velocity M/S --courant A --steps N [--all] [--keep-length] [--repeat K]\n", stderr);
        return 1;
    }
    s.elements = (size_t)elements;
    s.steps = (size_t)steps;
    size_t stride = (s.elements + 1 + 7) / 8 * 8; /* whole cache lines */
    double *memory = aligned_alloc(64, 8 * stride * sizeof *memory);
    if (!memory) return fputs("march: out of memory\n", stderr), 1;
    Fibre f = fibre(&s, memory, stride);
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
