//! Oracle `convert`: a call of a conversion function gives the result of exact arithmetic.

use super::operands::operand;
use super::{InputOutcome, Judged, failed};
use arbitrary::Unstructured;
use std::sync::LazyLock;
use stickler_exact::{Signature, expected, functions, signatures};
use stickler_reference::{Limits, RequestError, run};
use stickler_types::{DialectName, ElementaryType, Observation, Outcome, RunRequest, Setting, Value, join};

/// Every conversion of each dialect, in the order of [`DialectName::ALL`].
static CONVERSIONS: LazyLock<[Vec<Signature>; DialectName::ALL.len()]> = LazyLock::new(|| {
    DialectName::ALL.map(|dialect| {
        let names = functions(dialect).into_iter();
        let may_name = |ty: &ElementaryType| dialect.rules().may_name(*ty);
        let all = names.flat_map(|name| signatures(&name, dialect));
        all.filter(|one| may_name(&one.result) && one.operands.iter().all(may_name))
            .collect()
    })
});

/// Judges one call: the first byte chooses the dialect, the next two the function, the rest its operands. The reference runs
/// a program that calls the function with variables, which are set from outside.
///
/// Where no document states the result, the reference must give what IEC 60559 and two's complement suggest.
///
/// Basis: rule: not-stated, and the basis that `stickler-exact` names for each call.
///
/// # Errors
/// Symptoms: `value:FUNCTION`, `rejected:CODE`, `fault:FAULT`, `internal-error`, `request`.
pub(super) fn judge(data: &[u8]) -> Judged {
    let mut input = Unstructured::new(data);
    let Ok((dialect, signature, operands)) = call(&mut input) else {
        return Ok(InputOutcome::Skipped("too short"));
    };
    let program = program(signature);
    hold(dialect, signature, &operands, &program).map_err(|failure| failure.of_program(program))?;
    Ok(InputOutcome::Checked)
}

fn call(input: &mut Unstructured<'_>) -> arbitrary::Result<(DialectName, &'static Signature, Vec<Value>)> {
    let dialect = *input.choose(&DialectName::ALL)?;
    let signature = input.choose(&CONVERSIONS[dialect.index()])?;
    let operands = signature.operands.iter().map(|ty| operand(*ty, input));
    Ok((dialect, signature, operands.collect::<arbitrary::Result<_>>()?))
}

/// Returns a program that calls the function with `a` and `b` and keeps the result in `r`.
fn program(signature: &Signature) -> String {
    let names = ["a", "b"].into_iter().zip(&signature.operands);
    let declarations: String = names
        .clone()
        .map(|(name, ty)| format!("    {name} : {};\n", declared(*ty)))
        .collect();
    let arguments: Vec<&str> = names.map(|(name, _)| name).collect();
    format!(
        "PROGRAM main\nVAR\n{declarations}    r : {};\nEND_VAR\n    r := {}({});\nEND_PROGRAM\n",
        declared(signature.result),
        signature.function,
        arguments.join(", ")
    )
}

/// Spells a type, with enough length for a text.
fn declared(ty: ElementaryType) -> String {
    if ty.is_text() {
        format!("{ty}[250]")
    } else {
        ty.to_string()
    }
}

fn hold(dialect: DialectName, signature: &Signature, operands: &[Value], source: &str) -> Judged<()> {
    let set: Vec<Setting> = ["a", "b"]
        .into_iter()
        .zip(operands)
        .map(|(name, value)| Setting {
            before: 1,
            name: name.into(),
            value: value.clone(),
        })
        .collect();
    let observe = [Observation::last("r", signature.result.name())];
    let request = RunRequest {
        set: &set,
        ..RunRequest::once(dialect, source, &observe)
    };
    let exact = expected(signature, operands, dialect);
    let (symptom, what) = match run(&request, Limits::default()) {
        Ok(Outcome::Executed { values, .. }) => match values.first().map(|(_, value)| value) {
            Some(value) if *value == exact.value => return Ok(()),
            got => {
                let got = got.map_or_else(|| "nothing".to_owned(), Value::to_string);
                let basis = exact.basis.unwrap_or("open: no document says");
                let what = format!(" is {} ({basis}), and the reference gives {got}", exact.value);
                (format!("value:{}", signature.function), what)
            }
        },
        Ok(Outcome::Rejected { diagnostics: said }) => {
            let first = said.first().and_then(|first| first.code.as_deref());
            let symptom = format!("rejected:{}", first.unwrap_or_default());
            (symptom, format!(" is rejected: {said:?}"))
        }
        Ok(Outcome::Faulted { fault, .. }) => (format!("fault:{fault}"), format!(" faults: {fault}")),
        Ok(other) => ("request".to_owned(), format!(": {other}")),
        Err(RequestError::Internal(reason)) => ("internal-error".to_owned(), format!(": {reason}")),
        Err(error) => ("request".to_owned(), format!(": {error}")),
    };
    let call = format!("{}({}) in {dialect}", signature.function, join(operands, ", "));
    failed(symptom, call + &what)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_conversion_of_every_dialect_can_be_called() {
        for dialect in DialectName::ALL {
            for signature in &CONVERSIONS[dialect.index()] {
                let zeros = signature
                    .operands
                    .iter()
                    .map(|ty| operand(*ty, &mut Unstructured::new(&[])));
                let zeros: Vec<Value> = zeros
                    .collect::<arbitrary::Result<_>>()
                    .expect("a simplest operand");
                assert_eq!(hold(dialect, signature, &zeros, &program(signature)), Ok(()));
            }
        }
    }

    #[test]
    fn another_value_is_a_failure() {
        let signature = &signatures("INT_TO_SINT", DialectName::MATIEC)[0];
        let wrong = program(signature).replace("INT_TO_SINT(a)", "INT_TO_SINT(a + 1)");
        let failure = hold(
            DialectName::MATIEC,
            signature,
            &[Value::plain(ElementaryType::Int, 5)],
            &wrong,
        );
        assert_eq!(failure.expect_err("5 is not 6").symptom, "value:INT_TO_SINT");
    }
}
