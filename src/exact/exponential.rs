//! Exponential hardening or softening, whose waves are all closed forms.

use pxfm::{f_exp, f_expm1, f_log, f_log1pmx};

use super::elastic::{Elastic, LawError, checked};
use super::root::first_where;
use super::wave::{Kind, Piece};

/// T = a(exp(bε) − 1): convex for b > 0, concave for b < 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exponential {
    density: f64,
    a: f64,
    b: f64,
}

impl Exponential {
    /// The law of density ρ (kg/m³), a (Pa, with the sign of b) and b.
    pub fn new(density: f64, a: f64, b: f64) -> Result<Self, LawError> {
        checked(density, &[a, b], a * b)?;
        Ok(Self { density, a, b })
    }

    /// √(T′(ε)/ρ) = √(ab/ρ) exp(bε/2), m/s.
    fn speed(&self, strain: f64) -> f64 {
        (self.a * self.b / self.density).sqrt() * f_exp(self.b * strain / 2.0)
    }
}

/// (exp(y) − 1)/y.
fn mean_growth(y: f64) -> f64 {
    if y == 0.0 { 1.0 } else { f_expm1(y) / y }
}

/// exp(y) − 1 − y, which with u = exp(y) − 1 is u − ln(1 + u): so it keeps its digits at small y.
fn exp_m1_m_y(y: f64) -> f64 {
    let u = f_expm1(y);
    if y.abs() < 1.0 { -f_log1pmx(u) } else { u - y }
}

impl Elastic for Exponential {
    fn density(&self) -> f64 {
        self.density
    }

    fn tension(&self, strain: f64) -> f64 {
        self.a * f_expm1(self.b * strain)
    }

    fn tangent_modulus(&self, strain: f64) -> f64 {
        self.a * self.b * f_exp(self.b * strain)
    }

    /// (a/b)(exp(bε) − 1 − bε).
    fn stored_energy(&self, strain: f64) -> f64 {
        self.a / self.b * exp_m1_m_y(self.b * strain)
    }

    fn pieces(&self, from: f64, to: f64) -> Vec<Piece> {
        let (added, speed) = (to - from, self.speed(from));
        let y = self.b * added;
        // b·added > 0: convex and loading, or concave and unloading.
        let (kind, speeds, velocity) = if y > 0.0 {
            let shock = speed * mean_growth(y).sqrt();
            (Kind::Shock, (shock, shock), added * shock)
        } else {
            (Kind::Fan, (speed, self.speed(to)), added * speed * mean_growth(y / 2.0))
        };
        vec![Piece { kind, from, to, speeds, velocity }]
    }

    /// b < 0: T = λT′, which with y = −bε is exp(y) − 1 − y = −b. b > 0: no limit, so where the
    /// tension is 1e150 Pa.
    fn greatest_strain(&self) -> f64 {
        let b = self.b.abs();
        if self.b > 0.0 {
            f_log(1e150 / self.a) / b
        } else {
            // exp(y) − 1 − y > y²/2.
            first_where(0.0, (2.0 * b).sqrt(), |y| exp_m1_m_y(y) >= b) / b
        }
    }
}

#[cfg(test)]
mod tests;
