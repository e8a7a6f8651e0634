//! What must not change the answer: turning, mirroring, moving and scaling the experiment.

use crossfibre::errata::Corrections;
use crossfibre::number::{Number, Vector};
use crossfibre::scene::{Material, Scene};
use crossfibre::state::{State, Wavefront};

use super::support::{Marched, check, kinked, marched, marched_from, shipped, sliding_by};
use super::{Bound, Case, Check};
use crate::worse::worse;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case {
        id: "invariance.rotation",
        title: "Turning the experiment in its plane",
        equations: &[2, 5, 6, 9, 10, 11, 12, 13, 15, 16, 17, 18],
        run: rotation,
    },
    Case {
        id: "invariance.reflection",
        title: "Mirroring the experiment",
        equations: &[2, 5, 6, 9, 10, 11, 12, 13, 15, 16, 17, 18],
        run: reflection,
    },
    Case {
        id: "invariance.galilean",
        title: "Moving the experiment along",
        equations: &[2, 5, 6, 9, 10, 12, 13],
        run: galilean,
    },
    Case {
        id: "invariance.scaling",
        title: "Other units of length, time and mass",
        equations: &[2, 4, 5, 6, 7, 8, 15, 16, 17, 18, 20],
        run: scaling,
    },
];

/// Applies a map of the plane to every position, velocity and direction of a state at impact.
fn map_plane(state: &mut State<f64>, map: impl Fn(f64, f64) -> (f64, f64)) {
    let in_plane = |v: &mut Vector<f64, 2>| (v.x, v.y) = map(v.x, v.y);
    in_plane(&mut state.projectile.axis);
    state.primary.position.iter_mut().for_each(in_plane);
    if let Some(crossover) = &mut state.crossover {
        for p in &mut crossover.fibre.position {
            (p.x, p.y) = map(p.x, p.y);
        }
    }
}

/// Greatest distance between the primary's nodes of two runs, the second seen through a map, in
/// elements.
fn distance(a: &Marched, b: &Marched, map: impl Fn(f64, f64) -> (f64, f64)) -> f64 {
    let dx = a.state.primary.properties.spacing;
    let pairs = a.state.primary.position.iter().zip(&b.state.primary.position);
    pairs.fold(0.0_f64, |worst, (a, b)| {
        let (x, y) = map(b.x, b.y);
        worse(worst, worse((a.x - x).abs(), (a.y - y).abs()))
    }) / dx
}

/// Turned by an angle, rad.
fn turned_by(angle: f64) -> impl Fn(f64, f64) -> (f64, f64) {
    let (cos, sin) = (Number::cos(angle), Number::sin(angle));
    move |x, y| (cos * x - sin * y, sin * x + cos * y)
}

/// Mirrored in the plane of impact.
fn mirror(x: f64, y: f64) -> (f64, f64) {
    (-x, y)
}

fn rotation() -> Vec<Check> {
    let turned = |scene: Scene| {
        let plain = marched(scene.clone());
        let turned =
            marched_from(scene, Wavefront::Flagged, &|state| map_plane(state, turned_by(0.613)));
        distance(&plain, &turned, turned_by(-0.613))
    };
    // As printed only the crossover changes; the constant projectile runs no (8).
    let printed = Scene { corrections: Corrections::NONE, ..shipped("fig3") };
    let norm = "greatest distance of a node from its turned image, in elements";
    let rounding = "rounding, 1e-16 of a position of 100 elements, in 100 steps";
    vec![
        check(
            "One fibre, turned by 0.613 rad, does the same",
            "isotropy of the plane",
            norm,
            turned(shipped("single-400")),
            Bound::AtMost(3e-13),
            rounding,
        ),
        check(
            "So do two fibres with the corrected coupling",
            "isotropy of the plane",
            norm,
            turned(shipped("fig3")),
            Bound::AtMost(3e-13),
            rounding,
        ),
        check(
            "and when the kink has passed the crossover",
            "isotropy of the plane",
            norm,
            turned(kinked()),
            Bound::AtMost(3e-13),
            rounding,
        ),
        check(
            "With the printed coupling they do not",
            "isotropy of the plane",
            norm,
            turned(printed),
            Bound::AtLeast(0.05),
            "(16) as printed depends on the direction of the axes",
        ),
    ]
}

fn reflection() -> Vec<Check> {
    let scenes = ["single-400", "fig3", "unequal", "sliding"].map(|name| (name, shipped(name)));
    scenes
        .into_iter()
        .chain([("a crossover that the kink has passed", kinked())])
        .map(|(name, scene)| {
            let plain = marched(scene.clone());
            let mirrored = marched_from(scene, Wavefront::Flagged, &|state| {
                map_plane(state, mirror);
            });
            check(
                format!("{name}, mirrored in the plane of impact, does the same"),
                "symmetry",
                "greatest distance of a node from its mirror image",
                distance(&plain, &mirrored, mirror),
                Bound::Exactly(0.0),
                "a change of sign rounds nothing",
            )
        })
        .collect()
}

/// A velocity that an experiment is carried along with, m/s.
const ALONG: [f64; 2] = [-57.3, 123.4];

/// How far a node ends from where it should be when the experiment is carried along, in elements.
///
/// Along x and y together; the crossing fibre's own axis is closed to motion by (14).
pub fn moved_along(scene: Scene) -> f64 {
    let plain = marched_from(scene.clone(), Wavefront::Ignored, &|_| {});
    let moving = carried_along(scene);
    let way = Vector::<f64, 2>::from(ALONG) * plain.state.time();
    distance(&plain, &moving, |x, y| (x - way.x, y - way.y))
}

/// A scene that is carried along.
fn carried_along(scene: Scene) -> Marched {
    let along = Vector::<f64, 2>::from(ALONG);
    marched_from(scene, Wavefront::Ignored, &|state| {
        let drive = state.projectile.axis * state.projectile.velocity + along;
        state.projectile.velocity = drive.dot(&drive).sqrt();
        state.projectile.axis = drive / state.projectile.velocity;
        state.primary.velocity.iter_mut().for_each(|v| *v += along);
        state.primary.clamp_velocity = along;
        if let Some(crossover) = &mut state.crossover {
            let along = Vector::<f64, 3>::new(along.x, along.y, 0.0);
            crossover.fibre.velocity.iter_mut().for_each(|v| *v += along);
            crossover.fibre.clamp_velocity = along;
        }
    })
}

/// Nodes of a primary fibre whose kink has passed the crossover, in each frame.
pub fn in_other_frames() -> Vec<(&'static str, Vec<(f64, f64)>)> {
    let from =
        |prepare: &dyn Fn(&mut State<f64>)| marched_from(kinked(), Wavefront::Flagged, prepare);
    let frames = [
        ("as the scene has it", from(&|_| {})),
        ("turned by 0.613 rad", from(&|state| map_plane(state, turned_by(0.613)))),
        ("mirrored", from(&|state| map_plane(state, mirror))),
        ("carried along at 136 m/s", carried_along(kinked())),
    ];
    let nodes = |ended: &Marched| ended.state.primary.position.iter().map(|p| (p.x, p.y)).collect();
    frames.map(|(name, ended)| (name, nodes(&ended))).into()
}

fn galilean() -> Vec<Check> {
    let norm = "greatest distance of a node from its moving image, in elements";
    let [single, crossed] = ["single-400", "fig3"].map(|name| moved_along(shipped(name)));
    vec![
        check(
            "single-400 and fig3, carried along at 136 m/s with their clamps, do the same",
            "principle of relativity",
            &format!("{norm}, of both"),
            if single > crossed { single } else { crossed },
            Bound::AtMost(3e-12),
            "rounding of positions that are farther away, in 100 steps; the farthest are the same in both",
        ),
        check(
            "With α_s = 0.73 fig3 does not",
            "principle of relativity",
            norm,
            moved_along(sliding_by(0.73, shipped("fig3"))),
            Bound::AtLeast(2e-3),
            "ledger slide-frame: α_s multiplies a velocity over ground, as the page has it",
        ),
    ]
}

/// The scene in units 2^-a m, 2^-b s, 2^-c kg.
pub fn rescaled(scene: &Scene, a: i32, b: i32, c: i32) -> Scene {
    let power = |n: i32| 2.0_f64.powi(n);
    let modulus = power(c - a - 2 * b);
    let material = |m: &Material| Material::linear(m.instantaneous_modulus() * modulus);
    let mut scene = scene.clone();
    let (length, density, area) = (power(a), power(c - 3 * a), power(2 * a));
    let p = &mut scene.primary;
    (p.length, p.density, p.area) = (p.length * length, p.density * density, p.area * area);
    p.material = material(&p.material);
    if let Some(s) = &mut scene.secondary {
        (s.length, s.density, s.area) = (s.length * length, s.density * density, s.area * area);
        s.at *= length;
        s.material = material(&s.material);
    }
    scene.projectile.velocity *= power(a - b);
    scene.projectile.mass = scene.projectile.mass.map(|m| m * power(c));
    scene.duration *= power(b);
    scene
}

fn scaling() -> Vec<Check> {
    [("single-400", 3, -5, 7), ("unequal", -11, 4, 9), ("finite-projectile", 20, 20, -30)]
        .into_iter()
        .map(|(name, a, b, c)| {
            let scene = shipped(name);
            let plain = marched(scene.clone());
            let scaled = marched(rescaled(&scene, a, b, c));
            let (p, s) = (&plain.state.primary, &scaled.state.primary);
            let back = 2.0_f64.powi(-a);
            let positions = p.position.iter().zip(&s.position);
            let strains = p.strain.iter().zip(&s.strain);
            // The kink's forerunners die away through the subnormal numbers, where scaling rounds.
            let counts = |x: f64| x.abs() > 1e-290;
            let different = positions
                .flat_map(|(p, s)| [(p.x, s.x * back), (p.y, s.y * back)])
                .chain(strains.map(|(p, s)| (*p, *s)))
                .filter(|&(p, s)| counts(p) && p.to_bits() != s.to_bits())
                .count();
            check(
                format!("{name} in units of 2^{a} m, 2^{b} s and 2^{c} kg"),
                "dimensional analysis: powers of two round nothing",
                "positions and strains over 1e-290 whose bits differ",
                different as f64,
                Bound::Exactly(0.0),
                "no operation mixes units, and none under- or overflows",
            )
        })
        .collect()
}
