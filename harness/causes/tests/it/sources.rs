//! Finds the causes of a compiler for which Stickler's own sources speak: who is cited for them.

use crate::fixtures::{self, titles};
use crate::normal_forms::{DefectiveCompiler, as_the_reference, dying};
use std::path::Path;
use std::sync::Arc;
use stickler_causes::SearchLimits;
use stickler_engines::{Outcome, RunRequest};
use stickler_run::{Cause, Fact};
use stickler_suite::{Acceptance, Case, Expectation, Suite};
use stickler_types::Diagnostic;

/// Returns the causes of IronPLC with a defect, of cases with these bases.
fn causes(run: fn(&RunRequest<'_>) -> Outcome, cases: Vec<Case>) -> Vec<Cause> {
    let mut compiler = DefectiveCompiler::new(run);
    compiler.identity.name = "ironplc".to_owned();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
    let mut suite = Suite::load_files(&folder, &[], |_, _| false);
    suite.cases = cases;
    fixtures::causes(&suite, &compiler, 1, SearchLimits::default())
}

fn with_basis(basis: &str, case: Case) -> Case {
    Case {
        basis: basis.into(),
        ..case
    }
}

/// Cannot read repeated values of a list.
fn without_repetition(request: &RunRequest<'_>) -> Outcome {
    let line = request.source.lines().position(|line| line.contains("[2("));
    let Some(line) = line else {
        return as_the_reference(request);
    };
    Outcome::Rejected {
        diagnostics: vec![Diagnostic {
            code: Some("P0002".to_owned()),
            line: Some(line as u32 + 1),
            ..Diagnostic::default()
        }],
    }
}

#[test]
fn what_cannot_be_read_is_cited_by_who_promises_it_and_not_by_a_claim_about_its_values() {
    let program = "PROGRAM main\nVAR\nlist : ARRAY[0..1] OF DINT := [2(INT#1)];\ninto : DINT;\nEND_VAR\ninto := list[0];\n\
                   END_PROGRAM\n";
    let claim = "ironplc-type-conversions: Integer widening";
    let case = with_basis(claim, fixtures::case("t::a", program, "into = DINT#1"));
    let accepted = Expectation::default();
    let case = Case {
        expectation: Arc::new(accepted),
        observe: Vec::new().into(),
        ..case
    };
    let found = causes(without_repetition, vec![case]);
    assert_eq!(
        found[0].shown.basis,
        "iec-61131-3: Annex A",
        "{:?}",
        titles(&found)
    );
}

/// Has no outputs of functions.
fn without_outputs(request: &RunRequest<'_>) -> Outcome {
    match request.source.contains("=>") {
        true => Outcome::NotImplemented {
            reason: "P9999: call with an output".to_owned(),
        },
        false => as_the_reference(request),
    }
}

#[test]
fn an_output_that_is_not_implemented_is_shown_without_the_bit_that_takes_it() {
    let program = "FUNCTION half : INT\nVAR_INPUT\nin : INT;\nEND_VAR\nVAR_OUTPUT\nodd : BOOL;\nEND_VAR\nodd := in.0;\nhalf := in / 2;\n\
                   END_FUNCTION\nPROGRAM main\nVAR\nflags : WORD;\ninto : INT;\nEND_VAR\ninto := half(in := 5, odd => flags.0);\nEND_PROGRAM\n";
    let case = with_basis(
        "ironplc-bit-access: Bit Access",
        fixtures::case("t::a", program, "into = INT#2"),
    );
    let found = causes(without_outputs, vec![case]);
    let shown = &found[0].shown;
    assert!(shown.program.contains("=> received"), "{}", shown.program);
    assert_eq!(shown.basis, "iec-61131-3: 6.6.1.4.2");
}

#[test]
fn a_program_that_only_a_rule_forbids_and_that_dies_has_died() {
    let program = "PROGRAM main\nVAR\nfrom : DINT;\ninto : INT;\nEND_VAR\ninto := from;\nEND_PROGRAM\n";
    let of = |basis: &str| {
        let case = with_basis(basis, fixtures::case("t::a", program, "6 P4035"));
        causes(dying, vec![case])[0].shown.got.clone()
    };
    let crashed = |got: &[Fact]| matches!(got, [Fact::Crashed { .. }]);
    assert!(crashed(&of("rule: real-literal-range")));
    assert!(!crashed(&of("ironplc-problem-codes: P4035")));
}

/// Crashes for a selector that is a real number.
fn crashes_for_reals(request: &RunRequest<'_>) -> Outcome {
    match request.source.contains("CASE r OF") {
        true => Outcome::Crashed {
            reason: "it met a real number".to_owned(),
        },
        false => as_the_reference(request),
    }
}

#[test]
fn a_crash_of_a_program_that_nobody_decides_is_made_small() {
    let program = "PROGRAM main\nVAR\nn : INT;\nr : REAL;\nb : BOOL;\nEND_VAR\nCASE b OF 1: n := 1; END_CASE;\n\
                   CASE r OF 1: n := 1; END_CASE;\nEND_PROGRAM\n";
    let case = fixtures::case("t::a", program, "7 P4053");
    let case = Case {
        expectation: Arc::new(Expectation {
            accepted: Acceptance::Observed,
            ..Expectation::default()
        }),
        ..case
    };
    let found = causes(crashes_for_reals, vec![case]);
    assert!(
        !found[0].shown.program.contains("CASE b"),
        "{}",
        found[0].shown.program
    );
}
