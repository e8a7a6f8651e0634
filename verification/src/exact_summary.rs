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
