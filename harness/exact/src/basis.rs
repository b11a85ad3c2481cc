//! Tells which document states the result of a call, if one does: the suite asserts stated results and only observes the
//! others.
//!
//! A result without a document is open. An overloaded name (`TO_INT`) is open for every operand except in STruC++ and RuSTy,
//! whose tests have it, and in PLCnext Engineer, whose pages have no other: the ForgeIEC page says that every conversion is `<SRC>_TO_<DST>`, and so does IronPLC's.

mod conditions;
mod rows;
mod stated;
mod texts;
mod vendors;

use crate::elementary::elementary_basis;
use crate::signature::{Operation, Signature};
use crate::value::value;
use rows::ROWS;
use stickler_types::documents::DocumentedFunctions as Rules;
use stickler_types::{DialectName, ElementaryType, Value};
pub use vendors::stated_by_vendor;

/// The expected result of a call, and the document that states it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Expected {
    /// The result of the call.
    pub value: Value,
    /// The document and section that say so, as the suite writes a basis: `source: section`. `None` where the call is open.
    pub basis: Option<&'static str>,
}

/// Returns the expected result of a call of a conversion function in a dialect, and the document that states it.
///
/// Takes a signature of [`crate::signatures`] and one operand for each of its types. Where no document states the result,
/// the basis is `None` and the value is that of IEC 60559 and of two's complement. In a user-defined dialect, a statement of
/// its definition takes precedence over the documents of its base, and the basis is that of the definition. See [`value`]
/// for operands that do not fit.
pub fn expected(signature: &Signature, operands: &[Value], dialect: DialectName) -> Expected {
    let choices = dialect.rules().conversions;
    if signature.operation == Operation::Elementary {
        return Expected {
            value: value(signature, operands, &choices),
            basis: Some(elementary_basis(&signature.function)),
        };
    }
    let call = UnaryCall::of(signature, operands, dialect);
    let basis = call.and_then(|(call, operand)| match dialect.definition() {
        None => call.basis(operand),
        Some(definition) => call.stated(operand, definition, &choices),
    });
    Expected {
        value: value(signature, operands, &choices),
        basis,
    }
}

/// Returns whether the ForgeIEC page has a truncation whose name tells its result, of an operand of this type.
///
/// Basis: forgeiec-conversion-functions: The naming pattern (TRUNC_INT of REAL, TRUNC_LINT of LREAL), TRUNC vs. ROUND (TRUNC_DINT of a REAL).
pub fn page_has_truncation(signature: &Signature) -> bool {
    matches!(
        (&signature.function[..], &signature.operands[..]),
        ("TRUNC_INT" | "TRUNC_DINT", [ElementaryType::Real]) | ("TRUNC_LINT", [ElementaryType::Lreal])
    )
}

/// Returns whether an override in the definition of a dialect decides the result of a call: with another choice in its
/// place, the result would differ. Always `false` in a dialect of a documented system, and for operands that do not fit.
pub fn is_overridden(signature: &Signature, operands: &[Value], dialect: DialectName) -> bool {
    let call = UnaryCall::of(signature, operands, dialect);
    call.zip(dialect.definition())
        .is_some_and(|((call, operand), definition)| {
            call.is_overridden(operand, definition, &dialect.rules().conversions)
        })
}

/// A call with one argument.
#[derive(Clone, Copy)]
struct UnaryCall<'s> {
    signature: &'s Signature,
    from: ElementaryType,
    to: ElementaryType,
    rules: Rules,
}

impl<'s> UnaryCall<'s> {
    /// Returns a call with one operand, and that operand, if it fits.
    fn of<'v>(
        signature: &'s Signature,
        operands: &'v [Value],
        dialect: DialectName,
    ) -> Option<(UnaryCall<'s>, &'v Value)> {
        let (&[from], [operand]) = (&signature.operands[..], operands) else {
            return None;
        };
        let call = UnaryCall {
            signature,
            from,
            to: signature.result,
            rules: dialect.rules().documents.functions,
        };
        signature.takes(operands).then_some((call, operand))
    }

    /// Returns the source that states the result, by the rows of `basis.toml`.
    fn basis(self, operand: &Value) -> Option<&'static str> {
        let name = &self.signature.function[..];
        let functions = match self.signature.operation {
            Operation::Convert if name.starts_with("TO_") => "TO_",
            Operation::Convert => "FROM_TO",
            _ => name,
        };
        let fits = |row: &&rows::Row| {
            row.is_of(functions, self.from, self.to) && { row.conditions.iter() }
                .all(|condition| self.meets(*condition, operand))
        };
        ROWS.get(&self.rules)?.iter().find(fits).map(|row| row.basis)
    }
}
