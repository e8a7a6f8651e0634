#include "conform.h"

#include <stdlib.h>
#include <string.h>

#include "crossed.h"
#include "json.h"

static const size_t most_text = (size_t)1 << 28; /* of a line, bytes */
static const double most_elements = 1e6, most_steps = 1e9;

/* Why there is no answer: a question that cannot be read, or one for another program. */
typedef struct {
    const char *error, *skip;
} Trouble;

static const Trouble none = {0};

static Trouble error(const char *text) { return (Trouble){.error = text}; }

/* ---- Numbers out ---- */

static void put(FILE *out, double x)
{
    if (x == 0.0) fputs(signbit(x) ? "-0.0" : "0.0", out); /* "-0" would be a whole number */
    else if (isfinite(x)) fprintf(out, "%.17g", x);
    else fputs(isnan(x) ? "\"NaN\"" : x > 0 ? "\"inf\"" : "\"-inf\"", out);
}

static void put_list(FILE *out, const double *x, size_t count)
{
    putc('[', out);
    for (size_t i = 0; i < count; i++) {
        if (i) putc(',', out);
        put(out, x[i]);
    }
    putc(']', out);
}

/* Vectors of two or three components. */
static void put_plane(FILE *out, const char *name, const double *x, const double *y, size_t count)
{
    fprintf(out, "\"%s\":[", name);
    for (size_t i = 0; i < count; i++) {
        if (i) putc(',', out);
        put_list(out, (double[]){x[i], y[i]}, 2);
    }
    putc(']', out);
}

static void put_space(FILE *out, const char *name, const Vector *v, size_t count)
{
    fprintf(out, "\"%s\":[", name);
    for (size_t i = 0; i < count; i++) {
        if (i) putc(',', out);
        put_list(out, (double[]){v[i].x, v[i].y, v[i].z}, 3);
    }
    putc(']', out);
}

static void put_strain(FILE *out, const Constants *c, const double *strain)
{
    fputs(",\"strain\":", out);
    put_list(out, strain, c->elements);
    fputs(",\"tension\":[", out);
    for (size_t e = 0; e < c->elements; e++) {
        if (e) putc(',', out);
        put(out, eqn_7(c->stiffness, strain[e]));
    }
    putc(']', out);
}

static void put_fibres(FILE *out, const System *s)
{
    const Fibre *f = &s->primary;
    size_t nodes = f->constants.elements + 1;
    fputs("\"primary\":{", out);
    put_plane(out, "position", f->x, f->y, nodes);
    putc(',', out);
    put_plane(out, "velocity", f->vx, f->vy, nodes);
    put_strain(out, &f->constants, f->strain);
    putc('}', out);
    if (!s->is_crossed) return;
    const Secondary *f2 = &s->secondary;
    nodes = f2->constants.elements + 1;
    fputs(",\"secondary\":{", out);
    put_space(out, "position", f2->position, nodes);
    putc(',', out);
    put_space(out, "velocity", f2->velocity, nodes);
    put_strain(out, &f2->constants, f2->strain);
    fprintf(out, "},\"crossover\":{\"node\":%zu,\"moves\":%llu}", s->node,
            (unsigned long long)s->moves);
}

static void put_state(FILE *out, const System *s)
{
    fprintf(out, "\"state\":{\"step\":%llu,", (unsigned long long)s->step);
    put_fibres(out, s);
    fputs(",\"projectile_velocity\":", out);
    put(out, s->velocity);
    putc('}', out);
}

static void put_result(FILE *out, const System *s, Outcome outcome)
{
    const char *kind[] = {[COMPLETED] = "completed", [DIVERGED] = "diverged",
                          [CROSSOVER_LEFT] = "crossover_left"};
    double time_step = s->primary.constants.time_step;
    fprintf(out, "\"result\":{\"format\":\"crossfibre-result/1\",\"outcome\":{\"kind\":\"%s\"},",
            kind[outcome]);
    fprintf(out, "\"time\":%.17g,\"steps\":%llu,\"time_step\":%.17g,", (double)s->step * time_step,
            (unsigned long long)s->step, time_step);
    put_fibres(out, s);
    fputs(",\"projectile\":{\"velocity\":", out);
    put(out, s->velocity);
    fputs(",\"position\":", out);
    put(out, s->primary.y[0]);
    fputs("}}", out);
}

/* ---- A scene in ---- */

static int positive(const Json *j, size_t object, const char *name, double *x)
{
    return json_double(j, json_member(j, object, name), x) && *x > 0 && isfinite(*x);
}

static Trouble read_constants(const Json *j, size_t made, Constants *c)
{
    double length, elements, density, area, modulus;
    size_t material = json_member(j, made, "material");
    if (material == JSON_NONE) return error("a fibre has no material");
    if (!json_is(j, json_member(j, material, "law"), "linear") || j->values[material].count != 2) {
        return (Trouble){.skip = "only the linear law, without tension_only or artificial_viscosity"};
    }
    if (!positive(j, made, "length", &length) || !positive(j, made, "elements", &elements)
        || !positive(j, made, "density", &density) || !positive(j, made, "area", &area)
        || !positive(j, material, "modulus", &modulus)) {
        return error("a fibre lacks a positive number");
    }
    if (elements < 2 || elements > most_elements) return error("too few or too many elements");
    *c = constants(length, (size_t)elements, density, area, modulus);
    return none;
}

static void free_system(System *s)
{
    free(s->primary.x);
    free(s->secondary.position);
    free(s->secondary.strain);
}

/* What it has taken is given back by free_system, also after trouble. */
static Trouble take_memory(System *s, Constants primary, Constants secondary)
{
    double *memory = aligned_alloc(64, 8 * stride(primary.elements) * sizeof *memory);
    if (!memory) return error("out of memory");
    s->primary = fibre(primary, memory);
    if (!s->is_crossed) return none;
    size_t n = secondary.elements;
    Vector *vectors = malloc((3 * n + 2) * sizeof *vectors);
    double *numbers = malloc(2 * n * sizeof *numbers);
    s->secondary = (Secondary){.constants = secondary, .position = vectors, .strain = numbers};
    if (!vectors || !numbers) return error("out of memory");
    s->secondary.velocity = vectors + n + 1;
    s->secondary.pull = vectors + 2 * n + 2;
    s->secondary.unstrained = numbers + n;
    return none;
}

static Trouble read_scene(const Json *j, size_t scene, System *s)
{
    size_t primary = json_member(j, scene, "primary"), crossing = json_member(j, scene, "secondary");
    size_t projectile = json_member(j, scene, "projectile");
    size_t corrections = json_member(j, scene, "corrections"), mass, strain;
    Constants c1, c2 = {0};
    double courant, duration;
    if (corrections != JSON_NONE && !json_is(j, corrections, "all")) {
        return (Trouble){.skip = "all corrections only"};
    }
    strain = json_member(j, scene, "strain");
    s->is_engineering = json_is(j, strain, "engineering");
    if (strain != JSON_NONE && !s->is_engineering && !json_is(j, strain, "incremental")) {
        return error("strain is incremental or engineering");
    }
    mass = json_member(j, projectile, "mass");
    s->has_mass = mass != JSON_NONE;
    if (!json_double(j, json_member(j, projectile, "velocity"), &s->impact_velocity)
        || (s->has_mass && !json_double(j, mass, &s->mass))) {
        return error("the projectile lacks a number");
    }
    if (!positive(j, scene, "courant", &courant) || !positive(j, scene, "duration", &duration)) {
        return error("courant and duration are positive numbers");
    }
    Trouble trouble = read_constants(j, primary, &c1);
    if (trouble.error || trouble.skip) return trouble;
    double crossing_time = c1.crossing_time;
    if (crossing != JSON_NONE) {
        s->is_crossed = 1;
        trouble = read_constants(j, crossing, &c2);
        if (trouble.error || trouble.skip) return trouble;
        if (!json_double(j, json_member(j, crossing, "at"), &s->at)
            || !json_double(j, json_member(j, crossing, "slide_factor"), &s->slide_factor)) {
            return error("the secondary lacks a number");
        }
        if (c2.crossing_time < crossing_time) crossing_time = c2.crossing_time;
    }
    double time_step = courant * crossing_time, steps = round(duration / time_step);
    if (!(time_step > 0) || !(steps <= most_steps)) return error("too many steps");
    s->steps_to_run = (uint64_t)steps;
    trouble = take_memory(s, with_time_step(c1, time_step), with_time_step(c2, time_step));
    if (trouble.error) return trouble;
    at_impact(s);
    return s->is_crossed && s->node >= c1.elements ? error("the crossover is at the clamp") : none;
}

/* ---- A state in ---- */

/* Vectors: `x[k]` gets component k, `apart` doubles from one node to the next. */
static int read_vectors(const Json *j, size_t list, size_t count, size_t components, double *const *x,
                        size_t apart)
{
    size_t item = json_items(j, list, count);
    for (size_t i = 0; i < count; i++) {
        size_t component = item == JSON_NONE ? JSON_NONE : json_items(j, item, components);
        if (component == JSON_NONE) return 0;
        for (size_t k = 0; k < components; k++) {
            if (!json_double(j, component, x[k] + i * apart)) return 0;
            component = j->values[component].next;
        }
        item = j->values[item].next;
    }
    return 1;
}

static int read_numbers(const Json *j, size_t list, size_t count, double *x)
{
    size_t item = json_items(j, list, count);
    for (size_t i = 0; i < count; i++) {
        if (!json_double(j, item, x + i)) return 0;
        item = j->values[item].next;
    }
    return 1;
}

static int read_primary(const Json *j, size_t object, Fibre *f)
{
    size_t n = f->constants.elements;
    double *tension = f->tension_x; /* its magnitude, until it is made a vector */
    if (!read_vectors(j, json_member(j, object, "position"), n + 1, 2, (double *[]){f->x, f->y}, 1)
        || !read_vectors(j, json_member(j, object, "velocity"), n + 1, 2, (double *[]){f->vx, f->vy}, 1)
        || !read_numbers(j, json_member(j, object, "strain"), n, f->strain)
        || !read_numbers(j, json_member(j, object, "tension"), n, tension)) {
        return 0;
    }
    for (size_t e = 0; e < n; e++) {
        Vector pull = along(f->x[e + 1] - f->x[e], f->y[e + 1] - f->y[e], 0.0, tension[e]);
        f->tension_x[e] = pull.x;
        f->tension_y[e] = pull.y;
    }
    return 1;
}

static int read_secondary(const Json *j, size_t object, Secondary *f)
{
    size_t n = f->constants.elements, apart = sizeof(Vector) / sizeof(double);
    Vector *x = f->position, *v = f->velocity;
    size_t tension = json_items(j, json_member(j, object, "tension"), n);
    if (!read_vectors(j, json_member(j, object, "position"), n + 1, 3,
                      (double *[]){&x->x, &x->y, &x->z}, apart)
        || !read_vectors(j, json_member(j, object, "velocity"), n + 1, 3,
                         (double *[]){&v->x, &v->y, &v->z}, apart)
        || !read_numbers(j, json_member(j, object, "strain"), n, f->strain)) {
        return 0;
    }
    for (size_t e = 0; e < n; e++) {
        double magnitude;
        if (!json_double(j, tension, &magnitude)) return 0;
        f->pull[e] = along(x[e + 1].x - x[e].x, x[e + 1].y - x[e].y, x[e + 1].z - x[e].z, magnitude);
        tension = j->values[tension].next;
    }
    return 1;
}

static int read_count(const Json *j, size_t value, double most, double *count)
{
    return json_double(j, value, count) && *count >= 0 && *count <= most && *count == floor(*count);
}

static Trouble read_state(const Json *j, size_t state, System *s)
{
    double step, node = 0, moves = 0;
    size_t at = json_member(j, state, "crossover");
    if (!read_count(j, json_member(j, state, "step"), most_steps, &step)
        || !json_double(j, json_member(j, state, "projectile_velocity"), &s->velocity)
        || !read_primary(j, json_member(j, state, "primary"), &s->primary)) {
        return error("the state does not fit the scene");
    }
    s->step = (uint64_t)step;
    if (!s->is_crossed) return none;
    if (!read_secondary(j, json_member(j, state, "secondary"), &s->secondary)
        || !read_count(j, json_member(j, at, "node"), (double)s->primary.constants.elements - 1, &node)
        || !read_count(j, json_member(j, at, "moves"), most_steps, &moves)) {
        return error("the state of the crossing fibre does not fit the scene");
    }
    s->node = (size_t)node;
    s->moves = (uint64_t)moves;
    return none;
}

/* ---- An equation ---- */

/* What goes into an equation; `missing` is set by the first name that is not there. */
typedef struct {
    const Json *json;
    size_t in;
    int missing;
} Inputs;

static double get(Inputs *inputs, const char *name)
{
    double x = NAN;
    if (!json_double(inputs->json, json_member(inputs->json, inputs->in, name), &x)) {
        inputs->missing = 1;
    }
    return x;
}

/* A vector in v[0..3); its number of components. */
static size_t get_vector(Inputs *inputs, const char *name, double v[3])
{
    size_t list = json_member(inputs->json, inputs->in, name), count = 2;
    if (json_items(inputs->json, list, 3) != JSON_NONE) count = 3;
    v[2] = 0.0;
    if (!read_numbers(inputs->json, list, count, v)) inputs->missing = 1;
    return count;
}

static Cosines get_cosines(Inputs *inputs, const char *x, const char *y)
{
    return (Cosines){get(inputs, x), get(inputs, y)};
}

static Push get_push(Inputs *i)
{
    return (Push){.A = get(i, "A"), .alpha_s = get(i, "alpha_s"), .T2_perp = get(i, "T2_perp"),
                  .T2_para = get(i, "T2_para"), .phi1 = get_cosines(i, "cos_phi1_x", "cos_phi1_y"),
                  .du = get(i, "du"), .dv = get(i, "dv"), .m1 = get(i, "m1"), .m2 = get(i, "m2")};
}

/* Equations of vectors; how many components there are. */
static size_t vector_equation(long eq, Inputs *i, double out[3])
{
    double a[3], b[3], c[3], d[3];
    size_t count;
    if (eq == 1 || eq == 2) {
        double factor = get(i, eq == 1 ? "m_over_dt" : "A");
        count = get_vector(i, "v_before", a);
        get_vector(i, "T_ahead", b);
        get_vector(i, "T_here", c);
        if (eq == 1) get_vector(i, "v", d);
        for (size_t k = 0; k < 3 && !i->missing; k++) {
            out[k] = eq == 1 ? eqn_1(b[k], c[k], d[k], a[k], factor) : eqn_2(a[k], b[k], c[k], factor);
        }
        return count;
    }
    count = get_vector(i, "x_ahead", a);
    get_vector(i, "x_here", b);
    if (eq == 6) {
        double dt = get(i, "dt");
        get_vector(i, "v_ahead", c);
        get_vector(i, "v_here", d);
        for (size_t k = 0; k < 3 && !i->missing; k++) {
            a[k] = moved(a[k], c[k], dt);
            b[k] = moved(b[k], d[k], dt);
        }
    }
    if (i->missing) return 1;
    if (count == 3) *out = length_3(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    else *out = length_2(a[0] - b[0], a[1] - b[1]);
    return 1;
}

/* Any equation; how many numbers come out, none for an equation that is not known. */
static size_t equation(long eq, Inputs *i, int is_engineering, double out[3])
{
    Direction theta;
    switch (eq) {
    case 1: case 2: case 5: case 6: return vector_equation(eq, i, out);
    case 3: *out = eqn_3(get(i, "L"), get(i, "L_before")); return 1;
    case 4:
        *out = is_engineering ? engineering_strain(get(i, "L"), get(i, "L_0"))
                              : eqn_4(get(i, "strain_before"), get(i, "L"), get(i, "L_before"));
        return 1;
    case 7: *out = eqn_7(get(i, "E"), get(i, "strain")); return 1;
    case 8:
        *out = eqn_8(get(i, "v_p_before"), get(i, "T_y"), get(i, "m_p"), get(i, "m_node"), get(i, "dt"));
        return 1;
    case 9: *out = eqn_9(get(i, "u"), get(i, "v"), get(i, "cos"), get(i, "sin")); return 1;
    case 10: *out = eqn_10(get(i, "u"), get(i, "v"), get(i, "cos"), get(i, "sin")); return 1;
    case 11:
        theta = eqn_11(get(i, "x_here"), get(i, "y_here"), get(i, "x_behind"), get(i, "y_behind"));
        out[0] = theta.cos;
        out[1] = theta.sin;
        return 2;
    case 12: case 13:
        *out = (eq == 12 ? eqn_12 : eqn_13)(get(i, "alpha_s"), get(i, "v_para"), get(i, "v_perp"),
                                            get(i, "cos"), get(i, "sin"));
        return 1;
    case 14: *out = eqn_14(); return 1;
    case 15: case 16:
        *out = (eq == 15 ? eqn_15 : eqn_16)(get(i, "T2"), get_cosines(i, "cos_phi1_x", "cos_phi1_y"),
                                            get_cosines(i, "cos_phi2_x", "cos_phi2_y"));
        return 1;
    case 17: *out = eqn_17(get(i, "u_by_2"), get_push(i)); return 1;
    case 18: *out = eqn_18(get(i, "v_by_2"), get_push(i)); return 1;
    case 19: *out = eqn_19(get(i, "c"), get(i, "curvature")); return 1;
    case 20: *out = eqn_20(get(i, "c"), get(i, "dt"), get(i, "dx")); return 1;
    default: return 0;
    }
}

/* ---- Questions and answers ---- */

static const char *const hello =
    "\"format\":\"crossfibre-conformance/1\",\"name\":\"plain C\",\"number\":\"f64\","
    "\"depths\":[\"equation\",\"step\",\"run\"],\"laws\":[\"linear\"],\"dimensions\":[2,3],"
    "\"strain\":[\"incremental\",\"engineering\"],\"corrections\":[\"all\"]";

static Trouble answer_equation(const Json *j, FILE *out)
{
    size_t edition = json_member(j, 0, "edition"), name = json_member(j, 0, "eq");
    size_t corrections = json_member(j, edition, "corrections");
    Inputs inputs = {.json = j, .in = json_member(j, 0, "in")};
    double x[3] = {0};
    if (corrections != JSON_NONE && !json_is(j, corrections, "all")) {
        return (Trouble){.skip = "all corrections only"};
    }
    if (name == JSON_NONE || j->values[name].kind != JSON_STRING) return error("which equation?");
    char *end;
    long eq = strtol(j->text + j->values[name].start + 1, &end, 10);
    if (*end != '"') eq = 0;
    size_t count = equation(eq, &inputs, json_is(j, json_member(j, edition, "strain"), "engineering"), x);
    if (!count) return (Trouble){.skip = "not an equation of the page"};
    if (inputs.missing) return error("an input of the equation is missing");
    int is_vector = count > 1;
    fputs("\"out\":", out);
    if (is_vector) put_list(out, x, count);
    else put(out, *x);
    return none;
}

static Trouble answer_step_or_run(const Json *j, FILE *out, int is_run)
{
    System s = {0};
    Trouble trouble = read_scene(j, json_member(j, 0, "scene"), &s);
    if (!trouble.error && !trouble.skip) {
        if (is_run) put_result(out, &s, run(&s));
        else {
            trouble = read_state(j, json_member(j, 0, "state"), &s);
            if (!trouble.error) {
                step_system(&s);
                put_state(out, &s);
            }
        }
    }
    free_system(&s);
    return trouble;
}

/* Writes all of the answer but its `id`, and nothing where there is trouble. */
static Trouble answer(const Json *j, FILE *out)
{
    size_t ask = json_member(j, 0, "ask");
    if (json_is(j, ask, "hello")) return fputs(hello, out), none;
    if (json_is(j, ask, "equation")) return answer_equation(j, out);
    if (json_is(j, ask, "step")) return answer_step_or_run(j, out, 0);
    if (json_is(j, ask, "run")) return answer_step_or_run(j, out, 1);
    return (Trouble){.skip = "not a question that this program knows"};
}

/* A line without its end, NUL behind it. Its length; 0 at the end of the input. `most_text` at most. */
static int read_line(FILE *in, char **text, size_t *room, size_t *length)
{
    int c;
    *length = 0;
    while ((c = getc(in)) != EOF) {
        if (*length + 1 >= *room) {
            size_t more = *room ? 2 * *room : 4096;
            char *longer = more <= most_text ? realloc(*text, more) : NULL;
            if (!longer) return -1;
            *text = longer;
            *room = more;
        }
        if (c == '\n') break;
        (*text)[(*length)++] = (char)c;
    }
    if (c == EOF && !*length) return 0;
    (*text)[*length] = '\0';
    return 1;
}

int conform(FILE *in, FILE *out)
{
    Json json = {0};
    char *text = NULL;
    size_t room = 0, length;
    int got;
    while ((got = read_line(in, &text, &room, &length)) > 0) {
        const char *fault = json_read(&json, text, length);
        size_t id = fault ? JSON_NONE : json_member(&json, 0, "id");
        Trouble trouble = fault ? error(fault) : none;
        if (id == JSON_NONE) fputs("{\"id\":null,", out);
        else {
            const JsonValue *v = json.values + id;
            fputs("{\"id\":", out);
            fwrite(text + v->start, 1, v->end - v->start, out);
            putc(',', out);
        }
        if (!fault) trouble = answer(&json, out);
        if (trouble.error) fprintf(out, "\"error\":\"%s\"", trouble.error);
        if (trouble.skip) fprintf(out, "\"skip\":\"%s\"", trouble.skip);
        fputs("}\n", out);
        if (fflush(out)) break;
    }
    free(text);
    free(json.values);
    if (got < 0) fputs("march: a line is too long\n", stderr);
    return got ? 1 : 0;
}
