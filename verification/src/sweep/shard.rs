//! A part of a sweep.

use std::str::FromStr;

/// Part `index` of `of` parts: every `of`-th point, from the `index`-th on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// From 1.
    index: usize,
    /// How many parts there are.
    of: usize,
}

impl Shard {
    /// Whether point `k`, counted from 0, is in this part.
    pub fn has(self, k: usize) -> bool {
        k % self.of == self.index - 1
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers =
            text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
        match numbers {
            Some((index, of)) if (1..=of).contains(&index) => Ok(Self { index, of }),
            Some((_, 0)) => Err("there cannot be 0 parts; 1/1 is the whole".into()),
            Some((_, of)) => Err(format!("the parts of {of} are 1/{of} to {of}/{of}")),
            None => Err("must be I/N, part I of N, such as 2/5".into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_is_in_exactly_one_part() {
        for of in [1, 2, 3, 7] {
            for k in 0..23 {
                let parts = (1..=of).filter(|i| {
                    let shard: Shard = format!("{i}/{of}").parse().unwrap();
                    shard.has(k)
                });
                assert_eq!(parts.count(), 1, "point {k} of {of} parts");
            }
        }
    }

    #[test]
    fn what_is_no_part_is_refused() {
        for text in ["3/2", "0/3", "0/0", "1/0", "2", "a/b", "1/2/3", "-1/2", ""] {
            assert!(text.parse::<Shard>().is_err(), "{text}");
        }
    }
}
