//! A result as a picture: strain and tension along the fibres, and their shape.

use crossfibre::place::Fibre;
use crossfibre::result::{FibreResult, RunResult};

use crate::plot::{Axis, Colour, Panel, Series, Style, rows};

/// Above, strain against place for each fibre; below, tension, and below that the shape.
pub fn picture(result: &RunResult) -> String {
    let fibres: Vec<_> =
        [(Fibre::Primary, Some(&result.primary)), (Fibre::Secondary, result.secondary.as_ref())]
            .into_iter()
            .filter_map(|(fibre, numbers)| Some((fibre, numbers?)))
            .collect();
    let strains = fibres.iter().map(|(fibre, numbers)| Panel {
        title: format!("{} at {:.4} µs, {}", fibre.name(), 1e6 * result.time, result.outcome),
        ..along(*fibre, numbers, &numbers.strain, 100.0, "strain, %")
    });
    let tensions = fibres.iter().map(|(fibre, numbers)| Panel {
        title: format!("tension of the {}", fibre.name()),
        ..along(*fibre, numbers, &numbers.tension, 1.0, "tension, N")
    });
    let shapes = fibres.iter().map(|(fibre, numbers)| shape(*fibre, numbers));
    let panels: Vec<Panel> = strains.chain(tensions).chain(shapes).collect();
    rows(&panels, fibres.len())
}

const WIDTH: f64 = 600.0;

/// A number of each element, over its middle.
fn along(fibre: Fibre, numbers: &FibreResult, values: &[f64], unit: f64, label: &str) -> Panel {
    let middle = |i: usize| 1e3 * numbers.spacing * (i as f64 + 0.5);
    let points: Vec<_> = values.iter().enumerate().map(|(i, x)| (middle(i), unit * x)).collect();
    let origin = match fibre {
        Fibre::Primary => "the impact point",
        Fibre::Secondary => "the crossover",
    };
    let length = 1e3 * numbers.spacing * values.len() as f64;
    Panel {
        title: String::new(),
        x: axis(&format!("unstrained distance from {origin}, mm"), 0.0, [length].into_iter()),
        y: axis(label, 0.1, points.iter().map(|&(_, y)| y)),
        series: vec![line(points)],
        width: WIDTH,
    }
}

/// Where the nodes are: the primary along x, the secondary along z, and y the way of the projectile.
fn shape(fibre: Fibre, numbers: &FibreResult) -> Panel {
    let (along, name) = match fibre {
        Fibre::Primary => (0, "x, mm"),
        Fibre::Secondary => (2, "z, mm"),
    };
    let points: Vec<_> = numbers.position.iter().map(|at| (1e3 * at[along], 1e3 * at[1])).collect();
    Panel {
        title: format!("shape of the {}", fibre.name()),
        x: axis(name, 0.0, points.iter().map(|&(x, _)| x)),
        y: axis("y, mm", 0.1, points.iter().map(|&(_, y)| y)),
        series: vec![line(points)],
        width: WIDTH,
    }
}

fn line(points: Vec<(f64, f64)>) -> Series {
    Series { name: None, colour: Colour::Blue, style: Style::Solid(1.6), points }
}

/// A range of what is drawn, in its unit, below which it is rounding: it is drawn as none.
const LEAST: f64 = 1e-8;

/// From the least value, or zero, to the greatest, and so much of that range beyond.
fn axis(label: &str, margin: f64, values: impl Iterator<Item = f64>) -> Axis {
    let ends = |(least, most): (f64, f64), x: f64| (least.min(x), most.max(x));
    let (least, most) = values.fold((0.0, 0.0), ends);
    if most - least < LEAST {
        return Axis::from_zero(label, 1.0);
    }
    let beyond = margin * (most - least);
    let below = if least < 0.0 { beyond } else { 0.0 };
    Axis::around(label, least - below, most + beyond)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::shipped;
    use crate::wide;

    #[test]
    fn two_fibres_are_six_panels_and_no_number_is_lost() {
        let drawn = |name: &str| picture(&wide::run(&shipped(name), |_| ()));
        let (crossed, single) = (drawn("fig3"), drawn("slack"));
        for (text, parts) in [
            (&crossed, ["strain, %", "tension of the secondary", "z, mm"]),
            (&single, ["strain, %", "tension of the primary", "y, mm"]),
        ] {
            assert!(parts.iter().all(|part| text.contains(part)));
            assert!(!text.contains("NaN") && !text.contains("inf\""));
            // The kink has not come to the crossover: y is 5e-58 m there, and no tick is named so.
            assert!(!text.contains(">0.000000"));
        }
        assert!(!single.contains("secondary"));
    }

    #[test]
    fn what_is_at_rest_has_axes_too() {
        let mut result = wide::run(&shipped("single-400"), |_| ());
        result.primary.strain.fill(0.0);
        result.primary.tension.fill(0.0);
        result.primary.position.iter_mut().for_each(|at| at[1] = 0.0);
        assert!(!picture(&result).contains("NaN"));
    }
}
