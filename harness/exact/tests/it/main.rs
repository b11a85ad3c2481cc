//! Tests of the crate's public functions, in one test program to save linking time.

mod basis;
mod calls;
mod catalogue;
mod round_trips;
mod small_sources;

use stickler_exact::{Signature, functions, signatures};
use stickler_types::DialectName;

/// Returns the signatures of all functions of a dialect.
fn all_signatures(dialect: DialectName) -> impl Iterator<Item = Signature> {
    let names = functions(dialect).into_iter();
    names.flat_map(move |name| signatures(&name, dialect))
}
