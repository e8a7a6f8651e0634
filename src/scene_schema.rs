//! What the types of a scene do not tell its JSON Schema: the ids of corrections, and the `$schema`
//! that a file may name.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde_json::{Value, json};

use crate::errata::Erratum;
use crate::scene_text::SCHEMA;

/// Allows the member that names the schema.
pub(crate) fn of_files(schema: &mut Schema) {
    if let Some(properties) = schema.get_mut("properties").and_then(Value::as_object_mut) {
        let description = "Where this schema is, for editors; it is not read.";
        properties.insert(SCHEMA.into(), json!({ "description": description, "type": "string" }));
    }
}

/// `"all"`, `"none"` or a list of ids.
pub(crate) struct Corrections;

impl JsonSchema for Corrections {
    fn schema_name() -> Cow<'static, str> {
        "Corrections".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let ids = Erratum::ALL.iter().map(|erratum| {
            let entry = erratum.entry();
            json!({ "const": entry.id, "description": entry.used })
        });
        json_schema!({
            "oneOf": [
                { "const": "all", "description": "Every correction of the ledger." },
                { "const": "none", "description": "The page as printed." },
                {
                    "description": "These corrections.",
                    "type": "array",
                    "items": { "oneOf": ids.collect::<Vec<_>>() },
                },
            ]
        })
    }
}

#[cfg(test)]
mod tests {
    use schemars::schema_for;

    use super::*;
    use crate::scene::Scene;

    #[test]
    fn a_file_may_name_its_schema_by_a_text() {
        let schema = schema_for!(Scene);
        assert_eq!(schema.pointer("/properties/$schema/type"), Some(&json!("string")));
    }

    #[test]
    fn corrections_are_all_none_or_ids_of_the_ledger() {
        let schema = schema_for!(Corrections);
        let said = |pointer: &str| schema.pointer(pointer).and_then(Value::as_str);
        assert_eq!(said("/title"), Some("Corrections"));
        assert_eq!(said("/oneOf/0/const"), Some("all"));
        assert_eq!(said("/oneOf/1/const"), Some("none"));
        for (k, erratum) in Erratum::ALL.iter().enumerate() {
            let id = format!("/oneOf/2/items/oneOf/{k}/const");
            assert_eq!(said(&id), Some(erratum.entry().id));
        }
    }
}
