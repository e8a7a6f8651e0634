//! The engine, timed beside the plain C transcription of the same equations.
//!
//! `cargo bench -p crossfibre-simd`
//!
//! The C program and the engine take turns, round after round, so that whatever else the machine does
//! falls on all of them. A time is the least of all rounds; the spread is what the worst round took
//! longer. Beside them stands what the machine's divider allows, measured in the same rounds. Nothing
//! here fails on time. Bits that differ do fail.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Instant;

use crossfibre::corrected::{Corrected, Incremental};
use crossfibre::march;
use crossfibre::scene::Scene;
use crossfibre::scene_file;
use crossfibre::state::{State as Reference, Wavefront};
use crossfibre_simd::{Engine, Vectors};
use serde_json::Value;

#[cfg(target_arch = "x86_64")]
mod floor;

const ROUNDS: usize = 9;

/// One fibre and how it is marched.
struct Case {
    elements: usize,
    steps: u64,
    /// Engine and C visit all elements from the first step on.
    all: bool,
    /// Runs in one turn: some 50 ms together.
    repeats: u32,
}

const CASES: [Case; 4] = [
    Case { elements: 150, steps: 1000, all: true, repeats: 100 },
    Case { elements: 1000, steps: 1000, all: true, repeats: 20 },
    Case { elements: 1000, steps: 1000, all: false, repeats: 40 },
    Case { elements: 100_000, steps: 200, all: true, repeats: 2 },
];

/// Who takes turns.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    CLiteral,
    CKeepingLength,
    Engine(Vectors),
}

impl Way {
    const ALL: [Self; 5] = [
        Self::CLiteral,
        Self::CKeepingLength,
        Self::Engine(Vectors::Avx512),
        Self::Engine(Vectors::Avx2),
        Self::Engine(Vectors::Portable),
    ];

    fn name(self) -> &'static str {
        match self {
            Self::CLiteral => "C, literal",
            Self::CKeepingLength => "C, keeping the length",
            Self::Engine(Vectors::Avx512) => "engine, AVX-512",
            Self::Engine(Vectors::Avx2) => "engine, AVX2",
            Self::Engine(Vectors::Portable) => "engine, portable",
        }
    }
}

/// The best run of a turn.
#[derive(Clone, Copy, Default)]
struct Turn {
    seconds: f64,
    element_steps: u64,
    checksum: u64,
}

fn main() -> ExitCode {
    let c_program = build_c();
    if let Err(reason) = &c_program {
        println!("Without the C transcription, the engine alone: {reason}.\n");
    }
    let c_program = c_program.ok();
    #[cfg(target_arch = "x86_64")]
    floor::print();
    match CASES.iter().try_for_each(|case| compare(case, c_program.as_deref())) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// Builds the C program, with the flags of its own Makefile.
fn build_c() -> Result<PathBuf, String> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../c");
    let target = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let made = Command::new("make")
        .args(["--always-make".as_ref(), "-C".as_ref(), target.as_os_str()])
        .args(["-f".as_ref(), source.join("Makefile").as_os_str()])
        .args([format!("VPATH={}", source.display()), "march".to_owned()])
        .output()
        .map_err(|e| format!("make cannot be started ({e})"))?;
    if made.status.success() {
        Ok(target.join("march"))
    } else {
        Err(format!("it does not build: {}", String::from_utf8_lossy(&made.stderr).trim()))
    }
}

/// All take turns at a case; prints the table.
fn compare(case: &Case, c_program: Option<&Path>) -> Result<(), String> {
    let mut scene = scene_file::read(include_str!("../../../verification/scenes/single-400.json"))
        .map_err(|e| e.to_string())?;
    scene.primary.elements = case.elements;
    let expected = reference(case, &scene);
    let mut turns = Way::ALL.map(|way| (way, Vec::new()));
    for _ in 0..ROUNDS {
        for (way, turns) in &mut turns {
            turns.extend(match (*way, c_program) {
                (Way::Engine(vectors), _) => run_engine(case, &scene, vectors),
                (_, None) => None,
                (way, Some(c)) => Some(run_c(c, case, &scene, way == Way::CKeepingLength)?),
            });
        }
    }
    print_table(case, &turns);
    let differs = |turn: &&Turn| turn.checksum != expected;
    match turns.iter().find(|(_, turns)| turns.iter().any(|turn| differs(&turn))) {
        Some((way, _)) => Err(format!("the checksum of {} is not the reference's", way.name())),
        None => Ok(()),
    }
}

/// The reference's checksum.
fn reference(case: &Case, scene: &Scene) -> u64 {
    let mut state = Reference::<f64>::at_impact(scene, Wavefront::Flagged);
    let paper = Corrected::<Incremental>::new(scene.corrections);
    march::run(&paper, &mut state, case.steps, |_| ());
    let fibre = &state.primary;
    let vectors = fibre.position.iter().chain(&fibre.velocity).flat_map(|v| v.iter());
    checksum(vectors.chain(&fibre.strain))
}

/// None where the processor has no such vectors.
fn run_engine(case: &Case, scene: &Scene, vectors: Vectors) -> Option<Turn> {
    let mut turn = Turn { seconds: f64::INFINITY, ..Turn::default() };
    for _ in 0..case.repeats {
        let mut engine = Engine::new_in(scene, vectors).ok()?;
        if case.all {
            engine.visit_all();
        }
        let start = Instant::now();
        let outcome = engine.run(case.steps);
        turn.seconds = turn.seconds.min(start.elapsed().as_secs_f64());
        assert!(outcome.is_completed(), "{outcome}");
        turn.element_steps = engine.element_steps();
        let fibre = engine.state().primary;
        let vectors = fibre.position.iter().chain(&fibre.velocity).flatten();
        turn.checksum = checksum(vectors.chain(&fibre.strain));
    }
    Some(turn)
}

fn run_c(program: &Path, case: &Case, scene: &Scene, keeping: bool) -> Result<Turn, String> {
    let p = &scene.primary;
    let numbers = [
        ("--length", p.length),
        ("--density", p.density),
        ("--area", p.area),
        ("--modulus", p.material.instantaneous_modulus()),
        ("--velocity", scene.projectile.velocity),
        ("--courant", scene.courant),
        ("--elements", case.elements as f64),
        ("--steps", case.steps as f64),
        ("--repeat", f64::from(case.repeats)),
    ];
    let mut command = Command::new(program);
    command.args(numbers.iter().flat_map(|(name, value)| [(*name).to_owned(), value.to_string()]));
    command.args(case.all.then_some("--all"));
    command.args(keeping.then_some("--keep-length"));
    let output = command.output().map_err(|e| format!("{}: {e}", program.display()))?;
    let line: Value =
        serde_json::from_slice(&output.stdout).map_err(|e| format!("{command:?}: {e}"))?;
    let read = || {
        Some(Turn {
            seconds: line["seconds"].as_f64()?,
            element_steps: line["element_steps"].as_u64()?,
            checksum: u64::from_str_radix(line["checksum"].as_str()?, 16).ok()?,
        })
    };
    read().ok_or_else(|| format!("{command:?} says {line}"))
}

/// FNV-1a over the little-endian bytes, as `candidates/c/march.c` forms it.
fn checksum<'a>(numbers: impl Iterator<Item = &'a f64>) -> u64 {
    numbers.flat_map(|x| x.to_le_bytes()).fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

fn print_table(case: &Case, rows: &[(Way, Vec<Turn>)]) {
    let visited = if case.all { "all visited" } else { "up to the wavefront" };
    println!("\n{} elements, {} steps, {visited}", case.elements, case.steps);
    println!("{:24}  ns/el-step  M el-step/s  speed/C  spread", "");
    let time = |t: &Turn| t.seconds / t.element_steps as f64;
    let least = |turns: &[Turn]| turns.iter().map(time).fold(f64::INFINITY, f64::min);
    let literal = rows.iter().find(|(way, _)| *way == Way::CLiteral).map(|(_, t)| least(t));
    for (way, turns) in rows.iter().filter(|(_, turns)| !turns.is_empty()) {
        let t = least(turns);
        let most = turns.iter().map(time).fold(0.0, f64::max);
        println!(
            "{:24}  {:10.3}  {:11.1}  {:7.3}  {:5.1} %",
            way.name(),
            1e9 * t,
            1e-6 / t,
            literal.unwrap_or(f64::NAN) / t,
            100.0 * (most / t - 1.0)
        );
    }
}
