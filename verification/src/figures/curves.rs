//! Figs 4 to 7: coefficients against the modulus and the slide factor.

use crossfibre::exact::crossover::Coefficients;
use crossfibre::scene::Strain;

use super::points::{Abscissa, CURVES, Edition, curve_id, element};
use super::{Snapshots, Window};
use crate::cases::crossover::exact_coefficients;
use crate::cases::support::measured_by;
use crate::plot::{Axis, Colour, Panel, Series, Style, svg};
use crate::tables::{Table, cell};

/// One of R, T and D.
#[derive(Clone, Copy)]
struct Coefficient {
    title: &'static str,
    label: &'static str,
    of: fn(&Coefficients) -> f64,
}

const REFLECTION: Coefficient =
    Coefficient { title: "Reflection", label: "R", of: |ratios| ratios.reflection };
const TRANSMISSION: Coefficient =
    Coefficient { title: "Transmission", label: "T", of: |ratios| ratios.transmission };
const DIVERSION: Coefficient =
    Coefficient { title: "Diversion", label: "D of one arm", of: |ratios| ratios.diversion };

/// A curve of the scheme: equations and mesh, windows, name, and how it is drawn.
struct Curve {
    run: (Edition, usize),
    window: Window,
    name: &'static str,
    colour: Colour,
    style: Style,
}

const fn curve(
    run: (Edition, usize),
    window: Window,
    name: &'static str,
    colour: Colour,
    style: Style,
) -> Curve {
    Curve { run, window, name, colour, style }
}

/// Between the fronts.
const CURVES_BETWEEN: [Curve; 5] = {
    use {Colour::*, Style::*, Window::BetweenFronts as B};
    [
        curve(CURVES[0], B, "as printed, 2 mm", Vermillion, Dashed(1.6)),
        curve(CURVES[1], B, "as printed, 0.125 mm", Vermillion, Solid(1.6)),
        curve(CURVES[2], B, "corrected, 2 mm", Blue, Dashed(1.6)),
        curve(CURVES[3], B, "corrected, 0.125 mm", Blue, Circles),
        curve(CURVES[4], B, "corrected, engineering strain, 0.125 mm", Green, Pluses),
    ]
};

/// Fixed; they differ from the others for R alone.
const CURVES_FIXED: [Curve; 2] = {
    use {Colour::*, Style::*, Window::Fixed as F};
    [
        curve(CURVES[0], F, "as printed, 2 mm, fixed window", Orange, Triangles),
        curve(CURVES[2], F, "corrected, 2 mm, fixed window", Sky, Triangles),
    ]
};

fn panel(
    snapshots: &Snapshots,
    over: Abscissa,
    coefficient: Coefficient,
    width: f64,
    y: (f64, f64, f64),
) -> Panel {
    let (from, to, x) = match over {
        Abscissa::Modulus => (10.0, 200.0, Axis::new("modulus, GPa", 0.0, 205.0, 50.0)),
        Abscissa::Slide => (0.0, 1.0, Axis::new("slide factor αₛ", -0.02, 1.02, 0.1)),
    };
    // Fine enough that a picture shows a curve.
    let smooth = (0..=190).map(|k| {
        let x = from + (to - from) * f64::from(k) / 190.0;
        (x, (coefficient.of)(&exact_coefficients(&over.scene(x))))
    });
    let mut series =
        vec![Series::new("closed form", Colour::Black, Style::Solid(1.6), smooth.collect())];
    let fixed = if coefficient.label == REFLECTION.label { &CURVES_FIXED[..] } else { &[] };
    for Curve { run, window, name, colour, style } in CURVES_BETWEEN.iter().chain(fixed) {
        let found = over.values().into_iter().map(|x| {
            let snapshot = snapshots.of(&curve_id(over, x, run.0, run.1));
            (x, window.of(snapshot).as_ref().map_or(f64::NAN, coefficient.of))
        });
        series.push(Series::new(*name, *colour, *style, found.collect()));
    }
    let Coefficient { title, label, .. } = coefficient;
    Panel { title: title.into(), x, y: Axis::new(label, y.0, y.1, y.2), series, width }
}

/// T and D against the modulus; R beside them, of which the page gives no figure.
pub fn fig4(snapshots: &Snapshots) -> String {
    let panel = |coefficient, y| panel(snapshots, Abscissa::Modulus, coefficient, 370.0, y);
    svg(&[
        panel(TRANSMISSION, (0.9, 1.0, 0.02)),
        panel(DIVERSION, (0.0, 0.3, 0.05)),
        panel(REFLECTION, (0.0, 0.14, 0.02)),
    ])
}

fn against_slide(snapshots: &Snapshots, coefficient: Coefficient, y: (f64, f64, f64)) -> String {
    svg(&[panel(snapshots, Abscissa::Slide, coefficient, 800.0, y)])
}

/// R against the slide factor.
pub fn fig5(snapshots: &Snapshots) -> String {
    against_slide(snapshots, REFLECTION, (-0.003, 0.07, 0.01))
}

/// D against the slide factor.
pub fn fig6(snapshots: &Snapshots) -> String {
    against_slide(snapshots, DIVERSION, (-0.005, 0.18, 0.02))
}

/// T against the slide factor.
pub fn fig7(snapshots: &Snapshots) -> String {
    against_slide(snapshots, TRANSMISSION, (0.95, 1.005, 0.01))
}

/// All coefficients against one abscissa, by the scheme and by the closed form.
pub fn table(snapshots: &Snapshots, over: Abscissa) -> String {
    let (name, unit) = match over {
        Abscissa::Modulus => ("modulus [Pa]", 1e9),
        Abscissa::Slide => ("slide factor [1]", 1.0),
    };
    let mut table = Table::new(&[
        name,
        "equations",
        "strain",
        "element size [m]",
        "window",
        "outcome",
        "R [1]",
        "T [1]",
        "D of one arm [1]",
    ]);
    for x in over.values() {
        let numbers = |ratios: Option<Coefficients>| {
            [REFLECTION, TRANSMISSION, DIVERSION]
                .map(|coefficient| cell(ratios.as_ref().map(coefficient.of)))
        };
        let mut row = |words: [&str; 5], ratios| {
            let [equations, strain, size, window, outcome] = words.map(str::to_owned);
            let head = [cell(Some(unit * x)), equations, strain, size, window, outcome];
            table.row(&[head.as_slice(), &numbers(ratios)].concat());
        };
        let scene = over.scene(x);
        let engineering = measured_by(Strain::Engineering, scene.clone());
        row(["closed form", "logarithmic", "", "", ""], Some(exact_coefficients(&scene)));
        row(["closed form", "engineering", "", "", ""], Some(exact_coefficients(&engineering)));
        for (edition, factor) in CURVES {
            let snapshot = snapshots.of(&curve_id(over, x, edition, factor));
            let equations = if edition == Edition::Printed { "printed" } else { "corrected" };
            let strain = if edition == Edition::Engineering { "engineering" } else { "(4)" };
            let size = cell(Some(1e-3 * element(factor)));
            // Words of an outcome may hold a comma; its first does not.
            let outcome = snapshot.outcome.to_string();
            let outcome = outcome.split([':', ',']).next().unwrap_or_default();
            for window in [Window::BetweenFronts, Window::Fixed] {
                row([equations, strain, &size, window.name(), outcome], window.of(snapshot));
            }
        }
    }
    table.text()
}
