//! Helpers of the tests beside the productions.

use super::parse;
use crate::source::LineIndex;
use crate::tree::{
    Declaration, Expression, ExpressionId, ExpressionKind, Pou, SourceUnit, Statement, StatementKind,
    UnaryOperator,
};
use stickler_types::Code;
use stickler_types::{Dialect, DialectName};

/// The diagnostics of a text in the second edition, as `line:column code message`.
pub(super) fn errors(text: &str) -> Vec<String> {
    let (_, diagnostics) = parse(text, Dialect::of(DialectName::IRONPLC_ED2));
    let lines = LineIndex::new(text);
    let show = |diagnostic: &crate::diagnostic::SpannedDiagnostic| {
        let at = lines.position(text, diagnostic.span.start);
        format!(
            "{}:{} {} {}",
            at.line, at.column, diagnostic.code, diagnostic.message
        )
    };
    diagnostics.iter().map(show).collect()
}

/// Returns the errors of the body of a program that begins on the first line; columns count from the body.
pub(super) fn body_errors(body: &str) -> Vec<String> {
    let text = format!("PROGRAM p\n{body}\nEND_PROGRAM");
    let shift = |error: &String| {
        let (line, rest) = error.split_once(':').expect("a line");
        format!("{}:{rest}", line.parse::<u32>().expect("a number") - 1)
    };
    errors(&text).iter().map(shift).collect()
}

/// The codes in a dialect, and what they point at.
pub(super) fn codes(text: &str, dialect: &Dialect) -> Vec<(Code, String)> {
    let (_, diagnostics) = parse(text, dialect);
    diagnostics
        .iter()
        .map(|diagnostic| (diagnostic.code, diagnostic.span.text(text).to_owned()))
        .collect()
}

/// The tree of a text about which there is nothing to say.
pub(super) fn accepted(text: &str) -> SourceUnit<'_> {
    assert_eq!(errors(text), [""; 0], "{text}");
    parse(text, Dialect::of(DialectName::IRONPLC_ED2)).0
}

/// The statements of a body about which there is nothing to say.
pub(super) fn accepted_body(body: &str) -> Vec<Statement> {
    let text: &'static str = format!("PROGRAM p {body} END_PROGRAM").leak();
    match accepted(text).declarations.pop() {
        Some(Declaration::Pou(pou)) => pou.body,
        other => panic!("{other:?}"),
    }
}

/// The POU at this place among the declarations.
pub(super) fn pou<'u, 's>(unit: &'u SourceUnit<'s>, index: usize) -> &'u Pou<'s> {
    match unit.declarations.get(index) {
        Some(Declaration::Pou(pou)) => pou,
        other => panic!("{other:?}"),
    }
}

/// The whole tree of an accepted text, as it prints itself.
pub(super) fn shape(text: &str) -> String {
    format!("{:?}", accepted(text))
}

/// An expression with parentheses around each operation, and brackets around what is written in parentheses.
pub(super) fn grouped(expression: &str) -> String {
    let text = format!("PROGRAM p x := {expression}; END_PROGRAM");
    let unit = accepted(&text);
    match pou(&unit, 0).body[0].kind {
        StatementKind::Assignment { value, .. } => group(&unit.expressions, value),
        _ => panic!("{unit:?}"),
    }
}

fn group(all: &[Expression], id: ExpressionId) -> String {
    match &all[id.0 as usize].kind {
        ExpressionKind::Name(name) => name.text.to_owned(),
        ExpressionKind::Literal(literal) => {
            let prefix = literal
                .prefix()
                .map_or(String::new(), |prefix| format!("{}#", prefix.text));
            format!("{prefix}{:?}:{}", literal.kind, literal.text()).replace("Integer:2", "2")
        }
        ExpressionKind::EnumeratedValue(word) => format!("{}#{}", word.prefix().text, word.value().text),
        ExpressionKind::Parenthesized(inner) => format!("[{}]", group(all, *inner)),
        ExpressionKind::Unary { operator, operand } => {
            let sign = match operator {
                UnaryOperator::Negate => "-",
                UnaryOperator::Plus => "+",
                UnaryOperator::Not => "NOT ",
            };
            format!("({sign}{})", group(all, *operand))
        }
        ExpressionKind::Binary {
            operator,
            left,
            right,
        } => {
            format!(
                "({} {} {})",
                group(all, *left),
                operator.symbol(),
                group(all, *right)
            )
        }
        other => format!("{other:?}"),
    }
}
