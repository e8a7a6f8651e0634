//! The largest stable Courant number, by bisection.

/// Courant numbers are searched between these.
pub const RANGE: (f64, f64) = (0.004, 2.0);

/// From one Courant number to the next while nothing unstable has been seen.
const STRIDE: f64 = 1.25;

/// Halvings of the last stride: to a relative 1e-7.
const HALVINGS: u32 = 21;

/// The Courant number up to which nothing is unstable: zero if the least of the range is, none if the
/// range holds nothing unstable.
///
/// The search goes upward from the least, so that a band of stability beyond an instability is
/// not taken for the limit, unless the instability is narrower than a stride.
pub fn largest_stable(unstable: impl Fn(f64) -> bool) -> Option<f64> {
    let (mut low, mut high) = (0.0, RANGE.0);
    while !unstable(high) {
        if high == RANGE.1 {
            return None;
        }
        (low, high) = (high, (STRIDE * high).min(RANGE.1));
    }
    if low == 0.0 {
        return Some(0.0);
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if unstable(middle) { high = middle } else { low = middle }
    }
    Some(low)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limit_is_the_lowest_onset_of_instability() {
        // Halved 21 times: 0.25 × 0.83/2²¹.
        let found = largest_stable(|x| x > 0.8317 && !(1.1..1.3).contains(&x)).unwrap();
        assert!((0.8317 - found) < 1e-7 && found <= 0.8317, "{found}");
        assert_eq!(largest_stable(|_| true), Some(0.0));
        assert_eq!(largest_stable(|_| false), None);
    }
}
