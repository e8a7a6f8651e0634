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
    use crossfibre::discretisation::Discretisation;

    use super::*;
    use crate::cases::support::shipped;

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
        // 0.425 to 0.675 m holds three, 0.5 to 0.9 m four.
        assert!(Window::of(&plateau(0.8), &fibre, 0.1).is_none());
        assert_eq!(Window::of(&plateau(1.1), &fibre, 0.1).unwrap().elements, 4);
    }

    /// A fibre of the paper's, at rest but for these.
    fn strained(fibre: Fibre, strain: &[f64], tension: &[f64], work: impl Fn(OneFibre<'_>)) {
        let scene = shipped("single-400");
        let mesh = Discretisation::<f64>::of(&scene);
        let result = FibreResult {
            spacing: mesh.primary.spacing,
            position: vec![],
            velocity: vec![],
            strain: strain.into(),
            tension: tension.into(),
        };
        let (properties, time_step) = (mesh.primary, mesh.time_step);
        work(OneFibre { fibre, result: &result, properties, since: 1e-6, time_step });
    }

    #[test]
    fn elements_that_push_by_more_than_a_hundredth_of_the_greatest_tension_are_counted() {
        strained(Fibre::Primary, &[], &[100.0, -0.5, -1.0, -1.5, -2.0], |fibre| {
            let row = fibre.pressed().unwrap();
            assert_eq!((row.what, row.run.as_str()), ("pressed together", "2"));
            assert!(row.note.starts_with("elements, which no fibre bears"), "{}", row.note);
        });
        strained(Fibre::Primary, &[], &[100.0, -1.0], |fibre| assert!(fibre.pressed().is_none()));
    }

    #[test]
    fn of_a_plateau_with_too_few_elements_only_the_closed_form_is_said() {
        strained(Fibre::Primary, &[0.013, 0.013], &[], |fibre| {
            let to = fibre.length();
            let plateau =
                Plateau { what: "a plateau", fibre: Fibre::Primary, from: 0.0, to, strain: 0.017 };
            let row = fibre.plateau(&plateau);
            assert_eq!((row.what, row.run.as_str()), ("a plateau", ""));
            assert_eq!(
                (row.exact.as_str(), row.note.as_str()),
                ("1.7000 %", "too few elements for a mean")
            );
        });
    }

    /// In a microsecond c t is 6.97 mm, of elements of 2 mm; a shock of the primary is faster than c.
    #[test]
    fn the_front_is_at_the_speed_of_a_shock_on_the_primary_at_c_on_the_secondary_or_at_the_clamp() {
        let beyond = |fibre: Fibre, elements: usize, faster: f64| {
            let said = std::cell::RefCell::new(None);
            strained(fibre, &vec![0.013; elements], &vec![1.0; elements], |fibre| {
                let front_speed = Some(fibre.properties.wave_speed * faster);
                let rows = fibre.rows(&Exact { front_speed, ..Exact::default() });
                said.replace(Some((rows[0].exact.clone(), rows[0].note.clone())));
            });
            said.into_inner().unwrap()
        };
        let said = |exact: &str, note: &str| (exact.to_owned(), note.to_owned());
        let shock = "the shock's speed times t";
        assert_eq!(beyond(Fibre::Primary, 7, 1.0), said("7.0 mm", "c t"));
        assert_eq!(beyond(Fibre::Primary, 7, 1.5), said("10.5 mm", shock));
        // By less than a metre a second.
        assert_eq!(beyond(Fibre::Primary, 7, 1.0 + 1e-5), said("7.0 mm", shock));
        assert_eq!(beyond(Fibre::Secondary, 7, 1.5), said("7.0 mm", "c t"));
        assert_eq!(beyond(Fibre::Primary, 3, 1.0), said("clamp", "c t"));
    }
}
