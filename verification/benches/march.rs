//! The march of a single fibre, timed beside the plain C transcription of the same equations.
//!
//! `cargo bench -p crossfibre-verification --bench march`
//!
//! The C program and the variants of the reference take turns, round after round, so that whatever
//! else the machine does falls on all of them. A time is the least of all rounds; the spread is what
//! the worst round took longer. Nothing here fails on time. Bits that differ do fail.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Instant;

use crossfibre::corrected::{Corrected, Incremental};
use crossfibre::march;
use crossfibre::number::Number;
use crossfibre::outcome::Outcome;
use crossfibre::scene::Scene;
use crossfibre::scene_file;
use crossfibre::state::{FibreState, State, Wavefront};
use crossfibre::trace::{Event, Traced};
use crossfibre_verification::wide;
use serde_json::Value;

const ROUNDS: usize = 9;

/// One fibre and how it is marched.
struct Case {
    elements: usize,
    steps: u64,
    wavefront: Wavefront,
    /// Runs in one turn: some 50 ms together.
    repeats: u32,
}

const CASES: [Case; 3] = [
    Case { elements: 1000, steps: 1000, wavefront: Wavefront::Ignored, repeats: 20 },
    Case { elements: 1000, steps: 1000, wavefront: Wavefront::Flagged, repeats: 40 },
    Case { elements: 100_000, steps: 200, wavefront: Wavefront::Ignored, repeats: 2 },
];

/// Who takes turns.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    CLiteral,
    CKeepingLength,
    Dispatched,
    Baseline,
    Single,
    Traced,
}

impl Way {
    const ALL: [Self; 6] = [
        Self::CLiteral,
        Self::CKeepingLength,
        Self::Dispatched,
        Self::Baseline,
        Self::Single,
        Self::Traced,
    ];

    fn name(self) -> &'static str {
        match self {
            Self::CLiteral => "C, literal",
            Self::CKeepingLength => "C, keeping the length",
            Self::Dispatched => "reference, widest vectors",
            Self::Baseline => "reference, baseline vectors",
            Self::Single => "reference, widest vectors, f32",
            Self::Traced => "reference, traced, events counted",
        }
    }
}

/// The best run of a turn.
#[derive(Clone, Copy, Default)]
struct Turn {
    seconds: f64,
    element_steps: u64,
    checksum: u64,
    events: u64,
}

fn main() -> ExitCode {
    let c_program = build_c();
    if let Err(reason) = &c_program {
        println!("Without the C transcription, the reference alone: {reason}.\n");
    }
    let c_program = c_program.ok();
    match CASES
        .iter()
        .try_for_each(|case| compare(case, c_program.as_deref()))
        .and_then(|()| crossed())
    {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// Builds the C program, with the flags of its own Makefile.
fn build_c() -> Result<PathBuf, String> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../candidates/c");
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
    let mut scene = read(include_str!("../scenes/single-400.json"))?;
    scene.primary.elements = case.elements;
    let mut best = Way::ALL.map(|way| (way, Vec::new()));
    for _ in 0..ROUNDS {
        for (way, turns) in &mut best {
            turns.extend(take_turn(*way, case, &scene, c_program)?);
        }
    }
    print_table(case, &scene, &best)
}

fn take_turn(
    way: Way,
    case: &Case,
    scene: &Scene,
    c: Option<&Path>,
) -> Result<Option<Turn>, String> {
    let paper = Corrected::<Incremental>::new(scene.corrections);
    let steps = case.steps;
    let keeping = way == Way::CKeepingLength;
    Ok(match (way, c) {
        (Way::CLiteral | Way::CKeepingLength, None) => None,
        (Way::CLiteral | Way::CKeepingLength, Some(c)) => Some(run_c(c, case, scene, keeping)?),
        (Way::Dispatched, _) => {
            Some(run::<f64>(case, scene, |s| wide::march(&paper, s, steps, |_| ())))
        }
        (Way::Baseline, _) => {
            Some(run::<f64>(case, scene, |s| march::run(&paper, s, steps, |_| ())))
        }
        (Way::Single, _) => {
            Some(run::<f32>(case, scene, |s| wide::march(&paper, s, steps, |_| ())))
        }
        (Way::Traced, _) => {
            let mut events = 0;
            let once = Case { repeats: 1, ..*case };
            let turn = run::<f64>(&once, scene, |s| {
                let traced = Traced::new(&paper, |_: &Event<'_, f64>| events += 1);
                march::run(&traced, s, steps, |_| ())
            });
            Some(Turn { events, ..turn })
        }
    })
}

/// Marches as often as a turn asks for.
fn run<S: Number>(
    case: &Case,
    scene: &Scene,
    mut march: impl FnMut(&mut State<S>) -> Outcome,
) -> Turn {
    let at_impact = State::<S>::at_impact(scene, case.wavefront);
    let mut turn = Turn { seconds: f64::INFINITY, ..Turn::default() };
    for _ in 0..case.repeats {
        let mut state = at_impact.clone();
        let start = Instant::now();
        let outcome = march(&mut state);
        turn.seconds = turn.seconds.min(start.elapsed().as_secs_f64());
        assert!(outcome.is_completed(), "{outcome}");
        turn.element_steps = state.work.elements;
        turn.checksum = checksum(&state.primary);
    }
    turn
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
    command.args((case.wavefront == Wavefront::Ignored).then_some("--all"));
    command.args(keeping.then_some("--keep-length"));
    let output = command.output().map_err(|e| format!("{}: {e}", program.display()))?;
    let line: Value =
        serde_json::from_slice(&output.stdout).map_err(|e| format!("{command:?}: {e}"))?;
    let read = || {
        Some(Turn {
            seconds: line["seconds"].as_f64()?,
            element_steps: line["element_steps"].as_u64()?,
            checksum: u64::from_str_radix(line["checksum"].as_str()?, 16).ok()?,
            events: 0,
        })
    };
    read().ok_or_else(|| format!("{command:?} says {line}"))
}

/// FNV-1a over positions, velocities and strains, as `candidates/c/march.c` forms it.
fn checksum<S: Number>(fibre: &FibreState<S, 2>) -> u64 {
    let vectors = fibre.position.iter().chain(&fibre.velocity).flat_map(|v| v.iter());
    vectors
        .chain(&fibre.strain)
        .flat_map(|x| x.to_f64().to_le_bytes())
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        })
}

/// Bytes of all vectors of a fibre.
fn memory<S: Number, const D: usize>(fibre: &FibreState<S, D>) -> usize {
    let FibreState { position, velocity, pull, strain, tension, unstrained, .. } = fibre;
    [position, velocity, pull].map(|v| size_of_val(v.as_slice())).iter().sum::<usize>()
        + [strain, tension, unstrained].map(|v| size_of_val(v.as_slice())).iter().sum::<usize>()
}

fn print_table(case: &Case, scene: &Scene, rows: &[(Way, Vec<Turn>)]) -> Result<(), String> {
    let Case { elements, steps, wavefront, .. } = *case;
    let bytes = |bytes| bytes as f64 / elements as f64;
    println!(
        "{elements} elements, {steps} steps, {}; {:.2} bytes an element, in f32 {:.2}",
        match wavefront {
            Wavefront::Ignored => "all visited",
            Wavefront::Flagged => "up to the wavefront",
        },
        bytes(memory(&State::<f64>::at_impact(scene, wavefront).primary)),
        bytes(memory(&State::<f32>::at_impact(scene, wavefront).primary)),
    );
    println!("{:34}  ns/el-step  M el-step/s  speed/C  spread", "");
    let time = |t: &Turn| t.seconds / t.element_steps as f64;
    let least = |turns: &[Turn]| turns.iter().map(time).fold(f64::INFINITY, f64::min);
    let most = |turns: &[Turn]| turns.iter().map(time).fold(0.0, f64::max);
    let literal = rows.iter().find(|(way, _)| *way == Way::CLiteral).map(|(_, t)| least(t));
    for (way, turns) in rows.iter().filter(|(_, turns)| !turns.is_empty()) {
        let t = least(turns);
        let ratio = literal.map_or("-".to_owned(), |c| format!("{:.3}", c / t));
        let spread = 100.0 * (most(turns) / t - 1.0);
        print!(
            "{:34}  {:10.3}  {:11.1}  {ratio:>7}  {spread:5.1} %",
            way.name(),
            1e9 * t,
            1e-6 / t
        );
        match turns.first() {
            Some(turn) if turn.events > 0 => {
                let per_event = t * turn.element_steps as f64 / turn.events as f64;
                println!("  {:.1} M events/s", 1e-6 / per_event);
            }
            _ => println!(),
        }
    }
    println!();
    let mut doubles = rows.iter().filter(|(way, _)| *way != Way::Single).flat_map(|(_, t)| t);
    let expected = doubles.next().map(|t| (t.checksum, t.element_steps));
    if doubles.all(|t| Some((t.checksum, t.element_steps)) == expected) {
        Ok(())
    } else {
        Err("the checksums differ".to_owned())
    }
}

/// The time of a scene with a crossover, for information: there is no C transcription of it.
fn crossed() -> Result<(), String> {
    let mut scene = read(include_str!("../scenes/unequal.json"))?;
    scene.primary.elements = 1000;
    let Some(secondary) = &mut scene.secondary else { return Ok(()) };
    secondary.elements = 700;
    let case = Case { elements: 1000, steps: 1000, wavefront: Wavefront::Ignored, repeats: 10 };
    let paper = Corrected::<Incremental>::new(scene.corrections);
    let mut best = [f64::INFINITY; 2];
    for _ in 0..ROUNDS {
        let wide = run::<f64>(&case, &scene, |s| wide::march(&paper, s, case.steps, |_| ()));
        let plain = run::<f64>(&case, &scene, |s| march::run(&paper, s, case.steps, |_| ()));
        for (best, turn) in best.iter_mut().zip([wide, plain]) {
            *best = best.min(turn.seconds / turn.element_steps as f64);
        }
    }
    let state = State::<f64>::at_impact(&scene, case.wavefront);
    let bytes = state.crossover.map_or(0, |c| memory(&c.fibre)) as f64 / 700.0;
    println!(
        "crossed, 1000 + 700 elements, 1000 steps, all visited; secondary {bytes:.2} bytes an element"
    );
    for (name, t) in ["reference, widest vectors", "reference, baseline vectors"].iter().zip(best) {
        println!("{name:34}  {:10.3}  {:11.1}", 1e9 * t, 1e-6 / t);
    }
    Ok(())
}

fn read(text: &str) -> Result<Scene, String> {
    scene_file::read(text).map_err(|e| e.to_string())
}
