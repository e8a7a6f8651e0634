//! The scene: what a run is given. Format `crossfibre-scene/1`, SI units throughout.
//!
//! Lengths along a fibre are Lagrangian (unstrained). [`crate::scene_file`] reads a scene from text
//! and says where in the text a fault lies; `Scene::check` finds what the types cannot express.
//!
//! The page gives no density. 0.2 m of travel in 28.7 µs is c = 6968.6 m/s, and with
//! E = 58.6 GPa ρ = E/c² = 1206.7 kg/m³: an inference (ledger id `density`). It gives the page's
//! 1.45 % at 400 m/s; the 1440 kg/m³ usual for aramid gives 1.63 %.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::errata::{Corrections, Erratum};
use crate::scene_material::present;
pub use crate::scene_material::{Law, Material};

/// The format that this version reads and writes.
pub const FORMAT: &str = "crossfibre-scene/1";

/// A complete description of one run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(transform = crate::scene_schema::of_files))]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// `crossfibre-scene/1`.
    #[cfg_attr(feature = "schema", schemars(extend("const" = FORMAT)))]
    pub format: String,
    /// A name for people.
    #[serde(default)]
    pub title: String,
    /// The struck fibre, from the impact point to its clamp.
    pub primary: Primary,
    /// The crossing fibre; leave it out for a single fibre.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(with = "Secondary"))]
    pub secondary: Option<Secondary>,
    /// What strikes.
    pub projectile: Projectile,
    /// Courant number α: Δt = α × the smaller Δx/c of the fibres. The scheme is stable up to 1.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0), example = 1.0))]
    pub courant: f64,
    /// Time to run, s. The number of steps is duration/Δt rounded.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0), example = 28.7e-6))]
    pub duration: f64,
    /// How strain is measured.
    #[serde(default)]
    pub strain: Strain,
    /// `"all"` (default), `"none"` (the page as printed) or a list of ledger ids.
    #[serde(default = "all_corrections", with = "corrections")]
    #[cfg_attr(feature = "schema", schemars(with = "crate::scene_schema::Corrections"))]
    pub corrections: Corrections,
}

impl Scene {
    /// What the fibres are made of, the primary first.
    pub fn materials(&self) -> impl Iterator<Item = &Material> {
        let secondary = self.secondary.as_ref().map(|secondary| &secondary.material);
        [Some(&self.primary.material), secondary].into_iter().flatten()
    }

    /// Whether a fibre has another law than eqn (7).
    pub fn has_other_laws(&self) -> bool {
        self.materials().any(|material| !material.is_of_the_page())
    }
}

/// The primary fibre.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Primary {
    /// Length of the modelled half, from the impact point to the clamp, m.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0), example = 0.3))]
    pub length: f64,
    /// Number of elements, at least 2.
    #[cfg_attr(feature = "schema", schemars(range(min = 2), example = 150))]
    pub elements: usize,
    /// Density, kg/m³.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0), example = 1206.7))]
    pub density: f64,
    /// Cross-section, m².
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0), example = 1e-6))]
    pub area: f64,
    /// The law between strain and tension.
    pub material: Material,
}

/// The secondary fibre.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Secondary {
    /// Distance of the crossover from the impact point along the primary fibre, m.
    #[cfg_attr(feature = "schema", schemars(range(min = 0), example = 0.1))]
    pub at: f64,
    /// Length of the modelled half, from the crossover to the clamp, m.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0), example = 0.3))]
    pub length: f64,
    /// Number of elements, at least 2.
    #[cfg_attr(feature = "schema", schemars(range(min = 2), example = 150))]
    pub elements: usize,
    /// Density, kg/m³.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0), example = 1206.7))]
    pub density: f64,
    /// Cross-section, m².
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0), example = 1e-6))]
    pub area: f64,
    /// The law between strain and tension.
    pub material: Material,
    /// Slide factor α_s: 1 lets nothing slide, 0 lets it slide freely along the primary.
    #[cfg_attr(feature = "schema", schemars(range(min = 0, max = 1), example = 1.0))]
    pub slide_factor: f64,
}

/// The projectile.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Projectile {
    /// Velocity at impact, m/s.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0), example = 400.0))]
    pub velocity: f64,
    /// Mass, kg; leave it out for a velocity that stays constant.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(with = "f64", extend("exclusiveMinimum" = 0), example = 0.001))]
    pub mass: Option<f64>,
}

/// The measure of strain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Strain {
    /// Eqn (4).
    #[default]
    Incremental,
    /// L/L⁰ − 1.
    Engineering,
}

fn all_corrections() -> Corrections {
    Corrections::ALL
}

/// `"all"`, `"none"` or a list of ids.
mod corrections {
    use std::fmt;

    use serde::de::{Error, SeqAccess, Visitor};

    use super::*;

    #[derive(Serialize)]
    #[serde(untagged)]
    enum Text {
        Word(String),
        Ids(Vec<String>),
    }

    pub fn serialize<S: Serializer>(set: &Corrections, to: S) -> Result<S::Ok, S::Error> {
        let text = match *set {
            Corrections::ALL => Text::Word("all".into()),
            Corrections::NONE => Text::Word("none".into()),
            some => Text::Ids(some.iter().map(|e| e.entry().id.into()).collect()),
        };
        text.serialize(to)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Corrections, D::Error> {
        from.deserialize_any(WordOrIds)
    }

    struct WordOrIds;

    impl<'de> Visitor<'de> for WordOrIds {
        type Value = Corrections;

        fn expecting(&self, to: &mut fmt::Formatter) -> fmt::Result {
            write!(to, "\"all\", \"none\" or a list of correction ids")
        }

        fn visit_str<E: Error>(self, word: &str) -> Result<Corrections, E> {
            match word {
                "all" => Ok(Corrections::ALL),
                "none" => Ok(Corrections::NONE),
                _ => Err(E::unknown_variant(word, &["all", "none"])),
            }
        }

        fn visit_seq<A: SeqAccess<'de>>(self, mut ids: A) -> Result<Corrections, A::Error> {
            let mut set = Corrections::NONE;
            while let Some(Id(erratum)) = ids.next_element()? {
                set = set.with(erratum);
            }
            Ok(set)
        }
    }

    struct Id(Erratum);

    impl<'de> Deserialize<'de> for Id {
        fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
            let id = String::deserialize(from)?;
            Erratum::from_id(&id).map(Self).ok_or_else(|| {
                let known: Vec<_> =
                    Erratum::ALL.iter().map(|e| format!("`{}`", e.entry().id)).collect();
                D::Error::custom(format!(
                    "unknown correction `{id}`, expected one of {}",
                    known.join(", ")
                ))
            })
        }
    }
}
