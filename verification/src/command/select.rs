//! Which evaluations a trace keeps, and why a choice can come to nothing.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::str::FromStr;

use anyhow::{Result, bail};
use crossfibre::place::{Fibre, Place};
use crossfibre::plan::Plan;
use crossfibre::trace_file::Filter;

/// The choice, as arguments.
#[derive(clap::Args)]
pub struct Choice {
    /// Only these steps, from 1, both ends included
    #[arg(long, value_name = "N|A..B", value_parser = range::<u64>)]
    step: Option<RangeInclusive<u64>>,
    /// Only these nodes or elements, from 0 at the impact point (the crossover), both ends included
    #[arg(long, alias = "node", value_name = "N|A..B", value_parser = range::<usize>)]
    index: Option<RangeInclusive<usize>>,
    /// Only this fibre: primary or secondary
    #[arg(long, value_parser = fibre)]
    fibre: Option<Fibre>,
    /// Only these equations, such as 4,6,17
    #[arg(long, value_name = "EQUATIONS", value_delimiter = ',', value_parser = equation)]
    eq: Vec<u8>,
}

impl From<Choice> for Filter {
    fn from(choice: Choice) -> Self {
        let Choice { step, index, fibre, eq } = choice;
        Self { steps: step, indices: index, fibre, equations: eq }
    }
}

/// `n`, or `a..b` with both ends.
fn range<N: FromStr + PartialOrd + Copy>(text: &str) -> Result<RangeInclusive<N>, String> {
    let number = |text: &str| {
        text.trim().parse::<N>().map_err(|_| format!("`{text}` is not a whole number from 0 up"))
    };
    let (from, to) = match text.split_once("..") {
        Some((from, to)) => (number(from)?, number(to)?),
        None => (number(text)?, number(text)?),
    };
    if from > to {
        return Err("it ends before it begins".into());
    }
    Ok(from..=to)
}

/// The number of an equation of the page.
fn equation(text: &str) -> Result<u8, String> {
    match text.trim().trim_matches(['(', ')']).parse() {
        Ok(number @ 1..=20) => Ok(number),
        _ => Err("the paper has (1)–(20)".into()),
    }
}

/// A fibre by its name.
fn fibre(text: &str) -> Result<Fibre, String> {
    [Fibre::Primary, Fibre::Secondary]
        .into_iter()
        .find(|fibre| fibre.name() == text)
        .ok_or_else(|| "it is `primary` or `secondary`".into())
}

/// An error if the plan shows that nothing will match.
pub fn check(filter: &Filter, plan: &Plan) -> Result<()> {
    if let Some(steps) = &filter.steps {
        if *steps.end() == 0 {
            bail!("step 0: steps count from 1");
        }
        if *steps.start() > plan.steps {
            bail!("step {} is beyond the run's {} steps", steps.start(), plan.steps);
        }
    }
    if let Some(fibre) = filter.fibre
        && !plan.fibres.iter().any(|of| of.fibre == fibre)
    {
        bail!("this scene has no {} fibre", fibre.name());
    }
    let fibres =
        || plan.fibres.iter().filter(|of| filter.fibre.is_none_or(|fibre| fibre == of.fibre));
    if let Some(indices) = &filter.indices
        && let Some(longest) = fibres().map(|of| of.elements).max()
        && *indices.start() > longest
    {
        bail!("index {} is beyond the last node, {longest}", indices.start());
    }
    let chosen = || plan.equations.iter().filter(|e| filter.equations.contains(&e.equation));
    if chosen().count() > 0 && !chosen().any(|e| e.runs) {
        let reasons: Vec<_> = chosen()
            .map(|e| format!("eqn ({}) does not run in this scene: {}", e.equation, e.why))
            .collect();
        bail!("{}", reasons.join("\n       "));
    }
    Ok(())
}

/// Where the chosen equations were evaluated, kept or not: the answer to "why is there nothing?"
#[derive(Debug, Default)]
pub struct Seen(BTreeMap<(u8, &'static str), Span>);

#[derive(Debug, PartialEq)]
struct Span {
    steps: (u64, u64),
    indices: (usize, usize),
}

impl Seen {
    /// An equation has been evaluated.
    pub fn note(&mut self, filter: &Filter, place: Place, equation: u8) {
        if !(filter.equations.is_empty() || filter.equations.contains(&equation)) {
            return;
        }
        let Place { step, fibre, index } = place;
        let span = self
            .0
            .entry((equation, fibre.name()))
            .or_insert(Span { steps: (step, step), indices: (index, index) });
        span.steps.1 = step;
        span.indices = (span.indices.0.min(index), span.indices.1.max(index));
    }

    /// Says that nothing matched up to a step, and where something would have.
    pub fn nothing_matches(&self, last: u64) -> String {
        let mut places: Vec<(&str, &Span, String)> = Vec::new();
        for ((equation, fibre), span) in &self.0 {
            match places.iter_mut().find(|(f, s, _)| f == fibre && *s == span) {
                Some((_, _, equations)) => equations.push_str(&format!(" ({equation})")),
                None => places.push((fibre, span, format!("({equation})"))),
            }
        }
        let mut text = format!("nothing matches in steps {}", through(&(1, last)));
        if places.is_empty() {
            text += "\n  no wave has reached the place of that equation yet";
        }
        for (fibre, Span { steps, indices }, equations) in places {
            let (steps, indices) = (through(steps), through(indices));
            text += &format!("\n  evaluated: step {steps}, {fibre}, index {indices}: {equations}");
        }
        text
    }
}

fn through<N: PartialEq + std::fmt::Display>((from, to): &(N, N)) -> String {
    if from == to { from.to_string() } else { format!("{from}..{to}") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::shipped;

    #[test]
    fn ranges_have_both_ends() {
        assert_eq!(range::<u64>("17"), Ok(17..=17));
        assert_eq!(range::<usize>("3..17"), Ok(3..=17));
        for bad in ["", "3..", "..3", "17..3", "-2", "3.5", "3..=5", "a"] {
            assert!(range::<u64>(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn equations_are_those_of_the_page() {
        assert_eq!(equation("4"), Ok(4));
        assert_eq!(equation("(17)"), Ok(17));
        for bad in ["0", "21", "256", "-4", "four", ""] {
            assert!(equation(bad).is_err(), "{bad}");
        }
    }

    /// The crossing fibre of Fig. 3 has 100 elements, the struck one 150.
    #[test]
    fn the_last_step_and_the_last_node_of_a_fibre_can_be_chosen_and_no_later_ones() {
        let plan = Plan::of(&shipped("fig3"));
        let checked = |step: u64, fibre, index: usize| {
            let (steps, indices) = (Some(step..=step), Some(index..=index));
            let filter = Filter { steps, indices, fibre, ..Filter::default() };
            check(&filter, &plan).map_err(|error| error.to_string())
        };
        let last = plan.steps;
        for (fibre, node) in
            [(None, 150), (Some(Fibre::Primary), 150), (Some(Fibre::Secondary), 100)]
        {
            assert_eq!(checked(last, fibre, node), Ok(()));
            let message = format!("index {} is beyond the last node, {node}", node + 1);
            assert_eq!(checked(last, fibre, node + 1), Err(message));
        }
        let message = format!("step {} is beyond the run's {last} steps", last + 1);
        assert_eq!(checked(last + 1, None, 0), Err(message));
    }

    #[test]
    fn what_was_seen_of_the_chosen_equations_is_told_fibre_by_fibre() {
        let filter = Filter { equations: vec![2, 4, 6], ..Filter::default() };
        let mut seen = Seen::default();
        for (equation, fibre, step, index) in [
            (4, Fibre::Primary, 3, 1),
            (6, Fibre::Primary, 3, 1),
            (2, Fibre::Primary, 3, 7),
            (4, Fibre::Secondary, 3, 1),
            (7, Fibre::Secondary, 3, 1),
        ] {
            seen.note(&filter, Place { step, fibre, index }, equation);
        }
        assert_eq!(
            seen.nothing_matches(5),
            "nothing matches in steps 1..5\n  \
             evaluated: step 3, primary, index 7: (2)\n  \
             evaluated: step 3, primary, index 1: (4) (6)\n  \
             evaluated: step 3, secondary, index 1: (4)"
        );
        let mut all = Seen::default();
        all.note(&Filter::default(), Place { step: 3, fibre: Fibre::Primary, index: 1 }, 7);
        assert!(all.nothing_matches(5).ends_with("primary, index 1: (7)"));
    }
}
