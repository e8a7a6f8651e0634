//! States of the march as messages, and messages as states.

use crossfibre::number::{Number, Vector};
use crossfibre::paper::magnitude;
use crossfibre::place::Fibre;
use crossfibre::scene::Scene;
use crossfibre::state::{FibreState, State, Wavefront};

use super::protocol::{CrossoverRecord, FibreRecord, ResultRecord, StateRecord};
use super::quantity::Quantity;
use super::real::Real;

impl StateRecord {
    /// What a candidate is told of a state.
    pub fn of<S: Number>(state: &State<S>) -> Self {
        let crossover = state.crossover.as_ref();
        Self {
            step: state.step,
            primary: FibreRecord::of(&state.primary),
            secondary: crossover.map(|crossover| FibreRecord::of(&crossover.fibre)),
            crossover: crossover.map(|crossover| CrossoverRecord {
                node: crossover.node as u64,
                moves: crossover.moves,
            }),
            projectile_velocity: Real(state.projectile.velocity.to_f64()),
        }
    }

    /// The state of a scene that is recorded, or in what the record does not fit the scene.
    ///
    /// A record does not say how far the wavefront has come: every element is visited, which gives
    /// the same bits.
    pub fn state<S: Number>(&self, scene: &Scene) -> Result<State<S>, String> {
        let mut state = State::<S>::at_impact(scene, Wavefront::Ignored);
        state.step = self.step;
        self.primary.fill(&mut state.primary, Fibre::Primary)?;
        state.projectile.velocity = S::from_f64(self.projectile_velocity.0);
        match (&mut state.crossover, &self.secondary, self.crossover) {
            (None, ..) => {}
            (Some(crossover), Some(fibre), Some(CrossoverRecord { node, moves })) => {
                fibre.fill(&mut crossover.fibre, Fibre::Secondary)?;
                crossover.moves = moves;
                crossover.node = usize::try_from(node)
                    .ok()
                    .filter(|node| *node < state.primary.elements())
                    .ok_or_else(|| format!("node {node} is no place for a crossover"))?;
            }
            (Some(_), None, _) => return Err("there is no `secondary`".into()),
            (Some(_), _, None) => return Err("there is no `crossover`".into()),
        }
        Ok(state)
    }
}

impl FibreRecord {
    fn of<S: Number, const D: usize>(fibre: &FibreState<S, D>) -> Self {
        let real = |x: &S| Real(x.to_f64());
        let rows = |vectors: &[Vector<S, D>]| {
            vectors.iter().map(|v| v.iter().map(real).collect()).collect::<Vec<_>>()
        };
        Self {
            position: rows(&fibre.position),
            velocity: rows(&fibre.velocity),
            strain: fibre.strain.iter().map(real).collect(),
            tension: fibre.tension.iter().map(real).collect(),
        }
    }

    fn fill<S: Number, const D: usize>(
        &self,
        fibre: &mut FibreState<S, D>,
        name: Fibre,
    ) -> Result<(), String> {
        self.check(name, fibre.elements(), D)?;
        let vectors = |rows: &[Vec<Real>]| {
            rows.iter()
                .map(|row| Vector::<S, D>::from_iterator(row.iter().map(|x| S::from_f64(x.0))))
                .collect::<Vec<_>>()
        };
        let numbers = |list: &[Real]| list.iter().map(|x| S::from_f64(x.0)).collect::<Vec<_>>();
        fibre.position = vectors(&self.position);
        fibre.velocity = vectors(&self.velocity);
        fibre.strain = numbers(&self.strain);
        fibre.tension = numbers(&self.tension);
        for (i, pull) in fibre.pull.iter_mut().enumerate() {
            let element = fibre.position[i + 1] - fibre.position[i];
            *pull = element * (fibre.tension[i] / magnitude(element));
        }
        Ok(())
    }

    /// Whether every list is as long as it has to be.
    fn check(&self, name: Fibre, elements: usize, dimension: usize) -> Result<(), String> {
        let name = name.name();
        for (list, found, wanted) in [
            ("position", self.position.len(), elements + 1),
            ("velocity", self.velocity.len(), elements + 1),
            ("strain", self.strain.len(), elements),
            ("tension", self.tension.len(), elements),
        ] {
            if found != wanted {
                return Err(format!("{name}.{list} has {found} entries, not {wanted}"));
            }
        }
        for (list, rows) in [("position", &self.position), ("velocity", &self.velocity)] {
            if let Some(i) = rows.iter().position(|row| row.len() != dimension) {
                let found = rows[i].len();
                return Err(format!("{name}.{list}[{i}] has {found} components, not {dimension}"));
            }
        }
        Ok(())
    }

    fn numbers(&self, name: Fibre) -> [(Quantity, Vec<f64>); 4] {
        let components =
            |rows: &[Vec<Real>]| rows.iter().flatten().map(|x| x.0).collect::<Vec<_>>();
        let numbers = |list: &[Real]| list.iter().map(|x| x.0).collect::<Vec<_>>();
        [
            (Quantity::Position(name), components(&self.position)),
            (Quantity::Velocity(name), components(&self.velocity)),
            (Quantity::Strain(name), numbers(&self.strain)),
            (Quantity::Tension(name), numbers(&self.tension)),
        ]
    }
}

impl StateRecord {
    /// All numbers, by quantity.
    pub fn numbers(&self) -> Vec<(Quantity, Vec<f64>)> {
        let secondary = self.secondary.iter().flat_map(|fibre| fibre.numbers(Fibre::Secondary));
        self.primary
            .numbers(Fibre::Primary)
            .into_iter()
            .chain(secondary)
            .chain([(Quantity::ProjectileVelocity, vec![self.projectile_velocity.0])])
            .collect()
    }
}

impl ResultRecord {
    /// The state at the end of the run.
    pub fn state_record(&self) -> StateRecord {
        StateRecord {
            step: self.steps,
            primary: self.primary.clone(),
            secondary: self.secondary.clone(),
            crossover: self.crossover,
            projectile_velocity: self.projectile.velocity,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::golden::steps::{stepped, vectors};

    /// From a record of a state the march goes on to the same bits: nothing that a step needs is
    /// missing in it.
    #[test]
    fn a_step_from_a_record_gives_the_bits_of_a_step_from_the_state() {
        for vector in vectors() {
            let scene = &vector.scene;
            let start = State::at_impact(scene, Wavefront::Flagged);
            let before = stepped(scene, start, vector.before.step);
            let record = StateRecord::of(&before);
            let again = stepped(scene, record.state(scene).unwrap(), 1);
            let after = stepped(scene, before, 1);
            assert_eq!(StateRecord::of(&again), StateRecord::of(&after), "{}", vector.id);
            assert_ne!(StateRecord::of(&again), record, "{}", vector.id);
        }
    }

    #[test]
    fn a_record_that_does_not_fit_its_scene_is_refused_with_what_does_not_fit() {
        let vector = &vectors()[2];
        let start = State::<f64>::at_impact(&vector.scene, Wavefront::Flagged);
        let good = StateRecord::of(&start);
        let refused = |change: fn(&mut StateRecord)| {
            let mut bad = good.clone();
            change(&mut bad);
            bad.state::<f64>(&vector.scene).unwrap_err()
        };
        assert_eq!(
            refused(|r| r.primary.strain.truncate(10)),
            "primary.strain has 10 entries, not 11"
        );
        assert_eq!(
            refused(|r| r.primary.position[3].push(Real(0.3))),
            "primary.position[3] has 3 components, not 2"
        );
        assert_eq!(refused(|r| r.secondary = None), "there is no `secondary`");
        assert_eq!(
            refused(|r| r.crossover = Some(CrossoverRecord { node: 11, moves: 0 })),
            "node 11 is no place for a crossover"
        );
    }
}
