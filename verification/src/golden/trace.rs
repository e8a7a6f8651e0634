//! The golden trace: the first steps of Fig. 3 on a mesh that a person can follow.

use crossfibre::paper::Paper;
use crossfibre::result::WithPaper;
use crossfibre::scene::Scene;
use crossfibre::state::Wavefront;
use crossfibre::trace::Traced;
use crossfibre::trace_file::{Filter, JsonLines};

use crate::cases::support::coarse_fig3;
use crate::planted::{self, march, with_paper};

/// Steps traced: in the third the wave is at the crossover, in the fourth in the secondary.
const STEPS: u64 = 4;

/// The trace, as `crossfibre trace --step 1..4` writes it.
pub fn text() -> String {
    struct Write<'a>(&'a Scene);
    impl WithPaper<f64> for Write<'_> {
        type Out = Vec<u8>;
        fn with(self, paper: &impl Paper<f64>) -> Vec<u8> {
            let mut text = Vec::new();
            let sink = JsonLines::start(&mut text, self.0, paper, Filter::default())
                .expect("memory can be written to");
            let traced = Traced::new(paper, sink);
            let mut state = planted::at_impact::<f64>(self.0, Wavefront::Flagged);
            march::run(&traced, &mut state, STEPS, |_| ());
            traced.into_sink().finish().expect("memory can be written to");
            text
        }
    }
    let scene = coarse_fig3();
    String::from_utf8(with_paper(&scene, Write(&scene))).expect("JSON is text")
}
