//! Stored vectors against recomputed ones, bit by bit.

use std::collections::BTreeMap;
use std::fmt::{self, Display, Formatter};

use serde_json::Value as Json;

use super::file::Provenance;
use super::{FILES, Recomputed, TRACE, Text};
use crate::bits::ulps;

/// One number, word or vector that is not what is stored.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The file.
    pub file: &'static str,
    /// Id of the vector; of a trace, where its event is.
    pub vector: String,
    /// What differs in it, such as `after.primary.strain[3]`; empty for the vector as a whole.
    pub quantity: String,
    /// What is stored.
    pub expected: String,
    /// What this program computes.
    pub found: String,
    /// How many doubles apart they are, if they are two.
    pub ulps: Option<u64>,
}

impl Display for Difference {
    fn fmt(&self, to: &mut Formatter) -> fmt::Result {
        let Self { file, vector, quantity, expected, found, ulps } = self;
        let place: Vec<_> = [*file, vector.as_str(), quantity.as_str()]
            .into_iter()
            .filter(|part| !part.is_empty())
            .collect();
        write!(to, "{}: expected {expected}, found {found}", place.join(", "))?;
        ulps.iter().try_for_each(|ulps| write!(to, ", {ulps} ULP apart"))
    }
}

/// How many vectors differ.
pub fn vectors_that_differ(differences: &[Difference]) -> usize {
    let mut ids: Vec<_> = differences.iter().map(|d| (d.file, &d.vector)).collect();
    ids.sort_unstable();
    ids.dedup();
    ids.len()
}

/// Where stored files differ from what this program computes. Their provenance may be any.
pub fn differences(stored: &[Text; 4], recomputed: &Recomputed) -> Vec<Difference> {
    let texts = recomputed.texts(&Provenance::now(""));
    let mut all = Vec::new();
    for ((file, stored), found) in FILES.into_iter().zip(stored).zip(&texts) {
        let Some(stored) = stored else {
            all.push(of_file(file, "a file", "none"));
            continue;
        };
        match (read(file, stored), read(file, found)) {
            (Ok(expected), Ok(found)) => between(file, &expected, &found, &mut all),
            (Err(error), _) | (_, Err(error)) => all.push(of_file(file, "JSON", &error)),
        }
    }
    all
}

fn of_file(file: &'static str, expected: &str, found: &str) -> Difference {
    let (vector, quantity) = (String::new(), String::new());
    Difference {
        file,
        vector,
        quantity,
        expected: expected.into(),
        found: found.into(),
        ulps: None,
    }
}

/// The vectors of a file by a name each, in order, and what surrounds them under no name.
struct Named {
    order: Vec<String>,
    vectors: BTreeMap<String, Json>,
}

fn read(file: &str, text: &str) -> Result<Named, String> {
    let mut order = Vec::new();
    let mut vectors = BTreeMap::new();
    let mut add = |name: String, vector: Json| {
        order.push(name.clone());
        vectors.insert(name, vector).map_or(Ok(()), |_| Err("two vectors of one name".to_owned()))
    };
    let parse = |text| serde_json::from_str::<Json>(text).map_err(|error| error.to_string());
    if file == TRACE {
        for (i, line) in text.lines().enumerate() {
            let event = parse(line)?;
            let place = ["step", "fibre", "index", "eq"].map(|key| match &event[key] {
                Json::String(word) => word.clone(),
                Json::Null => String::new(),
                number => number.to_string(),
            });
            let [step, fibre, index, eq] = place;
            let name = match i {
                0 => "line 1, header".into(),
                _ => format!("line {}, step {step} {fibre} {index} eqn ({eq})", i + 1),
            };
            add(name, event)?;
        }
    } else {
        let mut json = parse(text)?;
        let list = json.get_mut("vectors").map(Json::take).unwrap_or_default();
        if let Json::Object(envelope) = &mut json {
            envelope.remove("vectors");
            envelope.remove("provenance");
        }
        add(String::new(), json)?;
        for vector in list.as_array().into_iter().flatten() {
            add(
                vector["id"].as_str().unwrap_or("a vector without an id").to_owned(),
                vector.clone(),
            )?;
        }
    }
    Ok(Named { order, vectors })
}

fn between(file: &'static str, expected: &Named, found: &Named, all: &mut Vec<Difference>) {
    let new = found.order.iter().filter(|name| !expected.vectors.contains_key(*name));
    for name in expected.order.iter().chain(new) {
        let mut leaves = Vec::new();
        walk("", expected.vectors.get(name), found.vectors.get(name), &mut leaves);
        all.extend(leaves.into_iter().map(|leaf| Difference {
            file,
            vector: name.clone(),
            ..leaf
        }));
    }
}

/// Collects the leaves in which two values differ.
fn walk(path: &str, expected: Option<&Json>, found: Option<&Json>, leaves: &mut Vec<Difference>) {
    match (expected, found) {
        (Some(Json::Object(a)), Some(Json::Object(b))) => {
            let new = b.keys().filter(|key| !a.contains_key(*key));
            for key in a.keys().chain(new) {
                let dot = if path.is_empty() { "" } else { "." };
                walk(&format!("{path}{dot}{key}"), a.get(key), b.get(key), leaves);
            }
        }
        (Some(Json::Array(a)), Some(Json::Array(b))) => {
            for i in 0..a.len().max(b.len()) {
                walk(&format!("{path}[{i}]"), a.get(i), b.get(i), leaves);
            }
        }
        _ => {
            let numbers = double(expected).zip(double(found));
            let same = match numbers {
                Some((a, b)) => a.to_bits() == b.to_bits(),
                None => expected == found,
            };
            if !same {
                leaves.push(Difference {
                    quantity: path.into(),
                    ulps: numbers.map(|(a, b)| ulps(a, b)),
                    ..of_file("", &shown(expected), &shown(found))
                });
            }
        }
    }
}

/// A number that is no count.
fn double(json: Option<&Json>) -> Option<f64> {
    json.filter(|json| json.is_f64())?.as_f64()
}

fn shown(json: Option<&Json>) -> String {
    match json {
        None => "nothing".into(),
        Some(Json::Object(_) | Json::Array(_)) => "something".into(),
        Some(leaf) => leaf.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn leaves(expected: Json, found: Json) -> Vec<String> {
        let mut leaves = Vec::new();
        walk("", Some(&expected), Some(&found), &mut leaves);
        leaves.iter().map(|leaf| leaf.to_string().trim_start_matches(", ").to_owned()).collect()
    }

    #[test]
    fn a_difference_names_what_differs_and_by_how_much() {
        let before = json!({"x": [[0.3, 0.7], [0.1, 1e-310]], "steps": 17, "kind": "completed"});
        assert!(leaves(before.clone(), before.clone()).is_empty());
        let mut after = before.clone();
        after["x"][0][0] = json!(0.1 + 0.2);
        after["steps"] = json!(18);
        after["more"] = json!(true);
        assert_eq!(
            leaves(before, after),
            [
                "steps: expected 17, found 18",
                "x[0][0]: expected 0.3, found 0.30000000000000004, 1 ULP apart",
                "more: expected nothing, found true",
            ]
        );
    }

    #[test]
    fn a_vector_that_differs_in_two_numbers_counts_once_and_ids_are_of_their_file() {
        let of = |file, id: &str| Difference { vector: id.into(), ..of_file(file, "1", "2") };
        let all = [
            of("runs.json", "a"),
            of("runs.json", "b"),
            of("runs.json", "a"),
            of("steps.json", "a"),
        ];
        assert_eq!(vectors_that_differ(&all), 3);
        assert_eq!(vectors_that_differ(&[]), 0);
    }

    #[test]
    fn events_of_a_trace_are_named_by_their_line_and_place() {
        let text = "{\"format\":\"crossfibre-trace/1\"}\n\
                    {\"step\":3,\"fibre\":\"primary\",\"index\":7,\"eq\":\"2\"}\n\
                    {\"step\":3,\"fibre\":\"secondary\",\"eq\":\"14\"}\n";
        let named = read(TRACE, text).unwrap();
        let expected = [
            "line 1, header",
            "line 2, step 3 primary 7 eqn (2)",
            // What an event does not say is left out of its name.
            "line 3, step 3 secondary  eqn (14)",
        ];
        assert_eq!(named.order, expected);
    }

    #[test]
    fn the_sign_of_zero_and_one_bit_of_the_least_number_are_differences() {
        let found = leaves(json!([-0.0, 5e-324, 1.0]), json!([0.0, 0.0, 1]));
        assert_eq!(
            found,
            [
                "[0]: expected -0.0, found 0.0, 0 ULP apart",
                "[1]: expected 5e-324, found 0.0, 1 ULP apart",
                "[2]: expected 1.0, found 1"
            ]
        );
    }
}
