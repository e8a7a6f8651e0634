//! Scenes to compare on: those shipped, and drawn ones.

use crossfibre::scene::Scene;
use serde_json::json;

macro_rules! shipped {
    ($($name:literal)*) => {
        /// Names and texts.
        pub const SHIPPED: &[(&str, &str)] = &[$((
            $name,
            include_str!(concat!("../../../../verification/scenes/", $name, ".json")),
        )),*];
    };
}

shipped! {
    "artificial-viscosity" "both-at-origin" "eyring" "fig3-printed" "fig3" "finite-projectile"
    "hardening" "single-400-1440" "single-400" "slack" "sliding" "softening" "timing" "unequal"
    "viscoelastic"
}

/// SplitMix64: numbers that are the same everywhere.
pub struct Draw(pub u64);

impl Draw {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Between two numbers.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, n: u64) -> u64 {
        self.bits() % n
    }

    fn one_in(&mut self, n: u64) -> bool {
        self.below(n) == 0
    }
}

/// So many scenes that pass the reference's check: one fibre or two, crossing anywhere or struck
/// together, with every kind of projectile, in both measures of strain. Counts of elements are
/// ragged, so that last vectors are partly filled; some are long enough for several blocks of the
/// reference. One scene in six is of an extreme scale, one in six runs away.
pub fn drawn(count: usize) -> impl Iterator<Item = Scene> {
    let mut draw = Draw(0x5eed_0f5c_e9e5);
    (0..).map(move |i| scene(i, &mut draw)).filter(|scene| scene.check().is_ok()).take(count)
}

fn scene(i: usize, draw: &mut Draw) -> Scene {
    let extreme = draw.one_in(6);
    let scale = |draw: &mut Draw, most: f64| -> f64 {
        if extreme { 2.0_f64.powi(draw.between(-most, most) as i32) } else { 1.0 }
    };
    let (length_scale, force_scale) = (scale(draw, 400.0), scale(draw, 340.0));
    let elements = |draw: &mut Draw| match draw.below(4) {
        0 => 2 + draw.below(17),
        1 | 2 => 17 + draw.below(90),
        _ => 380 + draw.below(60),
    };
    let n = elements(draw);
    let length = draw.between(0.05, 0.4) * length_scale;
    let fibre = |draw: &mut Draw, length: f64, n: u64| {
        json!({
            "length": length, "elements": n,
            "density": draw.between(700.0, 2900.0),
            "area": draw.between(0.3e-6, 3.0e-6) * force_scale,
            "material": {"law": "linear", "modulus": draw.between(20e9, 190e9)},
        })
    };
    let primary = fibre(draw, length, n);
    let wild = draw.one_in(6);
    let velocity = match draw.below(3) {
        0 if wild => 2.0_f64.powi(draw.between(13.0, 400.0) as i32),
        _ if wild => draw.between(30.0, 12e3),
        _ => draw.between(30.0, 700.0),
    };
    let mut scene = json!({
        "format": "crossfibre-scene/1",
        "title": format!("drawn {i}"),
        "primary": primary,
        "projectile": {"velocity": velocity},
        "courant": if draw.one_in(5) { 1.0 } else if wild { draw.between(0.3, 4.0) } else { draw.between(0.2, 0.99) },
        "duration": 1.0,
        "strain": if draw.one_in(3) { "engineering" } else { "incremental" },
    });
    if draw.one_in(2) {
        scene["projectile"]["mass"] = json!(draw.between(1e-4, 3e-3) * length_scale * force_scale);
    }
    if !draw.one_in(3) {
        let at = if draw.one_in(4) { 0.0 } else { draw.between(0.01, 0.9) * length };
        let (of, m) = (draw.between(0.05, 0.4) * length_scale, elements(draw));
        let mut secondary = fibre(draw, of, m);
        secondary["at"] = json!(at);
        secondary["slide_factor"] = json!(match draw.below(4) {
            0 => 0.0,
            1 => 1.0,
            _ => draw.between(0.0, 1.0),
        });
        scene["secondary"] = secondary;
    }
    let mut scene: Scene = serde_json::from_value(scene).unwrap();
    // Through the fibre and back, or until the crossover has slid for a while.
    let wave_speed =
        (scene.primary.material.instantaneous_modulus() / scene.primary.density).sqrt();
    let crossing = scene.primary.length / wave_speed;
    scene.duration = crossing * draw.between(0.3, 3.1) * if wild { 13.0 } else { 1.0 };
    scene
}
