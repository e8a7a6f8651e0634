//! The exact motion of Fig. 3, timed beside the march of the same scene.
//!
//! `cargo bench -p crossfibre-verification --bench exact`
//!
//! Both take turns; a time is the least of all rounds. Only meetings of fronts and ratios mean
//! anything on another machine. Nothing here fails on time.

use std::time::{Duration, Instant};

use crossfibre::exact::fronts::{Fronts, Line, Problem, solved};
use crossfibre::scene::{Scene, Strain};
use crossfibre_verification::cases::support::{measured_by, refined, shipped};
use crossfibre_verification::{closed_form, wide};

const ROUNDS: usize = 15;

/// Times after impact, s.
const TIMES: [f64; 4] = [28.7e-6, 45e-6, 60e-6, 90e-6];

/// Refinements of the paper's mesh.
const MESHES: [usize; 2] = [1, 16];

fn main() {
    for time in TIMES {
        let scene = Scene { duration: time, ..measured_by(Strain::Engineering, shipped("fig3")) };
        let problem: Problem<Line> = closed_form::problem(&scene).map(Line::of);
        let meshes = MESHES.map(|factor| refined(scene.clone(), factor));
        let (mut exact, mut marches) = (Duration::MAX, [Duration::MAX; MESHES.len()]);
        for _ in 0..ROUNDS {
            exact = exact.min(timed(|| solved(&problem, time)));
            for (least, scene) in marches.iter_mut().zip(&meshes) {
                *least = (*least).min(timed(|| wide::run(scene, |_| {})));
            }
        }
        let fronts: Fronts<Line> = solved(&problem, time);
        let ratio = |march: Duration| march.as_secs_f64() / exact.as_secs_f64();
        println!(
            "Fig. 3 at {:5.1} µs: {:5} meetings, resolution {:.0e}, error bound {:.0e}, {:9.1} µs; \
             the march takes {:.2} times that at 2 mm, {:.1} times at 0.125 mm",
            time * 1e6,
            fronts.events(),
            fronts.limits().resolution,
            fronts.error_bound(),
            exact.as_secs_f64() * 1e6,
            ratio(marches[0]),
            ratio(marches[1]),
        );
    }
}

fn timed<T>(work: impl Fn() -> T) -> Duration {
    let start = Instant::now();
    std::hint::black_box(work());
    start.elapsed()
}
