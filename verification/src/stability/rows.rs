//! The rows of the table of limits.

use crossfibre::errata::{Corrections, Erratum};
use crossfibre::material::{Arm, Coefficients, Update};
use crossfibre::scene::{Law, Material, Scene, Secondary, Strain};

use super::base::Base;
use super::closed_form::largest_courant;
use super::uniform;
use crate::cases::support::shipped;

/// Length of an element of either fibre, m.
const SPACING: f64 = 0.002;

/// Elements of a fibre by itself.
pub const ALONE: usize = 12;

/// Elements of the primary, and of the secondary, which crosses it in the middle.
pub const CROSSED: (usize, usize) = (24, 12);

/// A row.
#[derive(Clone, Debug)]
pub struct Row {
    /// Its id for good.
    pub id: String,
    /// Its part of the table.
    pub group: Group,
    /// What stands in the first columns of its part.
    pub cells: Vec<String>,
    /// Its base state.
    pub base: Base,
    /// The limit by hand.
    pub by_hand: f64,
}

impl Row {
    /// Whether its law dissipates.
    pub fn dissipates(&self) -> bool {
        let material = &self.base.scene.primary.material;
        let arms = matches!(material.law, Law::Viscoelastic { .. } | Law::Eyring { .. });
        arms || material.artificial_viscosity.is_some()
    }
}

/// A part of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// A uniform fibre.
    Uniform,
    /// The same of other laws.
    Law,
    /// The projectile's node.
    Projectile,
    /// The crossover's node.
    Crossover,
    /// The crossover of two different fibres.
    Unequal,
}

impl Group {
    /// All of them, in the order of the page.
    pub const ALL: [Self; 5] =
        [Self::Uniform, Self::Law, Self::Projectile, Self::Crossover, Self::Unequal];

    /// Its name in ids.
    pub fn name(self) -> &'static str {
        match self {
            Self::Uniform => "uniform",
            Self::Law => "law",
            Self::Projectile => "projectile",
            Self::Crossover => "crossover",
            Self::Unequal => "unequal",
        }
    }
}

/// Every row.
pub fn rows() -> Vec<Row> {
    [uniform(), laws(), projectile(), crossover(), unequal()].concat()
}

fn row(group: Group, cells: &[String], base: Base, by_hand: f64) -> Row {
    let words = cells.join("-");
    // Of letters that a file's name may have.
    let id = words.replace(['(', ')', ',', '%'], "").replace("E∞", "E").replace('τ', "t");
    let id = id.split_whitespace().collect::<Vec<_>>().join("-");
    Row { id: format!("{}-{id}", group.name()), group, cells: cells.to_vec(), base, by_hand }
}

/// The paper's fibre with so many elements of 2 mm.
pub fn fibre(elements: usize, strain: Strain) -> Scene {
    let mut scene = shipped("single-400");
    scene.primary.elements = elements;
    scene.primary.length = SPACING * elements as f64;
    scene.strain = strain;
    scene
}

/// A base state of a single fibre, its projectile across.
pub fn at_rest(scene: Scene, strain: f64) -> Base {
    Base { scene, strain, secondary_strain: 0.0, tilt: 0.0, axial: false }
}

/// The name of a measure.
pub fn measure_name(strain: Strain) -> &'static str {
    match strain {
        Strain::Incremental => "(4)",
        Strain::Engineering => "engineering",
    }
}

/// Both measures.
pub const MEASURES: [Strain; 2] = [Strain::Incremental, Strain::Engineering];

fn percent(strain: f64) -> String {
    format!("{} %", (1e6 * strain).round() / 1e4)
}

fn uniform() -> Vec<Row> {
    let mut rows = Vec::new();
    for measure in MEASURES {
        for strain in [0.0, 0.0145, 0.1, 0.5, -0.01] {
            let base = at_rest(fibre(ALONE, measure), strain);
            let cells = [measure_name(measure).into(), percent(strain)];
            let limit = uniform::held(&base);
            rows.push(row(Group::Uniform, &cells, base, limit));
        }
    }
    rows
}

/// A row of a uniform fibre of another law. Without strain there is no tension across it, and only
/// what moves along it is looked at.
fn of_law(name: &str, material: Material, measure: Strain, strain: f64) -> Row {
    let mut scene = fibre(ALONE, measure);
    scene.primary.material = material;
    let base = Base { axial: strain == 0.0, ..at_rest(scene, strain) };
    let cells = [name.to_owned(), measure_name(measure).into(), percent(strain)];
    let limit = uniform::held(&base);
    row(Group::Law, &cells, base, limit)
}

/// The modulus of the paper, Pa.
const MODULUS: f64 = 58.6e9;

fn laws() -> Vec<Row> {
    let mut rows = Vec::new();
    for measure in MEASURES {
        for strain in [0.0145, 0.05] {
            for (name, second) in [("stiffening polynomial", 2e12), ("softening polynomial", -5e11)]
            {
                let law = Law::Polynomial { coefficients: vec![MODULUS, second] };
                rows.push(of_law(name, law.into(), measure, strain));
            }
            let law = Law::Exponential { a: MODULUS / 40.0, b: 40.0 };
            rows.push(of_law("exponential", law.into(), measure, strain));
        }
        let slack = Material { tension_only: true, ..Material::linear(MODULUS) };
        rows.push(of_law("(7), tension only", slack, measure, -0.01));
        for linear in [0.05, 0.1, 0.5] {
            let artificial_viscosity = Some(Coefficients { linear, quadratic: 1.0 });
            let material = Material { artificial_viscosity, ..Material::linear(MODULUS) };
            rows.push(of_law(&format!("(7), viscosity {linear}"), material, measure, 0.0145));
        }
    }
    rows.extend(arms());
    rows
}

/// A spring beside an arm, and an arm alone; times over that of a wave through an element.
fn arms() -> Vec<Row> {
    let scene = fibre(ALONE, Strain::Engineering);
    let crossing_time = SPACING * (scene.primary.density / MODULUS).sqrt();
    let (stress, measure) = (40e6, Strain::Engineering);
    let mut rows = Vec::new();
    for (update, name) in [(Update::Literal, "literal"), (Update::Exact, "exact")] {
        for time in [0.01, 0.1, 0.7, 3.0, 100.0] {
            for equilibrium in [0.0, 0.4] {
                let (equilibrium_modulus, modulus) =
                    (equilibrium * MODULUS, (1.0 - equilibrium) * MODULUS);
                let relaxation_time = time * crossing_time;
                let arms = vec![Arm { modulus, relaxation_time }];
                let maxwell = Law::Viscoelastic { equilibrium_modulus, arms, update };
                // Small stresses relax with the time stress/(E rate).
                let rate = stress / (modulus * relaxation_time);
                let eyring = Law::Eyring { equilibrium_modulus, modulus, rate, stress, update };
                let strain = if equilibrium == 0.0 { 0.0 } else { 0.0145 };
                for (law, of) in [(maxwell, "Maxwell"), (eyring, "Eyring")] {
                    let name = format!("{of} {name}, E∞ {equilibrium}, τ {time}");
                    rows.push(of_law(&name, law.into(), measure, strain));
                }
            }
        }
    }
    rows
}

/// With all corrections but one, or with all.
fn without(erratum: Erratum) -> [(&'static str, Corrections); 2] {
    [("without", Corrections::ALL.without(erratum)), ("with", Corrections::ALL)]
}

/// The projectile's node along a fibre without tension, or across one at a strain.
pub fn struck(mass_ratio: f64, corrections: Corrections, axial: bool, elements: usize) -> Base {
    let mut scene = fibre(elements, Strain::Incremental);
    let lump = scene.primary.density * scene.primary.area * SPACING;
    scene.corrections = corrections;
    scene.projectile.mass = Some(mass_ratio * lump);
    Base { axial, ..at_rest(scene, if axial { 0.0 } else { 0.0145 }) }
}

fn projectile() -> Vec<Row> {
    let mut rows = Vec::new();
    for axial in [true, false] {
        for mass_ratio in [10.0, 1.0, 0.3, 0.1, 0.01, 1e-4, 1e-5] {
            for (inertia, corrections) in without(Erratum::ProjectileInertia) {
                let base = struck(mass_ratio, corrections, axial, ALONE);
                let across = if axial { "along" } else { "across" };
                let cells = [across.into(), mass_ratio.to_string(), inertia.to_owned()];
                let limit = largest_courant(&base);
                rows.push(row(Group::Projectile, &cells, base, limit));
            }
        }
    }
    rows
}

/// Two crossed fibres at 1.45 and 0.3 % of strain.
pub struct Crossing {
    /// Measure of strain.
    pub measure: Strain,
    /// Which equations are corrected.
    pub corrections: Corrections,
    /// α_s.
    pub slide_factor: f64,
    /// Sine of the angle by which the secondary is pulled along the primary.
    pub tilt: f64,
    /// Modulus of the secondary over that of the primary.
    pub modulus: f64,
    /// Density of the secondary over that of the primary.
    pub density: f64,
}

impl Crossing {
    /// The base state.
    pub fn base(&self) -> Base {
        let mut scene = fibre(CROSSED.0, self.measure);
        let modulus = scene.primary.material.instantaneous_modulus();
        scene.corrections = self.corrections;
        scene.secondary = Some(Secondary {
            at: 0.5 * scene.primary.length,
            length: SPACING * CROSSED.1 as f64,
            elements: CROSSED.1,
            density: self.density * scene.primary.density,
            area: scene.primary.area,
            material: Material::linear(self.modulus * modulus),
            slide_factor: self.slide_factor,
        });
        Base { secondary_strain: 0.003, tilt: self.tilt, ..at_rest(scene, 0.0145) }
    }
}

/// The editions of the crossover.
pub const EDITIONS: [(&str, Corrections); 3] = [
    ("as printed", Corrections::NONE),
    ("without inertia", Corrections::ALL.without(Erratum::CrossoverInertia)),
    ("corrected", Corrections::ALL),
];

fn crossover() -> Vec<Row> {
    let mut rows = Vec::new();
    for measure in MEASURES {
        for tilt in [0.0, 0.6] {
            for slide_factor in [0.0, 0.25, 0.5, 0.75, 1.0] {
                for (edition, corrections) in EDITIONS {
                    // (16) as printed pushes a tilted crossover away: it is no equilibrium.
                    if tilt > 0.0 && corrections == Corrections::NONE {
                        continue;
                    }
                    let (modulus, density) = (1.0, 1.0);
                    let base =
                        Crossing { measure, corrections, slide_factor, tilt, modulus, density }
                            .base();
                    let cells = [
                        measure_name(measure).into(),
                        tilt.to_string(),
                        slide_factor.to_string(),
                        edition.into(),
                    ];
                    let limit = largest_courant(&base);
                    rows.push(row(Group::Crossover, &cells, base, limit));
                }
            }
        }
    }
    rows
}

fn unequal() -> Vec<Row> {
    let mut rows = Vec::new();
    for tilt in [0.0, 0.6] {
        for (modulus, density) in [
            (1e4, 1.0),
            (100.0, 1.0),
            (1.0, 0.01),
            (1.0, 1e-4),
            (1e4, 1e-4),
            (0.01, 1.0),
            (1.0, 100.0),
        ] {
            for (edition, corrections) in EDITIONS {
                if corrections == Corrections::NONE {
                    continue;
                }
                let (measure, slide_factor) = (Strain::Engineering, 1.0);
                let base =
                    Crossing { measure, corrections, slide_factor, tilt, modulus, density }.base();
                let cells = [
                    modulus.to_string(),
                    density.to_string(),
                    tilt.to_string(),
                    edition.to_owned(),
                ];
                let limit = largest_courant(&base);
                rows.push(row(Group::Unequal, &cells, base, limit));
            }
        }
    }
    rows
}
