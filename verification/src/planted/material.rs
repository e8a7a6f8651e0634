//! Fibres of another law than the scene says.

use std::sync::Arc;

use crossfibre::constitution::Constitution;
use crossfibre::material::{Law, Update};
use crossfibre::number::Number;
use crossfibre::scene::{self, Material, Scene};
use crossfibre::state::{FibreState, State};

faults! {
    LinearDigits "material-linear-whole" "drops what a modulus has after the point of its GPa";
    LinearPrimary "material-linear-primary" "makes the secondary of the primary's modulus";
    PolynomialHalf "material-polynomial-half" "halves the higher coefficients, as in the energy";
    PolynomialFirst "material-polynomial-first" "leaves out all coefficients but the first";
    ExponentialLinear "material-exponential-linear" "takes the exponential's slope at rest for all of it";
    ExponentialHalf "material-exponential-half" "halves the exponent, and keeps the slope at rest";
    ViscoelasticArm "material-viscoelastic-arm" "leaves out what the last arm carries";
    ViscoelasticHalfLife "material-viscoelastic-half-life" "takes relaxation times for half-lives";
    ViscoelasticLiteral "material-viscoelastic-literal" "steps the arms by forward differences";
    ViscoelasticExact "material-viscoelastic-exact" "updates arms exactly where forward differences are asked for";
    EyringRate "material-eyring-rate" "leaves out the ½ of the hyperbolic sine";
    EyringStress "material-eyring-stress" "doubles the stress in the hyperbolic sine";
    EyringLiteral "material-eyring-literal" "steps the arm by forward differences";
    SlackBears "material-slack-bears" "has a fibre without compression bear it";
    SlackClipped "material-slack-clipped" "cuts the stress off at zero, and lets the material follow the fibre";
    SlackLeaks "material-slack-leaks" "lets a slack fibre bear a hundredth of the compression";
    ViscosityLinear "material-viscosity-linear" "halves the linear artificial viscosity";
    ViscosityQuadratic "material-viscosity-quadratic" "leaves out the quadratic artificial viscosity";
    Unchecked "material-unchecked" "takes any number for a parameter of a scene";
    StoredTwice "material-stored-twice" "forgets the ½ of the stored energy";
    DissipatedTwice "material-dissipated-twice" "books what is dissipated twice";
    DissipatedNot "material-dissipated-not" "forgets what is dissipated";
    DissipatedBack "material-dissipated-back" "books what is dissipated with the wrong sign";
}

impl Wrong {
    /// Makes the fibres of a state at impact of another law. The time step stays that of the scene.
    pub fn put_into<S: Number>(self, scene: &Scene, state: &mut State<S>) {
        let dt = state.time_step;
        let primary = &scene.primary;
        self.make(&primary.material, primary.density, dt, &mut state.primary);
        if let (Some(crossover), Some(secondary)) = (&mut state.crossover, &scene.secondary) {
            let fibre = &mut crossover.fibre;
            self.make(&secondary.material, secondary.density, dt, fibre);
            if self == Self::LinearPrimary && secondary.material.is_of_the_page() {
                let modulus = primary.material.instantaneous_modulus();
                fibre.properties.stiffness = S::from_f64(modulus) * fibre.properties.area;
            }
        }
    }

    fn make<S: Number, const D: usize>(
        self,
        material: &Material,
        density: f64,
        time_step: S,
        fibre: &mut FibreState<S, D>,
    ) {
        if self == Self::LinearDigits && material.is_of_the_page() {
            let whole = (material.instantaneous_modulus() / 1e9).floor() * 1e9;
            // In other units there may be no whole gigapascal.
            if whole > 0.0 {
                fibre.properties.stiffness = S::from_f64(whole) * fibre.properties.area;
            }
        }
        let other = self.other(material);
        if other != *material {
            let law = Constitution::of(&other, density, &fibre.properties, time_step);
            fibre.constitution = law.unwrap_or_else(|fault| panic!("{fault}"));
        }
        if let Some(by) = &mut fibre.constitution {
            let law = Arc::clone(&by.law);
            match self {
                Self::StoredTwice
                | Self::DissipatedTwice
                | Self::DissipatedNot
                | Self::DissipatedBack => by.law = Arc::new(Otherwise { law, wrong: self }),
                Self::SlackClipped | Self::SlackLeaks if material.tension_only => {
                    by.law = Arc::new(Otherwise { law, wrong: self });
                }
                _ => {}
            }
        }
    }

    /// The material that is taken for this one.
    fn other(self, material: &Material) -> Material {
        let mut other = material.clone();
        match (self, &mut other.law) {
            (Self::PolynomialHalf, scene::Law::Polynomial { coefficients }) => {
                coefficients.iter_mut().skip(1).for_each(|c| *c *= 0.5);
            }
            (Self::PolynomialFirst, scene::Law::Polynomial { coefficients }) => {
                coefficients.truncate(1);
            }
            (Self::ExponentialHalf, scene::Law::Exponential { a, b }) => {
                (*a, *b) = (2.0 * *a, 0.5 * *b);
            }
            (Self::ExponentialLinear, law) => {
                if let scene::Law::Exponential { a, b } = *law {
                    *law = scene::Law::Polynomial { coefficients: vec![a * b] };
                }
            }
            (Self::ViscoelasticArm, scene::Law::Viscoelastic { arms, .. }) => {
                if let Some(last) = arms.last_mut() {
                    last.modulus *= 1e-9;
                }
            }
            (Self::ViscoelasticHalfLife, scene::Law::Viscoelastic { arms, .. }) => {
                arms.iter_mut().for_each(|arm| arm.relaxation_time /= std::f64::consts::LN_2);
            }
            (Self::ViscoelasticLiteral, scene::Law::Viscoelastic { update, .. }) => {
                *update = Update::Literal;
            }
            (Self::ViscoelasticExact, scene::Law::Viscoelastic { update, .. }) => {
                *update = Update::Exact;
            }
            (Self::EyringRate, scene::Law::Eyring { rate, .. }) => *rate *= 2.0,
            (Self::EyringStress, scene::Law::Eyring { stress, .. }) => *stress *= 0.5,
            (Self::EyringLiteral, scene::Law::Eyring { update, .. }) => *update = Update::Literal,
            // (7) alone would have no law that could be wrapped.
            (Self::SlackClipped | Self::SlackLeaks, law) if material.tension_only => {
                if let scene::Law::Linear { modulus } = *law {
                    *law = scene::Law::Polynomial { coefficients: vec![modulus] };
                }
                other.tension_only = false;
            }
            (Self::SlackBears, _) => other.tension_only = false,
            _ => {}
        }
        if let Some(viscosity) = &mut other.artificial_viscosity {
            match self {
                Self::ViscosityLinear => viscosity.linear *= 0.5,
                Self::ViscosityQuadratic => viscosity.quadratic = 0.0,
                _ => {}
            }
        }
        other
    }
}

/// A law of which something is told otherwise.
#[derive(Debug)]
struct Otherwise<S> {
    law: Arc<dyn Law<S>>,
    wrong: Wrong,
}

impl<S: Number> Otherwise<S> {
    fn cut(&self, stress: S) -> S {
        let share = match self.wrong {
            Wrong::SlackClipped => S::zero(),
            Wrong::SlackLeaks => S::from_f64(0.01),
            _ => S::one(),
        };
        if stress < S::zero() { share * stress } else { stress }
    }
}

impl<S: Number> Law<S> for Otherwise<S> {
    fn prepared(self, _time_step: S) -> Self {
        self
    }

    fn memory(&self) -> usize {
        self.law.memory()
    }

    fn stress(&self, before: S, now: S, memory: &mut [S]) -> S {
        self.cut(self.law.stress(before, now, memory))
    }

    fn tangent_modulus(&self, before: S, now: S, memory: &[S]) -> S {
        self.law.tangent_modulus(before, now, memory)
    }

    fn instantaneous_modulus(&self, strain: S, memory: &[S]) -> S {
        self.law.instantaneous_modulus(strain, memory)
    }

    fn step_modulus(&self, before: S, now: S, memory: &[S]) -> S {
        self.law.step_modulus(before, now, memory)
    }

    fn stored(&self, strain: S, memory: &[S]) -> S {
        let right = self.law.stored(strain, memory);
        if self.wrong == Wrong::StoredTwice { S::two() * right } else { right }
    }

    fn dissipated(&self, memory: &[S]) -> S {
        let right = self.law.dissipated(memory);
        match self.wrong {
            Wrong::DissipatedTwice => S::two() * right,
            Wrong::DissipatedNot => S::zero(),
            Wrong::DissipatedBack => -right,
            _ => right,
        }
    }

    fn taut_strain(&self, before: S, now: S, memory: &[S]) -> S {
        self.law.taut_strain(before, now, memory)
    }
}
