//! The rule, on errors as on differences of values.

use crossfibre::number::Number;

use super::{LEAST, Reason, Rule, Run, Verdict};
use crate::convergence::Fault;

/// Errors, or differences of values, and the orders between them.
pub(super) struct Series<'a> {
    /// The meshes.
    pub spacings: &'a [(f64, f64)],
    /// Errors, one a mesh, or differences, one less.
    pub signed: Vec<f64>,
    /// Between each two of them.
    pub orders: Vec<f64>,
    /// How many meshes there are beyond one for each of `signed`.
    pub meshes_more: usize,
    /// The order fitted to the meshes from one to before another.
    pub fit: &'a dyn Fn(usize, usize) -> Option<f64>,
}

impl Series<'_> {
    /// The verdict by the rule of the module.
    pub fn verdict(&self, Rule { band, floor }: Rule) -> Result<Verdict, Fault> {
        if !(band > 0.0 && band.is_finite() && floor >= 0.0 && floor.is_finite()) {
            return Err(Fault::Rule { band, floor });
        }
        let all = self.signed.len();
        let above = (0..all).rev().find(|&k| !self.on_floor(k, band, floor)).map_or(0, |k| k + 1);
        let run = (0..(above + 1).saturating_sub(LEAST)).find_map(|k| self.run(k, above, band));
        let verdict = if above < all {
            let from = above + self.meshes_more;
            match run {
                Some(run) if self.falls_short(above, run.order + band, floor) => {
                    Verdict::NotYet(Reason::Dip { mesh: from })
                }
                before => Verdict::Floor { from, before },
            }
        } else {
            run.map_or_else(|| self.no_run(band, floor), Verdict::Asymptotic)
        };
        Ok(verdict)
    }

    /// Whether ± floor could change the order before the error by more than the band:
    /// |e| − floor < |e| r⁻ᵇᵃⁿᵈ. Of differences on meshes of unequal ratios this is nearly so.
    fn on_floor(&self, k: usize, band: f64, floor: f64) -> bool {
        let lost = |ratio: f64| -Number::exp_m1(-band * ratio);
        // A single mesh has no order that could be changed.
        floor >= self.signed[k].abs() * self.ln_ratio(k).map_or(1.0, lost)
    }

    /// Whether the error is smaller than an order from the one before allows, even with the floor
    /// added.
    fn falls_short(&self, k: usize, order: f64, floor: f64) -> bool {
        let least = self.ln_ratio(k).map_or(0.0, |ratio| Number::exp(-order * ratio));
        self.signed[k].abs() + floor < self.signed[k - 1].abs() * least
    }

    /// ln of the refinement ratio to the mesh of an error, or of the first two meshes.
    fn ln_ratio(&self, k: usize) -> Option<f64> {
        let k = (k + self.meshes_more).max(1);
        self.spacings.get(k).map(|fine| Number::ln(self.spacings[k - 1].0 / fine.0))
    }

    /// The run between two errors, if it is one.
    fn run(&self, from: usize, to: usize, band: f64) -> Option<Run> {
        if sign_changes(&self.signed[from..to], 0.0) > 0 {
            return None;
        }
        let (order, within) = self.agreement(from, to)?;
        let meshes = to - from + self.meshes_more;
        (order > band && within <= band).then_some(Run { from, meshes, order, within })
    }

    /// The fitted order, and the greatest difference of a pairwise one from it; none if an error is
    /// zero, or no order fits.
    fn agreement(&self, from: usize, to: usize) -> Option<(f64, f64)> {
        let orders = &self.orders[from..to - 1];
        if !orders.iter().all(|p| p.is_finite()) {
            return None;
        }
        let order = (self.fit)(from, to + self.meshes_more)?;
        Some((order, orders.iter().fold(0.0, |most: f64, p| most.max((p - order).abs()))))
    }

    /// Why there is no run, with nothing on the floor.
    fn no_run(&self, band: f64, floor: f64) -> Verdict {
        let all = self.signed.len();
        if all < LEAST {
            return Verdict::NotYet(Reason::TooFew);
        }
        let differences: Vec<_> = self.signed.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let crossings = |from: usize| sign_changes(&self.signed[from..], floor);
        // Differences of differences say nothing more about values.
        let turns = |from: usize| {
            if self.meshes_more > 0 { 0 } else { sign_changes(&differences[from..], 2.0 * floor) }
        };
        let changes = crossings(0).max(turns(0));
        let finest = all - LEAST;
        if changes >= 2 && crossings(finest) + turns(finest) > 0 {
            return Verdict::Oscillating { changes };
        }
        if crossings(finest) > 0 {
            return Verdict::NotYet(Reason::Crossing);
        }
        let fitted = self.agreement(finest, all).map(|(order, _)| order);
        let falls = self.orders[all - 2] > band && fitted.is_none_or(|order| order > band);
        Verdict::NotYet(if falls { Reason::Scattered } else { Reason::NotFalling })
    }
}

/// How often the sign changes, those numbers left out that are not above a size.
fn sign_changes(numbers: &[f64], size: f64) -> usize {
    let known: Vec<_> = numbers.iter().filter(|x| x.abs() > size).collect();
    known.windows(2).filter(|pair| (*pair[0] > 0.0) != (*pair[1] > 0.0)).count()
}
