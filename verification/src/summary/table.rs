//! The rows of the summary that hold strains and positions of a fibre, beside the closed forms.

use std::fmt::{self, Display, Formatter};

use crossfibre::discretisation::Properties;
use crossfibre::place::Fibre;
use crossfibre::result::FibreResult;

use super::exact::{Exact, Plateau};
use super::text::{mm, percent, relative};

/// A fibre at the end of a run.
pub struct OneFibre<'a> {
    pub fibre: Fibre,
    pub result: &'a FibreResult,
    pub properties: Properties<f64>,
    /// Time since the front entered the fibre, s; negative if it has not.
    pub since: f64,
    pub time_step: f64,
}

/// A row of the table.
#[derive(Default)]
pub struct Row {
    pub fibre: &'static str,
    pub what: &'static str,
    pub run: String,
    pub exact: String,
    pub relative: String,
    pub note: String,
}

/// The head of the table.
pub fn head() -> Row {
    let [run, exact, relative] = ["this run", "exact", "run/exact-1"].map(String::from);
    Row { run, exact, relative, ..Row::default() }
}

impl Display for Row {
    fn fmt(&self, to: &mut Formatter) -> fmt::Result {
        let Self { fibre, what, run, exact, relative, note } = self;
        let row = format!("{fibre:<10} {what:<24} {run:>9}  {exact:>10}  {relative:>11}  {note}");
        to.write_str(row.trim_end())
    }
}

impl OneFibre<'_> {
    /// The rows of the fibre.
    pub fn rows(&self, exact: &Exact) -> Vec<Row> {
        let (largest, at) = largest(&self.result.strain);
        let fibre = self.fibre.name();
        if largest == 0.0 {
            return vec![Row { fibre, what: "at rest", ..Row::default() }];
        }
        let c = self.properties.wave_speed;
        let speed = exact.front_speed.filter(|_| self.fibre == Fibre::Primary).unwrap_or(c);
        let reached = speed * self.since;
        let precursor = if speed > c * (1.0 + 1e-9) {
            "the shock's speed times t"
        } else if self.properties.courant(self.time_step) < 1.0 - 1e-9 {
            "c t; below α = 1 the scheme runs ahead of it, an element a step"
        } else {
            "c t"
        };
        let mut rows = vec![
            Row {
                fibre,
                what: "at rest beyond",
                run: self.place(self.beyond(0.0)),
                exact: if reached < self.length() { mm(reached) } else { "clamp".into() },
                note: precursor.into(),
                ..Row::default()
            },
            Row {
                what: "front",
                run: self.place(self.beyond(largest / 2.0)),
                note: "half of the largest strain: the scheme spreads fronts".into(),
                ..Row::default()
            },
        ];
        if let (Fibre::Primary, Some(kink)) = (self.fibre, exact.kink) {
            let note = if exact.kink_met {
                "U t by Smith's relation; faster since it met the reflected wave"
            } else {
                "U t by Smith's relation"
            };
            rows.push(Row { what: "kink", exact: mm(kink), note: note.into(), ..Row::default() });
        }
        let own = exact.plateaus.iter().filter(|plateau| plateau.fibre == self.fibre);
        rows.extend(own.map(|plateau| self.plateau(plateau)));
        rows.push(Row {
            what: "largest strain",
            run: percent(largest),
            note: format!("at {}", mm((at as f64 + 0.5) * self.properties.spacing)),
            ..Row::default()
        });
        rows.extend(self.slack());
        rows.extend(self.pressed());
        rows
    }

    /// Elements that are strained and carry nothing: a law of tension only.
    fn slack(&self) -> Option<Row> {
        let pairs = self.result.strain.iter().zip(&self.result.tension);
        let slack = pairs.filter(|&(&strain, &tension)| tension == 0.0 && strain != 0.0).count();
        (slack > 0).then(|| Row {
            what: "slack",
            run: slack.to_string(),
            note: format!("of {} elements", self.result.strain.len()),
            ..Row::default()
        })
    }

    /// Elements that push, by more than oscillations do.
    fn pressed(&self) -> Option<Row> {
        let tension = &self.result.tension;
        let (most, _) = largest(tension);
        let pushing = tension.iter().filter(|&&tension| tension < -0.01 * most).count();
        (pushing > 0).then(|| Row {
            what: "pressed together",
            run: pushing.to_string(),
            note: "elements, which no fibre bears: \"tension_only\" lets them go slack".into(),
            ..Row::default()
        })
    }

    fn plateau(&self, plateau: &Plateau) -> Row {
        let (what, exact) = (plateau.what, percent(plateau.strain));
        match Window::of(plateau, self.result, self.properties.spacing) {
            Some(window) => Row {
                what,
                run: percent(window.mean),
                exact,
                relative: relative(window.mean, plateau.strain),
                note: window.to_string(),
                ..Row::default()
            },
            None => {
                Row { what, exact, note: "too few elements for a mean".into(), ..Row::default() }
            }
        }
    }

    fn length(&self) -> f64 {
        self.result.strain.len() as f64 * self.properties.spacing
    }

    /// The far end of so many elements.
    fn place(&self, elements: usize) -> String {
        if elements == self.result.strain.len() {
            "clamp".into()
        } else {
            mm(elements as f64 * self.properties.spacing)
        }
    }

    /// How many elements there are up to the last one strained by more than this, either way.
    fn beyond(&self, strain: f64) -> usize {
        let last = self.result.strain.iter().rposition(|&x| x.abs() > strain);
        last.map_or(0, |last| last + 1)
    }
}

/// The largest of some numbers, and which it is.
fn largest(numbers: &[f64]) -> (f64, usize) {
    let start = (f64::NEG_INFINITY, 0);
    numbers.iter().enumerate().fold(start, |most, (i, &x)| if x > most.0 { (x, i) } else { most })
}

/// Elements below which a mean is not shown.
const FEWEST: usize = 4;

/// A mean over the middle half of a plateau. A quarter of its length at each end keeps clear of the
/// waves that bound it: their spread, the overshoot of the front, and a crossover between nodes.
struct Window {
    mean: f64,
    elements: usize,
    from: f64,
    to: f64,
}

impl Window {
    fn of(plateau: &Plateau, fibre: &FibreResult, spacing: f64) -> Option<Self> {
        let quarter = (plateau.to - plateau.from) / 4.0;
        let (from, to) = (plateau.from + quarter, plateau.to - quarter);
        let inside: Vec<_> = fibre
            .strain
            .iter()
            .enumerate()
            .filter(|(i, _)| (from..=to).contains(&((*i as f64 + 0.5) * spacing)))
            .map(|(_, &strain)| strain)
            .collect();
        (inside.len() >= FEWEST).then(|| Self {
            mean: inside.iter().sum::<f64>() / inside.len() as f64,
            elements: inside.len(),
            from,
            to,
        })
    }
}

impl Display for Window {
    fn fmt(&self, to: &mut Formatter) -> fmt::Result {
        let (from, end) = (self.from * 1e3, mm(self.to));
        write!(to, "mean of {} elements, {from:.1} to {end}", self.elements)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_is_the_middle_half() {
        let strain: Vec<_> = (0..20).map(|i| if i % 2 == 0 { 0.013 } else { 0.017 }).collect();
        let fibre = FibreResult {
            spacing: 1.7,
            position: vec![],
            velocity: vec![],
            tension: vec![],
            strain,
        };
        let plateau = |to| Plateau { what: "", fibre: Fibre::Primary, from: 0.3, to, strain: 0.0 };
        // 0.3 to 1.9 m: the middle half is 0.7 to 1.5 m, elements 7..15 of 0.1 m.
        let window = Window::of(&plateau(1.9), &fibre, 0.1).unwrap();
        assert_eq!(window.elements, 8);
        // Four of each: the mean of the two, to the rounding of eight additions.
        assert!((window.mean - 0.015).abs() < 1e-17);
        // 0.425 to 0.675 m holds three.
        assert!(Window::of(&plateau(0.8), &fibre, 0.1).is_none());
    }
}
