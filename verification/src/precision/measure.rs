//! Measures what the runs of the study take on this machine.

use std::env;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, ensure};
use crossfibre::double_double::DoubleDouble;
use crossfibre::exact::elastic::Hyperelastic;
use crossfibre::exact::fronts::{Fronts, Limits, Line, Problem as Strings};
use crossfibre::number::Number;
use crossfibre::paper::Paper;
use crossfibre::result::{WithPaper, with_paper};
use crossfibre::scene::{Scene, Strain};
use indicatif::ProgressBar;

use super::exact::Exact;
use super::problems::Problem;
use super::record::{Entry, Record};
use super::run::{Run, at_impact};
use super::times::{ENGINE, FORMAT, Seconds, TimedExact, TimedRun, Times};
use super::variants::{Precision, Variant};
use super::{VARIANTS, run_of};
use crate::closed_form;
use crate::cost::instructions::{has_callgrind, instructions};
use crate::interrupt::Scratch;
use crate::oracle::motion;
use crate::timing::machine::{Machine, calibration};
use crate::timing::{Contestant, Timed, Turn, clocked, march, program, turns};
use crate::wide;

/// Element-steps of the longest run that takes part in turns.
const LONGEST: u64 = 60_000_000;

/// About how many times as long 106 bits take.
const DOUBLE_DOUBLE: u64 = 50;

/// Refinements at which instructions are counted: under callgrind a run takes fifty times as long.
const COUNTED: [f64; 2] = [1.0, 4.0];

/// Resolutions of the exact fronts, from a few fronts to all that count.
const RESOLUTIONS: [f64; 6] = [1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10];

/// The duration of what has as good as no steps, over the duration.
const NO_STEPS: f64 = 1e-9;

/// How much is measured.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// How often each is run.
    pub rounds: usize,
    /// Whether instructions are counted, where callgrind is there.
    pub instructions: bool,
}

/// Measures every run of the record that completed and is not too long, and the exact solutions; says
/// in words what could not be measured.
pub fn times(record: &Record, effort: Effort) -> Result<(Times, Vec<String>)> {
    let mut notes = Vec::new();
    let engine = engine();
    if engine.is_none() {
        notes.push(
            "the engine in vectors is not there: `cargo build --release -p crossfibre-simd` makes it"
                .into(),
        );
    }
    let counted = effort.instructions && has_callgrind();
    if effort.instructions && !counted {
        notes.push("valgrind is not there: no instructions are counted".into());
    }
    let folder = Scratch::new().context("no folder for scenes can be made")?;
    let loops = turns(effort.rounds, &mut [calibration()])?;
    let bar = ProgressBar::new(2 * Problem::ALL.len() as u64);
    let (mut runs, mut exact) = (Vec::new(), Vec::new());
    for problem in Problem::ALL {
        let taken = marches(record, problem, engine.as_ref(), &folder)?;
        let (who, mut contestants): (Vec<_>, Vec<_>) = taken.into_iter().unzip();
        let timed = turns(effort.rounds, &mut contestants)?;
        for (who, timed) in who.into_iter().zip(&timed) {
            let Some(entry) = record.series(problem, who.variant.name).get(who.mesh).copied()
            else {
                continue;
            };
            let instructions = if counted { who.instructions(problem, entry)? } else { None };
            runs.push(TimedRun {
                problem,
                contestant: who.name(),
                elements: entry.elements,
                seconds: seconds(timed),
                instructions,
            });
        }
        bar.inc(1);
        exact.extend(solutions(problem, effort.rounds)?);
        bar.inc(1);
    }
    bar.finish_and_clear();
    let times = Times {
        format: FORMAT.into(),
        machine: Machine::here().to_string(),
        calibration: seconds(&loops[0]),
        rounds: effort.rounds,
        runs,
        exact,
    };
    Ok((times, notes))
}

fn seconds(timed: &Timed) -> Seconds {
    Seconds { least: timed.least, median: timed.median, greatest: timed.greatest }
}

/// The engine's program, if it was built beside this one.
fn engine() -> Option<PathBuf> {
    let beside = env::current_exe().ok()?.with_file_name("crossfibre-simd");
    [beside.with_extension(""), beside.with_extension("exe")]
        .into_iter()
        .find(|file| file.is_file())
}

/// Who marches, on which mesh of the series.
struct Who {
    variant: Variant,
    mesh: usize,
    by_engine: bool,
}

impl Who {
    fn name(&self) -> String {
        if self.by_engine { ENGINE.into() } else { self.variant.name.into() }
    }

    /// Instructions of the march alone, where a command makes it: those of the run, less those of a run
    /// of one step.
    fn instructions(&self, problem: Problem, entry: &Entry) -> Result<Option<f64>> {
        let by_command = self.variant.precision == Precision::Double && self.variant.flagged;
        let is_counted = COUNTED.contains(&entry.refinement);
        if !by_command || !is_counted || problem.is_pulled_along() || self.by_engine {
            return Ok(None);
        }
        let program = env::current_exe()?;
        let scene = run_of(problem, &self.variant, entry.refinement).scene;
        let once = Scene { duration: NO_STEPS * scene.duration, ..scene.clone() };
        let count = |scene| instructions(&program, &["run", "--quiet"], scene);
        Ok(Some(count(&scene)? - count(&once)?))
    }
}

/// Everyone who marches a problem.
fn marches<'a>(
    record: &Record,
    problem: Problem,
    engine: Option<&PathBuf>,
    folder: &Scratch,
) -> Result<Vec<(Who, Contestant<'a>)>> {
    let mut all = Vec::new();
    for variant in VARIANTS {
        for (mesh, entry) in record.series(problem, variant.name).into_iter().enumerate() {
            let longest = match variant.precision {
                Precision::DoubleDouble => LONGEST / DOUBLE_DOUBLE,
                _ => LONGEST,
            };
            if !entry.found.outcome.is_completed() || entry.found.element_steps > longest {
                continue;
            }
            let run = run_of(problem, &variant, entry.refinement);
            let is_engines = variant == VARIANTS[0] && !problem.is_pulled_along();
            if let Some(program) = engine.filter(|_| is_engines) {
                let file = folder.path().join(format!("{}-{mesh}.json", problem.id()));
                std::fs::write(&file, serde_json::to_vec(&run.scene)?)?;
                let mut command = Command::new(program);
                command.arg("--time").arg(&file);
                let who = Who { variant, mesh, by_engine: true };
                all.push((who, program::contestant(ENGINE, command)));
            }
            let who = Who { variant, mesh, by_engine: false };
            all.push((who, Contestant::new(variant.name, move || turn(&run))));
        }
    }
    Ok(all)
}

/// One march.
fn turn(run: &Run) -> Result<Turn> {
    match run.precision {
        Precision::Single => turn_in::<f32>(run),
        Precision::Double => turn_in::<f64>(run),
        Precision::DoubleDouble => turn_in::<DoubleDouble>(run),
    }
}

fn turn_in<S: Number>(run: &Run) -> Result<Turn> {
    struct March<'a>(&'a Run);
    impl<S: Number> WithPaper<S> for March<'_> {
        type Out = Result<Turn>;
        fn with(self, paper: &impl Paper<S>) -> Self::Out {
            let (state, steps) = at_impact::<S>(self.0);
            march::turn_by(&state, 1, |state| wide::march(paper, state, steps, |_| ()))
        }
    }
    with_paper::<S, _>(&run.scene, March(run))
}

/// The exact solutions of a problem: fronts of the engineering law at every resolution, and the
/// converging solution of the logarithmic law.
fn solutions(problem: Problem, rounds: usize) -> Result<Vec<TimedExact>> {
    if problem.is_pulled_along() {
        return Ok(Vec::new());
    }
    let variant = |strain| VARIANTS.into_iter().find(|v| v.strain == strain).unwrap_or(VARIANTS[0]);
    let mut all = Vec::new();
    let scene = run_of(problem, &variant(Strain::Engineering), 1.0).scene;
    let strings: Strings<Line> = closed_form::problem(&scene).map(Line::of);
    for resolution in RESOLUTIONS {
        let solve = || {
            let mut fronts = Fronts::new(&strings, Limits { resolution, events: 100_000 });
            // An early end is kept in the fronts.
            let _ = fronts.advance(scene.duration);
            fronts
        };
        let solved = solve();
        let is_new = all.last().is_none_or(|last: &TimedExact| last.meetings < solved.events());
        if solved.ended().is_none() && is_new {
            let error_bound = relative(&scene, solved.error_bound())?;
            let of = (problem, Strain::Engineering, resolution, solved.events(), error_bound);
            all.push(timed_exact(of, rounds, || drop(std::hint::black_box(solve())))?);
        }
    }
    let scene = run_of(problem, &variant(Strain::Incremental), 1.0).scene;
    let strings: Strings<Hyperelastic> = closed_form::problem(&scene);
    let solve = || motion(&strings, None, scene.duration);
    let solved = solve();
    ensure!(solved.ended.is_none(), "the exact motion of {} ends early", problem.id());
    let error_bound = relative(&scene, solved.error_bound)?;
    let of = (problem, Strain::Incremental, solved.resolution, solved.events, error_bound);
    all.push(timed_exact(of, rounds, || drop(std::hint::black_box(solve())))?);
    Ok(all)
}

/// A mean error of strain over the mean strain of the primary.
fn relative(scene: &Scene, error: f64) -> Result<f64> {
    let run = Run {
        scene: scene.clone(),
        pulled_along: false,
        precision: Precision::Double,
        flagged: true,
    };
    let exact = Exact::of(&run, scene.duration).map_err(anyhow::Error::msg)?;
    let mean = super::exact::integral(&exact.primary) / scene.primary.length;
    Ok(error / mean)
}

fn timed_exact(
    (problem, strain, resolution, meetings, error_bound): (Problem, Strain, f64, u64, f64),
    rounds: usize,
    solve: impl Fn(),
) -> Result<TimedExact> {
    let turn = || Ok(Turn { seconds: clocked(&solve).0, element_steps: 0, checksum: None });
    let timed = turns(rounds, &mut [Contestant::new("exact fronts", turn)])?;
    Ok(TimedExact {
        problem,
        strain,
        resolution,
        meetings,
        error_bound,
        seconds: seconds(&timed[0]),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::precision::stored::stored;

    /// Of an earlier run, on a machine that had the engine.
    fn stored_times() -> Times {
        Times::parse(include_str!("../../../docs/work-precision/times.json")).unwrap()
    }

    #[test]
    fn those_who_march_are_those_of_the_stored_times() {
        let times = stored_times();
        let (folder, engine) = (Scratch::new().unwrap(), PathBuf::from("engine"));
        for problem in Problem::ALL {
            let timed = times.runs.iter().filter(|run| run.problem == problem);
            let timed: Vec<_> = timed.map(|run| (run.contestant.clone(), run.elements)).collect();
            let all = marches(stored(), problem, Some(&engine), &folder).unwrap();
            let found = all.iter().map(|(who, contestant)| {
                assert_eq!(who.name(), contestant.name);
                let series = stored().series(problem, who.variant.name);
                (who.name(), series[who.mesh].elements)
            });
            assert_eq!(found.collect::<Vec<_>>(), timed, "{problem:?}");
        }
    }

    /// The coarsest mesh of each variant, and all exact solutions, against the stored times of the same.
    #[test]
    fn what_is_timed_is_what_was_timed_for_the_stored_times() {
        let mut record = stored().clone();
        record.entries.retain(|entry| entry.refinement < 0.3);
        let effort = Effort { rounds: 1, instructions: false };
        let (times, notes) = times(&record, effort).unwrap();
        let stored = stored_times();
        assert_eq!(notes.len(), usize::from(engine().is_none()), "{notes:?}");
        assert_eq!((times.format.as_str(), times.rounds), (FORMAT, 1));
        assert!(times.calibration.least > 0.0 && !times.machine.is_empty());

        let meshes = record.entries.iter().map(|entry| (entry.problem, entry.elements));
        let meshes: Vec<_> = meshes.collect();
        let runs = |of: &Times| {
            let own = |run: &&TimedRun| {
                run.contestant != ENGINE && meshes.contains(&(run.problem, run.elements))
            };
            let what = |run: &TimedRun| (run.problem, run.contestant.clone(), run.elements);
            of.runs.iter().filter(own).map(what).collect::<Vec<_>>()
        };
        assert_eq!(runs(&times), runs(&stored));
        for run in &times.runs {
            let Seconds { least, median, greatest } = run.seconds;
            assert!(0.0 < least && least <= median && median <= greatest, "{run:?}");
            assert_eq!(run.instructions, None);
        }

        let exact = |of: &Times| {
            let what = |e: &TimedExact| (e.problem, e.strain, e.resolution, e.meetings);
            of.exact.iter().map(what).collect::<Vec<_>>()
        };
        assert_eq!(exact(&times), exact(&stored));
        for (found, known) in times.exact.iter().zip(&stored.exact) {
            // Below 1e-15 it is rounding.
            let apart = (found.error_bound - known.error_bound).abs();
            assert!(apart <= 1e-9 * known.error_bound + 1e-15, "{found:?} {known:?}");
            assert!(found.seconds.least > 0.0, "{found:?}");
        }
    }

    /// A number that the command does not know, a march without flags, a pull along the fibre, another
    /// program, and a mesh that takes too long.
    #[test]
    fn instructions_are_counted_of_what_the_command_runs_on_two_meshes_only() {
        let uncounted = |problem, name, refinement, by_engine| {
            let series = stored().series(problem, name);
            let mesh = series.iter().position(|entry| entry.refinement == refinement).unwrap();
            let who = Who { variant: Variant::named(name), mesh, by_engine };
            let found = who.instructions(problem, series[mesh]).unwrap();
            assert_eq!(found, None, "{problem:?} {name} {refinement}");
        };
        uncounted(Problem::Single, "eqn (4), α = 1, f32", 1.0, false);
        uncounted(Problem::Single, "eqn (4), α = 1, no flags", 1.0, false);
        uncounted(Problem::Rod, "eqn (4), α = 1", 1.0, false);
        uncounted(Problem::Single, "eqn (4), α = 1", 1.0, true);
        uncounted(Problem::Single, "eqn (4), α = 1", 2.0, false);
    }
}
