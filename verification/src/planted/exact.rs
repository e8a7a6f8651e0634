//! Exact solutions of another problem than the one that was asked for.

use crossfibre::exact::crossover::Crossover;
use crossfibre::exact::elastic::Hyperelastic;
use crossfibre::exact::fronts::Problem;
use crossfibre::exact::smith::{Fibre, Law, Smith, Strain};
use crossfibre::exact::viscoelastic::Arm;
use crossfibre::number::Number;

faults! {
    SmithLaw "exact-smith-law" "takes T = E (λ - 1) for T = E ln λ in Smith's relation";
    SmithSmall "exact-smith-small" "takes Smith's relation for its limit of small strain";
    Density "exact-density" "takes the usual 1440 kg/m³ for the density of a fibre";
    KinkInSpace "exact-kink-in-space" "gives the kink's speed in space for that along the unstrained fibre";
    FrontForTail "exact-front-for-tail" "gives the speed of a wave's first disturbance for that of its last";
    CrossoverLaw "exact-crossover-law" "takes T = E (λ - 1) for T = E ln λ at the crossover";
    CrossoverOneArm "exact-crossover-one-arm" "counts one arm of the secondary";
    CrossoverSlideOnce "exact-crossover-slide-once" "applies the slide factor to the velocity, not to the force";
    CrossoverDensity "exact-crossover-density" "takes the primary's density for the secondary's";
    Diversion "exact-diversion" "refers what is diverted to what is transmitted";
    Power "exact-power" "forgets the ½ of the kinetic energy in the balance of power";
    MotionLaw "exact-motion-law" "takes T = E (λ - 1) for T = E ln λ in the motion at any time";
    MotionOneArm "exact-motion-one-arm" "counts one arm of the secondary in the motion at any time";
    MotionSlideOnce "exact-motion-slide-once" "lets the secondary's whole pull act in the motion at any time";
    MotionDensity "exact-motion-density" "takes the primary's density for the secondary's in the motion at any time";
    MotionMass "exact-motion-mass" "takes half of the projectile's mass for the whole";
    MotionEarly "exact-motion-early" "solves to one time step of a hundred too early";
    MotionClamp "exact-motion-clamp" "lets waves run on where the clamps are";
    DispersionCourant "exact-dispersion-courant" "leaves the Courant number out of the dispersion relation";
    DispersionHalf "exact-dispersion-half" "gives half of the frequency";
    GrowthRoot "exact-growth-root" "gives the lesser root of von Neumann's equation";
    GrowthTwice "exact-growth-twice" "gives the growth of two steps for that of one";
    MeshReflection "exact-mesh-reflection" "forgets that a clamp doubles the strain";
    MeshLate "exact-mesh-late" "gives d'Alembert's solution of the step before";
    RodElastic "exact-rod-elastic" "forgets that the arms of a rod relax";
    RodHalfLife "exact-rod-half-life" "takes relaxation times for half-lives";
    RodEarly "exact-rod-early" "gives a rod's state one part in a hundred too early";
    PolynomialHalf "exact-polynomial-half" "halves the higher coefficients, as in the energy";
    ExponentialHalf "exact-exponential-half" "halves the exponent, and keeps the slope at rest";
    Dissipation "exact-dissipation" "forgets the ½ of what a shock dissipates";
}

impl Wrong {
    /// The law that is taken for this one in Smith's relation.
    pub fn law_of_impact(self, law: Law) -> Law {
        if self == Self::SmithLaw { Law::Engineering } else { law }
    }

    /// What is made of Smith's solution.
    pub fn impact(self, right: Smith, velocity: f64) -> Smith {
        match self {
            Self::SmithSmall => {
                // (V/c)² = 2ε^(3/2).
                let mach = velocity / right.front_speed;
                let root = Number::exp(Number::ln(0.5 * mach * mach) / 3.0);
                Smith { strain: Strain::from_engineering(root * root), ..right }
            }
            Self::KinkInSpace => Smith { kink_speed_lagrangian: right.kink_speed, ..right },
            Self::FrontForTail => Smith { tail_speed: right.front_speed, ..right },
            _ => right,
        }
    }

    /// The problem that is taken for this one at the crossover.
    pub fn crossing(self, law: Law, fibres: [Fibre; 2], slide_factor: f64) -> (Law, [Fibre; 2]) {
        let [primary, mut secondary] = fibres;
        match self {
            Self::CrossoverOneArm => secondary.area *= 0.5,
            Self::CrossoverSlideOnce => secondary.area /= slide_factor,
            Self::CrossoverDensity => secondary.density = primary.density,
            _ => {}
        }
        let law = if self == Self::CrossoverLaw { Law::Engineering } else { law };
        (law, [primary, secondary])
    }

    /// What is made of the solution around the crossover.
    pub fn crossed(self, mut right: Crossover, [primary, secondary]: [Fibre; 2]) -> Crossover {
        match self {
            Self::Diversion => {
                for of in [&mut right.engineering, &mut right.logarithmic] {
                    of.diversion /= of.transmission;
                }
            }
            Self::Power => {
                let Smith {
                    kink_speed_lagrangian, kink_speed, inflow_velocity, angle_sine, ..
                } = right.diverted;
                // V = λU sin γ, λU = what the kink gains on the fibre.
                let across = (kink_speed + inflow_velocity) * angle_sine;
                let squares = across * across - inflow_velocity * inflow_velocity;
                let flow = secondary.density * secondary.area * kink_speed_lagrangian;
                let tension = primary.modulus * right.incident.tension;
                let incident = primary.area * tension * right.incident.inflow_velocity;
                right.power_residual += flow * squares / incident;
            }
            _ => {}
        }
        right
    }

    /// The problem that is taken for this one at any time.
    pub fn problem(self, right: &Problem<Hyperelastic>) -> Problem<Hyperelastic> {
        let mut problem = right.clone();
        if self == Self::MotionLaw {
            problem = problem.map(|&of| Hyperelastic { law: Law::Engineering, ..of });
        }
        if self == Self::MotionClamp {
            problem.primary.length *= 9.0;
        }
        if let Some(across) = &mut problem.secondary {
            match self {
                Self::MotionOneArm => across.fibre.area *= 0.5,
                Self::MotionSlideOnce => across.fibre.area /= across.slide_factor,
                Self::MotionDensity => {
                    across.fibre.material.fibre.density = right.primary.material.fibre.density;
                }
                Self::MotionClamp => across.fibre.length *= 9.0,
                _ => {}
            }
        }
        problem
    }

    /// The arms that are taken for these.
    pub fn arms(self, arms: &[Arm]) -> Vec<Arm> {
        let times = match self {
            Self::RodElastic => 1e9,
            Self::RodHalfLife => 1.0 / std::f64::consts::LN_2,
            _ => 1.0,
        };
        let arm = |arm: &Arm| Arm { relaxation_time: times * arm.relaxation_time, ..*arm };
        arms.iter().map(arm).collect()
    }

    /// The density of a fibre.
    pub fn density(self, right: f64) -> f64 {
        if self == Self::Density { 1440.0 } else { right }
    }

    /// The mass of the projectile.
    pub fn mass(self, right: Option<f64>) -> Option<f64> {
        right.map(|mass| if self == Self::MotionMass { 0.5 * mass } else { mass })
    }

    /// The time to which a motion is solved.
    pub fn time_of_motion(self, right: f64) -> f64 {
        if self == Self::MotionEarly { 0.99 * right } else { right }
    }

    /// The time of a rod's state.
    pub fn time_of_rod(self, right: f64) -> f64 {
        if self == Self::RodEarly { 0.99 * right } else { right }
    }

    /// The Courant number of the dispersion relation.
    pub fn courant(self, right: f64) -> f64 {
        if self == Self::DispersionCourant { 1.0 } else { right }
    }

    /// A frequency.
    pub fn frequency(self, right: f64) -> f64 {
        if self == Self::DispersionHalf { 0.5 * right } else { right }
    }

    /// By how much a mode grows in a step.
    pub fn growth(self, right: f64) -> f64 {
        match self {
            Self::GrowthRoot => 1.0 / right,
            Self::GrowthTwice => right * right,
            _ => right,
        }
    }

    /// The strain of an element, in fronts that have passed.
    pub fn fronts(self, right: usize) -> usize {
        if self == Self::MeshReflection { right.min(1) } else { right }
    }

    /// The step of which d'Alembert's solution is given.
    pub fn step(self, right: usize) -> usize {
        if self == Self::MeshLate { right - 1 } else { right }
    }

    /// The coefficients of a polynomial law.
    pub fn coefficients(self, right: &[f64]) -> Vec<f64> {
        let factor = if self == Self::PolynomialHalf { 0.5 } else { 1.0 };
        let factors = std::iter::once(1.0).chain(std::iter::repeat(factor));
        right.iter().zip(factors).map(|(coefficient, factor)| factor * coefficient).collect()
    }

    /// The two numbers of an exponential law.
    pub fn exponential(self, [a, b]: [f64; 2]) -> [f64; 2] {
        if self == Self::ExponentialHalf { [2.0 * a, 0.5 * b] } else { [a, b] }
    }

    /// What a shock dissipates.
    pub fn dissipation(self, right: f64) -> f64 {
        if self == Self::Dissipation { 2.0 * right } else { right }
    }
}
