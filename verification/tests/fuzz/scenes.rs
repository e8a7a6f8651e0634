//! Scenes: accepted ones are planned without their elements, run to a typed end where they are small,
//! and written and read back.

use crossfibre::outcome::Outcome;
use crossfibre::plan::Plan;
use crossfibre::result;
use crossfibre::scene::Scene;
use crossfibre::scene_file::read_bytes;
use crossfibre_verification::cases::support::SCENES;
use crossfibre_verification::closed_form;
use crossfibre_verification::exact_file::ExactFile;
use crossfibre_verification::summary::Summary;

/// Element-steps of a run that is tried.
const SMALL: f64 = 8000.0;

/// Elements of a run that is tried.
const FEW: usize = 600;

/// The shipped scenes, and each with few elements.
pub fn seeds() -> Vec<Vec<u8>> {
    let coarse = |text: &str| {
        let mut scene = read_bytes(text.as_bytes()).unwrap();
        scene.duration *= 0.7;
        scene.primary.elements = 17;
        if let Some(secondary) = &mut scene.secondary {
            secondary.elements = 13;
        }
        serde_json::to_string_pretty(&scene).unwrap().into_bytes()
    };
    let texts = || SCENES.iter().map(|(_, text)| *text);
    texts().map(|text| text.as_bytes().to_vec()).chain(texts().map(coarse)).collect()
}

/// The scene of an input; a refusal has its place in the text.
fn read(bytes: &[u8]) -> Result<Scene, String> {
    read_bytes(bytes).map_err(|fault| {
        // Of a text that is not UTF-8 the fault is in what comes before.
        let text = String::from_utf8_lossy(bytes);
        let line = text.split('\n').nth(fault.line - 1).unwrap_or_else(|| panic!("{fault}"));
        assert!((1..=line.chars().count() + 1).contains(&fault.column), "{fault}");
        assert!(!fault.message.trim().is_empty(), "{fault}");
        fault.to_string()
    })
}

pub fn scene(bytes: &[u8], _: &[u8]) -> Result<(), String> {
    let scene = read(bytes)?;
    assert_eq!(scene.check(), Ok(()));
    let text = serde_json::to_string(&scene).unwrap();
    assert_eq!(read(text.as_bytes()).as_ref(), Ok(&scene), "{text}");

    let plan = Plan::of(&scene);
    let planned = [plan.time_step, plan.time, plan.element_steps, plan.memory];
    assert!(planned.iter().all(|x| x.is_finite() && *x > 0.0), "{planned:?}");
    assert!(plan.steps > 0 && plan.equations.len() == 20);
    if plan.element_steps <= SMALL && plan.fibres.iter().all(|fibre| fibre.elements <= FEW) {
        run(&scene, &plan);
    }
    Ok(())
}

fn run(scene: &Scene, plan: &Plan) {
    let result = result::run(scene, |_| {});
    let fibres = || [Some(&result.primary), result.secondary.as_ref()].into_iter().flatten();
    let vectors = fibres().flat_map(|f| f.position.iter().chain(&f.velocity)).flatten();
    let numbers = fibres().flat_map(|f| f.strain.iter().chain(&f.tension));
    let others = [result.time, result.projectile.velocity, result.projectile.position];
    assert!(vectors.chain(numbers).chain(&others).all(|x| x.is_finite()), "{}", result.outcome);
    assert!(result.balance.is_none_or(|balance| balance.is_finite()));
    assert!(result.steps <= plan.steps);
    // A crossover that slides past the front takes it along.
    let slides = result.crossover.as_ref().is_some_and(|crossover| crossover.moves > 0);
    let elements = plan.fibres.iter().map(|fibre| fibre.elements as u64).sum::<u64>();
    let most = if slides { (elements * plan.steps) as f64 } else { plan.element_steps };
    assert!(result.counts.element_steps as f64 <= most, "{:?}", result.counts);
    if result.outcome == Outcome::Completed {
        assert_eq!(result.steps, plan.steps);
    }
    assert!(!result.outcome.to_string().is_empty());
    let json = serde_json::to_string(&result).unwrap();
    let only_null = if result.balance.is_some() { 0 } else { 1 };
    assert_eq!(json.matches("null").count(), only_null, "{json}");
    assert!(!Summary { scene, result: &result }.to_string().is_empty());
}

/// The motion without the scheme, of scenes that have one: it ends, with numbers.
pub fn exact(bytes: &[u8], _: &[u8]) -> Result<(), String> {
    let scene = read(bytes)?;
    if let Some(why) = closed_form::beyond(&scene) {
        return Err(why);
    }
    let (file, _) = ExactFile::of(&scene, scene.duration);
    let json = serde_json::to_string(&file).unwrap();
    let nulls = [
        file.ended.is_none(),
        file.solution.chords.is_none(),
        file.solution.velocity_steps.is_none(),
        file.coefficients.is_none(),
    ];
    let nulls = nulls.into_iter().filter(|none| *none).count();
    assert_eq!(json.matches("null").count(), nulls, "{json}");
    Ok(())
}
