//! Describing what an engine did in text that a finding can save.

use crate::finding::{EngineInfo, EngineReport};
use stickler_engines::Outcome;
use stickler_generate::reduce::diagnostic_line;
use stickler_types::Value;

/// Describes an outcome, one fact a line.
pub(crate) fn describe(engine: EngineInfo, outcome: &Outcome) -> EngineReport {
    let values = |values: &[(String, Value)]| {
        values
            .iter()
            .map(|(name, value)| format!("{name} = {value}"))
            .collect::<Vec<String>>()
    };
    let (word, said) = match outcome {
        Outcome::Accepted { .. } => ("accepted", Vec::new()),
        Outcome::Executed { values: got, .. } => ("executed", values(got)),
        Outcome::Rejected { diagnostics } => ("rejected", diagnostics.iter().map(diagnostic_line).collect()),
        Outcome::Faulted {
            fault,
            line,
            values: got,
            ..
        } => {
            let line = line.map(|line| format!(" on line {line}")).unwrap_or_default();
            let mut said = vec![format!("{fault}{line}")];
            said.extend(values(got));
            ("faulted", said)
        }
        Outcome::Rendered { .. } => ("rendered", Vec::new()),
        Outcome::Unsupported { reason } => ("unsupported", vec![reason.clone()]),
        Outcome::NotImplemented { reason } => ("not implemented", vec![reason.clone()]),
        Outcome::Crashed { reason } | Outcome::Unusable { reason } => ("crashed", vec![reason.clone()]),
        Outcome::TimedOut { .. } => ("timed out", vec![outcome.to_string()]),
        Outcome::Error { message } => ("error", vec![message.clone()]),
    };
    EngineReport {
        engine,
        outcome: word.to_owned(),
        said,
    }
}
