//! A candidate's numbers held against what is expected.

use serde::Serialize;

use super::expected::ExpectedQuantity;
use super::protocol::Precision;
use super::quantity::Quantity;
use crate::bits::ulps;

/// How many envelopes another order of operations is allowed.
///
/// What the rewrites of [`crate::faulty::rewritten`] need at most – every equation in other words – is
/// measured by the cases `conformance.…`; they fail if this is over eight times that.
pub fn allowed(quantity: Quantity) -> f64 {
    match quantity {
        Quantity::Equation(_) => 4.0,
        _ => 8.0,
    }
}

/// What became of a list of numbers.
#[derive(Clone, Debug, Serialize)]
pub struct Judged {
    /// Of what.
    pub quantity: String,
    /// How many numbers.
    pub values: usize,
    /// How many of them are equal to the bit; the sign of zero does not count.
    pub same: usize,
    /// Distance of each from the reference's, in units of the last place.
    #[serde(skip)]
    pub ulps: Vec<u64>,
    /// The greatest difference, in the quantity's unit; infinite where a number is not finite.
    #[serde(skip)]
    pub worst: f64,
    /// The greatest difference over the greatest number.
    #[serde(skip)]
    pub relative: f64,
    /// The greatest difference over the envelope.
    #[serde(skip)]
    pub envelopes: f64,
    /// How many envelopes are allowed.
    pub allowed: f64,
    /// Where the greatest difference is, such as `node 3, y`.
    pub place: String,
    /// The reference's number there.
    #[serde(skip)]
    pub expected: f64,
    /// The candidate's.
    #[serde(skip)]
    pub found: f64,
}

impl Judged {
    /// Whether every number is the reference's.
    pub fn is_same(&self) -> bool {
        self.same == self.values
    }

    /// Whether rounding explains the difference.
    pub fn is_rounding(&self) -> bool {
        self.envelopes <= self.allowed
    }

    /// Of the greatest difference, the part that rounding explains and the rest, in the quantity's
    /// unit.
    pub fn split(&self) -> (f64, f64) {
        if self.is_rounding() || self.worst == 0.0 {
            return (self.worst, 0.0);
        }
        let rounding =
            if self.worst.is_finite() { self.worst / self.envelopes * self.allowed } else { 0.0 };
        (rounding, self.worst - rounding)
    }
}

/// Compares, or says in what the lists do not fit.
pub fn judge(
    expected: &ExpectedQuantity,
    found: &[f64],
    precision: Precision,
) -> Result<Judged, String> {
    let ExpectedQuantity { quantity, values, envelope } = expected;
    if found.len() != values.len() {
        return Err(format!("{quantity} has {} numbers, not {}", found.len(), values.len()));
    }
    let mut judged = Judged {
        quantity: quantity.to_string(),
        values: values.len(),
        same: 0,
        ulps: Vec::with_capacity(values.len()),
        worst: 0.0,
        relative: 0.0,
        envelopes: 0.0,
        allowed: allowed(*quantity),
        place: String::new(),
        expected: 0.0,
        found: 0.0,
    };
    let size = values.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    for (i, (&expected, &found)) in values.iter().zip(found).enumerate() {
        // Energies are computed here.
        let is_theirs = *quantity != Quantity::Energy;
        let found = if is_theirs { rounded(found, precision) } else { found };
        let same = expected == found || (expected.is_nan() && found.is_nan());
        judged.same += usize::from(same);
        let apart = if same { 0 } else { ulps_in(expected, found, precision) };
        judged.ulps.push(apart);
        let difference = if same { 0.0 } else { (found - expected).abs() };
        // A difference that is not a number is the worst there is.
        let difference = if difference.is_nan() { f64::INFINITY } else { difference };
        if difference > judged.worst {
            judged.worst = difference;
            (judged.expected, judged.found) = (expected, found);
            judged.place = if values.len() > 1 { quantity.place(i) } else { String::new() };
        }
    }
    if judged.worst > 0.0 {
        // Of zeros there is nothing to be relative to.
        judged.relative = if size > 0.0 { judged.worst / size } else { 0.0 };
        judged.envelopes = judged.worst / envelope;
    }
    Ok(judged)
}

/// A number as the candidate has it: what an f32 candidate writes is the decimal of an f32.
fn rounded(x: f64, precision: Precision) -> f64 {
    match precision {
        Precision::F64 => x,
        Precision::F32 => f64::from(x as f32),
    }
}

fn ulps_in(a: f64, b: f64, precision: Precision) -> u64 {
    if a.is_nan() || b.is_nan() {
        return u64::MAX;
    }
    match precision {
        Precision::F64 => ulps(a, b),
        // Two f32 differ by as many of their units as of 2²⁹ units of doubles, where they are normal.
        Precision::F32 => ulps(a, b) >> 29,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crossfibre::place::Fibre;

    fn strain(values: &[f64], envelope: f64) -> ExpectedQuantity {
        let quantity = Quantity::Strain(Fibre::Primary);
        ExpectedQuantity { quantity, values: values.into(), envelope }
    }

    #[test]
    fn a_difference_is_measured_in_units_in_size_and_in_envelopes() {
        let expected = strain(&[0.3, 0.0131, 0.0], 1e-17);
        let judged = judge(&expected, &[0.1 + 0.2, 0.0131, -0.0], Precision::F64).unwrap();
        assert_eq!((judged.values, judged.same, judged.ulps[0]), (3, 2, 1));
        assert_eq!(judged.place, "element 0");
        // One unit in the last place of 0.3 is 2⁻⁵⁴ = 5.55e-17: powers of two, and so exact here.
        assert_eq!(judged.worst, 2.0_f64.powi(-54));
        assert_eq!(judged.relative, judged.worst / 0.3);
        assert_eq!(judged.envelopes, judged.worst / 1e-17);
        assert!(judged.is_rounding() && !judged.is_same());
        assert_eq!(judged.split(), (judged.worst, 0.0));
    }

    #[test]
    fn beyond_the_envelope_the_rest_is_no_rounding() {
        let judged = judge(&strain(&[0.25], 1e-4), &[0.253], Precision::F64).unwrap();
        assert!(!judged.is_rounding());
        let (rounding, rest) = judged.split();
        // 8 envelopes of 1e-4 of a difference of 3e-3, each to a few units in the last place.
        assert!((rounding - 8e-4).abs() < 1e-17 && (rest - 2.2e-3).abs() < 1e-16);
        // The only number has no place.
        assert_eq!(judged.place, "");
    }

    #[test]
    fn just_as_many_envelopes_as_are_allowed_are_rounding() {
        let envelope = 2.0_f64.powi(-10);
        let judged =
            judge(&strain(&[0.25], envelope), &[0.25 + 8.0 * envelope], Precision::F64).unwrap();
        assert_eq!((judged.envelopes, judged.is_rounding()), (8.0, true));
        assert_eq!(allowed(Quantity::Equation(4)), 4.0);
        // No envelope is needed where nothing differs.
        let judged = judge(&strain(&[0.25], 0.0), &[0.25], Precision::F64).unwrap();
        assert!(judged.is_rounding() && judged.is_same());
    }

    #[test]
    fn of_equal_differences_the_first_is_told_and_of_zeros_nothing_is_relative() {
        let judged = judge(&strain(&[0.0, 0.0], 1.0), &[0.5, 0.5], Precision::F64).unwrap();
        assert_eq!((judged.place.as_str(), judged.relative), ("element 0", 0.0));
    }

    #[test]
    fn what_is_not_finite_is_never_rounding() {
        for found in [f64::NAN, f64::INFINITY] {
            let judged = judge(&strain(&[0.25], 1.0), &[found], Precision::F64).unwrap();
            assert!(!judged.is_rounding() && judged.worst.is_infinite());
        }
        let both = judge(&strain(&[f64::NAN], 1.0), &[f64::NAN], Precision::F64).unwrap();
        assert!(both.is_same());
        for (expected, found) in [(f64::NAN, 0.25), (0.25, f64::NAN)] {
            let judged = judge(&strain(&[expected], 1.0), &[found], Precision::F64).unwrap();
            assert!(!judged.is_same() && judged.ulps == [u64::MAX], "{expected} {found}");
        }
    }

    #[test]
    fn single_numbers_are_counted_in_their_own_units() {
        let x = 0.1_f32;
        let next = f32::from_bits(x.to_bits() + 3);
        let expected = strain(&[f64::from(x)], 1e-8);
        // Written with just the digits that an f32 needs.
        let written: f64 = next.to_string().parse().unwrap();
        let judged = judge(&expected, &[written], Precision::F32).unwrap();
        assert_eq!(judged.ulps, [3]);
        // Energies are computed here, of doubles; what a candidate writes is an f32.
        let energy = ExpectedQuantity { quantity: Quantity::Energy, ..strain(&[0.1], 1e-17) };
        assert!(judge(&energy, &[0.1], Precision::F32).unwrap().is_same());
        assert!(judge(&expected, &[0.1], Precision::F32).unwrap().is_same());
    }

    #[test]
    fn a_list_of_another_length_is_refused() {
        let error = judge(&strain(&[0.1, 0.2], 1.0), &[0.1], Precision::F64).unwrap_err();
        assert_eq!(error, "primary strain has 1 numbers, not 2");
    }
}
