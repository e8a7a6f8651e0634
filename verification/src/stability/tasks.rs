//! What the study computes, point by point.

use crossfibre::scene::{Scene, Strain};
use serde::{Deserialize, Serialize};

use super::base::Base;
use super::growth::{Growth, Shaken, growth, shaken};
use super::impact::impact;
use super::limit::largest_stable;
use super::maps::maps;
use super::rows::{ALONE, MEASURES, at_rest, fibre, measure_name, rows};
use super::spectrum::{self, spectral_radius};
use crate::sweep::Point;

/// A point of the sweep.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
pub enum Task {
    /// The limits of a row: by the spectral radius, and measured.
    Limits(Base),
    /// The limit at a column of a map, by the spectral radius.
    Edge(Base),
    /// A uniform fibre, with perturbations that are not small.
    Shaken {
        /// What is marched.
        base: Base,
        /// The Courant number.
        courant: f64,
        /// Sizes over the wave speed.
        sizes: Vec<f64>,
    },
    /// Cells of a map in a column: a perturbation at each Courant number.
    Perturbed {
        /// What is marched.
        base: Base,
        /// The Courant numbers.
        courant: Vec<f64>,
    },
    /// Cells of a map in a column: an impact at each Courant number.
    Struck {
        /// What is marched.
        scene: Scene,
        /// The exact strain behind the front.
        exact: f64,
        /// The Courant numbers.
        courant: Vec<f64>,
    },
}

/// What came of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
pub enum Found {
    /// Of [`Task::Limits`].
    Limits {
        /// By the spectral radius.
        predicted: Option<f64>,
        /// By marching.
        measured: Option<f64>,
        /// Up to which the march makes the first step.
        allowed: Option<f64>,
    },
    /// Of [`Task::Shaken`].
    Shaken(Vec<Shaken>),
    /// Of [`Task::Edge`].
    Edge(Option<f64>),
    /// Of a column of cells.
    Cells(Vec<Growth>),
}

/// Every point.
pub fn points() -> Vec<Point<Task>> {
    let of_rows =
        rows().into_iter().map(|row| Point { id: row.id, parameters: Task::Limits(row.base) });
    let of_maps = maps().into_iter().flat_map(|map| map.points());
    of_rows.chain(shakings().into_iter().map(|(_, point)| point)).chain(of_maps).collect()
}

/// Sizes of perturbations that are not small, over the wave speed.
pub const SIZES: [f64; 4] = [0.001, 0.01, 0.03, 0.1];

/// Strain of fibres that are shaken: what (4) has behind an impact at half the wave speed.
pub const SHAKEN: f64 = 0.27;

/// Courant number and measure of fibres that are shaken, and the point.
pub fn shakings() -> Vec<((f64, Strain), Point<Task>)> {
    let mut shakings = Vec::new();
    for measure in MEASURES {
        for courant in [0.1, 0.3, 0.9] {
            let base = at_rest(fibre(ALONE, measure), SHAKEN);
            let id = format!("shaken-{}-{courant}", measure_name(measure)).replace(['(', ')'], "");
            let parameters = Task::Shaken { base, courant, sizes: SIZES.to_vec() };
            shakings.push(((courant, measure), Point { id, parameters }));
        }
    }
    shakings
}

/// The limit by the spectral radius of the linearised step.
pub fn predicted(base: &Base) -> Option<f64> {
    largest_stable(|courant| spectral_radius(base, courant) > 1.0 + spectrum::THRESHOLD)
}

/// The limit by marching a perturbation.
pub fn measured(base: &Base) -> Option<f64> {
    largest_stable(|courant| growth(base, courant).is_unstable())
}

/// Computes a point.
pub fn compute(task: &Task) -> Found {
    match task {
        Task::Limits(base) => {
            let allowed = largest_stable(|courant| base.is_refused(courant));
            Found::Limits { predicted: predicted(base), measured: measured(base), allowed }
        }
        Task::Shaken { base, courant, sizes } => {
            Found::Shaken(sizes.iter().map(|&size| shaken(base, *courant, size)).collect())
        }
        Task::Edge(base) => Found::Edge(predicted(base)),
        Task::Perturbed { base, courant } => {
            Found::Cells(courant.iter().map(|&courant| growth(base, courant)).collect())
        }
        Task::Struck { scene, exact, courant } => {
            let struck =
                |courant: &f64| impact(&Scene { courant: *courant, ..scene.clone() }, *exact);
            Found::Cells(courant.iter().map(struck).collect())
        }
    }
}
