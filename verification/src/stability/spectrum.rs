//! The linearised step and its spectral radius.
//!
//! The step is not linearised by hand: the march itself makes one step on numbers that carry their
//! derivative ([`Dual`]), once for every variable.

use crossfibre::number::Number;
use crossfibre::outcome::Outcome;
use crossfibre::paper::Paper;
use crossfibre::result::WithPaper;
use crossfibre::state::{FibreState, State};
use nalgebra::linalg::balancing::balance_parlett_reinsch;
use nalgebra::{DMatrix, Schur};

use super::base::Base;
use super::dual::Dual;
use crate::planted::{march, with_paper};

/// A step is called unstable from 1 + this on.
///
/// A step that neither gains nor loses energy has its eigenvalues on the unit circle, where rounding
/// of 1e-14 in the matrix scatters them by as much, and by the root of it, 1e-7, where two of them meet:
/// at −1 at the limit itself, at +1 where a straight fibre without tension drifts. What is
/// slower than this is not seen; it grows by 1 % in ten thousand steps.
pub const THRESHOLD: f64 = 1e-6;

/// Every number of a state that a step may change, in one order.
pub fn variables<S: Number>(state: &mut State<S>) -> Vec<&mut S> {
    let State { primary, crossover, projectile, .. } = state;
    let mut all = of_fibre(primary);
    all.extend(crossover.iter_mut().flat_map(|crossover| of_fibre(&mut crossover.fibre)));
    // The velocity of a projectile without mass is given.
    all.extend(projectile.mass.map(|_| &mut projectile.velocity));
    all
}

fn of_fibre<S: Number, const D: usize>(fibre: &mut FibreState<S, D>) -> Vec<&mut S> {
    let FibreState { position, velocity, pull, strain, tension, constitution, .. } = fibre;
    let vectors = [position, velocity, pull].into_iter().flatten().flat_map(|v| v.iter_mut());
    let memory = constitution.iter_mut().flat_map(|by| &mut by.memory);
    vectors.chain(strain).chain(tension).chain(memory).collect()
}

/// One step of the edition that a scene asks for.
pub struct Step<'a, S: Number>(pub &'a mut State<S>);

impl<S: Number> WithPaper<S> for Step<'_, S> {
    type Out = Result<(), Outcome>;
    fn with(self, paper: &impl Paper<S>) -> Self::Out {
        march::step(paper, self.0)
    }
}

/// The derivative of every variable after a step by every variable before it; none if the step ends
/// the march.
pub fn jacobian(base: &Base, courant: f64) -> Option<DMatrix<f64>> {
    let start = base.state::<Dual>(courant);
    let count = variables(&mut start.clone()).len();
    let mut matrix = DMatrix::zeros(count, count);
    for column in 0..count {
        let mut state = start.clone();
        variables(&mut state)[column].slope = 1.0;
        with_paper(&base.scene, Step(&mut state)).ok()?;
        for (row, variable) in variables(&mut state).into_iter().enumerate() {
            matrix[(row, column)] = variable.slope;
        }
    }
    Some(matrix)
}

/// The greatest |g| of the eigenvalues g of the linearised step; infinite if the step ends the march.
pub fn spectral_radius(base: &Base, courant: f64) -> f64 {
    let Some(matrix) = jacobian(base, courant) else { return f64::INFINITY };
    let radii = blocks(&matrix).into_iter().map(|block| {
        let n = block.len();
        radius(DMatrix::from_fn(n, n, |i, j| matrix[(block[i], block[j])]))
    });
    radii.fold(0.0, f64::max)
}

/// Sets of variables of which each acts, in the end, on every other of its set. The matrix is
/// triangular in them, so its eigenvalues are those of the sets by themselves.
///
/// So what a step overwrites or only adds up is set apart, and the motion along a straight fibre
/// from that across it.
fn blocks(matrix: &DMatrix<f64>) -> Vec<Vec<usize>> {
    let count = matrix.nrows();
    let acts_on: Vec<Vec<usize>> =
        (0..count).map(|j| (0..count).filter(|&i| matrix[(i, j)] != 0.0).collect()).collect();
    let reached: Vec<Vec<bool>> = (0..count)
        .map(|start| {
            let (mut reached, mut next) = (vec![false; count], vec![start]);
            while let Some(j) = next.pop() {
                for &i in &acts_on[j] {
                    if !reached[i] {
                        reached[i] = true;
                        next.push(i);
                    }
                }
            }
            reached
        })
        .collect();
    let mut blocks: Vec<Vec<usize>> = Vec::new();
    for (i, from_here) in reached.iter().enumerate() {
        let home = blocks.iter_mut().find(|block| from_here[block[0]] && reached[block[0]][i]);
        match home {
            Some(block) => block.push(i),
            None => blocks.push(vec![i]),
        }
    }
    blocks
}

/// The greatest |g| of the eigenvalues g of a matrix, which is balanced first: positions are in
/// metres, tensions in newtons.
///
/// # Panics
/// If the reduction finds no end: a fault of this program.
fn radius(mut matrix: DMatrix<f64>) -> f64 {
    if matrix.nrows() == 1 {
        return matrix[0].abs();
    }
    balance_parlett_reinsch(&mut matrix);
    // The reduction ends when what is left below the diagonal is this small in comparison with it.
    // Where many eigenvalues are 1, as strain by (4) has them, rounding leaves more.
    let rounds = 100 * matrix.nrows();
    let schur = [1e2, 1e3, 1e4]
        .into_iter()
        .find_map(|units| Schur::try_new(matrix.clone(), units * f64::EPSILON, rounds))
        .expect("the eigenvalues of a step can be found");
    let sizes = schur.complex_eigenvalues().map(|g| (g.re * g.re + g.im * g.im).sqrt());
    sizes.into_iter().copied().fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use crossfibre::errata::Corrections;
    use crossfibre::exact::dispersion;
    use crossfibre::scene::Strain;

    use super::super::rows::{Crossing, at_rest, fibre};
    use super::*;

    /// Two different crossed fibres with everything that couples them.
    fn coupled(measure: Strain) -> Base {
        let mut base = Crossing {
            measure,
            corrections: Corrections::ALL,
            slide_factor: 0.73,
            tilt: 0.41,
            modulus: 1.3,
            density: 0.7,
        }
        .base();
        base.scene.projectile.mass = Some(3.1e-6);
        base
    }

    /// Central differences of the march of doubles by 1e-6 of a variable's own scale. A position is up
    /// to 24 elements, so its rounding leaves 24 × 2.2e-16/1e-6 = 5e-9; third derivatives 1e-12.
    #[test]
    fn the_derivative_of_a_step_is_that_of_difference_quotients() {
        for measure in [Strain::Incremental, Strain::Engineering] {
            let (base, courant) = (coupled(measure), 0.83);
            let exact = jacobian(&base, courant).unwrap();
            let start = base.state::<f64>(courant);
            let after = |column: usize, by: f64| {
                let mut state = start.clone();
                *variables(&mut state)[column] += by;
                with_paper(&base.scene, Step(&mut state)).unwrap();
                variables(&mut state).into_iter().map(|x| *x).collect::<Vec<f64>>()
            };
            let sizes = sizes(&start);
            let mut worst = 0.0_f64;
            for column in 0..exact.ncols() {
                let h = 1e-6 * sizes[column];
                let (up, down) = (after(column, h), after(column, -h));
                for row in 0..exact.nrows() {
                    let unit = sizes[row] / sizes[column];
                    let found = (up[row] - down[row]) / (2.0 * h);
                    worst = worst.max((found - exact[(row, column)]).abs() / unit);
                }
            }
            assert!(worst < 1.5e-8, "{measure:?}: {worst:e}");
        }
    }

    /// What each variable is of the order of: an element, the wave speed, the stiffness, 1.
    fn sizes(state: &State<f64>) -> Vec<f64> {
        let mut sized = state.clone();
        let c = state.primary.properties.wave_speed;
        fn fill<const D: usize>(fibre: &mut FibreState<f64, D>, c: f64) {
            let p = fibre.properties;
            fibre.position.iter_mut().for_each(|x| x.fill(p.spacing));
            fibre.velocity.iter_mut().for_each(|x| x.fill(c));
            fibre.pull.iter_mut().for_each(|x| x.fill(p.stiffness));
            fibre.strain.fill(1.0);
            fibre.tension.fill(p.stiffness);
        }
        fill(&mut sized.primary, c);
        sized.projectile.velocity = c;
        if let Some(crossover) = &mut sized.crossover {
            fill(&mut crossover.fibre, c);
        }
        variables(&mut sized).into_iter().map(|x| *x).collect()
    }

    /// The growth of the highest mode by von Neumann. Rounding of the matrix, 1e-14.
    #[test]
    fn the_spectral_radius_of_a_uniform_fibre_is_the_growth_of_its_highest_mode() {
        let base = at_rest(fibre(9, Strain::Engineering), 0.0145);
        for courant in [0.37, 1.0, 1.0301, 1.21] {
            let expected = dispersion::amplification(courant, std::f64::consts::PI * 8.0 / 9.0);
            let found = spectral_radius(&base, courant);
            assert!((found / expected - 1.0).abs() < 1e-12, "{courant}: {found} {expected}");
        }
    }

    #[test]
    fn a_matrix_falls_into_what_acts_on_itself_in_the_end() {
        // 0 and 2 act on each other, 1 acts on them, 3 is acted on by all.
        let matrix = DMatrix::from_row_slice(
            4,
            4,
            &[0.3, 7.0, -2.0, 0.0, 0.0, -0.9, 0.0, 0.0, 1.3, 0.0, 0.1, 0.0, 1.0, 1.0, 1.0, 0.4],
        );
        assert_eq!(blocks(&matrix), [vec![0, 2], vec![1], vec![3]]);
        // g² − 0.4g + 0.03 + 2.6 has |g|² = 2.63.
        let block = DMatrix::from_row_slice(2, 2, &[0.3, -2.0, 1.3, 0.1]);
        assert!((radius(block) - 2.63_f64.sqrt()).abs() < 1e-15);
    }
}
