//! Polygons in a curved law.

use super::super::super::elastic::{Elastic, Hyperelastic};
use super::super::super::quadrature::integral;
use super::super::super::smith::{Fibre as Section, Law, smith};
use super::*;

const LAW: Hyperelastic = Hyperelastic {
    law: Law::Logarithmic,
    fibre: Section { modulus: 58.6e9, density: 1206.7, area: 1e-6 },
};

/// Its tension by straight lines between the vertices, and that line's slope over ρ.
fn chord(spacing: f64, strain: f64) -> (f64, f64) {
    let tension = |k: f64| 58.6e9 * pxfm::f_log1p(k * spacing);
    let k = (strain / spacing).floor();
    let slope = (tension(k + 1.0) - tension(k)) / spacing;
    (tension(k) + slope * (strain - k * spacing), slope / 1206.7)
}

#[test]
fn polygon_is_made_of_chords_of_its_law() {
    let spacing = 0.0137;
    let polygon = Polygon::inscribed(&LAW, spacing, 60);
    assert_eq!(polygon.density(), 1206.7);
    assert!((polygon.greatest_strain() / (60.0 * spacing) - 1.0).abs() < 1e-15);
    for strain in [3.1e-9, 0.0071, 0.0137, 0.0139, 0.5013] {
        let (tension, square) = chord(spacing, strain);
        assert!((polygon.tension(strain) / tension - 1.0).abs() < 1e-14);
        // At a vertex rounding chooses the chord.
        if strain != spacing {
            let speed = polygon.wave_speeds(strain, strain).0;
            assert!((speed * speed / square - 1.0).abs() < 1e-12);
            let modulus = polygon.tangent_modulus(strain);
            assert!((modulus / (1206.7 * square) - 1.0).abs() < 1e-12, "{modulus}");
        }
        let kink = (tension / (1206.7 * (1.0 + strain))).sqrt();
        assert!((polygon.kink_speed(strain) / kink - 1.0).abs() < 1e-14);
        // Inscribed: short of the law by at most Eh²/8.
        let short = LAW.tension(strain) - polygon.tension(strain);
        assert!(short > -1e-4 && short < 58.6e9 * spacing * spacing / 8.0, "{short}");
    }
}

#[test]
fn energy_of_a_line_is_half_of_what_it_pulls_through() {
    // 58.6e9 × 0.0137²/2 by hand; tolerance: three roundings.
    assert!((ARAMID.stored_energy(0.0137) / 5_499_317.0 - 1.0).abs() < 4e-16);
}

#[test]
fn energy_of_a_polygon_is_the_area_under_it() {
    // ½(T + T′) over a chord is short of the law's integral by T″h³/12, which adds up to
    // h²/12 of the fall of T′; T‴ takes 3h/4 of that away or adds it.
    let spacing = 0.0013;
    let polygon = Polygon::inscribed(&LAW, spacing, 300);
    for chords in [3.0, 31.0, 270.0] {
        let strain: f64 = chords * spacing;
        let short = LAW.stored_energy(strain) - polygon.stored_energy(strain);
        let fall = LAW.tangent_modulus(0.0) - LAW.tangent_modulus(strain);
        let error = short / (spacing * spacing / 12.0 * fall) - 1.0;
        assert!(error.abs() < spacing, "{chords}: {error}");
    }
    // Within a chord the tension is a straight line.
    let (from, to) = (31.2 * spacing, 31.7 * spacing);
    let mean = (polygon.tension(from) + polygon.tension(to)) / 2.0;
    let area = polygon.stored_energy(to) - polygon.stored_energy(from);
    assert!((area / (mean * (to - from)) - 1.0).abs() < 1e-11, "{area}");
}

#[test]
fn wave_of_no_width_is_one_jump_of_nothing_at_the_speed_of_its_chord() {
    let spacing = 0.0137;
    let polygon = Polygon::inscribed(&LAW, spacing, 60);
    for strain in [0.0, 0.0071, 0.5013] {
        let speed = polygon.wave_speeds(strain, strain).0;
        let [jump] = polygon.pieces(strain, strain)[..] else { panic!("not one piece") };
        assert_eq!((jump.from, jump.to, jump.velocity), (strain, strain, 0.0));
        assert_eq!(jump.speeds, (speed, speed));
        assert_eq!(polygon.wave_velocity(strain, strain), 0.0);
    }
}

#[test]
fn loading_is_a_row_of_chords_and_unloading_one_shock() {
    let spacing = 0.0137;
    let polygon = Polygon::inscribed(&LAW, spacing, 60);
    for (from, to) in
        [(0.0, 0.0071), (0.0, 0.0911), (0.0031, 0.0049), (0.0031, 0.5013), (0.0411, 0.0548)]
    {
        let jumps = polygon.pieces(from, to);
        // W by quadrature of √(slope/ρ), chord by chord.
        let (mut strain, mut inflow) = (from, 0.0);
        while strain < to {
            let end = (((strain / spacing + 1e-9).floor() + 1.0) * spacing).min(to);
            inflow += integral(strain, end, |s| chord(spacing, s).1.sqrt());
            strain = end;
        }
        let found = polygon.wave_velocity(from, to);
        assert!((found / inflow - 1.0).abs() < 1e-12, "{from} {to}: {found} {inflow}");
        // Each jump balances momentum, ρs² = [T]/[ε], and the foremost is the fastest.
        let (mut ahead, mut sum, mut faster) = (from, 0.0, f64::INFINITY);
        for jump in jumps {
            let (behind, speed) = (jump.to, jump.speeds.0);
            assert_eq!((jump.from, jump.speeds.1), (ahead, speed));
            assert!((jump.velocity / (speed * (behind - ahead)) - 1.0).abs() < 1e-15);
            let square = (chord(spacing, behind - 1e-12).0 - chord(spacing, ahead + 1e-12).0)
                / (1206.7 * (behind - ahead - 2e-12));
            assert!((speed * speed / square - 1.0).abs() < 1e-9, "{from} {to}: {behind}");
            assert!(speed < faster && behind > ahead);
            sum += speed * (behind - ahead);
            (ahead, faster) = (behind, speed);
        }
        assert_eq!(ahead, to);
        assert!((sum / inflow - 1.0).abs() < 1e-12);
        // And back: Rankine–Hugoniot, with the slope of the law's own chord.
        let [shock] = polygon.pieces(to, from)[..] else { panic!() };
        let (behind, speed) = (shock.to, shock.speeds.0);
        let square = (chord(spacing, to).0 - chord(spacing, from).0) / (1206.7 * (to - from));
        assert_eq!(behind, from);
        assert!((speed * speed / square - 1.0).abs() < 1e-12);
        let back = polygon.wave_velocity(to, from);
        assert!((back / (-speed * (to - from)) - 1.0).abs() < 1e-12);
    }
}

#[test]
fn weakest_waves_have_the_speed_of_their_chord() {
    // Two tensions 1e-16 apart are the same double, or in the wrong order.
    let polygon = Polygon::inscribed(&LAW, 0.0137, 60);
    for strain in [0.0073, 0.0311, 0.5013, 0.0137, 0.0274, 0.0411] {
        for weak in [1e-17, 1e-16, 1e-15, 3e-13] {
            let (from, to) = (strain * (1.0 + weak), strain * (1.0 - weak));
            let speed = polygon.wave_speeds(strain, strain).0;
            // The neighbouring chord is 0.7 % slower or faster.
            let (shock, _) = polygon.wave_speeds(from, to);
            assert!((shock / speed - 1.0).abs() < 0.01, "{strain} {weak:e}: {shock}");
            let velocity = polygon.wave_velocity(from, to);
            assert!((velocity + speed * (from - to)).abs() <= 0.01 * speed * (from - to));
        }
    }
}

#[test]
fn state_of_smith_is_approached_with_the_second_order() {
    let sound = LAW.fibre.wave_speed();
    let known = smith(Law::Logarithmic, sound, 411.3).unwrap().strain.engineering;
    // Half a chord is left over in each.
    let errors = [4.5, 8.5, 16.5].map(|chords| {
        let material = Polygon::inscribed(&LAW, known / chords, 40);
        let primary = Clamped { material, area: 1e-6, length: 0.3 };
        let problem = Problem { primary, secondary: None, velocity: 411.3 };
        let mut fronts = Fronts::new(&problem, Limits { resolution: 1e-12, events: 100 });
        fronts.advance(31e-6).unwrap();
        // One front for each chord and the kink.
        assert_eq!(fronts.fronts(), chords as usize + 2);
        (chords, state(&fronts, Fibre::Primary, 1e-4).strain - known)
    });
    for pair in errors.windows(2) {
        let [(coarse, large), (fine, small)] = pair else { unreachable!() };
        let order = (large / small).log2() / (fine / coarse).log2();
        // Second order, with a correction of a relative 1/chords that shrinks.
        assert!((order - 2.0).abs() < 0.1, "{order}: {large:e} {small:e}");
        assert!((large / known).abs() < 1e-3);
    }
}

#[test]
fn projectile_that_slows_down_sends_a_shock_that_takes_energy_out() {
    let (spacing, time) = (0.0137, 13.1e-6);
    let material = Polygon::inscribed(&LAW, spacing, 60);
    let primary = Clamped { material, area: 1e-6, length: 0.1 };
    let problem = Problem { primary, secondary: None, velocity: 911.3 };
    let mut fronts = Fronts::new(&problem, Limits { resolution: 1e-14, events: 10_000 });
    // ∫T dε of the polygon, which is linear between vertices: trapezia.
    let stored = |strain: f64| {
        let whole = (strain / spacing).floor() as usize;
        let vertices = (0..=whole).map(|k| k as f64 * spacing).chain([strain]);
        let points: Vec<_> = vertices.map(|s| (s, chord(spacing, s).0)).collect();
        points.windows(2).map(|p| (p[1].0 - p[0].0) * (p[1].1 + p[0].1) / 2.0).sum::<f64>()
    };
    let lost = |fronts: &Fronts<Polygon>| {
        let energy = total(fronts, Fibre::Primary, |s| {
            let kinetic = 1206.7 * s.velocity.norm_squared() / 2.0;
            Vector3::x() * (1e-6 * (kinetic + stored(s.strain)))
        });
        1.0 - energy.x / fronts.accounts().work
    };
    fronts.advance(7.9e-6).unwrap();
    // A loading fan takes nothing.
    assert!(lost(&fronts).abs() < 1e-13);
    fronts.strike(311.7);
    fronts.advance(time).unwrap();
    let gone = lost(&fronts);
    // The area between chord and law is −T″[ε]³/12, about 1e-3 of T ε/2 for the shock from 0.045
    // to 0.016, which crosses a third of what is strained.
    assert!((1e-4..1e-3).contains(&gone), "{gone:e}");
    let momentum = total(&fronts, Fibre::Primary, |s| s.velocity * 1206.7e-6);
    let impulse = fronts.accounts().impulse;
    // Rounding of positions, and what is left out.
    assert!((momentum - impulse).norm() < 1e-12 * impulse.norm());
    let reach = total(&fronts, Fibre::Primary, |s| s.direction * (1.0 + s.strain));
    let travelled = 911.3 * 7.9e-6 + 311.7 * (time - 7.9e-6);
    assert!((reach - Vector3::new(0.1, -travelled, 0.0)).norm() < 1e-13);
}
