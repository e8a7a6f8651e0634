//! Strain along fibres of other laws than (7), and what artificial viscosity does.

use crossfibre::scene::Scene;

use super::{Picture, Section};
use crate::cases::support::{marched, shipped};
use crate::closed_form::{component, struck};
use crate::plot::{Axis, Colour, Panel, Series, Style, rows};

/// The scenes that are drawn: each has a panel.
const SCENES: [&str; 4] = ["hardening", "softening", "artificial-viscosity", "viscoelastic"];

/// The lines.
const AS_IT_IS: &str = "as the scene has it";
const WITHOUT: &str = "without its artificial viscosity";
const SMITH: &str = "Smith's strain";

/// The picture.
pub fn picture() -> Picture {
    let panels = SCENES.map(|name| panel(&shipped(name)));
    Picture {
        id: "laws".into(),
        section: Section::Figures,
        title: "Other laws, and artificial viscosity".into(),
        caption: "Strain along the primary fibre at the end of shipped scenes. A law that hardens has a shock, \
                  of which the scheme alone makes a train of waves; one that softens has a fan; arms that relax \
                  leave no plateau, and so none that Smith's relation could give."
            .into(),
        alt: "Four panels of strain over distance. Hardening: with artificial viscosity a step at Smith's \
              strain, without it waves about that strain. Softening: the strain falls gradually ahead of \
              Smith's plateau. Linear: the overshoot at the front is gone with artificial viscosity. \
              Viscoelastic: a strain that is the same nowhere, with a step at the crossover."
            .into(),
        svg: rows(&panels, 2),
    }
}

fn panel(scene: &Scene) -> Panel {
    let line =
        |name, colour, scene: &Scene| Series::new(name, colour, Style::Solid(1.6), along(scene));
    let mut series: Vec<Series> =
        bare(scene).iter().map(|bare| line(WITHOUT, Colour::Orange, bare)).collect();
    series.push(line(AS_IT_IS, Colour::Blue, scene));
    let length = 1e3 * scene.primary.length;
    if let Ok(smith) = struck(scene, &scene.primary.material, scene.primary.density) {
        let strain = 100.0 * component(scene, smith.strain);
        let points = vec![(0.0, strain), (length, strain)];
        series.insert(0, Series::new(SMITH, Colour::Black, Style::Dashed(1.2), points));
    }
    let strains = series.iter().flat_map(|series| &series.points).map(|&(_, strain)| strain);
    let most = strains.fold(0.0_f64, f64::max);
    Panel {
        title: scene.title.clone(),
        x: Axis::from_zero("unstrained distance from the impact point, mm", length),
        y: Axis::from_zero("strain, %", 1.08 * most),
        series,
        width: 540.0,
    }
}

/// The scene without artificial viscosity; none if it has none.
fn bare(scene: &Scene) -> Option<Scene> {
    let mut bare = scene.clone();
    bare.primary.material.artificial_viscosity.take().map(|_| bare)
}

/// Strain, %, over the middle of each element, mm.
fn along(scene: &Scene) -> Vec<(f64, f64)> {
    let fibre = marched(scene.clone()).state.primary;
    let middle = |i: usize| 1e3 * fibre.properties.spacing * (i as f64 + 0.5);
    fibre.strain.iter().enumerate().map(|(i, strain)| (middle(i), 100.0 * strain)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Greatest strain over Smith's: 1.003 and 1.66.
    #[test]
    fn viscosity_makes_a_step_of_the_train_of_waves() {
        let panel = panel(&shipped("hardening"));
        let most = |name: &str| {
            let named = |series: &&Series| series.name.as_deref() == Some(name);
            let points = &panel.series.iter().find(named).unwrap().points;
            points.iter().fold(0.0_f64, |most, &(_, strain)| most.max(strain))
        };
        let [with, without] = [AS_IT_IS, WITHOUT].map(|name| most(name) / most(SMITH));
        assert!((0.999..1.01).contains(&with) && without > 1.5, "{with} {without}");
    }
}
