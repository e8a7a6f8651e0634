//! Axes: where a value stands between the ends, and how ticks are named.

use std::sync::Arc;

use kuva::render::layout::TickFormat;

/// How places on an axis follow values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// In proportion.
    Linear {
        /// From tick to tick; ticks are at its multiples.
        step: f64,
    },
    /// With their logarithm; ticks are at powers of ten. What is not positive has no place.
    Logarithmic,
}

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What it measures, with the unit.
    pub label: String,
    /// Its lower end.
    pub from: f64,
    /// Its upper end.
    pub to: f64,
    /// How places follow values.
    pub scale: Scale,
}

/// The most powers of ten that a logarithmic axis names.
const POWERS: f64 = 10.0;

impl Axis {
    /// A linear axis.
    pub fn new(label: impl Into<String>, from: f64, to: f64, step: f64) -> Self {
        Self { label: label.into(), from, to, scale: Scale::Linear { step } }
    }

    /// A logarithmic axis between positive ends, which should have two powers of ten between them.
    pub fn logarithmic(label: impl Into<String>, from: f64, to: f64) -> Self {
        Self { label: label.into(), from, to, scale: Scale::Logarithmic }
    }

    /// A linear axis from 0 to a positive number, with some five to ten ticks at 1, 2 or 5 times a
    /// power of ten. Where all that is to be drawn is nothing, or has no size, it ends at 1.
    pub fn from_zero(label: impl Into<String>, to: f64) -> Self {
        let to = if to > 0.0 && to.is_finite() { to } else { 1.0 };
        let mut step = 1.0;
        while step > to / 6.0 {
            step /= 10.0;
        }
        while step * 10.0 <= to / 6.0 {
            step *= 10.0;
        }
        let wider = [5.0, 2.0].into_iter().map(|n| n * step).find(|s| *s <= to / 5.0);
        Self::new(label, 0.0, to, wider.unwrap_or(step))
    }

    /// A linear axis from one number to a greater one, with ticks as of [`Axis::from_zero`].
    pub fn around(label: impl Into<String>, from: f64, to: f64) -> Self {
        Self { from, to, ..Self::from_zero(label, to - from) }
    }

    /// What is drawn in proportion: the value, or its decimal logarithm. No number for a value
    /// without a place, infinity for infinity.
    fn drawn(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear { .. } => value,
            Scale::Logarithmic if value > 0.0 => pxfm::f_log10(value),
            Scale::Logarithmic => f64::NAN,
        }
    }

    /// The ends as they are drawn. The rounding of a multiple of the step must not cost the last tick.
    pub(super) fn ends(&self) -> (f64, f64) {
        let (from, to) = (self.drawn(self.from), self.drawn(self.to));
        (from, to + 1e-9 * (to - from))
    }

    /// Where a value stands: 0 at the lower end, 1 at the upper end; none if it has no place.
    pub(super) fn share(&self, value: f64) -> Option<f64> {
        let (from, to) = self.ends();
        let share = (self.drawn(value) - from) / (to - from);
        share.is_finite().then_some(share)
    }

    /// From tick to tick, as drawn.
    pub(super) fn step(&self) -> f64 {
        match self.scale {
            Scale::Linear { step } => step,
            Scale::Logarithmic => {
                let (from, to) = self.ends();
                ((to - from) / POWERS).ceil().max(1.0)
            }
        }
    }

    /// How a tick is named, by where it is drawn.
    pub(super) fn format(&self) -> TickFormat {
        match self.scale {
            Scale::Linear { step } => TickFormat::Fixed(decimals(step)),
            Scale::Logarithmic => TickFormat::Custom(Arc::new(|power| power_of_ten(power as i32))),
        }
    }

    /// All ticks, upward: the share of the axis that is below, and the name.
    pub(super) fn ticks(&self) -> Vec<(f64, String)> {
        let ((from, to), step, format) = (self.ends(), self.step(), self.format());
        let (first, last) = ((from / step - 1e-9).ceil() as i64, (to / step).floor() as i64);
        let tick = |k| {
            let drawn = step * k as f64;
            ((drawn - from) / (to - from), format.format(drawn))
        };
        (first..=last).map(tick).collect()
    }

    /// Where 2 to 9 times each power of ten stand between the ends of a logarithmic axis that names
    /// every power.
    pub(super) fn minor_ticks(&self) -> Vec<f64> {
        if !matches!(self.scale, Scale::Logarithmic) || self.step() > 1.0 {
            return vec![];
        }
        let (from, to) = self.ends();
        let powers = from.floor() as i32..=to.floor() as i32;
        let drawn = powers.flat_map(|power| {
            (2..=9).map(move |digit| f64::from(power) + pxfm::f_log10(f64::from(digit)))
        });
        drawn.map(|at| (at - from) / (to - from)).filter(|s| (0.0..=1.0).contains(s)).collect()
    }
}

/// Decimals that tell the multiples of a step apart.
fn decimals(step: f64) -> usize {
    format!("{step}").split_once('.').map_or(0, |(_, after)| after.len())
}

/// 1 and 10 as they are, other powers as 10⁻³.
fn power_of_ten(power: i32) -> String {
    match power {
        0 => "1".into(),
        1 => "10".into(),
        _ => {
            let raised = |c: char| match c {
                '-' => '⁻',
                '1' => '¹',
                '2' => '²',
                '3' => '³',
                digit => char::from_u32('⁰' as u32 + digit as u32 - '0' as u32).unwrap_or(digit),
            };
            format!("10{}", power.to_string().chars().map(raised).collect::<String>())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(axis: &Axis) -> Vec<String> {
        axis.ticks().into_iter().map(|(_, name)| name).collect()
    }

    #[test]
    fn powers_of_ten_are_named_as_people_read_them() {
        let axis = Axis::logarithmic("error", 1e-3, 1e2);
        assert_eq!(names(&axis), ["10⁻³", "10⁻²", "10⁻¹", "1", "10", "10²"]);
        assert_eq!(names(&Axis::logarithmic("work", 3.7e4, 2.2e6)), ["10⁵", "10⁶"]);
        // Eighteen powers are too many to name.
        let wide = names(&Axis::logarithmic("error", 1e-16, 1e2));
        assert_eq!(
            wide,
            ["10⁻¹⁶", "10⁻¹⁴", "10⁻¹²", "10⁻¹⁰", "10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²", "1", "10²"]
        );
    }

    #[test]
    fn multiples_of_the_step_are_named_to_the_end() {
        assert_eq!(names(&Axis::new("R", -0.03, 0.08, 0.04)), ["0.00", "0.04", "0.08"]);
        assert_eq!(names(&Axis::new("x", 0.0, 0.3, 0.1)), ["0.0", "0.1", "0.2", "0.3"]);
    }

    #[test]
    fn ticks_stand_in_proportion_between_the_ends() {
        let ticks = Axis::new("angle, °", 20.0, 60.0, 10.0).ticks();
        // Absolute, 1e-8: the upper end is drawn 1e-9 of the axis higher.
        let apart =
            ticks.iter().zip(0_u32..).map(|((share, _), k)| (share - 0.25 * f64::from(k)).abs());
        assert!(ticks.len() == 5 && apart.fold(0.0, f64::max) < 1e-8, "{ticks:?}");
    }

    #[test]
    fn a_step_is_the_widest_with_five_ticks_beyond_the_first() {
        // At 60 ten fit six times, at 25 five and at 10 two fit five times, and count.
        for (to, step) in [(6.0, 1.0), (60.0, 10.0), (25.0, 5.0), (10.0, 2.0), (7.0, 1.0)] {
            assert_eq!(Axis::from_zero("x", to), Axis::new("x", 0.0, to, step));
        }
        assert_eq!(Axis::around("x", 20.0, 45.0), Axis::new("x", 20.0, 45.0, 5.0));
        for nothing in [0.0, -1.0, f64::INFINITY, f64::NAN] {
            assert_eq!(Axis::from_zero("x", nothing), Axis::from_zero("x", 1.0));
        }
    }

    #[test]
    fn a_value_stands_by_its_logarithm() {
        let axis = Axis::logarithmic("error", 1e-3, 1e2);
        // √10 · 10⁻² is 1.5 of the 5 decades above the lower end. Absolute, 1e-8: the upper end is
        // drawn 1e-9 of the axis higher.
        let share = axis.share(1e-2 * 10.0_f64.sqrt()).unwrap();
        assert!((share - 0.3).abs() < 1e-8, "{share}");
        for nowhere in [0.0, -2.3, f64::NAN, f64::INFINITY] {
            assert_eq!(axis.share(nowhere), None, "{nowhere}");
        }
        assert!(Axis::new("x", 0.0, 7.0, 1.0).share(-2.3).is_some());
    }

    #[test]
    fn minor_ticks_are_two_to_nine_times_each_power() {
        let axis = Axis::logarithmic("work", 30.0, 600.0);
        let expected: Vec<f64> = [30, 40, 50, 60, 70, 80, 90, 200, 300, 400, 500, 600]
            .map(|n| axis.share(n.into()).unwrap())
            .into();
        let ticks = axis.minor_ticks();
        assert_eq!(ticks.len(), expected.len(), "{ticks:?}");
        // Largest deviation, 1e-12: log₁₀ of a product against the sum of two, of numbers below 3.
        let apart = ticks.iter().zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-12, "{apart}");
        assert_eq!(Axis::new("x", 0.0, 7.0, 1.0).minor_ticks(), [0.0; 0]);
    }
}
