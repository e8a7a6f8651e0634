use proptest::prelude::*;
use pxfm::f_exp10;

use super::*;

mod balances;
mod figure_3;
mod polygons;
mod resolution;
mod single;

const ARAMID: Line = Line { modulus: 58.6e9, density: 1206.7 };

/// The paper's scene.
fn paper() -> Problem<Line> {
    Problem {
        primary: Clamped { material: ARAMID, area: 1e-6, length: 0.3 },
        secondary: Some(Across {
            fibre: Clamped { material: ARAMID, area: 1e-6, length: 0.2 },
            at: 0.1,
            slide_factor: 1.0,
        }),
        velocity: 400.0,
    }
}

/// Unequal fibres without a common measure.
fn unequal() -> Problem<Line> {
    Problem {
        primary: Clamped { material: ARAMID, area: 0.91e-6, length: 0.317 },
        secondary: Some(Across {
            fibre: Clamped {
                material: Line { modulus: 91.3e9, density: 1713.0 },
                area: 1.37e-6,
                length: 0.141,
            },
            at: 0.083,
            slide_factor: 1.0,
        }),
        velocity: 311.7,
    }
}

fn alone(length: f64) -> Problem<Line> {
    Problem { primary: Clamped { length, ..paper().primary }, secondary: None, velocity: 411.3 }
}

fn at(problem: &Problem<Line>, resolution: f64, time: f64) -> Fronts<Line> {
    let mut fronts = Fronts::new(problem, Limits { resolution, events: 100_000 });
    fronts.advance(time).unwrap();
    fronts
}

/// The state of a fibre at a place.
fn state<M: PiecewiseLinear>(fronts: &Fronts<M>, fibre: Fibre, at: f64) -> State {
    let segments = fronts.segments(fibre);
    segments.iter().find(|s| s.from <= at && at < s.to).unwrap().state
}

/// ∫f dX over a fibre.
fn total<M: PiecewiseLinear>(
    fronts: &Fronts<M>,
    fibre: Fibre,
    f: impl Fn(&State) -> Vector3<f64>,
) -> Vector3<f64> {
    fronts.segments(fibre).iter().map(|s| f(&s.state) * (s.to - s.from)).sum()
}

/// The mean of |difference of strain| along a fibre.
fn difference<M: PiecewiseLinear>(a: &Fronts<M>, b: &Fronts<M>, fibre: Fibre) -> f64 {
    let (a, b) = (a.segments(fibre), b.segments(fibre));
    let (mut i, mut j, mut from, mut sum) = (0, 0, 0.0, 0.0);
    while i < a.len() && j < b.len() {
        let to = a[i].to.min(b[j].to);
        sum += (to - from) * (a[i].state.strain - b[j].state.strain).abs();
        from = to;
        if a[i].to <= to {
            i += 1;
        }
        if b[j].to <= to {
            j += 1;
        }
    }
    sum / from
}

prop_compose! {
    /// Two unequal fibres of lengths without a common measure, ratios in decades up to `decades`.
    fn scenes(decades: f64)(
        (m, d, a) in (-decades..decades, -decades..decades, -decades..decades),
        (lengths, across) in (1.3..4.0_f64, 0.3..3.0_f64),
        at in 0.03..0.2_f64,
        (slide, slides) in (-3.0..0.0_f64, any::<bool>()),
        impact in -2.0..-0.5_f64,
    ) -> Problem<Line> {
        let (modulus, density) = (ARAMID.modulus * f_exp10(m), ARAMID.density * f_exp10(d));
        let c = (ARAMID.modulus / ARAMID.density).sqrt();
        Problem {
            primary: Clamped { material: ARAMID, area: 0.91e-6, length: at * lengths },
            secondary: Some(Across {
                fibre: Clamped {
                    material: Line { modulus, density },
                    area: 0.91e-6 * f_exp10(a),
                    length: at * across,
                },
                at,
                slide_factor: if slides { f_exp10(slide) } else { 1.0 },
            }),
            velocity: c * f_exp10(impact),
        }
    }
}
