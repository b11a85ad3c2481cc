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
//!
//! Basis: rule: literal-as-operand; rule: mixed-operands.

mod declarations;
mod expressions;
mod statements;
#[cfg(test)]
mod tests;

use crate::generator::{DialectProfile, TypeContext};
use crate::model::{Expression, LiteralForm, Pou, Program, Type, Variable};
use stickler_syntax::tree::{self, ExpressionId, Literal, LiteralKind, SourceUnit, UnaryOperator};
use stickler_syntax::{parse, words};
use stickler_types::{Dialect, DialectName, ElementaryType, Family, Value};

/// Reads a text; `None` where it is no program of the model.
pub fn read(text: &str, dialect: DialectName) -> Option<Program> {
    let is_used = |block: &&Pou| words(text, Dialect::of(dialect)).any(|word| word.is(&block.name));
    let blocks = DialectProfile::of(dialect).standard_blocks().iter();
    read_beside(text, dialect, blocks.filter(is_used).cloned().collect())
}

/// Returns the standard function blocks of a dialect, but for counters of WORD.
///
/// Basis: codesys-recording: recordings/codesys.run.json (`lib_std_…`), for the names SET and RESET.
pub(crate) fn standard_blocks(dialect: DialectName) -> Vec<Pou> {
    let rules = Dialect::of(dialect);
    let [least, greatest] = match rules.counters_stop_at_preset {
        true => ["INT#0", "PV"],
        false => ["INT#-32768", "INT#32767"],
    };
    let [set, reset] = match rules.set_and_reset_inputs {
        true => ["SET", "RESET"],
        false => ["S", "R"],
    };
    let text = STANDARD_BLOCKS
        .replace("{least}", least)
        .replace("{greatest}", greatest);
    let text = text.replace("{falls}", if rules.first_call_falls { "TRUE" } else { "FALSE" });
    let text = text.replace("{S", set).replace("{R", reset).replace('}', "");
    let read = read_beside(&text, dialect, Vec::new());
    let mut blocks = read.map_or(Vec::new(), |program| program.blocks);
    blocks.retain(|block| !(rules.set_and_reset_inputs && block.name.starts_with("CT")));
    blocks.iter_mut().for_each(|block| block.standard = true);
    blocks
}

const STANDARD_BLOCKS: &str = include_str!("reader/standard_blocks.st");

/// Reads a text beside which these function blocks are there.
fn read_beside(text: &str, dialect: DialectName, blocks: Vec<Pou>) -> Option<Program> {
    let (unit, diagnostics) = parse(text, Dialect::of(dialect));
    if !diagnostics.is_empty() {
        return None;
    }
    let mut reader = Reader {
        unit: &unit,
        profile: DialectProfile::of(dialect),
        program: Program {
            blocks,
            ..Program::empty(dialect)
        },
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

impl Reader<'_> {
    /// Reads a number without the prefix of its type as one of the type `ty`.
    pub(super) fn number(
        &self,
        id: ExpressionId,
        ty: ElementaryType,
        context: TypeContext,
    ) -> Option<Expression> {
        let (sign, literal) = self.bare_number(id)?;
        let suits = match ty.family() {
            Family::Signed | Family::Unsigned | Family::BitString => literal.kind != LiteralKind::Real,
            Family::Real => literal.kind == LiteralKind::Real,
            _ => false,
        };
        if !suits || !self.profile.takes_untyped(ty, context) {
            return None;
        }
        let value = Value::parse(&format!("{ty}#{sign}{}", literal.text())).ok()?;
        Some(Expression::literal(ty, value, LiteralForm::Untyped))
    }

    /// Reads a whole number without a prefix.
    pub(super) fn integer(&self, id: ExpressionId) -> Option<i128> {
        let (sign, literal) = self.bare_number(id)?;
        format!("{sign}{}", literal.text()).parse().ok()
    }

    /// Returns a number that has no prefix, and its sign.
    fn bare_number(&self, id: ExpressionId) -> Option<(&'static str, &Literal<'_>)> {
        match &self.unit.expression(id)?.kind {
            tree::ExpressionKind::Parenthesized(inner) => self.bare_number(*inner),
            tree::ExpressionKind::Unary {
                operator: UnaryOperator::Negate,
                operand,
            } => match self.bare_number(*operand)? {
                ("", literal) => Some(("-", literal)),
                _ => None,
            },
            tree::ExpressionKind::Literal(literal) if literal.prefix().is_none() => match literal.kind {
                LiteralKind::Integer | LiteralKind::BasedInteger | LiteralKind::Real => Some(("", literal)),
                _ => None,
            },
            _ => None,
        }
    }
}

/// Reads a literal that says its type: by a prefix, or by its form.
pub(super) fn typed(literal: &Literal<'_>) -> Option<Expression> {
    let prefix = literal.prefix().map_or("", |prefix| prefix.text);
    let ty = match literal.kind {
        LiteralKind::Boolean if prefix.is_empty() => ElementaryType::Bool,
        LiteralKind::SingleByteText if prefix.is_empty() => ElementaryType::String,
        LiteralKind::DoubleByteText if prefix.is_empty() => ElementaryType::Wstring,
        _ => ElementaryType::from_literal_prefix(prefix)?,
    };
    let value = Value::parse(&format!("{ty}#{}", literal.text())).ok()?;
    // T#, LT#, D# and LD# are what a duration or a date has without the prefix of its type.
    let form = match ElementaryType::from_name(prefix) {
        Some(_) => LiteralForm::Typed,
        None => LiteralForm::Untyped,
    };
    Some(Expression::literal(ty, value, form))
}
