//! The record in the repository, from which README.md and VALIDATION.md are written.

use std::sync::OnceLock;

use serde_json::Value;

use super::Record;
use crate::planted::{Plant, now};

const TEXT: &str = include_str!("../../../docs/work-precision/record.json");

/// The record in `docs/work-precision`.
///
/// # Panics
/// If it cannot be read: a fault of this program.
pub fn stored() -> &'static Record {
    static RECORD: OnceLock<Record> = OnceLock::new();
    RECORD.get_or_init(|| {
        let mut record = serde_json::from_str(TEXT).expect("the stored record can be read");
        if let Some(Plant::Record(wrong)) = now() {
            wrong.put_into(&mut record);
        }
        record
    })
}

/// In how many numbers and words two values differ: numbers by their bits, and one for each that only
/// one of them has.
pub fn differences(a: &Value, b: &Value) -> usize {
    match (a, b) {
        (Value::Array(a), Value::Array(b)) => {
            let apart: usize = a.iter().zip(b).map(|(a, b)| differences(a, b)).sum();
            apart + a.len().abs_diff(b.len())
        }
        (Value::Object(a), Value::Object(b)) => {
            let missing = b.keys().filter(|&key| !a.contains_key(key)).count();
            let apart = |(key, a): (&String, &Value)| b.get(key).map_or(1, |b| differences(a, b));
            missing + a.iter().map(apart).sum::<usize>()
        }
        (Value::Number(a), Value::Number(b)) => {
            // Counts are below 2⁵³.
            let bits = |n: &serde_json::Number| n.as_f64().map(f64::to_bits);
            usize::from(bits(a) != bits(b))
        }
        (a, b) => usize::from(a != b),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_that_is_written_and_read_is_the_same_and_a_changed_bit_is_found() {
        let text = stored().json();
        assert_eq!(&serde_json::from_str::<Record>(&text).unwrap(), stored());
        let value: Value = serde_json::from_str(&text).unwrap();
        let mut other = value.clone();
        assert_eq!(differences(&value, &other), 0);
        let reading = &mut other["entries"][3]["found"]["readings"];
        let strain = reading[1]["value"].as_f64().unwrap();
        reading[1]["value"] = f64::from_bits(strain.to_bits() + 1).into();
        reading.as_array_mut().unwrap().pop();
        assert_eq!(differences(&value, &other), 2);
    }
}
