//! The study `stability`: the largest stable Courant number, found three ways.
//!
//! - *By hand* ([`closed_form`]), where a formula can be had.
//! - *By the spectral radius* of the linearised step ([`spectrum`]): the march itself, on numbers that
//!   carry a derivative ([`dual`]).
//! - *Measured* ([`growth`]): a small perturbation, marched over ten thousand steps and more.
//!
//! All start from states at rest in equilibrium ([`base`]). [`tasks::points`] is what is computed, and
//! [`files`] a pure function of what came of it.

pub mod base;
pub mod closed_form;
pub mod dual;
pub mod growth;
pub mod impact;
pub mod limit;
pub mod maps;
mod page;
mod pictures;
pub mod rows;
pub mod spectrum;
pub mod tasks;
pub mod uniform;

use std::collections::BTreeMap;

use maps::Map;
use rows::Row;
use tasks::{Found, Task};

use crate::sweep::Point;
use crate::tables::{Table, cell};

/// The study, with the format of its points.
pub const STUDY: &str = "stability/1";

/// What the points gave, by id.
pub struct Results(BTreeMap<String, Found>);

impl Results {
    /// The values of points, in their order.
    pub fn new(points: &[Point<Task>], values: Vec<Found>) -> Self {
        Self(points.iter().map(|point| point.id.clone()).zip(values).collect())
    }

    fn of(&self, id: &str) -> &Found {
        self.0.get(id).unwrap_or_else(|| panic!("no point is called {id}"))
    }

    /// The limits of a row: by the spectral radius, measured, and what the march allows.
    fn limits(&self, row: &Row) -> [Option<f64>; 3] {
        match self.of(&row.id) {
            Found::Limits { predicted, measured, allowed } => [*predicted, *measured, *allowed],
            other => panic!("{} has no limits: {other:?}", row.id),
        }
    }
}

/// Every file of the study, by name.
pub fn files(results: &Results) -> Vec<(&'static str, String)> {
    let maps = maps::maps();
    let columns: Vec<(&Map, f64)> =
        maps.iter().flat_map(|map| map.x.values().into_iter().map(move |x| (map, x))).collect();
    let mut files = vec![
        ("README.md", page::page(results)),
        ("limits.csv", limits(results, &rows::rows())),
        ("maps.csv", cells(results, &columns)),
        ("edges.csv", edges(results, &columns)),
    ];
    for (pair, name) in maps.chunks(2).zip(["slide.svg", "modulus.svg", "velocity.svg", "mass.svg"])
    {
        files.push((name, pictures::picture(results, pair)));
    }
    files
}

/// A limit in tables: to six decimals, which is more than the search and the eigenvalues are good to on
/// every machine.
fn decimal(limit: Option<f64>) -> String {
    match limit {
        Some(limit) if limit <= limit::RANGE.1 => format!("{limit:.6}"),
        _ => format!("> {}", limit::RANGE.1),
    }
}

/// The head of the table of limits.
pub const LIMITS: &str =
    "row,by hand [1],spectral radius [1],measured [1],allowed by the march [1]";

/// The limits of rows.
pub fn limits(results: &Results, rows: &[Row]) -> String {
    let mut table = Table::new(&[LIMITS]);
    for row in rows {
        let found = results.limits(row).map(decimal);
        table.row(&[&[row.id.clone(), decimal(Some(row.by_hand))], &found[..]].concat());
    }
    table.text()
}

/// The head of the table of cells.
pub const CELLS: &str = "map,abscissa,value,Courant number [1],state,ln of growth in a step [1],steps \
                         until it diverged [1]";

/// The cells of columns of maps.
pub fn cells(results: &Results, columns: &[(&Map, f64)]) -> String {
    let mut table = Table::new(&[CELLS]);
    for (map, x) in columns {
        for (found, courant) in map.cells(results, *x).iter().zip(map.courant.0.values()) {
            table.row(&[
                map.id.clone(),
                map.abscissa.into(),
                cell(Some(*x)),
                cell(Some(courant)),
                pictures::State::name(found).into(),
                format!("{:.2e}", found.rate),
                cell(found.diverged.map(|step| step as f64)),
            ]);
        }
    }
    table.text()
}

/// The limits by columns of maps.
fn edges(results: &Results, columns: &[(&Map, f64)]) -> String {
    let mut table = Table::new(&["map", "abscissa", "value", "spectral radius [1]", "by hand [1]"]);
    for (map, x) in columns {
        let numbers = [map.edge(results, *x), Some(map.by_hand(*x))].map(decimal);
        let head = [map.id.clone(), map.abscissa.into(), cell(Some(*x))];
        table.row(&[&head[..], &numbers[..]].concat());
    }
    table.text()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_has_six_decimals_up_to_the_end_of_the_search() {
        let found = [Some(0.0), Some(0.948_683_298), Some(2.0), Some(2.5), None].map(decimal);
        assert_eq!(found, ["0.000000", "0.948683", "2.000000", "> 2", "> 2"]);
    }
}
