//! The reader: turns a source text back into a program of the model, so that the evaluator can say what it must compute.
//!
//! The reader knows what the writer writes, and nothing else of the language: a text with anything the model does not have is not
//! read. It finds the type of each expression by the rules that the generator keeps. An expression has the type that its text
//! says; only a number without the prefix of its type takes the type of its place or of the other operand, and only where
//! documents grant it.
//!
//! | file | reads |
//! |---|---|
//! | `declarations` | types, variables, program organization units |
//! | `statements` | statements |
//! | `expressions` | expressions and places |
//! | `literals` | literals |
//!
//! Basis: rule: literal-as-operand; rule: mixed-operands.

mod declarations;
mod expressions;
mod literals;
mod statements;
#[cfg(test)]
mod tests;

use crate::generator::DialectProfile;
use crate::model::{Program, Type, Variable};
use stickler_syntax::parse;
use stickler_syntax::tree::SourceUnit;
use stickler_types::{Dialect, DialectName, ElementaryType};

/// Reads a text; `None` where it is no program of the model.
#[must_use]
pub fn read(text: &str, dialect: DialectName) -> Option<Program> {
    let (unit, diagnostics) = parse(text, Dialect::of(dialect));
    if !diagnostics.is_empty() {
        return None;
    }
    let mut reader = Reader {
        unit: &unit,
        profile: DialectProfile::of(dialect),
        program: Program::empty(dialect),
        variables: Vec::new(),
        function: None,
    };
    reader.declarations()?;
    Some(reader.program)
}

const BOOL: Type = Type::Elementary(ElementaryType::Bool);

/// A program that is half read.
struct Reader<'t> {
    unit: &'t SourceUnit<'t>,
    profile: &'static DialectProfile,
    program: Program,
    /// The variables of the unit that is being read.
    variables: Vec<Variable>,
    /// The name and the result of the function that is being read; `None` in other units.
    function: Option<(String, Type)>,
}

/// Returns the index of the part with a name, in any case of its letters.
fn named<'n>(mut names: impl Iterator<Item = &'n String>, name: &str) -> Option<usize> {
    names.position(|one| one.eq_ignore_ascii_case(name))
}
