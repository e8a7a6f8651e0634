"""The twenty equations, as printed and as used.

Names are those of the protocol, so a question about an equation is a call. Each equation works on one
node or element as well as on arrays of them. The order of operations is the reference's: the same bits.
"""
import numpy as np


def magnitude(d):
    """|d| of a vector or of each row. (np.linalg.norm adds the squares in an order of its own.)"""
    return np.sqrt(sum(component * component for component in d.T))


class Printed:
    """The equations as the page prints them."""

    def __init__(self, strain):
        self.engineering = strain == "engineering"

    def eqn_1(self, T_ahead, T_here, v, v_before, m_over_dt):
        return T_ahead - T_here - (v - v_before) * m_over_dt

    def eqn_2(self, v_before, T_ahead, T_here, A):
        return v_before + (T_ahead - T_here) * A

    def eqn_3(self, L, L_before):
        return (L - L_before) / L

    def eqn_4(self, L, L_before=None, strain_before=None, L_0=None):
        return L / L_0 - 1.0 if self.engineering else strain_before + L / L_before - 1.0

    def eqn_5(self, x_ahead, x_here):
        return magnitude(x_ahead - x_here)

    def eqn_6(self, x_ahead, v_ahead, x_here, v_here, dt):
        return magnitude((x_ahead + v_ahead * dt) - (x_here + v_here * dt))

    def eqn_7(self, E, strain):
        return E * strain  # E is modulus × area: a tension is a force

    def eqn_8(self, v_p_before, T_y, m_p, m_node, dt, t):
        return v_p_before - 2.0 * T_y * t / m_p

    def eqn_9(self, u, v, cos, sin):
        return u * cos + v * sin

    def eqn_10(self, u, v, cos, sin):
        return v * cos - u * sin

    def eqn_11(self, x_here, y_here, x_behind, y_behind):
        theta = np.arctan((y_here - y_behind) / (x_here - x_behind))
        return np.cos(theta), np.sin(theta)

    def eqn_12(self, alpha_s, v_para, v_perp, cos, sin):
        return alpha_s * v_para * cos - v_perp * sin

    def eqn_13(self, alpha_s, v_para, v_perp, cos, sin):
        return alpha_s * v_para * sin + v_perp * cos

    def eqn_14(self):
        return 0.0

    def eqn_15(self, T2, cos_phi1_x, cos_phi1_y, cos_phi2_x, cos_phi2_y):
        return T2 * (cos_phi2_x * cos_phi1_x + cos_phi2_y * cos_phi1_y)

    def eqn_16(self, T2, cos_phi1_x, cos_phi1_y, cos_phi2_x, cos_phi2_y):
        return T2 * (cos_phi2_x * cos_phi1_x - cos_phi2_y * cos_phi1_y)

    def eqn_17(self, u_by_2, A, alpha_s, T2_perp, T2_para, cos_phi1_x, cos_phi1_y, du, dv, m1, m2):
        return u_by_2 + 2.0 * A * (T2_perp * cos_phi1_y + alpha_s * T2_para * cos_phi1_x)

    def eqn_18(self, v_by_2, A, alpha_s, T2_perp, T2_para, cos_phi1_x, cos_phi1_y, du, dv, m1, m2):
        return v_by_2 + 2.0 * A * (T2_perp * cos_phi1_x + alpha_s * T2_para * cos_phi1_y)

    def eqn_19(self, c, curvature):
        return c * c * curvature

    def eqn_20(self, c, dt, dx):
        return c * (dt / dx)


class Corrected(Printed):
    """The equations that are used: all corrections of the ledger are made."""

    def eqn_3(self, L, L_before):
        return (L - L_before) / L_before  # as (4) divides

    def eqn_8(self, v_p_before, T_y, m_p, m_node, dt, t):
        # The fibre brakes (T_y < 0), for one time step, the projectile and the node that moves with it.
        return v_p_before - 2.0 * -T_y * dt / (m_p + m_node)

    def eqn_11(self, x_here, y_here, x_behind, y_behind):
        dx, dy = x_here - x_behind, y_here - y_behind
        length = np.sqrt(dx * dx + dy * dy)
        return dx / length, dy / length

    def eqn_16(self, T2, cos_phi1_x, cos_phi1_y, cos_phi2_x, cos_phi2_y):
        return T2 * (cos_phi2_y * cos_phi1_x - cos_phi2_x * cos_phi1_y)

    def eqn_17(self, u_by_2, A, alpha_s, T2_perp, T2_para, cos_phi1_x, cos_phi1_y, du, dv, m1, m2):
        (along, across), (share_along, share_across) = self.secondary(alpha_s, cos_phi1_x, cos_phi1_y, du, dv, m1, m2)
        taken_back = share_along * along * cos_phi1_x - share_across * across * cos_phi1_y
        return u_by_2 + 2.0 * A * (T2_perp * (1.0 - share_across) * -cos_phi1_y
                                   + alpha_s * T2_para * (1.0 - share_along) * cos_phi1_x) - taken_back

    def eqn_18(self, v_by_2, A, alpha_s, T2_perp, T2_para, cos_phi1_x, cos_phi1_y, du, dv, m1, m2):
        (along, across), (share_along, share_across) = self.secondary(alpha_s, cos_phi1_x, cos_phi1_y, du, dv, m1, m2)
        taken_back = share_along * along * cos_phi1_y + share_across * across * cos_phi1_x
        return v_by_2 + 2.0 * A * (T2_perp * (1.0 - share_across) * cos_phi1_x
                                   + alpha_s * T2_para * (1.0 - share_along) * cos_phi1_y) - taken_back

    def secondary(self, alpha_s, cos, sin, du, dv, m1, m2):
        """What (2) added along the primary and across it, and the secondary's share of the moving mass."""
        m2_along = alpha_s * alpha_s * m2
        return (du * cos + dv * sin, dv * cos - du * sin), (m2_along / (m1 + m2_along), m2 / (m1 + m2))


def edition(strain="incremental", corrections="all"):
    """The equations with all corrections or with none; there is no edition with some."""
    classes = {"all": Corrected, "none": Printed}
    return classes[corrections](strain) if corrections in ("all", "none") else None
