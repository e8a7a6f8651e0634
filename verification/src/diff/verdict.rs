//! What came of a comparison, in a sentence; and where to look further.

use super::header::HeaderDifference;
use super::origin::{Origin, origin};
use super::record::{Evaluation, FirstDifference, Kind, QuantityDifference};
use crate::trace_line::Number;

/// ULPs beyond which a relative distance says more.
pub const MANY: u64 = 1_000_000;

/// Nothing differs.
pub fn agreement(events: u64, within_tolerance: u64) -> String {
    let s = if events == 1 { "" } else { "s" };
    match within_tolerance {
        0 => format!("the traces agree: {events} event{s}, to the last bit"),
        n => format!(
            "the traces agree within the tolerance: {events} event{s}, {n} of them not to the last bit"
        ),
    }
}

/// The first difference, and where the fault lies.
pub fn first(first: &FirstDifference, header: &HeaderDifference) -> String {
    let FirstDifference { kind, evaluation, a, b, quantities } = first;
    let eq = &evaluation.eq;
    let is_output = |q: &&QuantityDifference| q.name == "out";
    let said = match kind {
        Kind::Output => {
            let output = quantities.iter().find(is_output).map(distance).unwrap_or_default();
            let inputs: Vec<_> = quantities.iter().filter(|q| !is_output(q)).collect();
            if inputs.is_empty() {
                let other_lines = header.equations.iter().any(|number| number.to_string() == *eq);
                let edition = if other_lines { ", where the editions differ" } else { "" };
                format!("{evaluation}, {output}, inputs equal: the fault is in ({eq}){edition}")
            } else {
                format!(
                    "{evaluation}, {output}, inputs equal only within the tolerance ({}): \
                     the fault is in ({eq}), or has grown from before it",
                    listed(&inputs)
                )
            }
        }
        Kind::Inputs => {
            let inputs: Vec<_> = quantities.iter().filter(|q| !is_output(q) && !q.agrees).collect();
            format!(
                "{evaluation}, inputs already differ ({}): the fault is before ({eq})",
                listed(&inputs)
            )
        }
        Kind::Quantities => {
            let named = |of: fn(&QuantityDifference) -> bool, what: &str| {
                let names: Vec<_> =
                    quantities.iter().filter(|q| of(q)).map(|q| q.name.as_str()).collect();
                (!names.is_empty()).then(|| format!("{what} {}", names.join(", ")))
            };
            let kinds = [
                named(|q| q.b.is_none(), "only A has"),
                named(|q| q.a.is_none(), "only B has"),
                named(
                    |q| q.a.is_some() && q.b.is_some() && q.relative.is_none(),
                    "not of one dimension:",
                ),
            ];
            let kinds: Vec<_> = kinds.into_iter().flatten().collect();
            format!(
                "{evaluation}, not the same quantities ({}): the scenes or the editions differ",
                kinds.join("; ")
            )
        }
        Kind::OnlyInA | Kind::OnlyInB => {
            let (lacks, next) = if *kind == Kind::OnlyInA { ("B", b) } else { ("A", a) };
            let next = next.as_ref().map(|next| Evaluation::from(&next.event).to_string());
            format!(
                "{lacks} has no eqn ({eq}) at {}: what it has next is {}",
                evaluation.place(),
                next.unwrap_or_default(),
            )
        }
        Kind::AEnds | Kind::BEnds => {
            let (ended, other) = if *kind == Kind::AEnds { ("A", "B") } else { ("B", "A") };
            format!("{ended} ends; {other} goes on with {evaluation}")
        }
    };
    format!("first difference: {said}")
}

fn listed(quantities: &[&QuantityDifference]) -> String {
    let each: Vec<_> = quantities.iter().map(|q| format!("{}, {}", q.name, distance(q))).collect();
    each.join("; ")
}

/// How far apart, in the measure that says most.
fn distance(of: &QuantityDifference) -> String {
    match (of.ulp, of.relative) {
        (_, Some(Number::Other(_))) => "not finite in one".into(),
        (Some(0), Some(Number::Finite(0.0))) => "the sign of zero".into(),
        (Some(ulp @ 1..=MANY), _) => format!("{ulp} ULP"),
        (_, Some(Number::Finite(relative))) => format!("{relative:.1e} relative"),
        _ => "in kind".into(),
    }
}

/// Where the inputs come from that differ; `traced` tells of which equations there were events
/// before, which all agree.
pub fn notes(
    kind: Kind,
    quantities: &[QuantityDifference],
    traced: impl Fn(u8) -> bool,
    scenes_differ: bool,
) -> Vec<String> {
    if !matches!(kind, Kind::Inputs | Kind::Output) {
        return vec![];
    }
    let beyond = |q: &&QuantityDifference| !q.agrees || kind == Kind::Output;
    let inputs = quantities.iter().filter(|q| q.name != "out").filter(beyond);
    let mut origins: Vec<(Origin, Vec<&str>)> = Vec::new();
    for (origin, name) in inputs.filter_map(|q| Some((origin(&q.name)?, q.name.as_str()))) {
        match origins.iter_mut().find(|(of, _)| *of == origin) {
            Some((_, names)) => names.push(name),
            None => origins.push((origin, vec![name])),
        }
    }
    let note = |(Origin { what, equations }, names): (Origin, Vec<&str>)| {
        let names = names.join(", ");
        let list = |of: &[u8]| {
            of.iter().map(|equation| format!("({equation})")).collect::<Vec<_>>().join(", ")
        };
        let before: Vec<u8> = equations.iter().copied().filter(|&e| traced(e)).collect();
        let more = match (equations, &before[..]) {
            ([], _) if scenes_differ => "; the scenes differ".into(),
            ([], _) => String::new(),
            (_, []) => format!("; nothing traced before this gives it: see {}", list(equations)),
            (_, [one]) => format!("; ({one}) agrees wherever it is traced before this"),
            (_, many) => format!("; {} agree wherever they are traced before this", list(many)),
        };
        format!("{names}: {what}{more}")
    };
    origins.into_iter().map(note).collect()
}
