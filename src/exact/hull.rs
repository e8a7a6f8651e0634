//! The concave or convex hull of a polynomial law between two strains: its fans and shocks.
//!
//! A loading wave follows the least concave function above T, an unloading one the greatest convex
//! function below it. Either touches T only along the *arcs* on which T itself bends that way, and
//! at the two end points. Between two arcs it is the straight *bridge* that touches both. The bridge
//! is found by its slope m: where T(x) − mx is extreme on either arc is a matter of T′ = m alone,
//! and the chord between these two points falls below m as m grows, so bisection cannot fail.

use super::elastic::Elastic;
use super::polynomial::Polynomial;
use super::root::first_where;
use super::wave::{Kind, Piece};

/// An interval of strain on which T bends as the hull does; a point where an end is none such.
#[derive(Debug, Clone, Copy)]
struct Arc {
    low: f64,
    high: f64,
}

/// The chord that touches two arcs, at `low` and at `high`.
#[derive(Debug, Clone, Copy)]
struct Bridge {
    low: f64,
    high: f64,
    slope: f64,
}

/// Whether the hull is the concave one, of a loading wave.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Concave(bool);

impl Concave {
    /// Whether `a` comes before `b` when slopes are taken in the order of increasing strain.
    fn precedes(self, a: f64, b: f64) -> bool {
        if self.0 { a > b } else { a < b }
    }
}

/// The wave from strain `from` to strain `to`, in the order of decreasing speed.
pub(super) fn pieces(law: &Polynomial, from: f64, to: f64) -> Vec<Piece> {
    let (low, high) = (from.min(to), from.max(to));
    let concave = Concave(to >= from);
    let mut hull: Vec<(Arc, Option<Bridge>)> = Vec::new();
    for arc in arcs(law, low, high, concave) {
        let mut bridge = None;
        while let Some((last, before)) = hull.last() {
            let new = bridged(law, *last, arc, concave);
            // Where the slopes are out of order the arc between the two bridges is not on the hull.
            if before.is_some_and(|before| !concave.precedes(before.slope, new.slope)) {
                hull.pop();
            } else {
                bridge = Some(new);
                break;
            }
        }
        hull.push((arc, bridge));
    }

    let mut pieces = Vec::new();
    let mut reached = low;
    let mut piece = |kind, until: f64| {
        if until > reached {
            pieces.push(if concave.0 {
                law.piece(kind, reached, until)
            } else {
                law.piece(kind, until, reached)
            });
        }
        reached = until;
    };
    for bridge in hull.iter().filter_map(|(_, bridge)| *bridge) {
        piece(Kind::Fan, bridge.low);
        piece(Kind::Shock, bridge.high);
    }
    piece(Kind::Fan, high);
    if !concave.0 {
        pieces.reverse();
    }
    pieces
}

/// The arcs between two strains, in order, with a point at an end that lies on none.
fn arcs(law: &Polynomial, low: f64, high: f64, concave: Concave) -> Vec<Arc> {
    let inside = law.inflections().iter().copied().filter(|&x| low < x && x < high);
    let mut arcs = Vec::new();
    let mut start = low;
    for end in inside.chain([high]) {
        let bend = law.curvature(start + (end - start) / 2.0);
        // T′ falls where the hull is concave, and rises where it is convex.
        if concave.precedes(0.0, bend) {
            arcs.push(Arc { low: start, high: end });
        } else {
            if start == low {
                arcs.push(Arc { low, high: low });
            }
            if end == high {
                arcs.push(Arc { low: high, high });
            }
        }
        start = end;
    }
    arcs
}

/// The bridge between two arcs, the first at the lower strains.
fn bridged(law: &Polynomial, first: Arc, second: Arc, concave: Concave) -> Bridge {
    // The point of an arc from which on its slope is past m.
    let touching = |arc: Arc, m: f64| {
        let past = |x: f64| !concave.precedes(law.tangent_modulus(x), m);
        if past(arc.low) { arc.low } else { first_where(arc.low, arc.high, past) }
    };
    let chord = |m: f64| law.chord(touching(first, m), touching(second, m));
    let slope = first_where(0.0, f64::MAX, |m| chord(m) <= m);
    Bridge { low: touching(first, slope), high: touching(second, slope), slope }
}

#[cfg(test)]
mod tests;
