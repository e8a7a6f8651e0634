use proptest::prelude::*;

use super::super::elastic::Hyperelastic;
use super::super::quadrature::integral;
use super::super::samples::{
    any_polynomial, concave_convex, convex_concave, exponential_hardening, exponential_softening,
    last_strain, softening, twice_inflected,
};
use super::super::smith::{Fibre, Law};
use super::*;

/// Length, momentum and energy of a wave, integrated over ξ = X/t from the impact point to beyond
/// the front with the profile of [`Wave::strain_at`]; relative residuals, and the dissipation over
/// the power that comes in.
fn balances<M: Elastic>(material: &M, from: f64, to: f64) -> ([f64; 3], f64) {
    let (rho, wave) = (material.density(), Wave::between(material, from, to));
    let psi = |strain| material.stored_energy(strain) - material.stored_energy(from);
    // ε − ε₋, ρv and ψ − ψ₋ + ½ρv², at strain ε and velocity v.
    let densities = |strain: f64, v: f64| [strain - from, rho * v, psi(strain) + rho * v * v / 2.0];
    let mut sums = [0.0; 3];
    let mut add = |width: f64, at: &dyn Fn(f64) -> [f64; 3], start: f64| {
        for (k, sum) in sums.iter_mut().enumerate() {
            *sum += integral(start, start + width, |xi| at(xi)[k]);
        }
    };
    let (mut v, mut after) = (0.0, (from, 0.0));
    let mut last_speed = f64::NAN;
    for piece in wave.pieces() {
        let (strain, velocity) = after;
        if last_speed.is_finite() {
            // Uniform fibre between two pieces; none where they touch.
            add(last_speed - piece.speeds.0, &|_| densities(strain, velocity), piece.speeds.0);
        }
        if piece.kind == Kind::Fan {
            // ξ = ξ₋ + [ξ]t³(10 − 15t + 6t²): a fan that starts near an inflection has a profile like
            // a root there, which this flattens.
            let (first, last) = piece.speeds;
            let inside = |t: f64| {
                let xi = last + (first - last) * t * t * t * (10.0 - t * (15.0 - 6.0 * t));
                let weight = (first - last) * 30.0 * t * t * (1.0 - t) * (1.0 - t);
                let strain = wave.strain_at(xi);
                let v = v + material.wave_velocity(piece.from, strain);
                densities(strain, v).map(|density| density * weight)
            };
            add(1.0, &inside, 0.0);
        }
        v += piece.velocity;
        (after, last_speed) = ((piece.to, v), piece.speeds.1);
    }
    add(last_speed, &|_| densities(to, v), 0.0);

    let [length, momentum, energy] = sums;
    let (pull, power) = (material.tension(to) - material.tension(from), material.tension(to) * v);
    // The fibre ahead holds on at T₋, but at rest, so it does no work.
    let spent = energy + wave.dissipation();
    // The terms of the energy of a step that unloads cancel: relative to the greatest.
    let scale = power.abs().max((last_speed * psi(to)).abs());
    ([length / v - 1.0, momentum / pull - 1.0, (spent - power) / scale], wave.dissipation() / scale)
}

#[test]
fn waves_of_every_law_balance_length_momentum_and_energy() {
    fn check<M: Elastic + std::fmt::Debug>(material: &M, dissipates: [bool; 2]) {
        for (ends, dissipates) in [(0.0, 0.0683), (0.0683, 0.0041)].into_iter().zip(dissipates) {
            let (residuals, lost) = balances(material, ends.0, ends.1);
            // Sums of 768 terms over each fan; the strain in a fan is known to an ulp of T′ over
            // T″, and T′ has lost up to a factor of 30.
            for residual in residuals {
                assert!(residual.abs() < 1e-12, "{material:?} {ends:?}: {residuals:?}");
            }
            // A shock of a law that is not linear dissipates; without one nothing is lost but an
            // ulp or two.
            assert!(
                if dissipates { lost > 1e-4 } else { lost.abs() < 1e-15 },
                "{material:?} {lost:e}"
            );
        }
    }
    let fibre = Fibre { modulus: 58.6e9, density: 1206.7, area: 1.37e-8 };
    check(&Hyperelastic { law: Law::Engineering, fibre }, [false, false]);
    check(&exponential_hardening(), [true, false]);
    check(&exponential_softening(), [false, true]);
    check(&softening(), [false, true]);
    check(&concave_convex(), [true, true]);
    check(&convex_concave(), [true, true]);
    check(&twice_inflected(), [true, true]);
    // The logarithmic law bends less: greater strains.
    let logarithmic = Hyperelastic { law: Law::Logarithmic, fibre };
    for (from, to, least) in [(0.041, 0.683, 0.0), (0.683, 0.041, 1e-3)] {
        let (residuals, lost) = balances(&logarithmic, from, to);
        assert!(residuals.iter().all(|r| r.abs() < 1e-12) && lost >= least, "{residuals:?} {lost}");
    }
}

#[test]
fn profile_goes_through_fans_and_jumps_at_shocks() {
    let law = twice_inflected();
    let wave = Wave::between(&law, 0.0, 0.0677);
    let [fan, shock, last] = wave.pieces()[..] else { panic!("{wave:?}") };
    assert_eq!(wave.strain_at(1.001 * fan.speeds.0), 0.0);
    assert_eq!(wave.strain_at(0.999 * last.speeds.1), 0.0677);
    assert_eq!(wave.strain_at(0.0), 0.0677);
    for (piece, part) in [(fan, 0.317), (fan, 0.911), (last, 0.173), (last, 0.739)] {
        let xi = piece.speeds.0 + part * (piece.speeds.1 - piece.speeds.0);
        let strain = wave.strain_at(xi);
        assert!(piece.from < strain && strain < piece.to, "{strain}");
        // ξ² = T′/ρ: an ulp of strain, and the rounding of T′.
        let back = (law.tangent_modulus(strain) / law.density()).sqrt();
        assert!((back / xi - 1.0).abs() < 1e-14, "{back} {xi}");
    }
    // At a shock, the strain ahead.
    assert_eq!(wave.strain_at(shock.speeds.0), shock.from);
    // Across the shock, from one touching point to the other: to first order in the 1e-9 of speed.
    let (ahead, behind) = (
        wave.strain_at(shock.speeds.0 * (1.0 + 1e-9)),
        wave.strain_at(shock.speeds.0 * (1.0 - 1e-9)),
    );
    assert!(
        (ahead - shock.from).abs() < 1e-9 && (behind - shock.to).abs() < 1e-9,
        "{ahead} {behind}"
    );

    // Unloading of a hardening law is a fan, in which the strain falls.
    let law = exponential_hardening();
    let wave = Wave::between(&law, 0.0413, 0.0127);
    let (first, last) = law.wave_speeds(0.0413, 0.0127);
    let strain = wave.strain_at((first + last) / 2.0);
    let back = (law.tangent_modulus(strain) / law.density()).sqrt();
    assert!((back / ((first + last) / 2.0) - 1.0).abs() < 1e-14, "{back}");
    assert_eq!((wave.strain_at(first), wave.strain_at(last)), (0.0413, 0.0127));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn waves_of_any_polynomial_balance(
        law in any_polynomial(),
        parts in (0.0..1.0_f64, 0.0..1.0_f64),
    ) {
        let last = last_strain(&law);
        let (from, to) = (last * parts.0, last * parts.1);
        prop_assume!((to - from).abs() > 1e-3 * last);
        let (residuals, lost) = balances(&law, from, to);
        // The velocity and the profile lose what ε₊ − ε₋ is smaller than ε, T′ what its terms cancel.
        let tolerance = 1e-11 * last / (to - from).abs();
        prop_assert!(residuals.iter().all(|r| r.abs() < tolerance), "{residuals:?}");
        prop_assert!(lost > -1e-15, "{lost:e}");
    }
}
