//! Which document says what a reduced program must give, for the case that is made of it.

use stickler_exact::{Signature, expected};
use stickler_generate::model::visit::{Visitor, walk_expression, walk_program};
use stickler_generate::model::{Expression, ExpressionKind, Program, Type};
use stickler_types::documents::{DocumentedFunctions, DocumentedImplicit};
use stickler_types::{Code, DialectName, ElementaryType, Value};

/// The clause of the standard on the language of every dialect.
const LANGUAGE: &str = "iec-61131-3: 7.3";

/// The document and section, as a case writes them: of the conversion functions in the program, else of its implicit
/// conversions, else of its bit access, else of what all dialects share. The first of a kind decides.
///
/// The basis is a proposal: a person who promotes a finding may know a better one.
pub fn basis(program: &Program) -> String {
    let mut proposals = Proposals {
        dialect: program.dialect,
        conversion: None,
        widening: None,
        bit: None,
    };
    walk_program(&mut proposals, program);
    { proposals.conversion }
        .or(proposals.widening)
        .or(proposals.bit)
        .unwrap_or_else(|| LANGUAGE.to_owned())
}

struct Proposals {
    dialect: DialectName,
    conversion: Option<String>,
    widening: Option<String>,
    bit: Option<String>,
}

impl Visitor for Proposals {
    fn expression(&mut self, expression: &Expression) {
        let dialect = self.dialect;
        match &expression.kind {
            ExpressionKind::Convert(signature, operand) if self.conversion.is_none() => {
                self.conversion = of_conversion(signature, operand, dialect);
            }
            ExpressionKind::Widen(operand) if self.widening.is_none() => {
                if let (Type::Elementary(from), Type::Elementary(to)) = (&operand.ty, &expression.ty) {
                    self.widening = of_widening(*from, *to, dialect);
                }
            }
            ExpressionKind::Bit(..) if self.bit.is_none() && is_ironplc(dialect) => {
                self.bit = Some("ironplc-bit-access: Valid Base Types".to_owned());
            }
            _ => {}
        }
        walk_expression(self, expression);
    }
}

fn of_conversion(signature: &Signature, operand: &Expression, dialect: DialectName) -> Option<String> {
    let [from] = signature.operands[..] else {
        return None;
    };
    let operand = match &operand.kind {
        ExpressionKind::Literal(value, _) => value.clone(),
        // What a document says of a conversion it says, with few exceptions, of every value that the target holds.
        _ => Value::plain(from, from.wrap(1)),
    };
    expected(signature, &[operand], dialect).basis.map(str::to_owned)
}

/// Basis: the headings of the documents.
fn of_widening(from: ElementaryType, to: ElementaryType, dialect: DialectName) -> Option<String> {
    if dialect.rules().documents.implicit == DocumentedImplicit::PlcnextTable {
        return Some(format!("implicit-conversion-table: {from} to {to}"));
    }
    if !is_ironplc(dialect) {
        return None;
    }
    let section = if from.is_bit_string() && to.is_bit_string() {
        "Bit-string widening"
    } else if from.is_bit_string() {
        "Cross-family widening"
    } else if from.is_integer() && to.is_integer() {
        "Integer widening"
    } else if from.is_integer() {
        "Integer to real widening"
    } else {
        "Implicit Type Widening"
    };
    Some(format!("ironplc-type-conversions: {section}"))
}

/// Returns the source that says which code belongs to an error: the registry of the dialect, or else Stickler's own rule.
pub(crate) fn of_code(code: Code, dialect: DialectName) -> String {
    let code = code.as_str();
    match is_ironplc(dialect) && code.starts_with('P') {
        true => format!("ironplc-problem-codes: {code}"),
        false => "rule: code-of-the-context".to_owned(),
    }
}

fn is_ironplc(dialect: DialectName) -> bool {
    dialect.rules().documents.functions == DocumentedFunctions::Ironplc
}
