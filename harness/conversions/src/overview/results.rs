//! What engines give for the calls of one signature, beside what the documents say.

use super::values::Call;
use crate::session::{FunctionSession, Refusal, RefusalKind};
use stickler_engines::{Engine, EngineError};
use stickler_exact::{Expected, Signature};
use stickler_types::{DialectName, Value};

/// The results of a function between fixed types.
pub struct SignatureResults {
    /// The types.
    pub signature: Signature,
    /// The operands of each call.
    pub calls: Vec<Call>,
    /// The results of each engine in each dialect.
    pub columns: Vec<DialectResults>,
}

/// The results of one engine in one dialect.
pub struct DialectResults {
    /// The engine, by its place among those that were asked.
    pub engine: usize,
    /// The dialect.
    pub dialect: DialectName,
    /// The result of each call.
    pub results: Vec<ComparedResult>,
}

/// The result of one call, and the expected one.
#[derive(Clone, PartialEq, Debug)]
pub struct ComparedResult {
    /// What the engine gave.
    pub got: Result<Value, Refusal>,
    /// What it must give, where a document is the basis; otherwise what Stickler's design suggests.
    pub expected: Expected,
}

impl ComparedResult {
    /// Returns whether the engine does not do what a document says. What it says that it cannot do contradicts nothing.
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
    /// Returns whether any result contradicts a document.
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
        let compared = |(call, got): (&Call, _)| ComparedResult {
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

/// Asks each engine for each call in each of its dialects that have the signature.
///
/// # Errors
/// An engine of which no session can be opened.
pub fn gather(
    calls: Vec<(Signature, Vec<Call>)>,
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
