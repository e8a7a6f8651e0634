#include "crossed.h"

static Vector minus(Vector a, Vector b) { return (Vector){a.x - b.x, a.y - b.y, a.z - b.z}; }

static double magnitude(Vector v) { return length_3(v.x, v.y, v.z); }

static Vector moved_to(Vector x, Vector v, double dt)
{
    return (Vector){moved(x.x, v.x, dt), moved(x.y, v.y, dt), moved(x.z, v.z, dt)};
}

Vector along(double dx, double dy, double dz, double tension)
{
    double per_length = tension / length_3(dx, dy, dz);
    return (Vector){dx * per_length, dy * per_length, dz * per_length};
}

/* The secondary fibre as the page has it: from one element to the next, in place. An element has its
 * tension of t-1 until (2) of the node behind it has used it. */
static void march_secondary(Secondary *f, Vector driven, int is_engineering)
{
    Constants c = f->constants;
    double dt = c.time_step;
    f->velocity[0] = driven;
    for (size_t e = 0; e < c.elements; e++) {
        Vector *x = f->position + e, *v = f->velocity + e, *pull = f->pull + e;
        if (e + 1 < c.elements) {
            v[1] = (Vector){eqn_2(v[1].x, pull[1].x, pull[0].x, c.a),
                            eqn_2(v[1].y, pull[1].y, pull[0].y, c.a),
                            eqn_2(v[1].z, pull[1].z, pull[0].z, c.a)};
        }
        double before = magnitude(minus(x[1], x[0]));                                   /* (5) */
        Vector element = minus(moved_to(x[1], v[1], dt), moved_to(x[0], v[0], dt));
        double now = magnitude(element);                                                /* (6) */
        f->strain[e] = is_engineering ? engineering_strain(now, f->unstrained[e])
                                      : eqn_4(f->strain[e], now, before);
        pull[0] = along(element.x, element.y, element.z, eqn_7(c.stiffness, f->strain[e]));
        x[0] = moved_to(x[0], v[0], dt);
    }
    f->position[c.elements] = moved_to(f->position[c.elements], f->velocity[c.elements], dt);
}

/* (15), (16) and what (17) and (18) need: tensions and directions are of t-1. */
static Crossover crossover(const System *s)
{
    const Fibre *f = &s->primary;
    const Secondary *f2 = &s->secondary;
    size_t ix = s->node;
    double dx = f->x[ix] - f->x[ix - 1], dy = f->y[ix] - f->y[ix - 1], length = length_2(dx, dy);
    Vector first = minus(f2->position[1], f2->position[0]);
    double length2 = magnitude(first), a = f->constants.a;
    double T2 = eqn_7(f2->constants.stiffness, f2->strain[0]);
    Cosines phi1 = {dx / length, dy / length}, phi2 = {first.x / length2, first.y / length2};
    Push push = {.A = a, .alpha_s = s->slide_factor, .phi1 = phi1,
                 .T2_para = eqn_15(T2, phi1, phi2), .T2_perp = eqn_16(T2, phi1, phi2),
                 .du = (f->tension_x[ix] - f->tension_x[ix - 1]) * a,
                 .dv = (f->tension_y[ix] - f->tension_y[ix - 1]) * a,
                 .m1 = f->constants.mass, .m2 = f2->constants.mass};
    return (Crossover){ix, push};
}

/* (9)-(14): the velocity that the primary's node imposes on the secondary's first. */
static Vector drive(const System *s)
{
    const Fibre *f = &s->primary;
    size_t ix = s->node;
    Direction theta = eqn_11(f->x[ix], f->y[ix], f->x[ix - 1], f->y[ix - 1]);
    double v_para = eqn_9(f->vx[ix], f->vy[ix], theta.cos, theta.sin);
    double v_perp = eqn_10(f->vx[ix], f->vy[ix], theta.cos, theta.sin);
    return (Vector){eqn_12(s->slide_factor, v_para, v_perp, theta.cos, theta.sin),
                    eqn_13(s->slide_factor, v_para, v_perp, theta.cos, theta.sin), eqn_14()};
}

/* Node of the primary nearest to the secondary's first, the lower of two equals. There is nothing to look
 * for where nothing slides, nor before the wave has come to the crossover. */
static size_t nearest_node(const System *s)
{
    const Fibre *f = &s->primary;
    Vector first = s->secondary.position[0];
    if (s->slide_factor == 1.0) return s->node;
    for (size_t e = 0; e + 1 < s->node; e++) {
        if (f->strain[e] == 0.0) return s->node;
    }
    size_t nearest = 0;
    double least = INFINITY;
    for (size_t i = 0; i <= f->constants.elements; i++) {
        double dx = f->x[i] - first.x, dy = f->y[i] - first.y;
        double square = dx * dx + dy * dy + first.z * first.z;
        if (square < least) {
            nearest = i;
            least = square;
        }
    }
    return nearest;
}

/* (8), with the tension of all fibres that are struck. */
static void push_projectile(System *s)
{
    double T_y = s->primary.tension_y[0], m_node = s->primary.constants.mass;
    if (s->is_crossed && s->node == 0) {
        T_y = T_y + s->secondary.pull[0].y;
        m_node = m_node + s->secondary.constants.mass;
    }
    if (s->has_mass) {
        s->velocity = eqn_8(s->velocity, T_y, s->mass, m_node, s->primary.constants.time_step);
    }
}

static int is_finite(const System *s)
{
    int finite = isfinite(s->velocity);
    for (size_t e = 0; e < s->primary.constants.elements; e++) {
        finite &= isfinite(s->primary.tension_x[e]) && isfinite(s->primary.tension_y[e]);
    }
    for (size_t e = 0; s->is_crossed && e < s->secondary.constants.elements; e++) {
        Vector pull = s->secondary.pull[e];
        finite &= isfinite(pull.x) && isfinite(pull.y) && isfinite(pull.z);
    }
    return finite;
}

Outcome step_system(System *s)
{
    size_t elements = s->primary.constants.elements;
    Way way = s->is_engineering ? ENGINEERING : LITERAL;
    double struck = s->velocity;
    s->step++;
    if (s->is_crossed && s->node > 0) {
        Crossover at = crossover(s);
        step(&s->primary, elements, struck, way, &at);
        push_projectile(s);
        march_secondary(&s->secondary, drive(s), s->is_engineering);
    } else { /* what the projectile strikes it drives, one fibre or both */
        step(&s->primary, elements, struck, way, NULL);
        Vector driven = {0.0 * struck, struck, eqn_14()};
        if (s->is_crossed) march_secondary(&s->secondary, driven, s->is_engineering);
        push_projectile(s);
    }
    if (!is_finite(s)) return DIVERGED;
    if (s->is_crossed && s->node > 0) {
        size_t nearest = nearest_node(s);
        if (nearest == 0 || nearest == elements) return CROSSOVER_LEFT;
        s->moves += nearest != s->node;
        s->node = nearest;
    }
    return COMPLETED;
}

/* The node nearest to the crossover at rest, the lower of two equals. */
static size_t node_at(const Fibre *f, double at)
{
    size_t nearest = 0;
    for (size_t i = 1; i <= f->constants.elements; i++) {
        if (fabs(f->x[i] - at) < fabs(f->x[nearest] - at)) nearest = i;
    }
    return nearest;
}

void at_impact(System *s)
{
    s->step = 0;
    s->velocity = s->impact_velocity;
    s->moves = 0;
    at_rest(&s->primary);
    if (!s->is_crossed) return;
    Secondary *f = &s->secondary;
    size_t elements = f->constants.elements;
    s->node = node_at(&s->primary, s->at);
    for (size_t i = 0; i <= elements; i++) {
        f->position[i] = (Vector){s->at, 0.0, (double)i * f->constants.spacing};
        f->velocity[i] = (Vector){0.0, 0.0, 0.0};
    }
    for (size_t e = 0; e < elements; e++) {
        f->unstrained[e] = magnitude(minus(f->position[e + 1], f->position[e]));
        f->strain[e] = 0.0;
        f->pull[e] = (Vector){0.0, 0.0, 0.0};
    }
}

static Outcome run_steps(System *s, uint64_t steps)
{
    Outcome outcome = COMPLETED;
    at_impact(s);
    while (outcome == COMPLETED && s->step < steps) outcome = step_system(s);
    return outcome;
}

Outcome run(System *s)
{
    Outcome outcome = run_steps(s, s->steps_to_run);
    if (outcome == DIVERGED) {
        run_steps(s, s->step - 1); /* once more costs less than a copy in every step */
    }
    return outcome;
}
