//! What came of judging a candidate, format `crossfibre-conformance-report/1`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::judge::Judged;
use super::protocol::{Depth, Hello, Precision};
use super::real::Real;

/// The format that this version writes.
pub const FORMAT: &str = "crossfibre-conformance-report/1";

/// A report.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
pub struct Report {
    /// `crossfibre-conformance-report/1`.
    pub format: String,
    /// Version of the reference.
    pub crossfibre: String,
    /// The candidate's command line.
    pub command: Vec<String>,
    /// What it said of itself.
    pub candidate: Hello,
    /// Of the fresh questions.
    pub seed: u64,
    /// In what it is judged.
    pub number: Precision,
    /// Whether equal bits were demanded.
    pub exact: bool,
    /// Whether it conforms.
    pub conforms: bool,
    /// Each quantity at each depth, over all questions.
    pub quantities: Vec<Row>,
    /// Each question.
    pub items: Vec<ItemRecord>,
    /// Where the time went. The only numbers that are others in another run.
    pub seconds: Seconds,
}

/// Where the time went, s.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize, JsonSchema)]
pub struct Seconds {
    /// Waiting for the candidate.
    pub candidate: f64,
    /// In the reference, in the candidate's number type and with 106 bits.
    pub reference: f64,
    /// Everything else: drawing, reading and comparing.
    pub rest: f64,
}

/// A question and what became of it.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
pub struct ItemRecord {
    /// Depth and name.
    pub id: String,
    /// How deep it goes.
    pub depth: Depth,
    /// What became of it.
    pub verdict: Verdict,
    /// Why, where it is not that it agrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// Of a run that is wrong, the first step at which it is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub departs_at_step: Option<u64>,
}

/// What became of a question.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Equal to the bit.
    Bits,
    /// Within the allowed multiple of the envelope.
    Rounding,
    /// Beyond it, or a count differs.
    Wrong,
    /// No answer that can be judged.
    Broken,
    /// Not supported by the candidate.
    Skipped,
    /// Over- or underflow, or an end that hangs on rounding.
    NotJudged,
}

impl Verdict {
    /// All, in the order of a table.
    pub const ALL: [Self; 6] =
        [Self::Bits, Self::Rounding, Self::Wrong, Self::Broken, Self::Skipped, Self::NotJudged];

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bits => "bits",
            Self::Rounding => "rounding",
            Self::Wrong => "wrong",
            Self::Broken => "broken",
            Self::Skipped => "skipped",
            Self::NotJudged => "not judged",
        }
    }

    /// Whether a candidate with it does not conform.
    pub fn is_failure(self) -> bool {
        matches!(self, Self::Wrong | Self::Broken)
    }
}

/// A quantity at a depth, over all questions that were judged.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
pub struct Row {
    /// The depth.
    pub depth: Depth,
    /// What.
    pub quantity: String,
    /// In how many questions.
    pub questions: usize,
    /// How many numbers.
    pub values: usize,
    /// How many are equal to the bit.
    pub same: usize,
    /// Distances in units of the last place: median, 99 of 100, greatest.
    pub ulps: [u64; 3],
    /// The greatest difference over the greatest number of its list.
    pub relative: Real,
    /// The greatest difference over its envelope.
    pub envelopes: Real,
    /// How many envelopes are allowed.
    pub allowed: f64,
    /// Where that is: question and place; empty where all bits are equal.
    pub worst_at: String,
    /// There, the reference's number.
    pub expected: Real,
    /// There, the candidate's.
    pub found: Real,
    /// There, what of the difference rounding explains.
    pub rounding: Real,
    /// There, the rest.
    pub not_rounding: Real,
}

impl Report {
    /// How many questions came to this.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.items.iter().filter(|item| item.verdict == verdict).count()
    }

    /// Questions whose answers fail the candidate.
    pub fn failures(&self) -> impl Iterator<Item = &ItemRecord> {
        self.items.iter().filter(|item| item.verdict.is_failure())
    }
}

/// Quantities summed up over questions, in the order in which they were first seen at each depth.
#[derive(Debug, Default)]
pub struct Rows(Vec<(Row, Vec<u64>)>);

impl Rows {
    /// Adds what became of a quantity in a question.
    pub fn add(&mut self, depth: Depth, id: &str, judged: Judged) {
        let known =
            self.0.iter().position(|(r, _)| r.depth == depth && r.quantity == judged.quantity);
        let index = known.unwrap_or_else(|| {
            self.0.push((Row::new(depth, &judged), Vec::new()));
            self.0.len() - 1
        });
        let (row, ulps) = &mut self.0[index];
        row.questions += 1;
        row.values += judged.values;
        row.same += judged.same;
        row.relative.0 = row.relative.0.max(judged.relative);
        if judged.envelopes > row.envelopes.0 {
            let (rounding, rest) = judged.split();
            row.envelopes = Real(judged.envelopes);
            row.worst_at =
                if judged.place.is_empty() { id.into() } else { format!("{id}, {}", judged.place) };
            (row.expected, row.found) = (Real(judged.expected), Real(judged.found));
            (row.rounding, row.not_rounding) = (Real(rounding), Real(rest));
        }
        ulps.extend(judged.ulps);
    }

    /// The rows, depth by depth.
    pub fn finish(self) -> Vec<Row> {
        let mut rows: Vec<_> = self
            .0
            .into_iter()
            .map(|(row, mut ulps)| {
                ulps.sort_unstable();
                let quantile = |part: f64| {
                    let last = ulps.len().saturating_sub(1);
                    ulps.get((part * last as f64).ceil() as usize).copied().unwrap_or(0)
                };
                Row { ulps: [quantile(0.5), quantile(0.99), quantile(1.0)], ..row }
            })
            .collect();
        rows.sort_by_key(|row| row.depth);
        rows
    }
}

impl Row {
    /// Whether it fails a candidate of which equal bits are demanded, or not.
    pub fn is_wrong(&self, exact: bool) -> bool {
        if exact { self.same < self.values } else { self.envelopes.0 > self.allowed }
    }

    fn new(depth: Depth, judged: &Judged) -> Self {
        let zero = Real(0.0);
        Self {
            depth,
            quantity: judged.quantity.clone(),
            questions: 0,
            values: 0,
            same: 0,
            ulps: [0; 3],
            relative: zero,
            envelopes: zero,
            allowed: judged.allowed,
            worst_at: String::new(),
            expected: zero,
            found: zero,
            rounding: zero,
            not_rounding: zero,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conform::example::of_everything;

    #[test]
    fn verdicts_are_counted_by_their_names() {
        let report = of_everything();
        let counts = Verdict::ALL.map(|verdict| (verdict.name(), report.count(verdict)));
        let expected = [
            ("bits", 1),
            ("rounding", 1),
            ("wrong", 3),
            ("broken", 1),
            ("skipped", 2),
            ("not judged", 1),
        ];
        assert_eq!(counts, expected);
        let failures: Vec<_> = report.failures().map(|item| item.id.as_str()).collect();
        assert_eq!(failures, ["equation/off", "equation/off-too", "step/none", "run/late"]);
    }

    /// Of a quantity whose number is so many envelopes of 0.5 off; those of `0.0` are equal.
    fn judged(quantity: &str, envelopes: f64, place: &str) -> Judged {
        Judged {
            quantity: quantity.into(),
            values: 3,
            same: if envelopes > 0.0 { 2 } else { 3 },
            ulps: vec![0, 0, (16.0 * envelopes) as u64],
            worst: 0.5 * envelopes,
            relative: 0.25 * envelopes,
            envelopes,
            allowed: 8.0,
            place: place.into(),
            expected: 4.0,
            found: 4.0 + 0.5 * envelopes,
        }
    }

    #[test]
    fn a_row_sums_up_a_quantity_at_a_depth_and_tells_the_first_of_its_worst() {
        let mut rows = Rows::default();
        for (depth, id, judged) in [
            (Depth::Step, "step/a", judged("energy", 0.0, "")),
            (Depth::Run, "run/a", judged("energy", 0.0, "")),
            (Depth::Equation, "equation/a", judged("eqn (4)", 2.0, "")),
            (Depth::Run, "run/a", judged("tension", 2.0, "node 1")),
            (Depth::Run, "run/b", judged("tension", 16.0, "node 2")),
            (Depth::Run, "run/c", judged("tension", 16.0, "node 3")),
            (Depth::Run, "run/d", judged("tension", 1.0, "node 4")),
        ] {
            rows.add(depth, id, judged);
        }
        let rows = rows.finish();
        let names: Vec<_> = rows.iter().map(|r| (r.depth, r.quantity.as_str())).collect();
        // By depth, and there in the order in which they came.
        let expected = [
            (Depth::Equation, "eqn (4)"),
            (Depth::Step, "energy"),
            (Depth::Run, "energy"),
            (Depth::Run, "tension"),
        ];
        assert_eq!(names, expected);
        let (of_equation, of_equal_bits, tension) = (&rows[0], &rows[1], &rows[3]);
        assert_eq!(of_equation.worst_at, "equation/a");
        assert_eq!((of_equal_bits.same, of_equal_bits.values), (3, 3));
        assert_eq!((of_equal_bits.worst_at.as_str(), of_equal_bits.expected), ("", Real(0.0)));
        assert_eq!((tension.questions, tension.values, tension.same), (4, 12, 8));
        assert_eq!(tension.worst_at, "run/b, node 2");
        assert_eq!((tension.relative, tension.envelopes), (Real(4.0), Real(16.0)));
        assert_eq!((tension.expected, tension.found), (Real(4.0), Real(12.0)));
        // Of 16 envelopes of 0.5 rounding explains 8.
        assert_eq!((tension.rounding, tension.not_rounding), (Real(4.0), Real(4.0)));
        // Sorted: eight times 0, then 16, 32, and 256 twice.
        assert_eq!(tension.ulps, [0, 256, 256]);
        assert_eq!(of_equation.ulps, [0, 32, 32]);
    }

    #[test]
    fn of_many_numbers_the_distances_are_told_of_a_half_of_almost_all_and_of_all() {
        let ulps = (0..=1000).rev().collect();
        let judged = Judged { values: 1001, ulps, ..judged("tension", 2.0, "node 1") };
        let mut rows = Rows::default();
        rows.add(Depth::Run, "run/a", judged);
        assert_eq!(rows.finish()[0].ulps, [500, 990, 1000]);
    }

    #[test]
    fn a_row_is_wrong_beyond_what_is_allowed_or_by_a_bit_if_bits_are_demanded() {
        let row = |envelopes| {
            let mut rows = Rows::default();
            rows.add(Depth::Run, "run/a", judged("tension", envelopes, ""));
            rows.finish().remove(0)
        };
        for (envelopes, exact, wrong) in [
            (0.0, false, false),
            (0.0, true, false),
            (0.5, false, false),
            (0.5, true, true),
            (8.0, false, false),
            (8.5, false, true),
            (8.5, true, true),
        ] {
            assert_eq!(row(envelopes).is_wrong(exact), wrong, "{envelopes} {exact}");
        }
    }
}
