//! Bad scenes: each is refused with a path, a place in the text and a message that helps; and no
//! text whatever makes the reader panic.

use crossfibre::errata::{Corrections, Erratum};
use crossfibre::material::{Arm, Coefficients, Update};
use crossfibre::scene::{FORMAT, Law, Material, Primary, Projectile, Scene, Secondary, Strain};
use crossfibre::scene_file::{read, read_bytes};
use proptest::prelude::*;

const GOOD: &str = r#"{
  "format": "crossfibre-scene/1",
  "title": "µ",
  "primary": { "length": 0.287, "elements": 139,
    "density": 1443.0, "area": 0.87e-6,
    "material": { "law": "linear", "modulus": 71.3e9 } },
  "secondary": { "at": 0.0773, "length": 0.164, "elements": 97,
    "density": 973.0, "area": 1.31e-6,
    "material": {
      "law": "linear",
      "modulus": 43.1e9
    },
    "slide_factor": 0.73 },
  "projectile": { "velocity": 317.0, "mass": 0.00091 },
  "courant": 0.937,
  "duration": 31.3e-6,
  "corrections": ["time-level", "crossover-inertia"]
}
"#;

/// What is replaced in the good scene, by what; then path, line and column, part of the message.
type Case = (&'static str, &'static str, &'static str, (usize, usize), &'static str);

#[rustfmt::skip] // a case a line
const NOT_JSON: &[Case] = &[
    (GOOD, "", "", (1, 1), "the text is empty"),
    (GOOD, " \n\t\n", "", (1, 1), "the text is empty"),
    (GOOD, "{\n  \"courant\": 0.9", "", (2, 16), "ends too early"),
    (GOOD, "primary.length = 0.287", "", (1, 1), "begins with `{`"),
    ("{\n  \"format\"", "\u{FEFF}{\n  \"format\"", "", (1, 1), "byte order mark"),
    ("inertia\"]\n}", "inertia\"]\n} }", "", (18, 3), "trailing characters"),
    ("0.937,", "0.937", "", (16, 3), "expected `,` or `}`"),
    ("0.73 }", "0.73, }", "secondary", (13, 27), "trailing comma"),
    ("0.287", "1e999", "primary.length", (4, 26), "1e999 is too large for a double"),
    ("43.1e9", "1e999", "secondary.material.modulus", (11, 18), "1e999 is too large"),
    ("0.287", "NaN", "primary.length", (4, 26), "NaN is not a number"),
    ("0.937", "-Infinity", "courant", (15, 14), "-Infinity is not a number"),
    ("0.937", "nan", "courant", (15, 14), "nan is not a number"),
    ("0.937", "+Infinity", "courant", (15, 14), "+Infinity is not a number"),
    ("0.937", "?", "courant", (15, 14), "expected a value"),
    (GOOD, "{\"$serde_json::private::RawValue\": \"\\n\\n1 2\"}", "", (1, 1), "trailing characters"),
];

const LINEAR: &str = "{ \"law\": \"linear\", \"modulus\": 71.3e9 }";
const POLYNOMIAL_NULL: &str = r#"{ "law": "polynomial", "coefficients": [71, null] }"#;
const FALLING: &str = r#"{ "law": "polynomial", "coefficients": [-71] }"#;
const NO_COEFFICIENTS: &str = r#"{ "law": "polynomial", "coefficients": [] }"#;
const TWO_SIGNS: &str = r#"{ "law": "exponential", "a": 7e9, "b": -3.1 }"#;
const ARM_WITHOUT_TIME: &str = r#"{ "law": "viscoelastic", "equilibrium_modulus": 0, "arms":
    [{ "modulus": 3, "relaxation_time": 2e-6 }, { "modulus": 3 }] }"#;
const ARM_IN_ORDER: &str =
    r#"{ "law": "viscoelastic", "equilibrium_modulus": 0, "arms": [[3, 2e-6]] }"#;
const TIMELESS: &str = r#"{ "law": "viscoelastic", "equilibrium_modulus": 0, "arms":
    [{ "modulus": 3, "relaxation_time": 0 }] }"#;
const EYRING_HURRIED: &str = r#"{ "law": "eyring", "equilibrium_modulus": 0, "modulus": 3,
    "rate": 2e3, "stress": 1e7, "update": "fast" }"#;
const NO_RATE: &str =
    r#"{ "law": "eyring", "equilibrium_modulus": 0, "modulus": 3, "stress": 1e7 }"#;
const VISCOUS: &str =
    r#"{ "law": "linear", "modulus": 7e9, "artificial_viscosity": { "cubic": 0.1 } }"#;
const RUNNY: &str =
    r#"{ "law": "linear", "modulus": 7e9, "artificial_viscosity": { "linear": -0.1 } }"#;

#[rustfmt::skip] // a case a line
const NOT_A_SCENE: &[Case] = &[
    (GOOD, "17", "", (1, 1), "expected an object"),
    (GOOD, " [0.287]", "", (1, 2), "an array, expected an object"),
    (GOOD, "{}", "", (1, 1), "missing field `format`"),
    ("scene/1", "scene/2", "format", (2, 13), "must be \"crossfibre-scene/1\""),
    ("\"title\"", "\"titel\"", "titel", (3, 3), "unknown field `titel`, did you mean `title`?"),
    ("\"title\"", "\"why.so?\"", "why.so?", (3, 3), "unknown field `why.so?`"),
    ("\"modulus\": 71", "\"material\": 71", "primary.material.material", (6, 36), "unknown"),
    ("\"density\": 1443", "\"ρ\": 1443", "primary.ρ", (5, 5), "unknown field `ρ`"),
    ("\"modulus\": 71", "\"modlus\": 71", "primary.material.modlus", (6, 36), "mean `modulus`?"),
    ("\"mass\"", "\"material\"", "projectile.material", (14, 38), "unknown field `material`"),
    ("\"at\": 0.0773, ", "", "secondary", (7, 16), "missing field `at`"),
    ("  \"courant\": 0.937,\n", "", "", (1, 1), "missing field `courant`"),
    (",\n      \"modulus\": 43.1e9", "", "secondary.material", (9, 17), "missing field `modulus`"),
    ("\"law\": \"linear\",\n", "\n", "secondary.material", (9, 17), "missing field `law`"),
    ("\"mass\"", "\"velocity\"", "projectile.velocity", (14, 38), "duplicate field `velocity`"),
    ("\"courant\"", "\"title\"", "title", (15, 3), "duplicate field `title`"),
    ("\"law\": \"linear\", ", "\"tension_only\": true, ", "primary.material", (6, 17), "field `law`"),
    ("43.1e9", "2, \"rate\": 3", "secondary.material.rate", (11, 21), "unknown field `rate`"),
    ("43.1e9", "2, \"modlus\": 3", "secondary.material.modlus", (11, 21), "mean `modulus`?"),
    ("43.1e9", "2, \"tension_only\": 1", "secondary.material.tension_only", (11, 37), "boolean"),
    (LINEAR, POLYNOMIAL_NULL, "primary.material.coefficients[1]", (6, 61), "null, expected a num"),
    (LINEAR, ARM_WITHOUT_TIME, "primary.material.arms[1]", (7, 49), "missing field `relaxation_ti"),
    (LINEAR, ARM_IN_ORDER, "primary.material.arms[0]", (6, 77), "an array, expected an object"),
    (LINEAR, EYRING_HURRIED, "primary.material.update", (7, 43), "unknown name `fast`"),
    (LINEAR, NO_RATE, "primary.material", (6, 17), "missing field `rate`"),
    (LINEAR, VISCOUS, "primary.material.artificial_viscosity.cubic", (6, 78), "field `cubic`"),
    ("43.1e9", "2, \"modulus\": 3", "secondary.material.modulus", (11, 21), "duplicate field"),
    ("\"linear\",\n", "\"liner\",\n", "secondary.material.law", (10, 14), "mean `linear`?"),
    ("0.287", "\"0.287\"", "primary.length", (4, 26), "string \"0.287\", expected a"),
    ("43.1e9", "\"43\"", "secondary.material.modulus", (11, 18), "string \"43\", expected a"),
    ("97", "97.0", "secondary.elements", (7, 61), "expected a whole number"),
    ("97", "-97", "secondary.elements", (7, 61), "expected a whole number"),
    ("0.00091", "null", "projectile.mass", (14, 46), "null, expected a number"),
    ("{ \"velocity\": 317.0, \"mass\": 0.00091 }", "317", "projectile", (14, 17), "an object"),
    ("{ \"velocity\": 317.0, \"mass\": 0.00091 }", "[3, 4]", "projectile", (14, 17), "an arr"),
    ("{ \"law\": \"linear\", \"modulus\": 71.3e9 }", "9", "primary.material", (6, 17), "an object"),
    ("\"crossover-inertia\"", "\"theta\"", "corrections[1]", (17, 33), "correction `theta`"),
    ("time-level", "time-levle", "corrections[0]", (17, 19), "did you mean `time-level`?"),
    ("[\"time-level\", \"crossover-inertia\"]", "\"al\"", "corrections", (17, 18), "mean `all`?"),
    ("[\"time-level\", \"crossover-inertia\"]", "true", "corrections", (17, 18), "\"all\", \"none\""),
    ("\"corrections\"", "\"strain\": \"true\", \"corrections\"", "strain", (17, 13), "`true`"),
];

#[rustfmt::skip] // a case a line
const NOT_TO_BE_RUN: &[Case] = &[
    ("0.287", "0", "primary.length", (4, 26), "greater than 0, is 0.0"),
    ("139", "1", "primary.elements", (4, 45), "at least 2, is 1"),
    ("97", "100000001", "secondary.elements", (7, 61), "would take 20.8 GB of memory, more than 8 GB"),
    ("973.0", "-973.0", "secondary.density", (8, 16), "greater than 0, is -973.0"),
    ("0.87e-6", "-0.0", "primary.area", (5, 32), "greater than 0, is -0.0"),
    ("43.1e9", "-43.1e9", "secondary.material.modulus", (11, 18), "is -43100000000.0"),
    (LINEAR, FALLING, "primary.material.coefficients[0]", (6, 57), "greater than 0, is -71.0"),
    (LINEAR, NO_COEFFICIENTS, "primary.material.coefficients", (6, 56), "at least one entry"),
    (LINEAR, TWO_SIGNS, "primary.material.b", (6, 56), "a times b must be greater than 0"),
    (LINEAR, TIMELESS, "primary.material.arms[0].relaxation_time", (7, 41), "greater than 0, is 0"),
    (LINEAR, RUNNY, "primary.material.artificial_viscosity.linear", (6, 88), "negative, is -0.1"),
    ("0.73", "1.3", "secondary.slide_factor", (13, 21), "must lie in 0..1, is 1.3"),
    ("0.73", "-0.1", "secondary.slide_factor", (13, 21), "must lie in 0..1, is -0.1"),
    ("0.0773", "-0.0773", "secondary.at", (7, 24), "must not be negative"),
    ("0.0773", "0.287", "secondary.at", (7, 24), "at or beyond the clamp"),
    ("0.0773", "0.2865", "secondary.at", (7, 24), "the clamp's, which cannot move"),
    ("0.0773", "0.0010", "secondary.at", (7, 24), "nearest to 0.001 m is the impact point"),
    ("0.0773", "0", "secondary.at", (7, 24), "eqn (11) undefined"),
    ("317.0", "0", "projectile.velocity", (14, 31), "greater than 0"),
    ("317.0", "-317", "projectile.velocity", (14, 31), "greater than 0"),
    ("0.00091", "0.0", "projectile.mass", (14, 46), "greater than 0"),
    ("0.937", "0", "courant", (15, 14), "greater than 0"),
    ("31.3e-6", "-1e-6", "duration", (16, 15), "greater than 0"),
    // Δt = 0.937 × 0.164 m/97/√(43.1e9/973 m²/s²) = 2.3803e-7 s: half of it is 1.1901e-7 s.
    ("31.3e-6", "1.18e-7", "duration", (16, 15), "less than half a time step"),
    ("31.3e-6", "1e10", "duration", (16, 15), "more than 2^53"),
    ("0.287", "1e-160", "primary", (4, 14), "Δx², which (5) and (6) take the root of, is 0.0"),
    ("973.0", "1e-310", "secondary.density", (8, 16), "a double keeps few digits of it"),
    ("973.0", "1e-300", "secondary", (7, 16), "the wave speed c = √(modulus/density) is inf"),
    ("1.31e-6", "1e-203", "secondary", (7, 16), "the node mass"),
    ("1443.0, \"area\": 0.87e-6", "1e197, \"area\": 1", "primary", (4, 14), "A = Δt/Δm is 1."),
    ("973.0, \"area\": 1.31e-6", "1e197, \"area\": 1", "secondary", (7, 16), "A = Δt/Δm is 1."),
    ("0.937", "1e-305", "courant", (15, 14), "the time step Δt = courant × Δx/c is"),
    ("317.0", "1e-155", "projectile.velocity", (14, 31), "the square of the velocity is"),
    ("317.0", "1e-98", "projectile.velocity", (14, 31), "node mass × velocity² is"),
    ("0.00091", "1e306", "projectile.mass", (14, 46), "mass × velocity² is inf"),
    ("0.00091", "1e197", "projectile.mass", (14, 46), "mass × velocity² is 1.00"),
    ("0.87e-6", "1e195", "primary", (4, 14), "the stiffness modulus × area is 7."),
    ("0.87e-6", "1e188", "primary", (4, 14), "modulus × area/Δx, by which (7) makes tension"),
];

#[test]
fn the_good_scene_is_good() {
    let scene = read(GOOD).unwrap();
    assert_eq!(scene.secondary.unwrap().elements, 97);
    let chosen: Corrections = [Erratum::TimeLevel, Erratum::CrossoverInertia].into_iter().collect();
    assert_eq!(scene.corrections, chosen);
    // The fewest elements there may be.
    assert!(read(&GOOD.replace("139", "2")).is_ok());
    // Just over half a time step is one step: see the case of 1.18e-7 s above.
    assert!(read(&GOOD.replace("31.3e-6", "1.20e-7")).is_ok());
}

#[test]
fn every_bad_scene_is_refused_at_its_place() {
    for &(from, to, path, place, fragment) in
        NOT_JSON.iter().chain(NOT_A_SCENE).chain(NOT_TO_BE_RUN)
    {
        assert!(GOOD.contains(from), "{from:?} is not in the good scene");
        let text = GOOD.replacen(from, to, 1);
        let fault = read(&text).expect_err(to);
        assert_eq!((fault.line, fault.column), place, "{to:?} gives: {fault}");
        assert_eq!(fault.path, path, "{to:?} gives: {fault}");
        assert!(fault.message.contains(fragment), "{to:?} gives: {fault}");
    }
}

#[test]
fn a_fault_reads_as_one_line_and_its_help() {
    let fault = read(&GOOD.replace("0.73", "1.3")).unwrap_err();
    assert_eq!(
        fault.to_string(),
        "line 13, column 21: secondary.slide_factor: must lie in 0..1, is 1.3\n  \
         help: 1 lets nothing slide, 0 lets the fibre slide freely"
    );
}

#[test]
fn of_two_parameters_only_those_whose_product_counts_are_told_so() {
    let message = |material| read(&GOOD.replace(LINEAR, material)).unwrap_err().message;
    assert_eq!(message(FALLING), "must be greater than 0, is -71.0");
    assert!(message(TWO_SIGNS).starts_with("a times b must be greater than 0, is -21"));
}

#[test]
fn a_velocity_that_is_none_and_one_backwards_are_answered_unlike() {
    for (velocity, help) in [("0", "nothing would ever move"), ("-317", "travels along +y")] {
        let fault = read(&GOOD.replace("317.0", velocity)).unwrap_err();
        assert!(fault.help.as_ref().unwrap().contains(help), "{fault}");
    }
}

#[test]
fn a_scene_of_another_format_is_told_so_before_its_fields_are_judged() {
    let text = GOOD.replace("scene/1", "scene/2").replace("title", "name");
    assert_eq!(read(&text).unwrap_err().path, "format");
}

#[test]
fn a_name_that_resembles_none_is_not_guessed_at() {
    let fault = read(&GOOD.replace("time-level", "theta")).unwrap_err();
    assert_eq!(fault.message, "unknown correction `theta`");
    assert!(fault.help.unwrap().contains("theta-at-origin"));
}

#[test]
fn a_crossover_near_the_impact_point_is_told_its_two_possible_values() {
    // Δx = 0.287/139 = 0.002 064 7…; 0.001 lies below half of it.
    let fault = read(&GOOD.replace("0.0773", "0.001")).unwrap_err();
    let help = fault.help.unwrap();
    assert!(help.starts_with("say 0 for that node, or 0.0020647482"), "{help}");
    let at_origin = GOOD.replace("0.0773", "0").replace("time-level", "theta-at-origin");
    assert!(read(&at_origin).is_ok());
}

#[test]
fn bytes_that_are_not_utf_8_are_refused_where_they_stand() {
    let mut bytes = GOOD.as_bytes().to_vec();
    // The µ of the title, bytes 48 and 49, is its second byte in Latin-1.
    bytes.remove(48);
    let fault = read_bytes(&bytes).unwrap_err();
    assert_eq!((fault.line, fault.column), (3, 13), "{fault}");
    assert_eq!(fault.message, "not UTF-8: the byte at offset 48 is 0xB5");

    let utf_16: Vec<u8> = "\u{FEFF}{}".encode_utf16().flat_map(|unit| unit.to_le_bytes()).collect();
    let fault = read_bytes(&utf_16).unwrap_err();
    assert_eq!((fault.line, fault.column), (1, 1));
    assert!(fault.help.unwrap().contains("UTF-16"));
    let utf_16: Vec<u8> = "\u{FEFF}{}".encode_utf16().flat_map(|unit| unit.to_be_bytes()).collect();
    assert!(read_bytes(&utf_16).unwrap_err().help.unwrap().contains("UTF-16"));
}

#[test]
fn numbers_that_no_text_can_hold_are_refused_all_the_same() {
    let good = read(GOOD).unwrap();
    let refused_at = |path: &str, change: fn(&mut Scene, f64)| {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut scene = good.clone();
            change(&mut scene, bad);
            assert_eq!(scene.check().unwrap_err().path, path, "{bad}");
        }
    };
    refused_at("primary.length", |s, x| s.primary.length = x);
    refused_at("primary.density", |s, x| s.primary.density = x);
    refused_at("primary.area", |s, x| s.primary.area = x);
    refused_at("primary.material.modulus", |s, x| {
        s.primary.material = Material::linear(x);
    });
    refused_at("secondary.at", |s, x| s.secondary.as_mut().unwrap().at = x);
    refused_at("secondary.slide_factor", |s, x| s.secondary.as_mut().unwrap().slide_factor = x);
    refused_at("projectile.velocity", |s, x| s.projectile.velocity = x);
    refused_at("projectile.mass", |s, x| s.projectile.mass = Some(x));
    refused_at("courant", |s, x| s.courant = x);
    refused_at("duration", |s, x| s.duration = x);
}

/// Any double that is positive and not extreme, with an awkward mantissa.
fn size() -> impl Strategy<Value = f64> {
    (1.0..10.0_f64, -9_i32..9).prop_map(|(mantissa, exponent)| mantissa * 10.0_f64.powi(exponent))
}

fn law() -> impl Strategy<Value = Law> {
    let update = || prop_oneof![Just(Update::Exact), Just(Update::Literal)];
    let arm =
        (size(), size()).prop_map(|(modulus, relaxation_time)| Arm { modulus, relaxation_time });
    let arms = proptest::collection::vec(arm, 1..4);
    prop_oneof![
        size().prop_map(|modulus| Law::Linear { modulus }),
        proptest::collection::vec(size(), 1..5)
            .prop_map(|coefficients| Law::Polynomial { coefficients }),
        (size(), size(), any::<bool>()).prop_map(|(a, b, hardens)| {
            let sign = if hardens { 1.0 } else { -1.0 };
            Law::Exponential { a: sign * a, b: sign * b }
        }),
        (size(), arms, update()).prop_map(|(equilibrium_modulus, arms, update)| {
            Law::Viscoelastic { equilibrium_modulus, arms, update }
        }),
        (size(), size(), size(), size(), update()).prop_map(
            |(equilibrium_modulus, modulus, rate, stress, update)| Law::Eyring {
                equilibrium_modulus,
                modulus,
                rate,
                stress,
                update,
            }
        ),
    ]
}

fn material() -> impl Strategy<Value = Material> {
    let viscosity =
        (size(), size()).prop_map(|(linear, quadratic)| Coefficients { linear, quadratic });
    (law(), any::<bool>(), proptest::option::of(viscosity)).prop_map(
        |(law, tension_only, artificial_viscosity)| Material {
            law,
            tension_only,
            artificial_viscosity,
        },
    )
}

fn primary() -> impl Strategy<Value = Primary> {
    (size(), 2..1000_usize, size(), size(), material()).prop_map(
        |(length, elements, density, area, material)| Primary {
            length,
            elements,
            density,
            area,
            material,
        },
    )
}

/// A secondary fibre whose `at` is a fraction of the primary's length.
fn secondary() -> impl Strategy<Value = Secondary> {
    (primary(), 0.0..1.0_f64, 0.0..=1.0_f64).prop_map(|(like, at, slide_factor)| Secondary {
        at,
        length: like.length,
        elements: like.elements,
        density: like.density,
        area: like.area,
        material: like.material,
        slide_factor,
    })
}

prop_compose! {
    fn scene()(
        title in any::<String>(),
        primary in primary(),
        secondary in proptest::option::of(secondary()),
        velocity in size(),
        mass in proptest::option::of(size()),
        courant in size(),
        duration in size(),
        engineering in any::<bool>(),
        corrections in proptest::sample::subsequence(Erratum::ALL, 0..=Erratum::ALL.len()),
    ) -> Scene {
        let length = primary.length;
        Scene {
            format: FORMAT.into(),
            title,
            primary,
            secondary: secondary.map(|s| Secondary { at: s.at * length, ..s }),
            projectile: Projectile { velocity, mass },
            courant,
            duration,
            strain: if engineering { Strain::Engineering } else { Strain::Incremental },
            corrections: corrections.into_iter().collect(),
        }
    }
}

/// What only a program can get wrong: a file has neither NaN nor numbers beyond a double.
#[test]
fn a_problem_of_a_scene_that_was_never_text_is_told_as_well() {
    let good = || read(GOOD).unwrap();
    let told = |change: fn(&mut Scene)| {
        let mut scene = good();
        change(&mut scene);
        scene.check().unwrap_err().to_string()
    };
    assert_eq!(
        told(|scene| scene.primary.material.law =
            Law::Polynomial { coefficients: vec![3e9, f64::NAN] }),
        "primary.material.coefficients[1]: must be a finite number, is NaN"
    );
    assert_eq!(
        told(|scene| scene.primary.elements = 50_000_000),
        "primary.elements: a run would take 8.4 GB of memory, more than 8 GB\n  help: coarsen the mesh, \
         or shorten the fibre with it"
    );
    // Each fibre would do for itself.
    let both = |scene: &mut Scene| {
        scene.primary.elements = 20_000_000;
        scene.secondary.as_mut().unwrap().elements = 27_000_000;
    };
    assert!(
        told(both).starts_with("secondary.elements: a run would take 9.0 GB"),
        "{}",
        told(both)
    );
}

#[test]
fn what_is_left_out_of_a_scene_has_the_value_that_the_page_says() {
    let corrections = ",\n  \"corrections\": [\"time-level\", \"crossover-inertia\"]";
    assert!(GOOD.contains(corrections));
    let scene = read(&GOOD.replace(corrections, "").replace("  \"title\": \"µ\",\n", "")).unwrap();
    assert_eq!(scene.corrections, Corrections::ALL);
    assert_eq!((scene.title.as_str(), scene.strain), ("", Strain::Incremental));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_scene_that_passes_is_read_back_as_it_was_written(scene in scene()) {
        prop_assume!(scene.check().is_ok());
        let text = serde_json::to_string_pretty(&scene).unwrap();
        prop_assert_eq!(read(&text), Ok(scene));
    }

    #[test]
    fn no_change_of_bytes_makes_the_reader_panic(
        flips in proptest::collection::vec((0..GOOD.len(), any::<u8>()), 1..4),
    ) {
        let mut bytes = GOOD.as_bytes().to_vec();
        for (at, byte) in flips {
            bytes[at] = byte;
        }
        if let Err(fault) = read_bytes(&bytes) {
            let lines = bytes.split(|&b| b == b'\n').count();
            prop_assert!((1..=lines).contains(&fault.line), "{fault}");
            prop_assert!(fault.column >= 1 && !fault.message.is_empty(), "{fault}");
            let text = String::from_utf8_lossy(&bytes);
            prop_assert!(text.get(fault.span.clone()).is_some(), "{:?}: {fault}", fault.span);
        }
    }

    #[test]
    fn no_truncated_scene_is_read(end in 0..GOOD.trim_end().len()) {
        let bytes = &GOOD.as_bytes()[..end];
        let fault = read_bytes(bytes).unwrap_err();
        let lines = bytes.iter().filter(|&&b| b == b'\n').count() + 1;
        prop_assert!(fault.line <= lines, "{fault}");
    }

    #[test]
    fn words_of_json_in_any_order_make_no_panic(
        words in proptest::collection::vec(proptest::sample::select(&[
            "{", "}", "[", "]", ":", ",", "\"", "`", "\\u00", "null", "1e999", "NaN", "\n", "µ",
            "\"primary\"", "\"material\"", "\"law\"", "\"linear\"", "\"a.b[0]\"", "\"corrections\"",
        ][..]), 0..30),
    ) {
        if let Err(fault) = read(&words.concat()) {
            prop_assert!(fault.line >= 1 && fault.column >= 1);
        }
    }
}
