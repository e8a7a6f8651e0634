//! How variants are drawn, the same in every picture.

use super::super::times::ENGINE;
use crate::plot::{Colour, Mark, Style};

/// Colour and mark say how a run is made; they are filled and their line is solid with engineering
/// strain, open and dashed with eqn (4).
pub fn look(contestant: &str) -> (Colour, Style) {
    use {Colour::*, Mark::*};
    if contestant == ENGINE {
        return (Black, Style::MarkedDashed(Square));
    }
    let (measure, way) = contestant.split_once(", ").unwrap_or(("", contestant));
    let (colour, mark) = match way {
        "α = 1" => (Blue, Circle),
        "α = 0.95" => (Sky, Plus),
        "α = 0.5" => (Green, Square),
        "α = 0.5, viscous" => (Vermillion, Triangle),
        "α = 0.95, viscous" => (Sky, Triangle),
        "α = 1, printed" => (Purple, Diamond),
        "α = 1, f32" => (Orange, Diamond),
        "α = 1, no flags" => (Grey, Plus),
        "α = 1, 106 bits" => (Grey, Cross),
        _ => (Black, Cross),
    };
    let style =
        if measure == "engineering" { Style::Marked(mark) } else { Style::MarkedDashed(mark) };
    (colour, style)
}
