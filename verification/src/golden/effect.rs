//! The physical effect of a change: what the shipped scenes gave before and what they give now.

use std::fmt::{self, Display, Formatter};

use crossfibre::result::RunResult;
use crossfibre::scene::Scene;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::runs::RunVector;
use crate::cases::crossover::measured;
use crate::cases::support::{exact_single, marched, mean};

/// What a scene amounts to, in a few numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Effect {
    /// Mean strain of the primary over the middle half of the way between kink and front, or clamp;
    /// none if no element lies there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plateau_strain: Option<f64>,
    /// R at the crossover, by the window of the case `crossover.coefficients`; none if no element
    /// lies in it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reflection: Option<f64>,
    /// T at the crossover, likewise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub transmission: Option<f64>,
    /// D of each arm, likewise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub diversion: Option<f64>,
    /// Residual of the energy balance over the energy put in.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub energy_residual: Option<f64>,
    /// Velocity of the projectile at the end, m/s.
    pub projectile_velocity: f64,
}

impl Effect {
    /// Of a run of a scene.
    pub fn of(scene: &Scene, result: &RunResult) -> Self {
        let crosses = scene.secondary.as_ref().is_some_and(|secondary| secondary.at > 0.0);
        let around = crosses.then(|| measured(scene.clone(), marched).coefficients);
        // The mean of an empty window is not a number.
        let part = |x: Option<f64>| x.filter(|x| x.is_finite());
        Self {
            plateau_strain: part(Some(plateau(scene, result))),
            reflection: part(around.map(|c| c.reflection)),
            transmission: part(around.map(|c| c.transmission)),
            diversion: part(around.map(|c| c.diversion)),
            energy_residual: part(result.balance.map(|b| b.energy.relative_residual())),
            projectile_velocity: result.projectile.velocity,
        }
    }

    /// Each quantity by its name.
    fn quantities(&self) -> [(&'static str, Option<f64>); 6] {
        [
            ("plateau strain", self.plateau_strain),
            ("reflection R", self.reflection),
            ("transmission T", self.transmission),
            ("diversion D", self.diversion),
            ("energy residual", self.energy_residual),
            ("projectile, m/s", Some(self.projectile_velocity)),
        ]
    }
}

/// Mean strain over the middle half of the way from the kink to the front or the clamp.
fn plateau(scene: &Scene, result: &RunResult) -> f64 {
    let exact = exact_single(scene);
    let kink = exact.kink_speed_lagrangian * result.time;
    let front = (exact.front_speed * result.time).min(scene.primary.length);
    let quarter = (front - kink) / 4.0;
    let dx = scene.primary.length / scene.primary.elements as f64;
    mean(dx, &result.primary.strain, kink + quarter, front - quarter)
}

/// What the scenes gave before, and what they give now. Displays as a table.
pub struct Effects<'a> {
    /// The runs as stored; none where they cannot be read.
    pub before: &'a [RunVector],
    /// The runs as they are.
    pub after: &'a [RunVector],
}

impl Display for Effects<'_> {
    fn fmt(&self, to: &mut Formatter) -> fmt::Result {
        for after in self.after {
            let before = self.before.iter().find(|before| before.id == after.id);
            match before.map(|before| &before.effect) {
                None => writeln!(to, "{}: not among the stored runs", after.id)?,
                Some(before) if same(before, &after.effect) => {
                    writeln!(to, "{}: the same to the bit", after.id)?;
                    continue;
                }
                Some(_) => {
                    let [old, now, change, relative] = ["before", "now", "change", "relative"];
                    writeln!(to, "{:18}{old:>22}{now:>24}{change:>12}{relative:>12}", after.id)?;
                }
            }
            let old = before.map(|before| before.effect.quantities());
            for (i, (name, now)) in after.effect.quantities().into_iter().enumerate() {
                let before = old.and_then(|old| old[i].1);
                if before.is_some() || now.is_some() {
                    writeln!(to, "{}", row(name, before, now))?;
                }
            }
        }
        Ok(())
    }
}

fn same(a: &Effect, b: &Effect) -> bool {
    let bits = |effect: &Effect| effect.quantities().map(|(_, x)| x.map(f64::to_bits));
    bits(a) == bits(b)
}

fn row(name: &str, before: Option<f64>, now: Option<f64>) -> String {
    let shown = |x: Option<f64>| x.map_or("none".into(), |x| format!("{x:?}"));
    let mut row = format!("  {name:16}{:>22}{:>24}", shown(before), shown(now));
    if let (Some(before), Some(now)) = (before, now) {
        let change = now - before;
        let relative = if change == 0.0 { 0.0 } else { change / before.abs() };
        row += &format!("{change:>12.1e}{relative:>12.1e}");
    }
    row
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::golden::bless::stored_runs;
    use crate::golden::embedded;

    #[test]
    fn a_row_shows_before_after_and_both_kinds_of_change() {
        let fields = |row: String| row.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        // 0.013 → 0.0143: 0.0013 more, a tenth of 0.013.
        let changed = row("strain", Some(0.013), Some(0.0143));
        assert_eq!(fields(changed), ["strain", "0.013", "0.0143", "1.3e-3", "1.0e-1"]);
        // Relative to the size of what was before: a residual that falls is a negative change.
        let fallen = row("residual", Some(-0.02), Some(-0.03));
        assert_eq!(fields(fallen), ["residual", "-0.02", "-0.03", "-1.0e-2", "-5.0e-1"]);
        assert_eq!(fields(row("R", None, Some(0.043))), ["R", "none", "0.043"]);
        assert!(row("energy", Some(0.0), Some(0.0)).ends_with("0.0e0"));
    }

    #[test]
    fn what_changed_is_a_table_and_what_did_not_is_a_line() {
        let stored = stored_runs(&embedded());
        let effect = Effect {
            plateau_strain: Some(0.013),
            reflection: None,
            transmission: Some(0.9),
            diversion: None,
            energy_residual: Some(0.5),
            projectile_velocity: 400.0,
        };
        let changed = Effect {
            plateau_strain: Some(0.0143),
            transmission: None,
            diversion: Some(0.07),
            ..effect.clone()
        };
        let run = |id: &str, effect: &Effect| RunVector {
            id: id.into(),
            effect: effect.clone(),
            ..stored[0].clone()
        };
        let before = [run("gone", &changed), run("kept", &effect), run("changed", &effect)];
        let after = [run("new", &effect), run("kept", &effect), run("changed", &changed)];
        let said = Effects { before: &before, after: &after }.to_string();
        let spaced = |line: &str| line.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(
            said.lines().map(spaced).collect::<Vec<_>>(),
            [
                "new: not among the stored runs",
                "plateau strain none 0.013",
                "transmission T none 0.9",
                "energy residual none 0.5",
                "projectile, m/s none 400.0",
                "kept: the same to the bit",
                "changed before now change relative",
                "plateau strain 0.013 0.0143 1.3e-3 1.0e-1",
                "transmission T 0.9 none",
                "diversion D none 0.07",
                "energy residual 0.5 0.5 0.0e0 0.0e0",
                "projectile, m/s 400.0 400.0 0.0e0 0.0e0",
            ]
        );
    }
}
