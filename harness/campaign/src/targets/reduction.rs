//! Reduces a mismatch of the reference, judges it once more, and makes a finding of it.

use super::TargetOracle;
use super::reduced::Small;
use crate::finding::{Confirmation, ExpectedBehavior, FORMAT, Finding, FindingOrigin};
use crate::oracle::Mismatch;
use stickler_generate::oracles::{FuzzTarget, OracleFailure};

impl TargetOracle {
    /// Reduces the input of a mismatch, and makes a finding of it.
    pub(super) fn finding(&self, mismatch: &Mismatch, going: &dyn Fn() -> bool) -> Finding {
        let target = self.target(mismatch.place);
        let input = self.input(mismatch.place);
        let found = target.judge(&input).err();
        let small = Small::of(target, &input, &mismatch.symptom, going);
        let standing = match small.failure {
            Some(_) => Confirmation::Confirmed,
            None => Confirmation::Flaky,
        };
        let original = text(target, found.as_ref(), &input);
        // What is not seen again is kept as it was found.
        let failure = small.failure.as_ref().or(found.as_ref());
        let program = text(target, failure, &small.input);
        let origin = FindingOrigin {
            seed: self.inputs.seed(),
            place: mismatch.place,
            open: false,
            smallest: small.smallest,
            tries: small.tries,
            size_found: size(original.as_deref(), &input),
            size: size(program.as_deref(), &small.input),
        };
        let message = match failure {
            Some(failure) => failure.message.clone(),
            None => format!("{}, but not when it was judged again", mismatch.symptom),
        };
        let finding = Finding {
            format: FORMAT,
            id: String::new(),
            stickler: env!("CARGO_PKG_VERSION").to_owned(),
            target: target.as_str().to_owned(),
            engine: None,
            symptom: mismatch.symptom.clone(),
            rule: small.rule,
            cause: None,
            dialect: small.dialect.map(|dialect| dialect.as_str().to_owned()),
            standing,
            origin,
            message,
            expected: small.expected.unwrap_or_else(|| ExpectedBehavior::Property {
                claim: claim(target).to_owned(),
            }),
            outcomes: Vec::new(),
            reproduce: Vec::new(),
            fingerprint: String::new(),
            program,
            original,
            input: small.input,
        }
        .named();
        Finding {
            reproduce: self.commands.of(&finding),
            ..finding
        }
    }
}

/// Returns the program that an input stands for, or the text that it is.
fn text(target: FuzzTarget, failure: Option<&OracleFailure>, input: &[u8]) -> Option<String> {
    let reads_text = matches!(
        target,
        FuzzTarget::Parse | FuzzTarget::Literal | FuzzTarget::CaseFile | FuzzTarget::Protocol
    );
    let program = failure.and_then(|failure| failure.program.clone());
    program.or_else(|| reads_text.then(|| String::from_utf8_lossy(input).into_owned()))
}

fn size(program: Option<&str>, input: &[u8]) -> u64 {
    program.map_or(input.len(), |program| program.lines().count()) as u64
}

/// Returns the property that holds for every input of a target.
const fn claim(target: FuzzTarget) -> &'static str {
    match target {
        FuzzTarget::Parse => {
            "any text is read without harm, and what can be read keeps its tree when it is rendered"
        }
        FuzzTarget::Literal => {
            "a literal's canonical spelling reads to the same value, which an independent reader finds too"
        }
        FuzzTarget::Convert => "the reference converts as exact arithmetic does",
        FuzzTarget::Check => "a planted error is reported with its code on its line, and nothing else is",
        FuzzTarget::Execute => {
            "a well-typed program is accepted and ends, and it and its variants give the evaluator's values"
        }
        FuzzTarget::CaseFile => "any case file gives cases or located errors",
        FuzzTarget::Protocol => "every line is answered",
    }
}
