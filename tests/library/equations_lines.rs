//! The worked lines of every edition give the traced output from the traced inputs.
//!
//! The lines are text, worked out here as they are read: products before sums, equals from left to
//! right, every operation rounded. A line that says something else than the code, a symbol that a
//! trace leaves out or another order of operations shows in the last bit.

use std::collections::{BTreeMap, BTreeSet};

use crate::common::{
    Inputs, Recorder, Seen, cases, evaluate, short_scenes, trace, with_corrections,
};
use crossfibre::corrected::{Corrected, Engineering, Incremental, StrainMeasure};
use crossfibre::equations::{EQUATIONS, Line, SYMBOLS, TENSION_BY_LAW};
use crossfibre::errata::{Corrections, Erratum};
use crossfibre::number::Number;
use crossfibre::paper::{Paper, Printed};
use crossfibre::result::{WithPaper, with_paper};
use crossfibre::trace::Traced;
use proptest::array::uniform16;
use proptest::prelude::*;

/// The known numbers by name: one component, or as many as the vector has.
type Values = BTreeMap<String, Vec<f64>>;

type Function = fn(f64) -> f64;

/// An expression half read, and the values of the component that is worked out.
struct Reader<'a> {
    rest: &'a str,
    values: &'a Values,
    component: usize,
}

impl Reader<'_> {
    fn take(&mut self, token: &str) -> bool {
        let rest = self.rest.trim_start();
        let taken = rest.strip_prefix(token);
        self.rest = taken.unwrap_or(rest);
        taken.is_some()
    }

    fn sum(&mut self) -> f64 {
        let mut sum = self.product();
        loop {
            if self.take("+") {
                sum += self.product();
            } else if self.take("-") {
                sum -= self.product();
            } else {
                return sum;
            }
        }
    }

    fn product(&mut self) -> f64 {
        let mut product = self.factor();
        loop {
            if self.take("*") {
                product *= self.factor();
            } else if self.take("/") {
                product /= self.factor();
            } else {
                return product;
            }
        }
    }

    fn factor(&mut self) -> f64 {
        if self.take("-") {
            return -self.factor();
        }
        let functions: [(&str, Function); 5] = [
            ("sqrt(", Number::sqrt),
            ("atan(", Number::atan),
            ("cos(", Number::cos),
            ("sin(", Number::sin),
            ("(", |x| x),
        ];
        for (name, function) in functions {
            if self.take(name) {
                let x = self.sum();
                assert!(self.take(")"), "unclosed before {:?}", self.rest);
                return function(x);
            }
        }
        if self.take("|{") {
            let vector = &self.values[self.until("}|")];
            // "|d|": the root of the sum of the squares, in the order of the components.
            return vector.iter().map(|c| c * c).reduce(|a, b| a + b).unwrap().sqrt();
        }
        if self.take("{") {
            let name = self.until("}");
            let value = self.values.get(name).unwrap_or_else(|| panic!("no value of {name}"));
            return value[self.component.min(value.len() - 1)];
        }
        let digits = self.rest.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.');
        let number = &self.rest[..self.rest.len() - digits.len()];
        self.rest = digits;
        number.parse().unwrap_or_else(|_| panic!("no number before {digits:?}"))
    }
}

impl<'a> Reader<'a> {
    fn until(&mut self, end: &str) -> &'a str {
        let (name, rest) = self.rest.split_once(end).unwrap();
        self.rest = rest;
        name
    }
}

/// An expression holds for each component; a number serves all of them, and `|{d}|` is one number.
fn evaluated(expression: &str, values: &Values) -> Vec<f64> {
    let names = expression.split('{').skip(1).map(|rest| rest.split_once('}').unwrap().0);
    let vectors = names.filter_map(|name| values.get(name)).map(Vec::len);
    let components = if expression.starts_with('|') { 1 } else { vectors.max().unwrap_or(1) };
    let component = |component| {
        let mut reader = Reader { rest: expression, values, component };
        let value = reader.sum();
        assert!(reader.rest.trim().is_empty(), "left over: {:?}", reader.rest);
        value
    };
    (0..components).map(component).collect()
}

#[test]
fn expressions_are_worked_out_as_they_are_read() {
    let values = Values::from([("a".into(), vec![0.7]), ("d".into(), vec![1.5, -2.0, 6.0])]);
    let one = |expression| evaluated(expression, &values);
    // (0.7 + 0.1) − 0.3 and 0.7 + (0.1 − 0.3) differ in the last bit, as do (0.7/3)·7 and 0.7/(3·7).
    assert_eq!(one("{a} + 0.1 - 0.3"), [(0.7 + 0.1) - 0.3]);
    assert_ne!(one("{a} + 0.1 - 0.3"), [0.7 + (0.1 - 0.3)]);
    assert_eq!(one("{a} / 3 * 7"), [(0.7 / 3.0) * 7.0]);
    assert_eq!(one("-{a} * (2 - 5)"), [2.0999999999999996]);
    assert_eq!(one("|{d}|"), [6.5]);
    assert_eq!(one("{d} * {a} - 4"), [1.5 * 0.7 - 4.0, -2.0 * 0.7 - 4.0, 6.0 * 0.7 - 4.0]);
    assert_eq!(one("sqrt({a})"), [0.7_f64.sqrt()]);
}

/// The lines of all equations of an edition.
struct Lines(BTreeMap<u8, Vec<Line>>);

impl Lines {
    fn of(paper: &impl Paper<f64>) -> Self {
        Self(EQUATIONS.iter().map(|e| (e.number, paper.lines(e))).collect())
    }

    /// What the lines of the event's equation make of its inputs.
    fn work_out(&self, event: &Seen) -> Vec<f64> {
        let inputs = event.inputs.iter();
        let mut values: Values = inputs.map(|(name, v)| ((*name).into(), v.clone())).collect();
        let by_law = event.inputs.iter().any(|(name, _)| *name == "stress");
        let lines = if by_law { &vec![TENSION_BY_LAW] } else { &self.0[&event.equation] };
        for line in lines {
            values.insert(line.name.into(), evaluated(line.expression, &values));
        }
        // (11) gives a direction, its last two lines.
        let outputs = if event.equation == 11 { 2 } else { 1 };
        let last = &lines[lines.len() - outputs..];
        last.iter().flat_map(|line| values[line.name].clone()).collect()
    }
}

/// Asserts that the lines give the output to the bit: they are the code's own operations in the
/// code's own order, and each is rounded alike everywhere.
#[track_caller]
fn assert_reproduced(lines: &Lines, event: &Seen, what: &str) {
    let worked = lines.work_out(event);
    let same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
    assert!(
        worked.len() == event.output.len() && worked.iter().zip(&event.output).all(same),
        "{what}: the lines give {worked:?} for {event:?}"
    );
}

/// Printed, corrected, each correction alone, and each left out.
fn editions() -> Vec<(String, Corrections)> {
    let mut editions =
        vec![("none".to_string(), Corrections::NONE), ("all".to_string(), Corrections::ALL)];
    for &erratum in Erratum::ALL {
        let id = erratum.entry().id;
        editions.push((id.into(), Corrections::NONE.with(erratum)));
        editions.push((format!("all but {id}"), Corrections::ALL.without(erratum)));
    }
    editions
}

fn traced_evaluations(paper: &impl Paper<f64>, r: &Inputs) -> Vec<Seen> {
    let traced = Traced::new(paper, Recorder::default());
    evaluate(&traced, r);
    traced.into_sink().0
}

fn check_edition<M: StrainMeasure>(name: &str, corrections: Corrections, inputs: &[Inputs]) {
    let paper = Corrected::<M>::new(corrections);
    let lines = Lines::of(&paper);
    let mut seen = BTreeSet::new();
    for r in inputs {
        for event in traced_evaluations(&paper, r) {
            seen.insert(event.equation);
            assert_reproduced(&lines, &event, name);
        }
    }
    assert_eq!(seen, (1..=20).collect(), "every equation has been worked out");
}

proptest! {
    #![proptest_config(cases(32))]
    #[test]
    fn the_lines_of_every_edition_reproduce_every_equation_on_any_numbers(
        inputs in proptest::collection::vec(
            uniform16(prop_oneof![-9.7_f64..-0.013, 0.013_f64..9.7]), 4,
        )
    ) {
        for (name, corrections) in editions() {
            check_edition::<Incremental>(&name, corrections, &inputs);
            check_edition::<Engineering>(&name, corrections, &inputs);
        }
    }
}

#[test]
fn the_lines_of_the_page_are_those_of_the_register() {
    let r = std::array::from_fn(|i| 0.371 + 0.617 * i as f64);
    let lines = Lines::of(&Printed);
    for event in traced_evaluations(&Printed, &r) {
        assert_reproduced(&lines, &event, "printed");
    }
    for equation in EQUATIONS {
        assert_eq!(Paper::<f64>::lines(&Printed, equation), equation.lines);
    }
}

#[test]
fn the_lines_reproduce_what_a_march_evaluates() {
    struct LinesOf;
    impl WithPaper<f64> for LinesOf {
        type Out = Lines;
        fn with(self, paper: &impl Paper<f64>) -> Lines {
            Lines::of(paper)
        }
    }
    for (name, scene) in short_scenes() {
        let mut worked = BTreeMap::<u8, usize>::new();
        // The last steps, in which everything is in motion.
        let events = trace(&scene).2;
        let last = events.last().unwrap().place.step;
        let lines = with_paper(&scene, LinesOf);
        for event in events.iter().filter(|e| e.place.step + 3 > last) {
            assert_reproduced(&lines, event, &name);
            *worked.entry(event.equation).or_default() += 1;
        }
        assert!(worked.len() >= 4, "{name}: {worked:?}");
    }
    // And with each correction alone, where the equations of the crossover and the projectile run.
    let (name, scene) = short_scenes().swap_remove(5);
    for (edition, corrections) in editions() {
        let scene = with_corrections(&scene, corrections);
        let lines = with_paper(&scene, LinesOf);
        let events = trace(&scene).2;
        let seldom = events.iter().filter(|e| e.equation >= 8);
        for event in seldom.chain(events.iter().rev().take(997)) {
            assert_reproduced(&lines, event, &format!("{name}, {edition}"));
        }
    }
}

#[test]
fn every_name_of_a_trace_and_of_a_line_is_in_the_table_of_symbols() {
    let r = std::array::from_fn(|i| 0.371 + 0.617 * i as f64);
    let known = |name: &str| SYMBOLS.iter().any(|symbol| symbol.name == name);
    let mut used = BTreeSet::new();
    for (edition, corrections) in editions() {
        for paper in [true, false] {
            let (lines, events) = if paper {
                let paper = Corrected::<Incremental>::new(corrections);
                (Lines::of(&paper), traced_evaluations(&paper, &r))
            } else {
                let paper = Corrected::<Engineering>::new(corrections);
                (Lines::of(&paper), traced_evaluations(&paper, &r))
            };
            let inputs = events.iter().flat_map(|e| e.inputs.iter().map(|(name, _)| *name));
            let outputs = lines.0.values().flatten().map(|line| line.name);
            for name in inputs.chain(outputs) {
                assert!(known(name), "{edition}: {name}");
                used.insert(name);
            }
        }
    }
    let unused: Vec<_> = SYMBOLS.iter().filter(|s| !used.contains(s.name)).collect();
    assert!(unused.is_empty(), "{unused:?}");
}
