//! The tables of `conformance-cases/conversion` hold what exact arithmetic gives.

mod by_hand;
mod examples;
mod folder;

use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}
