//! The wire protocol: JSON Lines over stdin and stdout, one request, one reply, in order.
//!
//! [`Request`] and [`Reply`] are the two directions, and [`serve`] answers requests with any [`Engine`](crate::Engine).
//! Tests compare the JSON Schemas of both with those that are published in `harness/engines/schemas/`. Basis:
//! harness/engines/README.md (the wire protocol).

mod answer;
mod lines;
mod reply;
mod request;
mod server;

pub use reply::{HelloReply, Reply};
pub use request::{ClockMessage, ProgramRequest, Request, RunMessage, SetMessage};
pub use server::serve;

/// The version of the protocol that this crate speaks.
pub const PROTOCOL: u32 = 1;

/// The longest request line that is read, in bytes; a longer one is skipped and answered by an error.
pub const MAX_LINE: usize = 64 << 20;

#[cfg(test)]
mod tests {
    use super::{Reply, Request};
    use std::path::Path;

    /// To write the schemas again after a change of the protocol: `cargo xtask bless`.
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
}
