//! Faults that can be planted in any part of the program, so that its checks can be shown to fail.
//!
//! [`plant`] puts one in, once for the whole process; nothing takes it out again. What the checks of
//! `verify` march, solve and read goes through the functions here and in [`crate::oracle`], which
//! do what is right as long as nothing is planted. The commands that users call never plant.
//!
//! | part | what is planted | where it comes in |
//! |---|---|---|
//! | equations | [`crate::faulty`] | [`with_paper`], [`edition()`] |
//! | march | [`march`] | [`march::run`], [`march::step`], [`march::wide`] |
//! | materials | [`material`] | [`at_impact`], [`check`] |
//! | exact solutions | [`exact`] | [`crate::oracle`] |
//! | stored record | [`record`] | [`crate::precision::stored`] |

/// A name for each fault of a part, and what it does instead.
macro_rules! faults {
    ($($(#[$note:meta])* $name:ident $id:literal $what:literal;)*) => {
        /// The faults by name.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[allow(missing_docs)] // the list says what each is
        pub enum Wrong {
            $($(#[$note])* $name),*
        }

        impl Wrong {
            /// All.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// Its name for `verify --plant`, and what is done instead.
            pub fn words(self) -> (&'static str, &'static str) {
                match self {
                    $(Self::$name => ($id, $what)),*
                }
            }
        }
    };
}

pub mod catalogue;
#[cfg(test)]
mod digests;
pub mod edition;
pub mod exact;
pub mod march;
pub mod material;
pub mod record;
#[cfg(test)]
mod tests;

use crossfibre::number::Number;
use crossfibre::outcome::Outcome;
use crossfibre::paper::Paper;
use crossfibre::result::{self, Marcher, RunResult, WithPaper};
use crossfibre::scene::Scene;
use crossfibre::scene_check::Problem;
use crossfibre::state::{State, Wavefront};

pub use catalogue::{Fault, Group, Plant, Refused, all, now, plant, rewrites};
pub use edition::{Edition, edition};

/// As [`crossfibre::result::with_paper`].
pub fn with_paper<S: Number, W: WithPaper<S>>(scene: &Scene, work: W) -> W::Out {
    if edition::is_another() {
        work.with(&edition(scene.strain, scene.corrections))
    } else {
        result::with_paper(scene, work)
    }
}

/// As [`State::at_impact`].
pub fn at_impact<S: Number>(scene: &Scene, wavefront: Wavefront) -> State<S> {
    let mut state = State::at_impact(scene, wavefront);
    if let Some(Plant::Material(wrong)) = now() {
        wrong.put_into(scene, &mut state);
    }
    state
}

/// As [`Scene::check`].
pub fn check(scene: &Scene) -> Result<(), Problem> {
    match now() {
        Some(Plant::Material(material::Wrong::Unchecked)) => Ok(()),
        _ => scene.check(),
    }
}

/// As [`crossfibre::result::run`], by [`crate::wide`].
pub fn run(scene: &Scene, watch: impl FnMut(&State<f64>)) -> RunResult {
    result::run_with(&Planted, scene, watch)
}

/// Runs scenes with what is planted.
struct Planted;

impl Marcher for Planted {
    fn at_impact(&self, scene: &Scene) -> State<f64> {
        at_impact(scene, Wavefront::Flagged)
    }

    fn with_paper<W: WithPaper<f64>>(&self, scene: &Scene, work: W) -> W::Out {
        with_paper(scene, work)
    }

    fn march<P: Paper<f64>>(
        &self,
        paper: &P,
        state: &mut State<f64>,
        steps: u64,
        watch: impl FnMut(&State<f64>),
    ) -> Outcome {
        march::wide(paper, state, steps, watch)
    }
}
