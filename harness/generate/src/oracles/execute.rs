//! Oracle `execute`: the reference accepts a well-typed program, runs it to its end, and gives the values of the evaluator,
//! for the program and for its variants.

use super::{InputOutcome, Judged, OracleFailure, failed};
use crate::evaluate::{CYCLE, Evaluation, EvaluationError, evaluate};
use crate::generator::{GeneratorSettings, program};
use crate::model::Program;
use crate::random::{Random, bytes};
use crate::reduce::deviation;
use crate::variants::Variant;
use crate::writer::{Style, write};
use arbitrary::Unstructured;
use stickler_reference::{Limits, RequestError, run};
use stickler_types::{ClockSetting, DialectName, Fnv1a, Observation, Outcome, RunRequest, Value};

/// The number of variants of a program that are tried; the input chooses which.
const VARIANTS_TRIED: usize = 3;

/// Judges the program of an input.
///
/// # Errors
/// See [`judge_program`].
pub fn execute(data: &[u8]) -> Judged {
    judge_program(&program_of(data), data)
}

/// Generates the program of an input: of any dialect, without anything that documents leave open.
pub fn program_of(data: &[u8]) -> Program {
    program(data, &GeneratorSettings::default())
}

/// Judges a program. The bytes of `rest` choose which variants are tried, and what they vary: the same bytes choose alike
/// for every program, so that a program can be made smaller while it stays wrong.
///
/// # Errors
/// The reference rejects the program or a variant of it, faults where the evaluator does not or otherwise, does not
/// terminate, breaks down, or gives another value; or the program is ill-formed, which is a defect of the generator. The
/// symptom of a variant begins with `variant`, its name and a colon.
pub fn judge_program(program: &Program, rest: &[u8]) -> Judged {
    let text = write(program, &Style::default()).text;
    let scans = scans(rest);
    let evaluation = match evaluate(program, scans) {
        Ok(evaluation) => evaluation,
        Err(EvaluationError::Raw) => return Ok(InputOutcome::Skipped("raw text in the program")),
        Err(EvaluationError::Fault(fault)) => return judge_fault(program, &text, scans, fault),
        Err(EvaluationError::StepLimit) => {
            let message = "the program takes too many steps, though it is made to end soon";
            return Err(OracleFailure::new("generator:step-limit", message).of_program(text));
        }
        Err(EvaluationError::IllFormed(why)) => {
            let message = format!("the model of the program contradicts itself: {why}");
            return Err(OracleFailure::new("generator:ill-formed", message).of_program(text));
        }
    };
    let binds = evaluation.binds_the_reference();
    // Where documents leave values open, the program is accepted and runs all the same.
    let values = if binds { &evaluation.values[..] } else { &[] };
    judge_text(program, &text, scans, values).map_err(|failure| failure.of_program(&*text))?;
    if !binds {
        return Ok(InputOutcome::Skipped("documents leave open what it gives"));
    }
    judge_variants(program, &text, &evaluation, rest)?;
    Ok(InputOutcome::Checked)
}

/// Judges a program that stops: the reference must stop it with the same fault.
fn judge_fault(program: &Program, text: &str, scans: u32, fault: stickler_types::Fault) -> Judged {
    let symptom = match reference(program.dialect, text, scans, &[]) {
        Ok(Outcome::Faulted { fault: given, .. }) if given == fault => return Ok(InputOutcome::Checked),
        Ok(Outcome::Faulted { fault: given, .. }) => format!("fault:{given}"),
        Ok(Outcome::Executed { .. }) => format!("not-fault:{fault}"),
        Ok(ref outcome @ Outcome::Rejected { .. }) => {
            deviation(&[], outcome).map_or_else(String::new, |(symptom, _)| symptom.to_string())
        }
        Ok(_) => "not-run".to_owned(),
        Err(error) => broken(&error).symptom,
    };
    let message =
        format!("the program stops by its documents with the fault {fault}; the reference does not");
    Err(OracleFailure::new(symptom, message).of_program(text))
}

/// Judges some variants of a program that the reference runs correctly.
fn judge_variants(program: &Program, text: &str, evaluation: &Evaluation, rest: &[u8]) -> Judged<()> {
    let choices = choice_bytes(rest);
    let mut choices = Unstructured::new(&choices);
    for _ in 0..VARIANTS_TRIED {
        let chosen = Random::new(&mut choices).below(Variant::ALL.len());
        let Some(variant) = Variant::ALL.get(chosen) else {
            break;
        };
        if let Some(varied) = variant.text(program, &mut choices) {
            judge_variant(*variant, program, text, &varied, scans(rest), evaluation)?;
        }
    }
    Ok(())
}

fn judge_variant(
    variant: Variant,
    program: &Program,
    text: &str,
    varied: &str,
    scans: u32,
    evaluation: &Evaluation,
) -> Judged<()> {
    judge_text(program, varied, scans, &evaluation.values).map_err(|failure| {
        let name = variant.as_str();
        OracleFailure::new(
            format!("variant {name}:{}", failure.symptom),
            format!(
                "the program is right, but its variant `{name}` is not: {}; the variant is\n{varied}\nof",
                failure.message
            ),
        )
        .of_program(text)
    })
}

/// Compares what the reference does with a text of a program with the values that the program must give.
fn judge_text(program: &Program, text: &str, scans: u32, values: &[(String, Value)]) -> Judged<()> {
    let outcome = match reference(program.dialect, text, scans, &program.observed()) {
        Ok(outcome @ (Outcome::Executed { .. } | Outcome::Rejected { .. } | Outcome::Faulted { .. })) => {
            outcome
        }
        Ok(other) => return failed("not-run", format!("the reference answers: {other}")),
        Err(error) => return Err(broken(&error)),
    };
    match deviation(values, &outcome) {
        None => Ok(()),
        Some((symptom, message)) => failed(symptom.to_string(), message),
    }
}

/// Runs a text on the reference.
fn reference(
    dialect: DialectName,
    source: &str,
    scans: u32,
    observed: &[(String, stickler_types::ElementaryType)],
) -> Result<Outcome, RequestError> {
    let observe: Vec<Observation> = observed
        .iter()
        .map(|(name, ty)| Observation::last(name, ty.name()))
        .collect();
    let request = RunRequest {
        scans,
        clock: &ClockSetting::each(CYCLE, scans),
        ..RunRequest::once(dialect, source, &observe)
    };
    run(&request, Limits::default())
}

/// Returns the number of scans that the program of an input runs.
fn scans(input: &[u8]) -> u32 {
    1 + u32::from(choice_bytes(input)[0] % 4)
}

fn broken(error: &RequestError) -> OracleFailure {
    let symptom = match error {
        RequestError::Internal(_) => "internal-error",
        _ => "not-observed",
    };
    OracleFailure::new(symptom, format!("the reference gives no values: {error}"))
}

/// Derives bytes for choices from an input; inputs that differ in one bit give unrelated bytes.
fn choice_bytes(input: &[u8]) -> Vec<u8> {
    const LENGTH: usize = 512;
    bytes(Fnv1a::of(input).finish(), LENGTH)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_bytes_and_few_bytes_stand_for_programs_that_are_right() {
        for data in [&[][..], &[1], &[0xFF; 40], &[0x5A; 400]] {
            assert_eq!(execute(data), Ok(InputOutcome::Checked), "{data:?}");
        }
    }

    #[test]
    fn every_variant_of_a_program_that_has_everything_gives_its_values() {
        let program = crate::variants::tests::everything();
        let text = write(&program, &Style::default()).text;
        let evaluation = evaluate(&program, 1).unwrap();
        for variant in Variant::ALL {
            for seed in 0..20 {
                let choices = choice_bytes(&[seed]);
                if let Some(varied) = variant.text(&program, &mut Unstructured::new(&choices)) {
                    assert_eq!(
                        judge_variant(variant, &program, &text, &varied, 1, &evaluation),
                        Ok(())
                    );
                }
            }
        }
    }

    #[test]
    fn a_variant_that_gives_another_value_is_named() {
        let program = crate::variants::tests::everything();
        let text = write(&program, &Style::default()).text;
        let evaluation = evaluate(&program, 1).unwrap();
        let wrong = text.replace("7", "8");
        let failure = judge_variant(Variant::DeadCode, &program, &text, &wrong, 1, &evaluation).unwrap_err();
        assert_eq!(failure.symptom, "variant dead-code:value:DINT");
        let ill_formed = text.replace("INT#7", "INT#7.0");
        let failure = judge_variant(Variant::Bits, &program, &text, &ill_formed, 1, &evaluation).unwrap_err();
        assert_eq!(failure.symptom, "variant bits:rejected:P2026");
    }

    #[test]
    fn one_bit_of_the_input_changes_the_choices_altogether() {
        let (one, other) = (choice_bytes(&[0]), choice_bytes(&[1]));
        assert!(one.iter().zip(&other).filter(|(a, b)| a == b).count() < 16);
        assert_eq!(choice_bytes(&[1]), other);
    }
}
