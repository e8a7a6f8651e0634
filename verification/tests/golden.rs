//! The golden vectors: current to the bit, readable by their schema, and not to be written lightly.
//!
//! All comparisons here are of bits or bytes, so there is nothing to tolerate. Run it in both
//! profiles: the same files must hold in both.

#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::fs;
use std::path::Path;

use cli_support::{Ended, crossfibre};
use crossfibre::corrected::{Corrected, Incremental};
use crossfibre::equations::EQUATIONS;
use crossfibre::errata::Corrections;
use crossfibre::number::Vector;
use crossfibre::paper::Paper;
use crossfibre::scene::Scene;
use crossfibre::state::{FibreState, State, Wavefront, Work};
use crossfibre_verification::golden::equations::{self, EquationVector};
use crossfibre_verification::golden::file::{Flag, VectorFile, Vectors};
use crossfibre_verification::golden::steps::{
    FibreRecord, StateRecord, StepVector, WorkRecord, stepped,
};
use crossfibre_verification::golden::{FILES, compare_embedded, embedded};
use serde_json::{Value as Json, json};

/// The stored files that hold vectors: all but the trace.
fn vector_files() -> impl Iterator<Item = (&'static str, String)> {
    FILES.into_iter().zip(embedded().map(Option::unwrap)).take(3)
}

fn steps() -> Vec<StepVector> {
    let text = embedded()[1].clone().unwrap();
    match serde_json::from_str::<VectorFile>(&text).unwrap().into_parts().1 {
        Vectors::Steps(steps) => steps,
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_stored_vectors_are_what_is_computed_to_the_bit() {
    let differences = compare_embedded();
    let shown: Vec<_> = differences.iter().take(10).map(ToString::to_string).collect();
    assert!(differences.is_empty(), "{} differences:\n{}", differences.len(), shown.join("\n"));
}

#[test]
fn a_file_that_is_read_and_written_is_the_same_to_the_byte() {
    for (name, text) in vector_files() {
        let file: VectorFile = serde_json::from_str(&text).unwrap();
        let (provenance, vectors) = file.into_parts();
        assert!(!provenance.reason.is_empty());
        assert!(vectors.text(&provenance) == text, "{name}");
    }
}

#[test]
fn the_files_obey_the_schema_and_a_vector_with_something_more_does_not() {
    let schema = serde_json::to_value(schemars::schema_for!(VectorFile)).unwrap();
    let mut compiler = boon::Compiler::new();
    compiler.add_resource("vectors.json", schema).unwrap();
    let mut schemas = boon::Schemas::new();
    let schema = compiler.compile("vectors.json", &mut schemas).unwrap();
    for (name, text) in vector_files() {
        let mut json: Json = serde_json::from_str(&text).unwrap();
        schemas.validate(&json, schema).unwrap_or_else(|error| panic!("{name}: {error:#}"));
        json["vectors"][1]["more"] = json!(0.37);
        assert!(schemas.validate(&json, schema).is_err(), "{name}");
    }
}

#[test]
fn printed_and_corrected_vectors_differ_in_the_equations_that_the_edition_words_otherwise() {
    let paper = Corrected::<Incremental>::new(Corrections::ALL);
    let vectors = equations::vectors();
    let outputs = |number: u8, flag: Flag| -> Vec<_> {
        let chosen = |v: &&EquationVector| {
            v.eq == number.to_string()
                && v.flags.contains(&flag)
                && v.flags.contains(&Flag::Awkward)
                && !v.flags.contains(&Flag::Engineering)
        };
        vectors.iter().filter(chosen).map(|v| (&v.inputs, &v.out)).collect()
    };
    for equation in EQUATIONS {
        let [printed, corrected] =
            [Flag::Printed, Flag::Corrected].map(|flag| outputs(equation.number, flag));
        let reworded = Paper::<f64>::lines(&paper, equation) != equation.lines;
        assert_eq!(printed != corrected, reworded, "({})", equation.number);
        // (14) has no inputs, so one vector says it all.
        assert!(printed.len() >= if equation.number == 14 { 1 } else { 6 });
    }
}

/// A fibre with a record's numbers in place of its own.
fn put_back<const D: usize>(record: &FibreRecord, fibre: &mut FibreState<f64, D>) {
    let vectors = |rows: &[Vec<f64>]| {
        rows.iter().map(|row| Vector::<f64, D>::from_column_slice(row)).collect::<Vec<_>>()
    };
    fibre.position = vectors(&record.position);
    fibre.velocity = vectors(&record.velocity);
    fibre.pull = vectors(&record.pull);
    fibre.strain = record.strain.clone();
    fibre.tension = record.tension.clone();
    fibre.visited = record.visited;
}

/// The state of a record.
fn state_of(scene: &Scene, record: &StateRecord) -> State<f64> {
    let mut state = State::at_impact(scene, Wavefront::Flagged);
    state.step = record.step;
    put_back(&record.primary, &mut state.primary);
    if let Some(crossover) = &mut state.crossover {
        put_back(record.secondary.as_ref().unwrap(), &mut crossover.fibre);
        let at = record.crossover.as_ref().unwrap();
        (crossover.node, crossover.moves) = (at.node, at.moves);
    }
    state.projectile.velocity = record.projectile_velocity;
    state.accounts.drive_impulse = record.accounts.drive_impulse;
    state.accounts.clamp_impulse = record.accounts.clamp_impulse;
    state.accounts.drive_work = record.accounts.drive_work;
    let WorkRecord { elements, clamped, pushes, drives, secondary, projectile } = record.work;
    state.work = Work { elements, clamped, pushes, drives, secondary, projectile };
    state
}

/// A solver that is given a record needs nothing else to make the step.
#[test]
fn a_record_holds_all_that_a_step_reads() {
    for vector in steps() {
        let before = state_of(&vector.scene, &vector.before);
        let after = StateRecord::of(&stepped(&vector.scene, before, 1));
        // Numbers, not bits: that the bits agree is the first test's.
        assert_eq!(after, vector.after, "{}", vector.id);
    }
}

#[test]
fn a_step_shows_what_its_name_says() {
    let all = steps();
    let step = |id: &str| all.iter().find(|vector| vector.id == id).unwrap();
    let moves = |record: &StateRecord| record.crossover.as_ref().unwrap().moves;
    let moved = step("crossover-node-moves");
    assert_eq!(moves(&moved.after), moves(&moved.before) + 1);
    let early = step("front-not-at-crossover");
    assert!(early.after.secondary.as_ref().unwrap().strain.iter().all(|&strain| strain == 0.0));
    assert!(early.after.primary.visited < early.after.primary.strain.len());
    for id in ["crossed-fibres", "engineering-strain", "printed", "crossover-node-moves"] {
        let strains = &step(id).before.secondary.as_ref().unwrap().strain;
        assert!(strains.iter().all(|&strain| strain > 0.0), "{id}");
    }
    let origin = step("both-at-origin");
    assert_eq!(origin.after.crossover.as_ref().unwrap().node, 0);
    let slowed = step("finite-projectile");
    assert!(slowed.after.projectile_velocity < slowed.before.projectile_velocity);
    assert!(step("printed").flags == [Flag::Printed]);
    assert!(step("engineering-strain").flags == [Flag::Corrected, Flag::Engineering]);
}

#[test]
fn the_golden_trace_is_what_the_command_writes() {
    let trace = embedded()[3].clone().unwrap();
    let header: Json = serde_json::from_str(trace.lines().next().unwrap()).unwrap();
    let scene = tempfile::NamedTempFile::new().unwrap();
    fs::write(scene.path(), header["scene"].to_string()).unwrap();
    let path = scene.path().to_str().unwrap();
    let traced = crossfibre(Path::new("."), &["trace", "--step", "1..4", path]);
    assert_eq!(traced.code, 0, "{}", traced.stderr);
    assert!(traced.stdout == trace);
}

/// A folder with copies of the stored files.
fn copies() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in FILES.iter().zip(embedded()) {
        fs::write(folder.path().join(name), text.unwrap()).unwrap();
    }
    folder
}

/// `crossfibre vectors` on a folder.
fn vectors(folder: &Path, arguments: &[&str]) -> Ended {
    let dir = folder.to_str().unwrap();
    crossfibre(Path::new("."), &[&["vectors", "--dir", dir], arguments].concat())
}

#[test]
fn vectors_that_are_current_are_said_to_be_and_not_written_again() {
    let folder = copies();
    for arguments in [&[][..], &["--check"], &["--bless", "--reason", "none at all"]] {
        let Ended { code, stdout, .. } = vectors(folder.path(), arguments);
        assert_eq!(code, 0, "{stdout}");
        assert!(stdout.contains("the same to the bit"), "{stdout}");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), FILES.len());
}

#[test]
fn a_changed_bit_is_found_and_named() {
    let folder = copies();
    let path = folder.path().join("steps.json");
    let mut json: Json = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
    let list = json["vectors"].as_array_mut().unwrap();
    let vector = list.iter_mut().find(|vector| vector["id"] == "single-fibre").unwrap();
    let strain = &mut vector["after"]["primary"]["strain"][3];
    let computed = strain.as_f64().unwrap();
    let changed = f64::from_bits(computed.to_bits() ^ 1);
    *strain = json!(changed);
    fs::write(&path, json.to_string()).unwrap();

    let found = vectors(folder.path(), &[]);
    assert_eq!(found.code, 2);
    let expected = format!(
        "steps.json, single-fibre, after.primary.strain[3]: expected {changed:?}, found \
         {computed:?}, 1 ULP apart\n1 differences in 1 vectors\n"
    );
    assert_eq!(found.stdout, expected);
}

#[test]
fn ten_differences_are_told_and_the_others_counted() {
    for (changed, counted) in [(10, None), (11, Some("… and 1 more"))] {
        let folder = copies();
        let path = folder.path().join("steps.json");
        let mut json: Json = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        let list = json["vectors"].as_array_mut().unwrap();
        let vector = list.iter_mut().find(|vector| vector["id"] == "crossover-node-moves").unwrap();
        let strain = vector["after"]["primary"]["strain"].as_array_mut().unwrap();
        for strain in &mut strain[..changed] {
            *strain = json!(f64::from_bits(strain.as_f64().unwrap().to_bits() ^ 1));
        }
        fs::write(&path, json.to_string()).unwrap();

        let found = vectors(folder.path(), &[]).stdout;
        let told = found.lines().filter(|line| line.starts_with("steps.json, ")).count();
        let more = found.lines().find(|line| line.starts_with('…'));
        assert_eq!((told, more), (10, counted), "{found}");
        assert!(found.ends_with(&format!("\n{changed} differences in 1 vectors\n")), "{found}");
    }
}

#[test]
fn a_file_that_is_not_there_and_one_that_is_no_json_are_differences() {
    let folder = copies();
    fs::remove_file(folder.path().join("runs.json")).unwrap();
    fs::write(folder.path().join("equations.json"), "{").unwrap();
    let Ended { code, stdout: out, .. } = vectors(folder.path(), &[]);
    assert_eq!(code, 2);
    assert!(out.starts_with("equations.json: expected JSON, found EOF"), "{out}");
    assert!(out.contains("runs.json: expected a file, found none"), "{out}");
}

#[test]
fn blessing_wants_a_reason_and_a_folder() {
    let folder = copies();
    let trace = folder.path().join("trace.jsonl");
    fs::write(&trace, "{}").unwrap();
    for arguments in [&["--bless"][..], &["--bless", "--reason", " \t"], &["--reason", "why not"]] {
        let Ended { code, stderr: error, .. } = vectors(folder.path(), arguments);
        assert_eq!(code, 1, "{arguments:?}");
        assert!(error.contains("--reason") || error.contains("--bless"), "{error}");
    }
    assert_eq!(fs::read_to_string(&trace).unwrap(), "{}");
    let missing = folder.path().join("elsewhere");
    let Ended { code, stderr: error, .. } = vectors(&missing, &[]);
    assert_eq!(code, 1);
    assert!(error.contains("there is no such folder") && error.contains("--dir"), "{error}");
}
