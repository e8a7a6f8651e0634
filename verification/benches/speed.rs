//! What the reference does in this process: how long it takes, and what memory, by size.
//!
//! `cargo bench -p crossfibre-verification --bench speed [-- NAME]`
//!
//! The rows below a time are what is done in a second (element-steps, events, meetings of fronts) and,
//! where there is any, the memory that the measured part asks for. Nothing fails on time.

#![allow(clippy::unwrap_used)] // a bench may

use std::hint::black_box;
use std::io;
use std::path::Path;
use std::time::Duration;

use crossfibre::corrected::{Corrected, Incremental};
use crossfibre::double_double::DoubleDouble;
use crossfibre::exact::fronts::{Line, Problem, solved};
use crossfibre::march;
use crossfibre::number::Number;
use crossfibre::outcome::Outcome;
use crossfibre::scene::{Scene, Strain};
use crossfibre::scene_file;
use crossfibre::state::{State, Wavefront};
use crossfibre::trace::{Event, Sink, Traced};
use crossfibre::trace_file::{Filter, JsonLines};
use crossfibre_verification::cases::support::{SCENES, measured_by, shipped};
use crossfibre_verification::diff::{Comparison, Options};
use crossfibre_verification::exact_file::ExactFile;
use crossfibre_verification::timing::machine::Machine;
use crossfibre_verification::{closed_form, wide};
use divan::counter::ItemsCount;
use divan::{AllocProfiler, Bencher, Divan};

#[global_allocator]
static ALLOCATOR: AllocProfiler = AllocProfiler::system();

/// Elements of the single fibre.
const SIZES: [usize; 3] = [150, 1000, 10_000];

/// Steps of a march that visits all of them.
const STEPS: u64 = 100;

/// Steps of a march whose events are written, five an element.
const TRACED_STEPS: u64 = 4;

/// Times after impact in Fig. 3, µs.
const MICROSECONDS: [f64; 4] = [28.7, 45.0, 60.0, 90.0];

fn main() {
    println!("{}", Machine::here());
    Divan::default().max_time(Duration::from_secs(1)).config_with_args().main();
}

fn single(elements: usize) -> Scene {
    let mut scene = shipped("single-400");
    scene.primary.elements = elements;
    scene
}

fn paper(scene: &Scene) -> Corrected<Incremental> {
    Corrected::new(scene.corrections)
}

/// A march of all elements, again and again from impact on.
fn marched<S: Number>(
    bencher: Bencher<'_, '_>,
    elements: usize,
    steps: u64,
    march: impl Fn(&mut State<S>) -> Outcome,
) {
    let at_impact = State::<S>::at_impact(&single(elements), Wavefront::Ignored);
    bencher
        .counter(ItemsCount::new(elements as u64 * steps))
        .with_inputs(|| at_impact.clone())
        .bench_local_refs(|state| assert!(march(state).is_completed()));
}

/// The state of a fibre: what a march needs of memory.
#[divan::bench(args = SIZES, types = [f32, f64, DoubleDouble])]
fn at_impact<S: Number>(bencher: Bencher<'_, '_>, elements: usize) {
    let scene = single(elements);
    bencher
        .counter(ItemsCount::new(elements))
        .bench(|| State::<S>::at_impact(&scene, Wavefront::Ignored));
}

/// The literal march in the widest vectors.
#[divan::bench(args = SIZES, types = [f32, f64, DoubleDouble])]
fn march_wide<S: Number>(bencher: Bencher<'_, '_>, elements: usize) {
    let paper = paper(&single(elements));
    marched::<S>(bencher, elements, STEPS, |state| wide::march(&paper, state, STEPS, |_| ()));
}

/// The literal march in the vectors that every processor of its kind has.
#[divan::bench(args = SIZES, types = [f32, f64, DoubleDouble])]
fn march_baseline<S: Number>(bencher: Bencher<'_, '_>, elements: usize) {
    let paper = paper(&single(elements));
    marched::<S>(bencher, elements, STEPS, |state| march::run(&paper, state, STEPS, |_| ()));
}

/// Every event made and none kept.
#[divan::bench(args = SIZES)]
fn march_traced(bencher: Bencher<'_, '_>, elements: usize) {
    let paper = paper(&single(elements));
    marched::<f64>(bencher, elements, STEPS, |state| {
        let traced = Traced::new(&paper, |event: &Event<'_, f64>| {
            black_box(event);
        });
        march::run(&traced, state, STEPS, |_| ())
    });
}

/// Every event written as a line of JSON, into nothing.
#[divan::bench(args = SIZES)]
fn trace_written(bencher: Bencher<'_, '_>, elements: usize) {
    let scene = single(elements);
    marched::<f64>(bencher, elements, TRACED_STEPS, |state| {
        write_trace(&scene, state, io::sink()).1
    });
}

fn write_trace(scene: &Scene, state: &mut State<f64>, to: impl io::Write) -> (u64, Outcome) {
    let paper = paper(scene);
    let mut sink = JsonLines::start::<f64>(to, scene, &paper, Filter::default()).unwrap();
    let traced = Traced::new(&paper, |event: &Event<'_, f64>| sink.event(event));
    let outcome = march::run(&traced, state, TRACED_STEPS, |_| ());
    (sink.finish().unwrap(), outcome)
}

/// Two equal traces compared, from files; an item is a pair of events.
#[divan::bench(args = SIZES)]
fn diff(bencher: Bencher<'_, '_>, elements: usize) {
    let scene = single(elements);
    let mut state = State::at_impact(&scene, Wavefront::Ignored);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("speed");
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join(format!("{elements}.jsonl"));
    let to = io::BufWriter::new(std::fs::File::create(&path).unwrap());
    let (events, _) = write_trace(&scene, &mut state, to);
    bencher.counter(ItemsCount::new(events)).bench_local(|| {
        let mut comparison = Comparison::open(&path, &path, Options::default()).unwrap();
        comparison.run().unwrap();
        assert!(comparison.record().agree);
    });
    std::fs::remove_file(path).unwrap();
}

/// From a scene to the text of its result, as `crossfibre run` does, up to the wavefront.
#[divan::bench(args = SIZES)]
fn run_to_json(bencher: Bencher<'_, '_>, elements: usize) {
    let scene = single(elements);
    let element_steps = wide::run(&scene, |_| ()).counts.element_steps;
    bencher
        .counter(ItemsCount::new(element_steps))
        .bench(|| serde_json::to_string(&wide::run(&scene, |_| ())).unwrap());
}

/// The text of a shipped scene read and checked.
#[divan::bench(args = ["single-400", "fig3", "viscoelastic"])]
fn scene_read(bencher: Bencher<'_, '_>, name: &str) {
    let (_, text) = SCENES.iter().find(|(shipped, _)| *shipped == name).unwrap();
    bencher.bench(|| scene_file::read(black_box(text)).unwrap());
}

fn figure_3(microseconds: f64) -> Scene {
    Scene { duration: 1e-6 * microseconds, ..measured_by(Strain::Engineering, shipped("fig3")) }
}

/// Fig. 3 by exact fronts; an item is a meeting of fronts.
#[divan::bench(args = MICROSECONDS)]
fn exact_fronts(bencher: Bencher<'_, '_>, microseconds: f64) {
    let scene = figure_3(microseconds);
    let problem: Problem<Line> = closed_form::problem(&scene).map(Line::of);
    let meetings = solved(&problem, scene.duration).events();
    bencher.counter(ItemsCount::new(meetings)).bench(|| solved(&problem, scene.duration));
}

/// The same with the law of (4), by polygons of growing fineness, as `crossfibre exact` does.
#[divan::bench(args = MICROSECONDS, sample_count = 5)]
fn exact_converging(microseconds: f64) -> u64 {
    let scene = Scene { strain: Strain::Incremental, ..figure_3(microseconds) };
    ExactFile::of(&scene, scene.duration).0.solution.meetings
}

/// The march of the same scene on the paper's mesh, beside both.
#[divan::bench(args = MICROSECONDS)]
fn exact_beside_march(bencher: Bencher<'_, '_>, microseconds: f64) {
    let scene = figure_3(microseconds);
    let element_steps = wide::run(&scene, |_| ()).counts.element_steps;
    bencher.counter(ItemsCount::new(element_steps)).bench(|| wide::run(&scene, |_| ()));
}
