//! Bits of numbers: how far two are apart, and a digest of many.

/// How many steps from double to double two numbers are apart; −0 is 0.
pub fn ulps(a: f64, b: f64) -> u64 {
    let order = |x: f64| {
        let bits = x.to_bits().cast_signed();
        if bits < 0 { i64::MIN - bits } else { bits }
    };
    order(a).abs_diff(order(b))
}

/// FNV-1a, 64 bits: enough to see that something has changed; nothing here is secret.
pub fn fnv(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ulps_count_doubles_through_zero() {
        let least = f64::from_bits(1);
        assert_eq!(ulps(least, -least), 2);
        assert_eq!(ulps(0.3, 0.1 + 0.2), 1);
        assert_eq!(ulps(0.0, -0.0), 0);
    }

    /// Published values of FNV-1a: of nothing, of "a" and of "foobar".
    #[test]
    fn the_digest_is_fnv_1a() {
        assert_eq!(fnv("".bytes()), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv("a".bytes()), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(fnv("foobar".bytes()), 0x8594_4171_f739_67e8);
    }
}
