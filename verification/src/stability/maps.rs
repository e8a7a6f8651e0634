//! The maps: a parameter across, the Courant number upward.

use crossfibre::errata::{Corrections, Erratum};
use crossfibre::number::Number;
use crossfibre::scene::Strain;

use super::base::Base;
use super::closed_form::largest_courant;
use super::growth::STEPS;
use super::rows::{ALONE, Crossing, EDITIONS, MEASURES, at_rest, fibre, measure_name, struck};
use super::tasks::Task;
use super::uniform::finite;
use crate::cases::support::exact_primary;
use crate::closed_form::{component, law};
use crate::oracle::smith;
use crate::plot::Axis;
use crate::sweep::Point;

/// Values at equal distances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// The first.
    pub from: f64,
    /// The last.
    pub to: f64,
    /// How many.
    pub count: usize,
}

impl Grid {
    const fn new(from: f64, to: f64, count: usize) -> Self {
        Self { from, to, count }
    }

    /// From one to the next.
    pub fn step(self) -> f64 {
        (self.to - self.from) / (self.count - 1) as f64
    }

    /// The values.
    pub fn values(self) -> Vec<f64> {
        // Of six decimals, so that they read as what they are.
        let value = |k| self.from + k as f64 * self.step();
        (0..self.count).map(|k| (1e6 * value(k)).round() / 1e6).collect()
    }

    /// An axis over all cells.
    pub fn axis(self, label: &str, step: f64) -> Axis {
        Axis::new(label, self.from - 0.5 * self.step(), self.to + 0.5 * self.step(), step)
    }
}

/// What is on the abscissa, and what is marched at a value.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// The slide factor of a tilted crossover.
    Slide(Corrections),
    /// The logarithm of the modulus ratio of a tilted crossover.
    Modulus(Corrections),
    /// The velocity of impact over the wave speed.
    Velocity(Strain),
    /// The logarithm of the projectile's mass over a node's.
    Mass(Corrections),
}

/// A map.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// Its id, and that of its picture's panel.
    pub id: String,
    /// What stands over it.
    pub title: String,
    /// Name of the abscissa in tables.
    pub abscissa: &'static str,
    /// Label and distance of ticks of the abscissa.
    pub label: (&'static str, f64),
    /// Its values.
    pub x: Grid,
    /// Courant numbers, and the distance of ticks.
    pub courant: (Grid, f64),
    kind: Kind,
}

/// Sine of the angle by which the crossover of the maps is tilted.
pub const TILT: f64 = 0.6;

/// Every map; those of one picture follow each other.
pub fn maps() -> Vec<Map> {
    let near_one = (Grid::new(0.95, 1.03, 21), 0.02);
    let editions = || EDITIONS.into_iter().filter(|(_, set)| *set != Corrections::NONE);
    let slide = editions().map(|(name, set)| Map {
        id: format!("slide-{}", name.replace(' ', "-")),
        title: format!("Tilted crossover, {name}"),
        abscissa: "slide factor [1]",
        label: ("slide factor αₛ", 0.2),
        x: Grid::new(0.0, 1.0, 21),
        courant: near_one,
        kind: Kind::Slide(set),
    });
    let modulus = editions().map(|(name, set)| Map {
        id: format!("modulus-{}", name.replace(' ', "-")),
        title: format!("Tilted crossover, {name}"),
        abscissa: "log10 of the modulus ratio [1]",
        label: ("log₁₀ of the secondary's modulus over the primary's", 1.0),
        x: Grid::new(-4.0, 4.0, 33),
        courant: near_one,
        kind: Kind::Modulus(set),
    });
    let velocity = MEASURES.into_iter().map(|measure| Map {
        id: format!(
            "velocity-{}",
            if measure == Strain::Engineering { "engineering" } else { "4" }
        ),
        title: format!("Impact, strain {}", measure_name(measure)),
        abscissa: "velocity over wave speed [1]",
        label: ("velocity of impact over wave speed", 0.2),
        x: Grid::new(0.05, 0.95, 19),
        courant: (Grid::new(0.3, 1.05, 16), 0.1),
        kind: Kind::Velocity(measure),
    });
    let inertia = Erratum::ProjectileInertia;
    let sets = [("without", Corrections::ALL.without(inertia)), ("with", Corrections::ALL)];
    let mass = sets.into_iter().map(|(name, set)| Map {
        id: format!("mass-{name}"),
        title: format!("Projectile along the fibre, {name} the node's inertia"),
        abscissa: "log10 of projectile mass over node mass [1]",
        label: ("log₁₀ of the projectile's mass over a node's", 1.0),
        x: Grid::new(-5.0, 1.0, 25),
        courant: (Grid::new(0.025, 1.075, 22), 0.1),
        kind: Kind::Mass(set),
    });
    slide.chain(modulus).chain(velocity).chain(mass).collect()
}

impl Map {
    /// The base state at a value of the abscissa; for an impact, what is behind its front.
    pub fn base(&self, x: f64) -> Base {
        let crossing = |corrections, slide_factor, modulus| {
            let (measure, tilt, density) = (Strain::Engineering, TILT, 1.0);
            Crossing { measure, corrections, slide_factor, tilt, modulus, density }.base()
        };
        match self.kind {
            Kind::Slide(corrections) => crossing(corrections, x, 1.0),
            Kind::Modulus(corrections) => crossing(corrections, 1.0, power_of_ten(x)),
            Kind::Mass(corrections) => struck(power_of_ten(x), corrections, true, ALONE),
            Kind::Velocity(measure) => {
                let scene = fibre(ALONE, measure);
                let c = exact_primary(&scene).wave_speed();
                let exact = smith(law(&scene), c, x * c).expect("Smith's relation has a solution");
                let strain = component(&scene, exact.strain);
                at_rest(scene, strain)
            }
        }
    }

    /// The limit of the mesh of [`Map::base`] over that of the mesh of the cells. An impact runs on a
    /// fibre whose end is not reached.
    pub fn finite(&self) -> f64 {
        if matches!(self.kind, Kind::Velocity(_)) { finite(ALONE) } else { 1.0 }
    }

    /// The limit by hand, on fibres without end.
    pub fn by_hand(&self, x: f64) -> f64 {
        largest_courant(&self.base(x))
    }

    fn column_id(&self, what: &str, x: f64) -> String {
        format!("{}-{what}-{x}", self.id)
    }

    /// The id of the point with the cells at a value.
    pub fn cells_id(&self, x: f64) -> String {
        self.column_id("cells", x)
    }

    /// The id of the point with the limit by the spectral radius at a value.
    pub fn edge_id(&self, x: f64) -> String {
        self.column_id("edge", x)
    }

    /// Its points.
    pub fn points(&self) -> Vec<Point<Task>> {
        let courant = self.courant.0.values();
        self.x
            .values()
            .into_iter()
            .flat_map(|x| {
                let (base, courant) = (self.base(x), courant.clone());
                let cells = if let Kind::Velocity(measure) = self.kind {
                    let steps = STEPS[0] as usize;
                    let mut scene = fibre(steps, measure);
                    scene.projectile.velocity = x * exact_primary(&scene).wave_speed();
                    Task::Struck { scene, exact: base.strain, courant }
                } else {
                    Task::Perturbed { base: base.clone(), courant }
                };
                [(self.cells_id(x), cells), (self.edge_id(x), Task::Edge(base))]
            })
            .map(|(id, parameters)| Point { id, parameters })
            .collect()
    }
}

fn power_of_ten(x: f64) -> f64 {
    Number::exp(x * std::f64::consts::LN_10)
}
