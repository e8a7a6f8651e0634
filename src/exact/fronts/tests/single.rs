//! One fibre, or two that do not hear of each other.

use super::super::super::smith::{Law, Smith, smith};
use super::*;

fn known(velocity: f64) -> Smith {
    smith(Law::Engineering, (58.6e9_f64 / 1206.7).sqrt(), velocity).unwrap()
}

/// The strain behind a meeting, by bisection of |Uλ(t_L + t_R)/2 + (v_R* − v_L*)/2| = Uλ with
/// v* = v ± c(ε* − ε)t, written out here.
fn meeting(c: f64, left: State, right: State) -> f64 {
    let short = |strain: f64| {
        let q = c * (strain * (1.0 + strain)).sqrt();
        let v_left = left.velocity + left.direction * (c * (strain - left.strain));
        let v_right = right.velocity - right.direction * (c * (strain - right.strain));
        let sum = (left.direction + right.direction) * (q / 2.0) + (v_right - v_left) / 2.0;
        q - sum.norm()
    };
    let (mut below, mut above) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = (below + above) / 2.0;
        *(if short(middle) < 0.0 { &mut below } else { &mut above }) = middle;
    }
    above
}

#[test]
fn clamp_doubles_the_strain_and_the_kink_meets_what_it_sends_back() {
    let (length, c) = (0.371, (58.6e9_f64 / 1206.7).sqrt());
    let smith = known(411.3);
    let (e, u) = (smith.strain.engineering, smith.kink_speed_lagrangian);
    let mut fronts = Fronts::new(&alone(length), Limits { resolution: 1e-12, events: 1_000 });
    // d'Alembert: before and after the reflection at L/c = 53.2 µs.
    fronts.advance(52.9e-6).unwrap();
    assert_eq!(state(&fronts, Fibre::Primary, 0.9999 * length).strain, 0.0);
    assert!((state(&fronts, Fibre::Primary, 0.99 * length).strain / e - 1.0).abs() < 1e-14);
    fronts.advance(77.7e-6).unwrap();
    let turned = 2.0 * length - c * 77.7e-6;
    let segments = fronts.segments(Fibre::Primary);
    let [kink, front] = [&segments[1], &segments[2]].map(|segment| segment.from);
    assert!((front / turned - 1.0).abs() < 1e-13, "{front} {turned}");
    assert!((kink / (u * 77.7e-6) - 1.0).abs() < 1e-13);
    let clamped = segments[2].state;
    // Rounding.
    assert!((clamped.strain / (2.0 * e) - 1.0).abs() < 1e-14 && clamped.velocity.norm() < 1e-12);
    // The kink is met at 2L/(c + U) = 94.6 µs, and what went on is at the projectile 12 µs later.
    let met = 2.0 * length / (c + u);
    fronts.advance(met + 5.3e-6).unwrap();
    let behind = State {
        strain: e,
        direction: Vector3::new(smith.angle_cosine, -smith.angle_sine, 0.0),
        velocity: Vector3::y() * 411.3,
    };
    let ahead = State { strain: 2.0 * e, direction: Vector3::x(), velocity: Vector3::zeros() };
    let strain = meeting(c, behind, ahead);
    for off in [-5.2e-6, 0.0, 5.2e-6] {
        let found = state(&fronts, Fibre::Primary, u * met + c * off).strain;
        assert!((found / strain - 1.0).abs() < 1e-12, "{off}: {found} {strain}");
    }
    assert_eq!(state(&fronts, Fibre::Primary, u * met - c * 5.4e-6), behind_of(&fronts));
}

/// The state at the projectile.
fn behind_of(fronts: &Fronts<Line>) -> State {
    state(fronts, Fibre::Primary, 0.0)
}

#[test]
fn fibres_that_cross_at_the_impact_point_move_each_by_itself() {
    // Through two reflections of each.
    let mut both = paper();
    both.velocity = 411.3;
    both.primary.length = 0.317;
    let across = both.secondary.as_mut().unwrap();
    across.at = 0.0;
    across.fibre.length = 0.213;
    let (time, resolution) = (131e-6, 1e-7);
    let both = at(&both, resolution, time);
    let lone = [0.317, 0.213].map(|length| at(&alone(length), resolution, time));
    assert_eq!(both.segments(Fibre::Primary), lone[0].segments(Fibre::Primary));
    let (found, expected) = (both.segments(Fibre::Secondary), lone[1].segments(Fibre::Primary));
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(&expected) {
        // x and z change places; the same operations otherwise.
        let swap = |v: Vector3<f64>| Vector3::new(v.z, v.y, v.x);
        assert_eq!(found.to, expected.to);
        assert_eq!(swap(found.state.velocity), expected.state.velocity);
        assert_eq!(swap(found.state.direction), expected.state.direction);
    }
    let braking = lone[0].accounts().braking + lone[1].accounts().braking;
    // The sums are taken in another order.
    assert!((both.accounts().braking / braking - 1.0).abs() < 1e-12);
    assert!(
        (both.resistance() / (lone[0].resistance() + lone[1].resistance()) - 1.0).abs() < 1e-12
    );
}

#[test]
fn projectile_that_stops_at_once_leaves_nothing_and_one_that_is_struck_again_obeys() {
    // Two impacts at the same moment are the second alone.
    let mut again = Fronts::new(&alone(0.3), Limits { resolution: 1e-12, events: 100 });
    again.strike(137.9);
    again.advance(9.1e-6).unwrap();
    let smith = known(137.9);
    let found = behind_of(&again);
    assert!((found.strain / smith.strain.engineering - 1.0).abs() < 1e-13, "{found:?}");
    assert_eq!(found.velocity, Vector3::y() * 137.9);
    // Later: the fibre at the projectile moves with it.
    again.strike(81.3);
    again.advance(9.2e-6).unwrap();
    assert_eq!(behind_of(&again).velocity, Vector3::y() * 81.3);
}
