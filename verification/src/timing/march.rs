//! A turn of the reference: the march of a scene, without reading it and without its balances.

use anyhow::{Result, ensure};
use crossfibre::discretisation::Discretisation;
use crossfibre::number::Number;
use crossfibre::outcome::Outcome;
use crossfibre::paper::Paper;
use crossfibre::result::{WithPaper, with_paper};
use crossfibre::scene::Scene;
use crossfibre::state::{FibreState, State, Wavefront};

use super::{Turn, clocked};
use crate::bits::fnv;
use crate::wide;

/// Marches a scene to its end in the widest vectors, `repeats` times, and takes the least time.
///
/// # Errors
/// A run that does not complete.
pub fn turn<S: Number>(scene: &Scene, wavefront: Wavefront, repeats: u32) -> Result<Turn> {
    with_paper(scene, Wide::<S> { at_impact: State::at_impact(scene, wavefront), scene, repeats })
}

struct Wide<'a, S: Number> {
    at_impact: State<S>,
    scene: &'a Scene,
    repeats: u32,
}

impl<S: Number> WithPaper<S> for Wide<'_, S> {
    type Out = Result<Turn>;

    fn with(self, paper: &impl Paper<S>) -> Result<Turn> {
        let steps = steps(self.scene);
        turn_by(&self.at_impact, self.repeats, |state| wide::march(paper, state, steps, |_| ()))
    }
}

/// Time steps of a scene.
pub fn steps(scene: &Scene) -> u64 {
    Discretisation::<f64>::of(scene).steps(scene.duration)
}

/// The least time of `repeats` marches of one's own.
///
/// # Errors
/// A run that does not complete.
pub fn turn_by<S: Number>(
    at_impact: &State<S>,
    repeats: u32,
    mut march: impl FnMut(&mut State<S>) -> Outcome,
) -> Result<Turn> {
    let mut turn = Turn { seconds: f64::INFINITY, element_steps: 0, checksum: None };
    for _ in 0..repeats {
        let mut state = at_impact.clone();
        let (seconds, outcome) = clocked(|| march(&mut state));
        ensure!(outcome.is_completed(), "{outcome}");
        turn.seconds = turn.seconds.min(seconds);
        turn.element_steps = state.work.elements;
        turn.checksum = checksum(&state);
    }
    Ok(turn)
}

/// FNV-1a over the little-endian bytes of the primary's positions, velocities and strains, then the
/// secondary's: what `candidates/c` forms. None of another number than the double.
pub fn checksum<S: Number>(state: &State<S>) -> Option<u64> {
    let secondary = state.crossover.iter().flat_map(|crossover| numbers(&crossover.fibre));
    let bytes = numbers(&state.primary).chain(secondary).flat_map(|x| x.to_f64().to_le_bytes());
    (std::any::TypeId::of::<S>() == std::any::TypeId::of::<f64>()).then(|| fnv(bytes))
}

fn numbers<S: Number, const D: usize>(fibre: &FibreState<S, D>) -> impl Iterator<Item = S> {
    let vectors = fibre.position.iter().chain(&fibre.velocity).flat_map(|v| v.iter());
    vectors.chain(&fibre.strain).copied()
}

#[cfg(test)]
mod tests {
    use crossfibre::result::{self, FibreResult};

    use super::*;
    use crate::cases::support::shipped;

    #[test]
    fn a_turn_is_the_run_of_the_scene() {
        for name in ["single-400", "unequal"] {
            let scene = shipped(name);
            let run = result::run(&scene, |_| {});
            let fibres: Vec<&FibreResult> =
                [&run.primary].into_iter().chain(&run.secondary).collect();
            let numbers = fibres.iter().flat_map(|fibre| {
                let vectors = fibre.position.iter().chain(&fibre.velocity).flatten();
                vectors.chain(&fibre.strain)
            });
            let turn = turn::<f64>(&scene, Wavefront::Flagged, 2).unwrap();
            assert_eq!(turn.element_steps, run.counts.element_steps, "{name}");
            assert_eq!(turn.checksum, Some(fnv(numbers.flat_map(|x| x.to_le_bytes()))), "{name}");
            assert!(turn.seconds.is_finite());
        }
    }

    #[test]
    fn ahead_of_the_wavefront_there_is_more_work_and_not_another_result() {
        let scene = shipped("single-400");
        let all = turn::<f64>(&scene, Wavefront::Ignored, 1).unwrap();
        let some = turn::<f64>(&scene, Wavefront::Flagged, 1).unwrap();
        assert_eq!(all.element_steps, scene.primary.elements as u64 * steps(&scene));
        assert!(some.element_steps < all.element_steps);
        assert_eq!(all.checksum, some.checksum);
        assert_eq!(turn::<f32>(&scene, Wavefront::Flagged, 1).unwrap().checksum, None);
    }

    #[test]
    fn a_run_that_diverges_has_no_time() {
        let mut scene = shipped("single-400");
        scene.projectile.velocity = 1e200; // its square is infinite
        assert!(turn::<f64>(&scene, Wavefront::Flagged, 1).is_err());
    }
}
