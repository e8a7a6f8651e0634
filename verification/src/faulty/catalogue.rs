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
    BalanceOneTension "1-one-tension" 1 "leaves out the tension before the node";
    BalanceNoHistory "1-no-history" 1 "leaves out the velocity of the step before";
    BalanceHalf "1-half" 1 "halves the mass, as if the node were an end";
    VelocitySign "2-sign" 2 "pushes the node away from the greater tension";
    VelocityTwice "2-twice" 2 "doubles A";
    VelocityHalf "2-half" 2 "halves A";
    VelocityBehind "2-i-for-i+1" 2 "takes the tension before the node for that beyond it, and none before";
    VelocityForgotten "2-no-history" 2 "forgets the velocity of the step before";
    VelocityFlat "2-one-component" 2 "does not push along the last axis";
    VelocitySingle "2-single" 2 "keeps A in single precision";
    IncrementDenominator "3-denominator" 3 "divides by the length now";
    IncrementSign "3-sign" 3 "takes the lengths for each other";
    IncrementMean "3-mean" 3 "divides by the mean of the lengths";
    IncrementLogarithm "3-logarithm" 3 "takes the logarithm of the ratio";
    IncrementStretch "3-no-one" 3 "takes the ratio for its difference from 1";
    StrainDenominator "4-denominator" 4 "divides the increment by the length now";
    StrainSign "4-sign" 4 "subtracts the increment";
    StrainForgotten "4-no-history" 4 "forgets the strain of the step before";
    StrainTwice "4-twice" 4 "adds the increment twice";
    StrainLogarithm "4-logarithm" 4 "adds the logarithm of the ratio";
    StrainSingle "4-single" 4 "keeps the length now in single precision";
    LengthBeforeSign "5-sign" 5 "adds the positions";
    LengthBeforeFlat "5-one-component" 5 "leaves the last component out";
    LengthBeforeSum "5-sum" 5 "adds up the components, without their signs";
    LengthBeforeGreatest "5-greatest" 5 "takes the greatest component";
    LengthBeforeSquare "5-square" 5 "forgets the root";
    LengthOldNode "6-old-time-level" 6 "does not move the near node";
    LengthHalf "6-half-step" 6 "moves both nodes by half of v Δt";
    LengthSign "6-sign" 6 "moves the near node backwards";
    LengthFlat "6-one-component" 6 "leaves the last component out";
    LengthSum "6-sum" 6 "adds up the components, with their signs";
    LengthSingle "6-single" 6 "keeps Δt in single precision";
    TensionTwice "7-twice" 7 "doubles the tension";
    TensionSign "7-sign" 7 "has the tension push";
    TensionSquare "7-square" 7 "squares the strain";
    TensionDigits "7-digits" 7 "takes 56.8 for 58.6 GPa";
    TensionSingle "7-single" 7 "keeps the tension in single precision";
    ProjectileTime "8-t-for-dt" 8 "takes t for Δt";
    ProjectileSign "8-sign" 8 "pushes the projectile on";
    ProjectileHalf "8-one-half" 8 "leaves out the factor 2 of the two halves";
    ProjectileAlone "8-no-node" 8 "leaves out the mass of the node";
    ProjectileHalfNode "8-half-node" 8 "counts the node of one half only";
    ParallelSwapped "9-sin-for-cos" 9 "takes sine and cosine for each other";
    ParallelSign "9-sign" 9 "subtracts the second term";
    ParallelOne "9-one-term" 9 "leaves out the second term";
    ParallelTwice "9-cos-twice" 9 "takes the cosine in both terms";
    ParallelFlat "9-small-angle" 9 "takes 1 for the cosine";
    PerpendicularSwapped "10-sin-for-cos" 10 "takes sine and cosine for each other";
    PerpendicularSign "10-sign" 10 "adds the second term";
    PerpendicularOne "10-one-term" 10 "leaves out the second term";
    PerpendicularTwice "10-sin-twice" 10 "takes the sine in both terms";
    PerpendicularFlat "10-small-angle" 10 "takes 1 for the cosine";
    AngleSwapped "11-inverse-slope" 11 "takes Δx/Δy for Δy/Δx";
    AngleSign "11-sign" 11 "has the angle go the other way";
    AngleQuadrant "11-quadrant" 11 "loses the quadrant, as tan⁻¹ does";
    AngleSlope "11-slope" 11 "takes the slope for the sine, and 1 for the cosine";
    AngleDegrees "11-degrees" 11 "gives the angle in degrees to sine and cosine";
    DriveUNoSlide "12-no-slide" 12 "leaves out the slide factor";
    DriveUSign "12-sign" 12 "adds the second term";
    DriveUSwapped "12-sin-for-cos" 12 "takes sine and cosine for each other";
    DriveUOne "12-one-term" 12 "leaves out the second term";
    DriveUBoth "12-slide-both" 12 "has the velocity across slide too";
    DriveVNoSlide "13-no-slide" 13 "leaves out the slide factor";
    DriveVSign "13-sign" 13 "subtracts the second term";
    DriveVBoth "13-slide-both" 13 "has the velocity across slide too";
    DriveVOne "13-one-term" 13 "leaves out the second term";
    DriveVSwapped "13-sin-for-cos" 13 "takes sine and cosine for each other";
    DriveWFree "14-not-zero" 14 "lets the node go along z";
    DriveWNearly "14-nearly" 14 "leaves 1e-9 m/s of an iteration";
    DriveWCode "14-code" 14 "returns the -1 of a failed call";
    DriveWImpact "14-impact" 14 "leaves the velocity of an impact, 400 m/s, in its place";
    DriveWSpeed "14-speed" 14 "leaves a wave speed, 6968.6 m/s, in its place";
    ParallelTensionSign "15-sign" 15 "subtracts the second term";
    ParallelTensionOne "15-one-term" 15 "leaves out the second term";
    ParallelTensionSwapped "15-cosines" 15 "takes cos φ2_x and cos φ2_y for each other";
    ParallelTensionPrimary "15-primary" 15 "takes the primary's cosines for the secondary's";
    ParallelTensionHalf "15-half" 15 "halves the tension";
    NormalTensionPrinted "16-cosines" 16 "takes cos φ2_x and cos φ2_y for each other";
    NormalTensionSign "16-sign" 16 "adds the second term";
    NormalTensionOne "16-one-term" 16 "leaves out the second term";
    NormalTensionPrimary "16-primary" 16 "takes the primary's cos φ_y for the secondary's";
    NormalTensionHalf "16-half" 16 "halves the tension";
    PushUSign "17-sign" 17 "has the normal point the other way along x";
    PushUNoSlide "17-no-slide" 17 "leaves out the slide factor of the tension";
    PushUOneArm "17-one-arm" 17 "leaves out the factor 2 of the two arms";
    PushUSwapped "17-cos-y-for-x" 17 "takes cos φ1_x and cos φ1_y for each other";
    PushUSlideTwice "17-slide-twice" 17 "slides the tension twice";
    PushUNoInertia "17-no-inertia" 17 "leaves out the mass of the secondary's node";
    PushVSign "18-sign" 18 "subtracts the tension across";
    PushVNoSlide "18-no-slide" 18 "leaves out the slide factor of the tension";
    PushVOneArm "18-one-arm" 18 "leaves out the factor 2 of the two arms";
    PushVSwapped "18-cos-y-for-x" 18 "takes cos φ1_x and cos φ1_y for each other";
    PushVSlideTwice "18-slide-twice" 18 "slides the tension twice";
    PushVNoInertia "18-no-inertia" 18 "leaves out the mass of the secondary's node";
    WaveSpeedOnce "19-c-for-c2" 19 "multiplies by c once";
    WaveSign "19-sign" 19 "changes the sign";
    WaveHalf "19-half" 19 "halves c²";
    WaveCube "19-cube" 19 "multiplies by c once more";
    WaveSingle "19-single" 19 "keeps c in single precision";
    CourantInverse "20-inverse" 20 "takes Δx/Δt for Δt/Δx";
    CourantTwice "20-square" 20 "multiplies by c twice";
    CourantHalf "20-half" 20 "takes half of Δt";
    CourantSign "20-sign" 20 "has the wave go backwards";
    CourantSingle "20-single" 20 "keeps Δt in single precision";
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
            assert!(count >= 5, "({number})");
        }
        for &wrong in Wrong::ALL {
            assert_eq!(Wrong::from_id(wrong.fault().id), Some(wrong));
            assert!(wrong.fault().id.starts_with(&format!("{}-", wrong.fault().equation)));
        }
        assert_eq!(Wrong::from_id("4-sgn"), None);
    }
}
