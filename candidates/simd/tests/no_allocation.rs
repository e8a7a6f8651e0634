//! A run allocates nothing.

#![allow(clippy::unwrap_used)] // a test may

use crossfibre::scene_file;
use crossfibre_simd::{Engine, Vectors};

#[test]
fn two_hundred_steps_allocate_nothing() {
    for text in [
        include_str!("../../../verification/scenes/single-400.json"),
        include_str!("../../../verification/scenes/finite-projectile.json"),
        include_str!("../../../verification/scenes/both-at-origin.json"),
        include_str!("../../../verification/scenes/sliding.json"),
        include_str!("../../../verification/scenes/unequal.json"),
    ] {
        let scene = scene_file::read(text).unwrap();
        for vectors in Vectors::ALL {
            let Ok(mut engine) = Engine::new_in(&scene, vectors) else { continue };
            let mut state = None;
            // The counter does count: a state is four vectors a fibre.
            assert!(allocation_counter::measure(|| state = Some(engine.state())).count_total >= 4);
            let run = || assert!(engine.run(200).is_completed());
            assert_eq!(allocation_counter::measure(run).count_total, 0, "{}", scene.title);
            assert_eq!(engine.step(), 200);
        }
    }
}
