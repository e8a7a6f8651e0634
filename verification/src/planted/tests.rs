use std::fs;
use std::path::{Path, PathBuf};

use crossfibre::corrected::{Corrected, Incremental};
use crossfibre::errata::Corrections;
use crossfibre::outcome::Outcome;
use crossfibre::paper::Paper;
use crossfibre::result::{self, Marcher, RunResult, WithPaper};
use crossfibre::scene::{Law, Scene, Strain};
use crossfibre::state::{State, Wavefront};

use super::catalogue::find;
use super::{Group, Refused, all, check, march, material, now, record, rewrites};
use crate::cases::support::{SCENES, kinked, measured_by, shipped};
use crate::golden::steps;
use crate::precision::stored::stored;

#[test]
fn every_part_has_its_faults_and_every_name_leads_back() {
    let entries = [all(), rewrites()].concat();
    for entry in &entries {
        assert_eq!(find(entry.id).unwrap().entry(), *entry);
        assert_eq!(entries.iter().filter(|other| other.id == entry.id).count(), 1, "{}", entry.id);
    }
    let of = |group: &str| all().iter().filter(|f| f.group.to_string().starts_with(group)).count();
    for number in 1..=20 {
        let faults = all().into_iter().filter(|f| f.group == Group::Equation(number));
        assert!(faults.count() >= 5, "({number})");
    }
    assert!(of("march") >= 12 && of("material") >= 16 && of("exact") >= 16 && of("record") >= 4);
    assert_eq!(rewrites().len(), 3);
    assert_eq!(now(), None);
}

#[test]
fn an_unknown_name_is_refused_and_the_nearest_named() {
    let refused = find("march-ix-stael").unwrap_err();
    assert_eq!(
        refused.to_string(),
        "no fault is called `march-ix-stael`, did you mean `march-ix-stale`?"
    );
    assert_eq!(find("q").unwrap_err().to_string(), "no fault is called `q`");
    assert_eq!(Refused::Twice.to_string(), "something has been planted before");
}

/// The words that the stored matrix has.
#[test]
fn every_part_is_called_by_its_name() {
    let groups = [Group::Equation(17), Group::March, Group::Material, Group::Exact];
    assert_eq!(groups.map(|g| g.to_string()), ["equation 17", "march", "material", "exact"]);
    let others = [Group::Record, Group::Rewrite];
    assert_eq!(others.map(|g| g.to_string()), ["record", "rewrite"]);
}

/// Marches in plain words, by fibres of this making.
pub(super) struct InPlainWords(pub(super) Option<march::Wrong>, pub(super) Option<material::Wrong>);

impl Marcher for InPlainWords {
    fn at_impact(&self, scene: &Scene) -> State<f64> {
        let mut state = State::at_impact(scene, Wavefront::Flagged);
        if let Some(wrong) = self.1 {
            wrong.put_into(scene, &mut state);
        }
        state
    }

    fn march<P: Paper<f64>>(
        &self,
        paper: &P,
        state: &mut State<f64>,
        steps: u64,
        mut watch: impl FnMut(&State<f64>),
    ) -> Outcome {
        march::run_in_plain_words(paper, state, steps, &mut watch, self.0)
    }
}

pub(super) fn text(result: &RunResult) -> String {
    serde_json::to_string(result).unwrap()
}

pub(super) fn scenes() -> Vec<(String, Scene)> {
    let mut scenes = vec![("kinked".to_owned(), kinked())];
    for (name, _) in SCENES {
        for strain in [Strain::Incremental, Strain::Engineering] {
            scenes.push((format!("{name}, {strain:?}"), measured_by(strain, shipped(name))));
        }
    }
    // Struck so fast that its waves outgrow the step.
    let mut fast = shipped("hardening");
    (fast.projectile.velocity, fast.courant) = (731.0, 0.93);
    scenes.push(("outgrown".into(), fast));
    // Both fibres slow the projectile down.
    let mut heavy = shipped("both-at-origin");
    heavy.projectile.mass = Some(1.3e-4);
    scenes.push(("both slow".into(), heavy));
    // Laws that no shipped scene is of.
    let mut exponential = shipped("unequal");
    exponential.primary.material.law = Law::Exponential { a: 1.13e9, b: 51.3 };
    scenes.push(("exponential".into(), exponential));
    scenes
}

/// JSON tells numbers apart by every bit.
#[test]
fn in_plain_words_the_march_gives_the_same_bits() {
    for (name, scene) in scenes() {
        let expected = text(&result::run(&scene, |_| ()));
        let found = text(&result::run_with(&InPlainWords(None, None), &scene, |_| ()));
        assert!(expected == found, "{name}");
    }
}

#[test]
fn in_plain_words_the_march_gives_the_same_bits_in_blocks_of_one() {
    struct Trace<'a>(&'a Scene, bool);
    impl WithPaper<f64> for Trace<'_> {
        type Out = Vec<String>;
        fn with(self, paper: &impl Paper<f64>) -> Vec<String> {
            use crossfibre::trace::{Event, Traced};
            let mut seen = Vec::new();
            let mut state = State::<f64>::at_impact(self.0, Wavefront::Flagged);
            let traced = Traced::new(paper, |event: &Event<'_, f64>| {
                seen.push(format!("{event:?}"));
            });
            if self.1 {
                march::run_in_plain_words(&traced, &mut state, 25, &mut |_| (), None);
            } else {
                crossfibre::march::run(&traced, &mut state, 25, |_| ());
            }
            let booked = state.primary.constitution.map(|by| (by.path.stored, by.path.dissipated));
            seen.push(format!("{booked:?}"));
            seen
        }
    }
    for name in ["unequal", "eyring", "both-at-origin", "finite-projectile"] {
        let scene = shipped(name);
        let events = |plain| result::with_paper(&scene, Trace(&scene, plain));
        assert!(events(true) == events(false), "{name}");
    }
}

/// Steps from states of which one number is spoilt.
#[test]
fn in_plain_words_a_step_that_is_not_finite_ends_at_the_same_place_in_the_same_equation() {
    let scene = shipped("single-400");
    let paper = &Corrected::<Incremental>::new(Corrections::ALL);
    let end = |spoil: &dyn Fn(&mut State<f64>)| {
        let mut state = State::<f64>::at_impact(&scene, Wavefront::Ignored);
        spoil(&mut state);
        let outcome = crossfibre::march::run(paper, &mut state.clone(), 1, |_| ());
        let found = march::run_in_plain_words(paper, &mut state, 1, &mut |_| (), None);
        assert_eq!(found, outcome);
        let Outcome::Diverged { place, equation } = outcome else { panic!("{outcome}") };
        (place.index, equation)
    };
    assert_eq!(end(&|state| state.primary.velocity[2].x = f64::INFINITY), (2, 2));
    // An element without length.
    assert_eq!(end(&|state| state.primary.position[2] = state.primary.position[1]), (1, 6));
    assert_eq!(end(&|state| state.primary.strain[1] = f64::INFINITY), (1, 4));
    // A tension that is finite, and a quotient by the length of a nanometre that is not.
    let in_no_length = |state: &mut State<f64>| {
        state.primary.strain[1] = 1e296;
        state.primary.velocity[2].x = 1.0;
        state.primary.position[2].x = state.primary.position[1].x + 1e-9 - state.time_step;
    };
    assert_eq!(end(&in_no_length), (1, 7));
}

#[test]
fn with_nothing_planted_a_scene_that_is_wrong_is_refused() {
    let mut scene = shipped("single-400");
    assert!(check(&scene).is_ok());
    scene.courant = -0.7;
    assert_eq!(check(&scene).unwrap_err().path, "courant");
}

#[test]
fn only_where_there_are_whole_gigapascals_are_they_taken() {
    let mut scene = shipped("single-400");
    let stiffness = |scene: &Scene| {
        let mut state = State::<f64>::at_impact(scene, Wavefront::Flagged);
        material::Wrong::LinearDigits.put_into(scene, &mut state);
        state.primary.properties.stiffness / state.primary.properties.area
    };
    assert!((stiffness(&scene) / 58e9 - 1.0).abs() < 1e-15);
    scene.primary.material = Law::Linear { modulus: 0.7e9 }.into();
    assert!((stiffness(&scene) / 0.7e9 - 1.0).abs() < 1e-15);
}

#[test]
fn every_fault_of_the_march_and_of_the_materials_changes_a_run() {
    let scenes = scenes();
    let changes = |marcher: InPlainWords| {
        scenes.iter().any(|(_, scene)| {
            let right = text(&result::run(scene, |_| ()));
            text(&result::run_with(&marcher, scene, |_| ())) != right
        })
    };
    for &wrong in march::Wrong::ALL {
        // The clamps of a scene are at rest, and so is the node ahead of the front: a step from a state in
        // motion shows it, as golden vectors have them.
        if !matches!(wrong, march::Wrong::ClampAtRest | march::Wrong::FlagsShort) {
            assert!(changes(InPlainWords(Some(wrong), None)), "{wrong:?}");
        }
    }
    // What is not looked at does no harm to a scene that is right, and none of these asks for forward
    // differences.
    let harmless = [material::Wrong::Unchecked, material::Wrong::ViscoelasticExact];
    for &wrong in material::Wrong::ALL.iter().filter(|wrong| !harmless.contains(wrong)) {
        assert!(changes(InPlainWords(None, Some(wrong))), "{wrong:?}");
    }
}

#[test]
fn every_fault_of_the_record_changes_it() {
    for &wrong in record::Wrong::ALL {
        let mut other = stored().clone();
        wrong.put_into(&mut other);
        assert!(other != *stored(), "{wrong:?}");
    }
}

/// With nothing planted the edition of the checks is the corrected one, to the bit.
#[test]
fn the_edition_of_the_checks_is_the_corrected_one() {
    struct Steps(State<f64>);
    impl WithPaper<f64> for Steps {
        type Out = State<f64>;
        fn with(mut self, paper: &impl Paper<f64>) -> State<f64> {
            crossfibre::march::run(paper, &mut self.0, 70, |_| ());
            self.0
        }
    }
    for (name, scene) in scenes() {
        let start = State::at_impact(&scene, Wavefront::Flagged);
        let expected = result::with_paper(&scene, Steps(start.clone()));
        let found = Steps(start).with(&super::edition(scene.strain, scene.corrections));
        let record = steps::StateRecord::of;
        assert!(record(&expected) == record(&found), "{name}");
    }
}

/// What only the seams may call, and where a check must not.
#[test]
fn no_check_marches_or_solves_past_the_seams() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let past = [
        "State::at_impact",
        "State::<f64>::at_impact",
        "State::<S>::at_impact",
        "State::<W>::at_impact",
        "use crossfibre::march;",
        "crossfibre::result::run",
        "result::with_paper",
        "WithPaper, with_paper}",
        "use crate::wide;",
        "wide::run",
        "wide::march",
        "PulledRod::new",
        "Polynomial::new",
        "Exponential::new",
        "exact::smith::smith;",
        "exact::crossover::crossover;",
        "crossover, crossover",
        "Coefficients, crossover}",
        "Crossover, crossover}",
        "Smith, smith}",
        "Smith, struck}",
        "exact::dispersion",
        "exact::motion::motion;",
        "Motion, motion}",
        "Wave::between",
        ".dissipation()",
    ];
    let places = [
        "cases",
        "extremes",
        "stability",
        "golden",
        "figures",
        "precision",
        "summary",
        "closed_form.rs",
        "exact_file.rs",
        "fronts.rs",
        "claims.rs",
        "ledger_effects.rs",
        "conform/expected.rs",
        "conform/questions.rs",
    ];
    let mut files = Vec::new();
    places.iter().for_each(|place| sources(&source.join(place), &mut files));
    assert!(files.len() > 60);
    for file in files {
        let text = fs::read_to_string(&file).unwrap();
        // Tests of a module are no checks of `verify`.
        let text = text.split("#[cfg(test)]").next().unwrap();
        // What is held against the reference in the one is a candidate of its own, without a fault; the
        // other measures times, and no check reads them.
        let is_no_reference = ["cases/conformance.rs", "precision/measure.rs"]
            .iter()
            .any(|other| file.ends_with(other));
        for past in past.iter().filter(|_| !is_no_reference) {
            assert!(!text.contains(past), "{}: {past}", file.display());
        }
    }
}

fn sources(place: &Path, files: &mut Vec<PathBuf>) {
    if place.is_file() {
        files.push(place.to_owned());
        return;
    }
    for entry in fs::read_dir(place).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}
