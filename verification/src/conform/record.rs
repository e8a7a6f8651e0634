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
