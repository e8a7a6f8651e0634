//! An equation evaluated from inputs that are named as traces name them.

use std::collections::BTreeMap;

use crossfibre::number::{Number, Vector};
use crossfibre::paper::{Cosines, CrossoverPush, Direction, Lengths, Paper, ProjectilePush};

use super::protocol::Value;

/// Inputs by symbol; one number or the components of a vector.
pub type Inputs<S> = BTreeMap<String, Vec<S>>;

/// Inputs as questions have them.
pub fn inputs(values: &BTreeMap<String, Value>) -> Inputs<f64> {
    values.iter().map(|(name, value)| (name.clone(), value.numbers())).collect()
}

/// What an equation gives, or which input it lacks.
pub fn evaluate<S: Number>(
    paper: &impl Paper<S>,
    equation: u8,
    inputs: &Inputs<S>,
) -> Result<Vec<S>, String> {
    let named = Named(inputs);
    match (equation, named.dimension()) {
        (1 | 2 | 5 | 6, 2) => of_vectors::<S, 2>(paper, equation, named),
        (1 | 2 | 5 | 6, 3) => of_vectors::<S, 3>(paper, equation, named),
        (1 | 2 | 5 | 6, other) => Err(format!("vectors of {other} components")),
        _ => of_scalars(paper, equation, named),
    }
}

/// (1), (2), (5) and (6).
fn of_vectors<S: Number, const D: usize>(
    paper: &impl Paper<S>,
    equation: u8,
    named: Named<'_, S>,
) -> Result<Vec<S>, String> {
    let v = |name| named.vector::<D>(name);
    let s = |name| named.scalar(name);
    Ok(match equation {
        1 => paper
            .eqn_1_impulse_residual(
                v("T_ahead")?,
                v("T_here")?,
                s("m_over_dt")?,
                v("v")?,
                v("v_before")?,
            )
            .as_slice()
            .to_vec(),
        2 => paper
            .eqn_2_velocity(v("v_before")?, s("A")?, v("T_ahead")?, v("T_here")?)
            .as_slice()
            .to_vec(),
        5 => vec![paper.eqn_5_previous_length(v("x_ahead")?, v("x_here")?)],
        _ => vec![paper.eqn_6_length(
            v("x_ahead")?,
            v("v_ahead")?,
            v("x_here")?,
            v("v_here")?,
            s("dt")?,
        )],
    })
}

fn of_scalars<S: Number>(
    paper: &impl Paper<S>,
    equation: u8,
    named: Named<'_, S>,
) -> Result<Vec<S>, String> {
    let s = |name| named.scalar(name);
    let theta = || Ok::<_, String>(Direction { cos: s("cos")?, sin: s("sin")? });
    let phi_1 = || Ok::<_, String>(Cosines { x: s("cos_phi1_x")?, y: s("cos_phi1_y")? });
    let phi_2 = || Ok::<_, String>(Cosines { x: s("cos_phi2_x")?, y: s("cos_phi2_y")? });
    let push = || {
        Ok::<_, String>(CrossoverPush {
            a: s("A")?,
            slide_factor: s("alpha_s")?,
            perpendicular: s("T2_perp")?,
            parallel: s("T2_para")?,
            primary: phi_1()?,
            change: Vector::<S, 2>::new(s("du")?, s("dv")?),
            mass: s("m1")?,
            secondary_mass: s("m2")?,
        })
    };
    Ok(vec![match equation {
        3 => paper.eqn_3_strain_increment(s("L")?, s("L_before")?),
        4 if paper.uses_previous_length() => {
            let (now, previous) = (s("L")?, s("L_before")?);
            paper
                .eqn_4_strain(s("strain_before")?, Lengths { now, previous, unstrained: S::zero() })
        }
        4 => {
            let (now, unstrained) = (s("L")?, s("L_0")?);
            paper.eqn_4_strain(S::zero(), Lengths { now, previous: S::zero(), unstrained })
        }
        7 => paper.eqn_7_tension(s("E")?, s("strain")?),
        8 => paper.eqn_8_projectile_velocity(ProjectilePush {
            velocity: s("v_p_before")?,
            tension_y: s("T_y")?,
            mass: s("m_p")?,
            node_mass: s("m_node")?,
            time_step: s("dt")?,
            time: s("t")?,
        }),
        9 => paper.eqn_9_parallel_velocity(s("u")?, s("v")?, theta()?),
        10 => paper.eqn_10_perpendicular_velocity(s("u")?, s("v")?, theta()?),
        11 => {
            let here = Vector::<S, 2>::new(s("x_here")?, s("y_here")?);
            let behind = Vector::<S, 2>::new(s("x_behind")?, s("y_behind")?);
            let Direction { cos, sin } = paper.eqn_11_direction(here, behind);
            return Ok(vec![cos, sin]);
        }
        12 => paper.eqn_12_secondary_u(s("alpha_s")?, s("v_para")?, s("v_perp")?, theta()?),
        13 => paper.eqn_13_secondary_v(s("alpha_s")?, s("v_para")?, s("v_perp")?, theta()?),
        14 => paper.eqn_14_secondary_w(),
        15 => paper.eqn_15_parallel_tension(s("T2")?, phi_2()?, phi_1()?),
        16 => paper.eqn_16_perpendicular_tension(s("T2")?, phi_2()?, phi_1()?),
        17 => paper.eqn_17_u_at_crossover(s("u_by_2")?, push()?),
        18 => paper.eqn_18_v_at_crossover(s("v_by_2")?, push()?),
        19 => paper.eqn_19_acceleration(s("c")?, s("curvature")?),
        20 => paper.eqn_20_courant(s("c")?, s("dt")?, s("dx")?),
        other => return Err(format!("the page has no equation ({other})")),
    }])
}

struct Named<'i, S>(&'i Inputs<S>);

impl<S: Number> Named<'_, S> {
    /// Components of the longest input.
    fn dimension(&self) -> usize {
        self.0.values().map(Vec::len).max().unwrap_or(0)
    }

    fn numbers(&self, name: &str) -> Result<&[S], String> {
        self.0.get(name).map(Vec::as_slice).ok_or_else(|| format!("there is no input {name}"))
    }

    fn scalar(&self, name: &str) -> Result<S, String> {
        match self.numbers(name)? {
            [x] => Ok(*x),
            other => Err(format!("{name} has {} components, not one", other.len())),
        }
    }

    fn vector<const D: usize>(&self, name: &str) -> Result<Vector<S, D>, String> {
        let numbers = self.numbers(name)?;
        if numbers.len() == D {
            Ok(Vector::from_column_slice(numbers))
        } else {
            Err(format!("{name} has {} components, not {D}", numbers.len()))
        }
    }
}

#[cfg(test)]
mod tests {
    use crossfibre::corrected::{Corrected, Engineering, Incremental};
    use crossfibre::errata::Corrections;

    use super::*;
    use crate::golden::equations::vectors;
    use crate::golden::file::Flag;

    /// The golden vectors were drawn and traced without names being looked up: bits must agree.
    #[test]
    fn every_golden_vector_is_evaluated_to_its_bits_by_name() {
        for vector in vectors() {
            let inputs = vector.numbers();
            let eq = vector.eq.parse().unwrap();
            let corrections = match vector.flags.contains(&Flag::Printed) {
                true => Corrections::NONE,
                false => Corrections::ALL,
            };
            let out = if vector.flags.contains(&Flag::Engineering) {
                evaluate(&Corrected::<Engineering>::new(corrections), eq, &inputs)
            } else {
                evaluate(&Corrected::<Incremental>::new(corrections), eq, &inputs)
            };
            let bits = |v: &[f64]| v.iter().map(|x| (x.is_nan(), x.to_bits())).collect::<Vec<_>>();
            let same = |(a, b): (&(bool, u64), &(bool, u64))| a == b || (a.0 && b.0);
            let (found, stored) = (bits(&out.unwrap()), bits(&vector.out.numbers()));
            assert_eq!(found.len(), stored.len());
            assert!(found.iter().zip(&stored).all(same), "{}", vector.id);
        }
    }

    #[test]
    fn an_input_that_is_missing_or_of_another_shape_is_named() {
        let paper = Corrected::<Incremental>::new(Corrections::ALL);
        let inputs = Inputs::from([("E".to_owned(), vec![58_600.0, 1.7])]);
        let error = evaluate(&paper, 7, &inputs).unwrap_err();
        assert_eq!(error, "E has 2 components, not one");
        assert_eq!(evaluate(&paper, 19, &inputs).unwrap_err(), "there is no input c");
        assert!(evaluate(&paper, 21, &inputs).is_err());
    }

    #[test]
    fn a_vector_has_two_components_or_three() {
        let paper = Corrected::<Incremental>::new(Corrections::ALL);
        for count in [1, 4] {
            let x = vec![0.3; count];
            let inputs =
                Inputs::from([("x_ahead".to_owned(), x.clone()), ("x_here".to_owned(), x)]);
            let error = evaluate(&paper, 5, &inputs).unwrap_err();
            assert_eq!(error, format!("vectors of {count} components"));
        }
    }
}
