//! What the study computes, point by point.

use crossfibre::scene::Scene;
use serde::{Deserialize, Serialize};

use super::base::Base;
use super::growth::{Growth, growth};
use super::impact::impact;
use super::limit::largest_stable;
use super::maps::maps;
use super::rows::rows;
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
    },
    /// Of [`Task::Edge`].
    Edge(Option<f64>),
    /// Of a column of cells.
    Cells(Vec<Growth>),
}

/// Every point.
pub fn points() -> Vec<Point<Task>> {
    let of_rows =
        rows().into_iter().map(|row| Point { id: row.id, parameters: Task::Limits(row.base) });
    of_rows.chain(maps().iter().flat_map(super::maps::Map::points)).collect()
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
            Found::Limits { predicted: predicted(base), measured: measured(base) }
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
