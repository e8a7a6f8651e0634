//! A result for people: what came of a run, beside what the closed forms say.

pub mod exact;
mod table;
mod text;

use std::fmt::{self, Display, Formatter};

use crossfibre::discretisation::Discretisation;
use crossfibre::errata::Corrections;
use crossfibre::exact::smith::Law;
use crossfibre::place::Fibre;
use crossfibre::result::RunResult;
use crossfibre::scene::Scene;

use crate::closed_form::{self, law};
use exact::Exact;
use table::OneFibre;
use text::{mm, significant, write_note};

/// Displays as the summary.
pub struct Summary<'a> {
    /// What was run.
    pub scene: &'a Scene,
    /// What came of it.
    pub result: &'a RunResult,
}

impl Display for Summary<'_> {
    fn fmt(&self, to: &mut Formatter) -> fmt::Result {
        let Self { scene, result } = self;
        writeln!(to, "{}\n", scene.title)?;
        writeln!(to, "outcome      {}", result.outcome)?;
        writeln!(
            to,
            "time         {} steps of {:.6} µs = {:.4} µs",
            result.steps,
            result.time_step * 1e6,
            result.time * 1e6
        )?;
        writeln!(to, "corrections  {}", corrections(scene.corrections))?;
        if result.outcome.is_completed() {
            self.strains(to)?;
            self.bodies(to)?;
            self.balance(to)?;
        }
        writeln!(to, "work         {} element-steps", result.counts.element_steps)
    }
}

impl Summary<'_> {
    /// Strains and positions beside the closed forms.
    fn strains(&self, to: &mut Formatter) -> fmt::Result {
        let Self { scene, result } = self;
        let mesh = Discretisation::<f64>::of(scene);
        let exact = Exact::of(scene, result.time);
        let law = match (closed_form::beyond(scene), law(scene)) {
            (Some(_), Law::Logarithmic) => "other than eqn (7), along the path of (4)",
            (Some(_), Law::Engineering) => "other than eqn (7); strain is λ - 1, not the paper's",
            (None, Law::Logarithmic) => "eqns (4) and (7), which are T = E ln λ; strain is ln λ",
            (None, Law::Engineering) => "T = E (λ - 1); strain is λ - 1, not the paper's",
        };
        writeln!(
            to,
            "exact        Smith's impact and the self-similar crossover for the law of this scene:"
        )?;
        writeln!(to, "             {law}\n")?;

        writeln!(to, "{}", table::head())?;
        let mut fibres = vec![OneFibre {
            fibre: Fibre::Primary,
            result: &result.primary,
            properties: mesh.primary,
            since: result.time,
            time_step: result.time_step,
        }];
        if let (Some(secondary), Some(crossing)) = (&result.secondary, mesh.secondary) {
            fibres.push(OneFibre {
                fibre: Fibre::Secondary,
                result: secondary,
                properties: crossing.fibre,
                since: result.time - crossing.at / mesh.primary.wave_speed,
                time_step: result.time_step,
            });
        }
        for row in fibres.iter().flat_map(|fibre| fibre.rows(&exact)) {
            writeln!(to, "{row}")?;
        }
        writeln!(to)?;
        exact.notes.iter().try_for_each(|note| write_note(to, note))
    }

    /// Crossover and projectile.
    fn bodies(&self, to: &mut Formatter) -> fmt::Result {
        let Self { scene, result } = self;
        if let Some(crossover) = &result.crossover {
            let times = if crossover.moves == 1 { "time" } else { "times" };
            writeln!(
                to,
                "crossover    node {} of the primary, moved {} {times}; the secondary begins {} beside it",
                crossover.node,
                crossover.moves,
                mm(crossover.distance)
            )?;
        }
        let constant = if scene.projectile.mass.is_none() { " (kept constant)" } else { "" };
        writeln!(
            to,
            "projectile   {:.3} m/s at impact, {:.3} m/s now{constant}, {} on its way",
            scene.projectile.velocity,
            result.projectile.velocity,
            mm(result.projectile.position)
        )
    }

    /// Energy and momentum.
    fn balance(&self, to: &mut Formatter) -> fmt::Result {
        let Some(balance) = &self.result.balance else {
            return writeln!(to, "energy       a sum is not finite");
        };
        let (energy, momentum) = (&balance.energy, &balance.momentum);
        let projectile = match self.scene.projectile.mass {
            Some(_) => format!(", projectile {}", significant(energy.projectile)),
            None => String::new(),
        };
        let dissipated = match energy.dissipated {
            0.0 => String::new(),
            lost => format!(", dissipated {}", significant(lost)),
        };
        writeln!(
            to,
            "energy, J    put in {}; kinetic {}, stored {}{dissipated}{projectile}; residual {:+.4} %",
            significant(energy.initial + energy.work),
            significant(energy.kinetic),
            significant(energy.stored),
            energy.relative_residual() * 100.0
        )?;
        writeln!(
            to,
            "momentum     put in {} kg m/s; residual {:.1e} kg m/s",
            significant(momentum.initial + momentum.drive),
            momentum.residual
        )
    }
}

fn corrections(chosen: Corrections) -> String {
    match chosen {
        Corrections::ALL => "all".into(),
        Corrections::NONE => "none: the page as printed".into(),
        some => some.iter().map(|erratum| erratum.entry().id).collect::<Vec<_>>().join(", "),
    }
}
