//! Calls of conversion functions, what exact arithmetic says of them, and the columns of a table of calls.

use stickler_exact::{Expected, Signature, expected, signatures};
use stickler_types::documents::DocumentedFunctions;
use stickler_types::{DialectName, ElementaryType, Value, WrittenValue, join};

/// A call of a conversion function with the operands that a program writes.
#[derive(Clone, PartialEq, Debug)]
pub struct Call {
    /// The function with its types.
    pub signature: Signature,
    /// The operands, one for each parameter.
    pub operands: Vec<WrittenValue>,
}

/// The result on which the asserting probes of a table agree for a call.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Agreed {
    /// The result as a typed literal, or `open` where no document of a dialect states it; an empty text where no probe asserts one.
    pub value: String,
    /// The bases of the call, as the column `basis` has them: an empty text where those of the probes are right.
    pub basis: String,
    /// The dialects that ask the row, as the column `dialects` has them: an empty text where all dialects of the probes do.
    pub dialects: String,
}

impl Call {
    /// Returns the call of `function` with these operands that gives a `to`, or nothing where no dialect has such a function whose documents state
    /// rules.
    pub fn new(function: &str, operands: Vec<WrittenValue>, to: ElementaryType) -> Option<Call> {
        let types: Vec<&str> = operands.iter().map(|operand| operand.value.type_name()).collect();
        let signature = DialectName::ALL
            .into_iter()
            .filter(|dialect| dialect.rules().documents.functions != DocumentedFunctions::InTables)
            .find_map(|dialect| signature(function, &types, to, dialect))?;
        Some(Call { signature, operands })
    }

    /// Returns the type of the first operand.
    pub fn from(&self) -> ElementaryType {
        self.signature.operands[0]
    }

    /// Returns the type of the result.
    pub fn to(&self) -> ElementaryType {
        self.signature.result
    }

    /// Returns whether a program of a dialect may name the types of the call.
    pub fn may_be_named(&self, dialect: DialectName) -> bool {
        let mut types = self.signature.operands.iter().chain([&self.signature.result]);
        types.all(|ty| dialect.rules().may_name(*ty))
    }

    /// Returns whether a dialect lacks a type of the call that its edition has.
    pub(crate) fn is_lacked(&self, dialect: DialectName) -> bool {
        let mut types = self.signature.operands.iter().chain([&self.signature.result]);
        !self.may_be_named(dialect) && types.all(|ty| dialect.rules().has(*ty))
    }

    /// Returns the result in a dialect with the document that says so, or nothing where the dialect does not have the function.
    pub fn expected(&self, dialect: DialectName) -> Option<Expected> {
        let types: Vec<&str> = self.signature.operands.iter().map(|ty| ty.name()).collect();
        signature(&self.signature.function, &types, self.to(), dialect)?;
        let values: Vec<Value> = self
            .operands
            .iter()
            .map(|operand| operand.value.clone())
            .collect();
        Some(expected(&self.signature, &values, dialect))
    }
}

impl std::fmt::Display for Call {
    /// Writes the call with canonical typed literals, `DINT_TO_INT(DINT#1)`, so that equal calls have equal texts.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let operands = self.operands.iter().map(|operand| &operand.value);
        write!(f, "{}({})", self.signature.function, join(operands, ", "))
    }
}

fn signature(function: &str, types: &[&str], to: ElementaryType, dialect: DialectName) -> Option<Signature> {
    let fits = |signature: &Signature| {
        signature.result == to
            && signature
                .operands
                .iter()
                .map(|ty| ty.name())
                .eq(types.iter().copied())
    };
    signatures(function, dialect).into_iter().find(fits)
}

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
