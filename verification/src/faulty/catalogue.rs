//! The faults: what goes wrong when equations are copied from a page.

/// A fault in the transcription of one equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Its name: the equation, and what is wrong in it.
    pub id: &'static str,
    /// The equation.
    pub equation: u8,
    /// What is done instead.
    pub what: &'static str,
}

/// A name for each fault, and the catalogue.
macro_rules! faults {
    ($($name:ident $id:literal $equation:literal $what:literal;)*) => {
        /// The faults by name.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[allow(missing_docs)] // the catalogue says what each is
        pub enum Wrong {
            $($name),*
        }

        impl Wrong {
            /// All, equation by equation.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// Its entry in the catalogue.
            pub fn fault(self) -> &'static Fault {
                const CATALOGUE: &[Fault] =
                    &[$(Fault { id: $id, equation: $equation, what: $what }),*];
                &CATALOGUE[self as usize]
            }
        }
    };
}

faults! {
    BalanceSign "1-sign" 1 "adds the change of momentum to the impulse";
    BalanceEnds "1-ends" 1 "takes the tensions of the two sides for each other";
    VelocitySign "2-sign" 2 "pushes the node away from the greater tension";
    VelocityTwice "2-twice" 2 "doubles A";
    VelocityBehind "2-i-for-i+1" 2 "takes the tension before the node for that beyond it, and none before";
    VelocityForgotten "2-no-history" 2 "forgets the velocity of the step before";
    IncrementDenominator "3-denominator" 3 "divides by the length now";
    IncrementSign "3-sign" 3 "takes the lengths for each other";
    StrainDenominator "4-denominator" 4 "divides the increment by the length now";
    StrainSign "4-sign" 4 "subtracts the increment";
    StrainForgotten "4-no-history" 4 "forgets the strain of the step before";
    StrainTwice "4-twice" 4 "adds the increment twice";
    LengthBeforeSign "5-sign" 5 "adds the positions";
    LengthBeforeFlat "5-one-component" 5 "leaves the last component out";
    LengthOldNode "6-old-time-level" 6 "does not move the near node";
    LengthHalf "6-half-step" 6 "moves both nodes by half of v Δt";
    LengthSign "6-sign" 6 "moves the near node backwards";
    LengthFlat "6-one-component" 6 "leaves the last component out";
    TensionTwice "7-twice" 7 "doubles the tension";
    TensionSign "7-sign" 7 "has the tension push";
    ProjectileTime "8-t-for-dt" 8 "takes t for Δt";
    ProjectileSign "8-sign" 8 "pushes the projectile on";
    ProjectileHalf "8-one-half" 8 "leaves out the factor 2 of the two halves";
    ProjectileAlone "8-no-node" 8 "leaves out the mass of the node";
    ParallelSwapped "9-sin-for-cos" 9 "takes sine and cosine for each other";
    ParallelSign "9-sign" 9 "subtracts the second term";
    PerpendicularSwapped "10-sin-for-cos" 10 "takes sine and cosine for each other";
    PerpendicularSign "10-sign" 10 "adds the second term";
    AngleSwapped "11-inverse-slope" 11 "takes Δx/Δy for Δy/Δx";
    AngleSign "11-sign" 11 "has the angle go the other way";
    AngleQuadrant "11-quadrant" 11 "loses the quadrant, as tan⁻¹ does";
    DriveUNoSlide "12-no-slide" 12 "leaves out the slide factor";
    DriveUSign "12-sign" 12 "adds the second term";
    DriveUSwapped "12-sin-for-cos" 12 "takes sine and cosine for each other";
    DriveVNoSlide "13-no-slide" 13 "leaves out the slide factor";
    DriveVSign "13-sign" 13 "subtracts the second term";
    DriveVBoth "13-slide-both" 13 "has the velocity across slide too";
    DriveWFree "14-not-zero" 14 "lets the node go along z";
    ParallelTensionSign "15-sign" 15 "subtracts the second term";
    ParallelTensionOne "15-one-term" 15 "leaves out the second term";
    NormalTensionPrinted "16-cosines" 16 "takes cos φ2_x and cos φ2_y for each other";
    NormalTensionSign "16-sign" 16 "adds the second term";
    PushUSign "17-sign" 17 "has the normal point the other way along x";
    PushUNoSlide "17-no-slide" 17 "leaves out the slide factor of the tension";
    PushUOneArm "17-one-arm" 17 "leaves out the factor 2 of the two arms";
    PushUSwapped "17-cos-y-for-x" 17 "takes cos φ1_x and cos φ1_y for each other";
    PushVSign "18-sign" 18 "subtracts the tension across";
    PushVNoSlide "18-no-slide" 18 "leaves out the slide factor of the tension";
    PushVOneArm "18-one-arm" 18 "leaves out the factor 2 of the two arms";
    PushVSwapped "18-cos-y-for-x" 18 "takes cos φ1_x and cos φ1_y for each other";
    WaveSpeedOnce "19-c-for-c2" 19 "multiplies by c once";
    WaveSign "19-sign" 19 "changes the sign";
    CourantInverse "20-inverse" 20 "takes Δx/Δt for Δt/Δx";
    CourantTwice "20-square" 20 "multiplies by c twice";
}

impl Wrong {
    /// The fault of this name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|wrong| wrong.fault().id == id)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_equation_has_its_faults_and_every_name_leads_back() {
        for number in 1..=20 {
            let count = Wrong::ALL.iter().filter(|w| w.fault().equation == number).count();
            assert!(count >= if number == 14 { 1 } else { 2 }, "({number})");
        }
        for &wrong in Wrong::ALL {
            assert_eq!(Wrong::from_id(wrong.fault().id), Some(wrong));
            assert!(wrong.fault().id.starts_with(&format!("{}-", wrong.fault().equation)));
        }
        assert_eq!(Wrong::from_id("4-sgn"), None);
    }
}
