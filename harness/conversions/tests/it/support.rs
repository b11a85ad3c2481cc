//! Functions and types that several tests share.

use stickler_conversions::sweep::{Converter, Sampling, Sweep, SweepFindings, SweepMethod, agenda, run};
use stickler_engines::{ClosureEngine, RunRequest};
use stickler_types::{DialectName, Value};
use stickler_workers::Cancellation;

/// Returns the sweeps of a function in one dialect: each input of a small source, and a small sample of others.
pub fn sweeps(function: &str, dialect: DialectName) -> Vec<Sweep> {
    agenda(function, &[dialect], Sampling::default(), SweepMethod::Conversion).expect("a conversion function")
}

/// Returns the only sweep of a function in a dialect.
pub fn sweep(function: &str, dialect: DialectName) -> Sweep {
    let mut sweeps = sweeps(function, dialect);
    assert_eq!(sweeps.len(), 1, "{function}");
    sweeps.remove(0)
}

/// Runs a sweep to its end, and returns its findings.
pub fn findings(sweep: &Sweep, converter: &dyn Converter) -> SweepFindings {
    let found = run(sweep, converter, 0, &|_| {}, &Cancellation::new()).expect("threads");
    assert!(found.is_complete());
    found
}

/// A converter that changes the results of the reference's conversion.
pub struct Spoilt<'s, F> {
    /// The sweep whose reference converts.
    pub sweep: &'s Sweep,
    /// The function that takes the raw forms of an operand and of the right result or of one of its characters, and returns that of the
    /// wrong one.
    pub spoil: F,
}

impl<F: Fn(u64, u64) -> u64 + Sync> Converter for Spoilt<'_, F> {
    fn convert_all(&self, operands: &[u64], results: &mut [u64]) {
        self.sweep.reference.convert_all(operands, results);
        for (operand, result) in operands.iter().zip(results) {
            *result = (self.spoil)(*operand, *result);
        }
    }

    fn convert(&self, operands: &[Value]) -> Value {
        match (operands, self.sweep.reference.convert(operands)) {
            ([Value::Plain { raw: operand, .. }, ..], Value::Plain { ty, raw }) => {
                Value::plain(ty, (self.spoil)(*operand, raw))
            }
            ([Value::Plain { raw: operand, .. }, ..], Value::Text { ty, units }) => {
                let spoilt = units
                    .iter()
                    .map(|unit| (self.spoil)(*operand, (*unit).into()) as u16);
                Value::text(ty, spoilt.collect())
            }
            ([Value::Text { units, .. }], Value::Plain { ty, raw }) => {
                Value::plain(ty, (self.spoil)(units.len() as u64, raw))
            }
            (_, right) => right,
        }
    }
}

/// Returns the reference with a function replaced: `body` assigns `Wrong` from `x`, and may say `RIGHT` for the right result.
pub fn wrong(function: &str, from: &str, to: &str, body: &str) -> ClosureEngine<'static> {
    let body = body.replace("RIGHT", &format!("{function}(x)"));
    let call = format!(":= {function}(");
    let declared = format!("FUNCTION Wrong : {to}\nVAR_INPUT x : {from}; END_VAR\n{body}\nEND_FUNCTION\n");
    reading(move |source| format!("{declared}{}", source.replace(&call, ":= Wrong(")))
}

/// Returns the reference that reads another program than it is given.
pub fn reading<'f>(other: impl Fn(&str) -> String + Send + Sync + 'f) -> ClosureEngine<'f> {
    ClosureEngine::new("reference", move |reference, request| {
        let source = &other(request.source);
        reference.run(&RunRequest { source, ..*request })
    })
}
