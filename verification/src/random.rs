//! Numbers that look like chance and are the same in every run and every version.

/// splitmix64 (Steele, Lea and Flood, 2014). Ten lines that stay as they are; the numbers of a crate
/// may be others in its next version.
#[derive(Clone, Debug)]
pub struct SplitMix(u64);

impl SplitMix {
    /// The sequence of this seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number between two.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        // 53 bits: every double of the unit interval that is a multiple of 2⁻⁵³.
        low + (high - low) * ((self.bits() >> 11) as f64 * (f64::EPSILON / 2.0))
    }

    /// A whole number of a range.
    pub fn whole(&mut self, range: std::ops::Range<usize>) -> usize {
        range.start + (self.bits() % range.len().max(1) as u64) as usize
    }

    /// Whether something of this probability happens.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.between(0.0, 1.0) < probability
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first numbers of seed 1234567, as published with the reference implementation.
    #[test]
    fn the_generator_is_splitmix64() {
        let mut random = SplitMix::new(1_234_567);
        assert_eq!(random.bits(), 6_457_827_717_110_365_317);
        assert_eq!(random.bits(), 3_203_168_211_198_807_973);
        assert_eq!(random.bits(), 9_817_491_932_198_370_423);
    }

    /// The first numbers of the same seed over 2⁶⁴ are 0.3500795420214081 and 0.1736440966709126.
    #[test]
    fn a_number_between_two_is_their_share_of_the_way() {
        let mut random = SplitMix::new(1_234_567);
        // Absolute, 1e-14: the last digit of the share, eight times.
        assert!((random.between(-3.0, 5.0) - (8.0 * 0.3500795420214081 - 3.0)).abs() < 1e-14);
        assert!((random.between(7.0, 9.0) - (7.0 + 2.0 * 0.1736440966709126)).abs() < 1e-14);
    }

    #[test]
    fn whole_numbers_and_chances_keep_their_ranges() {
        let mut random = SplitMix::new(7);
        let drawn: Vec<_> = (0..500).map(|_| random.whole(3..8)).collect();
        assert!((3..8).all(|k| drawn.contains(&k)) && drawn.iter().all(|k| (3..8).contains(k)));
        // 500 throws of probability 0.3: 150, and six standard deviations are 61.
        let happened = (0..500).filter(|_| random.chance(0.3)).count();
        assert!((89..=211).contains(&happened), "{happened}");
    }
}
