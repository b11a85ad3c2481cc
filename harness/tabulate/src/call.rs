//! A call of a conversion function, and what the exact arithmetic says of it.

use crate::operand::Operand;
use stickler_exact::{Expected, Signature, expected, signatures};
use stickler_types::{DialectName, ElementaryType, Value};

/// A call of a conversion function with the operands that a program writes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Call {
    /// The function with its types.
    pub signature: Signature,
    /// One operand for each of its parameters.
    pub operands: Vec<Operand>,
}

impl Call {
    /// A call of `function` with these operands that gives a `to`.
    ///
    /// # Panics
    /// Where no dialect has such a function: the calls belong to this program, and such a one is its mistake.
    #[must_use]
    pub fn new(function: &str, operands: Vec<Operand>, to: ElementaryType) -> Call {
        let types: Vec<&str> = operands.iter().map(|operand| operand.value.type_name()).collect();
        let signature = DialectName::ALL
            .into_iter()
            .find_map(|dialect| signature(function, &types, to, dialect));
        let signature =
            signature.unwrap_or_else(|| panic!("no dialect has {function} from {types:?} to {to}"));
        Call { signature, operands }
    }

    /// A call of `<SRC>_TO_<DST>`.
    ///
    /// # Panics
    /// As [`Call::new`].
    #[must_use]
    pub fn convert(from: ElementaryType, to: ElementaryType, operand: Operand) -> Call {
        Call::new(&format!("{from}_TO_{to}"), vec![operand], to)
    }

    /// The type of the first operand.
    #[must_use]
    pub fn from(&self) -> ElementaryType {
        self.signature.operands[0]
    }

    /// The type of the result.
    #[must_use]
    pub fn to(&self) -> ElementaryType {
        self.signature.result
    }

    /// What the call gives in a dialect, and by which document; `None` where the dialect does not have the function.
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

    /// The document that says in a dialect what the call gives; `None` where none does.
    #[must_use]
    pub fn basis(&self, dialect: DialectName) -> Option<&'static str> {
        self.expected(dialect)?.basis
    }
}

/// Whether a text is among the one in so many that are chosen where a table has room for some only.
///
/// The choice depends on the text alone, not on its place in a list: a list may grow, and no case vanishes.
#[must_use]
pub fn is_chosen(text: &str, one_in: u64) -> bool {
    // FNV-1a of 64 bits, whose low bits alone are not mixed well enough.
    let hash = text.bytes().fold(0xCBF2_9CE4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01B3)
    });
    (hash >> 32).is_multiple_of(one_in)
}

impl std::fmt::Display for Call {
    /// As a program writes it with typed literals: `DINT_TO_INT(DINT#1)`.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let operands: Vec<&str> = self.operands.iter().map(|operand| &*operand.typed).collect();
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

#[cfg(test)]
mod tests {
    use super::*;
    use ElementaryType::{Dint, Int};

    #[test]
    fn a_call_knows_what_it_gives_and_who_says_so() {
        let call = Call::convert(Dint, Int, Operand::number(Dint, 100_000));
        let matiec = call.expected(DialectName::Matiec).unwrap();
        assert_eq!(matiec.value.to_string(), "INT#-31072");
        assert_eq!(
            matiec.basis,
            Some("forgeiec-conversion-functions: Range and precision")
        );
        assert_eq!(call.basis(DialectName::Plcnext), None);
    }

    #[test]
    fn about_as_many_are_chosen_as_were_asked_for_and_always_the_same() {
        let chosen = (0..7_000).filter(|number| is_chosen(&number.to_string(), 7));
        let chosen: Vec<u32> = chosen.collect();
        assert!((900..1_100).contains(&chosen.len()), "{}", chosen.len());
        assert!(is_chosen("anything", 1));
    }

    #[test]
    fn a_function_that_a_dialect_lacks_gives_nothing_there() {
        let call = Call::new("ROUND", vec![Operand::read(ElementaryType::Real, "0.5")], Dint);
        assert!(call.expected(DialectName::IronplcEd3).is_some());
        assert_eq!(call.expected(DialectName::Matiec), None);
    }
}
