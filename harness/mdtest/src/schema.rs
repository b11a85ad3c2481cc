//! Checks a JSON value against a schema, for tests. A keyword that is not known here is an error of the test.

use serde_json::{Map, Value};

/// Returns the first misfit of a value with its place; `None` where the value fits.
///
/// # Panics
/// A schema with a keyword that is not known here, or with a reference to nothing.
pub fn misfit(root: &Value, value: &Value) -> Option<String> {
    SchemaCheck { root }.misfit(root, value, "")
}

struct SchemaCheck<'s> {
    root: &'s Value,
}

impl SchemaCheck<'_> {
    fn misfit(&self, schema: &Value, value: &Value, at: &str) -> Option<String> {
        let Value::Object(keywords) = schema else {
            return (*schema == Value::Bool(false)).then(|| format!("{at}: nothing may stand here"));
        };
        keywords
            .iter()
            .find_map(|(keyword, wanted)| self.keyword(keyword, wanted, keywords, value, at))
    }

    fn keyword(
        &self,
        keyword: &str,
        wanted: &Value,
        keywords: &Map<String, Value>,
        value: &Value,
        at: &str,
    ) -> Option<String> {
        let fits = |schema: &&Value| self.misfit(schema, value, at).is_none();
        let is_right = match keyword {
            "$schema" | "$defs" | "title" | "description" | "default" | "format" => true,
            "$ref" => {
                let pointer = wanted.as_str()?.trim_start_matches('#');
                let schema = self.root.pointer(pointer).expect("a definition");
                return self.misfit(schema, value, at);
            }
            "type" => list(wanted).any(|ty| is_of(ty.as_str().unwrap_or_default(), value)),
            "const" => value == wanted,
            "enum" => list(wanted).any(|one| one == value),
            "oneOf" => list(wanted).filter(fits).count() == 1,
            "anyOf" => list(wanted).any(|schema| fits(&schema)),
            "minimum" => value
                .as_f64()
                .is_none_or(|number| number >= wanted.as_f64().expect("a number")),
            "maximum" => value
                .as_f64()
                .is_none_or(|number| number <= wanted.as_f64().expect("a number")),
            "minItems" => value
                .as_array()
                .is_none_or(|items| items.len() as u64 >= wanted.as_u64().expect("a number")),
            "maxItems" => value
                .as_array()
                .is_none_or(|items| items.len() as u64 <= wanted.as_u64().expect("a number")),
            "prefixItems" => {
                let mut items = list(value).zip(list(wanted)).enumerate();
                return items.find_map(|(index, (item, schema))| {
                    self.misfit(schema, item, &format!("{at}[{index}]"))
                });
            }
            "uniqueItems" => value.as_array().is_none_or(|items| {
                let is_new = |(index, item)| !items[..index].contains(item);
                items.iter().enumerate().all(is_new)
            }),
            "minLength" => value
                .as_str()
                .is_none_or(|text| text.chars().count() as u64 >= wanted.as_u64().expect("a number")),
            "required" => value.as_object().is_none_or(|object| {
                list(wanted).all(|key| object.contains_key(key.as_str().unwrap_or_default()))
            }),
            "items" => {
                let mut items = value.as_array().into_iter().flatten().enumerate();
                return items.find_map(|(index, item)| self.misfit(wanted, item, &format!("{at}[{index}]")));
            }
            "properties" => {
                let mut properties = wanted.as_object()?.iter();
                return properties
                    .find_map(|(key, schema)| self.misfit(schema, value.get(key)?, &format!("{at}.{key}")));
            }
            "additionalProperties" => {
                let known = keywords.get("properties").and_then(Value::as_object);
                let mut others = value.as_object().into_iter().flatten();
                return others.find_map(|(key, item)| {
                    match known.is_some_and(|known| known.contains_key(key)) {
                        true => None,
                        false => self.misfit(wanted, item, &format!("{at}.{key}")),
                    }
                });
            }
            other => panic!("the test does not know the keyword {other}"),
        };
        (!is_right).then(|| format!("{at}: {keyword} is {wanted}"))
    }
}

/// Returns the elements of a list, or the value itself.
fn list(value: &Value) -> std::slice::Iter<'_, Value> {
    match value {
        Value::Array(items) => items.iter(),
        one => std::slice::from_ref(one).iter(),
    }
}

fn is_of(ty: &str, value: &Value) -> bool {
    match ty {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "integer" => value.is_i64() || value.is_u64(),
        "number" => value.is_number(),
        "string" => value.is_string(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        other => panic!("no type {other}"),
    }
}
