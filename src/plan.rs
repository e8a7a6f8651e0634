//! What a run of a scene will do, before it is done: the mesh, the time step, which equations run
//! and which are left out, and why.

use serde::Serialize;

use crate::discretisation::{Discretisation, Properties};
use crate::place::Fibre;
use crate::result::FibreResult;
use crate::scene::{Material, Scene, Strain};
use crate::state::FibreState;

/// The format that this version writes.
pub const FORMAT: &str = "crossfibre-plan/1";

/// Element-steps beyond which a run has to be asked for twice: a quarter of an hour or more at
/// 10⁸ a second.
pub const MANY_ELEMENT_STEPS: f64 = 1e11;

/// A plan.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Plan {
    /// `crossfibre-plan/1`.
    pub format: &'static str,
    /// The scene's title.
    pub title: String,
    /// Δt, s.
    pub time_step: f64,
    /// Steps to make.
    pub steps: u64,
    /// Steps × Δt, s: the time that will be reached.
    pub time: f64,
    /// The fibres.
    pub fibres: Vec<FibrePlan>,
    /// `ix` at the start.
    pub crossover_node: Option<usize>,
    /// Ids of the corrections chosen.
    pub corrections: Vec<&'static str>,
    /// All twenty equations.
    pub equations: Vec<EquationPlan>,
    /// Element-steps at the most, elements ahead of the front left out; more if the crossover slides past
    /// the front.
    pub element_steps: f64,
    /// Memory of the state, bytes.
    pub memory: f64,
}

/// What a plan says of a fibre.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FibrePlan {
    /// Which.
    pub fibre: Fibre,
    /// Number of elements.
    pub elements: usize,
    /// Δx, m.
    pub spacing: f64,
    /// c, m/s.
    pub wave_speed: f64,
    /// α by (20).
    pub courant: f64,
    /// The greatest α that is stable with the fibre at rest: 1, or less with artificial viscosity.
    pub greatest_courant: f64,
    /// Name of the law.
    pub law: &'static str,
    /// Δm, kg.
    pub node_mass: f64,
    /// Components of a vector.
    pub dimensions: usize,
}

/// What a plan says of an equation.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct EquationPlan {
    /// Number on the page.
    pub equation: u8,
    /// Whether a step evaluates it.
    pub runs: bool,
    /// Why, or why not.
    pub why: &'static str,
}

impl Plan {
    /// The plan of a scene that has passed [`Scene::check`].
    pub fn of(scene: &Scene) -> Self {
        let mesh = Discretisation::<f64>::of(scene);
        let steps = mesh.steps(scene.duration);
        let fibre = |fibre, dimensions, of: &Properties<f64>, material: &Material| FibrePlan {
            fibre,
            law: material.law.name(),
            greatest_courant: material
                .artificial_viscosity
                .map_or(1.0, |viscosity| viscosity.greatest_courant_at_rest()),
            elements: of.elements,
            spacing: of.spacing,
            wave_speed: of.wave_speed,
            courant: of.courant(mesh.time_step),
            node_mass: of.mass,
            dimensions,
        };
        let mut fibres = vec![fibre(Fibre::Primary, 2, &mesh.primary, &scene.primary.material)];
        let mut element_steps = flagged_element_steps(steps, mesh.primary.elements, 0);
        let mut memory = memory_of::<2>(mesh.primary.elements, &scene.primary.material);
        if let Some((crossing, secondary)) = mesh.secondary.as_ref().zip(scene.secondary.as_ref()) {
            fibres.push(fibre(Fibre::Secondary, 3, &crossing.fibre, &secondary.material));
            element_steps += flagged_element_steps(steps, crossing.fibre.elements, crossing.node);
            memory += memory_of::<3>(crossing.fibre.elements, &secondary.material);
        }
        Self {
            format: FORMAT,
            title: scene.title.clone(),
            time_step: mesh.time_step,
            steps,
            time: steps as f64 * mesh.time_step,
            fibres,
            crossover_node: mesh.secondary.map(|crossing| crossing.node),
            corrections: scene.corrections.iter().map(|e| e.entry().id).collect(),
            equations: equations(scene, mesh.secondary.map(|crossing| crossing.node)),
            element_steps,
            memory,
        }
    }
}

/// Memory of a fibre's state, bytes.
fn memory_of<const D: usize>(elements: usize, material: &Material) -> f64 {
    let numbers = material.numbers_remembered();
    let of_law = (numbers * size_of::<f64>()) as f64;
    elements as f64 * (FibreState::<f64, D>::BYTES_PER_ELEMENT + of_law)
}

/// Memory of a fibre's state and of its result, bytes.
pub(crate) fn memory_of_run<const D: usize>(elements: usize, material: &Material) -> f64 {
    memory_of::<D>(elements, material) + elements as f64 * FibreResult::bytes_per_element(D)
}

/// Σ over the steps of the elements visited when the front starts at element 0 after `quiet` steps
/// and gains one element a step. One element is visited before that.
fn flagged_element_steps(steps: u64, elements: usize, quiet: usize) -> f64 {
    let (steps, elements, quiet) = (steps as f64, elements as f64, quiet as f64);
    let moving = (steps - quiet).max(0.0);
    let growing = moving.min(elements);
    steps.min(quiet) + growing * (growing + 1.0) / 2.0 + (moving - growing) * elements
}

/// Which equations a step of this scene evaluates.
fn equations(scene: &Scene, crossover_node: Option<usize>) -> Vec<EquationPlan> {
    let incremental = scene.strain == Strain::Incremental;
    let crossover: Result<&str, &str> = match crossover_node {
        None => Err("no secondary fibre"),
        Some(0) => Err("both fibres are at the impact point: the projectile drives both"),
        Some(_) => Ok("the secondary fibre crosses away from the impact point"),
    };
    let why = |number: u8| match number {
        1 => Err("(2) is its solved form; checks use it to audit a step"),
        2 => Ok("every inner node"),
        3 => Err("the strain is advanced by (4)"),
        4 if incremental => Ok("every element"),
        4 => Ok("every element, by L/L⁰ - 1 in its place"),
        5 if incremental => Ok("every element"),
        5 => Err("engineering strain does not look at the previous length"),
        7 if scene.has_other_laws() => Ok("every element, σ by the law of its fibre"),
        6 | 7 => Ok("every element"),
        8 if scene.projectile.mass.is_some() => Ok("the projectile has a mass"),
        8 => Err("the projectile's velocity is constant"),
        14 if crossover_node.is_some() => Ok("the secondary's first node"),
        9..=18 => crossover,
        19 => Err("the equation the scheme approximates; checks use it"),
        _ => Err("evaluated once for this plan, not in a step"),
    };
    (1..=20)
        .map(|equation| {
            let why = why(equation);
            EquationPlan { equation, runs: why.is_ok(), why: why.unwrap_or_else(|no| no) }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_element_takes_eight_bytes_a_number_and_its_law_as_many_for_what_it_remembers() {
        let linear = Material::linear(58.6e9);
        // Three vectors and three numbers.
        assert_eq!(memory_of::<2>(7, &linear), 7.0 * 9.0 * 8.0);
        assert_eq!(memory_of::<3>(7, &linear), 7.0 * 12.0 * 8.0);
        let material = r#"{"law": "viscoelastic", "equilibrium_modulus": 41.3e9, "arms": [
            {"modulus": 19.7e9, "relaxation_time": 7.3e-6},
            {"modulus": 10.3e9, "relaxation_time": 61e-6}]}"#;
        let viscoelastic: Material = serde_json::from_str(material).unwrap();
        // The stresses of two arms, and what was dissipated.
        assert_eq!(memory_of::<2>(7, &viscoelastic), 7.0 * (9.0 + 3.0) * 8.0);
    }

    #[test]
    fn a_plan_adds_the_memory_of_both_fibres_and_reaches_the_time_of_its_steps() {
        let text = include_str!("../verification/scenes/viscoelastic.json");
        let scene = crate::scene_file::read(text).unwrap();
        let plan = Plan::of(&scene);
        let secondary = scene.secondary.unwrap();
        let expected = memory_of::<2>(scene.primary.elements, &scene.primary.material)
            + memory_of::<3>(secondary.elements, &secondary.material);
        assert_eq!(plan.memory, expected);
        assert_eq!(plan.equations[6].why, "every element, σ by the law of its fibre");
        assert_eq!(plan.time, plan.steps as f64 * plan.time_step);
        // To the nearest step.
        assert!((plan.time - scene.duration).abs() <= 0.5 * plan.time_step, "{}", plan.time);
    }

    #[test]
    fn an_equation_that_a_step_leaves_out_or_changes_is_told_why() {
        let scene = |strain| {
            let text = r#"{"format": "crossfibre-scene/1", "title": "one fibre",
                "primary": {"length": 0.3, "elements": 15, "density": 1206.7, "area": 1e-6,
                    "material": {"law": "linear", "modulus": 58.6e9}},
                "projectile": {"velocity": 317.0}, "courant": 0.937, "duration": 2e-5}"#;
            Scene { strain, ..crate::scene_file::read(text).unwrap() }
        };
        for (strain, fourth, fifth) in [
            (Strain::Incremental, "every element", "every element"),
            (Strain::Engineering, "by L/L⁰ - 1", "does not look at the previous length"),
        ] {
            let plan = equations(&scene(strain), None);
            let why = |equation: usize| (plan[equation - 1].runs, plan[equation - 1].why);
            let told = [why(1), why(3), why(4), why(5), why(8), why(9), why(19), why(20)];
            let runs =
                [false, false, true, strain == Strain::Incremental, false, false, false, false];
            assert_eq!(told.map(|(runs, _)| runs), runs);
            let part = [
                "(2) is its solved form",
                "advanced by (4)",
                fourth,
                fifth,
                "velocity is constant",
                "no secondary",
                "the scheme approximates",
                "evaluated once",
            ];
            for ((_, why), part) in told.iter().zip(part) {
                assert!(why.contains(part), "{why}: {part}");
            }
        }
        let plan = equations(&scene(Strain::Incremental), None);
        assert_eq!((plan[3].why, plan[6].why), ("every element", "every element"));
    }

    #[test]
    fn the_front_gains_an_element_a_step_until_the_clamp() {
        // 1 + 2 + 3 + 3 + 3
        assert_eq!(flagged_element_steps(5, 3, 0), 12.0);
        // two quiet steps of one element, then 1 + 2 + 3
        assert_eq!(flagged_element_steps(5, 7, 2), 8.0);
        assert_eq!(flagged_element_steps(2, 7, 4), 2.0);
    }
}
