//! The register of the numbered equations: what each is called, how the page prints it, what its
//! symbols mean, and the same as lines that a person or a program can work out.

use serde::Serialize;

/// A quantity that enters or leaves an equation, as traces name it.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Symbol {
    /// The name in traces and worked lines.
    pub name: &'static str,
    /// What it is.
    pub meaning: &'static str,
    /// Its SI unit; `1` for a pure number.
    pub unit: &'static str,
}

/// One numbered equation of the page.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Equation {
    /// Its number on the page.
    pub number: u8,
    /// What it is.
    pub name: &'static str,
    /// How it is printed.
    pub printed: &'static str,
    /// The printed form as lines to work out.
    pub lines: &'static [Line],
}

/// One line of an equation worked by hand: `name = expression`, with symbols in braces.
///
/// Symbols may be vectors; an expression then holds for each component. `|{d}|` is the length of
/// the vector `d`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Line {
    /// What the line gives; that of the last line is the output.
    pub name: &'static str,
    /// How.
    pub expression: &'static str,
}

/// A line.
pub const fn line(name: &'static str, expression: &'static str) -> Line {
    Line { name, expression }
}

macro_rules! equations {
    ($($number:literal $name:literal $printed:literal { $($out:literal = $expression:literal;)+ })*) => {
        /// All twenty, in order.
        pub const EQUATIONS: &[Equation] = &[$(
            Equation {
                number: $number,
                name: $name,
                printed: $printed,
                lines: &[$(line($out, $expression)),+],
            }
        ),*];
    };
}

equations! {
    1 "impulse-momentum balance"
    "T_{i+1}^{t-1} - T_i^{t-1} = (Δm/Δt) (v_{i+1}^t - v_{i+1}^{t-1})" {
        "residual" = "{T_ahead} - {T_here} - ({v} - {v_before}) * {m_over_dt}";
    }
    2 "velocity of the next node"
    "v_{i+1}^t = v_{i+1}^{t-1} + A (T_{i+1}^{t-1} - T_i^{t-1})" {
        "v" = "{v_before} + ({T_ahead} - {T_here}) * {A}";
    }
    3 "increment of strain"
    "Δε_i = (L_i^t - L_i^{t-1}) / L_i^t" {
        "d_strain" = "({L} - {L_before}) / {L}";
    }
    4 "strain"
    "ε_i^t = ε_i^{t-1} + (L_i^t / L_i^{t-1}) - 1" {
        "strain" = "{strain_before} + ({L} / {L_before}) - 1";
    }
    5 "length one step ago"
    "L_i^{t-1} = |x_{i+1}^{t-1} - x_i^{t-1}|" {
        "d" = "{x_ahead} - {x_here}";
        "L_before" = "|{d}|";
    }
    6 "length now"
    "L_i^t = |x_{i+1}^t - x_i^t| = |(x_{i+1}^{t-1} + v_{i+1}^t Δt) - (x_i^{t-1} + v_i^t Δt)|" {
        "d" = "({x_ahead} + {v_ahead} * {dt}) - ({x_here} + {v_here} * {dt})";
        "L" = "|{d}|";
    }
    7 "tension"
    "T_i^t = E ε_i^t" {
        "T" = "{E} * {strain}";
    }
    8 "projectile velocity"
    "-2 T_y = m_p Δv_p/Δt = m_p (v_p^t - v_p^{t-1}) / t" {
        "v_p" = "{v_p_before} - 2 * {T_y} * {t} / {m_p}";
    }
    9 "velocity along the primary fibre"
    "v_para^t = u_ix^t cos θ_ix^t + v_ix^t sin θ_ix^t" {
        "v_para" = "{u} * {cos} + {v} * {sin}";
    }
    10 "velocity across the primary fibre"
    "v_perp^t = v_ix^t cos θ_ix^t - u_ix^t sin θ_ix^t" {
        "v_perp" = "{v} * {cos} - {u} * {sin}";
    }
    11 "angle of the primary fibre"
    "θ_ix^t = tan⁻¹[(y1_ix^t - y1_{ix-1}^t) / (x1_ix^t - x1_{ix-1}^t)]" {
        "theta" = "atan(({y_here} - {y_behind}) / ({x_here} - {x_behind}))";
        "cos" = "cos({theta})";
        "sin" = "sin({theta})";
    }
    12 "x-velocity imposed on the secondary"
    "u2_1^t = α_s v_para^t cos θ_ix^t - v_perp^t sin θ_ix^t" {
        "u2" = "{alpha_s} * {v_para} * {cos} - {v_perp} * {sin}";
    }
    13 "y-velocity imposed on the secondary"
    "v2_1^t = α_s v_para^t sin θ_ix^t + v_perp^t cos θ_ix^t" {
        "v2" = "{alpha_s} * {v_para} * {sin} + {v_perp} * {cos}";
    }
    14 "z-velocity imposed on the secondary"
    "w2_1^t = 0" {
        "w2" = "0";
    }
    15 "secondary's tension along the primary"
    "T2_para^t = T2_1^t [cos φ2_x cos φ1_x + cos φ2_y cos φ1_y]" {
        "T2_para" = "{T2} * ({cos_phi2_x} * {cos_phi1_x} + {cos_phi2_y} * {cos_phi1_y})";
    }
    16 "secondary's tension across the primary"
    "T2_perp^t = T2_1^t [cos φ2_x cos φ1_x - cos φ2_y cos φ1_y]" {
        "T2_perp" = "{T2} * ({cos_phi2_x} * {cos_phi1_x} - {cos_phi2_y} * {cos_phi1_y})";
    }
    17 "x-velocity of the crossover node"
    "u_{i+1}^t <- u_{i+1}^t + 2A [T2'_perp cos φ1_y + α_s T2'_para cos φ1_x]" {
        "u" = "{u_by_2} + 2 * {A} * ({T2_perp} * {cos_phi1_y} + {alpha_s} * {T2_para} * {cos_phi1_x})";
    }
    18 "y-velocity of the crossover node"
    "v_{i+1}^t <- v_{i+1}^t + 2A [T2'_perp cos φ1_x + α_s T2'_para cos φ1_y]" {
        "v" = "{v_by_2} + 2 * {A} * ({T2_perp} * {cos_phi1_x} + {alpha_s} * {T2_para} * {cos_phi1_y})";
    }
    19 "wave equation"
    "∂²u/∂t² = c² (∂²u/∂x²)" {
        "acceleration" = "{c} * {c} * {curvature}";
    }
    20 "Courant number"
    "α = c (Δt/Δx)" {
        "alpha" = "{c} * ({dt} / {dx})";
    }
}

/// The equation of this number, from 1 to 20.
pub fn equation(number: u8) -> Option<&'static Equation> {
    EQUATIONS.get(usize::from(number).checked_sub(1)?)
}

/// (7) of a fibre with another law than the page's; σ is the law's.
pub const TENSION_BY_LAW: Line = line("T", "{area} * {stress}");

macro_rules! symbols {
    ($($name:literal $unit:literal $meaning:literal;)*) => {
        /// Every symbol that traces use.
        pub const SYMBOLS: &[Symbol] =
            &[$(Symbol { name: $name, meaning: $meaning, unit: $unit }),*];
    };
}

symbols! {
    "A" "s/kg" "Δt/Δm of the fibre";
    "E" "N" "modulus × area";
    "L" "m" "length of the element now";
    "L_0" "m" "unstrained length of the element";
    "L_before" "m" "length of the element one step ago";
    "T" "N" "tension of the element now";
    "T2" "N" "tension of the secondary's first element, one step ago";
    "T2_para" "N" "that tension along the primary fibre";
    "T2_perp" "N" "that tension across the primary fibre";
    "T_ahead" "N" "tension of the element beyond the node, one step ago, as a vector";
    "T_here" "N" "tension of the element before the node, one step ago, as a vector";
    "T_y" "N" "first tension along the projectile's travel; negative while the fibre trails";
    "acceleration" "m/s²" "∂²u/∂t²";
    "across" "m/s" "velocity change by (2), across the primary fibre";
    "along" "m/s" "velocity change by (2), along the primary fibre";
    "alpha" "1" "Courant number";
    "alpha_s" "1" "slide factor";
    "area" "m²" "cross-section of the fibre";
    "c" "m/s" "speed of a small longitudinal wave";
    "cos" "1" "cos θ of the primary fibre at the crossover";
    "cos_phi1_x" "1" "direction cosine of the primary fibre at the crossover";
    "cos_phi1_y" "1" "direction cosine of the primary fibre at the crossover";
    "cos_phi2_x" "1" "direction cosine of the secondary's first element";
    "cos_phi2_y" "1" "direction cosine of the secondary's first element";
    "curvature" "1/m" "∂²u/∂x²";
    "d" "m" "the element as a vector";
    "d_strain" "1" "increment of strain";
    "dt" "s" "time step Δt";
    "du" "m/s" "x-velocity that (2) has just added to the crossover node";
    "dv" "m/s" "y-velocity that (2) has just added to the crossover node";
    "dx" "m" "unstrained length of an element; in (11) x_here - x_behind";
    "dy" "m" "y_here - y_behind";
    "interval" "s" "the time over which the projectile's velocity changes";
    "m1" "kg" "lumped mass of a node of the primary";
    "m2" "kg" "lumped mass of the secondary's first node, both arms";
    "m2_along" "kg" "the part of m2 that moves along the primary with it, α_s² m2";
    "m_node" "kg" "mass lumped on the projectile's node, both halves";
    "m_over_dt" "kg/s" "Δm/Δt";
    "m_p" "kg" "mass of the projectile";
    "mass" "kg" "the mass that the fibres slow down";
    "memory" "" "what the element remembers for its law after the step: energies in J/m³, stresses in Pa, a strain";
    "normal_x" "1" "x-part of the normal to the primary fibre";
    "pull" "N" "first tension against the projectile's travel";
    "residual" "N" "left side less right side";
    "share_across" "1" "the secondary's share of the mass moving across the primary";
    "share_along" "1" "the secondary's share of the mass moving along the primary";
    "sin" "1" "sin θ of the primary fibre at the crossover";
    "strain" "1" "strain of the element now";
    "strain_before" "1" "strain of the element one step ago";
    "stress" "Pa" "nominal stress by the law of the fibre";
    "t" "s" "time since impact";
    "taken_back" "m/s" "what (2) gave the node that belongs to the secondary's share";
    "theta" "rad" "angle of the primary fibre to the x-axis at the crossover";
    "u" "m/s" "x-velocity of the crossover node";
    "u2" "m/s" "x-velocity of the secondary's first node";
    "u_by_2" "m/s" "x-velocity of the crossover node as (2) left it";
    "v" "m/s" "velocity of the node now; in (9), (10), (18) the y-velocity of the crossover node";
    "v2" "m/s" "y-velocity of the secondary's first node";
    "v_ahead" "m/s" "velocity of the element's far node now";
    "v_before" "m/s" "velocity of the node one step ago";
    "v_by_2" "m/s" "y-velocity of the crossover node as (2) left it";
    "v_here" "m/s" "velocity of the element's near node now";
    "v_p" "m/s" "projectile velocity now";
    "v_p_before" "m/s" "projectile velocity one step ago";
    "v_para" "m/s" "velocity of the crossover node along the primary fibre";
    "v_perp" "m/s" "velocity of the crossover node across the primary fibre";
    "w2" "m/s" "z-velocity of the secondary's first node";
    "x_ahead" "m" "position of the element's far node one step ago";
    "x_behind" "m" "x of the node before the crossover node";
    "x_here" "m" "position of the element's near node one step ago; in (11) x of the crossover node";
    "y_behind" "m" "y of the node before the crossover node";
    "y_here" "m" "y of the crossover node";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_are_numbered_as_on_the_page() {
        for (i, e) in EQUATIONS.iter().enumerate() {
            assert_eq!(usize::from(e.number), i + 1);
            assert_eq!(equation(e.number).map(|found| found.number), Some(e.number));
        }
        assert_eq!(EQUATIONS.len(), 20);
        assert!(equation(0).is_none() && equation(21).is_none());
    }

    #[test]
    fn symbols_are_sorted_and_cover_every_printed_line() {
        assert!(SYMBOLS.windows(2).all(|pair| pair[0].name < pair[1].name));
        let known = |name: &str| SYMBOLS.iter().any(|s| s.name == name);
        for equation in EQUATIONS {
            for line in equation.lines {
                assert!(known(line.name), "({}) {}", equation.number, line.name);
                for part in line.expression.split('{').skip(1) {
                    let name = part.split('}').next().unwrap();
                    assert!(known(name), "({}) {name}", equation.number);
                }
            }
        }
    }
}
