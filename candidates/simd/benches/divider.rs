//! How many quotients and roots the machine's divider gives, and what that allows an element-step.
//!
//! `cargo bench -p crossfibre-simd`

#[cfg(target_arch = "x86_64")]
fn main() -> anyhow::Result<()> {
    avx512::print()
}

#[cfg(not(target_arch = "x86_64"))]
fn main() {
    println!("Only AVX-512's divider is measured.");
}

#[cfg(target_arch = "x86_64")]
mod avx512 {
    use std::hint::black_box;

    use anyhow::Result;
    use crossfibre_simd::lanes::{Avx512, Lanes, Work};
    use crossfibre_verification::timing::{Contestant, Turn, clocked, turns};

    type V = <Avx512 as Lanes>::V;

    const ROUNDS: usize = 9;

    /// Operations in one measurement.
    const MANY: u64 = 4_000_000;

    /// Independent chains, more than the divider can overlap.
    const CHAINS: usize = 8;

    /// One operation of the divider on eight doubles, many times.
    struct Many<F>(F);

    impl<F: Fn(Avx512, V) -> V> Work<Avx512> for Many<F> {
        #[inline(always)]
        fn run(self, lanes: Avx512) {
            let mut x: [_; CHAINS] = std::array::from_fn(|i| lanes.splat(1.37 + 0.1 * i as f64));
            for _ in 0..MANY / CHAINS as u64 {
                for x in &mut x {
                    *x = (self.0)(lanes, *x);
                }
            }
            black_box(x.map(|x| lanes.array(x)));
        }
    }

    fn contestant(
        name: &str,
        lanes: Avx512,
        operation: impl Fn(Avx512, V) -> V + Copy + 'static,
    ) -> Contestant<'static> {
        Contestant::new(name, move || {
            let (seconds, ()) = clocked(|| lanes.compile(Many(operation)));
            Ok(Turn { seconds, element_steps: MANY, checksum: None })
        })
    }

    pub fn print() -> Result<()> {
        let Some(lanes) = Avx512::detect() else {
            println!("No AVX-512 here: its divider is not measured.");
            return Ok(());
        };
        #[rustfmt::skip] // `inline` before a closure
        let mut both = [
            contestant("root", lanes, #[inline(always)] |lanes, x| lanes.root(x)),
            contestant("quotient", lanes, #[inline(always)] |lanes, x| lanes.reciprocal(x)),
        ];
        let nanoseconds: Vec<_> =
            turns(ROUNDS, &mut both)?.iter().map(|timed| 1e9 * timed.per_element_step()).collect();
        let (root, quotient) = (nanoseconds[0], nanoseconds[1]);
        println!("{root:.2} ns for eight square roots, {quotient:.2} ns for eight quotients.");
        println!("What that takes for an element-step, ns:");
        for (roots, quotients, what) in [
            (2.0, 2.0, "the literal count"),
            (1.0, 2.0, "keeping the length"),
            (1.0, 1.0, "and one reciprocal for both quotients"),
        ] {
            let each = (roots * root + quotients * quotient) / 8.0;
            println!("{roots} roots, {quotients} quotients: {each:.3}  {what}");
        }
        Ok(())
    }
}
