//! The results that engines give for the calls of a signature, each with the expected one.

use super::values::CallOperands;
use crate::session::{FunctionSession, Refusal, RefusalKind};
use stickler_engines::{Engine, EngineError};
use stickler_exact::{Expected, Signature};
use stickler_types::{DialectName, Value};

/// The results of one signature of a function.
pub struct SignatureResults {
    /// The function, and the types of its operands and of its result.
    pub signature: Signature,
    /// The operands of each call.
    pub calls: Vec<CallOperands>,
    /// The results of each engine in each dialect.
    pub columns: Vec<DialectResults>,
}

/// The results of one engine in one dialect.
pub struct DialectResults {
    /// The index of the engine among those that were asked.
    pub engine: usize,
    /// The dialect.
    pub dialect: DialectName,
    /// The result of each call.
    pub results: Vec<ComparedResult>,
}

/// The result of one call, and the expected one.
#[derive(Clone, PartialEq, Debug)]
pub struct ComparedResult {
    /// The value that the engine gave, or its reason for giving none.
    pub got: Result<Value, Refusal>,
    /// The value that a document demands, which is then the basis; without a basis, the value that IEC 60559 and two's complement suggest.
    pub expected: Expected,
}

impl ComparedResult {
    /// Returns whether the result contradicts a document. An engine that says it does not support the call contradicts nothing.
    #[must_use]
    pub fn contradicts(&self) -> bool {
        let wrong = match &self.got {
            Ok(value) => *value != self.expected.value,
            Err(refusal) => refusal.kind != RefusalKind::Unsupported,
        };
        wrong && self.expected.basis.is_some()
    }
}

impl SignatureResults {
    /// Returns whether any result of any engine contradicts a document.
    #[must_use]
    pub fn contradict(&self) -> bool {
        let mut results = self.columns.iter().flat_map(|column| &column.results);
        results.any(ComparedResult::contradicts)
    }

    fn ask(&mut self, engine: usize, dialect: DialectName, session: &mut FunctionSession<'_>) {
        let SignatureResults { signature, calls, .. } = &*self;
        if !stickler_exact::signatures(&signature.function, dialect).contains(signature) {
            return;
        }
        let got = session.results(dialect, signature, calls);
        let compared = |(call, got): (&CallOperands, _)| ComparedResult {
            got,
            expected: stickler_exact::expected(signature, call, dialect),
        };
        let results = calls.iter().zip(got).map(compared).collect();
        self.columns.push(DialectResults {
            engine,
            dialect,
            results,
        });
    }
}

/// Asks each engine for the result of each call, in each of its dialects that have the signature.
///
/// # Errors
/// [`EngineError`] where no session of an engine can be opened.
pub fn gather(
    calls: Vec<(Signature, Vec<CallOperands>)>,
    engines: &[(&dyn Engine, Vec<DialectName>)],
) -> Result<Vec<SignatureResults>, EngineError> {
    let mut all: Vec<SignatureResults> = calls
        .into_iter()
        .map(|(signature, calls)| SignatureResults {
            signature,
            calls,
            columns: Vec::new(),
        })
        .collect();
    for (index, (engine, dialects)) in engines.iter().enumerate() {
        let mut session = FunctionSession::open(*engine)?;
        for results in &mut all {
            for dialect in dialects {
                results.ask(index, *dialect, &mut session);
            }
        }
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::ComparedResult;
    use crate::session::{Refusal, RefusalKind};
    use stickler_exact::Expected;
    use stickler_types::Value;

    fn compared(got: Result<Value, Refusal>, basis: Option<&'static str>) -> ComparedResult {
        let value = Value::parse("INT#5").unwrap();
        ComparedResult {
            got,
            expected: Expected { value, basis },
        }
    }

    fn refused(kind: RefusalKind) -> Result<Value, Refusal> {
        Err(Refusal {
            kind,
            detail: String::new(),
            line: None,
        })
    }

    #[test]
    fn only_what_a_document_says_can_be_contradicted() {
        let basis = Some("iec-61131-3: Table 22");
        let right = || Ok(Value::parse("INT#5").unwrap());
        let wrong = || Ok(Value::parse("INT#6").unwrap());
        assert!(!compared(right(), basis).contradicts());
        assert!(compared(wrong(), basis).contradicts());
        assert!(!compared(wrong(), None).contradicts());
        assert!(compared(refused(RefusalKind::Crashed), basis).contradicts());
        assert!(!compared(refused(RefusalKind::Unsupported), basis).contradicts());
    }
}
