//! A stretch of fibre between two joints: uniform pieces with fronts between them.

use super::material::PiecewiseLinear;
use super::outgoing::{Family, Outgoing, Waves};
use crate::exact::riemann::{Arm, RiemannError, State, interior};

/// A front on its way.
#[derive(Debug, Clone, Copy)]
pub(super) struct Front {
    /// Where it would have been at time 0, m.
    origin: f64,
    /// Speed towards increasing coordinate, m/s.
    speed: f64,
    pub family: Family,
    pub strength: f64,
    /// When it was made, s.
    pub made: f64,
    /// The state on the side of increasing coordinate.
    right: State,
}

impl Front {
    /// Coordinate on the span, m.
    pub fn position(&self, time: f64) -> f64 {
        self.origin + self.speed * time
    }

    /// When it meets a front ahead of it on the right, never earlier than `now`.
    fn meets(&self, next: &Self, now: f64) -> f64 {
        if self.speed > next.speed {
            ((next.origin - self.origin) / (self.speed - next.speed)).max(now)
        } else {
            f64::INFINITY
        }
    }
}

/// Where the next meeting on a span is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Meeting {
    /// A front reaches the joint at coordinate 0.
    Start,
    /// A front reaches the joint at the other end.
    End,
    /// The front of this index meets the one after it.
    Fronts(usize),
}

/// What is too weak or too near to be told apart.
#[derive(Debug, Clone, Copy)]
pub(super) struct Resolution {
    /// Strength below which a wave is left out.
    pub weakest: f64,
    /// Strength times distance (m) up to which a front is taken into a meeting beside it.
    pub moment: f64,
    /// Distance of a few roundings of a position, m.
    pub rounding: f64,
}

impl Resolution {
    fn merges(&self, front: &Front, distance: f64) -> bool {
        distance <= self.rounding || distance * front.strength <= self.moment
    }
}

/// What was left out: the sum of the strengths of dropped waves, and of strength times distance of
/// merged fronts over the length of the span.
pub(super) type LeftOut = f64;

/// What a meeting leaves behind.
pub(super) struct Met {
    /// The two arms of the Riemann problem.
    pub arms: [Arm; 2],
    pub left_out: LeftOut,
}

/// A stretch of fibre between two joints.
#[derive(Debug, Clone)]
pub(super) struct Span<M> {
    pub material: M,
    /// Reference area, m².
    pub area: f64,
    /// Where it begins on its fibre, m.
    pub offset: f64,
    /// Unstrained length, m.
    pub length: f64,
    /// The state at coordinate 0.
    first: State,
    /// In order of position.
    fronts: Vec<Front>,
    /// The next meeting.
    next: (f64, Meeting),
}

impl<M: PiecewiseLinear> Span<M> {
    pub fn at_rest(material: M, area: f64, offset: f64, length: f64, first: State) -> Self {
        let next = (f64::INFINITY, Meeting::Start);
        Self { material, area, offset, length, first, fronts: Vec::new(), next }
    }

    /// The state at the joint at coordinate 0.
    pub fn start(&self) -> State {
        self.first
    }

    /// The state at the other joint.
    pub fn end(&self) -> State {
        self.fronts.last().map_or(self.first, |front| front.right)
    }

    pub fn fronts(&self) -> &[Front] {
        &self.fronts
    }

    /// When and where the next meeting is.
    pub fn next(&self) -> (f64, Meeting) {
        self.next
    }

    /// The uniform pieces at a time: where each begins on the span, and its state.
    pub fn pieces(&self, time: f64) -> impl Iterator<Item = (f64, State)> {
        let within = move |front: &Front| front.position(time).clamp(0.0, self.length);
        let rest = self.fronts.iter().map(move |front| (within(front), front.right));
        std::iter::once((0.0, self.first)).chain(rest)
    }

    /// Solves the meeting of front `index` with the next one, and with all others that are not to
    /// be told apart from it; they are handed to `ended`.
    pub fn meet(
        &mut self,
        time: f64,
        index: usize,
        resolution: Resolution,
        ended: impl FnMut(&Front),
    ) -> Result<Met, RiemannError> {
        let at = self.fronts[index].position(time);
        let distance = |front: &Front| (front.position(time) - at).abs();
        let merges = |front: &&Front| resolution.merges(front, distance(front));
        let from = index - self.fronts[..index].iter().rev().take_while(merges).count();
        let to = index + 2 + self.fronts[index + 2..].iter().take_while(merges).count();
        let left = if from == 0 { self.first } else { self.fronts[from - 1].right };
        let right = self.fronts[to - 1].right;
        let arms = interior(&self.material, left, right)?;
        let [leftward, rightward] =
            arms.map(|arm| Waves::of(&self.material, &arm, resolution.weakest));
        let merged = self.moment(&self.fronts[from..to], distance);
        self.fronts[from..to].iter().for_each(ended);
        let middle = if rightward.kept.is_empty() {
            right
        } else {
            leftward.at_joint(left.reversed()).reversed()
        };
        let new = leftwards(&leftward.kept, middle, at, time);
        let new = new.chain(rightwards(&rightward.kept, right, at, time));
        self.fronts.splice(from..to, new);
        self.schedule(time);
        Ok(Met { arms, left_out: leftward.dropped + rightward.dropped + merged })
    }

    /// Strength times distance over the length of the span, summed over merged fronts.
    fn moment(&self, merged: &[Front], distance: impl Fn(&Front) -> f64) -> LeftOut {
        merged.iter().map(|front| front.strength * distance(front)).sum::<f64>() / self.length
    }

    /// Takes away the fronts that are not to be told apart from the joint at coordinate 0.
    pub fn absorb_at_start(
        &mut self,
        time: f64,
        resolution: Resolution,
        ended: impl FnMut(&Front),
    ) -> LeftOut {
        let distance = |front: &Front| front.position(time).max(0.0);
        let merges = |front: &&Front| resolution.merges(front, distance(front));
        let count = self.fronts.iter().take_while(merges).count();
        let merged = self.moment(&self.fronts[..count], distance);
        if let Some(last) = self.fronts[..count].last() {
            self.first = last.right;
        }
        self.fronts.drain(..count).as_slice().iter().for_each(ended);
        merged
    }

    /// Takes away the fronts that are not to be told apart from the other joint.
    pub fn absorb_at_end(
        &mut self,
        time: f64,
        resolution: Resolution,
        ended: impl FnMut(&Front),
    ) -> LeftOut {
        let distance = |front: &Front| (self.length - front.position(time)).max(0.0);
        let merges = |front: &&Front| resolution.merges(front, distance(front));
        let kept = self.fronts.len() - self.fronts.iter().rev().take_while(merges).count();
        let merged = self.moment(&self.fronts[kept..], distance);
        self.fronts.drain(kept..).as_slice().iter().for_each(ended);
        merged
    }

    /// Sends waves from the joint at coordinate 0; the sum of what is left out.
    pub fn emit_from_start(&mut self, arm: &Arm, time: f64, weakest: f64) -> LeftOut {
        let waves = Waves::of(&self.material, arm, weakest);
        let new: Vec<_> = rightwards(&waves.kept, self.first, 0.0, time).collect();
        self.first = waves.at_joint(self.first);
        self.fronts.splice(..0, new);
        self.schedule(time);
        waves.dropped
    }

    /// Sends waves from the other joint; the sum of what is left out.
    pub fn emit_from_end(&mut self, arm: &Arm, time: f64, weakest: f64) -> LeftOut {
        let waves = Waves::of(&self.material, arm, weakest);
        let joint = waves.at_joint(self.end().reversed()).reversed();
        self.fronts.extend(leftwards(&waves.kept, joint, self.length, time));
        self.schedule(time);
        waves.dropped
    }

    /// Pieces (where each begins, its state) at a time, each step between them solved anew.
    #[cfg(test)]
    pub fn set(&mut self, pieces: &[(f64, State)], time: f64, weakest: f64) {
        self.first = pieces[0].1;
        self.fronts.clear();
        for pair in pieces.windows(2) {
            let (left, (at, right)) = (pair[0].1, pair[1]);
            let arms = interior(&self.material, left, right).unwrap();
            let [leftward, rightward] = arms.map(|arm| Waves::of(&self.material, &arm, weakest));
            let middle = rightward.at_joint(right);
            self.fronts.extend(leftwards(&leftward.kept, middle, at, time));
            self.fronts.extend(rightwards(&rightward.kept, right, at, time));
        }
        self.schedule(time);
    }

    /// Finds the next meeting.
    fn schedule(&mut self, now: f64) {
        let mut next = (f64::INFINITY, Meeting::Start);
        if let Some(first) = self.fronts.first().filter(|front| front.speed < 0.0) {
            next = ((-first.origin / first.speed).max(now), Meeting::Start);
        }
        for (index, pair) in self.fronts.windows(2).enumerate() {
            let time = pair[0].meets(&pair[1], now);
            if time < next.0 {
                next = (time, Meeting::Fronts(index));
            }
        }
        if let Some(last) = self.fronts.last().filter(|front| front.speed > 0.0) {
            let time = ((self.length - last.origin) / last.speed).max(now);
            if time < next.0 {
                next = (time, Meeting::End);
            }
        }
        self.next = next;
    }
}

/// Fronts of waves that run towards coordinate 0 (the foremost is the first), before `last`.
fn leftwards(waves: &[Outgoing], last: State, at: f64, time: f64) -> impl Iterator<Item = Front> {
    waves.iter().enumerate().map(move |(index, wave)| {
        let right = if index + 1 == waves.len() { last } else { wave.behind.reversed() };
        front(wave, -wave.speed, right, at, time)
    })
}

/// Fronts of waves that run towards increasing coordinate (the foremost is the last) into `ahead`.
fn rightwards(waves: &[Outgoing], ahead: State, at: f64, time: f64) -> impl Iterator<Item = Front> {
    (0..waves.len()).rev().map(move |index| {
        let right = if index == 0 { ahead } else { waves[index - 1].behind };
        front(&waves[index], waves[index].speed, right, at, time)
    })
}

fn front(wave: &Outgoing, speed: f64, right: State, at: f64, time: f64) -> Front {
    let Outgoing { family, strength, .. } = *wave;
    Front { origin: at - speed * time, speed, family, strength, made: time, right }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;

    #[test]
    fn what_is_as_near_as_rounding_or_as_weak_for_its_distance_is_taken_into_a_meeting() {
        let right = State { strain: 0.01, velocity: Vector3::zeros(), direction: Vector3::x() };
        let (origin, speed, made) = (0.0, 1.0, 0.0);
        let on = Resolution { weakest: 1e-6, moment: 0.5, rounding: 1e-13 };
        for (strength, distance, merges) in [
            (1e20, 1e-13, true),
            (1e20, 2e-13, false),
            (0.25, 2.0, true),
            (0.25, 2.5, false),
            (0.0, 1e9, true),
        ] {
            let front = Front { origin, speed, family: Family::Kink, strength, made, right };
            assert_eq!(on.merges(&front, distance), merges, "{strength} {distance}");
        }
    }
}
