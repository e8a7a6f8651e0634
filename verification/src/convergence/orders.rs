//! The order that two meshes show, and the envelope of errors that change sign.

use crossfibre::number::Number;

use super::Fault;
use super::fault::{descending, enough};

/// The observed order between each mesh and the next,
///
/// p = ln(|e_k| / |e_{k+1}|) / ln(h_k / h_{k+1}),
///
/// of errors on at least two meshes, coarse to fine, with any refinement ratios. Signs are of no
/// account here (they are in [`super::range`]); an error of zero has no order.
///
/// # Errors
/// Too few meshes, a mesh that is not finer than the one before, an error that is zero or not finite.
pub fn orders(errors: &[(f64, f64)]) -> Result<Vec<f64>, Fault> {
    enough(errors, 2)?;
    descending(errors)?;
    super::fault::positive(errors.iter().map(|&(_, e)| e.abs()))?;
    Ok(pairwise(errors))
}

/// [`orders`] of errors that may be zero: infinite, or not a number, there.
pub(super) fn pairwise(errors: &[(f64, f64)]) -> Vec<f64> {
    let order = |pair: &[(f64, f64)]| {
        let [(coarse, before), (fine, after)] = [pair[0], pair[1]];
        // Logarithms first: a ratio of errors may be too large for a number.
        (Number::ln(before.abs()) - Number::ln(after.abs())) / Number::ln(coarse / fine)
    };
    errors.windows(2).map(order).collect()
}

/// For each mesh the greatest size of the error on it and on all finer ones.
///
/// The size of an error that changes sign says little on any one mesh: near a change it is small by
/// chance. The envelope is what a user may rely on, and it can be fitted. Its finest point rests on
/// one mesh and may be too low.
///
/// # Errors
/// A mesh that is not finer than the one before, an error that is not finite.
pub fn envelope(errors: &[(f64, f64)]) -> Result<Vec<(f64, f64)>, Fault> {
    descending(errors)?;
    let mut greatest = 0.0_f64;
    let mut upward: Vec<_> = errors
        .iter()
        .rev()
        .map(|&(h, e)| {
            greatest = greatest.max(e.abs());
            (h, greatest)
        })
        .collect();
    upward.reverse();
    Ok(upward)
}

#[cfg(test)]
mod tests {
    use super::super::synthetic::{SPACINGS, ladder, power};
    use super::*;

    #[test]
    fn orders_are_those_that_the_errors_were_made_of() {
        // e = c hᵖ with another p in each step, whatever the ratio and the sign.
        let made = [0.37, 1.93, -0.41, 2.0 / 3.0];
        let mut errors = vec![(2.9, 0.173)];
        for (p, fine) in made.into_iter().zip([1.7, 1.51, 0.43, 0.29]) {
            let &(coarse, error) = errors.last().unwrap();
            errors.push((fine, -error * power(fine / coarse, p)));
        }
        for (found, made) in orders(&errors).unwrap().into_iter().zip(made) {
            // Some roundings of logarithms below 1, over one of 0.12 at least.
            assert!((found - made).abs() < 1e-14, "{found} {made}");
        }
    }

    #[test]
    fn an_order_needs_two_meshes_that_become_finer_and_errors_that_are_not_zero() {
        assert_eq!(orders(&[(1.3, 0.2)]), Err(Fault::TooFew { found: 1, needed: 2 }));
        assert_eq!(orders(&[(1.3, 0.2), (1.3, 0.1)]), Err(Fault::NotFiner { index: 1 }));
        let zero = Err(Fault::NotPositive { index: 1, value: 0.0 });
        assert_eq!(orders(&[(1.3, 0.2), (0.7, 0.0)]), zero);
        assert!(matches!(
            orders(&[(1.3, f64::NAN), (0.7, 0.1)]),
            Err(Fault::NotFinite { index: 0, .. })
        ));
    }

    #[test]
    fn the_envelope_is_the_greatest_error_from_each_mesh_on() {
        let errors = [(3.1, -0.4), (2.0, 0.05), (1.1, 0.3), (0.7, -0.02), (0.3, 0.11)];
        let expected = [(3.1, 0.4), (2.0, 0.3), (1.1, 0.3), (0.7, 0.11), (0.3, 0.11)];
        assert_eq!(envelope(&errors).unwrap(), expected);
        // Errors that fall are their own envelope.
        let falling = ladder(&SPACINGS, |h| 0.37 * power(h, 0.61));
        assert_eq!(envelope(&falling).unwrap(), falling);
    }
}
