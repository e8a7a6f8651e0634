//! `crossfibre-simd --time SCENE`: marches a scene and prints how long that took, as a line of JSON.

use std::fs;
use std::time::Instant;

use crossfibre::scene_file;
use crossfibre_simd::state::{FibreState, State};
use crossfibre_simd::{Engine, Vectors};
use serde_json::{Value, json};

type Error = Box<dyn std::error::Error>;

/// What the arguments say.
struct Options {
    scene: String,
    vectors: Option<Vectors>,
    /// Elements ahead of the wavefront are visited, too.
    all: bool,
    repeats: u32,
}

impl Options {
    fn of(mut arguments: impl Iterator<Item = String>) -> Result<Self, Error> {
        let scene = arguments.next().ok_or("--time lacks the file of a scene")?;
        let mut options = Self { scene, vectors: None, all: false, repeats: 1 };
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--all" => options.all = true,
                "--repeat" => {
                    let times = arguments.next().ok_or("--repeat lacks a number")?;
                    options.repeats =
                        times.parse().map_err(|e| format!("--repeat {times}: {e}"))?;
                }
                "--vectors" => {
                    let kind = arguments.next().unwrap_or_default().to_lowercase();
                    let named = |v: &Vectors| format!("{v:?}").to_lowercase() == kind;
                    let found = Vectors::ALL.into_iter().find(named);
                    options.vectors = Some(found.ok_or("--vectors is avx512, avx2 or portable")?);
                }
                other => return Err(format!("--time does not know {other}").into()),
            }
        }
        Ok(options)
    }
}

/// The least time of the march, without reading the scene, and a digest of where it ends.
pub fn timed(arguments: impl Iterator<Item = String>) -> Result<Value, Error> {
    let options = Options::of(arguments)?;
    let text = fs::read_to_string(&options.scene).map_err(|e| format!("{}: {e}", options.scene))?;
    let scene = scene_file::read(&text).map_err(|e| e.to_string())?;
    let mut least = f64::INFINITY;
    let mut made = None;
    for _ in 0..options.repeats.max(1) {
        let mut engine = match options.vectors {
            Some(vectors) => Engine::new_in(&scene, vectors)?,
            None => Engine::new(&scene)?,
        };
        if options.all {
            engine.visit_all();
        }
        let steps = engine.planned_steps();
        let start = Instant::now();
        let outcome = engine.run(steps);
        least = least.min(start.elapsed().as_secs_f64());
        if !outcome.is_completed() {
            return Err(outcome.to_string().into());
        }
        made = Some(engine);
    }
    let engine = made.ok_or("no march was made")?;
    Ok(json!({
        "steps": engine.step(),
        "element_steps": engine.element_steps(),
        "seconds": least,
        "checksum": format!("{:016x}", checksum(&engine.state())),
        "vectors": format!("{:?}", engine.vectors()),
    }))
}

/// FNV-1a over the little-endian bytes of the primary's positions, velocities and strains, then the
/// secondary's, as `candidates/c/march.c` forms it.
fn checksum(state: &State) -> u64 {
    let secondary = state.secondary.iter().flat_map(numbers);
    let bytes = numbers(&state.primary).chain(secondary).flat_map(|x| x.to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

fn numbers<const D: usize>(fibre: &FibreState<D>) -> impl Iterator<Item = &f64> {
    fibre.position.iter().chain(&fibre.velocity).flatten().chain(&fibre.strain)
}
