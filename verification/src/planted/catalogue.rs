//! Every fault of every part, and which one is planted.

use std::fmt::{self, Display, Formatter};
use std::sync::OnceLock;

use crossfibre::nearest::did_you_mean;

use super::{exact, march, material, record};
use crate::faulty::catalogue as equation;
use crate::faulty::rewritten::Style;

/// The part of the program that a fault is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// A numbered equation.
    Equation(u8),
    /// The order of a step, its time levels, its boundaries.
    March,
    /// What a fibre is made of.
    Material,
    /// The exact solutions.
    Exact,
    /// The stored record of error against work.
    Record,
    /// No fault: the same in other words.
    Rewrite,
}

impl Display for Group {
    fn fmt(&self, to: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Equation(number) => write!(to, "equation {number}"),
            Self::March => to.write_str("march"),
            Self::Material => to.write_str("material"),
            Self::Exact => to.write_str("exact"),
            Self::Record => to.write_str("record"),
            Self::Rewrite => to.write_str("rewrite"),
        }
    }
}

/// An entry of the catalogue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Its name.
    pub id: &'static str,
    /// Where it is.
    pub group: Group,
    /// What is done instead.
    pub what: &'static str,
}

/// What can be planted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plant {
    /// An equation transcribed wrongly.
    Equation(equation::Wrong),
    /// A step made wrongly.
    March(march::Wrong),
    /// A fibre of another law.
    Material(material::Wrong),
    /// An exact solution of another problem.
    Exact(exact::Wrong),
    /// Another record.
    Record(record::Wrong),
    /// Every equation in other words.
    Rewritten(Style),
    /// The march in other words.
    InPlainWords,
}

impl Plant {
    /// Its entry.
    pub fn entry(self) -> Fault {
        let entry = |group, (id, what)| Fault { id, group, what };
        match self {
            Self::Equation(wrong) => {
                let equation::Fault { id, equation, what } = *wrong.fault();
                entry(Group::Equation(equation), (id, what))
            }
            Self::March(wrong) => entry(Group::March, wrong.words()),
            Self::Material(wrong) => entry(Group::Material, wrong.words()),
            Self::Exact(wrong) => entry(Group::Exact, wrong.words()),
            Self::Record(wrong) => entry(Group::Record, wrong.words()),
            Self::Rewritten(Style::Expanded) => entry(
                Group::Rewrite,
                ("rewrite-expanded", "multiplies the products of every equation out"),
            ),
            Self::Rewritten(Style::Factored) => entry(
                Group::Rewrite,
                ("rewrite-factored", "scales roots and takes reciprocals in every equation"),
            ),
            Self::InPlainWords => entry(
                Group::Rewrite,
                ("rewrite-march", "marches one element after the other, in plain words"),
            ),
        }
    }
}

fn faults() -> impl Iterator<Item = Plant> {
    let equations = equation::Wrong::ALL.iter().map(|&wrong| Plant::Equation(wrong));
    equations
        .chain(march::Wrong::ALL.iter().map(|&wrong| Plant::March(wrong)))
        .chain(material::Wrong::ALL.iter().map(|&wrong| Plant::Material(wrong)))
        .chain(exact::Wrong::ALL.iter().map(|&wrong| Plant::Exact(wrong)))
        .chain(record::Wrong::ALL.iter().map(|&wrong| Plant::Record(wrong)))
}

fn other_words() -> impl Iterator<Item = Plant> {
    Style::ALL.into_iter().map(Plant::Rewritten).chain([Plant::InPlainWords])
}

/// Every fault, part by part.
pub fn all() -> Vec<Fault> {
    faults().map(Plant::entry).collect()
}

/// What is no fault: the same in other words.
pub fn rewrites() -> Vec<Fault> {
    other_words().map(Plant::entry).collect()
}

/// Why nothing was planted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refused {
    /// There is no fault of that name.
    Unknown {
        /// The name.
        id: String,
        /// The question whether another was meant; empty if none is near.
        meant: String,
    },
    /// Something has been planted in this process before.
    Twice,
}

impl Display for Refused {
    fn fmt(&self, to: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { id, meant } => write!(to, "no fault is called `{id}`{meant}"),
            Self::Twice => write!(to, "something has been planted before"),
        }
    }
}

impl std::error::Error for Refused {}

static PLANTED: OnceLock<Plant> = OnceLock::new();

/// Plants a fault, or other words, for the rest of this process.
pub fn plant(id: &str) -> Result<(), Refused> {
    PLANTED.set(find(id)?).map_err(|_| Refused::Twice)
}

/// What is planted in this process.
#[inline]
pub fn now() -> Option<Plant> {
    PLANTED.get().copied()
}

/// What is called so.
pub(super) fn find(id: &str) -> Result<Plant, Refused> {
    let known = || faults().chain(other_words());
    known().find(|plant| plant.entry().id == id).ok_or_else(|| {
        let names: Vec<_> = known().map(|plant| plant.entry().id).collect();
        Refused::Unknown { id: id.into(), meant: did_you_mean(id, &names) }
    })
}
