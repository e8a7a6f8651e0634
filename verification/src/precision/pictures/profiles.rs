//! Strain along both fibres of Fig. 3 on several meshes, beside the exact profile.

use crossfibre::exact::fronts::Segment;
use crossfibre::place::Fibre;
use crossfibre::result::RunResult;

use super::super::exact::{Exact, Piece};
use super::super::problems::Problem;
use super::super::run_of;
use super::super::variants::Variant;
use super::BASES;
use crate::closed_form;
use crate::oracle::motion;
use crate::planted;
use crate::plot::{Axis, Colour, Mark, Panel, Series, Style, rows};
use crate::tables::{Table, cell};

/// Refinements of the paper's mesh that are drawn, and how.
const MESHES: [(f64, Colour, Style); 4] = [
    (0.2, Colour::Orange, Style::Marked(Mark::Circle)),
    (1.0, Colour::Vermillion, Style::Solid(1.3)),
    (4.0, Colour::Green, Style::Solid(1.3)),
    (16.0, Colour::Blue, Style::Solid(1.3)),
];

/// A fibre or a part of it: title, where it is shown from and to, mm, and the scale of the ordinate.
struct View {
    title: &'static str,
    fibre: Fibre,
    from: f64,
    to: f64,
    every: f64,
}

const PRIMARY: View =
    View { title: "primary", fibre: Fibre::Primary, from: 0.0, to: 220.0, every: 20.0 };
const SECONDARY: View =
    View { title: "secondary", fibre: Fibre::Secondary, from: 0.0, to: 110.0, every: 20.0 };
const FRONT: View = View {
    title: "the front on the primary",
    fibre: Fibre::Primary,
    from: 180.0,
    to: 204.0,
    every: 4.0,
};

/// A finished run.
struct Profile {
    variant: &'static str,
    mesh: usize,
    /// Length of an element of each fibre, m.
    spacing: f64,
    result: RunResult,
}

/// The exact answer in a measure.
struct Answer {
    variant: &'static str,
    exact: Exact,
    /// The primary's segments, which know its directions.
    segments: Vec<Segment>,
}

/// What is drawn.
pub struct Profiles {
    profiles: Vec<Profile>,
    answers: Vec<Answer>,
}

impl Profiles {
    /// Makes the runs.
    pub fn made() -> Self {
        let (mut profiles, mut answers) = (Vec::new(), Vec::new());
        for variant in BASES {
            for (mesh, &(refinement, ..)) in MESHES.iter().enumerate() {
                let run = run_of(Problem::Crossed, &Variant::named(variant), refinement);
                let result = planted::run(&run.scene, |_| {});
                let fibre = &run.scene.primary;
                let spacing = fibre.length / fibre.elements as f64;
                if refinement == 1.0
                    && let Ok(exact) = Exact::of(&run, result.time)
                {
                    let problem = closed_form::problem(&run.scene);
                    let segments = motion(&problem, None, result.time).primary;
                    answers.push(Answer { variant, exact, segments });
                }
                profiles.push(Profile { variant, mesh, spacing, result });
            }
        }
        Self { profiles, answers }
    }

    /// Both fibres.
    pub fn whole(&self) -> String {
        let y = [Axis::new("strain, %", 0.0, 1.8, 0.2), Axis::new("strain, %", 0.0, 0.3, 0.05)];
        self.rows([PRIMARY, SECONDARY].map(|view| {
            let axis = if view.fibre == Fibre::Primary { &y[0] } else { &y[1] };
            BASES.map(|variant| self.strains(&view, axis, variant))
        }))
    }

    /// The front and the kink.
    pub fn close_ups(&self) -> String {
        let y = Axis::new("strain, %", 0.0, 1.8, 0.2);
        self.rows([
            BASES.map(|variant| self.strains(&FRONT, &y, variant)),
            BASES.map(|variant| self.inclinations(variant)),
        ])
    }

    fn rows(&self, panels: [[Panel; 2]; 2]) -> String {
        rows(&panels.concat(), 2)
    }

    /// Strains of a part of a fibre.
    fn strains(&self, view: &View, y: &Axis, variant: &str) -> Panel {
        let of_fibre = |profile: &Profile| -> Vec<f64> {
            strain(&profile.result, view.fibre).iter().map(|e| 100.0 * e).collect()
        };
        let outline = |answer: &Answer| {
            let pieces = match view.fibre {
                Fibre::Primary => &answer.exact.primary,
                Fibre::Secondary => &answer.exact.secondary,
            };
            let ends = |p: &Piece| [p.from, p.to].map(|x| (1e3 * x, 100.0 * p.strain));
            pieces.iter().flat_map(ends).collect()
        };
        self.panel(view, y.clone(), variant, of_fibre, outline)
    }

    /// Sines of the inclination of the primary about its kink.
    fn inclinations(&self, variant: &str) -> Panel {
        let of_elements = |profile: &Profile| -> Vec<f64> {
            let nodes = profile.result.primary.position.windows(2);
            let sine = |ends: &[Vec<f64>]| {
                let (x, y) = (ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
                y.abs() / (x * x + y * y).sqrt()
            };
            nodes.map(sine).collect()
        };
        let outline = |answer: &Answer| {
            let ends = |s: &Segment| [s.from, s.to].map(|x| (1e3 * x, s.state.direction.y.abs()));
            answer.segments.iter().flat_map(ends).collect()
        };
        let view = View {
            title: "the kink of the primary",
            fibre: Fibre::Primary,
            from: 12.0,
            to: 36.0,
            every: 4.0,
        };
        let y = Axis::new("sine of the inclination", 0.0, 0.6, 0.1);
        self.panel(&view, y, variant, of_elements, outline)
    }

    /// What elements have at their middles, on each mesh, and the exact line on top.
    fn panel(
        &self,
        view: &View,
        y: Axis,
        variant: &str,
        of_elements: impl Fn(&Profile) -> Vec<f64>,
        outline: impl Fn(&Answer) -> Vec<(f64, f64)>,
    ) -> Panel {
        let &View { title, fibre, from, to, every } = view;
        let mut series = Vec::new();
        for profile in self.profiles.iter().filter(|profile| profile.variant == variant) {
            let (_, colour, style) = MESHES[profile.mesh];
            let dx = 1e3 * profile.spacing;
            let middles = of_elements(profile).into_iter().enumerate();
            let points = middles.map(|(i, value)| ((i as f64 + 0.5) * dx, value));
            // One more on each side, so that lines run to the ends.
            let shown = points.filter(|p| from - dx <= p.0 && p.0 <= to + dx).collect();
            series.push(Series::new(mesh(profile.spacing), colour, style, shown));
        }
        for answer in self.answers.iter().filter(|answer| answer.variant == variant) {
            let style = Style::Dashed(1.6);
            series.push(Series::new("exact", Colour::Black, style, outline(answer)));
        }
        let origin = match fibre {
            Fibre::Primary => "the impact point",
            Fibre::Secondary => "the crossover",
        };
        let x = Axis::new(format!("unstrained distance from {origin}, mm"), from, to, every);
        Panel { title: format!("{title}: {variant}"), x, y, series, width: 645.0 }
    }

    /// The strains of all elements that are shown.
    pub fn table(&self) -> String {
        let mut table = Table::new(&[
            "fibre",
            "element size [m]",
            "middle of the element [m]",
            "strain (4) [1]",
            "exact (4) [1]",
            "strain engineering [1]",
            "exact engineering [1]",
        ]);
        for view in [PRIMARY, SECONDARY] {
            for mesh in 0..MESHES.len() {
                let of_variants = BASES.map(|variant| {
                    let of = |p: &&Profile| p.variant == variant && p.mesh == mesh;
                    (
                        self.profiles.iter().find(of),
                        self.answers.iter().find(|a| a.variant == variant),
                    )
                });
                let Some(first) = of_variants[0].0 else { continue };
                for i in 0..strain(&first.result, view.fibre).len() {
                    let middle = (i as f64 + 0.5) * first.spacing;
                    if 1e3 * middle > view.to {
                        break;
                    }
                    let mut row = vec![
                        view.fibre.name().to_owned(),
                        cell(Some(first.spacing)),
                        cell(Some(middle)),
                    ];
                    for (profile, answer) in of_variants {
                        row.push(cell(profile.map(|p| strain(&p.result, view.fibre)[i])));
                        row.push(cell(answer.and_then(|a| exact_at(a, view.fibre, middle))));
                    }
                    table.row(&row);
                }
            }
        }
        table.text()
    }
}

fn strain(result: &RunResult, fibre: Fibre) -> &[f64] {
    match (fibre, &result.secondary) {
        (Fibre::Primary, _) => &result.primary.strain,
        (Fibre::Secondary, Some(secondary)) => &secondary.strain,
        (Fibre::Secondary, None) => &[],
    }
}

fn exact_at(answer: &Answer, fibre: Fibre, place: f64) -> Option<f64> {
    let pieces = match fibre {
        Fibre::Primary => &answer.exact.primary,
        Fibre::Secondary => &answer.exact.secondary,
    };
    pieces.iter().find(|piece| place <= piece.to).map(|piece| piece.strain)
}

fn mesh(spacing: f64) -> String {
    format!("elements of {} mm", (1e6 * spacing).round() / 1e3)
}
