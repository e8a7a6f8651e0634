//! What the cases share: shipped scenes, finished marches, windows and orders.

use crossfibre::exact::crossover::Crossover;
use crossfibre::exact::smith::{Fibre, Smith};
use crossfibre::number::Number;
use crossfibre::outcome::Outcome;
use crossfibre::paper::Paper;
use crossfibre::result::WithPaper;
use crossfibre::scene::{Scene, Secondary, Strain};
use crossfibre::state::{FibreState, State, Wavefront};
use crossfibre::{balance::Balance, discretisation::Discretisation, scene_file};

use super::{Bound, Check};
use crate::closed_form::{self, law};
use crate::oracle::{crossover, smith};
use crate::planted::{self, with_paper};

macro_rules! scenes {
    ($($name:literal),* $(,)?) => {
        /// The shipped scenes by name.
        pub const SCENES: &[(&str, &str)] =
            &[$(($name, include_str!(concat!("../../scenes/", $name, ".json")))),*];
    };
}

scenes! {
    "artificial-viscosity", "both-at-origin", "eyring", "fig3", "fig3-printed",
    "finite-projectile", "hardening", "single-400", "single-400-1440", "slack", "sliding",
    "softening", "timing", "unequal", "viscoelastic",
}

/// A shipped scene.
///
/// # Panics
/// If there is none of that name, or it cannot be read: a fault of this program.
pub fn shipped(name: &str) -> Scene {
    let (_, text) = SCENES
        .iter()
        .find(|(n, _)| *n == name)
        .unwrap_or_else(|| panic!("no shipped scene is called {name}"));
    scene_file::read(text).unwrap_or_else(|fault| panic!("{name}: {fault}"))
}

/// A scene whose secondary fibre, if it has one, is changed.
fn with_secondary(mut scene: Scene, change: impl FnOnce(&mut Secondary)) -> Scene {
    if let Some(secondary) = &mut scene.secondary {
        change(secondary);
    }
    scene
}

/// A scene with another slide factor.
pub fn sliding_by(slide_factor: f64, scene: Scene) -> Scene {
    with_secondary(scene, |secondary| secondary.slide_factor = slide_factor)
}

/// Fig. 3 with the crossover so near to the impact that the kink passes it.
pub fn kinked() -> Scene {
    with_secondary(shipped("fig3"), |secondary| secondary.at = 0.012)
}

/// Fig. 3 on a mesh so coarse that a person can follow it.
pub fn coarse_fig3() -> Scene {
    let mut scene = shipped("fig3");
    scene.primary.elements = 6;
    with_secondary(scene, |secondary| secondary.elements = 4)
}

/// A scene on a mesh `factor` times as fine.
pub fn refined(mut scene: Scene, factor: usize) -> Scene {
    scene.primary.elements *= factor;
    with_secondary(scene, |secondary| secondary.elements *= factor)
}

/// A scene with another measure of strain.
pub fn measured_by(strain: Strain, scene: Scene) -> Scene {
    Scene { strain, ..scene }
}

/// The struck fibre for the closed forms.
pub fn exact_primary(scene: &Scene) -> Fibre {
    closed_form::primary(&scene.primary)
}

/// Smith's solution for a scene.
pub fn exact_single(scene: &Scene) -> Smith {
    let wave_speed = exact_primary(scene).wave_speed();
    smith(law(scene), wave_speed, scene.projectile.velocity).expect("the scene is in Smith's range")
}

/// The exact state around the crossover of a scene.
pub fn exact_crossover(scene: &Scene) -> Crossover {
    let s = scene.secondary.as_ref().expect("the scene has a secondary");
    let secondary = closed_form::secondary(s);
    let primary = exact_primary(scene);
    crossover(law(scene), &primary, &secondary, s.slide_factor, scene.projectile.velocity)
        .expect("the scene is in the range of the closed form")
}

/// A finished march.
pub struct Marched {
    /// The last state.
    pub state: State<f64>,
    /// How it ended.
    pub outcome: Outcome,
    /// Energy and momentum at the end.
    pub balance: Balance,
}

/// What a case changes before the first step.
type Prepare<'a> = &'a dyn Fn(&mut State<f64>);

/// Marches a scene to its end.
pub fn marched(scene: Scene) -> Marched {
    marched_from(scene, Wavefront::Flagged, &|_| {})
}

/// Marches a scene with a prepared start.
pub fn marched_from(scene: Scene, wavefront: Wavefront, prepare: Prepare<'_>) -> Marched {
    watched(scene, wavefront, prepare, |_| {})
}

/// Marches a scene and looks at every step.
pub fn watched(
    scene: Scene,
    wavefront: Wavefront,
    prepare: Prepare<'_>,
    watch: impl FnMut(&State<f64>),
) -> Marched {
    struct March<'a, F>(&'a Scene, Wavefront, Prepare<'a>, F);
    impl<F: FnMut(&State<f64>)> WithPaper<f64> for March<'_, F> {
        type Out = (State<f64>, Outcome, Balance);
        fn with(self, paper: &impl Paper<f64>) -> Self::Out {
            let Self(scene, wavefront, prepare, watch) = self;
            let mut state = planted::at_impact(scene, wavefront);
            prepare(&mut state);
            let steps = Discretisation::<f64>::of(scene).steps(scene.duration);
            let outcome = planted::march::run(paper, &mut state, steps, watch);
            let balance = state.balance(paper, scene.strain);
            (state, outcome, balance)
        }
    }
    let (state, outcome, balance) = with_paper(&scene, March(&scene, wavefront, prepare, watch));
    Marched { state, outcome, balance }
}

impl Marched {
    /// Mean strain of the primary between two Lagrangian distances, m.
    pub fn primary_strain(&self, from: f64, to: f64) -> f64 {
        let fibre = &self.state.primary;
        mean(fibre.properties.spacing, &fibre.strain, from, to)
    }

    /// Root mean square of the primary's strain over an exact one, less 1, between two distances, m.
    pub fn oscillation(&self, exact: f64, from: f64, to: f64) -> f64 {
        let fibre = &self.state.primary;
        let squares: Vec<f64> =
            fibre.strain.iter().map(|e| (e / exact - 1.0) * (e / exact - 1.0)).collect();
        mean(fibre.properties.spacing, &squares, from, to).sqrt()
    }

    /// Mean strain of the secondary between two Lagrangian distances, m.
    pub fn secondary_strain(&self, from: f64, to: f64) -> f64 {
        let fibre = &self.state.crossover.as_ref().expect("the scene has a secondary").fibre;
        mean(fibre.properties.spacing, &fibre.strain, from, to)
    }
}

/// Mean of a quantity of elements of length `dx` over those whose middle lies between two distances.
pub fn mean(dx: f64, of: &[f64], from: f64, to: f64) -> f64 {
    let inside = of.iter().enumerate().filter_map(|(i, &x)| {
        let middle = (i as f64 + 0.5) * dx;
        (from <= middle && middle <= to).then_some(x)
    });
    let (sum, count) = inside.fold((0.0, 0.0), |(sum, n), x| (sum + x, n + 1.0));
    sum / count
}

/// Observed order of convergence when an error falls from `coarse` to `fine` on a mesh `ratio`
/// times as fine.
pub fn order(coarse: f64, fine: f64, ratio: f64) -> f64 {
    Number::ln(coarse.abs() / fine.abs()) / Number::ln(ratio)
}

/// |a/b − 1|.
pub fn relative(a: f64, b: f64) -> f64 {
    (a / b - 1.0).abs()
}

/// A check, with the words in the order they are read.
pub fn check(
    claim: impl Into<String>,
    oracle: &str,
    norm: &str,
    measured: f64,
    bound: Bound,
    reason: &str,
) -> Check {
    Check {
        claim: claim.into(),
        oracle: oracle.into(),
        norm: norm.into(),
        measured,
        bound,
        reason: reason.into(),
    }
}

/// The number of positions and velocities whose bits differ between two fibres, and of strains and
/// tensions. Components are compared by number: the bits of −0 and 0 count as different.
pub fn different_bits<const D: usize, const E: usize>(
    a: &FibreState<f64, D>,
    b: &FibreState<f64, E>,
    component: impl Fn(usize) -> usize,
) -> f64 {
    let vectors = |a: &[crossfibre::number::Vector<f64, D>],
                   b: &[crossfibre::number::Vector<f64, E>]| {
        a.iter()
            .zip(b)
            .flat_map(|(a, b)| (0..D).map(|k| (a[k], b[component(k)])).collect::<Vec<_>>())
            .filter(|(a, b)| a.to_bits() != b.to_bits())
            .count()
    };
    let scalars =
        |a: &[f64], b: &[f64]| a.iter().zip(b).filter(|(a, b)| a.to_bits() != b.to_bits()).count();
    let unequal_length = a.strain.len().abs_diff(b.strain.len());
    (unequal_length
        + vectors(&a.position, &b.position)
        + vectors(&a.velocity, &b.velocity)
        + scalars(&a.strain, &b.strain)
        + scalars(&a.tension, &b.tension)) as f64
}

#[cfg(test)]
mod tests {
    use crossfibre::number::Vector;

    use super::*;

    /// Middles of elements at 1, 3 and 5.
    #[test]
    fn an_element_whose_middle_is_at_an_end_of_the_window_is_in_it() {
        let of = [1.0, 4.0, 16.0];
        assert_eq!(mean(2.0, &of, 1.0, 3.0), 2.5);
        assert_eq!(mean(2.0, &of, 3.0, 5.0), 10.0);
        assert_eq!(mean(2.0, &of, 1.5, 4.5), 4.0);
    }

    #[test]
    fn means_of_strain_are_those_of_their_fibre() {
        let mut run = marched(coarse_fig3());
        run.state.primary.properties.spacing = 2.0;
        run.state.primary.strain = vec![1.0, 4.0, 16.0];
        let across = &mut run.state.crossover.as_mut().unwrap().fibre;
        across.properties.spacing = 1.0;
        across.strain = vec![3.0, 8.0, 10.0];
        assert_eq!(run.primary_strain(2.0, 6.0), 10.0);
        assert_eq!(run.secondary_strain(1.0, 3.0), 9.0);
    }

    /// Other numbers of each kind, so that none makes up for another.
    #[test]
    fn every_number_that_differs_is_counted_once() {
        let state = State::<f64>::at_impact(&refined(coarse_fig3(), 4), Wavefront::Flagged);
        let (a, mut b) = (&state.primary, state.primary.clone());
        assert_eq!(different_bits(a, &b, |k| k), 0.0);
        // An element more, 2 components of positions, 4 of velocities, 8 strains, 16 tensions.
        b.strain.push(0.0);
        b.position[3].x += 1e-9;
        b.position[7].y = -0.0;
        b.velocity[5].y = 0.1;
        b.velocity[6] = Vector::<f64, 2>::new(0.1, 0.2);
        b.velocity[9].x = f64::NAN;
        b.strain[3..11].fill(1e-300);
        b.tension[..16].fill(-1.0);
        assert_eq!(different_bits(a, &b, |k| k), 31.0);
    }

    /// x of one is y of the other.
    #[test]
    fn components_are_compared_with_those_that_they_are_named_after() {
        let state = State::<f64>::at_impact(&coarse_fig3(), Wavefront::Flagged);
        let (mut a, mut b) = (state.primary.clone(), state.primary.clone());
        for i in 0..=6 {
            a.position[i] = Vector::<f64, 2>::new(i as f64 + 0.1, 0.7);
            b.position[i] = Vector::<f64, 2>::new(0.7, i as f64 + 0.1);
        }
        assert_eq!(different_bits(&a, &b, |k| [1, 0][k]), 0.0);
        assert_eq!(different_bits(&a, &b, |k| k), 14.0);
    }
}
