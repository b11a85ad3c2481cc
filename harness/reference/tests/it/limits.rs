//! Hostile and enormous texts: no panic, little stack, no long time.

use stickler_reference::check;
use stickler_types::DialectName;

/// Checks a text on a thread with the stack of a test; gives how much is wrong with it.
fn said(text: String) -> usize {
    let thread = std::thread::Builder::new()
        .stack_size(2 << 20)
        .spawn(move || check(&text, DialectName::IRONPLC_ED3).len())
        .expect("a thread");
    thread.join().expect("no panic")
}

fn program(variables: &str, statements: &str) -> String {
    format!("PROGRAM main VAR {variables} END_VAR {statements} END_PROGRAM")
}

#[test]
fn a_chain_may_be_long() {
    let sum = format!("d := d{};", " + 1".repeat(200_000));
    assert_eq!(said(program("d : DINT;", &sum)), 0);
    let untyped = format!("d := 0{};", " + 1".repeat(200_000));
    assert_eq!(said(program("d : DINT;", &untyped)), 0);
    let wrong = format!("d := b{};", " + 1".repeat(200_000));
    assert_eq!(said(program("d : DINT; b : BOOL;", &wrong)), 1);
    let limits = format!("d : ARRAY[0..0{}] OF INT;", " + 1".repeat(100_000));
    assert_eq!(said(program(&limits, "")), 0);
}

#[test]
fn everything_may_nest_as_deep_as_the_parser_lets_it() {
    let deep = 199;
    for (open, inside, close) in [
        ("(", "d", ")"),
        ("ABS(", "d", ")"),
        ("MAX(1, ", "d", ")"),
        ("F(", "d", ")"),
        ("F(n := ", "d", ")"),
        ("TO_DINT(", "d", ")"),
        ("a[", "d", "]"),
        ("-", "d", ""),
        ("(d + ", "d", ")"),
        ("SEL(b, d, ", "1", ")"),
    ] {
        for depth in [20, 90, deep, 400] {
            let text = format!(
                "FUNCTION F : DINT VAR_INPUT n : DINT; END_VAR END_FUNCTION {}",
                program(
                    "d : DINT; b : BOOL; a : ARRAY[0..1] OF DINT;",
                    &format!("d := {}{inside}{};", open.repeat(depth), close.repeat(depth))
                )
            );
            let count = said(text);
            assert!(count <= 2, "{open}: {count}");
            assert!(depth > 90 || count == 0 || open == "TO_DINT(", "{open}: {count}");
        }
    }
    for (open, close) in [
        ("IF b THEN ", " END_IF;"),
        ("WHILE b DO ", " END_WHILE;"),
        ("FOR d := 1 TO 2 DO ", " END_FOR;"),
        ("CASE d OF 1: ", " END_CASE;"),
        ("REPEAT ", " UNTIL b END_REPEAT;"),
    ] {
        let text = program(
            "d : DINT; b : BOOL;",
            &format!("{}d := 1;{}", open.repeat(190), close.repeat(190)),
        );
        assert!(said(text) <= 1, "{open}");
    }
    let fields = format!(
        "TYPE T0 : STRUCT x : INT; END_STRUCT; {} END_TYPE",
        (1..150)
            .map(|n| format!("T{n} : STRUCT x : T{}; END_STRUCT;", n - 1))
            .collect::<String>()
    );
    assert_eq!(
        said(format!(
            "{fields} {}",
            program("t : T149;", &format!("t{} := 1;", ".x".repeat(150)))
        )),
        0
    );
}

#[test]
fn types_nest_no_deeper_than_the_limit() {
    let chain = |step: &dyn Fn(usize) -> String| {
        let types: String = (1..20_000).map(step).collect();
        format!(
            "TYPE T0 : INT := 5; {types} END_TYPE {}",
            program("t : T19999;", "")
        )
    };
    assert_eq!(said(chain(&|n| format!("T{n} : T{};", n - 1))), 0);
    assert_eq!(said(chain(&|n| format!("T{n} : ARRAY[0..0] OF T{};", n - 1))), 1);
    assert_eq!(
        said(chain(&|n| format!("T{n} : STRUCT x : T{}; END_STRUCT;", n - 1))),
        99,
        "a structure with a wrong element is a structure, and the count begins anew"
    );
    // Declared backwards it is the same.
    assert_eq!(
        said(chain(&|n| format!(
            "T{} : T{};",
            20_000 - n,
            if n == 1 { 0 } else { 20_001 - n }
        ))),
        0
    );
}

#[test]
fn memory_has_a_limit() {
    assert_eq!(said(program("a, b : ARRAY[0..3000000] OF INT;", "")), 1);
    let many = (0..300)
        .map(|n| format!("VAR_GLOBAL g{n} : ARRAY[0..20000] OF INT; END_VAR "))
        .collect::<String>();
    assert_eq!(said(many), 1);
    let texts = program("a : ARRAY[0..1000] OF STRING[65535];", "");
    assert_eq!(said(texts), 1);
    let growing: String = (1..100)
        .map(|n| format!("T{n} : ARRAY[0..9] OF T{};", n - 1))
        .collect();
    assert_eq!(said(format!("TYPE T0 : INT; {growing} END_TYPE")), 1);
}

#[test]
fn many_declarations_and_calls_take_no_long_time() {
    let count = 20_000;
    let variables: String = (0..count).map(|n| format!("v{n} : INT;")).collect();
    let statements: String = (0..count)
        .map(|n| format!("v{n} := v{};", count - 1 - n))
        .collect();
    assert_eq!(said(program(&variables, &statements)), 0);
    let functions: String = (0..count)
        .map(|n| {
            format!(
                "FUNCTION f{n} : INT VAR_INPUT a : INT; END_VAR f{n} := f{}(a := a); END_FUNCTION ",
                n + 1
            )
        })
        .collect();
    assert_eq!(
        said(format!(
            "{functions} FUNCTION f{count} : INT VAR_INPUT a : INT; END_VAR END_FUNCTION"
        )),
        0
    );
    let circle = format!(
        "{functions} FUNCTION f{count} : INT VAR_INPUT a : INT; END_VAR f{count} := f0(a); END_FUNCTION"
    );
    assert_eq!(said(circle), 1);
    let unknown: String = (0..count).map(|n| format!("x{n} := y{n}(z{n});")).collect();
    assert!(said(program("", &unknown)) > 20_000);
    let inputs: String = (0..2000).map(|n| format!("i{n} : INT := {n};")).collect();
    let calls = "d := F(i5 := 1);".repeat(2000);
    let text = format!(
        "FUNCTION F : INT VAR_INPUT {inputs} END_VAR END_FUNCTION {}",
        program("d : INT;", &calls)
    );
    assert_eq!(said(text), 0);
}

#[test]
fn enormous_names_and_literals_are_said_in_few_words() {
    let name = "x".repeat(1_000_000);
    let text = program(
        "d : DINT;",
        &format!(
            "d := {name}; d := {}; d := {}.5; {name}();",
            "9".repeat(1_000_000),
            "9".repeat(1_000_000)
        ),
    );
    assert!(said(text) >= 4);
}
