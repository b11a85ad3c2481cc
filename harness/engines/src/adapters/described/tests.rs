//! Tests described compilers: the checking half of IronPLC beside its adapter, and stand-ins for others.

use super::*;
use crate::adapters::ironplc::tests::{scripts, stand_in};
use crate::{Observation, RunRequest};

/// The checking half of the adapter `ironplc`, as a table.
const IRONPLC: &str = include_str!("../../../tests/described/ironplc.toml");

/// Returns an engine of a table, whose paths are relative to a folder.
fn engine(table: &str, here: &Folder) -> DescribedEngine {
    DescribedEngine::start("described", toml::from_str(table).unwrap(), here.path()).unwrap()
}

/// Returns an engine whose commands are this shell script, called with the name of the command.
fn scripted(table: &str, script: &str) -> (DescribedEngine, Folder) {
    let folder = scripts(&[("st", script)]);
    (engine(table, &folder), folder)
}

fn please(engine: &dyn Engine, what: &str) -> Outcome {
    let source = format!("PROGRAM main\n(* please: {what} *)\nEND_PROGRAM\n");
    engine.session().unwrap().check(DialectName::IRONPLC_ED2, &source)
}

fn ask(engine: &dyn Engine, what: &str, observe: &[(&str, &str, Option<u32>)], scans: u32) -> Outcome {
    let observe: Vec<Observation> = observe
        .iter()
        .map(|&(name, type_name, after)| Observation {
            after,
            ..Observation::last(name, type_name)
        })
        .collect();
    let source = format!("PROGRAM main\n(* please: {what} *)\nEND_PROGRAM\n");
    engine.session().unwrap().run(&RunRequest {
        scans,
        ..RunRequest::once(DialectName::IRONPLC_ED2, &source, &observe)
    })
}

#[test]
fn the_checking_half_of_ironplc_needs_no_code() {
    let (adapter, folder) = stand_in();
    let described = engine(IRONPLC, &folder);
    assert_eq!(described.identity().grade, Grade::Code);
    for what in [
        "accept",
        "reject",
        "say what was recorded",
        "be unfinished",
        "go wrong",
        "panic",
        "die",
    ] {
        assert_eq!(
            format!("{:?}", please(&described, what))
                .replace("; nothing that it wrote fits its `diagnostic`", ""),
            format!("{:?}", please(&adapter, what)),
            "{what}"
        );
    }
    assert_eq!(please(&described, "accept"), Outcome::ACCEPTED);
    let Outcome::Rejected { diagnostics } = please(&described, "say what was recorded") else {
        panic!("not rejected")
    };
    assert_eq!(diagnostics.len(), 2);
    let outcome = described.session().unwrap().check(DialectName::MATIEC, "");
    let reason = "it does not speak matiec".to_owned();
    assert_eq!(outcome, Outcome::Unsupported { reason });
}

/// A table of a compiler whose compiled programs print values.
const WHOLE: &str = r#"
version = "{here}/st version"
check = "{here}/st check {file}"
compile = ["{here}/st first {file}", "{here}/st second {dialect}"]
run = "{folder}/program {scans}"
render = "{here}/st render {file}"
file = "input.scl"
append = "(* {program} *)"
diagnostic = '^(?<line>\d+): (?<code>E\d+) (?<message>.*)$'
value = '^(?<name>\S+) = (?<value>.*)$'
exit = { 0 = "diagnosed", 4 = "unsupported", 5 = "not-implemented" }
run_exit = { 0 = "accepted", 9 = "subscript-range" }
faults = { "divided by nothing" = "division-by-zero" }
codes = { E037 = "P4035", E9 = "not-implemented" }
environment = { LANGUAGE_OF_TEST = "plain" }
limits = { seconds = 30, run_seconds = 30, cpu_seconds = 30, memory_mib = 1000, output_mib = 1 }
[dialects]
ironplc-ed2 = "second"
"#;

const COMPILER: &str = r#"#!/bin/sh
case $1 in
version) echo 'Structured Text 1.2.3-beta (built today)'; exit 0 ;;
second)
    test "$2" = second || exit 7
    sed -n 's/^.*please: //p' input.scl >wish
    cat >program <<'END'
#!/bin/sh
echo "x = $1"
echo "stickler_probe_0 = 7"
case $(cat wish) in
divide*) echo 'divided by nothing' >&2; exit 3 ;;
leave*) exit 9 ;;
burst*) exit 3 ;;
esac
END
    chmod 700 program
    exit 0 ;;
render) echo "$LANGUAGE_OF_TEST"; exit 0 ;;
esac
case $(cat input.scl) in
*'please: reject'*) echo '3: E037 does not fit'; echo '2: E1 nor does this' ;;
*'please: pass'*) echo 'error: no licence' >&2; exit 4 ;;
*'please: wait'*) echo 'error: no pointers yet' >&2; exit 5 ;;
*'please: be unfinished'*) echo '2: E9 no CASE yet' ;;
*'(* main *)'*) ;;
*) exit 7 ;;
esac
"#;

#[test]
fn a_table_can_say_how_programs_are_compiled_and_run() {
    let (engine, _folder) = scripted(WHOLE, COMPILER);
    assert_eq!(engine.identity().version, "1.2.3-beta");
    let abilities = [Ability::Check, Ability::Execute, Ability::Scans, Ability::Render];
    assert_eq!(engine.identity().abilities, abilities);
    let Outcome::Executed { values, .. } = ask(
        &engine,
        "run",
        &[("x", "INT", None), ("x", "INT", Some(2)), ("a[1]", "DINT", None)],
        3,
    ) else {
        panic!("not executed")
    };
    let values: Vec<String> = values
        .iter()
        .map(|(name, value)| format!("{name} {value}"))
        .collect();
    assert_eq!(values, ["x INT#3", "x@2 INT#2", "a[1] DINT#7"]);
    let text = "plain\n".to_owned();
    let rendered = engine.session().unwrap().render(DialectName::IRONPLC_ED2, "");
    assert_eq!(rendered, Outcome::Rendered { text });
    let reason = "it does not show y".to_owned();
    assert_eq!(
        ask(&engine, "run", &[("y", "INT", None)], 1),
        Outcome::Unsupported { reason }
    );
}

#[test]
fn its_faults_rejections_and_crashes_are_told_apart() {
    let (engine, _folder) = scripted(WHOLE, COMPILER);
    let fault_of = |what| match ask(&engine, what, &[("x", "INT", None)], 1) {
        Outcome::Faulted { fault, values, .. } => (fault.as_str(), values.len()),
        other => panic!("{other:?}"),
    };
    assert_eq!(fault_of("divide"), ("division-by-zero", 1));
    assert_eq!(fault_of("leave"), ("subscript-range", 1));
    assert!(matches!(ask(&engine, "burst", &[], 1), Outcome::Crashed { .. }));
    let Outcome::Rejected { diagnostics } = ask(&engine, "reject", &[], 1) else {
        panic!("not rejected")
    };
    let found: Vec<_> = diagnostics
        .iter()
        .map(|diagnostic| {
            (
                diagnostic.line.unwrap(),
                diagnostic.code.as_deref().unwrap(),
                diagnostic.message.as_str(),
            )
        })
        .collect();
    assert_eq!(
        found,
        [(2, "E1", "nor does this"), (3, "P4035", "E037: does not fit")]
    );
    let reason = "error: no licence".to_owned();
    assert_eq!(please(&engine, "pass"), Outcome::Unsupported { reason });
    for (what, reason) in [
        ("wait", "error: no pointers yet"),
        ("be unfinished", "E9: no CASE yet"),
    ] {
        let reason = reason.to_owned();
        assert_eq!(please(&engine, what), Outcome::NotImplemented { reason });
    }
}

#[test]
fn a_rejection_that_fits_no_pattern_is_a_crash_with_the_words_and_the_pattern_to_mend() {
    let table = "check = \"{here}/st\"\ndiagnostic = '^E(?<line>.)$'\n[dialects]\nironplc-ed2 = \"\"\n";
    let (engine, _folder) = scripted(table, "#!/bin/sh\necho 'no licence' >&2; exit 1\n");
    let Outcome::Crashed { reason } = please(&engine, "check") else {
        panic!("no crash")
    };
    assert!(
        reason.contains("no licence") && reason.ends_with("fits its `diagnostic`"),
        "{reason}"
    );
}

#[test]
fn what_only_runs_programs_checks_by_running_and_rejects_by_its_exit_code() {
    let table =
        "run = \"{here}/st {file}\"\nvalue = '^(?<name>.) (?<value>.)$'\n[dialects]\nironplc-ed2 = \"\"\n";
    let script = "#!/bin/sh\ncase $(cat $1) in *reject*) echo wrong >&2; exit 1 ;; esac\necho 'x 5'\n";
    let (engine, _folder) = scripted(table, script);
    assert_eq!(please(&engine, "accept"), Outcome::ACCEPTED);
    let Outcome::Rejected { diagnostics } = ask(&engine, "reject", &[], 1) else {
        panic!("not rejected")
    };
    assert_eq!(
        (diagnostics[0].message.as_str(), diagnostics[0].line),
        ("wrong", None)
    );
    assert_eq!(engine.identity().grade, Grade::Rejected);
    assert!(matches!(
        ask(&engine, "run", &[("x", "INT", None)], 1),
        Outcome::Executed { .. }
    ));
    let Outcome::Unsupported { reason } = ask(&engine, "run", &[("x", "INT", None)], 2) else {
        panic!("supported")
    };
    assert!(reason.contains("number of scans"), "{reason}");
}

#[test]
fn what_only_runs_programs_passes_its_warnings_on() {
    let table = "run = \"{here}/st {file}\"\nvalue = '^(?<name>.) (?<value>.)$'\n\
                 diagnostic = '^(?<line>\\d+): (?<severity>\\w+): (?<message>.*)$'\n[dialects]\nironplc-ed2 = \"\"\n";
    let script = "#!/bin/sh\necho 'x 5'\necho '2: warning: narrowed' >&2\n";
    let (engine, _folder) = scripted(table, script);
    for outcome in [
        please(&engine, "accept"),
        ask(&engine, "run", &[("x", "INT", None)], 1),
    ] {
        let warnings: Vec<_> = outcome
            .warnings()
            .into_iter()
            .flatten()
            .map(|reported| (reported.line, &*reported.message))
            .collect();
        assert_eq!(warnings, [(Some(2), "narrowed")], "{outcome:?}");
    }
}

#[test]
fn a_program_that_is_not_there_or_may_not_be_executed_is_told_before_the_first_case() {
    let folder = Folder::new().unwrap();
    folder.write("text", "").unwrap();
    for (command, part) in [
        (
            "no-such-compiler {file}",
            "there is no `no-such-compiler` on PATH, which `check` names",
        ),
        ("bin/st {file}", "bin/st`, which `check` names"),
        ("{here}/text {file}", "not executable"),
        (
            "sh {file}\"\nversion = \"sh -c 'echo no licence >&2; exit 3'",
            "its last words: no licence",
        ),
        (
            "sh {file}\"\nversion = \"sh -c 'exit 0'",
            "`version` prints nothing",
        ),
    ] {
        let table = format!("check = \"{command}\"\n[dialects]\nironplc-ed2 = \"\"\n");
        let description: Description = toml::from_str(&table).unwrap();
        let error = DescribedEngine::start("mine", description, folder.path())
            .err()
            .unwrap()
            .to_string();
        assert!(error.contains(part) && error.contains("`mine`"), "{error}");
    }
}

#[test]
fn what_a_table_leaves_out_or_contradicts_is_told() {
    for (table, key, part) in [
        ("check = \"st\"\n[dialects]\n", "dialects", "at least one dialect"),
        (
            "[dialects]\nmatiec = \"\"\n",
            "dialects",
            "needs one of the commands",
        ),
        (
            "run = \"st\"\n[dialects]\nmatiec = \"\"\n",
            "run",
            "needs a `value`",
        ),
        (
            "check = \"st {scans}\"\n[dialects]\nmatiec = \"\"\n",
            "check",
            "in `run` alone",
        ),
        (
            "check = \"st\"\nexit = { 0 = \"diagnosed\" }\n[dialects]\nmatiec = \"\"\n",
            "exit",
            "needs a `diagnostic`",
        ),
    ] {
        let description: Description = toml::from_str(table).unwrap();
        let (at, reason) = description.check().unwrap_err();
        assert_eq!(at, key);
        assert!(reason.contains(part), "{reason}");
    }
    for (table, part) in [
        ("[dialects]\nmatic = \"\"\n", "unknown dialect `matic`"),
        (
            "check = \"st {fiel}\"\n[dialects]\nmatiec = \"\"\n",
            "`{fiel}` stands for nothing",
        ),
        ("check = []\n[dialects]\nmatiec = \"\"\n", "no command"),
        (
            "exit = { 0 = \"fine\" }\n[dialects]\nmatiec = \"\"\n",
            "not `fine`",
        ),
        (
            "exit = { no = \"accepted\" }\n[dialects]\nmatiec = \"\"\n",
            "invalid",
        ),
        (
            "codes = { E1 = \"P0\" }\n[dialects]\nmatiec = \"\"\n",
            "`P0` is no code",
        ),
        (
            "file = \"../x\"\n[dialects]\nmatiec = \"\"\n",
            "no name of a file",
        ),
        ("diagnostic = '('\n[dialects]\nmatiec = \"\"\n", "without closing"),
    ] {
        let error = toml::from_str::<Description>(table).unwrap_err().to_string();
        assert!(error.contains(part), "{error}");
    }
}
