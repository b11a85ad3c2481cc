//! Tests that the reference gives what IEC 60559 and two's complement suggest where no document says what a function gives.
//!
//! The suite only records such values, so no case could find the reference to be wrong there. The reference says of itself that it
//! gives them; here the exact arithmetic holds it to that.

use std::path::Path;
use stickler_engines::{Engine, Observation, Outcome, Reference, RunRequest};
use stickler_tabulate::folder::{self, CallTable, Suggestion};
use stickler_types::{BitsAsReal, Dialect, join};
use stickler_workers::{SpawnError, WorkerPool};

/// Describes a suggestion that the reference does not follow; returns `None` where it follows it.
fn complaint(suggestion: &Suggestion, reference: &Reference) -> Option<String> {
    let observe = [Observation::last("into", suggestion.ty.name())];
    let request = RunRequest::once(suggestion.dialect, &suggestion.program, &observe);
    let Ok(mut session) = reference.session() else {
        return Some("the reference has no session".to_owned());
    };
    let given = match session.run(&request) {
        Outcome::Executed { values, .. } if values.iter().any(|(_, value)| *value == suggestion.value) => {
            return None;
        }
        Outcome::Executed { values, .. } => join(values.iter().map(|(_, value)| value), ", "),
        other => format!("{other:?}"),
    };
    Some(format!(
        "{} in {}: {} is suggested, the reference gives {given}",
        suggestion.place, suggestion.dialect, suggestion.value
    ))
}

#[test]
fn the_reference_gives_what_the_design_suggests_where_no_document_speaks() {
    let reference = Reference::new();
    let tables = folder::call_tables(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")).unwrap();
    let mut suggestions: Vec<Suggestion> = tables.iter().flat_map(CallTable::suggestions).collect();
    // The sign of a NaN that a program computes is the processor's, and shows where the bits of a real are copied.
    let copies_bits = |dialect| Dialect::of(dialect).conversions.bits_as_real == BitsAsReal::Copy;
    suggestions
        .retain(|one| !(one.ty.is_bit_string() && one.place.contains("NaN") && copies_bits(one.dialect)));
    assert!(suggestions.len() > 19_000, "{} suggestions", suggestions.len());
    let complaints: Vec<Vec<String>> = WorkerPool::new(0)
        .map(
            suggestions.chunks(64),
            || Ok(()),
            |(), suggestions| {
                let complaints = suggestions.iter().filter_map(|one| complaint(one, &reference));
                Ok::<_, SpawnError>(complaints.collect())
            },
        )
        .unwrap();
    let complaints = complaints.concat();
    let shown = join(complaints.iter().take(30), "\n");
    let (missed, all) = (complaints.len(), suggestions.len());
    assert!(
        missed == 0,
        "{missed} of {all} suggestions are not followed:\n{shown}"
    );
}
