//! Conversions, explicit and implicit, by exact arithmetic.

use super::evaluator::ModelEvaluator;
use super::memory::MemoryCell;
use super::{Evaluated, OpenQuestion, ill_formed};
use std::sync::LazyLock;
use stickler_exact::{ImplicitResult, Operation, Signature, expected, implicit, implicit_result, value};
use stickler_types::{ElementaryType, MatrixWord};

const TYPES: usize = ElementaryType::ALL.len();

/// The plain conversion from each type to each, indexed by the positions of both in [`ElementaryType::ALL`].
static PLAIN: LazyLock<Vec<Signature>> = LazyLock::new(|| {
    let pairs = ElementaryType::ALL
        .into_iter()
        .flat_map(|from| ElementaryType::ALL.map(|to| (from, to)));
    pairs
        .map(|(from, to)| Signature {
            function: format!("{from}_TO_{to}"),
            operands: vec![from],
            result: to,
            operation: Operation::Convert,
        })
        .collect()
});

impl<'p> ModelEvaluator<'p> {
    /// Computes a conversion function; where no document states the result, raises a question and returns the value of the
    /// design.
    pub fn converted(
        &mut self,
        signature: &Signature,
        cell: MemoryCell,
        from: ElementaryType,
    ) -> Evaluated<MemoryCell> {
        let operands = [cell.into_value(from)?];
        if !signature.takes(&operands) {
            return Err(ill_formed("an argument of another type than the signature has"));
        }
        let given = expected(signature, &operands, self.program.dialect);
        if given.basis.is_none() {
            let [operand] = &operands;
            self.open(OpenQuestion::Conversion, || {
                format!("{}({operand})", signature.function)
            });
        }
        MemoryCell::of_value(given.value)
    }

    /// Computes an implicit conversion: the value unchanged, or the nearest real, rounded once.
    ///
    /// Basis: ironplc-type-conversions: Implicit Type Widening; implicit-conversion-table; conformance-cases/README.md (a matrix of types).
    pub fn widened(
        &mut self,
        cell: MemoryCell,
        from: ElementaryType,
        to: ElementaryType,
    ) -> Evaluated<MemoryCell> {
        if from == to {
            return Ok(cell);
        }
        let operand = cell.into_value(from)?;
        let Some(plain) = PLAIN.get(from as usize * TYPES + to as usize) else {
            return Err(ill_formed("an implicit conversion of no types"));
        };
        let result = value(
            plain,
            std::slice::from_ref(&operand),
            &self.program.dialect.rules().conversions,
        );
        let is_documented = implicit_result(&operand, to) == Some(ImplicitResult::Exactly(result.clone()));
        let granted = implicit(from, to, self.program.dialect) != MatrixWord::Open;
        if !granted || !is_documented {
            self.open(OpenQuestion::ImplicitConversion, || format!("{operand} as {to}"));
        }
        MemoryCell::of_value(result)
    }
}
