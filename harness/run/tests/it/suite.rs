//! Tests of the real suite on the real reference: no state is shared between cases, workers or runs.

use crate::fixtures::events_of_a_twentieth;
use stickler_engines::Reference;

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
