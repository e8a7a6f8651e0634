//! The costs as a page.

use std::fmt::Write;

use super::Cost;

/// The page, in Markdown.
pub fn page(costs: &[Cost]) -> String {
    let mut page = String::from(
        "# What a scene pays for\n\n\
         Written by `crossfibre study cost`. One fibre of eqn (7), struck at a constant velocity, and the \
         same with one thing more. For each element of each step: evaluations of equations, counted by \
         the program, and machine instructions, counted by callgrind as the difference between two runs \
         of which one has twice as many steps. Instructions depend on compiler and processor (callgrind \
         offers vectors of four doubles); on one machine they come out the same each time to about a \
         thousandth. They are a study, not a test.\n\n\
         | with | evaluations | equations beyond (2), (4)–(7) | instructions | times the first |\n\
         |---|---|---|---|---|\n",
    );
    let first = costs.first().and_then(|cost| cost.instructions);
    for cost in costs {
        let evaluations: f64 = cost.evaluations.iter().map(|(_, times)| times).sum();
        let beyond: Vec<_> = cost
            .evaluations
            .iter()
            .map(|(number, _)| *number)
            .filter(|number| !matches!(number, 2 | 4..=7))
            .map(|number| format!("({number})"))
            .collect();
        let number = |x: Option<f64>, digits| x.map_or("–".into(), |x| format!("{x:.digits$}"));
        let ratio = cost.instructions.zip(first).map(|(this, first)| this / first);
        let _ = writeln!(
            page,
            "| {} | {evaluations:.3} | {} | {} | {} |",
            cost.variant.what,
            if beyond.is_empty() { "none".into() } else { beyond.join(" ") },
            number(cost.instructions, 1),
            number(ratio, 2),
        );
    }
    page += "\n\
         Nothing in the first row is there for the others: a fibre of eqn (7) makes no call of a law and \
         remembers nothing for one, a scene without a crossing fibre holds none, and the traced march is \
         another instance of the same source. A law is compiled by itself and called once for a block of \
         384 elements; its loop holds one law, with what is added to it, and nothing else. Under (4) the \
         work along the path is booked as well, which the page's law does not need.\n";
    page
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::shipped;
    use crate::cost::Variant;

    #[test]
    fn a_row_has_sums_what_is_beyond_the_first_and_ratios_to_the_first() {
        let cost = |what, evaluations, instructions| Cost {
            variant: Variant { what, scene: shipped("single-400"), command: &[] },
            evaluations,
            instructions,
        };
        let plain = vec![(2, 1.0), (4, 1.0), (5, 1.0), (6, 0.5), (7, 1.0)];
        let more = vec![(2, 1.0), (3, 0.25), (7, 1.0), (8, 0.125)];
        let page = page(&[
            cost("nothing more", plain.clone(), Some(20.0)),
            cost("some", more, Some(50.0)),
            cost("uncounted", plain, None),
        ]);
        let rows: Vec<&str> = page.lines().filter(|line| line.starts_with("| ")).skip(1).collect();
        assert_eq!(
            rows,
            [
                "| nothing more | 4.500 | none | 20.0 | 1.00 |",
                "| some | 2.375 | (3) (8) | 50.0 | 2.50 |",
                "| uncounted | 4.500 | none | – | – |",
            ]
        );
    }
}
