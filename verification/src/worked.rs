//! Evaluations as someone would check them by hand: the equation as printed, what the ledger does to
//! it, every number that goes in, and each line with its numbers put in.

mod evaluate;

use std::io::{self, Write};

use crossfibre::equations::{EQUATIONS, Line, SYMBOLS, TENSION_BY_LAW, equation};
use crossfibre::errata::{Erratum, Kind};
use crossfibre::paper::Paper;
use crossfibre::place::Place;
use crossfibre::scene::{Scene, Strain};
use crossfibre::trace::{Event, Sink, Value};
use crossfibre::trace_file::Filter;

use crate::bits::ulps;
use evaluate::{AXES, Known, Quantity, Step, work_out};

/// Writes the kept events worked by hand, counts them and those that do not come out the same.
pub struct Worked<'a, W> {
    out: W,
    scene: &'a Scene,
    filter: Filter,
    /// The lines of the edition, by equation from (1).
    lines: Vec<Vec<Line>>,
    tally: Tally,
    failure: Option<io::Error>,
}

/// What has been worked out.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    /// Evaluations.
    pub events: u64,
    /// Of these, those whose output the lines do not give, although they hold nothing but
    /// + − × ÷ √, which leave no choice.
    pub wrong: u64,
}

impl<'a, W: Write> Worked<'a, W> {
    /// To write to `out` what `filter` keeps of a march of `paper`.
    pub fn new(out: W, scene: &'a Scene, paper: &impl Paper<f64>, filter: Filter) -> Self {
        let lines = EQUATIONS.iter().map(|equation| paper.lines(equation)).collect();
        Self { out, scene, filter, lines, tally: Tally::default(), failure: None }
    }

    /// The tally, or the first failure to write.
    pub fn finish(mut self) -> io::Result<Tally> {
        self.failure.map_or(Ok(()), Err)?;
        self.out.flush()?;
        Ok(self.tally)
    }

    fn write(&mut self, event: &Event<'_, f64>) -> io::Result<()> {
        if self.tally.events > 0 {
            writeln!(self.out)?;
        }
        self.tally.events += 1;
        let Place { step, fibre, index } = event.place;
        let what = if matches!(event.equation, 4..=7) { "element" } else { "node" };
        let Some(known_equation) = equation(event.equation) else {
            return Ok(());
        };
        let (number, name) = (event.equation, known_equation.name);
        writeln!(self.out, "step {step}, {}, {what} {index}: ({number}) {name}\n", fibre.name())?;
        writeln!(self.out, "  printed     {}", known_equation.printed)?;
        for note in ledger(self.scene, number) {
            writeln!(self.out, "  {note}")?;
        }
        writeln!(self.out)?;

        let mut known: Known = event.inputs.iter().map(|(name, v)| (*name, quantity(v))).collect();
        for (name, value) in event.inputs {
            write_input(&mut self.out, name, value)?;
        }
        if !event.inputs.is_empty() {
            writeln!(self.out)?;
        }

        let by_law = event.inputs.iter().any(|(name, _)| *name == "stress");
        let lines: &[Line] =
            if by_law { &[TENSION_BY_LAW] } else { &self.lines[usize::from(number) - 1] };
        let mut steps = Vec::new();
        for (i, line) in lines.iter().enumerate() {
            let of_line = work_out(line, &mut known).map_err(io::Error::other)?;
            write_line(&mut self.out, line, &of_line, i + 1 == lines.len())?;
            steps.extend(of_line);
        }

        let traced = components(&event.output);
        let by_hand = &steps[steps.len().saturating_sub(traced.len())..];
        let functions = lines.iter().any(|line| {
            ["sin(", "cos(", "atan("].iter().any(|function| line.expression.contains(function))
        });
        let verdict = Verdict::of(&traced, by_hand, functions);
        self.tally.wrong += u64::from(verdict == Verdict::Wrong);
        let traced = match event.output {
            Value::Scalar(x) => format!("{x:?}"),
            Value::Vector(v) => format!("{v:?}"),
        };
        writeln!(self.out, "  traced      {traced}: {}", verdict.words(&event.output, by_hand))
    }
}

impl<W: Write> Sink<f64> for Worked<'_, W> {
    fn event(&mut self, event: &Event<'_, f64>) {
        if self.failure.is_none() && self.filter.keeps(event.place, event.equation) {
            self.failure = self.write(event).err();
        }
    }
}

/// What the ledger does to an equation in this scene, a line each.
fn ledger(scene: &Scene, number: u8) -> Vec<String> {
    let mut notes = Vec::new();
    if number == 4 && scene.strain == Strain::Engineering {
        notes.push("measure     engineering strain in place of (4): not the paper's".into());
    }
    for erratum in Erratum::ALL {
        let entry = erratum.entry();
        if !entry.equations.contains(&number) {
            continue;
        }
        let (word, text) = match entry.kind {
            Kind::Erratum if !erratum.changes_a_run() => ("note", entry.used),
            Kind::Erratum if scene.corrections.has(*erratum) => ("corrected", entry.used),
            Kind::Erratum => ("uncorrected", entry.trouble),
            Kind::Reading => ("reading", entry.used),
            Kind::Report => ("note", entry.trouble),
        };
        notes.push(format!("{word:<11} {}: {text}", entry.id));
    }
    notes
}

/// A symbol, its number, unit and meaning; each component of a vector by itself.
fn write_input(out: &mut impl Write, name: &str, value: &Value<'_, f64>) -> io::Result<()> {
    let (meaning, unit) = meaning(name);
    match value {
        Value::Scalar(x) => write_number(out, &format!("{name:<13}"), *x, unit, meaning),
        Value::Vector(v) if name == "memory" => v.iter().enumerate().try_for_each(|(i, &x)| {
            let name = format!("{name}[{i}]");
            write_number(out, &format!("{name:<13}"), x, unit, if i == 0 { meaning } else { "" })
        }),
        Value::Vector(v) => v.iter().zip(AXES).try_for_each(|(&x, axis)| {
            let name = format!("{name}_{axis}");
            write_number(
                out,
                &format!("{name:<13}"),
                x,
                unit,
                if axis == "x" { meaning } else { "" },
            )
        }),
    }
}

fn write_number(
    out: &mut impl Write,
    name: &str,
    x: f64,
    unit: &str,
    meaning: &str,
) -> io::Result<()> {
    let number = format!("{x:?} {unit}");
    let row = format!("  {name} = {:<28}  {meaning}", number.trim_end());
    writeln!(out, "{}", row.trim_end())
}

/// A line: in symbols, with its numbers put in, and what it gives.
fn write_line(out: &mut impl Write, line: &Line, steps: &[Step], last: bool) -> io::Result<()> {
    let symbols = line.expression.replace(['{', '}'], "");
    let (meaning, unit) = meaning(line.name);
    let meaning = if last { "" } else { meaning };
    let is_vector = steps.len() > 1;
    if is_vector {
        writeln!(out, "  {} = {symbols}", line.name)?;
    }
    for step in steps {
        let blank = " ".repeat(step.name.len());
        if is_vector {
            writeln!(out, "  {} = {}", step.name, step.numbers)?;
        } else {
            writeln!(out, "  {} = {symbols}", step.name)?;
            writeln!(out, "  {blank} = {}", step.numbers)?;
        }
        write_number(out, &blank, step.value, unit, meaning)?;
    }
    writeln!(out)
}

/// Meaning and unit of a symbol; a pure number has none.
fn meaning(name: &str) -> (&'static str, &'static str) {
    let symbol = SYMBOLS.iter().find(|symbol| symbol.name == name);
    let (meaning, unit) = symbol.map_or(("", ""), |symbol| (symbol.meaning, symbol.unit));
    (meaning, if unit == "1" { "" } else { unit })
}

fn quantity(value: &Value<'_, f64>) -> Quantity {
    match value {
        Value::Scalar(x) => Quantity::Scalar(*x),
        Value::Vector(v) => Quantity::Vector(v.to_vec()),
    }
}

fn components(value: &Value<'_, f64>) -> Vec<f64> {
    match value {
        Value::Scalar(x) => vec![*x],
        Value::Vector(v) => v.to_vec(),
    }
}

/// Whether the lines give what was traced.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Verdict {
    Same,
    /// They differ, and a function that machines round differently is among the lines.
    Functions,
    Wrong,
}

impl Verdict {
    fn of(traced: &[f64], by_hand: &[Step], functions: bool) -> Self {
        let same = |x: f64, step: &Step| {
            x.to_bits() == step.value.to_bits() || x.is_nan() && step.value.is_nan()
        };
        if traced.len() == by_hand.len()
            && traced.iter().zip(by_hand).all(|(x, step)| same(*x, step))
        {
            Self::Same
        } else if functions {
            Self::Functions
        } else {
            Self::Wrong
        }
    }

    fn words(self, traced: &Value<'_, f64>, by_hand: &[Step]) -> String {
        let apart =
            || components(traced).iter().zip(by_hand).map(|(x, step)| ulps(*x, step.value)).max();
        match self {
            Self::Same => "the same to the last bit".into(),
            Self::Functions => format!(
                "{} units in the last place apart (sin, cos and tan⁻¹ of this machine are not \
                 those of the reference)",
                apart().unwrap_or_default()
            ),
            Self::Wrong => format!(
                "NOT THE SAME, {} units in the last place apart: a fault of this program",
                apart().unwrap_or_default()
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use crossfibre::corrected::{Corrected, Incremental};
    use crossfibre::errata::Corrections;
    use crossfibre::place::Fibre;

    use super::*;
    use crate::cases::support::shipped;

    #[test]
    fn a_value_that_the_lines_do_not_give_is_wrong() {
        let step = |value| Step { name: "u".into(), numbers: String::new(), value };
        assert_eq!(Verdict::of(&[0.3], &[step(0.3)], false), Verdict::Same);
        assert_eq!(Verdict::of(&[0.3], &[step(0.1 + 0.2)], false), Verdict::Wrong);
        assert_eq!(Verdict::of(&[0.3], &[step(0.1 + 0.2)], true), Verdict::Functions);
        assert_eq!(Verdict::of(&[f64::NAN], &[step(f64::NAN)], false), Verdict::Same);
        assert_eq!(Verdict::of(&[0.3, 0.7], &[step(0.3)], false), Verdict::Wrong);
    }

    /// No number is one whatever its bits, and nothing else is.
    #[test]
    fn what_is_no_number_is_the_same_as_what_is_none() {
        let verdict = |traced, value| {
            Verdict::of(
                &[traced],
                &[Step { name: "u".into(), numbers: String::new(), value }],
                false,
            )
        };
        assert_eq!(verdict(f64::NAN, -f64::NAN), Verdict::Same);
        assert_eq!(verdict(0.3, f64::NAN), Verdict::Wrong);
        assert_eq!(verdict(f64::NAN, 0.3), Verdict::Wrong);
    }

    /// (7) of 0.25 in a fibre of 16 N: 4 N, and not 5.
    fn of_7<W: Write>(worked: &mut Worked<'_, W>, tension: f64) {
        worked.event(&Event {
            place: Place { step: 3, fibre: Fibre::Primary, index: 1 },
            equation: 7,
            inputs: &[("E", Value::Scalar(16.0)), ("strain", Value::Scalar(0.25))],
            output: Value::Scalar(tension),
        });
    }

    fn corrected() -> Corrected<Incremental> {
        Corrected::new(Corrections::ALL)
    }

    #[test]
    fn evaluations_and_those_that_are_wrong_are_counted() {
        let scene = shipped("single-400");
        let mut text = Vec::new();
        let mut worked = Worked::new(&mut text, &scene, &corrected(), Filter::default());
        for tension in [4.0, 5.0, 4.0, 5.0] {
            of_7(&mut worked, tension);
        }
        let tally = worked.finish().unwrap();
        assert_eq!((tally.events, tally.wrong), (4, 2));
        let text = String::from_utf8(text).unwrap();
        assert_eq!(text.matches("traced      4.0: the same to the last bit").count(), 2);
        assert_eq!(text.matches("traced      5.0: NOT THE SAME, ").count(), 2);
    }

    /// Takes nothing, and counts how often it is asked.
    struct Full(u32);

    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            self.0 += 1;
            Err(io::ErrorKind::StorageFull.into())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn nothing_is_written_after_what_could_not_be() {
        let scene = shipped("single-400");
        let mut full = Full(0);
        let mut worked = Worked::new(&mut full, &scene, &corrected(), Filter::default());
        for tension in [4.0, 4.0] {
            of_7(&mut worked, tension);
        }
        assert_eq!(worked.finish().unwrap_err().kind(), io::ErrorKind::StorageFull);
        assert_eq!(full.0, 1);
    }
}
