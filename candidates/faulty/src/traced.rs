//! A trace of a scene as the changed edition works it out.

use std::io::{self, Write};

use crossfibre::discretisation::Discretisation;
use crossfibre::march;
use crossfibre::paper::Paper;
use crossfibre::scene::Scene;
use crossfibre::state::{State, Wavefront};
use crossfibre::trace::Traced;
use crossfibre::trace_file::{Filter, JsonLines};

use crate::answer::{Change, With, with_edition};

/// Writes the trace. A run that breaks off leaves the trace up to there.
pub fn trace(change: Change, scene: &Scene, out: impl Write) -> io::Result<u64> {
    struct Trace<'a, W>(&'a Scene, W);
    impl<W: Write> With<f64> for Trace<'_, W> {
        type Out = io::Result<u64>;
        fn with(self, paper: &impl Paper<f64>) -> Self::Out {
            let Self(scene, out) = self;
            let lines = JsonLines::start(out, scene, paper, Filter::default())?;
            let traced = Traced::new(paper, lines);
            let mut state = State::<f64>::at_impact(scene, Wavefront::Flagged);
            let steps = Discretisation::<f64>::of(scene).steps(scene.duration);
            // How it ends does not matter to a trace.
            let _ = march::run(&traced, &mut state, steps, |_| ());
            traced.into_sink().finish()
        }
    }
    with_edition(change, scene.strain, scene.corrections, Trace(scene, out))
}
