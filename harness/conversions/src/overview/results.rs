//! The results that engines give for the calls of a signature, each with the expected one.

use super::values::CallOperands;
use crate::recording::Recording;
use crate::session::{FunctionSession, Refusal, RefusalKind};
use std::sync::Arc;
use stickler_engines::{Engine, EngineError};
use stickler_exact::Signature;
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

/// A source of results: an engine that is asked now, or the recording of one that was asked before.
#[derive(Clone, Copy)]
pub enum AnswerSource<'a> {
    /// An engine.
    Engine(&'a dyn Engine),
    /// A recording.
    Recording(&'a Recording),
}

/// Gives the results of calls in a dialect.
type CallEvaluator<'a> =
    Box<dyn FnMut(DialectName, &Signature, &[CallOperands]) -> Vec<Result<Value, Refusal>> + 'a>;

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
    /// The expected one.
    pub expected: ExpectedResult,
}

/// The expected result of one call in a dialect.
#[derive(Clone, PartialEq, Debug)]
pub struct ExpectedResult {
    /// The value that the basis demands; without a basis, the value that IEC 60559 and two's complement suggest.
    pub value: Value,
    /// The source and section that demand the value, as the suite writes a basis; `None` where the result is open.
    pub basis: Option<Arc<str>>,
    /// The statement of another source of the same system, where its value differs.
    pub otherwise: Option<OtherStatement>,
}

/// The statement of a vendor's page on a result that was recorded otherwise.
#[derive(Clone, PartialEq, Debug)]
pub struct OtherStatement {
    /// The value.
    pub value: Value,
    /// The source and section that state it.
    pub basis: Arc<str>,
}

/// A result that a case of the suite asserts for one operand.
#[derive(Clone, PartialEq, Debug)]
pub struct AssertedResult {
    /// The dialect.
    pub dialect: DialectName,
    /// The operands.
    pub operands: Vec<Value>,
    /// The result.
    pub value: Value,
    /// The source and section that the case cites.
    pub basis: Arc<str>,
}

impl ExpectedResult {
    /// Returns the expected result of a call: by exact arithmetic where a document has a rule for it, otherwise the one that a case asserts,
    /// for single values that were recorded or printed.
    pub(crate) fn of(
        signature: &Signature,
        call: &[Value],
        dialect: DialectName,
        asserted: Option<(&Value, &Arc<str>)>,
    ) -> ExpectedResult {
        let exact = stickler_exact::expected(signature, call, dialect);
        match (exact.basis, asserted) {
            (None, Some((value, basis))) => {
                let stated = stickler_exact::stated_by_vendor(signature, call, dialect)
                    .filter(|(stated, page)| stated != value && **page != **basis);
                ExpectedResult {
                    value: value.clone(),
                    basis: Some(Arc::clone(basis)),
                    otherwise: stated.map(|(value, page)| OtherStatement {
                        value,
                        basis: page.into(),
                    }),
                }
            }
            (basis, _) => ExpectedResult {
                value: exact.value,
                basis: basis.map(Arc::from),
                otherwise: None,
            },
        }
    }
}

impl ComparedResult {
    /// Returns whether the result contradicts a document. An engine that says it does not support the call contradicts nothing.
    pub fn contradicts(&self) -> bool {
        let wrong = match &self.got {
            Ok(value) => *value != self.expected.value,
            Err(refusal) => !matches!(refusal.kind, RefusalKind::Unsupported | RefusalKind::NotAsked),
        };
        wrong && self.expected.basis.is_some()
    }
}

impl SignatureResults {
    /// Returns whether any result of the first `engines` engines contradicts a document.
    pub fn contradict(&self, engines: usize) -> bool {
        let columns = self.columns.iter().filter(|column| column.engine < engines);
        columns
            .flat_map(|column| &column.results)
            .any(ComparedResult::contradicts)
    }

    /// Adds the column of an engine in a dialect, if the dialect has the signature and a recording at least one of the calls. `answers` gives the results of the calls.
    fn add(
        &mut self,
        engine: usize,
        dialect: DialectName,
        answers: &mut CallEvaluator<'_>,
        asserted: &[AssertedResult],
    ) {
        let SignatureResults { signature, calls, .. } = &*self;
        if !stickler_exact::signatures(&signature.function, dialect).contains(signature) {
            return;
        }
        let got = answers(dialect, signature, calls);
        let is_not_asked =
            |got: &Result<_, Refusal>| matches!(got, Err(refusal) if refusal.kind == RefusalKind::NotAsked);
        if got.iter().all(is_not_asked) {
            return;
        }
        let asserted = |call: &CallOperands| {
            let is_same = |one: &&AssertedResult| {
                one.dialect == dialect
                    && call[..] == one.operands[..]
                    && one.value.type_name() == signature.result.name()
            };
            let found = asserted.iter().find(is_same)?;
            Some((&found.value, &found.basis))
        };
        let compared = |(call, got): (&CallOperands, _)| ComparedResult {
            got,
            expected: ExpectedResult::of(signature, call, dialect, asserted(call)),
        };
        let results = calls.iter().zip(got).map(compared).collect();
        self.columns.push(DialectResults {
            engine,
            dialect,
            results,
        });
    }
}

/// Asks each engine or recording for the result of each call, in each of its dialects that have the signature. `asserted` are the results that cases
/// assert of the function.
///
/// # Errors
/// [`EngineError`] where no session of an engine can be opened.
pub fn gather(
    calls: Vec<(Signature, Vec<CallOperands>)>,
    sources: &[(AnswerSource<'_>, Vec<DialectName>)],
    asserted: &[AssertedResult],
) -> Result<Vec<SignatureResults>, EngineError> {
    let mut all: Vec<SignatureResults> = calls
        .into_iter()
        .map(|(signature, calls)| SignatureResults {
            signature,
            calls,
            columns: Vec::new(),
        })
        .collect();
    for (index, (source, dialects)) in sources.iter().enumerate() {
        let mut answers: CallEvaluator<'_> = match source {
            AnswerSource::Engine(engine) => {
                let mut session = FunctionSession::open(*engine)?;
                Box::new(move |dialect, signature, calls| session.results(dialect, signature, calls))
            }
            AnswerSource::Recording(recording) => {
                Box::new(|dialect, signature, calls| recording.results(dialect, signature, calls))
            }
        };
        for results in &mut all {
            for dialect in dialects {
                results.add(index, *dialect, &mut answers, asserted);
            }
        }
    }
    Ok(all)
}
