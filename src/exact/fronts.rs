//! The crossed fibres at any time, exactly: every front followed from meeting to meeting.
//!
//! For T = Eε (engineering strain) all waves of a string are linearly degenerate: a jump stays a
//! jump, longitudinal fronts run at c and kinks at c√(ε/(1 + ε)) in the Lagrangian coordinate,
//! and between them the fibre is uniform. So the whole motion is a list of fronts, and whenever
//! two of them meet, or one reaches an end or the crossover, a Riemann problem
//! ([`riemann`]) says what leaves. Waves weaker than a stated strength are left
//! out; the sum of what was left out is the solution's own
//! [error](Fronts::error_bound).
//!
//! A [`Polygon`] in place of the straight line gives converging approximations of a concave law.
//! Derivation, range and tests: `docs/exact/fronts.md`.

use nalgebra::Vector3;

use super::riemann::{self, Arm, Crossing, RiemannError, State};
use crate::place::Fibre;
use span::{Front, Meeting, Resolution, Span};

pub use ended::Ended;
pub use material::{Line, PiecewiseLinear, Polygon};
pub use outgoing::Family;
pub use problem::{Across, Clamped, Problem};

mod ended;
mod material;
mod outgoing;
mod problem;
mod span;

/// What bounds the work.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Strength (in strain) below which a wave is left out, and strength times distance (over the
    /// length of the fibre) up to which a front is taken into a meeting beside it.
    pub resolution: f64,
    /// The most meetings of fronts, which also bounds the fronts: on a straight-line law four leave
    /// a meeting of two, six the crossover.
    pub events: u64,
}

/// A uniform piece of a fibre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// Where it begins, unstrained, m from the impact point (the crossover).
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// Its state; the direction is that of increasing coordinate.
    pub state: State,
}

/// The way of one front from its making to its end, or to now.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Track {
    /// On which fibre.
    pub fibre: Fibre,
    /// Longitudinal or kink.
    pub family: Family,
    /// (position in m, time in s) where it was made.
    pub from: (f64, f64),
    /// (position in m, time in s) where it ends.
    pub to: (f64, f64),
    /// Jump of strain, or of velocity over the longitudinal speed.
    pub strength: f64,
}

/// What the ends have done to the half of the system that is solved (x ≥ 0, all of z), so far.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Accounts {
    /// Impulse of projectile and clamps, N s.
    pub impulse: Vector3<f64>,
    /// Work of the projectile, J.
    pub work: f64,
    /// Impulse of all of both fibres against the projectile, N s.
    pub braking: f64,
}

/// The motion, solved up to a time.
#[derive(Debug, Clone)]
pub struct Fronts<M> {
    /// The primary; with a secondary at the origin, both; or the primary before and after the
    /// crossover, and the secondary.
    spans: Vec<Span<M>>,
    slide_factor: f64,
    velocity: Vector3<f64>,
    time: f64,
    events: u64,
    limits: Limits,
    left_out: f64,
    /// Strain that the impact gives.
    impact_strain: f64,
    tracks: Option<Vec<Track>>,
    /// Up to the last meeting.
    accounts: Accounts,
    /// When that was, s.
    settled: f64,
    ended: Option<Ended>,
}

/// The motion up to a time (s), or up to where it [ended](Fronts::ended), as [`finest`] resolves it.
pub fn solved<M: PiecewiseLinear + Clone>(problem: &Problem<M>, time: f64) -> Fronts<M> {
    finest(|limits| {
        let mut fronts = Fronts::new(problem, limits);
        // An early end is kept in the fronts.
        let _ = fronts.advance(time);
        fronts
    })
}

/// The motion at the finest resolution of 1e-10, 1e-9 … 1e-5 that takes no more than 20000 meetings of
/// fronts, or else at 1e-4.
pub fn finest<M>(run: impl Fn(Limits) -> Fronts<M>) -> Fronts<M> {
    let resolved = |resolution| run(Limits { resolution, events: 20_000 });
    let is_whole = |fronts: &Fronts<M>| !matches!(fronts.ended, Some(Ended::TooMany { .. }));
    let mut finer = [1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5].into_iter().map(resolved);
    finer.find(is_whole).unwrap_or_else(|| resolved(1e-4))
}

/// What holds a span at one of its ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Joint {
    Projectile,
    Crossover,
    Clamp,
}

impl<M: PiecewiseLinear + Clone> Fronts<M> {
    /// The moment of impact.
    pub fn new(problem: &Problem<M>, limits: Limits) -> Self {
        let along = |direction| State { strain: 0.0, direction, velocity: Vector3::zeros() };
        let (x, z) = (along(Vector3::x()), along(Vector3::z()));
        let piece = |fibre: &Clamped<M>, offset, length, state| {
            Span::at_rest(fibre.material.clone(), fibre.area, offset, length, state)
        };
        let primary = &problem.primary;
        let spans = match &problem.secondary {
            None => vec![piece(primary, 0.0, primary.length, x)],
            Some(across) if across.at == 0.0 => vec![
                piece(primary, 0.0, primary.length, x),
                piece(&across.fibre, 0.0, across.fibre.length, z),
            ],
            Some(across) => vec![
                piece(primary, 0.0, across.at, x),
                piece(primary, across.at, primary.length - across.at, x),
                piece(&across.fibre, 0.0, across.fibre.length, z),
            ],
        };
        let mut fronts = Self {
            spans,
            slide_factor: problem.secondary.as_ref().map_or(1.0, |across| across.slide_factor),
            velocity: Vector3::zeros(),
            time: 0.0,
            events: 0,
            limits,
            left_out: 0.0,
            impact_strain: 0.0,
            tracks: None,
            accounts: Accounts::default(),
            settled: 0.0,
            ended: None,
        };
        fronts.strike(problem.velocity);
        fronts.impact_strain = fronts.spans[0].start().strain;
        fronts
    }
}

impl<M: PiecewiseLinear> Fronts<M> {
    /// Writes down the way of every front from now on.
    pub fn record(&mut self) {
        self.tracks.get_or_insert_default();
    }

    /// Gives the projectile another velocity (m/s) from now on.
    pub fn strike(&mut self, velocity: f64) {
        self.settle();
        self.velocity = Vector3::new(0.0, velocity, 0.0);
        for span in 0..self.spans.len() {
            if self.joint(span, Meeting::Start) == Joint::Projectile {
                let held = self.held(span, Meeting::Start, self.velocity);
                self.ended = self.ended.or(held.err());
            }
        }
    }

    /// Goes on to a time, s, or to where the motion ends; a time that is past changes nothing.
    pub fn advance(&mut self, time: f64) -> Result<(), Ended> {
        while self.ended.is_none() {
            let (span, (next, meeting)) = self.next();
            if next > time {
                self.time = self.time.max(time);
                return Ok(());
            }
            self.time = next;
            self.settle();
            self.ended = self.event(span, meeting).err();
        }
        self.ended.map_or(Ok(()), Err)
    }

    fn event(&mut self, span: usize, meeting: Meeting) -> Result<(), Ended> {
        if self.events == self.limits.events {
            return Err(Ended::TooMany { time: self.time, events: self.events });
        }
        self.events += 1;
        if self.left_out > self.impact_strain {
            return Err(Ended::Unresolved { time: self.time });
        }
        match (meeting, self.joint(span, meeting)) {
            (Meeting::Fronts(index), _) => self.interior(span, index),
            (_, Joint::Projectile) => self.held(span, meeting, self.velocity),
            (_, Joint::Clamp) => self.held(span, meeting, Vector3::zeros()),
            (_, Joint::Crossover) => self.crossover(),
        }
    }

    /// Why the motion does not go on, if it does not.
    pub fn ended(&self) -> Option<Ended> {
        self.ended
    }

    /// The limits it was solved within.
    pub fn limits(&self) -> Limits {
        self.limits
    }

    /// The time reached, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Meetings of fronts so far.
    pub fn events(&self) -> u64 {
        self.events
    }

    /// Fronts on their way.
    pub fn fronts(&self) -> usize {
        self.spans.iter().map(|span| span.fronts().len()).sum()
    }

    /// The bound of the mean error of strain along a fibre: the strengths of all waves left out,
    /// and strength times distance over length of all fronts merged, summed up. What it is proved
    /// and measured to bound: `docs/exact/fronts.md`.
    pub fn error_bound(&self) -> f64 {
        self.left_out
    }

    /// Impulse and work so far.
    pub fn accounts(&self) -> Accounts {
        let mut accounts = self.accounts;
        let elapsed = self.time - self.settled;
        accounts.braking += self.resistance() * elapsed;
        for (index, span) in self.spans.iter().enumerate() {
            if self.joint(index, Meeting::Start) == Joint::Projectile {
                let force = -tension(span, span.start());
                accounts.impulse += force * elapsed;
                accounts.work += force.dot(&self.velocity) * elapsed;
            }
            if self.joint(index, Meeting::End) == Joint::Clamp {
                // Two arms of a secondary within the half, the third span; what their mirror symmetry
                // cancels is along z. At the origin half of each arm belongs to the half.
                let arms = if index == 2 { 2.0 } else { 1.0 };
                accounts.impulse += tension(span, span.end()) * (arms * elapsed);
            }
        }
        accounts
    }

    /// The force that holds the projectile back now, from all of both fibres, N.
    pub fn resistance(&self) -> f64 {
        let struck = |index: &usize| self.joint(*index, Meeting::Start) == Joint::Projectile;
        let pull = |index: usize| tension(&self.spans[index], self.spans[index].start()).y;
        // Two halves of each fibre that the projectile holds.
        -2.0 * (0..self.spans.len()).filter(struck).map(pull).sum::<f64>()
    }

    /// The uniform pieces of a fibre now, from the impact point (the crossover) outward.
    pub fn segments(&self, fibre: Fibre) -> Vec<Segment> {
        let mut segments = Vec::new();
        for (_, span) in self.spans.iter().enumerate().filter(|(i, _)| self.fibre(*i) == fibre) {
            let mut pieces = span.pieces(self.time).peekable();
            while let Some((from, state)) = pieces.next() {
                let to = pieces.peek().map_or(span.length, |(next, _)| *next);
                let (from, to) = (span.offset + from, span.offset + to);
                if to > from {
                    segments.push(Segment { from, to, state });
                }
            }
        }
        segments
    }

    /// The ways of all fronts since [`Fronts::record`], those still on their way up to now.
    pub fn tracks(&self) -> Vec<Track> {
        let mut tracks = self.tracks.clone().unwrap_or_default();
        for (index, span) in self.spans.iter().enumerate() {
            let fibre = self.fibre(index);
            tracks.extend(span.fronts().iter().map(|f| track(fibre, span.offset, f, self.time)));
        }
        tracks
    }

    fn next(&self) -> (usize, (f64, Meeting)) {
        let mut next = (0, self.spans[0].next());
        for (index, span) in self.spans.iter().enumerate().skip(1) {
            if span.next().0 < next.1.0 {
                next = (index, span.next());
            }
        }
        next
    }

    fn fibre(&self, span: usize) -> Fibre {
        if span + 1 == self.spans.len() && span > 0 { Fibre::Secondary } else { Fibre::Primary }
    }

    fn joint(&self, span: usize, meeting: Meeting) -> Joint {
        match (self.spans.len(), span, meeting) {
            (3, 0, Meeting::End) | (3, 1 | 2, Meeting::Start) => Joint::Crossover,
            (_, _, Meeting::Start) => Joint::Projectile,
            _ => Joint::Clamp,
        }
    }

    fn resolution(&self, span: usize) -> Resolution {
        let reach = self.spans[span].offset + self.spans[span].length;
        let weakest = self.limits.resolution;
        Resolution { weakest, moment: weakest * reach, rounding: 1e-13 * reach }
    }

    /// Closes the accounts up to now, before a force changes: so that they do not depend on when
    /// somebody looks.
    fn settle(&mut self) {
        self.accounts = self.accounts();
        self.settled = self.time;
    }

    /// Fronts that meet within a span.
    fn interior(&mut self, span: usize, index: usize) -> Result<(), Ended> {
        let (time, resolution, fibre) = (self.time, self.resolution(span), self.fibre(span));
        let Self { spans, tracks, .. } = self;
        let offset = spans[span].offset;
        let at = offset + spans[span].fronts()[index].position(time);
        let ended = |front: &Front| write_down(tracks, fibre, offset, front, time);
        let met = spans[span]
            .meet(time, index, resolution, ended)
            .map_err(|error| beyond(error, fibre, at, time))?;
        self.left_out += met.left_out;
        taut(&met.arms, fibre, at, time)
    }

    /// A span one end of which is moved at a given velocity.
    fn held(&mut self, span: usize, end: Meeting, velocity: Vector3<f64>) -> Result<(), Ended> {
        let (time, resolution, fibre) = (self.time, self.resolution(span), self.fibre(span));
        let Self { spans, tracks, left_out, .. } = self;
        let span = &mut spans[span];
        let offset = span.offset;
        let ended = |front: &Front| write_down(tracks, fibre, offset, front, time);
        let (at, ahead) = if end == Meeting::Start {
            *left_out += span.absorb_at_start(time, resolution, ended);
            (offset, span.start())
        } else {
            *left_out += span.absorb_at_end(time, resolution, ended);
            (offset + span.length, span.end().reversed())
        };
        let arm = riemann::end(&span.material, ahead, velocity)
            .map_err(|error| beyond(error, fibre, at, time))?;
        *left_out += if end == Meeting::Start {
            span.emit_from_start(&arm, time, resolution.weakest)
        } else {
            span.emit_from_end(&arm, time, resolution.weakest)
        };
        taut(&[arm], fibre, at, time)
    }

    /// Fronts that reach the crossover.
    fn crossover(&mut self) -> Result<(), Ended> {
        let (time, on, across) = (self.time, self.resolution(1), self.resolution(2));
        let slide_factor = self.slide_factor;
        let Self { spans, tracks, left_out, .. } = self;
        let [inner, outer, secondary] = &mut spans[..] else {
            unreachable!("a crossover joins three spans")
        };
        let at = outer.offset;
        let mut ended =
            |fibre, offset, front: &Front| write_down(tracks, fibre, offset, front, time);
        *left_out += inner.absorb_at_end(time, on, |front| ended(Fibre::Primary, 0.0, front));
        *left_out += outer.absorb_at_start(time, on, |front| ended(Fibre::Primary, at, front));
        *left_out +=
            secondary.absorb_at_start(time, across, |front| ended(Fibre::Secondary, 0.0, front));
        let (left, right, arm) = (inner.end(), outer.start(), secondary.start());
        if slide_factor < 1.0 && (left.direction - right.direction).norm() > on.weakest {
            return Err(Ended::SlidesOnKink { time });
        }
        let crossing = Crossing { material: &outer.material, area: outer.area };
        let other = Crossing { material: &secondary.material, area: secondary.area };
        let slide = (slide_factor, right.direction);
        let junction = riemann::junction(crossing, left, right, other, arm, slide)
            .map_err(|error| beyond(error, Fibre::Primary, at, time))?;
        *left_out += inner.emit_from_end(&junction.left, time, on.weakest)
            + outer.emit_from_start(&junction.right, time, on.weakest)
            + secondary.emit_from_start(&junction.secondary, time, across.weakest);
        taut(&[junction.left, junction.right], Fibre::Primary, at, time)?;
        taut(&[junction.secondary], Fibre::Secondary, 0.0, time)
    }
}

/// A T(ε) t, N.
fn tension<M: PiecewiseLinear>(span: &Span<M>, state: State) -> Vector3<f64> {
    state.direction * (span.area * span.material.tension(state.strain))
}

fn beyond(_: RiemannError, fibre: Fibre, at: f64, time: f64) -> Ended {
    Ended::BeyondTheLaw { fibre, at, time }
}

fn taut(arms: &[Arm], fibre: Fibre, at: f64, time: f64) -> Result<(), Ended> {
    if arms.iter().any(Arm::is_folded) { Err(Ended::Slack { fibre, at, time }) } else { Ok(()) }
}

fn track(fibre: Fibre, offset: f64, front: &Front, time: f64) -> Track {
    let Front { family, strength, made, .. } = *front;
    let place = |time| (offset + front.position(time), time);
    Track { fibre, family, from: place(made), to: place(time), strength }
}

fn write_down(
    tracks: &mut Option<Vec<Track>>,
    fibre: Fibre,
    offset: f64,
    front: &Front,
    time: f64,
) {
    if let Some(tracks) = tracks {
        tracks.push(track(fibre, offset, front, time));
    }
}

#[cfg(test)]
mod tests;
