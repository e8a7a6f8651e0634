//! A made-up report with a bit of everything, for the tests of what is written of one.

use super::protocol::{Depth, Precision};
use super::real::Real;
use super::record::{FORMAT, ItemRecord, Report, Row, Seconds, Verdict};

/// A question and what became of it.
pub fn item(id: &str, depth: Depth, verdict: Verdict, reason: Option<&str>) -> ItemRecord {
    let reason = reason.map(Into::into);
    ItemRecord { id: id.into(), depth, verdict, reason, departs_at_step: None }
}

/// The report of these questions and quantities.
pub fn report(items: Vec<ItemRecord>, quantities: Vec<Row>) -> Report {
    let hello = r#"{"id":0,"format":"crossfibre-conformance/1","name":"<made> up","version":"7"}"#;
    Report {
        format: FORMAT.into(),
        crossfibre: "0.1.0".into(),
        command: vec!["./made-up".into(), "--fast".into()],
        candidate: serde_json::from_str(hello).unwrap(),
        seed: 3,
        number: Precision::F64,
        exact: false,
        conforms: false,
        quantities,
        items,
        seconds: Seconds::default(),
    }
}

/// So many numbers, equal ones among them, and how far the others are apart.
fn row(depth: Depth, quantity: &str, values: [usize; 2], ulps: [u64; 3], envelopes: f64) -> Row {
    let [values, same] = values;
    Row {
        depth,
        quantity: quantity.into(),
        questions: 3,
        values,
        same,
        ulps,
        relative: Real(0.0025),
        envelopes: Real(envelopes),
        allowed: 4.0,
        worst_at: format!("where {quantity} is worst"),
        expected: Real(0.5),
        found: Real(0.25),
        rounding: Real(0.0003),
        not_rounding: Real(0.0),
    }
}

/// Every verdict, every kind of row.
pub fn of_everything() -> Report {
    use Depth::{Equation, Run, Step};
    let departed = ItemRecord {
        departs_at_step: Some(17),
        ..item("run/late", Run, Verdict::Wrong, Some("too late"))
    };
    let items = vec![
        item("equation/equal", Equation, Verdict::Bits, None),
        item("equation/off", Equation, Verdict::Wrong, Some("a sign")),
        item("equation/off-too", Equation, Verdict::Wrong, Some("a sign")),
        item("step/near", Step, Verdict::Rounding, None),
        item("step/none", Step, Verdict::Broken, Some("it ended")),
        departed,
        item("run/eyring", Run, Verdict::Skipped, Some("no eyring law")),
        item("run/other-eyring", Run, Verdict::Skipped, Some("no eyring law")),
        item("run/huge", Run, Verdict::NotJudged, Some("over- or underflow")),
    ];
    let rows = vec![
        row(Equation, "eqn (7)", [2000, 1999], [0, 3, 120_000], 123.4),
        row(Equation, "eqn (8)", [12, 12], [0; 3], 0.0),
        row(Step, "primary strain", [40, 10], [1, 99_999, 100_000], 0.5),
        row(Run, "primary tension", [40, 0], [1, 2, 3], 100.0),
        row(Run, "energy", [3, 0], [7, u64::MAX, u64::MAX], f64::INFINITY),
    ];
    report(items, rows)
}
