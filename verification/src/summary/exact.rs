//! Where, at one time after impact, the closed forms predict uniform strain, and how much.
//!
//! Positions are Lagrangian, from the impact point on the primary and from the crossover on the
//! secondary. Where a closed form does not hold, or no longer, a note says why.

use crossfibre::exact::smith::Smith;
use crossfibre::place::Fibre;
use crossfibre::scene::{Scene, Secondary};

use crate::closed_form::{self, component, law};
use crate::oracle::crossover;

/// A stretch of fibre that the exact solution strains uniformly.
#[derive(Debug, PartialEq)]
pub struct Plateau {
    /// What people call it.
    pub what: &'static str,
    /// The fibre.
    pub fibre: Fibre,
    /// The nearer end, m.
    pub from: f64,
    /// The farther end, m.
    pub to: f64,
    /// Strain in the scene's measure.
    pub strain: f64,
}

/// What the closed forms say.
#[derive(Debug, Default)]
pub struct Exact {
    /// Lagrangian speed of the first disturbance on the primary, m/s: c, or that of a shock.
    pub front_speed: Option<f64>,
    /// The kink of the primary, m; none where the closed form does not hold.
    pub kink: Option<f64>,
    /// Whether the kink has met the wave that the crossover reflects, and is faster since.
    pub kink_met: bool,
    /// Where strain is uniform.
    pub plateaus: Vec<Plateau>,
    /// Why a plateau that one would look for is not there.
    pub notes: Vec<String>,
}

impl Exact {
    /// The closed forms of a scene, `time` seconds after impact.
    pub fn of(scene: &Scene, time: f64) -> Self {
        let mut exact = Self::default();
        if let Err(why) = exact.fill(scene, time) {
            exact.notes.push(why);
            if closed_form::beyond(scene).is_none() {
                exact.notes.push("`crossfibre exact` follows every front, to any time".into());
            }
        }
        exact
    }

    /// Adds what holds; an error says why no more does.
    fn fill(&mut self, scene: &Scene, time: f64) -> Result<(), String> {
        if scene.projectile.mass.is_some() {
            return Err("no exact strain: the projectile has a mass and slows down, \
                        Smith's solution is for a constant velocity"
                .into());
        }
        let struck = |material, density| {
            closed_form::struck(scene, material, density)
                .map_err(|why| format!("no exact strain: {why}"))
        };
        let impact = struck(&scene.primary.material, scene.primary.density)?;
        self.front_speed = Some(impact.front_speed);
        before_clamp("primary", impact.front_speed, time, 0.0, scene.primary.length)?;
        self.kink = Some(impact.kink_speed_lagrangian * time);
        match &scene.secondary {
            Some(secondary) if secondary.at == 0.0 => {
                let other = struck(&secondary.material, secondary.density)?;
                before_clamp("secondary", other.front_speed, time, 0.0, secondary.length)?;
                self.push(
                    scene,
                    Fibre::Primary,
                    "strain, kink to front",
                    waves(&impact, time),
                    &impact,
                );
                self.push(
                    scene,
                    Fibre::Secondary,
                    "strain, kink to front",
                    waves(&other, time),
                    &other,
                );
                Ok(())
            }
            Some(secondary) if secondary.at < impact.front_speed * time => {
                self.fill_crossing(scene, secondary, &impact, time)
            }
            _ => {
                self.push(
                    scene,
                    Fibre::Primary,
                    "strain, kink to front",
                    waves(&impact, time),
                    &impact,
                );
                Ok(())
            }
        }
    }

    /// After the front has reached a crossover away from the impact point: docs/exact/crossover.md,
    /// "Range".
    fn fill_crossing(
        &mut self,
        scene: &Scene,
        secondary: &Secondary,
        impact: &Smith,
        time: f64,
    ) -> Result<(), String> {
        let (c, u, at) = (impact.front_speed, impact.kink_speed_lagrangian, secondary.at);
        // The reflected wave meets the kink, which sheds a wavelet towards the crossover.
        let meeting = 2.0 * at / (c + u);
        let shed_at = u * meeting;
        let back = meeting + (at - shed_at) / c;
        let inner_end = if time < meeting {
            let reflected = 2.0 * at - c * time;
            self.push(
                scene,
                Fibre::Primary,
                "strain, kink to reflected",
                (u * time, reflected),
                impact,
            );
            reflected
        } else {
            self.kink_met = true;
            self.notes.push(format!(
                "Smith's strain between kink and front has lasted until {} µs, when the wave \
                 reflected by the crossover met the kink",
                micro(meeting)
            ));
            shed_at + c * (time - meeting)
        };
        if time >= back {
            return Err(format!(
                "the exact solution of the crossover has lasted until {} µs, when a wave shed by \
                 the kink came back to it",
                micro(back)
            ));
        }
        if let Some(why) = closed_form::beyond(scene) {
            return Err(format!("no exact solution of the crossover: {why}"));
        }
        let fibres = (closed_form::primary(&scene.primary), closed_form::secondary(secondary));
        let around = crossover(
            law(scene),
            &fibres.0,
            &fibres.1,
            secondary.slide_factor,
            scene.projectile.velocity,
        )
        .map_err(|e| format!("no exact solution of the crossover: {e}"))?;
        let since = time - at / c;
        let arm = &around.diverted;
        before_clamp("secondary", arm.front_speed, since, at / c, secondary.length)?;
        let mut push = |fibre, what, (from, to), strain| {
            self.plateaus.push(Plateau { what, fibre, from, to, strain: component(scene, strain) });
        };
        let (before, beyond) = ((inner_end, at), (at, impact.tail_speed * time));
        push(Fibre::Primary, "strain before crossover", before, around.reflected);
        push(Fibre::Primary, "strain beyond crossover", beyond, around.transmitted);
        push(Fibre::Secondary, "strain, kink to front", waves(arm, since), arm.strain);
        Ok(())
    }

    fn push(
        &mut self,
        scene: &Scene,
        fibre: Fibre,
        what: &'static str,
        ends: (f64, f64),
        of: &Smith,
    ) {
        let (from, to) = ends;
        let strain = component(scene, of.strain);
        self.plateaus.push(Plateau { what, fibre, from, to, strain });
    }
}

/// Kink and end of the longitudinal wave, a time after the impact, m.
fn waves(impact: &Smith, time: f64) -> (f64, f64) {
    (impact.kink_speed_lagrangian * time, impact.tail_speed * time)
}

/// An error once a front that started at `start` seconds has reached the clamp.
fn before_clamp(name: &str, c: f64, since: f64, start: f64, length: f64) -> Result<(), String> {
    if c * since < length {
        return Ok(());
    }
    Err(format!(
        "no exact strain: the front reached the {name} fibre's clamp at {} µs and came back",
        micro(start + length / c)
    ))
}

fn micro(seconds: f64) -> String {
    format!("{:.2}", seconds * 1e6)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crossfibre::scene_file;

    fn fig3() -> Scene {
        scene_file::read(include_str!("../../scenes/fig3.json")).unwrap()
    }

    fn names(exact: &Exact) -> Vec<&str> {
        exact.plateaus.iter().map(|plateau| plateau.what).collect()
    }

    /// Edges by hand with c = 6968.6 m/s and U = 0.11926 c (Smith at 400 m/s, √(ln λ/λ) with
    /// ln λ = 1.4430 %): to the 5 digits of those numbers, so 0.02 mm.
    #[test]
    fn plateaus_lie_between_the_waves_of_their_time() {
        let near = |plateau: &Plateau, from: f64, to: f64| {
            let (a, b) = (plateau.from * 1e3 - from, plateau.to * 1e3 - to);
            assert!(a.abs() < 0.02 && b.abs() < 0.02, "{plateau:?}");
        };
        let early = Exact::of(&fig3(), 11.3e-6);
        assert_eq!(names(&early), ["strain, kink to front"]);
        // U t = 9.391 mm; the tail is c t/√λ = 78.745 mm/1.00724.
        near(&early.plateaus[0], 9.391, 78.179);

        // c t = 153.309 mm: reflected wave at 200 - c t; X_c to c t/√λ; 53.309 mm on the secondary,
        // whose strain 0.2124 % (docs/exact/crossover.md: 0.147184 × 1.4430 %) makes U 0.046037 c.
        let middle = Exact::of(&fig3(), 22.0e-6);
        assert_eq!(names(&middle)[0], "strain, kink to reflected");
        near(&middle.plateaus[0], 18.284, 46.691);
        near(&middle.plateaus[1], 46.691, 100.0);
        near(&middle.plateaus[2], 100.0, 152.207);
        near(&middle.plateaus[3], 2.454, 53.252);

        // The wave met the kink at 200 mm/1.11926 c = 25.641 µs and 21.310 mm; 3.058 µs later the
        // wavelet is 21.313 mm farther.
        let late = Exact::of(&fig3(), 28.7e-6);
        assert_eq!(names(&late)[0], "strain before crossover");
        near(&late.plateaus[0], 42.623, 100.0);
        assert!(late.notes[0].contains("lasted until 25.64 µs"), "{:?}", late.notes);
    }

    #[test]
    fn a_note_says_why_there_is_no_plateau() {
        let note = |scene: &Scene, time| Exact::of(scene, time).notes.concat();
        assert!(note(&fig3(), 37.5e-6).contains("came back to it"));
        assert!(note(&fig3(), 43.1e-6).contains("primary fibre's clamp at 43.05 µs"));
        let mut heavy = fig3();
        heavy.projectile.mass = Some(0.0013);
        assert!(note(&heavy, 11.3e-6).contains("slows down"));
        assert!(note(&heavy, 11.3e-6).contains("crossfibre exact"));
        let mut short = fig3();
        if let Some(secondary) = &mut short.secondary {
            secondary.length = 0.063;
        }
        // 0.163 m at c = 6968.6 m/s.
        assert!(note(&short, 28.7e-6).contains("secondary fibre's clamp at 23.39 µs"));
        let mut fast = fig3();
        fast.projectile.velocity = 12_000.0;
        assert!(note(&fast, 11.3e-6).contains("kink overtakes"));
    }
}
