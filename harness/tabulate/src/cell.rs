//! The columns of a table of calls.

use crate::call::{Agreed, Call};
use stickler_types::{ElementaryType, WrittenValue};

/// Writes the cell of a call, of which the table's probes say this.
pub type CellWriter = fn(&Call, &Agreed) -> String;

/// Returns how the cells of a column are written, or nothing where the column is none of a table of calls.
///
/// | column | cell |
/// |---|---|
/// | `function` | the function's name |
/// | `from`, `to` | the types of the first operand and of the result |
/// | `input`, `typed` | the first operand as a declaration initializes a variable with it, and as a typed literal |
/// | `with`, `second` | the second operand's type, and the operand itself |
/// | `id` | the function and the operand, where the other cells are too long for an id |
/// | `huge`, `made` | a number whose square is infinite, and an expression with `huge` for an operand without a literal |
/// | `expected` | the result as a typed literal |
/// | `dialects` | the dialects whose sources say so; an empty cell where all do |
/// | `basis` | the sources that say so; an empty cell where the head or the probe names them |
#[must_use]
pub fn of_column(name: &str) -> Option<CellWriter> {
    Some(match name {
        "function" => |call, _| call.signature.function.clone(),
        "from" => |call, _| call.from().to_string(),
        "to" => |call, _| call.to().to_string(),
        "input" => |call, _| literal(call, 0).to_owned(),
        "typed" => |call, _| typed(&call.operands[0]),
        "with" => |call, _| operand_type(call, 1),
        "second" => |call, _| literal(call, 1).to_owned(),
        "id" => |call, _| format!("{}/{}", call.signature.function, typed(&call.operands[0])),
        "huge" => |call, _| huge(call.from()).to_owned(),
        "made" => |call, _| made(literal(call, 0)).to_owned(),
        "expected" => |_, agreed| agreed.value.clone(),
        "basis" => |_, agreed| agreed.basis.clone(),
        "dialects" => |_, agreed| agreed.dialects.clone(),
        _ => return None,
    })
}

fn literal(call: &Call, at: usize) -> &str {
    call.operands.get(at).map_or("", |operand| &operand.literal)
}

/// Returns the literal with its type, which it may have already: `TIME#999us`.
fn typed(operand: &WrittenValue) -> String {
    let has_type = operand
        .literal
        .split_once('#')
        .is_some_and(|(prefix, _)| ElementaryType::from_literal_prefix(prefix).is_some());
    if has_type {
        operand.literal.to_string()
    } else {
        format!("{}#{}", operand.value.type_name(), operand.literal)
    }
}

fn operand_type(call: &Call, at: usize) -> String {
    let ty = call.signature.operands.get(at);
    ty.map_or_else(String::new, |ty| ty.to_string())
}

fn huge(ty: ElementaryType) -> &'static str {
    if ty == ElementaryType::Real {
        "3.0E38"
    } else {
        "1.0E308"
    }
}

/// Returns an expression that makes what no literal can write. There are compilers that read the literal of -0.0 as 0.0.
fn made(literal: &str) -> &'static str {
    match literal {
        "Infinity" => "huge * huge",
        "-Infinity" => "-huge * huge",
        "-0.0" => "-1.0 / (huge * huge)",
        _ => "huge * huge - huge * huge",
    }
}
