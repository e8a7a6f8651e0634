//! Artificial viscosity at the front of a linear fibre; at a shock see `elastic`.

use crossfibre::material::Coefficients;
use crossfibre::number::Number;
use crossfibre::scene::{Scene, Strain};

use crate::cases::axial::{edition, held, linear_scene};
use crate::cases::support::{
    Marched, check, exact_single, marched, measured_by, order, refined, relative, shipped,
};
use crate::cases::{Bound, Check};
use crate::closed_form::component;
use crate::planted::march;

/// What a run shows of its front.
pub struct Front {
    /// Greatest strain over the plateau's, less 1.
    pub overshoot: f64,
    /// Mean over the middle half of the plateau: relative error.
    plateau: f64,
    /// From a tenth to nine tenths of the plateau's strain, m.
    width: f64,
    /// What the viscosity has taken, over the work put in.
    taken: f64,
}

/// The front of the shipped scene, with its viscosity or without.
pub fn of_scene(strain: Strain, factor: usize, viscous: bool) -> Front {
    let mut scene = measured_by(strain, refined(shipped("artificial-viscosity"), factor));
    if !viscous {
        scene.primary.material.artificial_viscosity = None;
    }
    let exact = component(&scene, exact_single(&scene).strain);
    let Marched { state, outcome, balance } = marched(scene);
    assert!(outcome.is_completed(), "{outcome}");
    let fibre = &state.primary;
    let height = |part: f64| {
        let last = fibre.strain.iter().rposition(|&e| e > part * exact).unwrap_or(0);
        let (behind, ahead) = (fibre.strain[last], fibre.strain[last + 1]);
        last as f64 + (behind - part * exact) / (behind - ahead)
    };
    let dx = fibre.properties.spacing;
    Front {
        overshoot: fibre.strain.iter().fold(0.0_f64, |a, &b| a.max(b)) / exact - 1.0,
        plateau: relative(crate::cases::support::mean(dx, &fibre.strain, 0.075, 0.1125), exact),
        width: (height(0.1) - height(0.9)) * dx,
        taken: balance.energy.dissipated / balance.energy.work,
    }
}

/// The oscillations at the front, and what their damping costs.
pub fn front() -> Vec<Check> {
    let bare = of_scene(Strain::Incremental, 1, false);
    let viscous = of_scene(Strain::Incremental, 1, true);
    let [coarse, fine] = [4, 16].map(|factor| of_scene(Strain::Engineering, factor, true));
    let spread = "a linear law does not steepen its front, which the viscosity spreads like heat: \
                  as the root of its coefficient, and that is Δx: order 1/2";
    vec![
        check(
            "Without viscosity the front overshoots",
            "Smith's plateau",
            "greatest strain over the plateau's, less 1, 2 mm, α = 0.7",
            bare.overshoot,
            Bound::AtLeast(0.1),
            "oscillations at a front that is steeper than the mesh resolves",
        ),
        check(
            "With linear = 0.3 and quadratic = 1 it hardly does",
            "Smith's plateau",
            "greatest strain over the plateau's, less 1, 2 mm, α = 0.7",
            viscous.overshoot,
            Bound::AtMost(2e-2),
            "waves of a few elements are damped within a few elements; what is left is the kink's",
        ),
        check(
            "The plateau stays Smith's",
            "Smith's relation, engineering law",
            "relative, mean over the middle half, 0.5 mm",
            coarse.plateau,
            Bound::AtMost(1e-5),
            "uniform strain feels no viscosity",
        ),
        check(
            "The front is narrower on a finer mesh, but not in elements",
            "spreading of a front by viscosity",
            "observed order of the width from 10 to 90 %, 0.5 mm to 0.125 mm",
            order(coarse.width, fine.width, 4.0),
            Bound::Within(0.45, 0.55),
            spread,
        ),
        check(
            "The energy that the viscosity takes falls likewise",
            "spreading of a front by viscosity",
            "observed order of its share of the work, 0.5 mm to 0.125 mm",
            order(coarse.taken, fine.taken, 4.0),
            Bound::Within(0.45, 0.55),
            spread,
        ),
        limit(),
    ]
}

/// ζ = `linear` of this check.
const ZETA: f64 = 0.37;

/// A held fibre with viscosity, 2 % beyond the limit.
fn limit() -> Check {
    let courant = 1.02 * ((1.0 + ZETA * ZETA).sqrt() - ZETA);
    let growth = |courant: f64| {
        let mut scene: Scene = linear_scene(courant);
        scene.primary.material.artificial_viscosity =
            Some(Coefficients { linear: ZETA, quadratic: 0.0 });
        let n = scene.primary.elements;
        let phase = std::f64::consts::PI * (n - 1) as f64 / n as f64;
        let mut state = held(&scene, |i| 1e-5 * Number::sin(phase * i as f64));
        let mut amplitude = Vec::new();
        march::run(&edition(), &mut state, 200, |state| {
            amplitude.push(state.primary.velocity[1].x.abs());
        });
        let rate = Number::ln(amplitude[199] / amplitude[99]) / 100.0;
        (rate, phase)
    };
    let (below, _) = growth(courant / 1.04);
    let (beyond, phase) = growth(courant);
    // sin²(kΔx/2) of the mode; in the place of α² for the highest.
    let sine = Number::sin(phase / 2.0);
    let mode = courant * courant * sine * sine;
    let d = ZETA / courant;
    let (b, c) = (4.0 * mode * (1.0 + d) - 2.0, 1.0 - 4.0 * mode * d);
    let root = 0.5 * (b + (b * b - 4.0 * c).sqrt());
    let error = if below < 0.0 { relative(beyond, Number::ln(root)) } else { f64::MAX };
    check(
        "2 % below √(1 + ζ²) - ζ the highest mode decays, 2 % above it grows as von Neumann says",
        "greater root of g² + g(4α²s²(1 + ζ/α) - 2) + 1 - 4α²s²ζ/α = 0, s = sin(kΔx/2)",
        "relative error of the growth rate above; none if it grows below",
        error,
        Bound::AtMost(1e-7),
        "rounding excites the modes beside the highest, which grow nearly as fast",
    )
}
