//! Inversion of the transforms by the trapezoidal rule on a circle.
//!
//! With X = x/c and T = t − X ≥ 0 every transform is F(s) e^(φ − st)/s, where
//! φ(s) = sT − X h(s), and F is √e for σ/(ρcv₀), 1/√e for ε/(v₀/c) and 1 for v/v₀. Its only
//! singularities are the cuts where e(s) ≤ 0 and the pole 0, all of them in −a ≤ s ≤ 0 with
//! a = 1/τ of the fastest arm, and it is regular at infinity. So behind the front the path of the
//! inversion closes to a circle around −a … 0, s = −a/2 + R e^(iθ):
//!
//! ```text
//! (1/2πi) ∮ F e^φ ds/s  ≈  (1/N) Σ_j [F e^φ (s + a/2)/s] at θ = 2πj/N
//! ```
//!
//! The rule converges geometrically in N, at the front as anywhere. The circle crosses the positive
//! real axis where e^φ/s is least; nowhere else on the circle is |e^φ/s| greater
//! (`docs/exact/viscoelastic.md`), so that no digits cancel but those of a sum of like terms.

use nalgebra::Complex;

use super::super::root::first_where;
use super::RodError;
use super::relaxation::{Relaxation, exponential, square_root};

/// Points on the circle, at first and at most.
const POINTS: (u64, u64) = (32, 1 << 30);

/// Two sums, the second with twice the points, agree when they differ by less than this part of
/// the sum of the absolute terms. Doubling squares the error, so 1e-20 of that would be left.
const AGREEMENT: f64 = 1e-10;

/// Terms with |e^(sT)| below e⁻⁴⁵ = 3e-20 of the first one are left out.
const NEGLIGIBLE: f64 = 45.0;

/// σ/(ρcv₀), ε/(v₀/c) and v/v₀ at X = `path` (s) and T = `since` > 0 (s).
pub(super) fn at(relaxation: &Relaxation, path: f64, since: f64) -> Result<[f64; 3], RodError> {
    let circle = Circle::new(relaxation, path, since);
    let (mut points, last) = POINTS;
    let mut terms = circle.terms(points, 0, 1);
    while points < last {
        let coarse = terms.mean(points);
        points *= 2;
        terms = terms.with(circle.terms(points, 1, 2));
        let fine = terms.mean(points);
        if (0..3).all(|i| (fine.sum[i] - coarse.sum[i]).abs() <= AGREEMENT * fine.absolute[i]) {
            return Ok(fine.sum);
        }
    }
    Err(RodError::Unsettled { points })
}

/// Sums over points of the circle.
#[derive(Debug, Clone, Copy)]
struct Terms {
    sum: [f64; 3],
    absolute: [f64; 3],
}

impl Terms {
    fn with(self, more: Self) -> Self {
        let plus = |a: [f64; 3], b: [f64; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
        Self { sum: plus(self.sum, more.sum), absolute: plus(self.absolute, more.absolute) }
    }

    fn mean(self, points: u64) -> Self {
        let over = |a: [f64; 3]| a.map(|value| value / points as f64);
        Self { sum: over(self.sum), absolute: over(self.absolute) }
    }
}

struct Circle<'a> {
    relaxation: &'a Relaxation,
    path: f64,
    since: f64,
    /// Where the circle crosses the positive real axis, 1/s.
    crossing: f64,
    /// R, 1/s.
    radius: f64,
}

impl<'a> Circle<'a> {
    fn new(relaxation: &'a Relaxation, path: f64, since: f64) -> Self {
        let fastest = relaxation.fastest_rate();
        // φ − ln s is convex on s > 0. Its least point recedes as T → 0; up to here is far enough:
        // |h(∞) − h(s)| X < 1 there, and the cuts lie within a ninth of the radius.
        let far = fastest * (4.0 + relaxation.front_decay() * path);
        let rises = |s: f64| since - path * relaxation.lag_slope(s) - 1.0 / s >= 0.0;
        let crossing = if rises(far) { first_where(0.0, far, rises) } else { far };
        Self { relaxation, path, since, crossing, radius: crossing + 0.5 * fastest }
    }

    /// Sums over points `first`, `first` + `step`, … of N on the circle. The terms below the real
    /// axis are the conjugates of those above it.
    fn terms(&self, points: u64, first: u64, step: usize) -> Terms {
        let mut terms = Terms { sum: [0.0; 3], absolute: [0.0; 3] };
        for j in (first..=points / 2).step_by(step) {
            // s = crossing − 2R sin²(θ/2) + 2iR sin(θ/2) cos(θ/2): no digit of a small s is lost.
            let (sine, cosine) = pxfm::f_sincospi(j as f64 / points as f64);
            let chord = 2.0 * self.radius * sine;
            if chord * sine * self.since > NEGLIGIBLE {
                break;
            }
            let s = Complex::new(self.crossing - chord * sine, chord * cosine);
            let count = if j == 0 || j == points / 2 { 1.0 } else { 2.0 };
            for (i, value) in self.integrand(s).into_iter().enumerate() {
                terms.sum[i] += count * value.re;
                terms.absolute[i] += count * (value.re.abs() + value.im.abs());
            }
        }
        terms
    }

    /// F e^φ (s + a/2)/s.
    fn integrand(&self, s: Complex<f64>) -> [Complex<f64>; 3] {
        let e = self.relaxation.modulus(s);
        let root = square_root(e);
        let phi = s * self.since - self.relaxation.lag(s, e, root) * self.path;
        let value = exponential(phi) * (s + (self.radius - self.crossing)) / s;
        [value * root, value / root, value]
    }
}
