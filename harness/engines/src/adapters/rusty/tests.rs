//! Tests the adapter with examples of the compiler's book, and with a stand-in for the compiler.

use super::*;
use crate::adapters::dependencies::DependencyPaths;
use crate::adapters::ironplc::tests::scripts;
use crate::process::Ended;
use crate::{Diagnostic, Observation, Severity};
use std::io::Write;
use std::os::unix::process::ExitStatusExt;
use std::process::ExitStatus;
use std::sync::LazyLock;

/// The output of a build of April 2025 about programs with these planted mistakes, with the names of the files changed.
const SAID: &str = "program_0.st:3:7:{3:7-3:8}: warning[E067]: Implicit downcast from 'LREAL' to 'REAL'.\n\
                    program_0.st:6:5:{6:5-6:11}: error[E037]: Invalid assignment: cannot assign 'STRING' to 'INT'\n\
                    program_0.st:4:10:{4:10-4:17}: error[E048]: Could not resolve reference to unknown\n\
                    program_0.st:7:9:{7:9-7:10}: error[E058]: Array access must be in the range 1..2\n\
                    stickler.st:1:132:{1:132-1:133}: warning[E049]: Illegal access to private member main_in_pack_0.n\n\
                    Compilation aborted due to critical errors\n";

/// A stand-in that does what a comment in the first program asks for; otherwise it compiles C that does what the programs
/// would.
const COMPILER: &str = r#"#!/bin/sh
case "$*" in *--version*) echo '0.2.0 (Tue Apr 8 10:00:00 2025 +0200, 1a2b3c4)'; exit 0 ;; esac
case "$*" in *"/include/*.st"*) ;; *) echo 'no declarations' >&2; exit 2 ;; esac
asked=$(cat "$1")
case "$asked" in
*'please: reject'*) cat "$(dirname "$0")/said" >&2; exit 1 ;;
*'please: panic'*) echo "thread 'main' panicked" >&2; exit 101 ;;
*'please: forget why'*) exit 1 ;;
esac
case "$asked $*" in *'please: show nothing'*stickler.st*)
    echo 'stickler.st:1:2:{1:2-1:3}: error[E048]: Could not resolve reference to x' >&2; exit 1 ;;
esac
# In company, these are rejected or name no file.
for file in "$@"; do
    case "$file $(cat "$file" 2>/dev/null)" in
    program_*'wrong among others'*) echo "$file:2:2:{2:2-2:3}: error[E048]: Could not resolve reference to x" >&2; exit 1 ;;
    esac
done
case "$*" in *--check*) exit 0 ;; esac
cat >body.c <<'END'
#include <signal.h>
#include <stdint.h>
int32_t stickler_show_int(int32_t number, uint16_t value);
int32_t stickler_show_time(int32_t number, int64_t value);
int32_t stickler_show_string(int32_t number, char *value);
static uint16_t n;
static char *text = "not initialised";
void __init___program_0_st(void) { text = "a'"; }
END
number=0
for file in "$@"; do
    case "$file" in program_*.st)
        divide=
        case $(cat "$file") in *'please: divide'*) divide='raise(SIGFPE);' ;; esac
        echo "int32_t stickler_scan_$number(void) { n++; $divide return 0; }
        int32_t stickler_look_$number(void) { stickler_show_int(0, -n); stickler_show_int(1, n + $number);
        stickler_show_time(2, 1500000000); stickler_show_string(3, text); return 0; }" >>body.c
        number=$((number + 1)) ;;
    esac
done
cc -c body.c -o program.o
"#;

/// Returns the adapter with its stand-in; prints why it is skipped where there is no C compiler.
fn stand_in() -> Option<(Rusty, Folder)> {
    let folder = scripts(&[("plc", COMPILER)]);
    folder.write("said", SAID).unwrap();
    std::fs::create_dir(folder.path().join("include")).unwrap();
    std::fs::create_dir(folder.path().join("lib")).unwrap();
    // A static library with nothing in it.
    folder.write("lib/libiec61131std.a", "!<arch>\n").unwrap();
    let places = DependencyPaths::default()
        .named("plc", folder.path().join("plc"), "a test".to_owned())
        .without_variables();
    match Rusty::find("rusty", &mut DependencySearch::new("rusty", &places)) {
        Ok(rusty) => Some((rusty, folder)),
        Err(reason) if reason.contains("`cc`") => {
            // Not `eprintln`, which nobody sees when the test passes.
            let _ = writeln!(std::io::stderr(), "skipped: {reason}");
            None
        }
        Err(reason) => panic!("{reason}"),
    }
}

/// The observations of the requests in these tests.
static OBSERVED: LazyLock<[Observation; 4]> = LazyLock::new(|| {
    let early = Observation {
        after: Some(2),
        ..Observation::last("a[1]", "INT")
    };
    [
        Observation::last("x", "INT"),
        early,
        Observation::last("t", "TIME"),
        Observation::last("s", "STRING"),
    ]
});

fn source(what: &str) -> String {
    format!("PROGRAM main\n(* please: {what} *)\nEND_PROGRAM\n")
}

fn request(source: &str, scans: u32) -> RunRequest<'_> {
    RunRequest {
        scans,
        ..RunRequest::once(DialectName::RUSTY, source, &*OBSERVED)
    }
}

fn asked(engine: &Rusty, what: &str, scans: u32) -> Outcome {
    engine.session().unwrap().run(&request(&source(what), scans))
}

/// Returns the values of an outcome, one a line.
fn values(outcome: &Outcome) -> Vec<String> {
    let Outcome::Executed { values, .. } = outcome else {
        panic!("not executed: {outcome:?}")
    };
    let line = |(name, value): &(String, _)| format!("{name} = {value}");
    values.iter().map(line).collect()
}

#[test]
fn the_functions_beside_a_program_tell_its_values_after_each_scan() {
    let Some((engine, _folder)) = stand_in() else {
        return;
    };
    assert_eq!(engine.identity().version, "0.2.0 (1a2b3c4)");
    assert_eq!(
        values(&asked(&engine, "run", 3)),
        [
            "x = INT#-3",
            "a[1]@2 = INT#2",
            "t = TIME#1500ms",
            "s = STRING#'a$''"
        ]
    );
}

#[test]
fn rejections_crashes_and_faults_are_told_apart() {
    let Some((engine, _folder)) = stand_in() else {
        return;
    };
    let Outcome::Rejected { diagnostics } = asked(&engine, "reject", 2) else {
        panic!("not rejected")
    };
    let place = |diagnostic: &Diagnostic| {
        (
            diagnostic.line,
            diagnostic.column,
            diagnostic.end_column,
            diagnostic.code.clone().unwrap(),
        )
    };
    assert_eq!(
        diagnostics.iter().map(place).collect::<Vec<_>>(),
        [
            (Some(4), Some(10), Some(17), "E048".to_owned()),
            (Some(6), Some(5), Some(11), "P4035".to_owned()),
            (Some(7), Some(9), Some(10), "P2027".to_owned())
        ]
    );
    assert!(matches!(asked(&engine, "panic", 2), Outcome::Crashed { .. }));
    assert!(matches!(asked(&engine, "forget why", 2), Outcome::Crashed { .. }));
    let divided = asked(&engine, "divide", 2);
    assert!(matches!(divided, Outcome::Faulted { .. }), "{divided:?}");
    let Outcome::Unsupported { reason } = asked(&engine, "show nothing", 2) else {
        panic!("supported")
    };
    assert_eq!(
        reason,
        "the functions that show its values are not accepted: Could not resolve reference to x"
    );
    let mut session = engine.session().unwrap();
    assert_eq!(session.check(DialectName::RUSTY, ""), Outcome::ACCEPTED);
    assert!(matches!(
        session.check(DialectName::MATIEC, ""),
        Outcome::Unsupported { .. }
    ));
}

#[test]
fn a_pack_tells_of_each_program_what_is_told_of_it_alone() {
    let Some((engine, _folder)) = stand_in() else {
        return;
    };
    let sources = ["run", "wrong among others", "divide", "run"].map(source);
    let requests: Vec<RunRequest<'_>> = sources.iter().map(|source| request(source, 2)).collect();
    let answers = engine.session().unwrap().run_pack(&requests);
    let outcome = |place: usize| match &answers[place] {
        Packed::Answered(outcome) => outcome,
        other => panic!("{place}: {other:?}"),
    };
    assert_eq!(values(outcome(0))[..2], ["x = INT#-2", "a[1]@2 = INT#2"]);
    assert!(matches!(outcome(1), Outcome::Rejected { .. }));
    assert!(matches!(outcome(2), Outcome::Faulted { .. }));
    // The stand-in adds the number of a program to this one.
    assert_eq!(values(outcome(3))[..2], ["x = INT#-2", "a[1]@2 = INT#4"]);
}

#[test]
fn no_line_of_a_program_moves_and_its_name_does_not_meet_that_of_c() {
    let source = "TYPE C : (RED, GREEN); END_TYPE\nPROGRAM main\nVAR x : INT; c : C; END_VAR\n    x := 1; (* main *)\nEND_PROGRAM\n";
    let observe = [("x", "INT"), ("c", "C"), ("s", "STRING")]
        .map(|(name, type_name)| Observation::last(name, type_name));
    let request = RunRequest::once(DialectName::RUSTY, source, &observe);
    let program = PackedProgram::alone(&request).unwrap();
    assert_eq!(
        program.text(),
        source.replace("PROGRAM main", "PROGRAM main_in_pack_0")
    );
    let subjects = [program.subject()];
    let driver = driver(&subjects, "program_0.st").unwrap();
    assert_eq!(
        functions(&subjects, &driver.subjects),
        "FUNCTION stickler_scan_0 : DINT main_in_pack_0(); END_FUNCTION FUNCTION stickler_look_0 : DINT \
         stickler_show_int(0, main_in_pack_0.x); stickler_show_dint(1, main_in_pack_0.c); \
         stickler_show_string(2, main_in_pack_0.s); END_FUNCTION\n\
         {external} FUNCTION stickler_show_dint : DINT VAR_INPUT number : DINT; END_VAR VAR_INPUT value : DINT; END_VAR END_FUNCTION\n\
         {external} FUNCTION stickler_show_int : DINT VAR_INPUT number : DINT; END_VAR VAR_INPUT value : INT; END_VAR END_FUNCTION\n\
         {external} FUNCTION stickler_show_string : DINT VAR_INPUT number : DINT; END_VAR VAR_INPUT {ref} value : STRING; END_VAR END_FUNCTION\n"
    );
}

#[test]
fn among_others_every_name_of_a_program_is_kept_apart_unless_the_language_has_it() {
    let taken = HashSet::from(["TON".to_owned()]);
    let among = |source: &str| {
        let request = RunRequest::once(DialectName::RUSTY, source, &[]);
        PackedProgram::among_others(&request, 7, &taken).map(|program| program.text().to_owned())
    };
    assert_eq!(
        among("FUNCTION F : INT F := 1; END_FUNCTION PROGRAM main VAR w : WORD; END_VAR w.%X3 := f() > 0; END_PROGRAM").unwrap(),
        "FUNCTION F_in_pack_7 : INT F_in_pack_7 := 1; END_FUNCTION PROGRAM main_in_pack_7 VAR w : WORD; END_VAR \
         w.%X3 := f_in_pack_7() > 0; END_PROGRAM"
    );
    for alone in [
        "FUNCTION_BLOCK TON END_FUNCTION_BLOCK PROGRAM main END_PROGRAM",
        "FUNCTION sel : INT END_FUNCTION PROGRAM main END_PROGRAM",
        "PROGRAM main VAR x AT %IX0.0 : BOOL; END_VAR END_PROGRAM",
        "PROGRAM main VAR x_in_pack_1 : BOOL; END_VAR END_PROGRAM",
        "FUNCTION f : INT END_FUNCTION",
    ] {
        assert_eq!(among(alone), None, "{alone}");
    }
}

#[test]
fn warnings_are_told_of_what_is_accepted_and_passed_over_beside_errors() {
    let reader = OutputParser::new().unwrap();
    let warning = "program_7.st:2:3:{2:3-2:4}: warning[E067]: Implicit downcast from 'LREAL' to 'SINT'.\n";
    let reported = |code: i32, stderr: String| {
        let ended = Ended {
            status: ExitStatus::from_raw(code << 8),
            stdout: String::new(),
            stderr,
        };
        let found = reader.diagnostics(&ended).unwrap();
        found
            .into_iter()
            .map(|(_, reported)| {
                (
                    reported.severity,
                    reported.code.unwrap_or_default(),
                    reported.line,
                )
            })
            .collect::<Vec<_>>()
    };
    let expected = (Severity::Warning, "E067".to_owned(), Some(2));
    assert_eq!(reported(0, warning.to_owned()), [expected]);
    let error = "program_7.st:3:3:{3:3-3:4}: error[E037]: no\n";
    let expected = (Severity::Error, "E037".to_owned(), Some(3));
    assert_eq!(reported(1, format!("{warning}{error}")), [expected]);
}

#[test]
fn what_stops_the_compiler_is_told_the_same_each_time() {
    let reader = OutputParser::new().unwrap();
    let ended = |code: i32, stderr: &str| Ended {
        // As `wait` tells it: the exit code, or the signal.
        status: ExitStatus::from_raw(code),
        stdout: String::new(),
        stderr: stderr.to_owned(),
    };
    let said = "program_7.st:2:3:{2:3-2:4}: warning[E067]: Implicit downcast from 'LREAL' to 'SINT'.\n\
                LLVM ERROR: Cannot select: 0x563c1fd96888: i8 = bitcast 0x563c1fd96340\nIn function: main_in_pack_7\n";
    let Err(Outcome::Crashed { reason }) = reader.diagnostics(&ended(6, said)) else {
        panic!("no crash")
    };
    assert!(
        reason.ends_with("LLVM ERROR: Cannot select: 0x… i8 = bitcast 0x… | In function: main_in_pack_7"),
        "{reason}"
    );
    let said = "thread 'main' (23300) panicked at src/ast.rs:1295:18:\nnot implemented\n\
                note: run with `RUST_BACKTRACE=1` environment variable to display a backtrace\n";
    let Err(Outcome::Crashed { reason: panicked }) = reader.diagnostics(&ended(101 << 8, said)) else {
        panic!("no crash")
    };
    assert!(
        panicked.ends_with("thread 'main' panicked at src/ast.rs:1295:18: | not implemented"),
        "{panicked}"
    );
    let said = "thread 'main' panicked at /home/x/.cargo/registry/src/index.example-1949cf8c/inkwell-0.2.0/src/enums.rs:294:13:\n";
    let Err(Outcome::Crashed { reason: panicked }) = reader.diagnostics(&ended(101 << 8, said)) else {
        panic!("no crash")
    };
    assert!(
        panicked.ends_with("thread 'main' panicked at inkwell-0.2.0/src/enums.rs:294:13:"),
        "{panicked}"
    );
    assert_eq!(crate::adapters::rename::places_named(&reason), [7]);
    // It gives no more of a reason where it cannot write the initial values of a program.
    let found = reader
        .diagnostics(&ended(1 << 8, "Some initial values were not generated\n"))
        .unwrap();
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].0, ErrorPart::Elsewhere);
    assert_eq!(found[0].1.message, "Some initial values were not generated");
    // Here it counts lines and columns from 0. Basis: rusty: book, chapter on the parser, with another name of the file.
    let said = "Unexpected token: expected KeywordSemicolon but found 'text: STRING' at: program_3.st:3:8:{3:8-3:20}: \n";
    let found = reader.diagnostics(&ended(1 << 8, said)).unwrap();
    let (about, diagnostic) = &found[0];
    assert_eq!(*about, ErrorPart::Program(3));
    assert_eq!(
        (diagnostic.line, diagnostic.column, diagnostic.end_column),
        (Some(4), Some(9), Some(21))
    );
    assert!(
        diagnostic.message.ends_with("'text: STRING'"),
        "{}",
        diagnostic.message
    );
}

#[test]
fn a_version_is_short_whatever_a_build_knows_of_itself() {
    for (said, shortened) in [
        (
            "0.2.0 (Tue Apr 8 10:00:00 2025 +0200, 1a2b3c4)",
            "0.2.0 (1a2b3c4)",
        ),
        ("0.1.0 (, )", "0.1.0"),
        ("plc 9.8.7", "9.8.7"),
        ("version information unavailable", "unknown"),
    ] {
        assert_eq!(short(said), shortened);
    }
}

#[test]
fn the_shared_library_is_made_of_the_static_one_where_there_is_one() {
    let Some((engine, folder)) = stand_in() else {
        return;
    };
    // As cargo leaves it: without the functions that are written in Structured Text.
    folder.write("lib/libiec61131std.so", "").unwrap();
    let found = folder.path().join("lib");
    let shared = engine.library.shared(&engine.builder).unwrap();
    assert_ne!(shared, found);
    assert!(shared.join("libiec61131std.so").metadata().unwrap().len() > 0);
    let mut path = OsString::from("-Wl,-rpath,");
    path.push(shared);
    assert!(engine.linked().unwrap().contains(&path));
    let again = || StandardLibrary::new(found.clone());
    folder.write("lib/libiec61131std.a", "no archive").unwrap();
    let broken = again();
    let reason = broken.shared(&engine.builder).unwrap_err();
    assert!(
        reason.starts_with("no shared library can be made of `"),
        "{reason}"
    );
    std::fs::remove_file(found.join("libiec61131std.a")).unwrap();
    assert_eq!(again().shared(&engine.builder).unwrap(), found);
    std::fs::remove_file(found.join("libiec61131std.so")).unwrap();
    let missing = again();
    let reason = missing.shared(&engine.builder).unwrap_err();
    assert!(reason.contains("STICKLER_RUSTY_LIB"), "{reason}");
}
