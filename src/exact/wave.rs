//! One longitudinal wave between two uniform strains, piece by piece.

use super::elastic::Elastic;
use super::root::first_where;

/// What a piece of a wave is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A rarefaction fan: every strain in it travels at its own speed √(T′/ρ), and T = T̂.
    Fan,
    /// A jump at speed `√([T]/(ρ[ε]))`, along a chord of T. Where T is linear it dissipates nothing.
    Shock,
}

/// A fan or a shock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// Which of the two.
    pub kind: Kind,
    /// Strain ahead of it.
    pub from: f64,
    /// Strain behind it.
    pub to: f64,
    /// Lagrangian speeds of its first and last disturbance, m/s; the same for a shock.
    pub speeds: (f64, f64),
    /// The particle velocity that it gives, m/s, with the sign of `to − from`: ∫√(T′/ρ) dε through
    /// a fan, `±√([T][ε]/ρ)` across a shock.
    pub velocity: f64,
}

/// The wave from strain `from` (ahead of it) to strain `to` (behind it) in a material.
#[derive(Debug, Clone, PartialEq)]
pub struct Wave<'m, M> {
    material: &'m M,
    to: f64,
    pieces: Vec<Piece>,
}

impl<'m, M: Elastic> Wave<'m, M> {
    /// The wave between two strains.
    pub fn between(material: &'m M, from: f64, to: f64) -> Self {
        Self { material, to, pieces: material.pieces(from, to) }
    }

    /// Its fans and shocks from the first disturbance to the last.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The strain at Lagrangian distance ξt from where the wave started, ξ in m/s.
    ///
    /// Inside a fan it is where T′ = ρξ². At a shock it is the strain ahead.
    pub fn strain_at(&self, xi: f64) -> f64 {
        let rho = self.material.density();
        for piece in &self.pieces {
            if xi >= piece.speeds.0 {
                return piece.from;
            }
            if xi > piece.speeds.1 {
                let (low, high) = (piece.from.min(piece.to), piece.from.max(piece.to));
                // T′ falls with strain through a loading fan, and rises through an unloading one.
                let loading = piece.to > piece.from;
                return first_where(low, high, |strain| {
                    let slope = self.material.tangent_modulus(strain);
                    if loading { slope <= rho * xi * xi } else { slope >= rho * xi * xi }
                });
            }
        }
        self.to
    }

    /// Energy that the shocks turn into heat per unit area and time, W/m²: the sum of
    /// `s(½(T₊ + T₋)[ε] − [ψ])`, which is s∫(T̂ − T) dε over a shock of speed s and not negative.
    ///
    /// It is a difference of large terms: rounding leaves an ulp or two of `s[ψ]`.
    pub fn dissipation(&self) -> f64 {
        let shocks = self.pieces.iter().filter(|piece| piece.kind == Kind::Shock);
        shocks
            .map(|&Piece { from, to, speeds, .. }| {
                let tension = |strain| self.material.tension(strain);
                let energy = |strain| self.material.stored_energy(strain);
                let work = (tension(to) + tension(from)) / 2.0 * (to - from);
                speeds.0 * (work - (energy(to) - energy(from)))
            })
            .sum()
    }
}

#[cfg(test)]
mod tests;
