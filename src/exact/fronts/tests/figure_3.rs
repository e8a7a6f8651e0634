//! The paper's scene while every front can be followed by hand.

use super::super::super::crossover::crossover;
use super::super::super::smith::{Fibre as Section, Law, smith};
use super::*;

const SECTION: Section = Section { modulus: 58.6e9, density: 1206.7, area: 1e-6 };

fn sound() -> f64 {
    (58.6e9_f64 / 1206.7).sqrt()
}

/// The places at which a fibre's state changes.
fn places(fronts: &Fronts<Line>, fibre: Fibre) -> Vec<f64> {
    let segments = fronts.segments(fibre);
    // Two spans of the primary meet at the crossover without a front.
    segments.windows(2).map(|pair| pair[1].from).collect()
}

#[track_caller]
fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found:e} {expected:e}");
}

#[test]
fn impact_sends_the_state_of_smith() {
    // Until the wave is at the crossover, at 14.35 µs. A few roundings.
    let fronts = at(&paper(), 1e-12, 13.7e-6);
    let known = smith(Law::Engineering, sound(), 400.0).unwrap();
    let places = places(&fronts, Fibre::Primary);
    near(places[0], known.kink_speed_lagrangian * 13.7e-6, 1e-14);
    near(places[1], sound() * 13.7e-6, 1e-14);
    let (behind, between) =
        (state(&fronts, Fibre::Primary, 1e-4), state(&fronts, Fibre::Primary, 0.07));
    for found in [behind.strain, between.strain] {
        near(found, known.strain.engineering, 1e-14);
    }
    assert_eq!(behind.velocity, Vector3::y() * 400.0);
    near(-between.velocity.x, known.inflow_velocity, 1e-14);
    near(behind.direction.x, known.angle_cosine, 1e-14);
    near(-behind.direction.y, known.angle_sine, 1e-14);
    near(fronts.resistance(), 2.0 * 58.6e3 * known.tension * known.angle_sine, 1e-14);
    assert_eq!((fronts.events(), fronts.error_bound()), (0, 0.0));
}

#[test]
fn fronts_of_figure_3_are_where_the_closed_forms_say() {
    // At 28.7 µs: docs/exact/crossover.md, "Range".
    let time = 28.7e-6;
    let mut fronts = Fronts::new(&paper(), Limits { resolution: 1e-12, events: 100 });
    fronts.record();
    fronts.advance(time).unwrap();
    let (c, x_c) = (sound(), 0.1);
    let known = crossover(Law::Engineering, &SECTION, &SECTION, 1.0, 400.0).unwrap();
    let u = known.incident.kink_speed_lagrangian;
    // The reflected wave meets the kink at t₁, X₁, from which two wavelets and two kinks leave; the
    // wavelet towards the projectile has been there for 0.07 ns and is on its way back.
    let t_1 = 2.0 * x_c / (c + u);
    let x_1 = u * t_1;
    near(t_1, 25.6e-6, 0.002);
    near(x_1, 21.3e-3, 0.002);
    let strain = state(&fronts, Fibre::Primary, 0.02).strain;
    let slower = c * (strain / (1.0 + strain)).sqrt();
    let expected = [
        c * (time - t_1) - x_1,
        x_1 - slower * (time - t_1),
        x_1 + slower * (time - t_1),
        x_1 + c * (time - t_1),
        x_c,
        c * time,
    ];
    let found = places(&fronts, Fibre::Primary);
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(&expected) {
        // A few roundings of 0.2 m.
        assert!((found - expected).abs() < 2e-16, "{found} {expected}");
    }
    near(found[3], 0.0427, 0.002);
    // Where the closed form of the crossover still holds.
    let engineering = known.engineering;
    let e = known.incident.strain.engineering;
    let strain = |fibre, at| state(&fronts, fibre, at).strain;
    near(strain(Fibre::Primary, 0.07), e * (1.0 + engineering.reflection), 1e-13);
    near(strain(Fibre::Primary, 0.15), e * engineering.transmission, 1e-13);
    assert_eq!(strain(Fibre::Primary, 0.25), 0.0);
    let since = time - x_c / c;
    let secondary = places(&fronts, Fibre::Secondary);
    assert_eq!(secondary.len(), 2);
    near(secondary[0], known.diverted.kink_speed_lagrangian * since, 1e-13);
    near(secondary[1], c * since, 1e-13);
    for at in [1e-3, 0.05] {
        near(strain(Fibre::Secondary, at), e * engineering.diversion, 1e-13);
    }
    near(-state(&fronts, Fibre::Secondary, 1e-3).velocity.x, known.junction_speed, 1e-13);
    near(state(&fronts, Fibre::Secondary, 0.05).velocity.z, -c * e * engineering.diversion, 1e-13);
    // Three meetings: with the crossover, with the kink, with the projectile.
    assert_eq!((fronts.events(), fronts.fronts()), (3, 7));
    // Their ways: the incident wave, the reflected one, the first kink, the wavelet that went on,
    // which have ended, and those on their way.
    let tracks = fronts.tracks();
    assert_eq!(tracks.len(), 4 + fronts.fronts());
    let incident = tracks[0];
    assert_eq!((incident.fibre, incident.family), (Fibre::Primary, Family::Longitudinal));
    assert_eq!((incident.from, incident.to.0), ((0.0, 0.0), 0.1));
    near(incident.to.1, x_c / c, 1e-14);
    near(incident.strength, e, 1e-14);
    let kink = tracks.iter().find(|track| track.family == Family::Kink).unwrap();
    near(kink.to.0, x_1, 1e-13);
    near(kink.to.1, t_1, 1e-13);
    near(
        kink.strength,
        known.incident.kink_speed_lagrangian / c
            * (2.0 * (1.0 - known.incident.angle_cosine)).sqrt()
            * (1.0 + e),
        1e-13,
    );
}
