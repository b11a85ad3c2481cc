//! Texts that are nested too deep, or very long: one diagnostic, no recursion without limit.

use crate::{parse, render};
use stickler_types::{Dialect, DialectName};

/// The diagnostics of a text, as `line:column code message`.
fn errors(text: &str) -> Vec<String> {
    let (_, diagnostics) = parse(text, Dialect::of(DialectName::IRONPLC_ED2));
    let lines = crate::source::LineIndex::new(text);
    let described = diagnostics.iter().map(|diagnostic| {
        let at = lines.position(text, diagnostic.span.start);
        format!(
            "{}:{} {} {}",
            at.line, at.column, diagnostic.code, diagnostic.message
        )
    });
    described.collect()
}

/// The diagnostics of the body of a program that begins on the second line.
fn body_errors(body: &str) -> Vec<String> {
    errors(&format!("PROGRAM p\n{body}\nEND_PROGRAM"))
}

#[test]
fn everything_nests_to_the_limit_only() {
    let nested =
        |open: &str, close: &str, depth: usize| format!("{}1{}", open.repeat(depth), close.repeat(depth));
    let blocks = |depth: usize| {
        format!(
            "{}x := 1;{}",
            "IF a THEN ".repeat(depth),
            " END_IF;".repeat(depth)
        )
    };
    let parentheses = |depth: usize| format!("x := {};", nested("(", ")", depth));
    let types = |depth: usize| format!("TYPE T : {} INT; END_TYPE", "ARRAY[1..2] OF ".repeat(depth));
    let initial = format!(
        "PROGRAM p VAR x : T := {}; END_VAR END_PROGRAM",
        nested("[", "]", 200)
    );
    let calls = format!("x := {}; x := a{};", nested("f(", ")", 200), ".b".repeat(200));
    let accepted = [
        body_errors(&blocks(200)),
        body_errors(&parentheses(200)),
        body_errors(&calls),
    ];
    assert!(accepted.iter().all(Vec::is_empty), "{accepted:?}");
    assert_eq!((errors(&types(199)), errors(&initial)), (vec![], vec![]));
    assert_eq!(
        body_errors(&blocks(201)),
        ["2:2001 S0002 nested more than 200 deep"]
    );
    assert_eq!(
        body_errors(&parentheses(201)),
        ["2:206 S0002 nested more than 200 deep"]
    );
    for deep in [blocks(100_000), parentheses(100_000)] {
        assert_eq!(body_errors(&deep).len(), 1);
    }
    assert_eq!(errors(&types(100_000)).len(), 1);
    let signs = format!("x := {}1; y := {}1;", "-".repeat(1_000_000), "NOT ".repeat(300));
    assert_eq!(body_errors(&signs).len(), 1);
}

#[test]
fn what_opens_without_end_is_one_error() {
    let openings = [
        "IF a THEN ",
        "CASE a OF 1: ",
        "FOR i := 1 TO 2 DO ",
        "WHILE a DO ",
        "REPEAT ",
    ];
    for open in openings {
        let found = body_errors(&open.repeat(100_000));
        assert!(
            matches!(&found[..], [only] if only.contains("S0002")),
            "{open}: {found:?}"
        );
    }
    for deep in [
        "(",
        "a ** (b + c[",
        "f(",
        "a[",
        "f(x := ",
        "a.b[",
        "a.b[1](c := 1 + f(",
    ] {
        assert_eq!(
            body_errors(&format!("x := {}", deep.repeat(100_000))).len(),
            1,
            "{deep}"
        );
    }
    for long in [".b", "[1]", "()", ".3"] {
        assert_eq!(
            body_errors(&format!("x := a{};", long.repeat(100_000))).len(),
            1,
            "{long}"
        );
    }
    for deep in ["[", "(x := ", "[1(", "("] {
        let text = format!(
            "PROGRAM p VAR x : T := {}; END_VAR END_PROGRAM",
            deep.repeat(100_000)
        );
        assert_eq!(errors(&text).len(), 1, "{deep}");
    }
    assert_eq!(
        errors(&format!("TYPE T : {}", "STRUCT a : ".repeat(100_000))).len(),
        1
    );
}

#[test]
fn a_long_chain_is_no_nesting() {
    for link in [" + 1", " + 1 * (2 - 3)"] {
        let body = format!("x := 1{};", link.repeat(150_000));
        assert_eq!(body_errors(&body), [""; 0]);
        let text = format!("PROGRAM p\n    {body}\nEND_PROGRAM\n");
        let (unit, _) = parse(&text, Dialect::of(DialectName::IRONPLC_ED2));
        assert!(
            render(&unit, &text) == text,
            "a chain is rendered without recursion"
        );
    }
    let chain = vec!["x"; 100_000].join(" + ");
    let leaves = crate::documents::leaves(
        &format!("PROGRAM p y := {chain}; END_PROGRAM"),
        Dialect::of(DialectName::IRONPLC_ED2),
    );
    assert_eq!(leaves.lines().count(), 100_001);
}
