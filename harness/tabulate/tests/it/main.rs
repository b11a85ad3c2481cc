//! The tables of `conformance-cases/conversion` hold what exact arithmetic gives, and those of `conformance-cases/widening` say what it
//! says.

mod by_hand;
mod examples;
mod folder;
mod widening;

use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}
