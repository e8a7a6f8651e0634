//! The march of the reference beside the same march in C, Fortran and vectors: who takes how many times
//! as long, and how that grows with the size.
//!
//! `cargo build --release -p crossfibre-simd; cargo bench -p crossfibre-verification --bench side_by_side`
//!
//! What is not there (a compiler, the engine) is left out, and said to be. Nothing fails on time; bits
//! that differ do fail.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};
use crossfibre::corrected::{Corrected, Incremental};
use crossfibre::discretisation::Discretisation;
use crossfibre::double_double::DoubleDouble;
use crossfibre::march;
use crossfibre::number::Number;
use crossfibre::scene::Scene;
use crossfibre::state::{State, Wavefront};
use crossfibre::trace::{Event, Traced};
use crossfibre_verification::cases::support::shipped;
use crossfibre_verification::timing::machine::{Machine, calibration, version};
use crossfibre_verification::timing::march::{steps, turn, turn_by};
use crossfibre_verification::timing::program::{build, contestant, single_fibre};
use crossfibre_verification::timing::table::{growth, side_by_side};
use crossfibre_verification::timing::{Contestant, Timed, same_bits, turns};

const ROUNDS: usize = 9;

/// Elements visited in one turn, in as many runs as that takes.
const WORK: u64 = 4_000_000;

/// Elements and steps of the marches that visit everything: short enough for a run to be left alone
/// now and then on a busy machine.
const SIZES: [(usize, u64); 4] = [(150, 1000), (1000, 1000), (10_000, 100), (100_000, 10)];

fn main() -> Result<()> {
    println!("{}", Machine::here());
    let programs = Programs::here();
    let mut all = Vec::new();
    for (elements, steps) in SIZES {
        let scene = lasting(steps, scene_of(elements));
        println!("\n{elements} elements, {steps} steps, all visited");
        all.push(contest(&scene, Wavefront::Ignored, &programs)?);
    }
    println!("\n1000 elements, 1000 steps, up to the wavefront");
    contest(&lasting(1000, scene_of(1000)), Wavefront::Flagged, &programs)?;
    println!("\ncrossed, 1000 and 700 elements, 1000 steps, all visited");
    contest(&lasting(1000, crossed()), Wavefront::Ignored, &programs)?;
    println!();
    print_growth(&all);
    Ok(())
}

fn scene_of(elements: usize) -> Scene {
    let mut scene = shipped("single-400");
    scene.primary.elements = elements;
    scene
}

fn crossed() -> Scene {
    let mut scene = shipped("unequal");
    scene.primary.elements = 1000;
    if let Some(secondary) = &mut scene.secondary {
        secondary.elements = 700;
    }
    scene
}

fn lasting(steps: u64, scene: Scene) -> Scene {
    let time_step = Discretisation::<f64>::of(&scene).time_step;
    Scene { duration: steps as f64 * time_step, ..scene }
}

/// The programs that there are.
struct Programs {
    c: Option<PathBuf>,
    fortran: Option<PathBuf>,
    engine: Option<PathBuf>,
}

impl Programs {
    /// Builds what is to be built, with the flags of its own Makefile.
    fn here() -> Self {
        let target = Path::new(env!("CARGO_TARGET_TMPDIR"));
        let candidates = Path::new(env!("CARGO_MANIFEST_DIR")).join("../candidates");
        let built = |folder: &str, program: &str, compiler: &str| {
            let into = target.join("side-by-side").join(folder);
            let built = build(&candidates.join(folder), &into, program);
            match (&built, version(Command::new(compiler).arg("--version"))) {
                (Ok(_), version) => println!("{folder}: {}", version.unwrap_or(compiler.into())),
                (Err(reason), _) => println!("{folder}: left out, {reason:#}"),
            }
            built.ok()
        };
        let engine = target.with_file_name("release").join("crossfibre-simd");
        if !engine.is_file() {
            println!("simd: left out, `cargo build --release -p crossfibre-simd` has not been run");
        }
        Self {
            c: built("c", "march", "gcc"),
            fortran: built("fortran", "fibres", "gfortran"),
            engine: engine.is_file().then_some(engine),
        }
    }
}

/// All that can march the scene take turns; prints the table.
fn contest(scene: &Scene, wavefront: Wavefront, programs: &Programs) -> Result<Vec<Timed>> {
    let elements = scene.primary.elements + scene.secondary.as_ref().map_or(0, |s| s.elements);
    let repeats = (WORK / (elements as u64 * steps(scene))).max(1) as u32;
    let mut all = Vec::new();
    if scene.secondary.is_none() {
        all.extend(single_fibre_programs(scene, wavefront, programs, repeats));
    }
    all.extend(reference(scene, wavefront, repeats));
    if let Some(engine) = &programs.engine {
        all.extend(engines(engine, scene, wavefront, repeats)?);
    }
    all.push(calibration());
    let mut timed = turns(ROUNDS, &mut all)?;
    let link = timed.pop().context("the calibration loop took turns, too")?.per_element_step();
    println!("a link of the calibration loop takes {:.3} ns", 1e9 * link);
    print!("{}", side_by_side(&timed, link));
    same_bits(&timed)?;
    Ok(timed)
}

fn single_fibre_programs<'a>(
    scene: &Scene,
    wavefront: Wavefront,
    programs: &Programs,
    repeats: u32,
) -> Vec<Contestant<'a>> {
    let of = |name, program: &Option<PathBuf>, before: &[&str], after: &[&str]| {
        let mut command = Command::new(program.as_ref()?);
        command.args(before);
        single_fibre(&mut command, scene, wavefront, repeats);
        command.args(after);
        Some(contestant(name, command))
    };
    [
        of("C, literal", &programs.c, &[], &[]),
        of("C, keeping the length", &programs.c, &[], &["--keep-length"]),
        of("Fortran, array by array", &programs.fortran, &["--time"], &[]),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn reference(scene: &Scene, wavefront: Wavefront, repeats: u32) -> Vec<Contestant<'_>> {
    let paper = Corrected::<Incremental>::new(scene.corrections);
    let at_impact = State::<f64>::at_impact(scene, wavefront);
    let (baseline, traced) = (at_impact.clone(), at_impact);
    let count = steps(scene);
    // Twenty times as slow, and told apart from the others by far fewer runs.
    let few = repeats.div_ceil(16);
    vec![
        Contestant::new("reference", move || turn::<f64>(scene, wavefront, repeats)),
        Contestant::new("reference, baseline vectors", move || {
            turn_by(&baseline, repeats, |state| march::run(&paper, state, count, |_| ()))
        }),
        Contestant::new("reference, f32", move || turn::<f32>(scene, wavefront, repeats)),
        Contestant::new("reference, double-double", move || {
            turn::<DoubleDouble>(scene, wavefront, few)
        }),
        Contestant::new("reference, traced, events counted", move || {
            turn_by(&traced, few, |state| {
                let mut events = 0_u64;
                let paper = Traced::new(&paper, |_: &Event<'_, f64>| events += 1);
                let outcome = march::run(&paper, state, count, |_| ());
                std::hint::black_box(events);
                outcome
            })
        }),
    ]
}

/// The engine in each kind of vectors that the processor has.
fn engines<'a>(
    engine: &Path,
    scene: &Scene,
    wavefront: Wavefront,
    repeats: u32,
) -> Result<Vec<Contestant<'a>>> {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("side-by-side/scene.json");
    fs::create_dir_all(file.with_file_name(""))?;
    fs::write(&file, serde_json::to_vec(scene)?)?;
    let in_vectors = |vectors: &str| {
        let mut command = Command::new(engine);
        command.arg("--time").arg(&file).args(["--vectors", vectors]);
        command.args((wavefront == Wavefront::Ignored).then_some("--all"));
        command.args(["--repeat".to_owned(), repeats.to_string()]);
        command
    };
    let is_there = |vectors: &&str| match in_vectors(vectors).output() {
        Ok(output) if output.status.success() => Ok(true),
        Ok(output) if String::from_utf8_lossy(&output.stderr).contains("no vectors") => Ok(false),
        other => bail!("{}: {other:?}", engine.display()),
    };
    let mut all = Vec::new();
    for vectors in ["avx512", "avx2", "portable"] {
        if is_there(&vectors)? {
            all.push(contestant(format!("simd, {vectors}"), in_vectors(vectors)));
        }
    }
    Ok(all)
}

fn print_growth(all: &[Vec<Timed>]) {
    let sizes = SIZES.map(|(elements, _)| elements);
    let row = |(who, first): (usize, &Timed)| {
        let each = all.iter().map(|timed| 1e9 * timed[who].per_element_step());
        (first.name.clone(), each.collect())
    };
    let rows: Vec<_> = all[0].iter().enumerate().map(row).collect();
    println!("{}", growth("ns/element-step", &sizes, &rows));
    let rows = [
        ("reference", sizes.map(bytes::<f64>)),
        ("reference, f32", sizes.map(bytes::<f32>)),
        ("reference, double-double", sizes.map(bytes::<DoubleDouble>)),
    ]
    .map(|(name, bytes)| (name.to_owned(), bytes.to_vec()));
    println!("{}", growth("bytes an element", &sizes, &rows));
}

/// What the state of a fibre asks of the heap, for one element.
fn bytes<S: Number>(elements: usize) -> f64 {
    let scene = scene_of(elements);
    let of_all = allocation_counter::measure(|| {
        std::hint::black_box(State::<S>::at_impact(&scene, Wavefront::Ignored));
    });
    of_all.bytes_max as f64 / elements as f64
}
