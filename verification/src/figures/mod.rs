//! The study `figures`: Figs 3 to 7 of the paper redrawn, from the scheme as printed and corrected and
//! from closed forms, with the numbers as tables and a page that shows them.
//!
//! [`points::points`] are the runs; [`files`] is a pure function of what they gave.

mod curves;
mod fig3;
mod page;
pub mod points;
mod window;

use crossfibre::exact::crossover::Coefficients;
use std::collections::BTreeMap;

use points::{Edition, Run, Snapshot, Strains};

use crate::sweep::Point;

/// The study, with the format of its points.
pub const STUDY: &str = "figures/1";

/// What the runs gave, by id.
pub struct Snapshots(BTreeMap<String, Snapshot>);

impl Snapshots {
    /// The values of points, in their order.
    pub fn new(points: &[Point<Run>], values: Vec<Snapshot>) -> Self {
        Self(points.iter().map(|point| point.id.clone()).zip(values).collect())
    }

    fn of(&self, id: &str) -> &Snapshot {
        self.0.get(id).unwrap_or_else(|| panic!("no point is called {id}"))
    }

    /// The strains of a profile; none if its run did not complete.
    fn strains(&self, edition: Edition, factor: usize) -> Option<&Strains> {
        self.of(&points::profile_id(edition, factor)).strains.as_ref()
    }
}

/// Which windows a mean is over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Window {
    /// Between the exact fronts.
    BetweenFronts,
    /// Fixed, blind to reflected waves.
    Fixed,
}

impl Window {
    fn name(self) -> &'static str {
        match self {
            Self::BetweenFronts => "between fronts",
            Self::Fixed => "fixed",
        }
    }

    fn of(self, snapshot: &Snapshot) -> Option<Coefficients> {
        match self {
            Self::BetweenFronts => snapshot.between_fronts,
            Self::Fixed => snapshot.fixed,
        }
    }
}

/// Every file of the study, by name.
pub fn files(snapshots: &Snapshots) -> Vec<(&'static str, String)> {
    vec![
        ("README.md", page::page(snapshots)),
        ("fig3.svg", fig3::whole(snapshots)),
        ("fig3-plateaus.svg", fig3::plateaus(snapshots)),
        ("fig3.csv", fig3::table(snapshots)),
        ("fig3-exact.csv", fig3::exact_table()),
        ("motion.svg", fig3::motion_picture()),
        ("fig4.svg", curves::fig4(snapshots)),
        ("fig4.csv", curves::table(snapshots, points::Abscissa::Modulus)),
        ("fig5.svg", curves::fig5(snapshots)),
        ("fig6.svg", curves::fig6(snapshots)),
        ("fig7.svg", curves::fig7(snapshots)),
        ("fig5-7.csv", curves::table(snapshots, points::Abscissa::Slide)),
        ("window-printed.svg", window::picture(snapshots, Edition::Printed)),
        ("window-corrected.svg", window::picture(snapshots, Edition::Corrected)),
        ("window.csv", window::table(snapshots)),
    ]
}
