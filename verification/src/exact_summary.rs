//! The exact motion for people: how it was solved, and the pieces that can be seen.

use std::fmt::{self, Display, Formatter};

use crossfibre::scene::Strain;

use crate::exact_file::{ExactFile, Piece};

/// Displays as the summary.
pub struct ExactSummary<'a>(pub &'a ExactFile);

/// The most rows of a fibre.
const MOST: usize = 12;

/// Pieces side by side that a row cannot tell apart.
struct Row<'a> {
    from: f64,
    to: f64,
    longest: &'a Piece,
}

impl Display for ExactSummary<'_> {
    fn fmt(&self, to: &mut Formatter<'_>) -> fmt::Result {
        let Self(file) = self;
        let solution = &file.solution;
        writeln!(to, "{}\n", file.title)?;
        writeln!(to, "time         {:.4} µs", file.time * 1e6)?;
        let stands_in = [
            solution.chords.map(|n| format!("a polygon of {n} chords in place of T = E ln λ")),
            solution.velocity_steps.map(|n| format!("a projectile that slows down in {n} steps")),
        ];
        let stands_in: Vec<_> = stands_in.into_iter().flatten().collect();
        let how = if solution.exact {
            "exact: every front followed".to_owned()
        } else {
            format!("converging: {}", stands_in.join(" and "))
        };
        writeln!(to, "solution     {how}; {} meetings of fronts", solution.meetings)?;
        let greatest = file.primary.iter().fold(0.0_f64, |most, piece| most.max(piece.strain));
        writeln!(
            to,
            "error        {:.1e} at most in the strain, mean along a fibre ({:.1e} of the greatest)",
            file.error_bound,
            file.error_bound / greatest
        )?;
        if let Some(c) = file.coefficients {
            writeln!(
                to,
                "crossover    R = {:.6}, T = {:.6}, D = {:.6} until a wave shed by the kink is back",
                c.reflection, c.transmission, c.diversion
            )?;
        }
        writeln!(to, "projectile   {:.3} m/s", file.projectile_velocity)?;
        let measure = match file.measure {
            Strain::Incremental => "ln λ",
            Strain::Engineering => "λ - 1",
        };
        for (fibre, pieces) in [("primary", &file.primary), ("secondary", &file.secondary)] {
            if !pieces.is_empty() {
                let columns = 9 * pieces[0].velocity.len();
                writeln!(
                    to,
                    "\n{fibre:<9} {:>10} {:>13} {measure:>10} {:>columns$}  direction",
                    "from", "to", "velocity, m/s"
                )?;
                let rows = rows(pieces);
                longest(&rows).try_for_each(|row| writeln!(to, "{row}"))?;
                let (count, listed) = (rows.len(), longest(&rows).count());
                if count > listed {
                    writeln!(to, "           and {} shorter ones between them", count - listed)?;
                }
            }
        }
        Ok(())
    }
}

/// Neighbours that differ by less than 0.2 % of the greatest strain and of the greatest speed, and
/// by less than 0.005 in direction, are one row.
fn rows(pieces: &[Piece]) -> Vec<Row<'_>> {
    let greatest = |of: fn(&Piece) -> f64| pieces.iter().map(of).fold(0.0, f64::max);
    let strain = 0.002 * greatest(|piece| piece.strain);
    let speed = 0.002 * greatest(|piece| length(&piece.velocity));
    let alike = |a: &Piece, b: &Piece| {
        (a.strain - b.strain).abs() <= strain
            && distance(&a.velocity, &b.velocity) <= speed
            && distance(&a.direction, &b.direction) <= 0.005
    };
    let mut rows: Vec<Row<'_>> = Vec::new();
    for piece in pieces {
        match rows.last_mut() {
            Some(row) if alike(row.longest, piece) => {
                row.to = piece.to;
                if piece.to - piece.from > row.longest.to - row.longest.from {
                    row.longest = piece;
                }
            }
            _ => rows.push(Row { from: piece.from, to: piece.to, longest: piece }),
        }
    }
    rows
}

fn length(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// The longest rows, in order of place.
fn longest<'a, 'p>(rows: &'a [Row<'p>]) -> impl Iterator<Item = &'a Row<'p>> {
    let mut lengths: Vec<_> = rows.iter().map(|row| row.to - row.from).collect();
    lengths.sort_by(f64::total_cmp);
    let least = lengths[lengths.len().saturating_sub(MOST)];
    rows.iter().filter(move |row| row.to - row.from >= least)
}

impl Display for Row<'_> {
    fn fmt(&self, to: &mut Formatter<'_>) -> fmt::Result {
        let Self { from, to: end, longest } = self;
        let vector = |v: &[f64], digits: usize, width: usize| {
            // Adding zero makes of a rounded −0 a 0.
            let rounded = |x: f64| format!("{x:.digits$}").parse::<f64>().unwrap_or(x) + 0.0;
            v.iter().map(|x| format!("{:>width$.digits$}", rounded(*x))).collect::<String>()
        };
        write!(
            to,
            "{:>17.3} mm {:>10.3} mm {:>8.4} % {}  {}",
            from * 1e3,
            end * 1e3,
            longest.strain * 100.0,
            vector(&longest.velocity, 2, 9),
            vector(&longest.direction, 4, 8)
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A piece of 3 % and 50 m/s at a place.
    fn piece(from: f64, to: f64) -> Piece {
        Piece { from, to, strain: 0.03, velocity: vec![30.0, 40.0], direction: vec![1.0, 0.0] }
    }

    /// The limits are 0.2 % of 3 % and of 50 m/s, and 0.005.
    #[test]
    fn neighbours_are_one_row_as_long_as_they_differ_by_little() {
        let first = piece(0.0, 0.1);
        let rows_with = |change: &dyn Fn(&mut Piece)| {
            let mut second = piece(0.1, 0.3);
            change(&mut second);
            rows(&[first.clone(), second]).iter().map(|row| (row.from, row.to)).collect::<Vec<_>>()
        };
        let (one, two) = (vec![(0.0, 0.3)], vec![(0.0, 0.1), (0.1, 0.3)]);
        assert_eq!(rows_with(&|_| ()), one);
        assert_eq!(rows_with(&|piece| piece.strain -= 5e-5), one);
        assert_eq!(rows_with(&|piece| piece.strain -= 7e-5), two);
        assert_eq!(rows_with(&|piece| piece.velocity[0] -= 0.09), one);
        assert_eq!(rows_with(&|piece| piece.velocity[0] -= 0.11), two);
        assert_eq!(rows_with(&|piece| piece.direction[1] += 0.004), one);
        assert_eq!(rows_with(&|piece| piece.direction[1] += 0.006), two);
    }

    #[test]
    fn pieces_at_rest_are_one_row() {
        let at_rest = |from, to| Piece { strain: 0.0, velocity: vec![0.0; 2], ..piece(from, to) };
        assert_eq!(rows(&[at_rest(0.0, 0.1), at_rest(0.1, 0.3)]).len(), 1);
    }

    #[test]
    fn a_row_has_the_numbers_of_its_longest_piece() {
        let longest = |ends: [f64; 4]| {
            let mut pieces =
                [piece(ends[0], ends[1]), piece(ends[1], ends[2]), piece(ends[2], ends[3])];
            for (k, piece) in pieces.iter_mut().enumerate() {
                piece.strain -= 1e-5 * k as f64;
            }
            let rows = rows(&pieces);
            assert_eq!(rows.len(), 1);
            pieces.iter().position(|piece| std::ptr::eq(piece, rows[0].longest)).unwrap()
        };
        assert_eq!(longest([0.0, 0.3, 0.4, 0.6]), 0);
        assert_eq!(longest([0.1, 0.2, 0.5, 0.7]), 1);
        assert_eq!(longest([0.1, 0.2, 0.4, 0.8]), 2);
    }

    #[test]
    fn what_is_rounded_to_zero_has_no_sign() {
        let piece = Piece { velocity: vec![-0.004, -0.006], ..piece(0.0, 0.1) };
        let row = Row { from: piece.from, to: piece.to, longest: &piece }.to_string();
        assert!(row.ends_with("     0.00    -0.01    1.0000  0.0000"), "{row}");
        assert!(row.starts_with("            0.000 mm    100.000 mm   3.0000 % "), "{row}");
    }
}
