//! Tests real compilers behind their adapters. Where a compiler is not installed, its test says so and passes.

use std::io::Write;
use stickler_engines::{
    Compiler, DependencyPaths, DescribedEngine, Description, Engine, Observation, Outcome, Packed, RunRequest,
};
use stickler_types::{DialectName, Fault};

/// Returns the compiler's engine; prints why it is skipped where there is none.
fn here(compiler: Compiler) -> Option<Box<dyn Engine>> {
    match compiler.engine(compiler.name()) {
        Ok(engine) => Some(engine),
        Err(error) => {
            // Not `eprintln`, which nobody sees when the test passes.
            let _ = writeln!(std::io::stderr(), "skipped: {error}");
            None
        }
    }
}

fn ask(engine: &dyn Engine, source: &str, observe: &[(&str, &str, Option<u32>)], scans: u32) -> Outcome {
    let observe: Vec<Observation> = observe
        .iter()
        .map(|&(name, type_name, after)| Observation {
            after,
            ..Observation::last(name, type_name)
        })
        .collect();
    engine.session().unwrap().run(&RunRequest {
        scans,
        ..RunRequest::once(engine.identity().dialects[0], source, &observe)
    })
}

fn values(outcome: Outcome) -> Vec<String> {
    let Outcome::Executed { values, .. } = outcome else {
        panic!("not executed: {outcome:?}")
    };
    values
        .iter()
        .map(|(name, value)| format!("{name} = {value}"))
        .collect()
}

/// Checks the behaviour that every compiler of Structured Text has in common.
fn behaves(engine: &dyn Engine) {
    let source = "TYPE PAIR : STRUCT a : INT; b : DINT; END_STRUCT; END_TYPE\n\
                  FUNCTION ADDED : INT\nVAR_INPUT x : INT; END_VAR\n    ADDED := x + 1;\nEND_FUNCTION\n\
                  PROGRAM main\nVAR\n    n : INT;\n    x : BOOL;\n    list : ARRAY[1..2] OF INT;\n    both : PAIR;\n    \
                  letters : STRING := 'a~b';\n    ratio : REAL := 0.1;\nEND_VAR\n    n := ADDED(n);\n    x := n > 1;\n    \
                  list[2] := n;\n    both.b := 7;\nEND_PROGRAM\n";
    let observe = [
        ("n", "INT", None),
        ("n", "INT", Some(1)),
        ("x", "BOOL", None),
        ("list[2]", "INT", None),
        ("both.b", "DINT", None),
        ("letters", "STRING", None),
        ("ratio", "REAL", None),
    ];
    assert_eq!(
        values(ask(engine, source, &observe, 3)),
        [
            "n = INT#3",
            "n@1 = INT#1",
            "x = BOOL#TRUE",
            "list[2] = INT#3",
            "both.b = DINT#7",
            "letters = STRING#'a~b'",
            "ratio = REAL#0.1"
        ]
    );
    let source = "PROGRAM main\nVAR\n    n : INT;\nEND_VAR\n    n := unknown;\nEND_PROGRAM\n";
    let Outcome::Rejected { diagnostics } = ask(engine, source, &[], 1) else {
        panic!("not rejected")
    };
    assert_eq!(diagnostics[0].line, Some(5));
    let dialect = engine.identity().dialects[0];
    let mut session = engine.session().unwrap();
    assert!(matches!(session.check(dialect, source), Outcome::Rejected { .. }));
    let accepted = session.check(
        dialect,
        "PROGRAM main\nVAR\n    n : INT;\nEND_VAR\n    n := 1;\nEND_PROGRAM\n",
    );
    assert_eq!(accepted, Outcome::ACCEPTED);
}

fn divides_by_zero(engine: &dyn Engine) {
    let source = "PROGRAM main\nVAR\n    n : INT;\n    q : INT;\nEND_VAR\n    q := 5 / n;\nEND_PROGRAM\n";
    let outcome = ask(engine, source, &[], 1);
    assert!(
        matches!(
            outcome,
            Outcome::Faulted {
                fault: Fault::DivisionByZero,
                ..
            }
        ),
        "{outcome:?}"
    );
}

/// Checks that variables of an alias and of a subrange type are read.
fn reads_derived_types(engine: &dyn Engine) {
    let source = "TYPE LENGTH : INT; PERCENT : INT (0..100); END_TYPE\n\
                  PROGRAM main\nVAR\n    l : LENGTH;\n    p : PERCENT;\nEND_VAR\n    l := -5;\n    p := 6;\nEND_PROGRAM\n";
    let observe = [("l", "INT", None), ("p", "INT", None)];
    assert_eq!(
        values(ask(engine, source, &observe, 1)),
        ["l = INT#-5", "p = INT#6"]
    );
}

/// Programs with every kind of outcome, some of which declare the same names.
const COMPANY: [&str; 12] = [
    "TYPE COLOR : (RED, GREEN); END_TYPE\nPROGRAM main\nVAR c : COLOR; n : INT; END_VAR\n    c := GREEN;\n    \
     IF c = GREEN THEN n := 1; END_IF;\nEND_PROGRAM\n",
    "TYPE COLOR : (GREEN, RED); END_TYPE\nPROGRAM main\nVAR c : COLOR := RED; n : INT; END_VAR\n    c := GREEN;\n    \
     IF c = GREEN THEN n := 2; END_IF;\nEND_PROGRAM\n",
    "FUNCTION ADDED : INT\nVAR_INPUT x : INT; END_VAR\n    ADDED := x + 3;\nEND_FUNCTION\n\
     PROGRAM main\nVAR n : INT; END_VAR\n    n := ADDED(n);\nEND_PROGRAM\n",
    "FUNCTION_BLOCK ADDED\nVAR_INPUT x : INT; END_VAR\nVAR y : INT; END_VAR\n    y := y + x;\nEND_FUNCTION_BLOCK\n\
     PROGRAM main\nVAR b : ADDED; n : INT; END_VAR\n    b(x := 4);\n    n := 4;\nEND_PROGRAM\n",
    "PROGRAM main\nVAR n : INT; END_VAR\n    n := unknown;\nEND_PROGRAM\n",
    "FUNCTION NUMBER : INT\nVAR_INPUT x : INT; END_VAR\n    NUMBER := x;\nEND_FUNCTION\n\
     PROGRAM main\nVAR n : INT; s : STRING; END_VAR\n    n := NUMBER(s) + NUMBER(s);\n    s := n;\nEND_PROGRAM\n",
    "PROGRAM main\nVAR n : INT; END_VAR\n    n := ;\nEND_PROGRAM\n",
    "PROGRAM main\nVAR n : INT; END_VAR\n    n := 5;\n    IF n > 1 THEN\nEND_PROGRAM\n",
    "PROGRAM main\nVAR n : INT; z : INT; END_VAR\n    n := 5 / z;\nEND_PROGRAM\n",
    "PROGRAM main\nVAR n : INT; list : ARRAY[1..3] OF INT; END_VAR\n    list[2] := 8;\n    n := list[2];\nEND_PROGRAM\n",
    "PROGRAM other\nVAR n : INT; END_VAR\n    n := 10;\n    RETURN;\nEND_PROGRAM\n",
    "(* a comment that does not end PROGRAM main\nVAR n : INT; END_VAR\nEND_PROGRAM\n",
];

/// Checks that running in packs gives the same outcomes as running alone.
fn packs(engine: &dyn Engine) {
    let observe = [Observation::last("n", "INT")];
    let requests: Vec<RunRequest<'_>> = COMPANY
        .iter()
        .map(|source| RunRequest {
            scans: 2,
            ..RunRequest::once(engine.identity().dialects[0], source, &observe)
        })
        .collect();
    assert!(engine.pack_size() > requests.len());
    let mut session = engine.session().unwrap();
    let alone: Vec<Outcome> = requests.iter().map(|request| session.run(request)).collect();
    let packed = session.run_pack(&requests);
    let mut left = Vec::new();
    for ((source, alone), packed) in COMPANY.iter().zip(&alone).zip(packed) {
        match packed {
            Packed::Answered(outcome) => assert_eq!(&outcome, alone, "{source}"),
            Packed::Alone | Packed::Unknown => left.push(*source),
        }
    }
    assert!(left.len() <= 4, "the pack tells nothing about {left:#?}");
    let executed = |outcome: &&Outcome| matches!(outcome, Outcome::Executed { .. });
    let rejected = |outcome: &&Outcome| matches!(outcome, Outcome::Rejected { .. });
    let counted = (
        alone.iter().filter(executed).count(),
        alone.iter().filter(rejected).count(),
    );
    assert!(counted.0 >= 5 && counted.1 >= 4, "{counted:?}: {alone:#?}");
}

#[test]
fn matiec_packs() {
    if let Some(engine) = here(Compiler::Matiec) {
        packs(engine.as_ref());
    }
}

#[test]
fn strucpp_packs() {
    if let Some(engine) = here(Compiler::Strucpp) {
        packs(engine.as_ref());
    }
}

#[test]
fn ironplc_behaves() {
    let Some(engine) = here(Compiler::Ironplc) else {
        return;
    };
    behaves(engine.as_ref());
    divides_by_zero(engine.as_ref());
    let source = "PROGRAM main\nVAR\n    letters : STRING := '$$x';\n    dollar : STRING;\n    wide : WSTRING := \"a~b\";\n\
                  END_VAR\n    dollar := MID(letters, 1, 1);\nEND_PROGRAM\n";
    let observe = [("dollar", "STRING", None), ("wide", "WSTRING", None)];
    assert_eq!(
        values(ask(engine.as_ref(), source, &observe, 1)),
        ["dollar = STRING#'$$'", "wide = WSTRING#\"a~b\""]
    );
    let rendered = engine.session().unwrap().render(
        DialectName::IRONPLC_ED2,
        "PROGRAM main VAR x : INT; END_VAR x := 1; END_PROGRAM",
    );
    assert!(matches!(rendered, Outcome::Rendered { .. }), "{rendered:?}");
}

#[test]
fn a_description_of_ironplc_checks_as_its_adapter_does() {
    let sought = Compiler::Ironplc.seek("ironplc", "ironplc", &DependencyPaths::default());
    let (Ok(adapter), Some(compiler)) = (&sought.engine, sought.located.first()) else {
        // Not `eprintln`, which nobody sees when the test passes.
        let _ = writeln!(
            std::io::stderr(),
            "skipped: there is no ironplcc to hold its description against"
        );
        return;
    };
    let description: Description = toml::from_str(include_str!("../described/ironplc.toml")).unwrap();
    let here = compiler.path.parent().unwrap();
    let described = DescribedEngine::start("described", description, here).unwrap();
    let (mut one, mut other) = (adapter.session().unwrap(), described.session().unwrap());
    for body in [
        "a := 1;",
        "a := b;",
        "a := nowhere_declared;",
        "a := ;",
        "a := 1; a.9 := 5;",
        "a := REAL_TO_INT(b);",
    ] {
        let source = format!("PROGRAM main\nVAR\n    a : INT; b : DINT;\nEND_VAR\n    {body}\nEND_PROGRAM\n");
        for &dialect in &described.identity().dialects {
            let outcome = one.check(dialect, &source);
            assert_eq!(other.check(dialect, &source), outcome, "{body} {dialect}");
        }
    }
}

#[test]
fn matiec_behaves() {
    let Some(engine) = here(Compiler::Matiec) else {
        return;
    };
    behaves(engine.as_ref());
    divides_by_zero(engine.as_ref());
    reads_derived_types(engine.as_ref());
    let located = "PROGRAM main VAR x AT %MW5 : INT; END_VAR x := x + 1; END_PROGRAM";
    let outcome = ask(engine.as_ref(), located, &[("x", "INT", None)], 3);
    assert_eq!(values(outcome), ["x = INT#3"]);
    let wrong = "PROGRAM main VAR x AT %MW5 : INT; END_VAR x := TRUE; END_PROGRAM";
    let outcome = ask(engine.as_ref(), wrong, &[("x", "INT", None)], 1);
    assert!(matches!(outcome, Outcome::Rejected { .. }), "{outcome:?}");
}

#[test]
fn rusty_behaves() {
    let Some(engine) = here(Compiler::Rusty) else {
        return;
    };
    behaves(engine.as_ref());
    divides_by_zero(engine.as_ref());
    reads_derived_types(engine.as_ref());
}

#[test]
fn rusty_packs() {
    if let Some(engine) = here(Compiler::Rusty) {
        packs(engine.as_ref());
    }
}

#[test]
fn strucpp_behaves() {
    let Some(engine) = here(Compiler::Strucpp) else {
        return;
    };
    behaves(engine.as_ref());
    divides_by_zero(engine.as_ref());
    reads_derived_types(engine.as_ref());
    // Of this character the compiler tells the offset alone.
    let source = "PROGRAM main\nVAR\n    n : INT;\nEND_VAR\n    n := 1 ? 2;\nEND_PROGRAM\n";
    let Outcome::Rejected { diagnostics } = ask(engine.as_ref(), source, &[], 1) else {
        panic!("not rejected")
    };
    assert_eq!((diagnostics[0].line, diagnostics[0].column), (Some(5), Some(12)));
}

#[test]
fn a_compiler_is_known_by_its_name() {
    for compiler in Compiler::ALL {
        assert_eq!(Compiler::from_name(compiler.name()), Some(compiler));
    }
    assert_eq!(Compiler::from_name("cc"), None);
}
