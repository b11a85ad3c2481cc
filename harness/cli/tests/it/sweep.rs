//! Tests a sweep that is interrupted, and sweeps of engines that are processes.

use crate::common::{STICKLER, interrupt, output, stickler, text, under_way};
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

#[test]
fn ctrl_c_tells_how_far_a_sweep_came() {
    // Billions of texts, so that it cannot end by itself before the signal comes.
    let arguments = ["sweep", "DINT_TO_STRING", "--jobs", "1"];
    let mut sweep = under_way(&mut stickler(Path::new("."), &arguments));
    let mut out = BufReader::new(sweep.stdout.take().expect("a pipe"));
    let mut lines = String::new();
    // These are shown when the handler stands and the sweep is about to begin.
    for _ in 0..2 {
        out.read_line(&mut lines).expect("a line");
    }
    assert!(lines.contains("4,294,967,296 inputs: every DINT"), "{lines}");
    interrupt(&sweep);
    out.read_to_string(&mut lines).expect("the rest");
    assert_eq!(sweep.wait().expect("an end").code(), Some(130), "{lines}");
    assert!(lines.contains("  stopped by Ctrl-C after "), "{lines}");
    assert!(lines.contains(" of 4,294,967,296 inputs ("), "{lines}");
    assert!(lines.contains("  no mismatch so far, "), "{lines}");
}

/// Runs a sweep of an engine, and returns its exit code and output. `COMMAND` in the engine's command line stands for `stickler`.
fn swept(function: &str, dialect: &str, engine: &str) -> (Option<i32>, String) {
    let engine = format!("cmd:{}", engine.replace("COMMAND", &format!("\"{STICKLER}\"")));
    let arguments = [
        "sweep",
        function,
        "--dialect",
        dialect,
        "--jobs",
        "1",
        "--engine",
        &engine,
    ];
    let output = output(Path::new("."), &arguments);
    (output.status.code(), text(&output.stdout))
}

#[test]
fn an_engine_that_is_right_is_swept_by_a_few_programs() {
    let (code, shown) = swept("INT_TO_SINT", "matiec", "COMMAND engine");
    assert_eq!(code, Some(0), "{shown}");
    assert!(shown.contains("  65,536 inputs: every INT\n"), "{shown}");
    assert!(
        shown.contains("  no mismatch among 65,536 answered inputs, "),
        "{shown}"
    );
}

#[test]
fn the_one_input_that_an_engine_gets_wrong_is_named() {
    let wrong =
        "sed -u \"s/:= INT_TO_SINT(operand)/& + BOOL_TO_SINT(operand = INT#4711)/g\" | COMMAND engine";
    let (code, shown) = swept("INT_TO_SINT", "matiec", &format!("sh -c '{wrong}'"));
    assert_eq!(code, Some(1), "{shown}");
    assert!(
        shown.contains("  1 mismatch among 65,536 answered inputs, "),
        "{shown}"
    );
    assert!(
        shown.contains("    INT#4711 gives SINT#104, not SINT#103  (forgeiec-"),
        "{shown}"
    );
    let (code, shown) = swept("INT_TO_SINT", "plcnext", &format!("sh -c '{wrong}'"));
    assert_eq!(code, Some(0), "{shown}");
    assert!(
        shown.contains("  1 result differs where no document says what must come:\n"),
        "{shown}"
    );
}

#[test]
fn an_engine_that_rejects_every_program_could_not_be_run() {
    let rejects = "sed -u \"s/:= INT_TO_SINT(/:= INT_TO_SNIT(/g\" | COMMAND engine";
    let (code, shown) = swept("INT_TO_SINT", "matiec", &format!("sh -c '{rejects}'"));
    assert_eq!(code, Some(3), "{shown}");
    assert!(
        shown.contains("could not be asked INT_TO_SINT in matiec: it rejected"),
        "{shown}"
    );
    assert!(!shown.contains("mismatch"), "{shown}");
}
