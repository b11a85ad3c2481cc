//! The JSON Schemas of both directions, as they are published in `harness/engines/schemas/`.

use super::{Reply, Request};

/// A schema and the file in which it is published.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Schema {
    /// The file's name.
    pub file: &'static str,
    /// Its text, with a line feed at the end.
    pub text: String,
}

/// The schemas of requests and replies. They describe one line each.
#[must_use]
pub fn schemas() -> [Schema; 2] {
    [
        Schema {
            file: "request.schema.json",
            text: pretty(&schemars::schema_for!(Request)),
        },
        Schema {
            file: "reply.schema.json",
            text: pretty(&schemars::schema_for!(Reply)),
        },
    ]
}

fn pretty(schema: &schemars::Schema) -> String {
    // The alternate form of a JSON value's Display is the pretty one, and cannot fail.
    format!("{:#}\n", schema.as_value())
}
