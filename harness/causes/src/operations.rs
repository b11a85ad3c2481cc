//! The operations of a program: its operators, functions and statements, by the kind of work that they are in a compiler.

use crate::shape::{function, is_fixed, own_functions};
use crate::tokens::{ProgramToken, ProgramTokenKind, tokens};
use std::collections::BTreeSet;

/// Returns the operators, functions and statements of a program.
pub(crate) fn operations_of(program: &str) -> BTreeSet<String> {
    let tokens = tokens(program);
    operations(&tokens, &own_functions(&tokens))
}

/// Returns the operators, functions and statements among these tokens; an assignment and a field are none.
pub(crate) fn operations(tokens: &[ProgramToken<'_>], own: &BTreeSet<String>) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for (at, token) in tokens.iter().enumerate() {
        let next = tokens.get(at + 1);
        let upper = token.text.to_ascii_uppercase();
        let operation = match token.kind {
            ProgramTokenKind::Sign => sign(
                token,
                at.checked_sub(1).and_then(|before| tokens.get(before)),
                next,
            ),
            ProgramTokenKind::Word => match upper.as_str() {
                "MOD" => Some("arithmetic"),
                "AND" | "OR" | "XOR" | "NOT" => Some("bitwise operator"),
                "IF" | "ELSIF" | "CASE" | "FOR" | "WHILE" | "UNTIL" => Some("condition"),
                _ if next.is_some_and(|next| next.text == "(") => {
                    let is_own = own.contains(&upper);
                    found.insert(match upper.as_str() {
                        _ if is_own => "call".to_owned(),
                        // The two directions are one piece of work.
                        "SHL" | "SHR" => "shift".to_owned(),
                        "ROL" | "ROR" => "rotation".to_owned(),
                        _ => function(&upper),
                    });
                    None
                }
                _ => None,
            },
            _ => None,
        };
        found.extend(operation.map(str::to_owned));
    }
    found
}

/// The words that begin a loop.
pub(crate) const LOOPS: [&str; 3] = ["FOR", "WHILE", "REPEAT"];

/// Returns whether a token is an operator that calculates with numbers.
pub(crate) fn calculates(token: &ProgramToken<'_>) -> bool {
    token.is("MOD") || matches!(token.text, "+" | "-" | "*" | "/" | "**")
}

/// Returns whether an operand may end with a token, so that a sign behind it is an operator between two operands.
pub(crate) fn ends_operand(token: &ProgramToken<'_>) -> bool {
    match token.kind {
        ProgramTokenKind::Sign => matches!(token.text, ")" | "]"),
        ProgramTokenKind::Word => !is_fixed(token.text) || token.is("TRUE") || token.is("FALSE"),
        _ => true,
    }
}

/// Returns whether a sign compares.
pub(crate) fn is_comparison(sign: &str) -> bool {
    matches!(sign, "=" | "<>" | "<" | ">" | "<=" | ">=")
}

/// Returns the operation of a sign, by the tokens around it.
fn sign(
    token: &ProgramToken<'_>,
    before: Option<&ProgramToken<'_>>,
    next: Option<&ProgramToken<'_>>,
) -> Option<&'static str> {
    let is_name = |token: &ProgramToken<'_>| token.kind == ProgramTokenKind::Word && !is_fixed(token.text);
    match token.text {
        "+" | "-" if before.is_some_and(ends_operand) => Some("arithmetic"),
        // The sign of a literal is a part of it.
        "+" | "-" if next.is_some_and(|next| next.text == "(" || is_name(next)) => Some("sign"),
        "*" | "/" => Some("arithmetic"),
        "**" => Some("power"),
        text if is_comparison(text) => Some("comparison"),
        "&" => Some("bitwise operator"),
        "=>" => Some("output argument"),
        "[" => Some("subscript or list"),
        "." => next
            .is_some_and(|next| matches!(next.kind, ProgramTokenKind::Number | ProgramTokenKind::Partial))
            .then_some("bit access"),
        _ => None,
    }
}
