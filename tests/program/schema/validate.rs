//! The part of JSON Schema that the project's own schema uses. A keyword that is not known here is a failure, so that
//! nothing in the schema goes unchecked.

use serde_json::{Map, Value};

/// Lists what in `value` does not fit `rule`; `place` is a JSON pointer.
pub fn validate(schema: &Value, rule: &Value, value: &Value, place: &str, wrong: &mut Vec<String>) {
    let Some(rule) = rule.as_object() else {
        wrong.push(format!("{place}: the schema's rule is no object"));
        return;
    };
    for (keyword, argument) in rule {
        let fits = match keyword.as_str() {
            "$schema" | "$id" | "$defs" | "title" | "description" => true,
            // properties speaks for both
            "additionalProperties" if rule.contains_key("properties") => true,
            "$ref" => {
                validate(schema, target(schema, argument), value, place, wrong);
                true
            }
            "properties" | "additionalProperties" => {
                properties(schema, rule, value, place, wrong);
                true
            }
            "items" => {
                let items = value.as_array().into_iter().flatten().enumerate();
                items.for_each(|(i, v)| validate(schema, argument, v, &format!("{place}/{i}"), wrong));
                true
            }
            "required" => {
                let missing = argument.as_array().into_iter().flatten().filter_map(Value::as_str);
                for key in missing.filter(|key| value.get(key).is_none()) {
                    wrong.push(format!("{place}: {key} is missing"));
                }
                true
            }
            "anyOf" => argument.as_array().into_iter().flatten().any(|rule| {
                let mut found = Vec::new();
                validate(schema, rule, value, place, &mut found);
                found.is_empty()
            }),
            "type" => is_of_type(value, argument.as_str().unwrap_or_default()),
            "const" => value == argument,
            "enum" => argument.as_array().is_some_and(|all| all.contains(value)),
            "minimum" => value.as_f64() >= argument.as_f64(),
            "maximum" => value.as_f64() <= argument.as_f64(),
            "minItems" => value.as_array().map(Vec::len) >= size(argument),
            "maxItems" => value.as_array().map(Vec::len) <= size(argument),
            unknown => {
                wrong.push(format!("{place}: the validator does not know the keyword {unknown}"));
                true
            }
        };
        if !fits {
            wrong.push(format!("{place}: {value} does not fit {keyword} {argument}"));
        }
    }
}

fn size(argument: &Value) -> Option<usize> {
    argument.as_u64().and_then(|n| usize::try_from(n).ok())
}

/// What a reference such as `#/$defs/pose` names.
fn target<'a>(schema: &'a Value, reference: &Value) -> &'a Value {
    let pointer = reference.as_str().and_then(|r| r.strip_prefix('#')).unwrap_or_default();
    schema.pointer(pointer).unwrap_or(&Value::Null)
}

fn properties(
    schema: &Value,
    rule: &Map<String, Value>,
    value: &Value,
    place: &str,
    wrong: &mut Vec<String>,
) {
    for (key, inner) in value.as_object().into_iter().flatten() {
        let here = format!("{place}/{key}");
        match (rule.get("properties").and_then(|p| p.get(key)), rule.get("additionalProperties")) {
            (Some(known), _) => validate(schema, known, inner, &here, wrong),
            (None, Some(Value::Bool(false))) => wrong.push(format!("{here}: no such key")),
            (None, Some(other)) => validate(schema, other, inner, &here, wrong),
            (None, None) => {}
        }
    }
}

fn is_of_type(value: &Value, name: &str) -> bool {
    match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        _ => false,
    }
}
