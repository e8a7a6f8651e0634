//! Verdicts on the golden trace and on copies of it in which something has been changed.

use std::collections::BTreeSet;
use std::io::Cursor;

use crossfibre::corrected::{Corrected, Incremental};
use crossfibre::double_double::DoubleDouble;
use crossfibre::march;
use crossfibre::place::Fibre;
use crossfibre::result::{WithPaper, with_paper};
use crossfibre::scene::Scene;
use crossfibre::state::{State, Wavefront};
use crossfibre::trace::{Event, Traced};
use crossfibre::trace_file::JsonLines;
use proptest::prelude::*;

use super::origin::origin;
use super::*;
use crate::cases::support::{SCENES, coarse_fig3, relative, shipped};
use crate::trace_line::Number;

/// Four steps of a coarse Fig. 3.
const GOLDEN: &str = include_str!("../../../golden/trace.jsonl");

/// A line of it: (6) of the primary's element 1 in step 3.
const LENGTH: &str = r#"{"step":3,"fibre":"primary","index":1,"eq":"6","in":{"x_ahead":[0.09999999999999999,0.0],"v_ahead":[-5.72585652919446,0.0005392104990500223],"x_here":[0.04991783437967817,4.71629517434639e-6],"v_here":[-34.05606540204146,4.5690945798942275],"dt":7.17498260810583e-6},"out":0.050285448355663113}"#;

/// The output, and the same two doubles on.
const OUTPUT: (&str, &str) = ("\"out\":0.050285448355663113", "\"out\":0.05028544835566313");

fn read(a: impl AsRef<[u8]>, b: impl AsRef<[u8]>, options: Options) -> Result<Record> {
    let stream = |name: &str, bytes: &[u8]| {
        Stream::of(name.into(), Box::new(Cursor::new(bytes.to_vec())), options.filter.clone())
    };
    let a = stream("a.trace", a.as_ref())?;
    let b = stream("b.trace", b.as_ref())?;
    let mut comparison = Comparison::of(a, b, options);
    comparison.run()?;
    let record = comparison.record();
    assert!(!Report(&record).to_string().is_empty());
    Ok(record)
}

fn compared(a: &str, b: &str) -> Record {
    read(a, b, Options::default()).unwrap()
}

/// The golden trace with a part of a line exchanged.
fn with(line: &str, from: &str, to: &str) -> String {
    assert!(GOLDEN.contains(line) && line.contains(from), "{from}");
    GOLDEN.replacen(line, &line.replacen(from, to, 1), 1)
}

fn line_of(step: u64, fibre: &str, index: usize, equation: u8) -> &'static str {
    let head = format!(r#"{{"step":{step},"fibre":"{fibre}","index":{index},"eq":"{equation}","#);
    GOLDEN.lines().find(|line| line.starts_with(&head)).unwrap()
}

fn sum(record: &Record, of: fn(&record::EquationTally) -> u64) -> u64 {
    record.equations.iter().map(of).sum()
}

#[test]
fn the_same_trace_twice_agrees() {
    let record = compared(GOLDEN, GOLDEN);
    assert!(record.agree && record.to_the_end && record.first_difference.is_none());
    assert_eq!(record.verdict, "the traces agree: 111 events, to the last bit");
    assert_eq!(sum(&record, |tally| tally.events), 111);
    assert_eq!(record.header, HeaderDifference::default());
    // With and without the end of the last line.
    assert!(compared(GOLDEN, GOLDEN.trim_end()).agree);
}

#[test]
fn an_output_that_differs_is_a_fault_of_its_equation() {
    let record = compared(GOLDEN, &with(LENGTH, OUTPUT.0, OUTPUT.1));
    assert_eq!(
        record.verdict,
        "first difference: eqn (6), step 3, primary element 1, 2 ULP, inputs equal: \
         the fault is in (6)"
    );
    let first = record.first_difference.as_ref().unwrap();
    assert_eq!((first.kind, first.quantities.len()), (Kind::Output, 1));
    assert_eq!(first.a.as_ref().unwrap().line, 54);
    assert_eq!(record.agree_before, 52);
    assert_eq!(record.last_agreeing.as_ref().unwrap().evaluation.eq, "5");
    assert_eq!(sum(&record, |tally| tally.differing), 1);
    let of_6 = record.equations.iter().find(|tally| tally.eq == "6").unwrap();
    let worst = of_6.worst.as_ref().unwrap();
    let Number::Finite(found) = worst.relative else { panic!("{worst:?}") };
    // The two doubles are 6.9e-18 each, 2⁻⁵⁷, and their difference is exact.
    let expected = 2.0 * 2_f64.powi(-57) / 0.05028544835566313;
    assert_eq!((worst.ulp, worst.name.as_str()), (Some(2), "out"));
    assert!(relative(found, expected) < 1e-15); // a quotient rounded
}

#[test]
fn an_input_that_differs_puts_the_fault_before_and_says_where_it_comes_from() {
    let b = with(LENGTH, "[0.09999999999999999,0.0]", "[0.1,0.0]");
    let record = compared(GOLDEN, &b.replacen(OUTPUT.0, OUTPUT.1, 1));
    assert_eq!(
        record.verdict,
        "first difference: eqn (6), step 3, primary element 1, inputs already differ \
         (x_ahead, 1 ULP): the fault is before (6)"
    );
    assert_eq!(
        record.notes,
        [
            "x_ahead: a position, moved by x + v Δt, which is no numbered equation; (2), (12), (13), \
          (14), (17), (18) agree wherever they are traced before this"
        ]
    );
    // Only (6) was traced: then nothing says where the position comes from.
    let filter = Filter { equations: vec![6], ..Filter::default() };
    let only = Options { filter, ..Options::default() };
    let record = read(GOLDEN, &b, only).unwrap();
    assert_eq!(
        record.notes,
        ["x_ahead: a position, moved by x + v Δt, which is no numbered equation; nothing traced \
          before this gives it: see (2), (8), (12), (13), (14), (17), (18)"]
    );
    let b = with(LENGTH, "7.17498260810583e-6", "7.17498260810593e-6");
    assert_eq!(compared(GOLDEN, &b).notes, ["dt: set up from the scene before the first step"]);
}

#[test]
fn an_event_that_one_trace_lacks_is_named_with_what_the_other_has_next() {
    let line = line_of(2, "primary", 1, 5);
    let lacks = GOLDEN.replacen(&format!("{line}\n"), "", 1);
    let verdict = |lacking: &str| {
        format!(
            "first difference: {lacking} has no eqn (5) at step 2, primary element 1: \
             what it has next is eqn (6), step 2, primary element 1"
        )
    };
    let record = compared(GOLDEN, &lacks);
    assert_eq!(record.verdict, verdict("B"));
    assert_eq!((sum(&record, |t| t.only_in_a), sum(&record, |t| t.differing)), (1, 0));
    let record = compared(&lacks, GOLDEN);
    assert_eq!(record.verdict, verdict("A"));
    assert_eq!((sum(&record, |t| t.only_in_b), sum(&record, |t| t.only_in_a)), (1, 0));
    // No (5) at all, as with engineering strain: each is missed, the others agree.
    let lines: Vec<_> = GOLDEN.lines().filter(|line| !line.contains("\"eq\":\"5\"")).collect();
    let record = compared(GOLDEN, &lines.join("\n"));
    let missed = GOLDEN.lines().count() - lines.len();
    assert!(missed > 10, "{missed}");
    assert_eq!(sum(&record, |t| t.only_in_a), missed as u64);
    assert_eq!(sum(&record, |t| t.events), 111 - missed as u64);
}

#[test]
fn a_trace_that_ends_before_the_other_does_is_told_so() {
    let shorter: String = GOLDEN.lines().take(100).map(|line| format!("{line}\n")).collect();
    let record = compared(GOLDEN, &shorter);
    let next: trace_line::Event = serde_json::from_str(GOLDEN.lines().nth(100).unwrap()).unwrap();
    let next = record::Evaluation::from(&next);
    assert_eq!(record.verdict, format!("first difference: B ends; A goes on with {next}"));
    assert_eq!(sum(&record, |t| t.only_in_a), 12);
    assert_eq!(record.first_difference.unwrap().b, None);
    let record = compared(&shorter, GOLDEN);
    assert_eq!(record.verdict, format!("first difference: A ends; B goes on with {next}"));
}

#[test]
fn other_quantities_are_told_from_other_numbers() {
    let line = line_of(3, "primary", 1, 4);
    let record = compared(GOLDEN, &with(line, "\"L_before\"", "\"L_0\""));
    assert_eq!(
        record.verdict,
        "first difference: eqn (4), step 3, primary element 1, not the same quantities \
         (only A has L_before; only B has L_0): the scenes or the editions differ"
    );
    let record =
        compared(GOLDEN, &with(LENGTH, "[0.09999999999999999,0.0]", "[0.09999999999999999]"));
    assert!(record.verdict.contains("(not of one dimension: x_ahead)"), "{}", record.verdict);
    let record = compared(
        &with(LENGTH, "\"dt\":7.17498260810583e-6", "\"dt\":[7.17498260810583e-6]"),
        GOLDEN,
    );
    assert!(record.verdict.contains("(not of one dimension: dt)"), "{}", record.verdict);
}

#[test]
fn a_tolerance_excuses_what_is_within_it_and_says_so() {
    let options =
        |relative, ulp| Options { tolerance: Tolerance { relative, ulp }, ..Options::default() };
    let b = with(LENGTH, OUTPUT.0, OUTPUT.1);
    for within in [options(Some(3e-16), None), options(None, Some(2))] {
        assert_eq!(
            read(GOLDEN, &b, within).unwrap().verdict,
            "the traces agree within the tolerance: 111 events, 1 of them not to the last bit"
        );
    }
    // 2 ULP of 0.0503 are 2 × 6.9e-18, 2.8e-16 of it.
    for beyond in [options(Some(2e-16), None), options(None, Some(1))] {
        assert!(!read(GOLDEN, &b, beyond).unwrap().agree);
    }
    // The input that is within it may be to blame all the same.
    let b = b.replacen(
        "4.71629517434639e-6],\"v_here\":[-34.05606540204146",
        "4.71629517434638e-6],\"v_here\":[-34.05606540204146",
        1,
    );
    let b = b.replacen(OUTPUT.1, "\"out\":0.0512", 1);
    let record = read(GOLDEN, &b, options(Some(1e-3), None)).unwrap();
    assert_eq!(
        record.verdict,
        "first difference: eqn (6), step 3, primary element 1, 1.8e-2 relative, inputs equal only \
         within the tolerance (x_here, 11 ULP): the fault is in (6), or has grown from before it"
    );
    assert_eq!(record.notes.len(), 1);
}

#[test]
fn the_same_numbers_in_other_words_agree() {
    // Keys in alphabetical order, spaces, and numbers with exponents.
    let words = |line: &str| {
        let mut json: serde_json::Value = serde_json::from_str(line).unwrap();
        if json["out"].is_f64() {
            json["out"] =
                serde_json::from_str(&format!("{:E}", json["out"].as_f64().unwrap())).unwrap();
        }
        serde_json::to_string(&json).unwrap().replace(":", " :\t").replace(",", " , ")
    };
    let (header, events) = GOLDEN.split_once('\n').unwrap();
    let other: Vec<_> = events.lines().map(words).collect();
    let other = format!("{header}\r\n{}\r\n", other.join("\r\n"));
    assert_ne!(other.lines().nth(1), GOLDEN.lines().nth(1));
    assert_eq!(compared(GOLDEN, &other).verdict, "the traces agree: 111 events, to the last bit");
    let b = with(LENGTH, "7.17498260810583e-6", "0.00000717498260810583000");
    assert!(compared(GOLDEN, &b).agree);
    // A double is a sum of doubles without a second one; with it, it differs by less than a ULP.
    let b = with(LENGTH, "7.17498260810583e-6", r#"{"hi":7.17498260810583e-6,"lo":0.0}"#);
    assert!(compared(GOLDEN, &b).agree);
    let b = with(LENGTH, "7.17498260810583e-6", r#"{"hi":7.17498260810583e-6,"lo":1e-25}"#);
    let record = compared(GOLDEN, &b);
    assert!(record.verdict.contains("(dt, 1.4e-20 relative)"), "{}", record.verdict);
}

#[test]
fn headers_that_differ_are_told_and_are_no_disagreement() {
    let b = GOLDEN.replacen("\"elements\":6", "\"elements\":7", 1).replacen(
        "{E} * {strain}",
        "{strain} * {E}",
        1,
    );
    let record = compared(GOLDEN, &b);
    assert!(record.agree);
    let [field] = &record.header.scene[..] else { panic!("{:?}", record.header) };
    assert_eq!(
        (field.path.as_str(), field.a.as_u64(), field.b.as_u64()),
        ("primary.elements", Some(6), Some(7))
    );
    assert_eq!(record.header.equations, [7]);
    let text = Report(&record).to_string();
    assert!(text.contains("warning: the scenes differ: primary.elements: 6 / 7\n"), "{text}");
    assert!(text.contains("warning: the editions differ: other lines of (7)\n"), "{text}");
}

#[test]
fn a_choice_and_the_first_difference_read_no_more_than_is_wanted() {
    let b = with(LENGTH, OUTPUT.0, OUTPUT.1);
    let chosen = |filter| read(GOLDEN, &b, Options { filter, ..Options::default() });
    assert!(chosen(Filter { equations: vec![4, 7], ..Filter::default() }).unwrap().agree);
    assert!(chosen(Filter { fibre: Some(Fibre::Secondary), ..Filter::default() }).unwrap().agree);
    assert!(!chosen(Filter { steps: Some(3..=3), ..Filter::default() }).unwrap().agree);
    let nothing = chosen(Filter { equations: vec![8], ..Filter::default() }).unwrap_err();
    assert_eq!(nothing.to_string(), "neither trace has an event of this choice");
    let first = read(GOLDEN, &b, Options { first_only: true, ..Options::default() }).unwrap();
    assert!(!first.to_the_end);
    assert_eq!(sum(&first, |tally| tally.events), 53);
}

#[test]
fn a_fault_is_where_the_editions_differ_only_if_they_differ_there() {
    let b = with(LENGTH, OUTPUT.0, OUTPUT.1);
    let of_7 = b.replacen("{E} * {strain}", "{strain} * {E}", 1);
    let record = compared(GOLDEN, &of_7);
    assert_eq!(record.header.equations, [7]);
    assert!(record.verdict.ends_with("the fault is in (6)"), "{}", record.verdict);
    let of_6 = b.replacen("({x_ahead} + {v_ahead} * {dt})", "({v_ahead} * {dt} + {x_ahead})", 1);
    let record = compared(GOLDEN, &of_6);
    assert_eq!(record.header.equations, [6]);
    let verdict = "the fault is in (6), where the editions differ";
    assert!(record.verdict.ends_with(verdict), "{}", record.verdict);
}

#[test]
fn of_inputs_those_beyond_the_tolerance_are_blamed() {
    let b = with(
        LENGTH,
        "4.71629517434639e-6],\"v_here\":[-34.05606540204146,4.5690945798942275],\"dt\":7.17498260810583e-6",
        "4.71629517434638e-6],\"v_here\":[-34.05606540204146,4.5690945798942275],\"dt\":7.2e-6",
    );
    let tolerance = Tolerance { relative: Some(1e-3), ulp: None };
    let record = read(GOLDEN, &b, Options { tolerance, ..Options::default() }).unwrap();
    // 0.02501739 of 7.2 are 3.47e-3.
    assert_eq!(
        record.verdict,
        "first difference: eqn (6), step 3, primary element 1, inputs already differ \
         (dt, 3.5e-3 relative): the fault is before (6)"
    );
    assert_eq!(record.notes, ["dt: set up from the scene before the first step"]);
}

#[test]
fn inputs_of_one_origin_are_noted_together_and_that_the_scenes_differ_is_noted() {
    let other = LENGTH
        .replacen("[0.09999999999999999,0.0]", "[0.1,0.0]", 1)
        .replacen("[0.04991783437967817,4.71629517434639e-6]", "[0.05,4.7e-6]", 1)
        .replacen("7.17498260810583e-6", "7.2e-6", 1);
    let b = with(LENGTH, LENGTH, &other).replacen("\"elements\":6", "\"elements\":7", 1);
    let notes: Vec<_> = compared(GOLDEN, &b).notes;
    let [positions, time_step] = &notes[..] else { panic!("{notes:?}") };
    assert!(positions.starts_with("x_ahead, x_here: a position, moved by"), "{positions}");
    assert_eq!(time_step, "dt: set up from the scene before the first step; the scenes differ");
}

#[test]
fn what_is_not_finite_and_a_sign_of_zero_are_named_so() {
    let record = compared(GOLDEN, &with(LENGTH, OUTPUT.0, "\"out\":\"NaN\""));
    assert_eq!(
        record.verdict,
        "first difference: eqn (6), step 3, primary element 1, not finite in one, inputs equal: \
         the fault is in (6)"
    );
    let b = with(LENGTH, "[0.09999999999999999,0.0]", "[0.09999999999999999,-0.0]");
    assert_eq!(
        compared(GOLDEN, &b).verdict,
        "first difference: eqn (6), step 3, primary element 1, inputs already differ \
         (x_ahead, the sign of zero): the fault is before (6)"
    );
}

#[test]
fn other_quantities_come_before_other_numbers_and_a_vector_of_one_is_no_number() {
    let line = line_of(3, "primary", 1, 4);
    let other = with(line, "\"L\":0.05", "\"L\":0.07").replacen(
        r#""index":1,"eq":"4","in":{"strain_before":0.0016433168478258153"#,
        r#""index":1,"eq":"4","in":{"strain_past":0.0016433168478258153"#,
        1,
    );
    assert_eq!(
        compared(GOLDEN, &other).verdict,
        "first difference: eqn (4), step 3, primary element 1, not the same quantities \
         (only A has strain_before; only B has strain_past): the scenes or the editions differ"
    );
    let b = with(LENGTH, "[0.09999999999999999,0.0]", "[0.09999999999999999]");
    let first = compared(GOLDEN, &b).first_difference.unwrap();
    let of_one = trace_line::Value::Vector(vec![Number::Finite(0.09999999999999999)]);
    assert_eq!(first.quantities[0].b, Some(of_one));
}

/// A line of the same bytes in both is not read, unless it might be none.
#[test]
fn what_is_wrong_in_both_traces_is_wrong() {
    let twice = |bytes: String| read(&bytes, &bytes, Options::default()).unwrap_err().to_string();
    let error = twice(with(LENGTH, "\"dt\"", "\"Δt\""));
    assert!(error.starts_with("a.trace:54: an input whose name is not of plain"), "{error}");
    let error = twice(GOLDEN.replacen(LENGTH, &format!("{LENGTH}x"), 1));
    assert!(error.starts_with("a.trace:54: not JSON"), "{error}");
}

#[test]
fn an_event_of_far_more_inputs_than_any_equation_has_is_refused() {
    let more: String = (0..100).map(|k| format!("\"i{k}\":0.3,")).collect();
    let b = with(LENGTH, "\"dt\"", &format!("{more}\"dt\""));
    let error = read(GOLDEN, &b, Options::default()).unwrap_err().to_string();
    assert_eq!(error, "b.trace:54: too many inputs");
}

#[test]
fn half_of_what_an_event_has_does_not_make_a_first_line_one() {
    for line in ["{\"eq\":\"7\"}\n", "{\"out\":0.3}\n"] {
        let error = read(GOLDEN, line, Options::default()).unwrap_err().to_string();
        assert!(error.starts_with("b.trace:1: no header of a trace"), "{error}");
    }
}

/// What is wrong, where, and some words of what is said of it.
#[test]
fn a_malformed_trace_is_refused_with_its_line() {
    let events = GOLDEN.split_once('\n').unwrap().1;
    let (fifty_four, five) = (LENGTH.to_owned() + "\n", line_of(3, "primary", 1, 5));
    let cut = &GOLDEN[..GOLDEN.len() - 7];
    let renamed = |from, to| with(LENGTH, from, to).into_bytes();
    let mut latin_1 = GOLDEN.as_bytes().to_vec();
    let at = GOLDEN.find(LENGTH).unwrap();
    latin_1[at + 50] = 0xB5;
    let cases: Vec<(Vec<u8>, &str)> = vec![
        (vec![], "b.trace: is empty"),
        (b"\n".to_vec(), "b.trace:1: not JSON"),
        (events.into(), "b.trace:1: an event: the header, the first line of a trace, is missing"),
        (
            GOLDEN.replacen("trace/1", "trace/2", 1).into(),
            "b.trace:1: the format is \"crossfibre-trace/2\"",
        ),
        (
            b"{\"format\":\"crossfibre-result/1\"}\n".to_vec(),
            "b.trace:1: the format is \"crossfibre-result/1\"",
        ),
        (b"[1]\n".to_vec(), "b.trace:1: no header of a trace"),
        (
            GOLDEN.replacen("\"elements\":6", "\"elements\":0", 1).into(),
            "b.trace:1: scene.primary.elements",
        ),
        (GOLDEN.lines().next().unwrap().into(), "b.trace: has a header and no event"),
        (GOLDEN[..200].into(), "b.trace:1: the file ends in the middle of this line"),
        (cut.into(), "b.trace:112: the file ends in the middle of this line: not JSON"),
        (latin_1, "b.trace:54: byte 51 is not UTF-8"),
        (renamed("\"6\"", "\"21\""), "b.trace:54: unknown equation \"21\""),
        (renamed("\"6\"", "\"06\""), "b.trace:54: unknown equation \"06\""),
        (
            renamed("\"6\"", "\"3\""),
            "b.trace:54: eqn (3), step 3, primary node 1 has no place in a step",
        ),
        (
            renamed("\"step\":3", "\"step\":2"),
            "b.trace:54: eqn (6), step 2, primary element 1 is out of order: it comes after eqn (5), step 3, primary element 1",
        ),
        (
            renamed("primary", "tertiary"),
            "b.trace:54: not an event of crossfibre-trace/1: unknown variant `tertiary`",
        ),
        (
            renamed("\"out\"", "\"result\""),
            "b.trace:54: not an event of crossfibre-trace/1: unknown field `result`",
        ),
        (
            renamed("\"dt\":7.17498260810583e-6", "\"dt\":null"),
            "b.trace:54: not an event of crossfibre-trace/1",
        ),
        (
            renamed("\"dt\":7.17498260810583e-6", "\"dt\":7e999"),
            "b.trace:54: not JSON: number out of range",
        ),
        (renamed("\"dt\"", "\"Δt\""), "b.trace:54: an input whose name is not of plain letters"),
        (renamed("{", ""), "b.trace:54: not"),
        (
            GOLDEN.replacen(&fifty_four, &fifty_four.repeat(2), 1).into(),
            "b.trace:55: eqn (6), step 3, primary element 1 is there twice",
        ),
        (
            GOLDEN.replacen(&format!("{five}\n{LENGTH}"), &format!("{LENGTH}\n{five}"), 1).into(),
            "b.trace:54: eqn (5), step 3, primary element 1 is out of order",
        ),
        (
            GOLDEN.replacen(LENGTH, GOLDEN.lines().next().unwrap(), 1).into(),
            "b.trace:54: a second header",
        ),
        (GOLDEN.replacen(LENGTH, "", 1).into(), "b.trace:54: not JSON"),
        (
            GOLDEN.replacen(LENGTH, &"x".repeat((1 << 20) + 1), 1).into(),
            "b.trace:54: the line has more than 1 MiB",
        ),
    ];
    for (b, message) in cases {
        let error = read(GOLDEN, &b, Options::default()).unwrap_err().to_string();
        assert!(error.starts_with(message), "{error}\nis not: {message}");
    }
}

#[test]
fn every_input_of_every_shipped_scene_has_an_origin() {
    struct Symbols<'a>(&'a Scene);
    impl WithPaper<f64> for Symbols<'_> {
        type Out = BTreeSet<&'static str>;
        fn with(self, paper: &impl crossfibre::paper::Paper<f64>) -> Self::Out {
            let mut symbols = BTreeSet::new();
            let traced = Traced::new(paper, |event: &Event<'_, f64>| {
                symbols.extend(event.inputs.iter().map(|(name, _)| *name));
            });
            march::run(&traced, &mut State::at_impact(self.0, Wavefront::Flagged), 70, |_| ());
            symbols
        }
    }
    let mut all = BTreeSet::new();
    for (name, _) in SCENES {
        let mut scene = shipped(name);
        scene.projectile.mass = Some(0.00091);
        all.extend(with_paper(&scene, Symbols(&scene)));
    }
    let unknown: Vec<_> = all.iter().filter(|symbol| origin(symbol).is_none()).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
    assert!(all.len() > 40, "{}", all.len());
}

/// What the library writes of a march in some type of number.
fn traced_in<S: crossfibre::number::Number>(scene: &Scene, steps: u64) -> Vec<u8> {
    let paper = Corrected::<Incremental>::new(scene.corrections);
    let mut text = Vec::new();
    let sink = JsonLines::start::<S>(&mut text, scene, &paper, Filter::default()).unwrap();
    let traced = Traced::new(&paper, sink);
    march::run(&traced, &mut State::<S>::at_impact(scene, Wavefront::Flagged), steps, |_| ());
    traced.into_sink().finish().unwrap();
    text
}

#[test]
fn a_march_of_32_digits_differs_from_one_of_16_by_a_rounding() {
    let scene = coarse_fig3();
    let [doubles, sums] = [traced_in::<f64>(&scene, 5), traced_in::<DoubleDouble>(&scene, 5)];
    let record = read(&sums, &sums, Options::default()).unwrap();
    assert!(record.verdict.starts_with("the traces agree: "), "{}", record.verdict);
    let record = read(&doubles, &sums, Options::default()).unwrap();
    let first = record.first_difference.unwrap();
    let Some(Number::Finite(relative)) = first.quantities[0].relative else { panic!("{first:?}") };
    // The scene's doubles are the same; a few operations of half a unit, 1.1e-16, follow.
    assert!(relative > 0.0 && relative < 5e-16, "{relative}: {first:?}");
}

/// What befalls the bytes of a trace.
#[derive(Clone, Debug)]
enum Mishap {
    Cut(prop::sample::Index),
    Flip(prop::sample::Index, u8),
    Swap(prop::sample::Index, prop::sample::Index),
    Repeat(prop::sample::Index),
    Drop(prop::sample::Index),
}

impl Mishap {
    fn befall(&self, bytes: &mut Vec<u8>) {
        let mut lines: Vec<Vec<u8>> =
            bytes.split_inclusive(|&b| b == b'\n').map(Into::into).collect();
        match self {
            _ if bytes.is_empty() => return,
            Self::Cut(at) => return bytes.truncate(at.index(bytes.len())),
            Self::Flip(at, by) => {
                let at = at.index(bytes.len());
                bytes[at] ^= by;
                return;
            }
            Self::Swap(one, other) => {
                let count = lines.len();
                lines.swap(one.index(count), other.index(count));
            }
            Self::Repeat(at) => {
                let at = at.index(lines.len());
                lines.insert(at, lines[at].clone());
            }
            Self::Drop(at) => {
                lines.remove(at.index(lines.len()));
            }
        }
        *bytes = lines.concat();
    }
}

fn mishap() -> impl Strategy<Value = Mishap> {
    let at = any::<prop::sample::Index>;
    prop_oneof![
        1 => at().prop_map(Mishap::Cut),
        6 => (at(), 1_u8..).prop_map(|(at, by)| Mishap::Flip(at, by)),
        1 => (at(), at()).prop_map(|(one, other)| Mishap::Swap(one, other)),
        1 => at().prop_map(Mishap::Repeat),
        1 => at().prop_map(Mishap::Drop),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever the bytes, the comparison ends, with a verdict or with a message that names the file.
    #[test]
    fn whatever_befalls_the_bytes_there_is_a_verdict_or_a_message(
        mishaps in prop::collection::vec(mishap(), 1..4),
        events_alone in any::<bool>(),
    ) {
        let (header, events) = GOLDEN.split_at(if events_alone { GOLDEN.find('\n').unwrap() + 1 } else { 0 });
        let mut bytes = events.as_bytes().to_vec();
        for mishap in &mishaps {
            mishap.befall(&mut bytes);
        }
        let bytes = [header.as_bytes(), &bytes].concat();
        match read(GOLDEN, &bytes, Options::default()) {
            Ok(record) => {
                prop_assert!(record.to_the_end);
                prop_assert!(record.verdict.contains("the traces agree") == record.agree);
            }
            Err(error) => prop_assert!(error.to_string().starts_with("b.trace"), "{}", error),
        }
        if let Err(error) = read(&bytes, &bytes, Options::default()) {
            prop_assert!(error.to_string().starts_with("a.trace"), "{}", error);
        }
    }
}
