//! What a fibre is made of, as a scene says it.

use serde::{Deserialize, Deserializer, Serialize};

use crate::material::{Arm, Coefficients, Update};

/// A law between strain and tension, and what is added to it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Fields")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(!try_from, deny_unknown_fields))]
pub struct Material {
    /// The law.
    #[serde(flatten)]
    pub law: Law,
    /// Whether a slack fibre carries nothing.
    #[serde(skip_serializing_if = "is_false")]
    #[cfg_attr(feature = "schema", schemars(default))]
    pub tension_only: bool,
    /// Against the oscillations at a front.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(default, with = "Coefficients"))]
    pub artificial_viscosity: Option<Coefficients>,
}

/// A law between strain and stress; `docs/materials.md` has the formulas.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "law", rename_all = "lowercase")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Law {
    /// Eqn (7): σ = E ε.
    #[cfg_attr(feature = "schema", schemars(title = "linear"))]
    Linear {
        /// Young's modulus E, Pa.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0), example = 58.6e9))]
        modulus: f64,
    },
    /// σ = E₁ε + E₂ε² + …
    #[cfg_attr(feature = "schema", schemars(title = "polynomial"))]
    Polynomial {
        /// E₁ > 0, E₂, …, Pa.
        #[cfg_attr(feature = "schema", schemars(length(min = 1), extend("examples" = [[58.6e9, 1e12]])))]
        coefficients: Vec<f64>,
    },
    /// σ = a(exp(bε) − 1).
    #[cfg_attr(feature = "schema", schemars(title = "exponential"))]
    Exponential {
        /// a, Pa.
        #[cfg_attr(feature = "schema", schemars(example = 1.3e9))]
        a: f64,
        /// b, of the same sign.
        #[cfg_attr(feature = "schema", schemars(example = 45.0))]
        b: f64,
    },
    /// σ = E∞ε + Σ s with ds/dt = E dε/dt − s/τ in each arm.
    #[cfg_attr(feature = "schema", schemars(title = "viscoelastic"))]
    Viscoelastic {
        /// E∞, Pa; 0 for a liquid.
        #[cfg_attr(feature = "schema", schemars(range(min = 0), example = 30e9))]
        equilibrium_modulus: f64,
        /// At least one.
        #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
        arms: Vec<Arm>,
        /// How an arm goes through a step.
        #[serde(skip_serializing_if = "Update::is_exact")]
        #[cfg_attr(feature = "schema", schemars(default))]
        update: Update,
    },
    /// σ = E∞ε + s with ds/dt = E(dε/dt − rate sinh(s/stress)).
    #[cfg_attr(feature = "schema", schemars(title = "eyring"))]
    Eyring {
        /// E∞, Pa; 0 for a liquid.
        #[cfg_attr(feature = "schema", schemars(range(min = 0), example = 30e9))]
        equilibrium_modulus: f64,
        /// E of the arm, Pa.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0), example = 28.6e9))]
        modulus: f64,
        /// Of the flow, 1/s.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0), example = 1e3))]
        rate: f64,
        /// By which the flow grows e-fold, Pa.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0), example = 5e7))]
        stress: f64,
        /// How the arm goes through a step.
        #[serde(skip_serializing_if = "Update::is_exact")]
        #[cfg_attr(feature = "schema", schemars(default))]
        update: Update,
    },
}

impl Material {
    /// Eqn (7) with Young's modulus E, Pa.
    pub fn linear(modulus: f64) -> Self {
        Law::Linear { modulus }.into()
    }

    /// The modulus felt by a sudden small strain at rest, Pa: it sets the wave speed.
    pub fn instantaneous_modulus(&self) -> f64 {
        match &self.law {
            Law::Linear { modulus } => *modulus,
            Law::Polynomial { coefficients } => coefficients.first().copied().unwrap_or(0.0),
            Law::Exponential { a, b } => a * b,
            Law::Viscoelastic { equilibrium_modulus, arms, .. } => {
                arms.iter().fold(*equilibrium_modulus, |sum, arm| sum + arm.modulus)
            }
            Law::Eyring { equilibrium_modulus, modulus, .. } => equilibrium_modulus + modulus,
        }
    }

    /// How many numbers an element remembers for its law ([`crate::material::Law::memory`]).
    pub fn numbers_remembered(&self) -> usize {
        let of_law = match &self.law {
            Law::Linear { .. } | Law::Polynomial { .. } | Law::Exponential { .. } => 0,
            Law::Viscoelastic { arms, .. } => 1 + arms.len(),
            Law::Eyring { .. } => 2,
        };
        of_law + usize::from(self.tension_only) + usize::from(self.artificial_viscosity.is_some())
    }

    /// Whether its arms go through a step by forward differences.
    pub fn is_literal(&self) -> bool {
        matches!(
            self.law,
            Law::Viscoelastic { update: Update::Literal, .. }
                | Law::Eyring { update: Update::Literal, .. }
        )
    }

    /// Whether it is eqn (7) and nothing else.
    pub fn is_of_the_page(&self) -> bool {
        matches!(self.law, Law::Linear { .. })
            && !self.tension_only
            && self.artificial_viscosity.is_none()
    }
}

impl Law {
    /// Its name in a scene.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Linear { .. } => "linear",
            Self::Polynomial { .. } => "polynomial",
            Self::Exponential { .. } => "exponential",
            Self::Viscoelastic { .. } => "viscoelastic",
            Self::Eyring { .. } => "eyring",
        }
    }
}

/// With nothing added.
impl From<Law> for Material {
    fn from(law: Law) -> Self {
        Self { law, tension_only: false, artificial_viscosity: None }
    }
}

fn is_false(x: &bool) -> bool {
    !x
}

/// All fields that a material may have. serde reads these, and so can say which one is wrong; the
/// law decides which of them there must be.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Fields {
    law: Name,
    #[serde(default, deserialize_with = "present")]
    modulus: Option<f64>,
    #[serde(default, deserialize_with = "present")]
    coefficients: Option<Vec<f64>>,
    #[serde(default, deserialize_with = "present")]
    a: Option<f64>,
    #[serde(default, deserialize_with = "present")]
    b: Option<f64>,
    #[serde(default, deserialize_with = "present")]
    equilibrium_modulus: Option<f64>,
    #[serde(default, deserialize_with = "present")]
    arms: Option<Vec<Arm>>,
    #[serde(default, deserialize_with = "present")]
    rate: Option<f64>,
    #[serde(default, deserialize_with = "present")]
    stress: Option<f64>,
    #[serde(default, deserialize_with = "present")]
    update: Option<Update>,
    #[serde(default)]
    tension_only: bool,
    #[serde(default, deserialize_with = "present")]
    artificial_viscosity: Option<Coefficients>,
}

/// The laws by name.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Name {
    Linear,
    Polynomial,
    Exponential,
    Viscoelastic,
    Eyring,
}

impl Name {
    /// The fields of the law.
    fn fields(self) -> &'static [&'static str] {
        match self {
            Self::Linear => &["modulus"],
            Self::Polynomial => &["coefficients"],
            Self::Exponential => &["a", "b"],
            Self::Viscoelastic => &["equilibrium_modulus", "arms", "update"],
            Self::Eyring => &["equilibrium_modulus", "modulus", "rate", "stress", "update"],
        }
    }
}

impl TryFrom<Fields> for Material {
    /// In the words of serde, so that one place turns them into words for people.
    type Error = String;

    fn try_from(all: Fields) -> Result<Self, String> {
        all.check_belonging()?;
        let update = all.update.unwrap_or_default();
        let law = match all.law {
            Name::Linear => Law::Linear { modulus: given("modulus", all.modulus)? },
            Name::Polynomial => {
                Law::Polynomial { coefficients: given("coefficients", all.coefficients)? }
            }
            Name::Exponential => Law::Exponential { a: given("a", all.a)?, b: given("b", all.b)? },
            Name::Viscoelastic => Law::Viscoelastic {
                equilibrium_modulus: given("equilibrium_modulus", all.equilibrium_modulus)?,
                arms: given("arms", all.arms)?,
                update,
            },
            Name::Eyring => Law::Eyring {
                equilibrium_modulus: given("equilibrium_modulus", all.equilibrium_modulus)?,
                modulus: given("modulus", all.modulus)?,
                rate: given("rate", all.rate)?,
                stress: given("stress", all.stress)?,
                update,
            },
        };
        let Fields { tension_only, artificial_viscosity, .. } = all;
        Ok(Self { law, tension_only, artificial_viscosity })
    }
}

impl Fields {
    /// Whether each field that is there belongs to the law.
    fn check_belonging(&self) -> Result<(), String> {
        let there = [
            ("modulus", self.modulus.is_some()),
            ("coefficients", self.coefficients.is_some()),
            ("a", self.a.is_some()),
            ("b", self.b.is_some()),
            ("equilibrium_modulus", self.equilibrium_modulus.is_some()),
            ("arms", self.arms.is_some()),
            ("rate", self.rate.is_some()),
            ("stress", self.stress.is_some()),
            ("update", self.update.is_some()),
        ];
        let own = self.law.fields();
        let stranger = there.iter().find(|(name, there)| *there && !own.contains(name));
        stranger.map_or(Ok(()), |(name, _)| {
            let known: Vec<_> = ["law"]
                .iter()
                .chain(own)
                .chain(&["tension_only", "artificial_viscosity"])
                .map(|name| format!("`{name}`"))
                .collect();
            Err(format!("unknown field `{name}`, expected one of {}", known.join(", ")))
        })
    }
}

fn given<T>(name: &str, field: Option<T>) -> Result<T, String> {
    field.ok_or_else(|| format!("missing field `{name}`"))
}

/// A field that may be left out but not be `null`: a writer that knows no NaN writes one as `null`.
pub(crate) fn present<'de, D, T>(from: D) -> Result<Option<T>, D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    T::deserialize(from).map(Some)
}
