//! The published schemas are the ones that the code generates. To write them anew after a change of the
//! protocol: `STICKLER_BLESS=1 cargo test -p stickler-engines --test it schemas`.

use std::path::Path;
use stickler_engines::protocol::schemas;

#[test]
fn published_schemas_are_those_of_the_code() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("schemas");
    for schema in schemas() {
        let path = folder.join(schema.file);
        if std::env::var_os("STICKLER_BLESS").is_some() {
            std::fs::write(&path, &schema.text).unwrap();
        }
        let published = std::fs::read_to_string(&path)
            .unwrap_or_default()
            .replace("\r\n", "\n");
        assert!(
            published == schema.text,
            "{} is out of date; run STICKLER_BLESS=1 cargo test -p stickler-engines --test it schemas",
            schema.file
        );
    }
}
