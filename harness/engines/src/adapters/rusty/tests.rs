//! The adapter with what the compiler's book shows, and with a stand-in for the compiler.

use super::*;
use crate::Observation;
use crate::adapters::ironplc::tests::scripts;
use crate::adapters::places::Places;
use std::io::Write;

/// Of the compiler's book, chapters on the format of its output and on its parser, with another name of the file.
const SHOWN: &str = "program.st:6:5:{6:5-6:16}: error[E037]: Invalid assignment: cannot assign 'STRING' to 'DINT'\n\
                     program.st:4:9:{4:9-4:21}: error[E007]: Unexpected token: expected KeywordSemicolon but found 'text: STRING'\n\
                     error: Compilation aborted due to critical parse errors\n\
                     Unexpected token: expected KeywordSemicolon but found 'text: STRING' at: program.st:3:8:{3:8-3:20}:\n";

/// Does what a comment in the program asks for; otherwise it compiles C that does what the program would.
const COMPILER: &str = r#"#!/bin/sh
case "$*" in *--version*) echo 'plc 9.8.7'; exit 0 ;; esac
case "$*" in *"/include/*.st"*) ;; *) echo 'no declarations' >&2; exit 2 ;; esac
case $(cat program.st) in
*'please: reject'*) cat "$(dirname "$0")/shown" >&2; exit 1 ;;
*'please: panic'*) echo "thread 'main' panicked" >&2; exit 101 ;;
*'please: forget why'*) exit 1 ;;
*'please: take no calls'*'stickler_show'*) echo 'program.st:2:1:{2:1-2:2}: error[E048]: unresolved' >&2; exit 1 ;;
esac
case "$*" in *--check*) exit 0 ;; esac
cat >body.c <<'END'
#include <signal.h>
#include <stdint.h>
int32_t stickler_show_int(int32_t number, uint16_t value);
int32_t stickler_show_time(int32_t number, int64_t value);
int32_t stickler_show_string(int32_t number, char *value);
static uint16_t n;
int32_t stickler_scan(void) {
    n++;
END
case $(cat program.st) in *'please: divide'*) echo 'raise(SIGFPE);' >>body.c ;; esac
cat >>body.c <<'END'
    stickler_show_int(0, -n); stickler_show_int(1, n); stickler_show_time(2, 1500000000); stickler_show_string(3, "a'");
    return 0;
}
END
cc -c body.c -o program.o
"#;

/// The adapter with its stand-in; nothing, and a word about it, where there is no C compiler.
fn stand_in() -> Option<(Rusty, Folder)> {
    let folder = scripts(&[("plc", COMPILER)]);
    folder.write("shown", SHOWN).unwrap();
    std::fs::create_dir(folder.path().join("include")).unwrap();
    std::fs::create_dir(folder.path().join("lib")).unwrap();
    // A static library with nothing in it.
    folder.write("lib/libiec61131std.a", "!<arch>\n").unwrap();
    let places = Places::default()
        .named("plc", folder.path().join("plc"), "a test".to_owned())
        .without_variables();
    match Rusty::find("rusty", &mut Search::new("rusty", &places)) {
        Ok(rusty) => Some((rusty, folder)),
        Err(reason) if reason.contains("`cc`") => {
            // Not `eprintln`, which nobody sees when the test passes.
            let _ = writeln!(std::io::stderr(), "skipped: {reason}");
            None
        }
        Err(reason) => panic!("{reason}"),
    }
}

fn asked(engine: &Rusty, what: &str, scans: u32) -> Outcome {
    let observe = [
        ("x", "INT", None),
        ("a[1]", "INT", Some(2)),
        ("t", "TIME", None),
        ("s", "STRING", None),
    ]
    .map(|(name, type_name, after)| Observation {
        name,
        type_name,
        after,
    });
    let source = format!("PROGRAM main\n(* please: {what} *)\nEND_PROGRAM\n");
    engine.session().unwrap().run(&RunRequest {
        scans,
        ..RunRequest::once(DialectName::IronplcRusty, &source, &observe)
    })
}

#[test]
fn the_program_tells_its_values_to_the_driver_after_each_scan() {
    let Some((engine, _folder)) = stand_in() else {
        return;
    };
    assert_eq!(engine.identity().version, "9.8.7");
    let Outcome::Executed { values } = asked(&engine, "run", 3) else {
        panic!("not executed")
    };
    let values: Vec<String> = values
        .iter()
        .map(|(name, value)| format!("{name} = {value}"))
        .collect();
    assert_eq!(
        values,
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
    let told: Vec<_> = diagnostics
        .iter()
        .map(|told| {
            (
                told.line,
                told.column,
                told.end_column,
                told.code.as_deref().unwrap(),
            )
        })
        .collect();
    assert_eq!(
        told,
        [
            (Some(4), Some(9), Some(21), "E007"),
            (Some(6), Some(5), Some(16), "P4035")
        ]
    );
    assert!(matches!(asked(&engine, "panic", 2), Outcome::Crashed { .. }));
    assert!(matches!(asked(&engine, "forget why", 2), Outcome::Crashed { .. }));
    let divided = asked(&engine, "divide", 2);
    assert!(matches!(divided, Outcome::Faulted { .. }), "{divided:?}");
    let Outcome::Unsupported { reason } = asked(&engine, "take no calls", 2) else {
        panic!("supported")
    };
    assert_eq!(
        reason,
        "the calls that show its values are not accepted: unresolved"
    );
    let mut session = engine.session().unwrap();
    assert_eq!(session.check(DialectName::IronplcRusty, ""), Outcome::Accepted);
    assert!(matches!(
        session.check(DialectName::Matiec, ""),
        Outcome::Unsupported { .. }
    ));
}

#[test]
fn no_line_of_the_program_moves_and_its_name_does_not_meet_that_of_c() {
    let source = "TYPE C : (RED, GREEN); END_TYPE\nPROGRAM main\nVAR x : INT; c : C; END_VAR\n    x := 1; (* main *)\nEND_PROGRAM\n";
    let observe = [("x", "INT"), ("c", "C"), ("s", "STRING")]
        .map(|(name, type_name)| Observation::last(name, type_name));
    let request = RunRequest::once(DialectName::IronplcRusty, source, &observe);
    let kinds = driver(&request).unwrap().subjects.remove(0).kinds;
    let text = instrumented(&request, &main_program(source).unwrap(), &kinds);
    assert_eq!(
        text,
        "TYPE C : (RED, GREEN); END_TYPE\nPROGRAM stickler_program\nVAR x : INT; c : C; END_VAR\n    x := 1; (* main *)\n\
         stickler_show_int(0, x); stickler_show_dint(1, c); stickler_show_string(2, s); END_PROGRAM\n\n\
         {external} FUNCTION stickler_show_dint : DINT VAR_INPUT number : DINT; END_VAR VAR_INPUT value : DINT; END_VAR END_FUNCTION\n\
         {external} FUNCTION stickler_show_int : DINT VAR_INPUT number : DINT; END_VAR VAR_INPUT value : INT; END_VAR END_FUNCTION\n\
         {external} FUNCTION stickler_show_string : DINT VAR_INPUT number : DINT; END_VAR VAR_INPUT {ref} value : STRING; END_VAR END_FUNCTION\n\
         FUNCTION stickler_scan : DINT stickler_program(); END_FUNCTION\n"
    );
}
