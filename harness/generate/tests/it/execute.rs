//! Tests of the oracle `execute` on hundreds of programs: it finds no failure, and few open questions.

use std::fmt::Write as _;
use stickler_generate::oracles::{InputOutcome, execute};

/// Returns pseudorandom bytes for a seed.
fn bytes(seed: u64) -> Vec<u8> {
    stickler_generate::random::bytes(seed ^ 0x5EED, (seed * 11 % 2000) as usize)
}

#[test]
fn the_reference_gives_what_the_evaluator_gives_and_so_do_all_variants() {
    let (mut failures, mut passed_over) = (String::new(), 0);
    let seeds = crate::seeds(400);
    for seed in 0..seeds {
        match execute::execute(&bytes(seed)) {
            Ok(InputOutcome::Checked) => {}
            Ok(InputOutcome::Skipped(_)) => passed_over += 1,
            Err(failure) => {
                let _ = writeln!(failures, "seed {seed}: {failure}");
            }
        }
    }
    assert_eq!(failures, "");
    assert!(
        passed_over * 5 < seeds,
        "{passed_over} of {seeds} programs are passed over"
    );
}
