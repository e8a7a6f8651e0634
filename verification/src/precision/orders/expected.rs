//! The table of expected orders.

use std::fmt;

use crossfibre::errata::Corrections;
use crossfibre::scene::Strain;

use crate::precision::{Problem, Quantity, Variant};

/// What is expected of the order of an error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Expected {
    /// One term decides: its order.
    Order(f64),
    /// Two terms are of one size on these meshes: the order of the slower and that of the faster.
    Between(f64, f64),
    /// The error does not fall: a wrong limit.
    Stays,
    /// There is no error beyond what the exact solution leaves open.
    Exact,
    /// The sign changes with the mesh: there is no order.
    Swings,
}

impl fmt::Display for Expected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Order(order) => write!(f, "{}", fraction(order)),
            Self::Between(from, to) => write!(f, "{} to {}", fraction(from), fraction(to)),
            Self::Stays => write!(f, "0: does not fall"),
            Self::Exact => write!(f, "no error"),
            Self::Swings => write!(f, "none: swings"),
        }
    }
}

/// An order by its name.
fn fraction(order: f64) -> String {
    let thirds = [(0.25, "1/4"), (1.0 / 3.0, "1/3"), (0.5, "1/2"), (2.0 / 3.0, "2/3")];
    let named = thirds.iter().find(|(value, _)| *value == order);
    named.map_or_else(|| format!("{order}"), |(_, name)| (*name).to_owned())
}

/// How wide a front is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Front {
    /// Some elements.
    Sharp,
    /// At α near to 1: some elements, until the next is wider.
    NearlySharp,
    /// (h²t)^(1/3), with a tail of ringing.
    Dispersed,
    /// √(ht): spread by artificial viscosity, whose kinematic viscosity is a number times ch.
    Diffused,
}

impl Front {
    fn of(problem: Problem, variant: &Variant) -> Self {
        match variant.courant {
            _ if variant.viscous => Self::Diffused,
            // The smaller Δx/c, that of the secondary, sets the time step: α = 0.86 on the primary.
            courant if problem == Problem::Unequal || courant < 0.9 => Self::Dispersed,
            1.0 => Self::Sharp,
            _ => Self::NearlySharp,
        }
    }
}

const THIRD: f64 = 1.0 / 3.0;
const TWO_THIRDS: f64 = 2.0 / 3.0;

/// Meshes on which the window of a mean holds some tens of elements.
const FINE: f64 = 4.0;

/// What is expected of an error, from which refinement on, and why; none where nothing was derived.
pub fn expected(
    problem: Problem,
    variant: &Variant,
    quantity: Quantity,
) -> Option<(Expected, f64, &'static str)> {
    let front = Front::of(problem, variant);
    if variant.corrections != Corrections::ALL {
        return printed(problem, variant, quantity);
    }
    let found = match (problem, variant.strain) {
        (Problem::Rod, strain) => rod(front, strain, quantity),
        (_, Strain::Engineering) => engineering(problem, front, quantity),
        (_, Strain::Incremental) => incremental(problem, front, quantity),
    };
    found.map(|(expected, why)| {
        let is_path = variant.strain == Strain::Incremental && quantity == Quantity::Plateau;
        (expected, if is_path { FINE } else { 1.0 }, why)
    })
}

type Found = Option<(Expected, &'static str)>;

fn engineering(problem: Problem, front: Front, quantity: Quantity) -> Found {
    use Expected::{Between, Order, Swings};
    Some(match (quantity, front) {
        (Quantity::Kink, _) => (Order(TWO_THIRDS), KINK),
        (Quantity::MeanStrain, _) => (Order(1.0), LATE),
        (Quantity::SecondaryMean, Front::Sharp) => (Order(1.0), LATE),
        (Quantity::Energy, Front::Sharp | Front::NearlySharp | Front::Dispersed)
            if problem != Problem::Unequal =>
        {
            (Order(1.0), STAGGERED)
        }
        (Quantity::Arrival, Front::Sharp | Front::Diffused) => (Order(1.0), LATE),
        (Quantity::Arrival, _) => (Between(TWO_THIRDS, 1.0), LATE_AND_WIDE),
        (Quantity::StrainL1, Front::Sharp) => (Between(TWO_THIRDS, 1.0), SHARP_L1),
        (Quantity::StrainL1, Front::NearlySharp | Front::Dispersed) => {
            (Between(0.5, 1.0), DISPERSED_L1)
        }
        (Quantity::StrainL1, Front::Diffused) => (Order(0.5), DIFFUSED),
        (Quantity::StrainL2, Front::Sharp) => (Order(0.5), SHARP_L2),
        (Quantity::StrainL2, Front::NearlySharp | Front::Dispersed) => {
            (Between(THIRD, 0.5), DISPERSED_L2)
        }
        (Quantity::StrainL2, Front::Diffused) => (Order(0.25), DIFFUSED),
        (Quantity::SecondaryL1, Front::Sharp) => (Between(TWO_THIRDS, 1.0), SHARP_L1),
        (Quantity::SecondaryL2, Front::Sharp) => (Order(0.5), SHARP_L2),
        (Quantity::Plateau, Front::Sharp | Front::NearlySharp | Front::Dispersed)
            if problem != Problem::Unequal =>
        {
            (Swings, RINGING)
        }
        (Quantity::Reflection | Quantity::Diversion, Front::Sharp | Front::Dispersed) => {
            (Swings, RINGING)
        }
        _ => return None,
    })
}

fn incremental(problem: Problem, front: Front, quantity: Quantity) -> Found {
    use Expected::{Between, Order};
    Some(match (quantity, front) {
        (Quantity::Kink, _) => (Order(TWO_THIRDS), KINK),
        (Quantity::StrainL1, Front::Sharp) => (Between(TWO_THIRDS, 1.0), FAN),
        (Quantity::StrainL2, Front::Sharp) => (Between(0.5, 1.0), FAN),
        (Quantity::Plateau, Front::Sharp) if problem == Problem::Single => {
            (Between(0.25, THIRD), PATH)
        }
        (Quantity::Plateau, Front::Diffused) if problem == Problem::Single => {
            (Order(0.5), DIFFUSED_PATH)
        }
        (Quantity::Energy, Front::Sharp) => (Between(0.0, THIRD), PATH_ENERGY),
        _ => return None,
    })
}

fn rod(front: Front, strain: Strain, quantity: Quantity) -> Found {
    use Expected::{Between, Exact, Order, Stays};
    let is_engineering = strain == Strain::Engineering;
    Some(match (quantity, front) {
        (Quantity::MeanStrain, _) if is_engineering => (Exact, TELESCOPES),
        (Quantity::MeanStrain, _) => (Stays, ROD_PATH),
        (Quantity::StrainL1, Front::Sharp) if is_engineering => (Order(1.0), ROD_SHARP),
        (Quantity::StrainL2, Front::Sharp) if is_engineering => (Order(1.0), ROD_SHARP),
        (Quantity::StrainL1, Front::Dispersed) => (Between(0.5, TWO_THIRDS), ROD_DISPERSED),
        (Quantity::StrainL2, Front::Dispersed | Front::NearlySharp) => {
            (Order(THIRD), ROD_DISPERSED)
        }
        (Quantity::StrainL1, Front::Diffused) if is_engineering => (Order(0.5), DIFFUSED),
        (Quantity::StrainL2, Front::Diffused) if is_engineering => (Order(0.25), DIFFUSED),
        (Quantity::Arrival, Front::Dispersed) => (Order(TWO_THIRDS), ROD_ARRIVAL),
        (Quantity::Energy, Front::Sharp | Front::Dispersed) if is_engineering => {
            (Order(1.0), ROD_ENERGY)
        }
        _ => return None,
    })
}

fn printed(
    problem: Problem,
    variant: &Variant,
    quantity: Quantity,
) -> Option<(Expected, f64, &'static str)> {
    let is_wrong = match problem {
        Problem::Crossed => matches!(
            quantity,
            Quantity::Reflection | Quantity::Transmission | Quantity::Diversion | Quantity::Energy
        ),
        Problem::Unequal => matches!(quantity, Quantity::MeanStrain | Quantity::Energy),
        _ => false,
    };
    let is_whole = variant.corrections == Corrections::NONE;
    (is_wrong && is_whole).then_some((Expected::Stays, FINE, WRONG))
}

const LATE: &str = "A fibre that is struck is strained only as its first elements turn; that takes the same \
    number of steps on every mesh, so the front starts late by a length of some elements, which is first \
    order in its time, in the mean strain and in the L1 norm.";

const KINK: &str = "Transverse waves move at a Courant number far below 1, and disperse: the kink is \
    (h²t)^(1/3) wide, and the place half-way across it lags by a part of that width.";

const STAGGERED: &str = "What leapfrog keeps differs from the energy by a multiple of Σ m (Δv)², Δv a node's change \
    in a step. By Parseval the sum of (Δv)² over a jump and its ringing is the same on every mesh, whatever \
    the front's width, and in proportion with α²; m is in proportion with h.";

const ROD_ENERGY: &str = "A jump over one element, in energies that are half a step apart.";

const LATE_AND_WIDE: &str = "The front starts late by some elements (1), and half of its strain comes later by a \
    part of its width (2/3).";

const SHARP_L1: &str = "At α = 1 the front is late by some elements (1); the ringing of the kink is as wide as \
    that (2/3).";

const SHARP_L2: &str = "An error of the size of the strain over some elements.";

const DISPERSED_L1: &str = "The front is late by some elements (1), (h²t)^(1/3) wide (2/3), with a tail (1/2): each \
    decides on finer meshes than the one before.";

const DISPERSED_L2: &str = "The front is late by some elements (1/2) and (h²t)^(1/3) wide (1/3).";

const DIFFUSED: &str = "A viscosity in proportion with h spreads a front over √(ht): 1/2 in L1 and half of that \
    in L2.";

const RINGING: &str = "The strain between the fronts is exact but for ringing, whose phase at the ends of the \
    window is another on each mesh.";

const FAN: &str = "Under T = E ln λ the exact front is a fan, 1.4 mm wide at this time: a jump on meshes that are \
    coarser (1 and 1/2 in L1 and L2, and the kink's 2/3), continuous on those that are finer (1 in \
    both).";

const PATH: &str = "By (4) a rise in m steps adds ε²/(2m) to the logarithm. With m as the width of a dispersed \
    front in elements that is order 1/3; the tail's part falls more slowly.";

const DIFFUSED_PATH: &str = "By (4) a rise in m steps adds ε²/(2m) to the logarithm, and a front of √(ht) is \
    m ∝ h^(-1/2) elements wide.";

const PATH_ENERGY: &str = "The work of (4) depends on the path as its strain does, wherever a wave rings: at most \
    1/3, down to nearly none.";

const TELESCOPES: &str =
    "The sum of ΔL/L₀ over a straight fibre is what its end has moved, to rounding.";

const ROD_PATH: &str = "By (4) a jump of ε₀ at the front adds ε₀ and what follows the logarithm: the limit is \
    another strain than the logarithm, on every mesh.";

const ROD_SHARP: &str = "At α = 1 the front is sharp and in its place: what is left is that a strain which is \
    uniform in an element stands for one that is not.";

const ROD_DISPERSED: &str = "A front of (h²t)^(1/3) with nothing beside it: 1/3 in L2; in L1 2/3 for the front and \
    1/2 for its tail.";

const ROD_ARRIVAL: &str = "Half of the strain comes later by a part of the front's width.";

const WRONG: &str = "The printed coupling is another problem: its limit is not the exact one.";

#[cfg(test)]
mod tests {
    use super::super::table;
    use crate::precision::stored::stored;

    #[test]
    fn the_orders_of_the_stored_record_are_those_of_the_committed_page() {
        let page = include_str!("../../../../VALIDATION.md");
        let table = table(stored());
        assert!(table.starts_with("| problem |") && page.contains(&table), "{table}");
    }
}
