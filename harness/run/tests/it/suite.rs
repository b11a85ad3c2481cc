//! Tests of the real suite on the real reference: no state is shared between cases, workers or runs.

use crate::fixtures::events_of_a_twentieth;
use std::path::Path;
use stickler_engines::{EngineSession, Reference};
use stickler_run::{Grade, Verdict, ask, judge};
use stickler_suite::{Suite, Wanted};

#[test]
fn two_runs_of_the_suite_give_the_same_events_but_for_durations() {
    // Tests beside this one define dialects, which a reference that is made later speaks.
    let reference = Reference::new();
    let alone = events_of_a_twentieth(&reference, 1);
    assert!(alone.len() > 100, "only {} events", alone.len());
    for (first, second) in alone.iter().zip(&events_of_a_twentieth(&reference, 4)) {
        assert_eq!(first, second);
    }
    assert_eq!(alone.len(), events_of_a_twentieth(&reference, 2).len());
}

/// Whatever stands in a program, its meaning and the lines of what is expected of it stay the same without its marks.
#[test]
fn the_reference_meets_cases_without_their_marks() {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
    let suite = Suite::load_files(&cases, Wanted::default(), |id, _| id.starts_with("language/"));
    let reference = Reference::new();
    let mut session = EngineSession::new(&reference);
    let mut seen = 0;
    for case in &suite.cases {
        let unmarked = case.without_marks();
        assert!(!unmarked.source.contains("(*!"), "{}", case.id);
        let answers = ask(&mut session, &unmarked).unwrap();
        let judgement = judge(&unmarked, &answers, Grade::Code);
        assert_eq!(
            judgement.verdict,
            Verdict::Pass,
            "{}: {judgement:?}\n{}",
            case.key(),
            unmarked.source
        );
        seen += 1;
    }
    assert!(seen > 1000, "only {seen} cases");
}
