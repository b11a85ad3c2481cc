//! Tests that the JSON Schemas published in `harness/engines/schemas/`, one for requests and one for replies, are those of the
//! code.
//!
//! To write them again after a change of the protocol: `cargo xtask bless`.

use super::{Reply, Request};
use std::path::Path;

#[test]
fn golden_schemas_are_those_of_the_code() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("schemas");
    for (file, schema) in [
        ("request.schema.json", schemars::schema_for!(Request)),
        ("reply.schema.json", schemars::schema_for!(Reply)),
    ] {
        // The alternate form of a JSON value's Display is the pretty one.
        let text = format!("{:#}\n", schema.as_value());
        let path = folder.join(file);
        if std::env::var_os("STICKLER_BLESS").is_some() {
            std::fs::write(&path, &text).unwrap();
        }
        let published = std::fs::read_to_string(&path)
            .unwrap_or_default()
            .replace("\r\n", "\n");
        assert!(
            published == text,
            "{file} is out of date; `cargo xtask bless` writes it"
        );
    }
}
