//! Where the inputs of the equations come from: where to look when an input is the first thing that
//! differs.

/// What gives a node its velocity.
const VELOCITIES: &[u8] = &[2, 8, 12, 13, 14, 17, 18];

/// Where an input comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Origin {
    /// What it is, and what becomes of it between the equations.
    pub what: &'static str,
    /// The equations whose output it is or is made of; none for what is set up from the scene.
    pub equations: &'static [u8],
}

/// The origin of an input, by its symbol.
pub fn origin(symbol: &str) -> Option<Origin> {
    let from = |what, equations| Some(Origin { what, equations });
    match symbol {
        "A" | "E" | "L_0" | "alpha_s" | "area" | "dt" | "m1" | "m2" | "m_node" | "m_p" => {
            from("set up from the scene before the first step", &[])
        }
        "t" => from("the time since impact, which no numbered equation gives", &[]),
        "x_ahead" | "x_behind" | "x_here" | "y_behind" | "y_here" => {
            from("a position, moved by x + v Δt, which is no numbered equation", VELOCITIES)
        }
        "cos_phi1_x" | "cos_phi1_y" | "cos_phi2_x" | "cos_phi2_y" => {
            from("a direction, of positions one step before, by no numbered equation", VELOCITIES)
        }
        "v_ahead" | "v_here" => from("a velocity of this step", VELOCITIES),
        "v_before" => from("the node's velocity one step before", &[2, 17, 18]),
        "u_by_2" | "v_by_2" => from("the node's velocity as (2) left it", &[2]),
        "u" | "v" => from("the velocity of the crossover's node", &[2, 17, 18]),
        "T_ahead" | "T_here" => {
            from("a tension one step before, along its element by no numbered equation", &[7])
        }
        "T2" => from("a tension one step before", &[7]),
        "T_y" => from("a part of the first tension, by no numbered equation", &[7]),
        "du" | "dv" => from("what (2) has just added, of tensions one step before", &[7]),
        "T2_para" => from("a part of the secondary's tension", &[15]),
        "T2_perp" => from("a part of the secondary's tension", &[16]),
        "L" => from("the length of the element now", &[6]),
        "L_before" => from("the length of the element one step before", &[5]),
        "strain" => from("the strain of this step", &[4]),
        "strain_before" => from("the strain one step before", &[4]),
        "stress" | "memory" => from("by the law of the fibre, which is no numbered equation", &[4]),
        "cos" | "sin" => from("the direction of the primary at the crossover", &[11]),
        "v_para" => from("the crossover's velocity along the primary", &[9]),
        "v_perp" => from("the crossover's velocity across the primary", &[10]),
        "v_p_before" => from("the projectile's velocity one step before", &[8]),
        _ => None,
    }
}
