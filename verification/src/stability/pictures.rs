//! The maps as pictures.

use super::Results;
use super::growth::Growth;
use super::maps::Map;
use super::tasks::Found;
use crate::plot::{Colour, Panel, Series, Style, svg};

/// What a cell is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Nothing grows.
    Stable,
    /// Something grows, and all steps were made.
    Growing,
    /// The march left all bounds within so many steps.
    Diverged(u64),
}

/// All that a cell can be, with what the legend calls it.
const STATES: [(State, &str, Colour); 5] = [
    (State::Stable, "stable", Colour::Mist),
    (State::Growing, "growing", Colour::Sand),
    (State::Diverged(u64::MAX), "diverged later", Colour::Amber),
    (State::Diverged(1000), "diverged within 1000 steps", Colour::Rust),
    (State::Diverged(100), "diverged within 100 steps", Colour::Brown),
];

impl State {
    fn of(cell: &Growth) -> Self {
        match cell.diverged {
            Some(0..=100) => Self::Diverged(100),
            Some(101..=1000) => Self::Diverged(1000),
            Some(_) => Self::Diverged(u64::MAX),
            None if cell.is_unstable() => Self::Growing,
            None => Self::Stable,
        }
    }

    /// What tables call it.
    pub fn name(cell: &Growth) -> &'static str {
        match Self::of(cell) {
            Self::Stable => "stable",
            Self::Growing => "growing",
            Self::Diverged(_) => "diverged",
        }
    }
}

impl Map {
    /// The cells at a value of the abscissa, upward.
    pub fn cells<'a>(&self, results: &'a Results, x: f64) -> &'a [Growth] {
        match results.of(&self.cells_id(x)) {
            Found::Cells(cells) => cells,
            other => panic!("{} is no column of cells: {other:?}", self.id),
        }
    }

    /// The limit by the spectral radius at a value of the abscissa.
    pub fn edge(&self, results: &Results, x: f64) -> Option<f64> {
        match results.of(&self.edge_id(x)) {
            Found::Edge(edge) => edge.map(|limit| limit / self.finite()),
            other => panic!("{} is no limit: {other:?}", self.id),
        }
    }

    fn panel(&self, results: &Results, width: f64) -> Panel {
        let ((courant, tick), (label, x_tick)) = (self.courant, self.label);
        let style = Style::Cells { width: self.x.step(), height: courant.step() };
        let mut series: Vec<Series> = STATES
            .iter()
            .map(|&(_, name, colour)| Series::new(name, colour, style, vec![]))
            .collect();
        for x in self.x.values() {
            for (cell, y) in self.cells(results, x).iter().zip(courant.values()) {
                let state = State::of(cell);
                let of_state = STATES.iter().position(|&(known, ..)| known == state);
                series[of_state.unwrap_or(0)].points.push((x, y));
            }
        }
        series.retain(|series| !series.points.is_empty());
        let line = |limit: &dyn Fn(f64) -> Option<f64>| {
            self.x.values().into_iter().map(|x| (x, limit(x).unwrap_or(f64::NAN))).collect()
        };
        series.extend([
            Series::new(
                "spectral radius 1",
                Colour::Black,
                Style::Solid(2.0),
                line(&|x| self.edge(results, x)),
            ),
            Series::new(
                "by hand, fibres without end",
                Colour::Blue,
                Style::Dashed(1.8),
                line(&|x| Some(self.by_hand(x))),
            ),
        ]);
        Panel {
            title: self.title.clone(),
            x: self.x.axis(label, x_tick),
            y: courant.axis("Courant number", tick),
            series,
            width,
        }
    }
}

/// Maps side by side.
pub fn picture(results: &Results, maps: &[Map]) -> String {
    let panels: Vec<Panel> = maps.iter().map(|map| map.panel(results, 480.0)).collect();
    svg(&panels)
}
