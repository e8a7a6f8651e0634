//! Transverse impact on nonlinear elastic fibres, against Smith's relation with the waves of the law.

use crossfibre::exact::elastic::Elastic;
use crossfibre::exact::exponential::Exponential;
use crossfibre::exact::polynomial::Polynomial;
use crossfibre::exact::smith::Smith;
use crossfibre::scene::{Law, Scene};

use crate::cases::support::{check, marched, order, refined, relative, shipped};
use crate::cases::{Bound, Check};
use crate::oracle::{self, struck};

const ORACLE: &str = "Smith's relation with the fans and shocks of the law";

/// A scene and its exact solution.
struct Struck<M> {
    scene: Scene,
    material: M,
    exact: Smith,
}

/// What a run has of the exact solution.
struct Found {
    /// Mean strain of the middle half between kink and tail: relative error.
    plateau: f64,
    /// Mean of |ε − exact| from the middle of that to beyond the front, over the plateau's strain
    /// and the way of the front.
    profile: f64,
    /// Where the strain first is half the plateau's: error relative to the way of the front.
    place: f64,
    /// Greatest strain over the plateau's, less 1.
    overshoot: f64,
    /// From a tenth to nine tenths of the plateau's strain, elements.
    width: f64,
    /// What the viscosity has taken, over what the exact shocks dissipate.
    dissipated: f64,
}

impl<M: Elastic> Struck<M> {
    fn new(scene: Scene, material: M) -> Self {
        let exact = struck(&material, scene.projectile.velocity).expect("in Smith's range");
        Self { scene, material, exact }
    }

    /// A run on a mesh `factor` times as fine.
    fn found(&self, factor: usize) -> Found {
        let run = marched(refined(self.scene.clone(), factor));
        assert!(run.outcome.is_completed(), "{}", run.outcome);
        let fibre = &run.state.primary;
        let (time, dx, strain) = (run.state.time(), fibre.properties.spacing, &fibre.strain);
        let kink = self.exact.kink_speed_lagrangian * time;
        let tail = self.exact.tail_speed * time;
        let front = self.exact.front_speed * time;
        let plateau = self.exact.strain.engineering;
        let wave = self.exact.wave(&self.material);
        let middle = |i: usize| (i as f64 + 0.5) * dx;
        let apart: f64 = (0..fibre.elements())
            .filter(|&i| middle(i) > (kink + tail) / 2.0)
            .map(|i| (strain[i] - wave.strain_at(middle(i) / time)).abs() * dx)
            .sum();
        // Both halves.
        let heat = 2.0 * fibre.properties.area * oracle::dissipation(&wave) * time;
        let quarter = (tail - kink) / 4.0;
        Found {
            plateau: relative(run.primary_strain(kink + quarter, tail - quarter), plateau),
            profile: apart / plateau / front,
            place: relative(first_at(strain, 0.5 * plateau) * dx, front),
            overshoot: strain.iter().fold(0.0_f64, |a, &b| a.max(b)) / plateau - 1.0,
            width: first_at(strain, 0.1 * plateau) - first_at(strain, 0.9 * plateau),
            dissipated: run.balance.energy.dissipated / heat,
        }
    }
}

/// Where the strain first is above a height as one comes from the clamp, in elements from the impact
/// point, by interpolation between the middles of two.
fn first_at(strain: &[f64], height: f64) -> f64 {
    let i = strain.iter().rposition(|&e| e > height).unwrap_or(0);
    let (behind, ahead) = (strain[i], strain[i + 1]);
    i as f64 + 0.5 + (behind - height) / (behind - ahead)
}

fn exponential(mut scene: Scene, a: f64, b: f64) -> Struck<Exponential> {
    scene.primary.material.law = Law::Exponential { a, b };
    let material = oracle::exponential(scene.primary.density, a, b).expect("a law");
    Struck::new(scene, material)
}

fn polynomial(mut scene: Scene, coefficients: &[f64]) -> Struck<Polynomial> {
    scene.primary.material.law = Law::Polynomial { coefficients: coefficients.into() };
    let material = oracle::polynomial(scene.primary.density, coefficients).expect("a law");
    Struck::new(scene, material)
}

/// The coefficients of the shipped convex polynomial.
const CONVEX: [f64; 2] = [57.9e9, 1.93e12];

fn without_viscosity(mut scene: Scene) -> Scene {
    scene.primary.material.artificial_viscosity = None;
    scene
}

const PLATEAU: &str = "relative, mean over the middle half between kink and tail";
const PROFILE: &str = "mean |ε - exact| from plateau to front, over the plateau";

/// T softens: a fan.
pub fn softening() -> Vec<Check> {
    let exponential = exponential(shipped("softening"), -1.37e9, -43.7);
    let polynomial = polynomial(shipped("softening"), &[59.3e9, -0.97e12]);
    let [coarse, fine] = [2, 16].map(|factor| exponential.found(factor));
    let [coarse_2, fine_2] = [2, 16].map(|factor| polynomial.found(factor));
    let fan = "expected between 1/2 and 2/3, measured over a factor of 8 in Δx: the impact is a step \
               before it is a fan, and leaves a train of oscillations at the fan's foot";
    vec![
        check(
            "Exponential: the plateau is Smith's, 2.02 %",
            ORACLE,
            PLATEAU,
            fine.plateau,
            Bound::AtMost(1e-4),
            "oscillations of the train, averaged over a thousand elements of 0.075 mm",
        ),
        check(
            "Exponential: so is the fan, whose tail is a third slower than its front",
            ORACLE,
            PROFILE,
            fine.profile,
            Bound::AtMost(6e-3),
            "oscillations behind the tail and a rounded corner at the front, 0.075 mm",
        ),
        check(
            "Exponential: the fan converges",
            ORACLE,
            "observed order of the profile's error",
            order(coarse.profile, fine.profile, 8.0),
            Bound::Within(0.5, 0.8),
            fan,
        ),
        check(
            "Exponential: and the overshoot, which at a linear law does not shrink, does",
            ORACLE,
            "observed order of the greatest strain over the plateau's, less 1",
            order(coarse.overshoot, fine.overshoot, 8.0),
            Bound::Within(0.3, 0.5),
            "a fan spreads as time goes on: what the mesh resolves is ever less steep",
        ),
        check(
            "Polynomial: the plateau is Smith's, 2.03 %",
            ORACLE,
            PLATEAU,
            fine_2.plateau,
            Bound::AtMost(3e-4),
            "oscillations of the train, as above",
        ),
        check(
            "Polynomial: the fan converges",
            ORACLE,
            "observed order of the profile's error",
            order(coarse_2.profile, fine_2.profile, 8.0),
            Bound::Within(0.5, 0.8),
            fan,
        ),
    ]
}

/// T hardens: a shock.
pub fn hardening() -> Vec<Check> {
    let shock = polynomial(shipped("hardening"), &CONVEX);
    let [coarse, fine] = [1, 8].map(|factor| shock.found(factor));
    let exponential = exponential(shipped("hardening"), 1.13e9, 51.3);
    let [coarse_2, fine_2] = [1, 8].map(|factor| exponential.found(factor));
    let bare = polynomial(without_viscosity(shipped("hardening")), &CONVEX);
    let [bare_coarse, bare_fine] = [1, 8].map(|factor| bare.found(factor));
    let smeared = "a shock keeps its width in elements, and starts with a delay of some steps";
    vec![
        check(
            "Polynomial, artificial viscosity: the plateau is Smith's, 1.16 %",
            ORACLE,
            PLATEAU,
            fine.plateau,
            Bound::AtMost(2e-6),
            "nothing is left of oscillations in the middle half; the kink is far",
        ),
        check(
            "The shock is where Rankine and Hugoniot have it, 18 % faster than c",
            ORACLE,
            "place of half the height, error over its way, 0.15 mm",
            fine.place,
            Bound::AtMost(3e-3),
            smeared,
        ),
        check(
            "Its place converges",
            ORACLE,
            "observed order over a factor of 8",
            order(coarse.place, fine.place, 8.0),
            Bound::Within(0.9, 1.1),
            "a delay of a number of steps: order one",
        ),
        check(
            "Its profile converges",
            ORACLE,
            "observed order of the profile's error over a factor of 8",
            order(coarse.profile, fine.profile, 8.0),
            Bound::Within(0.85, 1.1),
            "a jump spread over a number of elements: order one",
        ),
        check(
            "It is as many elements wide on any mesh",
            "a steady profile in elements",
            "width from 10 to 90 %, mesh of 0.15 mm over that of 1.2 mm",
            fine.width / coarse.width,
            Bound::Within(0.95, 1.05),
            "what comes from behind is faster, and holds against the viscosity's spreading",
        ),
        check(
            "What the viscosity takes is what the exact shock dissipates",
            "s(½(T₊ + T₋)[ε] - [ψ]) of the jump conditions",
            "relative, 0.15 mm",
            relative(fine.dissipated, 1.0),
            Bound::AtMost(3e-2),
            "the kink's share and the delay of the start: order one",
        ),
        check(
            "The more the finer",
            "the same",
            "observed order over a factor of 8",
            order(coarse.dissipated - 1.0, fine.dissipated - 1.0, 8.0),
            Bound::Within(0.8, 1.1),
            "the kink's share and the delay of the start: order one",
        ),
        check(
            "Exponential, artificial viscosity: the plateau is Smith's, 1.17 %",
            ORACLE,
            PLATEAU,
            fine_2.plateau,
            Bound::AtMost(2e-6),
            "as above",
        ),
        check(
            "Exponential: the shock's place converges",
            ORACLE,
            "observed order over a factor of 8",
            order(coarse_2.place, fine_2.place, 8.0),
            Bound::Within(0.9, 1.1),
            "as above",
        ),
        check(
            "Without viscosity there is no shock but a train of waves: it overshoots",
            ORACLE,
            "greatest strain over the plateau's, less 1, 0.15 mm",
            bare_fine.overshoot,
            Bound::Within(0.6, 1.0),
            "a chain of masses without a loss cannot have a shock; its greatest wave grows towards \
             twice the jump",
        ),
        check(
            "it runs ahead of the shock",
            ORACLE,
            "place of half the height, error over its way, 0.15 mm",
            bare_fine.place,
            Bound::AtLeast(2e-2),
            "its first wave is higher than the plateau, and the higher the faster",
        ),
        check(
            "and converges to nothing",
            ORACLE,
            "observed order of the profile's error over a factor of 8",
            order(bare_coarse.profile, bare_fine.profile, 8.0),
            Bound::Within(-0.1, 0.1),
            "the train fills the same part of the way on any mesh: order zero",
        ),
    ]
}

/// T hardens, then softens: the hull is a chord and an arc.
pub fn inflection() -> Vec<Check> {
    let struck = polynomial(shipped("hardening"), &[57.9e9, 2.13e12, -121.3e12]);
    let [coarse, fine] = [1, 8].map(|factor| struck.found(factor));
    vec![
        check(
            "Artificial viscosity: the plateau is Smith's, 1.35 %",
            ORACLE,
            PLATEAU,
            fine.plateau,
            Bound::AtMost(1e-4),
            "the foot of the fan, spread by the viscosity, reaches into the middle half",
        ),
        check(
            "A shock from rest to where its chord touches the law, at 0.88 %",
            ORACLE,
            "place of half the plateau's height, error over its way, 0.15 mm",
            fine.place,
            Bound::AtMost(2e-3),
            "a delay of some steps",
        ),
        check(
            "Shock and fan converge together",
            ORACLE,
            "observed order of the profile's error over a factor of 8",
            order(coarse.profile, fine.profile, 8.0),
            Bound::Within(0.6, 0.8),
            "the fan's fastest part is as fast as the shock, so that nothing holds it steep from \
             behind: expected 2/3",
        ),
    ]
}
