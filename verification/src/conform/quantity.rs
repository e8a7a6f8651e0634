//! What is compared: the quantities of a state, each as a list of numbers.

use std::fmt::{self, Display, Formatter};

use crossfibre::number::{Number, Vector};
use crossfibre::place::Fibre;
use crossfibre::state::{FibreState, State};

/// A quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    /// What an equation gives.
    Equation(u8),
    /// Of the nodes of a fibre, m.
    Position(Fibre),
    /// Of the nodes of a fibre, m/s.
    Velocity(Fibre),
    /// Of the elements of a fibre.
    Strain(Fibre),
    /// Of the elements of a fibre, N.
    Tension(Fibre),
    /// Of the projectile for the next step, m/s.
    ProjectileVelocity,
    /// Distance travelled by the projectile, m.
    ProjectilePosition,
    /// Of both halves of the fibres and of the projectile, J.
    Energy,
}

impl Display for Quantity {
    fn fmt(&self, to: &mut Formatter) -> fmt::Result {
        match self {
            Self::Equation(number) => write!(to, "eqn ({number})"),
            Self::Position(fibre) => write!(to, "{} position", fibre.name()),
            Self::Velocity(fibre) => write!(to, "{} velocity", fibre.name()),
            Self::Strain(fibre) => write!(to, "{} strain", fibre.name()),
            Self::Tension(fibre) => write!(to, "{} tension", fibre.name()),
            Self::ProjectileVelocity => write!(to, "projectile velocity"),
            Self::ProjectilePosition => write!(to, "projectile position"),
            Self::Energy => write!(to, "energy"),
        }
    }
}

impl Quantity {
    /// Where a number of its list is, such as `node 3, y`; nothing where there is only one.
    pub fn place(self, index: usize) -> String {
        let node = |dimension: usize| {
            format!("node {}, {}", index / dimension, ["x", "y", "z"][index % dimension])
        };
        match self {
            Self::Position(Fibre::Primary) | Self::Velocity(Fibre::Primary) => node(2),
            Self::Position(Fibre::Secondary) | Self::Velocity(Fibre::Secondary) => node(3),
            Self::Strain(_) | Self::Tension(_) => format!("element {index}"),
            Self::Equation(_) => format!("component {index}"),
            Self::ProjectileVelocity | Self::ProjectilePosition | Self::Energy => String::new(),
        }
    }
}

/// The numbers of a state, vectors component by component.
pub fn numbers<S: Number>(state: &State<S>) -> Vec<(Quantity, Vec<S>)> {
    let mut all = of_fibre(Fibre::Primary, &state.primary);
    if let Some(crossover) = &state.crossover {
        all.extend(of_fibre(Fibre::Secondary, &crossover.fibre));
    }
    all.push((Quantity::ProjectileVelocity, vec![state.projectile.velocity]));
    all
}

fn of_fibre<S: Number, const D: usize>(
    name: Fibre,
    fibre: &FibreState<S, D>,
) -> Vec<(Quantity, Vec<S>)> {
    let components =
        |vectors: &[Vector<S, D>]| vectors.iter().flat_map(|v| v.iter().copied()).collect();
    vec![
        (Quantity::Position(name), components(&fibre.position)),
        (Quantity::Velocity(name), components(&fibre.velocity)),
        (Quantity::Strain(name), fibre.strain.clone()),
        (Quantity::Tension(name), fibre.tension.clone()),
    ]
}

/// What half a unit in the last place is taken of, where a quantity has a size of its own and not
/// just that of its numbers: a strain is a stretch less 1, a tension E·area times a strain, and the
/// velocities of a fibre come from tensions, a strain of 1 being worth its wave speed.
pub fn natural_size<S: Number>(quantity: Quantity, state: &State<S>) -> f64 {
    let secondary = state.crossover.as_ref().map(|crossover| &crossover.fibre.properties);
    let properties = match quantity {
        Quantity::Strain(Fibre::Secondary)
        | Quantity::Tension(Fibre::Secondary)
        | Quantity::Velocity(Fibre::Secondary) => secondary.unwrap_or(&state.primary.properties),
        _ => &state.primary.properties,
    };
    match quantity {
        Quantity::Strain(_) => 1.0,
        Quantity::Tension(_) => properties.stiffness.to_f64(),
        Quantity::Velocity(_) | Quantity::ProjectileVelocity => properties.wave_speed.to_f64(),
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_of_a_list_has_its_place() {
        assert_eq!(Quantity::Velocity(Fibre::Primary).place(7), "node 3, y");
        assert_eq!(Quantity::Position(Fibre::Secondary).place(7), "node 2, y");
        assert_eq!(Quantity::Strain(Fibre::Secondary).place(7), "element 7");
        assert_eq!(Quantity::Energy.place(0), "");
    }
}
