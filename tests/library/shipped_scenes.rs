//! The scenes in `verification/scenes`: all are read, and each is what its title says.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crossfibre::errata::Corrections;
use crossfibre::scene::{Primary, Scene};
use crossfibre::scene_file::read_bytes;

fn shipped() -> BTreeMap<String, Scene> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("verification/scenes");
    fs::read_dir(folder)
        .unwrap()
        .map(|entry| {
            let path = entry.unwrap().path();
            let name = path.file_stem().unwrap().to_string_lossy().into_owned();
            let scene = read_bytes(&fs::read(&path).unwrap());
            (name.clone(), scene.unwrap_or_else(|fault| panic!("{name}: {fault}")))
        })
        .collect()
}

/// c = √(E/ρ), m/s.
fn wave_speed(primary: &Primary) -> f64 {
    (primary.material.instantaneous_modulus() / primary.density).sqrt()
}

#[test]
fn every_shipped_scene_is_read_and_has_a_title_of_its_own() {
    let scenes = shipped();
    let names: Vec<&str> = scenes.keys().map(String::as_str).collect();
    let expected = [
        "artificial-viscosity",
        "both-at-origin",
        "eyring",
        "fig3",
        "fig3-printed",
        "finite-projectile",
        "hardening",
        "single-400",
        "single-400-1440",
        "slack",
        "sliding",
        "softening",
        "timing",
        "unequal",
        "viscoelastic",
    ];
    assert_eq!(names, expected);
    let titles: BTreeSet<&str> = scenes.values().map(|s| s.title.as_str()).collect();
    assert_eq!(titles.len(), expected.len());
    assert!(!titles.contains(""));
}

#[test]
fn the_scenes_of_the_page_travel_as_far_as_the_page_says() {
    // 0.2 m in 28.7 µs; half an element, 1 mm, is as near as whole steps can come.
    for name in ["fig3", "fig3-printed", "single-400", "timing"] {
        let scene = &shipped()[name];
        let travel = wave_speed(&scene.primary) * scene.duration;
        assert!((travel - 0.2).abs() < 1e-3, "{name}: {travel} m");
        let spacing = scene.primary.length / scene.primary.elements as f64;
        // 2.0 mm to the last bits of the division.
        assert!((spacing - 0.002).abs() < 1e-17, "{name}: {spacing} m");
    }
}

#[test]
fn scenes_that_are_compared_differ_in_what_is_compared_alone() {
    let scenes = shipped();
    let same_but_title = |name: &str, expected: Scene| {
        assert_eq!(Scene { title: String::new(), ..scenes[name].clone() }, expected, "{name}");
    };
    let untitled = |name: &str| Scene { title: String::new(), ..scenes[name].clone() };

    same_but_title("fig3-printed", Scene { corrections: Corrections::NONE, ..untitled("fig3") });
    same_but_title("single-400", Scene { secondary: None, ..untitled("fig3") });
    same_but_title("single-400", Scene { secondary: None, ..untitled("both-at-origin") });
    let mut aramid = untitled("single-400");
    aramid.primary.density = 1440.0;
    same_but_title("single-400-1440", aramid);

    let (p, s) = (&scenes["both-at-origin"].primary, &scenes["both-at-origin"].secondary);
    let s = s.as_ref().unwrap();
    assert_eq!((s.length, s.elements, s.density), (p.length, p.elements, p.density));
    assert_eq!((s.area, &s.material), (p.area, &p.material));
}

#[test]
fn the_projectile_is_about_as_heavy_as_the_fibre_it_strikes() {
    let scene = &shipped()["finite-projectile"];
    let Primary { length, density, area, .. } = scene.primary;
    let ratio = scene.projectile.mass.unwrap() / (2.0 * density * area * length);
    // "About" is within a tenth: 0.7 g against 0.724 g of both halves.
    assert!((ratio - 1.0).abs() < 0.1, "{ratio}");
}
