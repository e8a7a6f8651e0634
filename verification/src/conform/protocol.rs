//! The messages of `crossfibre-conformance/1`, as types; `docs/conformance.md` explains them.

use std::collections::BTreeMap;

use crossfibre::scene::{Scene, Strain};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::real::Real;

/// The format that this version speaks.
pub const FORMAT: &str = "crossfibre-conformance/1";

/// What the reference asks: a line of the candidate's standard input.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Question {
    /// To be given back.
    pub id: u64,
    /// What is asked.
    #[serde(flatten)]
    pub ask: Ask,
}

/// What is asked.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "ask", rename_all = "lowercase")]
pub enum Ask {
    /// What do you support?
    Hello {
        /// `crossfibre-conformance/1`.
        format: String,
    },
    /// What does an equation give?
    Equation {
        /// Its number on the page, as a name.
        eq: String,
        /// Which of its forms.
        edition: Edition,
        /// What goes in, by the symbols of traces.
        #[serde(rename = "in")]
        inputs: BTreeMap<String, Value>,
    },
    /// What is the state a step later?
    Step {
        /// The scene.
        scene: Box<Scene>,
        /// The state before the step.
        state: Box<StateRecord>,
    },
    /// What comes of a scene?
    Run {
        /// The scene.
        scene: Box<Scene>,
    },
}

/// Which form of an equation is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Edition {
    /// The measure of strain, for (4).
    pub strain: Strain,
    /// The corrected form or the printed one.
    pub corrections: Form,
}

/// The corrected form of an equation, or the printed one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Form {
    /// With all corrections.
    All,
    /// As printed.
    None,
}

/// A number, or the components of a vector in the order x, y, z.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Value {
    /// One number.
    Scalar(Real),
    /// A vector.
    Vector(Vec<Real>),
}

impl Value {
    /// A number, or a vector of any other count.
    pub fn of(numbers: &[f64]) -> Self {
        match numbers {
            [x] => Self::Scalar(Real(*x)),
            all => Self::Vector(all.iter().copied().map(Real).collect()),
        }
    }

    /// The components; of a number, itself.
    pub fn numbers(&self) -> Vec<f64> {
        match self {
            Self::Scalar(Real(x)) => vec![*x],
            Self::Vector(v) => v.iter().map(|Real(x)| *x).collect(),
        }
    }
}

/// All that a step leaves behind for the next.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StateRecord {
    /// Steps made.
    pub step: u64,
    /// The struck fibre, in two dimensions.
    pub primary: FibreRecord,
    /// The crossing fibre, in three.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub secondary: Option<FibreRecord>,
    /// Where it crosses.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crossover: Option<CrossoverRecord>,
    /// Velocity of the projectile for the next step, m/s.
    pub projectile_velocity: Real,
}

/// A fibre: nodes and elements from the impact point (the crossover) outward.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FibreRecord {
    /// Of each node, m.
    pub position: Vec<Vec<Real>>,
    /// Of each node, m/s.
    pub velocity: Vec<Vec<Real>>,
    /// Of each element.
    pub strain: Vec<Real>,
    /// Of each element, N.
    pub tension: Vec<Real>,
}

/// Where the fibres cross.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CrossoverRecord {
    /// The nearest node of the primary, from 0.
    pub node: u64,
    /// How often it has changed.
    pub moves: u64,
}

/// What a candidate answers: a line of its standard output. Besides the id one of the others.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Answer {
    /// That of the question.
    pub id: u64,
    /// Why the question is not for this candidate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub skip: Option<String>,
    /// Why it could not be answered.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error: Option<String>,
    /// Of an equation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub out: Option<Value>,
    /// Of a step.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub state: Option<StateRecord>,
    /// Of a run.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub result: Option<ResultRecord>,
}

/// What is read of a `crossfibre-result/1`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ResultRecord {
    /// How the run ended.
    pub outcome: OutcomeRecord,
    /// Steps made.
    pub steps: u64,
    /// Δt, s.
    pub time_step: Real,
    /// The struck fibre.
    pub primary: FibreRecord,
    /// The crossing fibre.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub secondary: Option<FibreRecord>,
    /// The projectile.
    pub projectile: ProjectileRecord,
    /// Where the fibres cross.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crossover: Option<CrossoverRecord>,
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OutcomeRecord {
    /// As in a result.
    pub kind: String,
}

/// The projectile at the end of a run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ProjectileRecord {
    /// For the next step, m/s.
    pub velocity: Real,
    /// Distance travelled, m.
    pub position: Real,
}

/// The depths at which a candidate can be judged.
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    JsonSchema,
    clap::ValueEnum,
)]
#[serde(rename_all = "lowercase")]
pub enum Depth {
    /// Inputs of an equation to its output.
    Equation,
    /// A state to the next.
    Step,
    /// A scene to its result.
    Run,
}

impl Depth {
    /// All, from the nearest to a cause.
    pub const ALL: [Self; 3] = [Self::Equation, Self::Step, Self::Run];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Equation => "equation",
            Self::Step => "step",
            Self::Run => "run",
        }
    }
}

/// What a candidate computes in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Precision {
    /// 53 bits.
    #[default]
    F64,
    /// 24 bits.
    F32,
}

/// The answer to `hello`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Hello {
    /// That of the question.
    pub id: u64,
    /// `crossfibre-conformance/1`.
    pub format: String,
    /// Of the candidate.
    pub name: String,
    /// Of the candidate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub version: Option<String>,
    /// What it computes in.
    #[serde(default)]
    pub number: Precision,
    /// At which depths it can be asked.
    #[serde(default = "all_depths")]
    pub depths: Vec<Depth>,
    /// The equations that it has.
    #[serde(default = "all_equations")]
    pub equations: Vec<String>,
    /// The laws, and what may be added to them.
    #[serde(default = "linear")]
    pub laws: Vec<String>,
    /// 2 for vectors of the primary fibre, 3 for those of the secondary.
    #[serde(default = "both_dimensions")]
    pub dimensions: Vec<u8>,
    /// Measures of strain.
    #[serde(default = "both_measures")]
    pub strain: Vec<Strain>,
    /// Corrected equations, printed ones.
    #[serde(default = "corrected")]
    pub corrections: Vec<Form>,
}

fn all_depths() -> Vec<Depth> {
    Depth::ALL.into()
}

fn all_equations() -> Vec<String> {
    (1..=20).map(|number| number.to_string()).collect()
}

fn linear() -> Vec<String> {
    vec!["linear".into()]
}

fn both_dimensions() -> Vec<u8> {
    vec![2, 3]
}

fn both_measures() -> Vec<Strain> {
    vec![Strain::Incremental, Strain::Engineering]
}

fn corrected() -> Vec<Form> {
    vec![Form::All]
}

/// Every message: the source of the JSON Schema.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Message {
    /// Of the reference.
    Question(Question),
    /// Of the candidate, to `hello`.
    Hello(Hello),
    /// Of the candidate, to the others.
    Answer(Box<Answer>),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_hello_leaves_out_has_the_value_that_the_page_says() {
        let text = r#"{"id":0,"format":"crossfibre-conformance/1","name":"mine"}"#;
        let hello: Hello = serde_json::from_str(text).unwrap();
        assert_eq!(hello.depths, Depth::ALL);
        assert_eq!(hello.equations.len(), 20);
        assert_eq!(hello.laws, ["linear"]);
        assert_eq!((hello.dimensions, hello.corrections), (vec![2, 3], vec![Form::All]));
        assert_eq!((hello.strain.len(), hello.number), (2, Precision::F64));
    }

    #[test]
    fn a_question_is_one_object_with_its_id_beside_what_it_asks() {
        let ask = Ask::Hello { format: FORMAT.into() };
        let text = serde_json::to_string(&Question { id: 0, ask }).unwrap();
        assert_eq!(text, r#"{"id":0,"ask":"hello","format":"crossfibre-conformance/1"}"#);
    }

    #[test]
    fn a_number_is_one_and_any_other_count_is_a_vector() {
        let value = |numbers: &[f64]| serde_json::to_string(&Value::of(numbers)).unwrap();
        assert_eq!(value(&[0.3]), "0.3");
        assert_eq!(value(&[0.3, 0.7]), "[0.3,0.7]");
        assert_eq!(value(&[]), "[]");
    }

    #[test]
    fn a_depth_has_the_name_that_messages_have() {
        for depth in Depth::ALL {
            assert_eq!(serde_json::to_value(depth).unwrap(), depth.name());
        }
    }
}
