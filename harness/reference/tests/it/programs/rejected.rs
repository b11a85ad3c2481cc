//! Programs that are not acceptable: codes, lines, places and suggestions.

use super::support::{
    DIALECT, assert_diagnostics, assert_diagnostics_in, attempt, code, code_and_line, place, program,
};
use stickler_reference::{check, check_bytes, render};
use stickler_types::{Code, DialectName, Outcome};

#[test]
fn a_suggestion_replaces_its_place_and_makes_the_program_acceptable() {
    let source = program("i : INT; d : DINT := 5;", "i := d;");
    let found = check(&source, DIALECT);
    let [mismatch] = &found[..] else {
        panic!("{found:#?}")
    };
    assert_eq!(
        (code(mismatch), place(&source, mismatch)),
        (Code::AssignmentTypeMismatch, "d")
    );
    assert_eq!(mismatch.suggestion.as_deref(), Some("DINT_TO_INT(d)"));
    assert_diagnostics(&source.replace("i := d", "i := DINT_TO_INT(d)"), &[]);
}

#[test]
fn each_context_has_its_code() {
    let source = "FUNCTION F : INT VAR_INPUT a : INT; END_VAR VAR_OUTPUT o : DINT; END_VAR
    F := o;
END_FUNCTION
PROGRAM main VAR d : DINT; i : INT :=
    d; s : SINT; END_VAR
    i := F(
        d);
    s := F(i);
    i := F(i, o =>
        s);
    i := d;
END_PROGRAM";
    let expected = [
        (Code::AssignmentTypeMismatch, 2),
        (Code::InitializerTypeMismatch, 5),
        (Code::FunctionCallArgTypeMismatch, 7),
        (Code::FunctionCallReturnTypeMismatch, 8),
        (Code::AssignmentTypeMismatch, 10),
        (Code::AssignmentTypeMismatch, 11),
    ];
    assert_diagnostics(source, &expected);
}

#[test]
fn all_errors_of_a_source_are_said_at_once() {
    let source = program("i : INT; r : REAL;", "i := nobody;\ni := r;\ni := ;\nr := i;");
    let expected = [
        (Code::VariableUndefined, 5),
        (Code::AssignmentTypeMismatch, 6),
        (Code::SyntaxError, 7),
    ];
    let found = check(&source, DIALECT);
    assert_eq!(
        found.iter().map(code_and_line).collect::<Vec<_>>(),
        expected,
        "{found:#?}"
    );
}

#[test]
fn what_is_not_enabled_is_all_that_is_said_about_it() {
    let source = program("b : BYTE; i : INT; t : LTIME;", "i := b.%X3;\nt := T#1s;");
    let expected = [(Code::Std2013Feature, 3), (Code::PartialAccessSyntaxDisabled, 5)];
    assert_diagnostics_in(DialectName::IRONPLC_ED2, &source, &expected);
}

#[test]
fn a_bit_outside_its_type_is_rejected() {
    let source = program("b : BYTE; r : BOOL;", "r := b.7;\nr := b.8;\nr.0 := TRUE;");
    let expected = [(Code::BitAccessOutOfRange, 6), (Code::BitAccessTypeInvalid, 7)];
    let found = check(&source, DIALECT);
    assert_eq!(
        found.iter().map(|found| code(found).as_str()).collect::<Vec<_>>(),
        ["P4025", "P4069"],
        "{found:#?}"
    );
    assert_diagnostics(&source, &expected);
}

#[test]
fn a_text_without_a_program_is_acceptable_and_cannot_be_run() {
    let source = "FUNCTION F : INT\n    F := 1;\nEND_FUNCTION\n\n(* the end *)\n";
    assert_diagnostics(source, &[]);
    match attempt(DIALECT, source, &["x"]) {
        Ok(Outcome::Rejected { diagnostics: found }) => {
            let places: Vec<_> = found.iter().map(code_and_line).collect();
            assert_eq!(places, [(Code::NoProgramDeclaration, 3)]);
        }
        other => panic!("{other:#?}"),
    }
}

#[test]
fn bytes_that_are_no_text_are_diagnosed() {
    let (text, found) = check_bytes(
        b"\xEF\xBB\xBFPROGRAM main\nVAR b\xFFd : INT; END_VAR\nEND_PROGRAM",
        DIALECT,
    );
    assert!(text.starts_with("PROGRAM main"));
    assert_eq!(found.first().map(code_and_line), Some((Code::UnexpectedToken, 2)));
}

#[test]
fn rendering_is_stable_and_refuses_what_cannot_be_read() {
    let source = program(
        "b : ARRAY[1..2] OF BYTE; r : BOOL;",
        "r := b[ 1 ].%X3; (* gone *)",
    );
    let rendered = render(&source, DIALECT).expect("it can be read");
    assert!(rendered.contains("r := b[1].3;"), "{rendered}");
    assert_eq!(render(&rendered, DIALECT).as_ref(), Ok(&rendered));
    let refused = render(&source, DialectName::IRONPLC_ED2).expect_err("the form is not enabled");
    assert_eq!(
        refused
            .iter()
            .map(|found| code(found).as_str())
            .collect::<Vec<_>>(),
        ["P4033"]
    );
    assert!(render("PROGRAM main x := ; END_PROGRAM", DIALECT).is_err());
}
