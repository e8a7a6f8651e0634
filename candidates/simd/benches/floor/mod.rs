//! How many quotients and roots the machine's divider gives, and what that allows.

use std::hint::black_box;
use std::time::Instant;

use crossfibre_simd::lanes::{Avx512, Lanes, Work};

/// Operations in one measurement.
const MANY: usize = 4_000_000;

/// Independent chains, more than the divider can overlap.
const CHAINS: usize = 8;

/// Seconds of one operation of the divider on eight doubles.
struct Timing<'a, F> {
    operation: F,
    seconds: &'a mut f64,
}

impl<F: Fn(Avx512, <Avx512 as Lanes>::V) -> <Avx512 as Lanes>::V> Work<Avx512> for Timing<'_, F> {
    #[inline(always)]
    fn run(self, lanes: Avx512) {
        let mut x: [_; CHAINS] = std::array::from_fn(|i| lanes.splat(1.37 + 0.1 * i as f64));
        let start = Instant::now();
        for _ in 0..MANY / CHAINS {
            for x in &mut x {
                *x = (self.operation)(lanes, *x);
            }
        }
        *self.seconds = start.elapsed().as_secs_f64() / MANY as f64;
        black_box(x.map(|x| lanes.array(x)));
    }
}

/// The least of several measurements.
fn seconds(
    lanes: Avx512,
    operation: impl Fn(Avx512, <Avx512 as Lanes>::V) -> <Avx512 as Lanes>::V + Copy,
) -> f64 {
    (0..9).fold(f64::INFINITY, |least, _| {
        let mut seconds = 0.0;
        lanes.compile(Timing { operation, seconds: &mut seconds });
        least.min(seconds)
    })
}

/// Prints what the divider takes for an element-step.
pub fn print() {
    let Some(lanes) = Avx512::detect() else {
        return println!("No AVX-512 here: its divider is not measured.");
    };
    let root = 1e9
        * seconds(
            lanes,
            #[inline(always)]
            |lanes, x| lanes.root(x),
        );
    let quotient = 1e9
        * seconds(
            lanes,
            #[inline(always)]
            |lanes, x| lanes.reciprocal(x),
        );
    println!("Divider: {root:.2} ns for eight square roots, {quotient:.2} ns for eight quotients.");
    println!("What it takes for an element-step, ns:");
    for (roots, quotients, what) in [
        (2.0, 2.0, "the literal count"),
        (1.0, 2.0, "keeping the length"),
        (1.0, 1.0, "and one reciprocal for both quotients"),
    ] {
        let nanoseconds = (roots * root + quotients * quotient) / 8.0;
        println!("{roots} roots, {quotients} quotients: {nanoseconds:.3}  {what}");
    }
}
