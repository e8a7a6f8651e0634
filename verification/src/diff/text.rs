//! A comparison for people.

use std::fmt::{self, Display, Formatter};

use serde::Serialize;

use super::record::{EquationTally, FirstDifference, Located, Record};
use super::verdict::MANY;
use crate::trace_line::{Number, Value};

/// Displays as the report.
pub struct Report<'a>(pub &'a Record);

impl Display for Report<'_> {
    fn fmt(&self, to: &mut Formatter) -> fmt::Result {
        let Record { a, b, header, verdict, notes, agree_before, .. } = self.0;
        writeln!(to, "A  {a}\nB  {b}")?;
        for field in &header.scene {
            writeln!(to, "warning: the scenes differ: {}: {} / {}", field.path, field.a, field.b)?;
        }
        if !header.equations.is_empty() {
            let list: Vec<_> = header.equations.iter().map(|e| format!("({e})")).collect();
            writeln!(to, "warning: the editions differ: other lines of {}", list.join(", "))?;
        }
        writeln!(to, "\n{verdict}")?;
        for note in notes {
            writeln!(to, "  {note}")?;
        }
        if let Some(first) = &self.0.first_difference {
            self.before(to, *agree_before)?;
            difference(to, first)?;
        }
        self.table(to)
    }
}

impl Report<'_> {
    fn before(&self, to: &mut Formatter, events: u64) -> fmt::Result {
        match &self.0.last_agreeing {
            None => writeln!(to, "\nNo event before it."),
            Some(last) => writeln!(
                to,
                "\n{} before it, the last: {} (line {} of A, {} of B)",
                if events == 1 {
                    "1 event agrees".into()
                } else {
                    format!("{events} events agree")
                },
                last.evaluation,
                last.line_a,
                last.line_b,
            ),
        }
    }

    fn table(&self, to: &mut Formatter) -> fmt::Result {
        let Record { equations, to_the_end, .. } = self.0;
        let until = if *to_the_end { "" } else { " (read to the first difference)" };
        writeln!(
            to,
            "\neqn    events  differing  only in A  only in B  worst ULP  worst relative  where{until}"
        )?;
        for EquationTally { eq, events, differing, only_in_a, only_in_b, worst, .. } in equations {
            write!(
                to,
                "{:>4} {events:>8} {differing:>10} {only_in_a:>10} {only_in_b:>10}",
                format!("({eq})")
            )?;
            match worst {
                None => writeln!(to)?,
                Some(worst) => writeln!(
                    to,
                    " {:>10} {:>15}  step {}, {} {}, {}",
                    ulp(worst.ulp),
                    relative(Some(worst.relative)),
                    worst.evaluation.step,
                    worst.evaluation.fibre.name(),
                    worst.evaluation.index,
                    worst.name,
                )?,
            }
        }
        Ok(())
    }
}

/// What differs, and both events.
fn difference(to: &mut Formatter, first: &FirstDifference) -> fmt::Result {
    let FirstDifference { a, b, quantities, .. } = first;
    for of in quantities {
        let text = |value: &Option<Value>| value.as_ref().map_or("–".into(), json);
        let within = if of.agrees { ", within the tolerance" } else { "" };
        writeln!(
            to,
            "  {}: {} ULP, {} relative{within}",
            of.name,
            ulp(of.ulp),
            relative(of.relative)
        )?;
        writeln!(to, "    A {}\n    B {}", text(&of.a), text(&of.b))?;
    }
    for (name, of) in [("A", a), ("B", b)] {
        match of {
            Some(Located { line, event }) => writeln!(to, "{name}, line {line}: {}", json(event))?,
            None => writeln!(to, "{name}: at its end")?,
        }
    }
    Ok(())
}

fn json(of: &impl Serialize) -> String {
    serde_json::to_string(of).unwrap_or_default()
}

fn ulp(of: Option<u64>) -> String {
    match of {
        None => "–".into(),
        Some(ulp) if ulp > MANY => format!("{:.1e}", ulp as f64),
        Some(ulp) => ulp.to_string(),
    }
}

fn relative(of: Option<Number>) -> String {
    match of {
        Some(Number::Finite(relative)) => format!("{relative:.2e}"),
        Some(_) => "inf".into(),
        None => "–".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace_line::NotFinite;

    #[test]
    fn a_million_ulps_are_written_out_and_more_are_about_so_many() {
        let written = [None, Some(7), Some(1_000_000), Some(1_000_001)].map(ulp);
        assert_eq!(written, ["–", "7", "1000000", "1.0e6"]);
    }

    #[test]
    fn a_relative_distance_is_a_number_or_infinite_or_none() {
        let written = [Some(Number::Finite(0.0123)), None].map(relative);
        assert_eq!(written, ["1.23e-2", "–"]);
        assert_eq!(relative(Some(Number::Other(NotFinite::Infinity))), "inf");
    }
}
