//! The answers of a recording, to be compared with those of sources.

use super::{FunctionAnswers, RecordedSection, Recording, RecordingOrigin};
use crate::contradictions::{AnswerOrigin, ContradictionsBuilder};
use std::sync::Arc;
use stickler_types::{ConversionCall, ElementaryType, Question};

impl Recording {
    /// Adds what the compiler answered with a value, with acceptance or with a rejection; no call that it refused, which may be for its name.
    /// `address` is that of the file.
    pub fn add_answers(&self, builder: &mut ContradictionsBuilder, address: &str) {
        let RecordingOrigin {
            product,
            version,
            date,
            ..
        } = &self.origin;
        let origin = |dialect| {
            Arc::new(AnswerOrigin {
                system: product.clone(),
                kind: "recording".to_owned(),
                source: format!("recording: {}", self.name),
                read: format!("{version}, {date}"),
                address: address.to_owned(),
                dialect: Some(dialect),
            })
        };
        for ((dialect, (section, ty, other)), word) in &self.words {
            let answer = match *word {
                "accepts" | "warns" => "accepted",
                "rejects" | "rejected" => "rejected",
                "true" => "BOOL#TRUE",
                "false" => "BOOL#FALSE",
                _ => continue,
            };
            let question = match (section, ElementaryType::from_name(other)) {
                (RecordedSection::Bits, _) => Question::Part(*ty, other.clone()),
                (RecordedSection::Implicit, Some(into)) => Question::Implicit((*ty, into)),
                (RecordedSection::Comparisons, Some(right)) => Question::Comparison((*ty, right)),
                _ => continue,
            };
            builder.add_question(&question, None, (&origin(*dialect), answer.to_owned()));
        }
        for ((dialect, row), answers) in &self.functions {
            let FunctionAnswers::Calls(calls) = answers else {
                continue;
            };
            let function = row.split('(').next().unwrap_or_default();
            for (operands, value) in calls {
                let Ok(value) = value else { continue };
                if let Some(result) = ElementaryType::from_name(value.type_name()) {
                    let (function, operands) = (function.to_owned(), operands.clone());
                    let call = Question::Call(ConversionCall {
                        function,
                        operands,
                        result,
                    });
                    builder.add_question(&call, None, (&origin(*dialect), value.to_string()));
                }
            }
        }
    }
}
