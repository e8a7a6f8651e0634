//! Materials on which every longitudinal wave is a row of jumps.

use crate::exact::elastic::{Elastic, Hyperelastic};
use crate::exact::wave::{Kind, Piece};

/// A material all of whose [pieces](Elastic::pieces) of a wave are jumps, so that piecewise constant
/// states stay piecewise constant.
pub trait PiecewiseLinear: Elastic {}

/// A jump of strain with its speed, m/s.
fn jump(from: f64, to: f64, speed: f64) -> Piece {
    let velocity = speed * (to - from);
    Piece { kind: Kind::Shock, from, to, speeds: (speed, speed), velocity }
}

/// T = Eε: every longitudinal wave is one jump with speed c = √(E/ρ).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// E, Pa.
    pub modulus: f64,
    /// ρ, kg/m³.
    pub density: f64,
}

impl Line {
    /// The line that T = Eε is in a material of the engineering law.
    pub fn of(material: &Hyperelastic) -> Self {
        Self { modulus: material.fibre.modulus, density: material.fibre.density }
    }

    fn wave_speed(&self) -> f64 {
        (self.modulus / self.density).sqrt()
    }
}

impl Elastic for Line {
    fn density(&self) -> f64 {
        self.density
    }

    fn tension(&self, strain: f64) -> f64 {
        self.modulus * strain
    }

    fn tangent_modulus(&self, _: f64) -> f64 {
        self.modulus
    }

    fn stored_energy(&self, strain: f64) -> f64 {
        self.modulus * strain * strain / 2.0
    }

    fn pieces(&self, from: f64, to: f64) -> Vec<Piece> {
        vec![jump(from, to, self.wave_speed())]
    }

    fn wave_velocity(&self, from: f64, to: f64) -> f64 {
        self.wave_speed() * (to - from)
    }

    fn wave_speeds(&self, _: f64, _: f64) -> (f64, f64) {
        (self.wave_speed(), self.wave_speed())
    }

    fn greatest_strain(&self) -> f64 {
        f64::MAX
    }
}

impl PiecewiseLinear for Line {}

/// A polygon inscribed in a concave law, with vertices at the multiples of a spacing h.
///
/// It makes of a fan a row of jumps, each with the speed of its chord. Its tension is too small by
/// at most −T″h²/8, which is what the solution converges with.
#[derive(Debug, Clone)]
pub struct Polygon {
    density: f64,
    spacing: f64,
    /// T (Pa) at the vertices.
    tension: Vec<f64>,
    /// ψ (J/m³) at the vertices.
    energy: Vec<f64>,
    /// Speed of the chord after each vertex, m/s.
    speed: Vec<f64>,
    /// W from zero strain to each vertex, m/s.
    velocity: Vec<f64>,
}

impl Polygon {
    /// The polygon in `law`, which must be concave, from zero strain to `chords`·`spacing`.
    pub fn inscribed(law: &impl Elastic, spacing: f64, chords: usize) -> Self {
        let density = law.density();
        let tension: Vec<f64> = (0..=chords).map(|k| law.tension(k as f64 * spacing)).collect();
        let speed: Vec<f64> = tension
            .windows(2)
            .map(|chord| ((chord[1] - chord[0]) / (density * spacing)).sqrt())
            .collect();
        let velocity = std::iter::once(0.0)
            .chain(speed.iter().scan(0.0, |sum, speed| {
                *sum += speed * spacing;
                Some(*sum)
            }))
            .collect();
        let energy = std::iter::once(0.0)
            .chain(tension.windows(2).scan(0.0, |sum, chord| {
                *sum += (chord[0] + chord[1]) / 2.0 * spacing;
                Some(*sum)
            }))
            .collect();
        Self { density, spacing, tension, energy, speed, velocity }
    }

    /// The chord that a strain lies on, and how far along it.
    fn chord(&self, strain: f64) -> (usize, f64) {
        let chord = ((strain / self.spacing) as usize).min(self.speed.len() - 1);
        (chord, strain - chord as f64 * self.spacing)
    }

    /// W from zero strain, m/s.
    fn velocity(&self, strain: f64) -> f64 {
        let (chord, part) = self.chord(strain);
        self.velocity[chord] + self.speed[chord] * part
    }

    /// √([T]/(ρ[ε])): an unloading wave of a concave law is one shock. One of no width is as fast as
    /// its chord.
    fn shock_speed(&self, from: f64, to: f64) -> f64 {
        let ((first, above), (last, part)) = (self.chord(from), self.chord(to));
        if first == last {
            return self.speed[first];
        }
        // [T]/ρ from `to` to the vertex above it, from vertex to vertex, and on to `from`: of a
        // weak wave the difference of two tensions would keep no digits, not even its sign.
        let square = |chord: usize| self.speed[chord] * self.speed[chord];
        let below = self.spacing - part;
        let between = (first - last - 1) as f64 * self.spacing;
        let whole = (self.tension[first] - self.tension[last + 1]) / self.density;
        let drop = square(last) * below + whole + square(first) * above;
        (drop / (below + between + above)).sqrt()
    }
}

impl Elastic for Polygon {
    fn density(&self) -> f64 {
        self.density
    }

    fn tension(&self, strain: f64) -> f64 {
        let (chord, part) = self.chord(strain);
        self.tension[chord] + self.density * self.speed[chord] * self.speed[chord] * part
    }

    fn tangent_modulus(&self, strain: f64) -> f64 {
        let speed = self.speed[self.chord(strain).0];
        self.density * speed * speed
    }

    fn stored_energy(&self, strain: f64) -> f64 {
        let (chord, part) = self.chord(strain);
        self.energy[chord] + (self.tension[chord] + self.tension(strain)) / 2.0 * part
    }

    fn pieces(&self, from: f64, to: f64) -> Vec<Piece> {
        let (first, last) = (self.chord(from).0, self.chord(to).0);
        if to <= from {
            return vec![jump(from, to, self.shock_speed(from, to))];
        }
        (first..=last)
            .map(|chord| {
                let ahead = if chord == first { from } else { chord as f64 * self.spacing };
                let behind = if chord == last { to } else { (chord + 1) as f64 * self.spacing };
                jump(ahead, behind, self.speed[chord])
            })
            // At a vertex the last chord has no length.
            .filter(|jump| jump.to > jump.from)
            .collect()
    }

    fn wave_velocity(&self, from: f64, to: f64) -> f64 {
        if to > from {
            let (first, _) = self.chord(from);
            let (last, _) = self.chord(to);
            // On one chord the difference of two sums would lose the digits of a weak wave.
            if first == last {
                self.speed[first] * (to - from)
            } else {
                self.velocity(to) - self.velocity(from)
            }
        } else {
            self.shock_speed(from, to) * (to - from)
        }
    }

    fn wave_speeds(&self, from: f64, to: f64) -> (f64, f64) {
        if to < from {
            let shock = self.shock_speed(from, to);
            (shock, shock)
        } else {
            (self.speed[self.chord(from).0], self.speed[self.chord(to).0])
        }
    }

    fn greatest_strain(&self) -> f64 {
        self.spacing * self.speed.len() as f64
    }
}

impl PiecewiseLinear for Polygon {}
