//! Errors on a ladder of meshes, on logarithmic axes.

use super::super::problems::Problem;
use super::super::reading::Quantity;
use super::super::record::{Entry, Record};
use super::BASES;
use super::looks::look;
use crate::plot::{Axis, Colour, Panel, Series, Style};

/// What errors are drawn against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Abscissa {
    /// Elements visited.
    ElementSteps,
    /// Length of an element.
    ElementLength,
}

impl Abscissa {
    fn label(self) -> &'static str {
        match self {
            Self::ElementSteps => "element-steps",
            Self::ElementLength => "length of an element, mm",
        }
    }

    fn of(self, entry: &Entry) -> f64 {
        match self {
            Self::ElementSteps => entry.found.element_steps as f64,
            Self::ElementLength => 1e3 * entry.spacing,
        }
    }

    /// The power of the abscissa that an error of an order follows: halved elements are twice as many
    /// in each of twice as many steps.
    fn power(self, order: f64) -> f64 {
        match self {
            Self::ElementSteps => -0.5 * order,
            Self::ElementLength => order,
        }
    }
}

/// What is drawn of a problem.
#[derive(Clone, Copy)]
pub struct Errors<'r> {
    /// Where its runs are.
    pub record: &'r Record,
    /// Which problem.
    pub problem: Problem,
    /// Against what.
    pub abscissa: Abscissa,
    /// The variants drawn, as far as there are runs of them.
    pub variants: &'r [&'static str],
    /// Width of a panel, pixels.
    pub width: f64,
}

/// Height of a row of failed runs, of the height of the axes.
const ROW: f64 = 0.045;

impl Errors<'_> {
    /// The errors of a quantity.
    pub fn panel(&self, quantity: Quantity) -> Panel {
        let drawn: Vec<(&str, Vec<&Entry>)> = self
            .variants
            .iter()
            .map(|&variant| (variant, self.record.series(self.problem, variant)))
            .filter(|(_, entries)| !entries.is_empty())
            .collect();
        let size = |entry: &Entry| entry.error(quantity).map_or(f64::NAN, f64::abs);
        let all = || drawn.iter().flat_map(|(_, entries)| entries.iter().copied());
        let (from, to) = ends(all().filter(|e| e.error(quantity).is_some()).map(|e| self.x(e)));
        let floors = self.floors(quantity);
        let (low, _) = ends(all().map(size));
        // A floor far below says no more than that it is far below.
        let near = |floor: &f64| *floor > 0.1 * low;
        let floors: Vec<_> =
            floors.into_iter().filter(|s| s.points.iter().any(|p| near(&p.1))).collect();
        let drawn_floors = || floors.iter().flat_map(|series| series.points.iter().map(|p| p.1));
        let (low, high) = ends(all().map(size).chain(drawn_floors()));
        let failed: Vec<_> =
            drawn.iter().filter(|(_, entries)| entries.iter().any(|e| is_failed(e))).collect();
        let y = with_rows(axis_label(quantity), (low, high), failed.len());

        let mut series = self.guide(quantity, &drawn, (from, to));
        for (variant, entries) in &drawn {
            let (colour, style) = look(variant);
            let points = entries.iter().map(|e| (self.x(e), size(e))).collect();
            series.push(Series::new(*variant, colour, style, points));
        }
        series.extend(floors);
        for (row, (variant, entries)) in failed.into_iter().enumerate() {
            // What ended at once stands at the left end.
            let left = share(from, to, 0.03);
            let x = |entry: &Entry| self.x(entry).max(left);
            let level = share(y.from, y.to, 1.0 - ROW * (row as f64 + 0.7));
            let ended = entries.iter().filter(|entry| is_failed(entry));
            let points = ended.map(|entry| (x(entry), level)).collect();
            let colour = look(variant).0;
            series.push(Series { name: None, colour, style: Style::Failed, points });
        }
        if y.to > high {
            series.push(Series::new(FAILED, Colour::Black, Style::Failed, vec![]));
        }
        Panel {
            title: quantity.label().into(),
            x: Axis::logarithmic(self.abscissa.label(), from, to),
            y,
            series,
            width: self.width,
        }
    }

    fn x(&self, entry: &Entry) -> f64 {
        self.abscissa.of(entry)
    }

    /// The error that the exact solution admits itself: of the strains of the primary.
    fn floors(&self, quantity: Quantity) -> Vec<Series> {
        if !matches!(quantity, Quantity::StrainL1 | Quantity::MeanStrain) {
            return vec![];
        }
        let floor = |(variant, style): (&str, Style)| {
            let entries = self.record.series(self.problem, variant);
            let known = entries.iter().filter_map(|e| Some((self.x(e), e.found.floor?)));
            let (measure, _) = variant.split_once(", ").unwrap_or_default();
            let name = format!("bound of the exact solution, {measure}");
            Series::new(name, Colour::Black, style, known.collect())
        };
        let styles = [Style::Dotted(2.2), Style::Dotted(1.2)];
        BASES.into_iter().zip(styles).map(floor).collect()
    }

    /// A slope to compare with, a little below the first variant.
    fn guide(
        &self,
        quantity: Quantity,
        drawn: &[(&str, Vec<&Entry>)],
        (from, to): (f64, f64),
    ) -> Vec<Series> {
        let first = drawn.first().and_then(|(_, entries)| entries.first());
        let error = first.and_then(|entry| entry.error(quantity));
        let (Some(slope), Some(entry), Some(error)) = (slope(quantity), first, error) else {
            return vec![];
        };
        let power = self.abscissa.power(slope.order);
        let at = |x: f64| (x, 0.45 * error.abs() * pxfm::f_pow(x / self.x(entry), power));
        vec![Series::new(slope.name, Colour::Grey, slope.style, vec![at(from), at(to)])]
    }
}

/// What the legend calls the mark of a failed run.
const FAILED: &str = "failed, where its work ended";

fn is_failed(entry: &Entry) -> bool {
    !entry.found.outcome.is_completed()
}

/// A slope to compare with.
struct Slope {
    order: f64,
    name: &'static str,
    style: Style,
}

/// The order that a front of fixed width in elements would give, or a kink that spreads as Δx^(2/3);
/// none for means over windows, whose errors swing (`docs/convergence.md`).
fn slope(quantity: Quantity) -> Option<Slope> {
    use Quantity::*;
    match quantity {
        StrainL1 | SecondaryL1 | MeanStrain | SecondaryMean | Arrival | Energy => {
            Some(Slope { order: 1.0, name: "slope of order 1", style: Style::Solid(1.0) })
        }
        Kink => {
            Some(Slope { order: 2.0 / 3.0, name: "slope of order 2/3", style: Style::Dashed(1.0) })
        }
        StrainL2 | SecondaryL2 => {
            Some(Slope { order: 0.5, name: "slope of order 1/2", style: Style::Dotted(1.6) })
        }
        Plateau | Reflection | Transmission | Diversion | Projectile => None,
    }
}

fn axis_label(quantity: Quantity) -> &'static str {
    use Quantity::*;
    match quantity {
        StrainL1 | StrainL2 | SecondaryL1 | SecondaryL2 => {
            "error, of the norm of the exact profile"
        }
        Energy => "|residual|, of the energy put in",
        _ => "|error|, relative",
    }
}

/// Room around what is drawn, as a factor; at least that, and more on a long axis.
const ROOM: f64 = 1.5;
const LONG: f64 = 0.04;

/// The fewest decades of an axis, as a factor.
const LEAST: f64 = 100.0;

/// The ends of a logarithmic axis that holds what is positive and finite among some values.
pub fn ends(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let fit = values.filter(|value| *value > 0.0 && value.is_finite());
    let (low, high) = fit.fold((f64::INFINITY, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
    if low > high {
        return (0.1, 10.0);
    }
    let short = (LEAST * low / high).max(1.0).sqrt();
    let wider = pxfm::f_pow(high / low, LONG).max(ROOM * short);
    (low / wider, high * wider)
}

/// An axis with some rows for failed runs above.
fn with_rows(label: &str, (low, high): (f64, f64), rows: usize) -> Axis {
    let decades = pxfm::f_log10(high / low);
    // The rows, and half of one between them and what is below.
    let share = if rows == 0 { 0.0 } else { ROW * (rows as f64 + 0.5) };
    let more = decades / (1.0 - share) - decades;
    Axis::logarithmic(label, low, if rows == 0 { high } else { high * pxfm::f_exp10(more) })
}

/// The value at a share of the way along a logarithmic axis.
fn share(from: f64, to: f64, share: f64) -> f64 {
    from * pxfm::f_pow(to / from, share)
}

#[cfg(test)]
mod tests {
    use super::super::made_up::{entry, record};
    use super::*;

    fn panel(entries: Vec<Entry>) -> Panel {
        let record = record(entries);
        let variants = &["engineering, α = 1", "eqn (4), α = 1, f32"];
        let (problem, abscissa) = (Problem::Crossed, Abscissa::ElementSteps);
        let errors = Errors { record: &record, problem, abscissa, variants, width: 430.0 };
        errors.panel(Quantity::StrainL1)
    }

    #[test]
    fn a_failed_run_is_a_cross_above_and_no_point() {
        let single = "eqn (4), α = 1, f32";
        let panel = panel(vec![
            entry("engineering, α = 1", 3e-3, Some(-0.043)),
            entry("engineering, α = 1", 1e-3, Some(0.013)),
            entry(single, 3e-3, Some(0.031)),
            entry(single, 1e-3, None),
        ]);
        let named = |name: &str| {
            panel.series.iter().find(|series| series.name.as_deref() == Some(name)).unwrap()
        };
        // Sizes, against elements squared.
        assert_eq!(named("engineering, α = 1").points, [(1e4, 0.043), (9e4, 0.013)]);
        let line = &named(single).points;
        assert_eq!(line[0], (1e4, 0.031));
        assert!(line[1].1.is_nan());
        let crosses: Vec<_> =
            panel.series.iter().filter(|s| s.style == Style::Failed && s.name.is_none()).collect();
        let [cross] = &crosses[..] else { panic!("{crosses:?}") };
        assert_eq!(cross.colour, named(single).colour);
        let [(work, height)] = cross.points[..] else { panic!("{cross:?}") };
        assert_eq!(work, 9e4);
        assert!(height > 2.0 * 0.043 && height < panel.y.to, "{height} {}", panel.y.to);
    }

    #[test]
    fn what_failed_at_once_stands_within_the_axes() {
        let mut at_once = entry("eqn (4), α = 1, f32", 3e-3, None);
        at_once.found.element_steps = 2;
        let panel = panel(vec![entry("engineering, α = 1", 3e-3, Some(0.043)), at_once]);
        let cross = panel.series.iter().find(|s| s.style == Style::Failed).unwrap();
        let x = cross.points[0].0;
        assert!(panel.x.from < x && x < 1e4, "{x}");
    }

    #[test]
    fn a_bound_is_drawn_where_it_is_near() {
        let bounds = |error| {
            let panel = panel(vec![entry("engineering, α = 1", 3e-3, Some(error))]);
            let is_bound = |name: &String| name.starts_with("bound");
            panel.series.iter().filter(|s| s.name.as_ref().is_some_and(is_bound)).count()
        };
        // It is 2.3e-5.
        assert_eq!((bounds(1.1e-4), bounds(0.37)), (1, 0));
    }

    #[test]
    fn a_slope_falls_as_an_error_of_its_order() {
        let panel = panel(vec![entry("engineering, α = 1", 3e-3, Some(0.043))]);
        let slope = panel.series.iter().find(|s| s.name.as_deref() == Some("slope of order 1"));
        let [(x0, y0), (x1, y1)] = slope.unwrap().points[..] else { panic!("{slope:?}") };
        // Elements are the root of the element-steps. Some roundings of a power.
        assert!((y1 / y0 * (x1 / x0).sqrt() - 1.0).abs() < 1e-14);
    }

    #[test]
    fn ends_hold_what_has_a_place() {
        let (low, high) = ends([0.0, 3e-4, f64::NAN, 0.7, -2.0, f64::INFINITY].into_iter());
        assert!(low < 3e-4 && low > 1e-4 && high > 0.7 && high < 2.0, "{low} {high}");
        let (low, high) = ends([0.31].into_iter());
        // Two decades, and room.
        assert!(high / low > 100.0 && low < 0.31 && 0.31 < high, "{low} {high}");
    }
}
