use proptest::prelude::*;

use super::super::samples::{
    DENSITY, any_polynomial, concave_convex, convex_concave, twice_inflected, with_inflections,
};
use super::*;

/// The hull of 10⁵ sampled points by the monotone chain: its vertices in order of strain.
fn sampled(law: &Polynomial, low: f64, high: f64, concave: bool) -> Vec<(f64, f64)> {
    const POINTS: u32 = 100_000;
    let mut hull: Vec<(f64, f64)> = Vec::new();
    for i in 0..=POINTS {
        let x = low + (high - low) * f64::from(i) / f64::from(POINTS);
        let new = (x, law.tension(x));
        while let [.., a, b] = hull[..] {
            let turn = (b.0 - a.0) * (new.1 - a.1) - (b.1 - a.1) * (new.0 - a.0);
            if (turn < 0.0) == concave {
                break;
            }
            hull.pop();
        }
        hull.push(new);
    }
    hull
}

#[test]
fn wave_is_that_of_the_hull_of_a_hundred_thousand_points() {
    // Three concave parts; the middle one lies below the hull of the whole law, or on it.
    let hidden = with_inflections(DENSITY, 58.6e9, &[0.012, 0.029, 0.034, 0.061], false, 0.83);
    let touched = with_inflections(DENSITY, 58.6e9, &[0.01, 0.025, 0.06, 0.085], false, 0.83);
    for (law, low, high, shocks) in [
        (concave_convex(), 0.0, 0.0571, [1, 1]),
        (concave_convex(), 0.0053, 0.0391, [1, 1]),
        // So far into the convex part that the tangent point has left the law.
        (concave_convex(), 0.0, 0.0917, [1, 1]),
        (convex_concave(), 0.0, 0.0803, [1, 1]),
        (convex_concave(), 0.0211, 0.0453, [1, 1]),
        (twice_inflected(), 0.0, 0.0731, [1, 2]),
        (twice_inflected(), 0.0117, 0.0611, [1, 2]),
        (hidden.clone(), 0.0, 0.0973, [1, 1]),
        (hidden, 0.0017, 0.0443, [1, 2]),
        (touched.clone(), 0.0, 0.0731, [2, 1]),
        (touched, 0.0017, 0.0443, [1, 1]),
    ] {
        for (loading, shocks) in [true, false].into_iter().zip(shocks) {
            let (from, to) = if loading { (low, high) } else { (high, low) };
            let hull = sampled(&law, low, high, loading);
            let step = (high - low) / 1e5;
            let edges = hull.windows(2).map(|pair| (pair[0], pair[1]));
            let velocity: f64 =
                edges.clone().map(|(a, b)| ((b.1 - a.1) * (b.0 - a.0) / DENSITY).sqrt()).sum();
            // Touching points off by a step change W by its square; ΔT between neighbours has lost
            // five digits, at random.
            let found = law.wave_velocity(from, to).abs();
            assert!((found / velocity - 1.0).abs() < 1e-9, "{from} {to}: {found} {velocity}");

            let long: Vec<_> = edges.filter(|(a, b)| b.0 - a.0 > 4.0 * step).collect();
            let mut pieces = law.pieces(from, to);
            if !loading {
                pieces.reverse();
            }
            pieces.retain(|piece| piece.kind == Kind::Shock);
            assert_eq!((pieces.len(), long.len()), (shocks, shocks), "{from} {to} {pieces:?}");
            for (piece, (a, b)) in pieces.iter().zip(long) {
                // A sampled touching point is at most a step or two from the true one.
                let (p, q) = (piece.from.min(piece.to), piece.from.max(piece.to));
                assert!((p - a.0).abs() < 3.0 * step, "{from} {to}: {p} {}", a.0);
                assert!((q - b.0).abs() < 3.0 * step, "{from} {to}: {q} {}", b.0);
            }
        }
    }
}

#[test]
fn touching_points_agree_with_40_digits() {
    // T′(p) = T′(q) = [T]/[ε], and W by quadrature, solved in another language. W is stationary in
    // the touching points: a few roundings of the sums. The points: an ulp of T′ over T″, with
    // the cancellation in T′.
    let close = |found: f64, expected: f64, tolerance: f64| {
        assert!((found / expected - 1.0).abs() < tolerance, "{found} {expected}");
    };
    let law = concave_convex();
    let wave = law.pieces(0.0, 0.0571);
    let [fan, shock] = wave[..] else { panic!("{wave:?}") };
    close(fan.to, 0.014_579_770_992_366_413, 1e-13);
    close(shock.speeds.0, 5_201.665_449_104_286, 1e-14);
    close(law.wave_velocity(0.0, 0.0571), 307.207_205_224_901_77, 3e-15);
    let wave = law.pieces(0.0571, 0.0071);
    let [fan, shock] = wave[..] else { panic!("{wave:?}") };
    close(fan.to, 0.039_579_770_992_366_41, 1e-13);
    assert_eq!((fan.kind, shock.kind, shock.to), (Kind::Fan, Kind::Shock, 0.0071));
    close(law.wave_velocity(0.0571, 0.0071), -261.604_213_677_902_75, 3e-15);

    let law = twice_inflected();
    let wave = law.pieces(0.0, 0.0677);
    let [fan, shock, last] = wave[..] else { panic!("{wave:?}") };
    close(fan.to, 0.009_295_549_160_350_39, 1e-13);
    close(last.from, 0.064_704_690_842_046_35, 1e-13);
    assert_eq!(shock.kind, Kind::Shock);
    close(law.wave_velocity(0.0, 0.0677), 332.451_180_146_004_05, 3e-15);
}

/// The hull T̂ of a wave at a strain of one of its pieces.
fn hull_at(law: &Polynomial, piece: &Piece, strain: f64) -> f64 {
    match piece.kind {
        Kind::Fan => law.tension(strain),
        Kind::Shock => {
            law.tension(piece.from) + law.chord(piece.from, piece.to) * (strain - piece.from)
        }
    }
}

proptest! {
    #[test]
    fn any_wave_follows_the_hull(
        law in any_polynomial(),
        ends in (0.0..0.0997_f64, 0.0..0.0997_f64),
    ) {
        let (from, to) = ends;
        let pieces = law.pieces(from, to);
        let sign = if to > from { 1.0 } else { -1.0 };
        // Joined end to end, from the first strain to the last.
        prop_assert_eq!(pieces[0].from, from);
        prop_assert_eq!(pieces[pieces.len() - 1].to, to);
        // Speeds decrease. Where a shock touches a fan they are equal, each with the rounding of
        // T′, whose terms may be a thousand times their sum.
        let speeds: Vec<f64> =
            pieces.iter().flat_map(|piece| [piece.speeds.0, piece.speeds.1]).collect();
        prop_assert!(speeds.iter().all(|&s| s > 0.0), "{speeds:?}");
        for pair in speeds.windows(2) {
            prop_assert!(pair[1] <= pair[0] * (1.0 + 1e-11), "{speeds:?}");
        }
        let scale = law.tension(from).max(law.tension(to));
        for (i, piece) in pieces.iter().enumerate() {
            prop_assert!(i == 0 || pieces[i - 1].to == piece.from);
            prop_assert!(sign * (piece.to - piece.from) > 0.0, "{pieces:?}");
            // The entropy condition: T̂ ≥ T for loading, ≤ for unloading. As T̂ is bent one way (the
            // order of speeds) and meets T at every end of a piece, it is the hull.
            for part in 1..40 {
                let strain = piece.from + (piece.to - piece.from) * f64::from(part) / 40.0;
                let above = sign * (hull_at(&law, piece, strain) - law.tension(strain));
                prop_assert!(above > -1e-12 * scale, "{strain}: {above:e} {pieces:?}");
                // And T itself bends so inside a fan.
                let bend = sign * law.curvature(strain);
                prop_assert!(piece.kind == Kind::Shock || bend < 0.0, "{strain} {pieces:?}");
            }
        }
    }
}
