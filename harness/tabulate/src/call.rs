//! Calls of conversion functions, and what exact arithmetic says of them.

use stickler_exact::{Expected, Signature, expected, signatures};
use stickler_types::documents::DocumentedFunctions;
use stickler_types::{DialectName, ElementaryType, Value, WrittenValue};

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
    #[must_use]
    pub fn new(function: &str, operands: Vec<WrittenValue>, to: ElementaryType) -> Option<Call> {
        let types: Vec<&str> = operands.iter().map(|operand| operand.value.type_name()).collect();
        let signature = DialectName::ALL
            .into_iter()
            .filter(|dialect| dialect.rules().documents.functions != DocumentedFunctions::InTables)
            .find_map(|dialect| signature(function, &types, to, dialect))?;
        Some(Call { signature, operands })
    }

    /// Returns the type of the first operand.
    #[must_use]
    pub fn from(&self) -> ElementaryType {
        self.signature.operands[0]
    }

    /// Returns the type of the result.
    #[must_use]
    pub fn to(&self) -> ElementaryType {
        self.signature.result
    }

    /// Returns the result in a dialect with the document that says so, or nothing where the dialect does not have the function.
    #[must_use]
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
        let operands: Vec<String> = self
            .operands
            .iter()
            .map(|operand| operand.value.to_string())
            .collect();
        write!(f, "{}({})", self.signature.function, operands.join(", "))
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
