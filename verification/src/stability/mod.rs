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

use std::collections::BTreeMap;

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

    /// The limits of a row: by the spectral radius, and measured.
    fn limits(&self, row: &Row) -> (Option<f64>, Option<f64>) {
        match self.of(&row.id) {
            Found::Limits { predicted, measured } => (*predicted, *measured),
            other => panic!("{} has no limits: {other:?}", row.id),
        }
    }
}

/// Every file of the study, by name.
pub fn files(results: &Results) -> Vec<(&'static str, String)> {
    let maps = maps::maps();
    let mut files = vec![
        ("README.md", page::page(results)),
        ("limits.csv", limits(results)),
        ("maps.csv", cells(results)),
        ("edges.csv", edges(results)),
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
    limit.map_or_else(|| format!("> {}", limit::RANGE.1), |limit| format!("{limit:.6}"))
}

fn limits(results: &Results) -> String {
    let mut table = Table::new(&["row", "spectral radius [1]", "measured [1]", "by hand [1]"]);
    for row in rows::rows() {
        let (predicted, measured) = results.limits(&row);
        let by_hand = decimal(Some(row.closed_form));
        table.row(&[row.id, decimal(predicted), decimal(measured), by_hand]);
    }
    table.text()
}

fn cells(results: &Results) -> String {
    let mut table = Table::new(&[
        "map",
        "abscissa",
        "value",
        "Courant number [1]",
        "state",
        "ln of growth in a step [1]",
        "steps until it diverged [1]",
    ]);
    for map in maps::maps() {
        for x in map.x.values() {
            for (found, courant) in map.cells(results, x).iter().zip(map.courant.0.values()) {
                table.row(&[
                    map.id.clone(),
                    map.abscissa.into(),
                    cell(Some(x)),
                    cell(Some(courant)),
                    pictures::State::name(found).into(),
                    format!("{:.2e}", found.rate),
                    cell(found.diverged.map(|step| step as f64)),
                ]);
            }
        }
    }
    table.text()
}

fn edges(results: &Results) -> String {
    let mut table = Table::new(&["map", "abscissa", "value", "spectral radius [1]", "by hand [1]"]);
    for map in maps::maps() {
        for x in map.x.values() {
            let (edge, by_hand) = (map.edge(results, x), map.closed_form(x));
            let numbers = [decimal(edge), decimal(Some(by_hand))];
            table.row(
                &[&[map.id.clone(), map.abscissa.into(), cell(Some(x))], &numbers[..]].concat(),
            );
        }
    }
    table.text()
}
