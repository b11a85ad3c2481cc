//! Tests the adapter with stand-ins for both programs, which print recorded output, or misbehave.

use super::*;
use crate::Observation;
use std::process::Command;

/// A stand-in that does what a comment in the program asks for; otherwise it writes bytecode, which here is the program itself.
const COMPILER: &str = r#"#!/bin/sh
case $(cat program.st) in
*'please: reject'*)
    printf '\033[0m\033[1merror[P4035]\033[0m: does not fit\n  \342\224\214\342\224\200 program.st:3:7\n' >&2
    exit 1 ;;
*'please: say what was recorded'*) cat "$(dirname "$0")/recorded" >&2; exit 1 ;;
*'please: go wrong'*) printf 'error[P9998]: internal\n' >&2; exit 1 ;;
*'please: be unfinished'*) printf 'error[P9999]: not yet\n' >&2; exit 1 ;;
*'please: panic'*) echo "thread 'main' panicked at src/x.rs" >&2; exit 101 ;;
*'please: die'*) kill -ABRT $$ ;;
*'please: forget'*) exit 0 ;;
*'please: take no copies'*'stickler_probe_0'*) printf 'error[P2008]: no such type\n' >&2; exit 1 ;;
esac
cp program.st program.iplc
"#;

const MACHINE: &str = r#"#!/bin/sh
printf 'x: 5\nstickler_probe_0: 7\n'
case $(cat "$2") in
*'please: divide'*) echo 'V4001 - runtime error: divide by zero (task 0, instance 0)' >&2; exit 1 ;;
*'please: trap'*) echo 'V4002 - runtime error: negative exponent' >&2; exit 1 ;;
*'please: overflow'*) echo 'V9001 - stack' >&2; exit 3 ;;
*'please: break over copies'*'stickler_probe_0'*) echo 'V9014 - width' >&2; exit 3 ;;
*'please: stumble over copies'*'stickler_probe_0'*) echo 'V4001 - runtime error: divide by zero' >&2; exit 1 ;;
esac
"#;

/// Writes programs, given as names and shell scripts, into a folder of their own.
pub(in crate::adapters) fn scripts(programs: &[(&str, &str)]) -> Folder {
    let folder = Folder::new().unwrap();
    for (name, text) in programs {
        // Another process writes the file: one that this process still had open for writing, in a child that another test is
        // just starting, could not be run.
        let written = Command::new("sh")
            .args(["-c", r#"printf %s "$1" >"$2" && chmod 700 "$2""#, "sh", text])
            .arg(folder.path().join(name))
            .status();
        assert!(written.unwrap().success());
    }
    folder
}

/// Returns the adapter with its stand-ins, and the folder that holds them.
pub(in crate::adapters) fn stand_in() -> (Ironplc, Folder) {
    let folder = scripts(&[("ironplcc", COMPILER), ("ironplcvm", MACHINE)]);
    folder.write("recorded", diagnostics::RECORDED).unwrap();
    let ironplc = Ironplc {
        identity: Identity {
            name: "ironplc".to_owned(),
            version: "0".to_owned(),
            dialects: vec![DialectName::IRONPLC_ED2],
            abilities: Vec::new(),
            grade: Grade::Code,
            lacks: Vec::new(),
        },
        compiler: folder.path().join("ironplcc"),
        machine: folder.path().join("ironplcvm"),
        texts: ReadableTexts::default(),
    };
    (ironplc, folder)
}

fn asked(what: &str, observe: &[(&str, &str)]) -> Outcome {
    let (engine, _folder) = stand_in();
    let observe: Vec<Observation> = observe
        .iter()
        .map(|&(name, type_name)| Observation::last(name, type_name))
        .collect();
    let source = format!("PROGRAM main\n(* please: {what} *)\nEND_PROGRAM\n");
    engine
        .session()
        .unwrap()
        .run(&RunRequest::once(DialectName::IRONPLC_ED2, &source, &observe))
}

#[test]
fn values_come_from_the_dump_and_from_copies() {
    let executed = asked("run", &[("x", "INT"), ("a[1]", "DINT")]);
    let values = vec![
        ("x".to_owned(), stickler_types::Value::parse("INT#5").unwrap()),
        ("a[1]".to_owned(), stickler_types::Value::parse("DINT#7").unwrap()),
    ];
    assert_eq!(executed, Outcome::executed(values));
}

#[test]
fn a_rejection_is_no_crash_and_a_crash_no_rejection() {
    let Outcome::Rejected { diagnostics } = asked("reject", &[]) else {
        panic!("not rejected")
    };
    assert_eq!(
        (diagnostics[0].code.as_deref(), diagnostics[0].line),
        (Some("P4035"), Some(3))
    );
    assert!(matches!(
        asked("be unfinished", &[]),
        Outcome::NotImplemented { .. }
    ));
    for what in ["panic", "die", "overflow"] {
        assert!(matches!(asked(what, &[]), Outcome::Crashed { .. }), "{what}");
    }
    for what in ["forget", "trap"] {
        assert!(matches!(asked(what, &[]), Outcome::Error { .. }), "{what}");
    }
}

#[test]
fn a_trap_is_a_fault_with_the_values_that_need_no_copy() {
    let outcome = asked("divide", &[("x", "INT"), ("a[1]", "DINT")]);
    let values = vec![("x".to_owned(), stickler_types::Value::parse("INT#5").unwrap())];
    assert_eq!(
        outcome,
        Outcome::Faulted {
            fault: Fault::DivisionByZero,
            line: None,
            values,
            warnings: Vec::new()
        }
    );
}

#[test]
fn where_copies_are_not_accepted_the_program_alone_is_judged() {
    let Outcome::Unsupported { reason } = asked("take no copies", &[("a[1]", "DINT")]) else {
        panic!("supported")
    };
    let prefix = "with copies of its values: rejected: ";
    assert!(
        reason.starts_with(prefix) && reason.ends_with("no such type"),
        "{reason}"
    );
    assert!(matches!(
        asked("take no copies", &[("x", "INT")]),
        Outcome::Executed { .. }
    ));
    assert!(matches!(
        asked("reject", &[("a[1]", "DINT")]),
        Outcome::Rejected { .. }
    ));
}

#[test]
fn what_only_the_copies_do_is_an_error_and_no_crash_or_fault() {
    for what in ["break over copies", "stumble over copies"] {
        let Outcome::Error { message } = asked(what, &[("a[1]", "DINT")]) else {
            panic!("no error: {what}")
        };
        assert!(message.starts_with("its values cannot be read: "), "{message}");
        assert!(matches!(asked(what, &[("x", "INT")]), Outcome::Executed { .. }));
    }
    assert!(matches!(
        asked("overflow", &[("a[1]", "DINT")]),
        Outcome::Crashed { .. }
    ));
    assert!(matches!(
        asked("divide", &[("a[1]", "DINT")]),
        Outcome::Faulted { .. }
    ));
}

#[test]
fn a_value_that_cannot_be_read_is_an_error() {
    let Outcome::Error { message } = asked("run", &[("x", "BOOL")]) else {
        panic!("no error")
    };
    assert_eq!(message, "it shows `5` as BOOL");
}

#[test]
fn texts_are_not_read_where_the_calls_that_read_them_do_not_work() {
    // The stand-in shows no length.
    let Outcome::Unsupported { reason } = asked("run", &[("s", "STRING"), ("x", "INT")]) else {
        panic!("supported")
    };
    assert!(
        reason.starts_with("values of STRING are not shown, and LEN, MID and FIND"),
        "{reason}"
    );
}

#[test]
fn what_it_cannot_do_is_unsupported() {
    let (engine, _folder) = stand_in();
    let mut session = engine.session().unwrap();
    assert!(matches!(
        session.check(DialectName::MATIEC, ""),
        Outcome::Unsupported { .. }
    ));
    let clock = [crate::ClockSetting {
        before: 1,
        nanoseconds: 1,
    }];
    let request = RunRequest {
        dialect: DialectName::IRONPLC_ED2,
        source: "",
        scans: 1,
        observe: &[],
        clock: &clock,
        set: &[],
    };
    assert!(matches!(session.run(&request), Outcome::Unsupported { .. }));
}

#[test]
fn a_trap_is_told_by_its_code() {
    let stderr = "V4001 - runtime error: divide by zero (task 0, instance 0)\n";
    assert_eq!(fault(stderr), Some(Fault::DivisionByZero));
    assert_eq!(fault("V4002 - runtime error: negative exponent"), None);
    assert_eq!(fault(""), None);
}
