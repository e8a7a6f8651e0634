//! The order of the events of a trace.

use crossfibre::place::{Fibre, Place};

/// Which evaluation an event is of: what two traces are aligned by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct At {
    /// Step, fibre, node or element.
    pub place: Place,
    /// The number of the equation on the page.
    pub equation: u8,
}

/// Where in the paper's order an evaluation stands. In a trace ranks rise strictly, so no evaluation
/// is there twice.
///
/// It is compared field by field:
///
/// 1. the step, from 1;
/// 2. the stage of the step: the primary fibre, the projectile (8), the secondary fibre. Where both
///    fibres are at the impact point, (8) feels both tensions and comes last;
/// 3. the element of the recursion. Element i is the turn of (4)–(7) with index i, and of (2) and
///    (15)–(18) with index i + 1, the node at its far end. (9)–(14), with index 0, begin element 0 of
///    the secondary;
/// 4. the equation: (11), (9), (10), (12), (13), (14), then (2), (15), (16), (17), (18), then (5),
///    (6), (4), (7).
///
/// That the march keeps to it is tested with every shipped scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Rank {
    step: u64,
    stage: Stage,
    element: usize,
    turn: u8,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Stage {
    Primary,
    Projectile,
    Secondary,
    ProjectileOfBoth,
}

impl Rank {
    /// The rank of an evaluation, in a scene whose fibres are both at the impact point or not; none
    /// for an equation that has no place in a step, or not there.
    pub fn of(at: At, both_at_impact: bool) -> Option<Self> {
        let At { place: Place { step, fibre, index }, equation } = at;
        let along = match fibre {
            Fibre::Primary => Stage::Primary,
            Fibre::Secondary => Stage::Secondary,
        };
        let (stage, element, turn) = match (equation, fibre) {
            (11, Fibre::Secondary) if index == 0 => (along, 0, 0),
            (9 | 10, Fibre::Secondary) if index == 0 => (along, 0, equation - 8),
            (12..=14, Fibre::Secondary) if index == 0 => (along, 0, equation - 9),
            (2, _) => (along, index.checked_sub(1)?, 6),
            (15..=18, Fibre::Primary) => (along, index.checked_sub(1)?, equation - 8),
            (5 | 6, _) => (along, index, equation + 6),
            (4, _) => (along, index, 13),
            (7, _) => (along, index, 14),
            (8, Fibre::Primary) if index == 0 && both_at_impact => (Stage::ProjectileOfBoth, 0, 0),
            (8, Fibre::Primary) if index == 0 => (Stage::Projectile, 0, 0),
            _ => return None,
        };
        (step > 0).then_some(Self { step, stage, element, turn })
    }
}

#[cfg(test)]
mod tests {
    use crossfibre::discretisation::Discretisation;
    use crossfibre::march;
    use crossfibre::paper::Paper;
    use crossfibre::result::{WithPaper, with_paper};
    use crossfibre::scene::{Scene, Strain};
    use crossfibre::state::{State, Wavefront};
    use crossfibre::trace::{Event, Traced};

    use super::*;
    use crate::cases::support::{SCENES, shipped};

    struct Ranks<'a>(&'a Scene);

    impl WithPaper<f64> for Ranks<'_> {
        type Out = u64;

        fn with(self, paper: &impl Paper<f64>) -> u64 {
            let mesh = Discretisation::<f64>::of(self.0);
            let both = mesh.secondary.is_some_and(|crossing| crossing.node == 0);
            let (mut last, mut events) = (None, 0);
            let traced = Traced::new(paper, |event: &Event<'_, f64>| {
                let at = At { place: event.place, equation: event.equation };
                let rank = Rank::of(at, both);
                assert!(rank.is_some() && rank > last, "{at:?}: {rank:?} after {last:?}");
                last = rank;
                events += 1;
            });
            let mut state = State::at_impact(self.0, Wavefront::Flagged);
            march::run(&traced, &mut state, mesh.steps(self.0.duration), |_| ());
            events
        }
    }

    #[test]
    fn ranks_rise_in_a_trace_of_every_shipped_scene_by_either_strain() {
        for (name, _) in SCENES {
            for strain in [Strain::Incremental, Strain::Engineering] {
                for mass in [None, Some(0.00091)] {
                    let mut scene = Scene { strain, ..shipped(name) };
                    scene.projectile.mass = mass;
                    let events = with_paper(&scene, Ranks(&scene));
                    assert!(events > 1000, "{name}: {events}");
                }
            }
        }
    }

    #[test]
    fn what_has_no_place_in_a_step_has_no_rank() {
        let rank = |equation, fibre, index| {
            Rank::of(At { place: Place { step: 7, fibre, index }, equation }, false)
        };
        let (primary, secondary) = (Fibre::Primary, Fibre::Secondary);
        for equation in [0, 1, 3, 19, 20, 21] {
            assert_eq!(rank(equation, primary, 0), None);
            assert_eq!(rank(equation, secondary, 3), None);
        }
        assert_eq!(rank(2, primary, 0), None); // the driven node has no (2)
        assert_eq!(rank(8, primary, 1), None);
        assert_eq!(rank(8, secondary, 0), None);
        assert_eq!(rank(12, primary, 0), None);
        assert_eq!(rank(12, secondary, 1), None);
        assert_eq!(rank(17, primary, 0), None);
        assert_eq!(rank(17, secondary, 5), None);
        let at_rest = Place { step: 0, fibre: primary, index: 3 };
        assert_eq!(Rank::of(At { place: at_rest, equation: 4 }, false), None);
    }

    #[test]
    fn what_is_of_the_first_node_alone_is_of_no_other() {
        let rank = |equation, fibre, index| {
            let both_at_impact = true;
            Rank::of(At { place: Place { step: 7, fibre, index }, equation }, both_at_impact)
        };
        for (equation, fibre) in [
            (8, Fibre::Primary),
            (9, Fibre::Secondary),
            (10, Fibre::Secondary),
            (11, Fibre::Secondary),
            (12, Fibre::Secondary),
            (14, Fibre::Secondary),
        ] {
            assert!(rank(equation, fibre, 0).is_some(), "{equation}");
            assert_eq!(rank(equation, fibre, 1), None, "{equation}");
        }
    }
}
