//! The ledger of departures from the printed page.
//!
//! [`crate::corrected::Corrected`] makes them; each line says what is printed, what is used and why.

use serde::{Deserialize, Serialize};

/// What kind of departure an entry is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// The equation cannot be meant as printed; the correction changes it.
    Erratum,
    /// The page leaves something open; one reading is used in every edition.
    Reading,
    /// Nothing is changed; the trouble is measured and reported.
    Report,
}

/// One line of the ledger.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Entry {
    /// The id used in scenes, docstrings and reports.
    pub id: &'static str,
    /// What kind of departure it is.
    pub kind: Kind,
    /// The numbered equations concerned.
    pub equations: &'static [u8],
    /// What the page has.
    pub printed: &'static str,
    /// Why that cannot stand, or what it leaves open.
    pub trouble: &'static str,
    /// What is used.
    pub used: &'static str,
}

macro_rules! ledger {
    ($($name:ident = $entry:expr;)*) => {
        /// An entry of the ledger by name.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[allow(missing_docs)] // each is documented by its entry in `LEDGER`
        pub enum Erratum { $($name),* }

        /// Every departure from the page, in the order of the equations.
        pub const LEDGER: &[Entry] = &[$($entry),*];

        impl Erratum {
            /// All of them, in the order of [`LEDGER`].
            pub const ALL: &[Self] = &[$(Self::$name),*];
        }
    };
}

ledger! {
    StrainDenominator = Entry {
        id: "strain-denominator",
        kind: Kind::Erratum,
        equations: &[3, 4],
        printed: "(3) divides by L^t, (4) by L^{t-1}",
        trouble: "the two are not the same increment of strain",
        used: "(3) divides by L^{t-1}, as (4) does; the march advances by (4) in every edition",
    };
    StrainPath = Entry {
        id: "strain-path",
        kind: Kind::Report,
        equations: &[4],
        printed: "ε^t = ε^{t-1} + L^t/L^{t-1} - 1",
        trouble: "depends on the path: an element that is stretched by q and let go again keeps \
                  (q - 1)²/q > 0, so oscillations wind strain up; above about half the wave speed \
                  the impact runs away",
        used: "unchanged; measured beside engineering strain, which has no memory",
    };
    CrossSection = Entry {
        id: "cross-section",
        kind: Kind::Reading,
        equations: &[7],
        printed: "T = E ε beside T = (Δm/Δt) Δv",
        trouble: "force per area on one side, force on the other",
        used: "T = (E × area) ε, newtons",
    };
    ProjectileInterval = Entry {
        id: "projectile-interval",
        kind: Kind::Erratum,
        equations: &[8],
        printed: "m_p (v_p^t - v_p^{t-1}) / t",
        trouble: "the velocity changes over one time step, not over the time since impact",
        used: "m_p (v_p^t - v_p^{t-1}) / Δt",
    };
    ProjectileSign = Entry {
        id: "projectile-sign",
        kind: Kind::Erratum,
        equations: &[8],
        printed: "-2 T_y = m_p Δv_p/Δt",
        trouble: "with T pointing from node i to i+1, as (1) requires, T_y is negative behind the \
                  projectile and the printed sign accelerates it",
        used: "+2 T_y = m_p Δv_p/Δt",
    };
    ProjectileInertia = Entry {
        id: "projectile-inertia",
        kind: Kind::Erratum,
        equations: &[8],
        printed: "m_p alone is decelerated",
        trouble: "the lumped mass of node 1 moves with the projectile and is charged to nobody: \
                  momentum is off by O(Δx)",
        used: "m_p plus the lumped mass of node 1",
    };
    ThetaAtOrigin = Entry {
        id: "theta-at-origin",
        kind: Kind::Erratum,
        equations: &[8, 11],
        printed: "θ = tan⁻¹ of a ratio that needs node ix-1",
        trouble: "undefined at ix = 1; tan⁻¹ of a ratio loses the quadrant of a folded element \
                  (harmless: every use is even in the direction) and costs three transcendental \
                  functions",
        used: "direction cosines; at ix = 1 the projectile drives both fibres and (8) feels both",
    };
    TimeLevel = Entry {
        id: "time-level",
        kind: Kind::Reading,
        equations: &[15, 16, 17, 18],
        printed: "T2 has superscript t in (15)-(16), a prime in (17)-(18)",
        trouble: "T2^t needs v2_1^t by (12), which needs u_ix^t, which (17) computes from T2^t",
        used: "T2 and the direction cosines at t-1: the secondary is marched after the primary",
    };
    PerpendicularResolution = Entry {
        id: "perpendicular-resolution",
        kind: Kind::Erratum,
        equations: &[16],
        printed: "cos φ2_x cos φ1_x - cos φ2_y cos φ1_y",
        trouble: "not the component along the normal (-cos φ1_y, cos φ1_x): on a straight fibre \
                  along x it equals (15)",
        used: "cos φ2_y cos φ1_x - cos φ2_x cos φ1_y",
    };
    PerpendicularSign = Entry {
        id: "perpendicular-sign",
        kind: Kind::Erratum,
        equations: &[17],
        printed: "+ T2_perp cos φ1_y",
        trouble: "the x-part of the normal is -cos φ1_y",
        used: "- T2_perp cos φ1_y",
    };
    CrossoverInertia = Entry {
        id: "crossover-inertia",
        kind: Kind::Erratum,
        equations: &[17, 18],
        printed: "A of the primary fibre alone",
        trouble: "the first node of the secondary moves with the crossover and its mass is charged \
                  to nobody: energy is lost at O(Δx), and with engineering strain the node is \
                  unstable at α = 1",
        used: "A = Δt/(Δm1 + Δm2) across the fibre, Δt/(Δm1 + α_s² Δm2) along it",
    };
    SlipDrift = Entry {
        id: "slip-drift",
        kind: Kind::Report,
        equations: &[12, 13],
        printed: "the secondary's first node moves by (12)-(14)",
        trouble: "after slip nothing keeps it on the line of the primary fibre",
        used: "unchanged; its distance from the crossover's node is reported",
    };
    SlideFrame = Entry {
        id: "slide-frame",
        kind: Kind::Report,
        equations: &[9, 12, 13],
        printed: "α_s multiplies v_para, the velocity of the primary's node over ground",
        trouble: "at α_s < 1 the answer changes when the experiment moves along: slip should be a \
                  velocity between the fibres; and (1 - α_s) T2_para is taken from one fibre and not \
                  given to the other",
        used: "unchanged; measured and reported",
    };
    EnergyClaim = Entry {
        id: "energy-claim",
        kind: Kind::Report,
        equations: &[],
        printed: "R² + T² + D² = 1",
        trouble: "half of the diverted power is sideways kinetic energy that no strain shows",
        used: "the exact power balance R² + T² + 2 s T² = 1 at α_s = 1",
    };
    Density = Entry {
        id: "density",
        kind: Kind::Reading,
        equations: &[],
        printed: "not given",
        trouble: "1440 kg/m³, usual for aramid, gives 1.63 % at 400 m/s, not 1.45 %",
        used: "1206.7 kg/m³, implied by 0.2 m of travel in 28.7 µs",
    };
}

impl Erratum {
    /// The line of the ledger.
    pub fn entry(self) -> &'static Entry {
        &LEDGER[self as usize]
    }

    /// The erratum of this id.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|e| e.entry().id == id)
    }

    /// Whether choosing it changes an equation that a run evaluates.
    pub fn changes_a_run(self) -> bool {
        self.entry().kind == Kind::Erratum && self != Self::StrainDenominator
    }
}

/// A subset of the ledger.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corrections(u32);

impl Corrections {
    /// The page as printed.
    pub const NONE: Self = Self(0);
    /// Every correction of the ledger.
    pub const ALL: Self = Self((1 << LEDGER.len()) - 1);

    /// This set and one more.
    #[must_use]
    pub const fn with(self, erratum: Erratum) -> Self {
        Self(self.0 | 1 << erratum as u32)
    }

    /// This set less one.
    #[must_use]
    pub const fn without(self, erratum: Erratum) -> Self {
        Self(self.0 & !(1 << erratum as u32))
    }

    /// Whether the erratum is corrected.
    pub const fn has(self, erratum: Erratum) -> bool {
        self.0 & (1 << erratum as u32) != 0
    }

    /// The corrections in the order of the ledger.
    pub fn iter(self) -> impl Iterator<Item = Erratum> {
        Erratum::ALL.iter().copied().filter(move |&e| self.has(e))
    }
}

impl FromIterator<Erratum> for Corrections {
    fn from_iter<I: IntoIterator<Item = Erratum>>(errata: I) -> Self {
        errata.into_iter().fold(Self::NONE, Self::with)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_holds_what_was_put_in_and_nothing_else() {
        let set = Corrections::NONE.with(Erratum::ProjectileSign).with(Erratum::Density);
        assert_eq!(set.iter().collect::<Vec<_>>(), [Erratum::ProjectileSign, Erratum::Density]);
        assert_eq!(set.without(Erratum::Density), Corrections::NONE.with(Erratum::ProjectileSign));
        assert_eq!(Corrections::ALL.iter().count(), LEDGER.len());
        assert_eq!(set.iter().collect::<Corrections>(), set);
    }

    #[test]
    fn every_id_is_unique_and_leads_back_to_its_erratum() {
        for &erratum in Erratum::ALL {
            assert_eq!(Erratum::from_id(erratum.entry().id), Some(erratum));
        }
        assert_eq!(Erratum::from_id("projectile-sgn"), None);
    }
}
