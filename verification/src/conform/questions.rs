//! What a candidate is asked, and what of it a candidate supports.

use crossfibre::discretisation::Discretisation;
use crossfibre::errata::Corrections;
use crossfibre::paper::Paper;
use crossfibre::result::WithPaper;
use crossfibre::scene::{Material, Scene, Strain};
use crossfibre::state::{State, Wavefront};

use super::draw;
use super::protocol::{Ask, Depth, Edition, Form, Hello, StateRecord, Value};
use crate::cases::support::{SCENES, shipped};
use crate::golden::equations::{self, EquationVector};
use crate::golden::file::Flag;
use crate::golden::steps;
use crate::planted::{at_impact, march, with_paper};
use crate::random::SplitMix;

/// A question with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// Depth and name.
    pub id: String,
    /// How deep it goes.
    pub depth: Depth,
    /// What is asked.
    pub ask: Ask,
}

/// Fresh sets of inputs for each equation in each edition.
const SETS: u64 = 4;
/// Fresh states.
const STEPS: usize = 40;
/// Fresh scenes of linear fibres.
const RUNS: usize = 24;
/// Fresh scenes of other laws.
const RUNS_OF_OTHER_LAWS: usize = 8;

/// All questions of a seed, from the nearest to a cause of differences to the farthest.
pub fn all(seed: u64) -> Vec<Item> {
    let stored = equations::vectors();
    let fresh = equations::drawn(seed, SETS);
    let mut items: Vec<_> = stored.iter().chain(&fresh).map(equation).collect();
    items.extend(steps::vectors().into_iter().map(|vector| {
        let start = at_impact(&vector.scene, Wavefront::Flagged);
        let before = steps::stepped(&vector.scene, start, vector.before.step);
        step(&vector.id, vector.scene, &before)
    }));
    // Another sequence than that of the runs, so that either can change without the other.
    let random = &mut SplitMix::new(seed.wrapping_mul(2));
    items.extend((1..=STEPS).map(|k| {
        let scene = draw::scene(random);
        let before = state_on_the_way(&scene, random);
        step(&format!("drawn-{k}"), scene, &before)
    }));
    items.extend(SCENES.iter().map(|(name, _)| run(name, shipped(name))));
    let random = &mut SplitMix::new(seed.wrapping_mul(2).wrapping_add(1));
    items.extend((1..=RUNS).map(|k| run(&format!("drawn-{k}"), draw::scene(random))));
    items
        .extend((1..=RUNS_OF_OTHER_LAWS).map(|k| {
            run(&format!("drawn-of-another-law-{k}"), draw::scene_of_another_law(random))
        }));
    items
}

fn equation(vector: &EquationVector) -> Item {
    let has = |flag| vector.flags.contains(&flag);
    let edition = Edition {
        strain: if has(Flag::Engineering) { Strain::Engineering } else { Strain::Incremental },
        corrections: if has(Flag::Printed) { Form::None } else { Form::All },
    };
    let inputs = vector.inputs.iter().map(|(k, v)| (k.clone(), Value::of(&v.numbers()))).collect();
    Item {
        id: format!("equation/{}", vector.id),
        depth: Depth::Equation,
        ask: Ask::Equation { eq: vector.eq.clone(), edition, inputs },
    }
}

fn step(name: &str, scene: Scene, before: &State<f64>) -> Item {
    let (scene, state) = (Box::new(scene), Box::new(StateRecord::of(before)));
    Item { id: format!("step/{name}"), depth: Depth::Step, ask: Ask::Step { scene, state } }
}

fn run(name: &str, scene: Scene) -> Item {
    let ask = Ask::Run { scene: Box::new(scene) };
    Item { id: format!("run/{name}"), depth: Depth::Run, ask }
}

/// A state of a scene before one of its steps, the next of which does not end the run.
fn state_on_the_way(scene: &Scene, random: &mut SplitMix) -> State<f64> {
    struct March(State<f64>, u64);
    impl WithPaper<f64> for March {
        type Out = State<f64>;
        fn with(self, paper: &impl Paper<f64>) -> State<f64> {
            let Self(mut state, steps) = self;
            let mut before = state.clone();
            while state.step <= steps {
                let mut after = state.clone();
                if march::step(paper, &mut after).is_err() {
                    break;
                }
                before = std::mem::replace(&mut state, after);
            }
            before
        }
    }
    let steps = Discretisation::<f64>::of(scene).steps(scene.duration);
    let made = random.whole(0..usize::try_from(steps).unwrap_or(usize::MAX)) as u64;
    with_paper(scene, March(at_impact(scene, Wavefront::Flagged), made))
}

/// Why a candidate cannot be asked this, by what it says of itself.
pub fn unsupported(item: &Item, hello: &Hello) -> Option<String> {
    if !hello.depths.contains(&item.depth) {
        return Some(format!("no depth {}", item.depth.name()));
    }
    match &item.ask {
        Ask::Hello { .. } => None,
        Ask::Equation { eq, edition, inputs } => {
            let components = inputs.values().map(|v| v.numbers().len()).max().unwrap_or(1);
            no_equation(hello, eq)
                .or_else(|| no_form(hello, edition.corrections))
                .or_else(|| {
                    let matters = eq == "4";
                    (matters && !hello.strain.contains(&edition.strain)).then(no_measure)
                })
                .or_else(|| (components > 1).then(|| no_dimension(hello, components)).flatten())
        }
        Ask::Step { scene, .. } => no_scene(hello, scene).or_else(|| {
            let remembers = scene.materials().any(|m| m.numbers_remembered() > 0);
            remembers.then(|| "a state does not say what a law remembers".into())
        }),
        Ask::Run { scene } => no_scene(hello, scene),
    }
}

fn no_equation(hello: &Hello, eq: &str) -> Option<String> {
    (!hello.equations.iter().any(|e| e == eq)).then(|| format!("no equation {eq}"))
}

fn no_form(hello: &Hello, form: Form) -> Option<String> {
    let name = if form == Form::All { "corrected" } else { "printed" };
    (!hello.corrections.contains(&form)).then(|| format!("no {name} equations"))
}

fn no_measure() -> String {
    "not this measure of strain".into()
}

fn no_dimension(hello: &Hello, dimension: usize) -> Option<String> {
    let has = hello.dimensions.iter().any(|&d| usize::from(d) == dimension);
    (!has).then(|| format!("no dimension {dimension}"))
}

fn no_scene(hello: &Hello, scene: &Scene) -> Option<String> {
    let form = match scene.corrections {
        Corrections::ALL => Form::All,
        Corrections::NONE => Form::None,
        _ => return Some("a choice of corrections".into()),
    };
    let crossing = scene.secondary.is_some();
    let crossed = || (9..=18).find_map(|eq: u8| no_equation(hello, &eq.to_string()));
    no_form(hello, form)
        .or_else(|| (!hello.strain.contains(&scene.strain)).then(no_measure))
        .or_else(|| scene.materials().find_map(|material| no_material(hello, material)))
        .or_else(|| no_dimension(hello, 2))
        .or_else(|| crossing.then(|| no_dimension(hello, 3)).flatten())
        .or_else(|| crossing.then(crossed).flatten())
        .or_else(|| scene.projectile.mass.and_then(|_| no_equation(hello, "8")))
}

fn no_material(hello: &Hello, material: &Material) -> Option<String> {
    let law = match &material.law {
        crossfibre::scene::Law::Linear { .. } => "linear",
        crossfibre::scene::Law::Polynomial { .. } => "polynomial",
        crossfibre::scene::Law::Exponential { .. } => "exponential",
        crossfibre::scene::Law::Viscoelastic { .. } => "viscoelastic",
        crossfibre::scene::Law::Eyring { .. } => "eyring",
    };
    let added = [
        (material.tension_only, "tension_only"),
        (material.artificial_viscosity.is_some(), "artificial_viscosity"),
    ];
    let needed = added.into_iter().filter(|(has, _)| *has).map(|(_, name)| name);
    [law].into_iter().chain(needed).find_map(|name| {
        (!hello.laws.iter().any(|known| known == name)).then(|| format!("no {name} law"))
    })
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn hello(fields: &str) -> Hello {
        let text = format!(r#"{{"id":0,"format":"crossfibre-conformance/1","name":"a"{fields}}}"#);
        serde_json::from_str(&text).unwrap()
    }

    #[test]
    fn names_are_unique_and_every_question_is_supported_by_who_supports_everything() {
        let items = all(1);
        let mut ids: Vec<_> = items.iter().map(|item| &item.id).collect();
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), items.len());
        let all_laws = r#","laws":["linear","polynomial","exponential","viscoelastic","eyring",
            "tension_only","artificial_viscosity"],"corrections":["all","none"]"#;
        let hello = hello(all_laws);
        for item in &items {
            assert_eq!(unsupported(item, &hello), None, "{}", item.id);
        }
        // By their text: what is not a number is not equal to itself.
        let text =
            |items: &[Item]| items.iter().map(|i| json!(i.ask).to_string()).collect::<String>();
        assert!(text(&all(1)) == text(&items) && text(&all(2)) != text(&items));
    }

    #[test]
    fn what_a_candidate_leaves_out_it_is_not_asked() {
        let items = all(1);
        let asked = |fields: &str| {
            let hello = hello(fields);
            let asked = items.iter().filter(|item| unsupported(item, &hello).is_none());
            asked.map(|item| item.id.as_str()).collect::<Vec<_>>()
        };
        let runs = asked(r#","depths":["run"]"#);
        assert!(runs.contains(&"run/fig3") && runs.iter().all(|id| id.starts_with("run/")));
        assert!(!runs.contains(&"run/eyring") && !runs.contains(&"run/fig3-printed"));
        assert!(runs.contains(&"run/finite-projectile"));
        let single = asked(r#","dimensions":[2],"equations":["2","4","5","6","7"]"#);
        assert!(single.contains(&"run/single-400") && !single.contains(&"run/fig3"));
        assert!(!single.contains(&"run/finite-projectile"));
        assert!(single.contains(&"equation/2/2d/corrected/awkward-1"));
        assert!(!single.contains(&"equation/2/3d/corrected/awkward-1"));
        assert!(single.iter().all(|id| !id.contains("printed")));
    }

    #[test]
    fn why_a_candidate_is_not_asked_is_said() {
        let items = all(1);
        let reason = |id: &str, fields: &str| {
            let item = items.iter().find(|item| item.id == id).unwrap();
            unsupported(item, &hello(fields))
        };
        let says = |reason: &str| Some(reason.to_owned());
        let corrected = "equation/7/corrected/awkward-1";
        assert_eq!(reason(corrected, ""), None);
        assert_eq!(reason("equation/7/printed/awkward-1", ""), says("no printed equations"));
        let printed_alone = r#","corrections":["none"]"#;
        assert_eq!(reason(corrected, printed_alone), says("no corrected equations"));
        // Strain is measured by (4), and how is no matter to the other equations.
        let by_length = r#","strain":["engineering"]"#;
        assert_eq!(reason(corrected, by_length), None);
        assert_eq!(reason("equation/4/engineering/awkward-1", by_length), None);
        assert_eq!(
            reason("equation/4/corrected/awkward-1", by_length),
            says("not this measure of strain")
        );
        assert_eq!(reason("run/fig3", by_length), says("not this measure of strain"));
        assert_eq!(reason("run/fig3", r#","dimensions":[2]"#), says("no dimension 3"));
        assert_eq!(reason("run/eyring", ""), says("no eyring law"));
        assert_eq!(reason("run/fig3", r#","depths":["step"]"#), says("no depth run"));

        // A record of a state has no room for what an arm remembers.
        let scene = shipped("viscoelastic");
        let start = at_impact(&scene, Wavefront::Flagged);
        let item = step("viscoelastic", scene, &start);
        assert_eq!(
            unsupported(&item, &hello(r#","laws":["viscoelastic"]"#)),
            says("a state does not say what a law remembers")
        );
    }
}
