//! The result of a run that diverges holds the numbers of its last whole step.

use crossfibre::errata::Corrections;
use crossfibre::outcome::Outcome;
use crossfibre::place::{Fibre, Place};
use crossfibre::result::{self, RunResult, WithPaper, with_paper};
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::{State, Wavefront};
use crossfibre::{march, paper::Paper, scene_file};
use serde_json::Value;

fn single() -> Scene {
    scene_file::read(include_str!("../../verification/scenes/single-400.json")).unwrap()
}

/// Beyond the Courant limit the highest mode grows without bound. With (4) the growth ends, since
/// its strain is a logarithm; with the engineering measure it ends where a double does.
fn overflowing() -> [Scene; 2] {
    let fig3 = scene_file::read(include_str!("../../verification/scenes/fig3.json")).unwrap();
    [(single(), 1.3), (fig3, 1.1)].map(|(scene, courant)| Scene {
        strain: Strain::Engineering,
        courant,
        duration: 293e-6,
        ..scene
    })
}

/// A projectile so light that what (8) takes off its velocity in the first step is no double.
fn weightless_projectile() -> Scene {
    let mut scene = single();
    scene.projectile.mass = Some(f64::from_bits(1));
    scene.corrections = Corrections::NONE;
    scene
}

fn diverged(result: &RunResult) -> (Place, u8) {
    match result.outcome {
        Outcome::Diverged { place, equation } => (place, equation),
        ref other => panic!("{other}"),
    }
}

/// The state after `place.step − 1` steps, and how the step after it ends.
struct OneByOne<'a>(&'a Scene, u64);
impl WithPaper<f64> for OneByOne<'_> {
    type Out = (State<f64>, Result<(), Outcome>);
    fn with(self, paper: &impl Paper<f64>) -> Self::Out {
        let mut state = State::at_impact(self.0, Wavefront::Flagged);
        for _ in 0..self.1 {
            march::step(paper, &mut state).unwrap();
        }
        let whole = state.clone();
        (whole, march::step(paper, &mut state))
    }
}

/// Every number below a value; a `null`, which is how JSON writes what is not finite, is a fault.
fn numbers(value: &Value) -> usize {
    match value {
        Value::Null => panic!("null"),
        Value::Number(_) => 1,
        Value::Array(values) => values.iter().map(numbers).sum(),
        Value::Object(fields) => fields.values().map(numbers).sum(),
        Value::Bool(_) | Value::String(_) => 0,
    }
}

#[test]
fn a_diverged_result_is_that_of_the_step_before() {
    for scene in overflowing() {
        let result = result::run(&scene, |_| ());
        let (place, equation) = diverged(&result);
        let (whole, next) = with_paper(&scene, OneByOne(&scene, place.step - 1));
        assert_eq!(next, Err(Outcome::Diverged { place, equation }));
        assert_eq!(result.steps, place.step - 1);
        assert_eq!(result.primary.strain, whole.primary.strain);
        assert_eq!(result.primary.tension, whole.primary.tension);
        let positions = whole.primary.position.iter().map(|x| [x.x, x.y]);
        assert!(positions.eq(result.primary.position.iter().map(|x| [x[0], x[1]])));
        let velocities = whole.primary.velocity.iter().map(|v| [v.x, v.y]);
        assert!(velocities.eq(result.primary.velocity.iter().map(|v| [v[0], v[1]])));
    }
}

#[test]
fn a_diverged_result_holds_no_null_in_its_arrays_and_parses() {
    for scene in overflowing() {
        let text = serde_json::to_string(&result::run(&scene, |_| ())).unwrap();
        let json: Value = serde_json::from_str(&text).unwrap();
        // x, y of positions and velocities at 151 nodes, strain and tension of 150 elements, their length.
        assert_eq!(numbers(&json["primary"]), 2 * 2 * 151 + 2 * 150 + 1);
        assert_eq!(numbers(&json["projectile"]), 2);
        if scene.secondary.is_some() {
            // The same with z, at 101 nodes and 100 elements.
            assert_eq!(numbers(&json["secondary"]), 2 * 3 * 101 + 2 * 100 + 1);
            assert_eq!(numbers(&json["crossover"]), 3);
        }
    }
}

#[test]
fn a_projectile_velocity_that_is_not_finite_ends_the_run() {
    let result = result::run(&weightless_projectile(), |_| ());
    let (place, equation) = diverged(&result);
    assert_eq!((place.fibre, place.index, equation), (Fibre::Primary, 0, 8));
    assert_eq!(result.steps, place.step - 1);
    assert!(result.projectile.velocity.is_finite());
    assert!(result.primary.velocity.iter().flatten().all(|v| v.is_finite()));
}
