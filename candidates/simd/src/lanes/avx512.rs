//! Eight doubles: AVX-512F.
//!
//! Roots come from the divider or from the multipliers, quotients from a reciprocal of the divider
//! and the multipliers: [`crate::division`] says why their bits are those of `√` and `÷`.

#[allow(clippy::wildcard_imports)] // some twenty intrinsics
use std::arch::x86_64::*;

use super::{Lanes, Work};
use crate::division::LEAST_LENGTH;

/// A processor with AVX-512F.
#[derive(Clone, Copy, Debug)]
pub struct Avx512(());

impl Avx512 {
    /// If this is one.
    pub fn detect() -> Option<Self> {
        is_x86_feature_detected!("avx512f").then_some(Self(()))
    }
}

/// An intrinsic, in a method of [`Avx512`].
macro_rules! avx512 {
    ($call:expr) => {
        // SAFETY: the intrinsics of this file take and give values, and need AVX-512F: a value of
        // `Avx512`, which `self` is, is only made where it has been detected.
        unsafe { $call }
    };
}

impl Lanes for Avx512 {
    const COUNT: usize = 8;
    type V = __m512d;
    type Array = [f64; 8];

    fn compile(self, work: impl Work<Self>) {
        #[target_feature(enable = "avx512f")]
        fn compiled(lanes: Avx512, work: impl Work<Avx512>) {
            work.run(lanes);
        }
        avx512!(compiled(self, work));
    }
    #[inline(always)]
    fn splat(self, x: f64) -> __m512d {
        avx512!(_mm512_set1_pd(x))
    }
    #[inline(always)]
    fn vector(self, x: [f64; 8]) -> __m512d {
        // SAFETY: both are 64 bytes that may have any value.
        unsafe { std::mem::transmute(x) }
    }
    #[inline(always)]
    fn array(self, x: __m512d) -> [f64; 8] {
        // SAFETY: both are 64 bytes that may have any value.
        unsafe { std::mem::transmute(x) }
    }
    #[inline(always)]
    fn add(self, x: __m512d, y: __m512d) -> __m512d {
        avx512!(_mm512_add_pd(x, y))
    }
    #[inline(always)]
    fn sub(self, x: __m512d, y: __m512d) -> __m512d {
        avx512!(_mm512_sub_pd(x, y))
    }
    #[inline(always)]
    fn mul(self, x: __m512d, y: __m512d) -> __m512d {
        avx512!(_mm512_mul_pd(x, y))
    }
    #[inline(always)]
    fn root(self, x: __m512d) -> __m512d {
        avx512!(_mm512_sqrt_pd(x))
    }
    #[inline(always)]
    fn reciprocal(self, x: __m512d) -> __m512d {
        avx512!(_mm512_div_pd(_mm512_set1_pd(1.0), x))
    }
    /// By the reciprocal: see [`crate::division`].
    #[inline(always)]
    fn divide(self, x: __m512d, y: __m512d, reciprocal: __m512d) -> __m512d {
        let near = self.mul(x, reciprocal);
        let remainder = avx512!(_mm512_fnmadd_pd(y, near, x));
        avx512!(_mm512_fmadd_pd(remainder, reciprocal, near))
    }
    #[inline(always)]
    fn one_before(self, before: __m512d, here: __m512d) -> __m512d {
        avx512!(_mm512_castsi512_pd(_mm512_alignr_epi64::<7>(
            _mm512_castpd_si512(here),
            _mm512_castpd_si512(before)
        )))
    }
    #[inline(always)]
    fn one_ahead(self, here: __m512d, after: __m512d) -> __m512d {
        avx512!(_mm512_castsi512_pd(_mm512_alignr_epi64::<1>(
            _mm512_castpd_si512(after),
            _mm512_castpd_si512(here)
        )))
    }
    #[inline(always)]
    fn is_ordinary(self, length: __m512d, strain: __m512d, most_strain: __m512d) -> bool {
        let rooted = avx512!(_mm512_cmp_pd_mask::<_CMP_GE_OQ>(length, self.splat(LEAST_LENGTH)));
        let both = avx512!(_mm512_mask_cmp_pd_mask::<_CMP_LT_OQ>(rooted, strain, most_strain));
        both == u8::MAX
    }
    #[inline(always)]
    fn any_at_most(self, x: __m512d, y: __m512d) -> bool {
        avx512!(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(x, y)) != 0
    }
}
