//! What is read off a run, and how far it is from what it ought to be.

use crossfibre::number::Number;
use crossfibre::state::FibreState;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::exact::{Arrival, Exact, Kink, Piece, Plateau, integral, only_plateau};
use super::run::{Marched, Run};
use crate::figures::points::mean_over;

/// A number that a run gives.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Mean strain in the middle half of the widest plateau of the primary.
    Plateau,
    /// R.
    Reflection,
    /// T.
    Transmission,
    /// D.
    Diversion,
    /// Mean strain of the primary.
    MeanStrain,
    /// Mean strain of the secondary.
    SecondaryMean,
    /// ∫|ε − exact| dX over ∫|exact| dX, primary.
    StrainL1,
    /// √∫(ε − exact)² dX over √∫exact² dX, primary.
    StrainL2,
    /// As [`StrainL1`](Self::StrainL1), secondary.
    SecondaryL1,
    /// As [`StrainL2`](Self::StrainL2), secondary.
    SecondaryL2,
    /// Where the inclination of the primary passes half-way across its sharpest kink, m.
    Kink,
    /// When the front passes a place, s.
    Arrival,
    /// Velocity of a projectile that has a mass, m/s.
    Projectile,
    /// Residual of the energy balance over the energy put in.
    Energy,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 14] = [
        Self::Plateau,
        Self::Reflection,
        Self::Transmission,
        Self::Diversion,
        Self::MeanStrain,
        Self::SecondaryMean,
        Self::StrainL1,
        Self::StrainL2,
        Self::SecondaryL1,
        Self::SecondaryL2,
        Self::Kink,
        Self::Arrival,
        Self::Projectile,
        Self::Energy,
    ];

    /// Its name in tables and on axes.
    pub fn label(self) -> &'static str {
        match self {
            Self::Plateau => "plateau strain",
            Self::Reflection => "R",
            Self::Transmission => "T",
            Self::Diversion => "D",
            Self::MeanStrain => "mean strain",
            Self::SecondaryMean => "secondary's mean strain",
            Self::StrainL1 => "strain profile, L1",
            Self::StrainL2 => "strain profile, L2",
            Self::SecondaryL1 => "secondary's strain profile, L1",
            Self::SecondaryL2 => "secondary's strain profile, L2",
            Self::Kink => "position of the kink",
            Self::Arrival => "arrival of the front",
            Self::Projectile => "velocity of the projectile",
            Self::Energy => "energy residual",
        }
    }
}

/// A quantity of a run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reading {
    /// Which.
    pub quantity: Quantity,
    /// What the run gives.
    pub value: f64,
    /// What is exact; none where nothing says.
    pub exact: Option<f64>,
}

impl Reading {
    /// The error: relative where the exact number is not zero, for a norm or a residual itself.
    pub fn error(&self) -> Option<f64> {
        self.exact.map(|exact| if exact == 0.0 { self.value } else { self.value / exact - 1.0 })
    }
}

/// Everything that a finished run can be asked.
pub fn readings<S: Number>(
    run: &Run,
    marched: &Marched<S>,
    exact: Option<&Exact>,
    residual: Option<f64>,
) -> Vec<Reading> {
    let Marched { state, arrived } = marched;
    let (scene, length) = (&run.scene, run.scene.primary.length);
    let primary = strains(&state.primary);
    let mut all = Vec::new();
    let mut read = |quantity, value, exact| all.push(Reading { quantity, value, exact });
    read(
        Quantity::MeanStrain,
        mean_over(length, &primary, (0.0, length)),
        exact.map(|exact| integral(&exact.primary) / length),
    );
    let plateau = match exact {
        Some(exact) => exact.plateau,
        None if run.pulled_along => None,
        None => only_plateau(scene, state.time().to_f64()),
    };
    if let Some(plateau) = &plateau {
        let mean = mean_over(length, &primary, plateau.window);
        read(Quantity::Plateau, mean, Some(plateau.strain));
    }
    if let Some(exact) = exact {
        let (l1, l2) = norms(length, &primary, &exact.primary);
        read(Quantity::StrainL1, l1, Some(0.0));
        read(Quantity::StrainL2, l2, Some(0.0));
        if let Some(kink) = exact.kink
            && let Some(at) = turning_point(&state.primary, kink)
        {
            read(Quantity::Kink, at, Some(kink.at));
        }
    }
    if let (Some(across), Some(crossover)) = (&scene.secondary, &state.crossover) {
        let length = across.length;
        let secondary = strains(&crossover.fibre);
        read(
            Quantity::SecondaryMean,
            mean_over(length, &secondary, (0.0, length)),
            exact.map(|exact| integral(&exact.secondary) / length),
        );
        if let Some(exact) = exact {
            let (l1, l2) = norms(length, &secondary, &exact.secondary);
            read(Quantity::SecondaryL1, l1, Some(0.0));
            read(Quantity::SecondaryL2, l2, Some(0.0));
        }
        if let Some(around) = exact.and_then(|exact| exact.around) {
            let share = |strain: f64| strain / around.incident;
            let mean = |of: &Plateau| share(mean_over(scene.primary.length, &primary, of.window));
            let diverted = share(mean_over(length, &secondary, around.diverted.window));
            let (behind, ahead) = (&around.behind, &around.ahead);
            read(Quantity::Reflection, mean(behind) - 1.0, Some(share(behind.strain) - 1.0));
            read(Quantity::Transmission, mean(ahead), Some(share(ahead.strain)));
            read(Quantity::Diversion, diverted, Some(share(around.diverted.strain)));
        }
    }
    if let Some((arrival, arrived)) = Arrival::of(run).zip(*arrived) {
        read(Quantity::Arrival, arrived, Some(arrival.time));
    }
    if state.projectile.mass.is_some() {
        let exact = exact.map(|exact| exact.projectile_velocity);
        read(Quantity::Projectile, state.projectile.velocity.to_f64(), exact);
    }
    if let Some(residual) = residual {
        read(Quantity::Energy, residual, Some(0.0));
    }
    all.sort_by_key(|reading| reading.quantity);
    all
}

fn strains<S: Number, const D: usize>(fibre: &FibreState<S, D>) -> Vec<f64> {
    fibre.strain.iter().map(|strain| strain.to_f64()).collect()
}

/// L1 and L2 of the difference over those of the exact profile. Both are uniform in pieces, so the
/// integrals are sums.
fn norms(length: f64, strain: &[f64], exact: &[Piece]) -> (f64, f64) {
    let dx = length / strain.len() as f64;
    let (mut apart, mut squares, mut exact_squares) = (0.0, 0.0, 0.0);
    let (mut element, mut from) = (0, 0.0_f64);
    for piece in exact {
        exact_squares += (piece.to - piece.from) * piece.strain * piece.strain;
        while element < strain.len() {
            let end = (element + 1) as f64 * dx;
            let to = end.min(piece.to);
            let width = (to - from).max(0.0);
            let difference = strain[element] - piece.strain;
            apart += width * difference.abs();
            squares += width * difference * difference;
            from = from.max(to);
            if end > piece.to {
                break;
            }
            element += 1;
        }
    }
    (apart / integral(exact), (squares / exact_squares).sqrt())
}

/// Where the inclination of the fibre passes a level, nearest to where it ought to: linear between the
/// middles of elements.
fn turning_point<S: Number, const D: usize>(fibre: &FibreState<S, D>, kink: Kink) -> Option<f64> {
    let dx = fibre.properties.spacing.to_f64();
    let sines: Vec<f64> = fibre
        .position
        .windows(2)
        .map(|ends| {
            let element = ends[1] - ends[0];
            (element[1] / element.dot(&element).sqrt()).to_f64() - kink.level
        })
        .collect();
    let crossings = sines.windows(2).enumerate().filter_map(|(i, pair)| {
        let (here, ahead) = (pair[0], pair[1]);
        (here * ahead <= 0.0 && here != ahead)
            .then(|| (i as f64 + 0.5 + here / (here - ahead)) * dx)
    });
    crossings.min_by(|a, b| (a - kink.at).abs().total_cmp(&(b - kink.at).abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::shipped;
    use crate::precision::variants::Precision;
    use crate::precision::{Problem, Variant, found, run_of};
    use crossfibre::state::{State, Wavefront};

    fn piece(from: f64, to: f64, strain: f64) -> Piece {
        Piece { from, to, strain }
    }

    /// Elements of 0.5 against pieces that end within them, by hand.
    #[test]
    fn norms_are_integrals_over_every_overlap() {
        let exact = [piece(0.0, 0.3, 2.0), piece(0.3, 1.1, -1.0), piece(1.1, 1.5, 0.0)];
        let (l1, l2) = norms(1.5, &[1.7, -0.9, 0.4], &exact);
        let apart = [(0.3, 0.3), (0.2, 2.7), (0.5, 0.1), (0.1, 1.4), (0.4, 0.4)];
        let sum = |f: fn(f64) -> f64| apart.iter().map(|&(width, d)| width * f(d)).sum::<f64>();
        // A dozen roundings.
        let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-14, "{a} {b}");
        near(l1, sum(|d| d) / (0.3 * 2.0 + 0.8));
        near(l2, (sum(|d| d * d) / (0.3 * 4.0 + 0.8)).sqrt());
    }

    #[test]
    fn the_exact_profile_has_no_error() {
        let exact = [piece(0.0, 0.6, 0.013), piece(0.6, 1.8, 0.017)];
        assert_eq!(norms(1.8, &[0.013, 0.017, 0.017], &exact), (0.0, 0.0));
    }

    /// Of a law without exact fronts there may be a closed form; of a fibre that is pulled along itself
    /// Smith's is none.
    #[test]
    fn without_an_exact_profile_a_plateau_is_that_of_the_closed_form_if_the_fibre_was_struck() {
        let read = |name: &str, pulled_along: bool| {
            let (scene, precision) = (shipped(name), Precision::Double);
            let found = found(&Run { scene, pulled_along, precision, flagged: true });
            let of = |quantity| found.readings.iter().any(|reading| reading.quantity == quantity);
            (of(Quantity::Plateau), of(Quantity::StrainL1))
        };
        assert_eq!(read("hardening", false), (true, false));
        assert_eq!(read("single-400", true), (false, false));
    }

    /// Three elements of a zigzag, and level ones: the inclination passes zero at nodes 1 and 2, and for
    /// the last time where it is just zero, in the middle of element 3.
    #[test]
    fn of_places_where_the_inclination_passes_a_level_the_nearest_is_the_kink() {
        let mut fibre = State::<f64>::at_impact(&shipped("single-400"), Wavefront::Flagged).primary;
        let dx = fibre.properties.spacing;
        for (node, height) in [0.0, 1.0, 0.0].into_iter().enumerate() {
            fibre.position[node].y = height * dx;
        }
        fibre.position.iter_mut().skip(3).for_each(|node| node.y = dx);
        let found = |at: f64| turning_point(&fibre, Kink { at: at * dx, level: 0.0 }).unwrap() / dx;
        for (near, expected) in [(0.2, 1.0), (1.4, 1.0), (2.1, 2.0), (9.0, 3.5)] {
            assert!((found(near) - expected).abs() < 1e-12, "{near}: {}", found(near));
        }
    }

    /// What is read of a run of Fig. 3 beside its own errors: those of axial waves at α = 1 and of the
    /// kink, which lags by about Δx^(2/3) (docs/convergence.md). Bounds are twice what was measured.
    #[test]
    fn every_quantity_is_read_and_near_to_what_is_exact() {
        let run = run_of(Problem::Crossed, &Variant::named("engineering, α = 1"), 16.0);
        let found = found(&run);
        let quantities: Vec<_> = found.readings.iter().map(|reading| reading.quantity).collect();
        let mut expected = Quantity::ALL.to_vec();
        expected.retain(|&quantity| quantity != Quantity::Projectile);
        assert_eq!(quantities, expected);
        for reading in &found.readings {
            let most = match reading.quantity {
                Quantity::Plateau | Quantity::Transmission | Quantity::Energy => 1e-5,
                Quantity::Reflection | Quantity::Diversion => 2e-4,
                Quantity::MeanStrain => 2.4e-3,
                Quantity::SecondaryMean => 1.8e-2,
                Quantity::StrainL1 | Quantity::Kink | Quantity::Arrival => 1.1e-2,
                Quantity::SecondaryL1 | Quantity::StrainL2 => 7e-2,
                Quantity::SecondaryL2 => 1.8e-1,
                Quantity::Projectile => unreachable!("its velocity is constant"),
            };
            let error = reading.error().unwrap();
            assert!(error != 0.0 && error.abs() < most, "{reading:?}: {error:e}");
        }
    }
}
