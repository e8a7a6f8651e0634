//! Four doubles: AVX2 with fused multiply-add.
//!
//! Roots come from the divider, quotients from a reciprocal of the divider and the multipliers
//! ([`crate::division`]).

#[allow(clippy::wildcard_imports)] // some twenty intrinsics
use std::arch::x86_64::*;

use super::{Lanes, Work};
use crate::division::LEAST_LENGTH;

/// A processor with AVX2 and FMA.
#[derive(Clone, Copy, Debug)]
pub struct Avx2(());

impl Avx2 {
    /// If this is one.
    pub fn detect() -> Option<Self> {
        (is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")).then_some(Self(()))
    }
}

/// An intrinsic, in a method of [`Avx2`].
macro_rules! avx2 {
    ($call:expr) => {
        // SAFETY: the intrinsics of this file take and give values, and need AVX2 and FMA: a value
        // of `Avx2`, which `self` is, is only made where both have been detected.
        unsafe { $call }
    };
}

impl Lanes for Avx2 {
    const COUNT: usize = 4;
    type V = __m256d;
    type Array = [f64; 4];

    fn compile(self, work: impl Work<Self>) {
        #[target_feature(enable = "avx2,fma")]
        fn compiled(lanes: Avx2, work: impl Work<Avx2>) {
            work.run(lanes);
        }
        avx2!(compiled(self, work));
    }
    #[inline(always)]
    fn splat(self, x: f64) -> __m256d {
        avx2!(_mm256_set1_pd(x))
    }
    #[inline(always)]
    fn vector(self, x: [f64; 4]) -> __m256d {
        // SAFETY: both are 32 bytes that may have any value.
        unsafe { std::mem::transmute(x) }
    }
    #[inline(always)]
    fn array(self, x: __m256d) -> [f64; 4] {
        // SAFETY: both are 32 bytes that may have any value.
        unsafe { std::mem::transmute(x) }
    }
    #[inline(always)]
    fn add(self, x: __m256d, y: __m256d) -> __m256d {
        avx2!(_mm256_add_pd(x, y))
    }
    #[inline(always)]
    fn sub(self, x: __m256d, y: __m256d) -> __m256d {
        avx2!(_mm256_sub_pd(x, y))
    }
    #[inline(always)]
    fn mul(self, x: __m256d, y: __m256d) -> __m256d {
        avx2!(_mm256_mul_pd(x, y))
    }
    #[inline(always)]
    fn root(self, x: __m256d) -> __m256d {
        avx2!(_mm256_sqrt_pd(x))
    }
    #[inline(always)]
    fn reciprocal(self, x: __m256d) -> __m256d {
        avx2!(_mm256_div_pd(_mm256_set1_pd(1.0), x))
    }
    /// By the reciprocal: see [`crate::division`].
    #[inline(always)]
    fn divide(self, x: __m256d, y: __m256d, reciprocal: __m256d) -> __m256d {
        let near = self.mul(x, reciprocal);
        let remainder = avx2!(_mm256_fnmadd_pd(y, near, x));
        avx2!(_mm256_fmadd_pd(remainder, reciprocal, near))
    }
    #[inline(always)]
    fn one_before(self, before: __m256d, here: __m256d) -> __m256d {
        // [before 2, before 3, here 0, here 1], and of that and `here` every other pair.
        let middle = avx2!(_mm256_permute2f128_pd::<0x21>(before, here));
        avx2!(_mm256_shuffle_pd::<0b0101>(middle, here))
    }
    #[inline(always)]
    fn one_ahead(self, here: __m256d, after: __m256d) -> __m256d {
        let middle = avx2!(_mm256_permute2f128_pd::<0x21>(here, after));
        avx2!(_mm256_shuffle_pd::<0b0101>(here, middle))
    }
    #[inline(always)]
    fn is_ordinary(self, length: __m256d, strain: __m256d, most_strain: __m256d) -> bool {
        let rooted = avx2!(_mm256_cmp_pd::<_CMP_GE_OQ>(length, self.splat(LEAST_LENGTH)));
        let strained = avx2!(_mm256_cmp_pd::<_CMP_LT_OQ>(strain, most_strain));
        avx2!(_mm256_movemask_pd(_mm256_and_pd(rooted, strained))) == 0b1111
    }
    #[inline(always)]
    fn any_at_most(self, x: __m256d, y: __m256d) -> bool {
        avx2!(_mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LE_OQ>(x, y))) != 0
    }
}
