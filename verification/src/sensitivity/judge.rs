//! What a matrix must be like.

use super::matrix::{Column, Matrix, Row};

/// Checks that are of the last digits themselves, which other words change and nothing of it is wrong: a
/// case, and a piece of its claims.
#[rustfmt::skip] // a table
const OF_BITS: &[(&str, &str)] = &[
    // Stored numbers, to the bit.
    ("golden.vectors", ""),
    ("record.stored", "come out the same"),
    ("precision.record", "come out the same"),
    // Terms that are exactly zero in the words of the reference, and of the size of rounding in others.
    ("identity.free-sliding", ""),
    ("identity.wavefront-flags", ""),
    ("extreme.crossover", "α_s = 0"),
    // How many digits rounding leaves, and what grows out of it.
    ("extreme.rounding", ""),
    ("material.viscosity", "as von Neumann says"),
    // Which elements of a fibre that flaps end slack: the last digit decides, and the count is in the claim.
    ("extreme.laws", "end slack"),
];

fn is_of_bits(check: &Column) -> bool {
    OF_BITS.iter().any(|&(case, claim)| check.case == case && check.claim.contains(claim))
}

/// What is wrong with a matrix.
pub struct Judgement<'a> {
    matrix: &'a Matrix,
    /// Faults that no check of the quick set notices.
    pub missed: Vec<&'a Row>,
    /// Checks that notice no fault.
    pub idle: Vec<&'a Column>,
    /// Editions equal in algebra, and the check that fails one.
    pub misjudged: Vec<(&'a Row, &'a Column)>,
}

/// Judges it.
pub fn judge(matrix: &Matrix) -> Judgement<'_> {
    let misjudged = |row| {
        let falling = matrix.noticing(row).map(|check| &matrix.checks[check]);
        falling.filter(|check| !is_of_bits(check)).map(move |check| (row, check))
    };
    Judgement {
        matrix,
        missed: matrix.missed_by_quick().collect(),
        idle: matrix.idle().collect(),
        misjudged: matrix.rewrites.iter().flat_map(misjudged).collect(),
    }
}

impl Judgement<'_> {
    /// Whether the matrix is as it must be.
    pub fn is_well(&self) -> bool {
        self.missed.is_empty() && self.idle.is_empty() && self.misjudged.is_empty()
    }

    /// What is wrong, a line each, with what to do.
    pub fn lines(&self) -> Vec<String> {
        let missed = self.missed.iter().map(|row| {
            let by_any = self.matrix.noticing(row).next().is_some();
            let who = if by_any { "no quick check" } else { "no check" };
            format!("{who} notices `{}` ({}: {}): a check is missing", row.id, row.group, row.what)
        });
        let idle = self.idle.iter().map(|check| {
            format!(
                "`{}` of {} notices no fault: remove it, or plant the fault that it is there for",
                check.claim, check.case
            )
        });
        let misjudged = self.misjudged.iter().map(|(row, check)| {
            format!(
                "`{}` of {} falls for `{}`, which is equal in algebra: it judges taste",
                check.claim, check.case, row.id
            )
        });
        missed.chain(idle).chain(misjudged).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix() -> Matrix {
        let column = |case: &str, claim: &str, quick| Column {
            case: case.into(),
            claim: claim.into(),
            quick,
        };
        let row = |id: &str, caught_by: &[usize], stopped: &[&str]| Row {
            id: id.into(),
            group: "march".into(),
            what: "errs".into(),
            caught_by: caught_by.to_vec(),
            stopped: stopped.iter().map(|&case| case.into()).collect(),
        };
        Matrix {
            format: String::new(),
            version: String::new(),
            checks: vec![
                column("a", "first", true),
                column("b", "second", true),
                column("c", "third", false),
                column("golden.vectors", "bits", true),
            ],
            faults: vec![row("gross", &[0, 2, 3], &["b"]), row("small", &[3], &[])],
            rewrites: vec![row("other-words", &[3], &[])],
        }
    }

    #[test]
    fn a_matrix_without_a_gap_is_well() {
        assert!(judge(&matrix()).is_well());
        assert!(judge(&matrix()).lines().is_empty());
    }

    #[test]
    fn every_kind_of_gap_is_named() {
        let gap = |change: fn(&mut Matrix), word: &str| {
            let mut matrix = matrix();
            change(&mut matrix);
            let lines = judge(&matrix).lines();
            assert!(!judge(&matrix).is_well());
            assert!(lines.len() == 1 && lines[0].contains(word), "{word}: {lines:?}");
        };
        gap(|m| m.faults[1].caught_by.clear(), "no check notices `small`");
        gap(|m| m.faults[1].caught_by = vec![2], "no quick check notices `small`");
        gap(|m| m.faults[0].stopped.clear(), "`second` of b notices no fault");
        gap(|m| m.rewrites[0].caught_by = vec![0], "falls for `other-words`");
        // Of a case with a check of bits the other checks are none.
        let other = |m: &mut Matrix| {
            m.checks[0].case = "record.stored".into();
            m.rewrites[0].caught_by = vec![0];
        };
        gap(other, "`first` of record.stored falls for `other-words`");
        let mut of_bits = matrix();
        other(&mut of_bits);
        of_bits.checks[0].claim = "All numbers come out the same".into();
        assert!(judge(&of_bits).is_well());
    }
}
