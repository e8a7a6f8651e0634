/* The equations as they are used: the page's, with the corrections of the ledger.
 *
 * Arguments have the names of docs/conformance.md. Vectors come a component at a time; what a component
 * cannot tell, (5) and (6), is the length of an element by its components. Every operation is in the
 * order of the reference and rounds once.
 */
#ifndef EQUATIONS_H
#define EQUATIONS_H

#include <math.h>

static inline double length_2(double dx, double dy) { return sqrt(dx * dx + dy * dy); }

static inline double length_3(double dx, double dy, double dz)
{
    return sqrt(dx * dx + dy * dy + dz * dz);
}

/* x^t of a node. */
static inline double moved(double x, double v, double dt) { return x + v * dt; }

static inline double eqn_1(double T_ahead, double T_here, double v, double v_before, double m_over_dt)
{
    return T_ahead - T_here - (v - v_before) * m_over_dt;
}

static inline double eqn_2(double v_before, double T_ahead, double T_here, double A)
{
    return v_before + (T_ahead - T_here) * A;
}

static inline double eqn_3(double L, double L_before) { return (L - L_before) / L_before; }

static inline double eqn_4(double strain_before, double L, double L_before)
{
    return strain_before + L / L_before - 1.0;
}

static inline double engineering_strain(double L, double L_0) { return L / L_0 - 1.0; }

static inline double eqn_7(double E, double strain) { return E * strain; }

static inline double eqn_8(double v_p_before, double T_y, double m_p, double m_node, double dt)
{
    return v_p_before - 2.0 * -T_y * dt / (m_p + m_node);
}

static inline double eqn_9(double u, double v, double cos, double sin) { return u * cos + v * sin; }

static inline double eqn_10(double u, double v, double cos, double sin) { return v * cos - u * sin; }

typedef struct { double cos, sin; } Direction;

static inline Direction eqn_11(double x_here, double y_here, double x_behind, double y_behind)
{
    double dx = x_here - x_behind, dy = y_here - y_behind, length = length_2(dx, dy);
    return (Direction){dx / length, dy / length};
}

static inline double eqn_12(double alpha_s, double v_para, double v_perp, double cos, double sin)
{
    return alpha_s * v_para * cos - v_perp * sin;
}

static inline double eqn_13(double alpha_s, double v_para, double v_perp, double cos, double sin)
{
    return alpha_s * v_para * sin + v_perp * cos;
}

static inline double eqn_14(void) { return 0.0; }

typedef struct { double x, y; } Cosines;

static inline double eqn_15(double T2, Cosines phi1, Cosines phi2)
{
    return T2 * (phi2.x * phi1.x + phi2.y * phi1.y);
}

static inline double eqn_16(double T2, Cosines phi1, Cosines phi2)
{
    return T2 * (phi2.y * phi1.x - phi2.x * phi1.y);
}

/* What (17) and (18) are evaluated with, beside the velocity by (2). */
typedef struct {
    double A, alpha_s, T2_perp, T2_para; /* s/kg, 1, N, N */
    Cosines phi1;
    double du, dv, m1, m2; /* what (2) has added, m/s; lumped masses of primary and secondary, kg */
} Push;

/* Along the primary and across it: the velocity by (2), and the secondary's share of the moving mass. */
typedef struct { double along, across, share_along, share_across; } Inertia;

static inline Inertia inertia(Push p)
{
    double m2_along = p.alpha_s * p.alpha_s * p.m2;
    return (Inertia){.along = p.du * p.phi1.x + p.dv * p.phi1.y,
                     .across = p.dv * p.phi1.x - p.du * p.phi1.y,
                     .share_along = m2_along / (p.m1 + m2_along),
                     .share_across = p.m2 / (p.m1 + p.m2)};
}

static inline double eqn_17(double u_by_2, Push p)
{
    Inertia i = inertia(p);
    double taken_back = i.share_along * i.along * p.phi1.x - i.share_across * i.across * p.phi1.y;
    return u_by_2 + 2.0 * p.A * (p.T2_perp * (1.0 - i.share_across) * -p.phi1.y
                                 + p.alpha_s * p.T2_para * (1.0 - i.share_along) * p.phi1.x)
           - taken_back;
}

static inline double eqn_18(double v_by_2, Push p)
{
    Inertia i = inertia(p);
    double taken_back = i.share_along * i.along * p.phi1.y + i.share_across * i.across * p.phi1.x;
    return v_by_2 + 2.0 * p.A * (p.T2_perp * (1.0 - i.share_across) * p.phi1.x
                                 + p.alpha_s * p.T2_para * (1.0 - i.share_along) * p.phi1.y)
           - taken_back;
}

static inline double eqn_19(double c, double curvature) { return c * c * curvature; }

static inline double eqn_20(double c, double dt, double dx) { return c * (dt / dx); }

#endif
