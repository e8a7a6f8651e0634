//! What is left out, what bounds the work, and where the motion ends.

use super::*;

#[test]
fn looking_on_the_way_changes_nothing() {
    for problem in [paper(), unequal()] {
        let straight = at(&problem, 1e-9, 51.3e-6);
        let mut halting = Fronts::new(&problem, straight.limits());
        for time in [3.1e-6, 28.7e-6, 28.7e-6, 11.0e-6, 47.9e-6, 51.3e-6] {
            let before = halting.time();
            halting.advance(time).unwrap();
            assert_eq!(halting.time(), time.max(before));
        }
        // Bit for bit.
        for fibre in [Fibre::Primary, Fibre::Secondary] {
            assert_eq!(halting.segments(fibre), straight.segments(fibre));
        }
        assert_eq!(halting.accounts(), straight.accounts());
        assert_eq!(halting.error_bound(), straight.error_bound());
        assert_eq!(halting.events(), straight.events());
    }
}

/// The same motion, begun from the uniform pieces that it consists of now.
fn begun_anew(problem: &Problem<Line>, before: &Fronts<Line>) -> Fronts<Line> {
    let mut anew = Fronts::new(problem, before.limits());
    anew.time = before.time;
    let at = problem.secondary.as_ref().unwrap().at;
    let primary = before.segments(Fibre::Primary);
    let inner = primary.iter().filter(|s| s.from < at);
    let outer = primary.iter().filter(|s| s.from >= at);
    let secondary = before.segments(Fibre::Secondary);
    let pieces = |offset: f64, segment: &Segment| (segment.from - offset, segment.state);
    let spans: [Vec<_>; 3] = [
        inner.map(|s| pieces(0.0, s)).collect(),
        outer.map(|s| pieces(at, s)).collect(),
        secondary.iter().map(|s| pieces(0.0, s)).collect(),
    ];
    for (span, pieces) in anew.spans.iter_mut().zip(&spans) {
        span.set(pieces, before.time, before.limits().resolution);
    }
    anew.held(0, Meeting::Start, anew.velocity).unwrap();
    anew.crossover().unwrap();
    anew
}

#[test]
fn motion_begun_anew_from_any_moment_is_the_same() {
    for (problem, resolution) in [(paper(), 1e-12), (unequal(), 1e-10)] {
        for begun in [7.3e-6, 28.7e-6, 38.3e-6] {
            let before = at(&problem, resolution, begun);
            let mut anew = begun_anew(&problem, &before);
            // Every jump is solved into itself, but for what it was left short of.
            let short = anew.error_bound();
            assert!(short <= 0.1 * before.error_bound() + 1e-16, "{begun:e}: {short:e}");
            anew.advance(44.1e-6).unwrap();
            let through = at(&problem, resolution, 44.1e-6);
            let bound = anew.error_bound() + through.error_bound() + 1e-15;
            for fibre in [Fibre::Primary, Fibre::Secondary] {
                let difference = difference(&anew, &through, fibre);
                assert!(difference <= bound, "{begun:e}: {difference:e} {bound:e}");
            }
        }
    }
}

#[test]
fn difference_from_a_finer_resolution_is_within_the_bound() {
    for (problem, time) in [(paper(), 60e-6), (unequal(), 51e-6)] {
        let finest = at(&problem, 1e-11, time);
        for resolution in [1e-7, 1e-8, 1e-9, 1e-10] {
            let coarse = at(&problem, resolution, time);
            assert!(coarse.events() < finest.events());
            let bound = coarse.error_bound();
            for fibre in [Fibre::Primary, Fibre::Secondary] {
                let found = difference(&coarse, &finest, fibre);
                // Measured: a 5th to a 40th of the bound. Less than a 100th and the bound would
                // be counting something else.
                assert!(found < bound / 3.0 && found > bound / 100.0, "{found:e} {bound:e}");
            }
        }
    }
}

#[test]
fn finer_resolution_costs_more_and_leaves_out_less() {
    // A tenth of the resolution: about three times the meetings, about a fifth of the bound.
    let runs = [1e-7, 1e-8, 1e-9, 1e-10].map(|resolution| at(&paper(), resolution, 60e-6));
    for pair in runs.windows(2) {
        let cost = pair[1].events() as f64 / pair[0].events() as f64;
        let gain = pair[0].error_bound() / pair[1].error_bound();
        assert!((1.8..4.0).contains(&cost) && (3.0..8.0).contains(&gain), "{cost} {gain}");
    }
}

#[test]
fn too_many_meetings_end_the_motion_and_a_solution_is_found_all_the_same() {
    let mut fronts = Fronts::new(&paper(), Limits { resolution: 1e-12, events: 100 });
    let Err(Ended::TooMany { time, events: 100 }) = fronts.advance(60e-6) else {
        panic!("{:?}", fronts.ended());
    };
    assert_eq!((fronts.events(), fronts.time()), (100, time));
    // From then on it stays as it is.
    let left = fronts.segments(Fibre::Primary);
    assert_eq!(fronts.advance(60e-6), Err(Ended::TooMany { time, events: 100 }));
    assert_eq!(fronts.segments(Fibre::Primary), left);
    // 1e-11 would take 11297.
    let found = solved(&paper(), 60e-6);
    assert_eq!((found.limits().resolution, found.time()), (1e-10, 60e-6));
    let found = solved(&paper(), 90e-6);
    assert!(found.limits().resolution > 1e-10 && found.ended().is_none());
}

#[test]
fn coarser_resolutions_are_tried_one_after_the_other_down_to_the_last() {
    let tried = std::cell::RefCell::new(Vec::new());
    let attempt = |limits: Limits, events| {
        tried.borrow_mut().push(limits.resolution);
        assert_eq!(limits.events, 20_000);
        let mut fronts = Fronts::new(&paper(), Limits { events, ..limits });
        let _ = fronts.advance(20e-6);
        fronts
    };
    let found = finest(|limits| attempt(limits, 0));
    assert!(matches!(found.ended(), Some(Ended::TooMany { events: 0, .. })));
    assert_eq!(tried.take(), [1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4]);
    // The first that can be followed to its end is taken.
    let found = finest(|limits| attempt(limits, if limits.resolution < 5e-9 { 0 } else { 1_000 }));
    assert_eq!((tried.take(), found.ended()), (vec![1e-10, 1e-9, 1e-8], None));
}

#[test]
fn what_is_left_out_grows_from_meeting_to_meeting() {
    let mut short = unequal();
    short.secondary.as_mut().unwrap().fibre.length = 0.0071;
    let mut at_origin = unequal();
    at_origin.secondary.as_mut().unwrap().at = 0.0;
    for problem in [paper(), short, at_origin, alone(0.3)] {
        let mut fronts = Fronts::new(&problem, Limits { resolution: 1e-5, events: 3_000 });
        let (mut bound, mut grown) = (fronts.error_bound(), 0);
        while fronts.ended().is_none() && fronts.time() < 150e-6 {
            let (next, _) = fronts.next().1;
            let before = fronts.events();
            // Some end early, by a fibre that goes slack.
            if fronts.advance(next).is_err() {
                break;
            }
            assert!(fronts.events() > before && fronts.time() == next);
            assert!(fronts.error_bound() >= bound, "{next:e}: {} {bound}", fronts.error_bound());
            grown += u32::from(fronts.error_bound() > bound);
            bound = fronts.error_bound();
            let segments = [Fibre::Primary, Fibre::Secondary].map(|f| fronts.segments(f));
            assert!(segments.iter().flatten().all(|s| s.to > s.from), "{next:e}");
        }
        assert!(grown > 3, "{grown} of {}", fronts.events());
    }
}

#[test]
fn waves_left_out_in_sum_as_strong_as_the_impact_end_the_motion() {
    // A third of the strain of the impact is left out wherever it could be.
    let problem = unequal();
    let strain = Fronts::new(&problem, Limits { resolution: 1e-9, events: 1 }).impact_strain;
    let limits = Limits { resolution: strain / 3.0, events: 100_000 };
    let mut fronts = Fronts::new(&problem, limits);
    let Err(Ended::Unresolved { time }) = fronts.advance(3.0) else {
        panic!("{:?} {}", fronts.ended(), fronts.error_bound());
    };
    assert_eq!(time, fronts.time());
    assert!(fronts.error_bound() > strain && fronts.error_bound() < 2.0 * strain);
}

#[test]
fn braking_is_the_impulse_of_both_halves_until_the_clamps_answer() {
    let mut at_origin = unequal();
    at_origin.secondary.as_mut().unwrap().at = 0.0;
    for problem in [paper(), unequal(), at_origin, alone(0.3)] {
        // Half of 5.1 µs is less than a wave takes to the nearest clamp; the force changes meanwhile.
        let mut fronts = at(&problem, 1e-9, 2.7e-6);
        fronts.strike(0.93 * problem.velocity);
        fronts.advance(5.1e-6).unwrap();
        let accounts = fronts.accounts();
        // The projectile alone acts on the half of the system, along y; four roundings.
        let halves = 2.0 * accounts.impulse.y;
        assert!(halves > 0.0 && (accounts.braking / halves - 1.0).abs() < 1e-15, "{accounts:?}");
    }
}

#[test]
fn fibre_that_goes_slack_at_its_clamp_is_told_to_do_so_there() {
    let mut fronts = Fronts::new(&paper(), Limits { resolution: 1e-9, events: 100 });
    // A clamp that runs towards the crossover, span 1 of the primary.
    let found = fronts.held(1, Meeting::End, Vector3::new(-31.7, 0.0, 0.0));
    assert_eq!(found, Err(Ended::Slack { fibre: Fibre::Primary, at: 0.3, time: 0.0 }));
}

#[test]
fn fibre_that_goes_slack_where_two_waves_meet_is_told_to_do_so_there() {
    // Two unloading waves of 0.65 of the strain each: one leaves the fibre taut, both do not.
    let problem = paper();
    let c = (ARAMID.modulus / ARAMID.density).sqrt();
    let piece = |velocity: f64| {
        let velocity = Vector3::new(1.3 * c * 0.0137 * velocity, 0.0, 0.0);
        State { strain: 0.0137, direction: Vector3::x(), velocity }
    };
    let mut fronts = Fronts::new(&problem, Limits { resolution: 1e-9, events: 100 });
    // On the outer primary, from 0.1 m on; from the struck end and the clamp waves have farther to go.
    fronts.spans[1].set(&[(0.0, piece(1.0)), (0.06, piece(0.0)), (0.12, piece(-1.0))], 0.0, 1e-9);
    let Err(Ended::Slack { fibre, at, time }) = fronts.advance(10e-6) else {
        panic!("{:?}", fronts.ended());
    };
    // Two roundings.
    assert_eq!(fibre, Fibre::Primary);
    assert!(
        (at / 0.19 - 1.0).abs() < 4e-16 && (time * c / 0.03 - 1.0).abs() < 4e-16,
        "{at} {time}"
    );
}

#[test]
fn all_that_is_left_out_at_the_crossover_is_counted() {
    let problem = paper();
    let law = crate::exact::smith::Law::Engineering;
    let fibre = crate::exact::smith::Fibre { modulus: 58.6e9, density: 1206.7, area: 1e-6 };
    let closed = crate::exact::crossover::crossover(law, &fibre, &fibre, 1.0, 400.0).unwrap();
    let mut fronts = Fronts::new(&problem, Limits { resolution: 1e-12, events: 100 });
    let bound = fronts.error_bound();
    // From now on more than what is reflected into the primary or diverted into the secondary, and less
    // than what is transmitted or the kink of the secondary.
    fronts.limits.resolution = 0.003;
    fronts.advance(14.4e-6).unwrap();
    let left_out = closed.engineering.reflection + closed.engineering.diversion;
    let counted = fronts.error_bound() - bound;
    // Differences of strains that are 70 times as great.
    let expected = left_out * closed.incident.strain.engineering;
    assert!((counted / expected - 1.0).abs() < 1e-13, "{counted} {expected}");
}

#[test]
fn projectile_that_stops_at_once_lets_a_steep_fibre_go_slack() {
    // At 1.37 c the fibre stands at sin γ = 0.98 behind the projectile; stopped, it would have to
    // unload by V sin γ, more than cε.
    let problem = Problem { velocity: 9547.0, ..alone(0.3) };
    let mut fronts = Fronts::new(&problem, Limits { resolution: 1e-9, events: 100 });
    fronts.advance(13.7e-6).unwrap();
    let State { strain, direction, .. } = state(&fronts, Fibre::Primary, 0.0);
    assert!(-9547.0 * direction.y > 6968.6 * strain);
    let mut slower = fronts.clone();
    fronts.strike(0.0);
    let slack = Ended::Slack { fibre: Fibre::Primary, at: 0.0, time: 13.7e-6 };
    assert_eq!((fronts.ended(), fronts.advance(20e-6)), (Some(slack), Err(slack)));
    assert_eq!(slack.to_string(), "the primary fibre goes slack at 0.000000 m, 13.7000 µs");
    // Slowed down by less than the fibre can give way, it stays taut.
    slower.strike(7547.0);
    assert_eq!(slower.advance(14.7e-6), Ok(()));
}

#[test]
fn short_stiff_secondary_throws_the_crossover_into_the_outer_primary() {
    let mut problem = paper();
    let across = problem.secondary.as_mut().unwrap();
    across.fibre.length = 0.02;
    across.fibre.material.modulus *= 10.0;
    for resolution in [1e-5, 1e-6] {
        let mut fronts = Fronts::new(&problem, Limits { resolution, events: 20_000 });
        let Err(Ended::Slack { fibre, at, time }) = fronts.advance(60e-6) else {
            panic!("{:?}", fronts.ended());
        };
        // The time only as far as the two resolutions agree: a kink of the secondary returns after
        // a thousand meetings. Before it, the outer primary is at rest but for its unloading.
        assert_eq!((fibre, at), (Fibre::Primary, 0.1));
        assert!((time - 45.5e-6).abs() < 0.3e-6, "{time:e}");
    }
}

#[test]
fn kink_that_reaches_a_sliding_crossover_ends_the_motion() {
    let mut problem = paper();
    problem.secondary.as_mut().unwrap().slide_factor = 0.5;
    let mut fronts = Fronts::new(&problem, Limits { resolution: 1e-7, events: 20_000 });
    fronts.record();
    let Err(Ended::SlidesOnKink { time }) = fronts.advance(200e-6) else {
        panic!("{:?}", fronts.ended());
    };
    let arrived = |track: &Track| {
        let there = (track.to.0 - 0.1).abs() < 1e-9 && (track.to.1 - time).abs() < 1e-12;
        there && track.fibre == Fibre::Primary && track.family == Family::Kink
    };
    assert!(fronts.tracks().iter().any(arrived), "{time:e}");
    // Without sliding it goes on.
    problem.secondary.as_mut().unwrap().slide_factor = 1.0;
    at(&problem, 1e-6, time + 10e-6);
}

#[test]
fn front_that_follows_another_closely_is_merged_into_its_reflection_and_counted() {
    let problem = alone(0.3);
    let delta = 1e-6;
    let mut fronts = Fronts::new(&problem, Limits { resolution: delta, events: 100 });
    // A second, weaker step of the velocity, 0.7 mm behind the first.
    fronts.advance(0.1e-6).unwrap();
    fronts.strike(412.0);
    fronts.advance(42.9e-6).unwrap();
    let segments = fronts.segments(Fibre::Primary);
    let [.., before, behind, ahead] = &segments[..] else { panic!("{segments:?}") };
    assert_eq!(ahead.state.strain, 0.0);
    let (strength, distance) =
        ((before.state.strain - behind.state.strain).abs(), behind.to - behind.from);
    assert!(strength > 10.0 * delta && strength * distance < delta * 0.3);
    let bound = fronts.error_bound();
    fronts.advance(43.1e-6).unwrap();
    let counted = fronts.error_bound() - bound;
    // Strains of 1e-5 out of 1e-2: three digits less.
    assert!((counted / (strength * distance / 0.3) - 1.0).abs() < 1e-9, "{counted:e}");
    // Both were reflected at once, doubled.
    let doubled = state(&fronts, Fibre::Primary, 0.2999).strain;
    assert!((doubled / (2.0 * before.state.strain) - 1.0).abs() < 1e-13);
}

#[test]
fn ways_of_fronts_begin_where_others_end() {
    let problem = unequal();
    let mut fronts = Fronts::new(&problem, Limits { resolution: 1e-8, events: 10_000 });
    fronts.record();
    fronts.advance(63e-6).unwrap();
    let tracks = fronts.tracks();
    for ended in tracks.iter().filter(|track| track.to.1 < fronts.time()) {
        let (x, time) = ended.to;
        // Merged from at most so far.
        let near = 1e-8 * 0.317 / ended.strength + 1e-12;
        let goes_on = |next: &&Track| {
            let (from, made) = next.from;
            next.fibre == ended.fibre && made == time && (from - x).abs() <= near
        };
        assert!(tracks.iter().any(|track| goes_on(&track)), "{ended:?}");
    }
    // Beyond the crossover fronts have met each other.
    let beyond = |track: &&Track| track.to.0 > 0.084 && track.to.0 < 0.316;
    assert!(tracks.iter().filter(beyond).count() > 10);
}
