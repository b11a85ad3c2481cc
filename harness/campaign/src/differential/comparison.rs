//! What an engine did, held against what the evaluator gives.

use stickler_engines::{Diagnostic, Outcome};
use stickler_types::{Code, DialectName, Value};

/// What an engine is asked about a program.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Question<'a> {
    /// The dialect of the program.
    pub(crate) dialect: DialectName,
    /// Its text.
    pub(crate) text: &'a str,
    /// What is observed of it at the end of one scan, and what must be seen.
    pub(crate) values: &'a [(String, Value)],
    /// Whether an engine must accept it, and give these values. Where something happens that no document settles, it need not.
    pub(crate) binds: bool,
}

/// What came of the comparison.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Agreement {
    /// The engine did what it must.
    Agrees,
    /// The engine says that it cannot do this.
    Unsupported,
    /// It did something else.
    Disagrees(Disagreement),
}

/// How an engine did something else.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Disagreement {
    /// In a word that stays the same when the program is made smaller.
    pub(crate) symptom: String,
    /// For a person.
    pub(crate) message: String,
}

impl Agreement {
    fn disagrees(symptom: impl Into<String>, message: impl Into<String>) -> Agreement {
        Agreement::Disagrees(Disagreement {
            symptom: symptom.into(),
            message: message.into(),
        })
    }

    /// The symptom, where there is one.
    pub(crate) fn symptom(&self) -> Option<&str> {
        match self {
            Agreement::Disagrees(disagreement) => Some(&disagreement.symptom),
            Agreement::Agrees | Agreement::Unsupported => None,
        }
    }
}

/// Holds an outcome against what was asked. Where an engine is not bound, only what no program excuses counts: to die, to
/// hang, to answer nonsense.
pub(crate) fn compare(question: Question<'_>, outcome: &Outcome) -> Agreement {
    let Question {
        values: expected,
        binds,
        ..
    } = question;
    match outcome {
        Outcome::Unsupported { .. } => Agreement::Unsupported,
        Outcome::Accepted => Agreement::Agrees,
        Outcome::Executed { values } if binds => values_agree(expected, values),
        Outcome::Rejected { diagnostics } if binds => rejected(diagnostics),
        Outcome::Faulted { fault, line, .. } if binds => {
            let line = line.map(|line| format!(" on line {line}")).unwrap_or_default();
            Agreement::disagrees(
                format!("fault:{fault}"),
                format!("expected to run to its end, got the fault {fault}{line}"),
            )
        }
        Outcome::Executed { .. } | Outcome::Rejected { .. } | Outcome::Faulted { .. } => Agreement::Agrees,
        Outcome::Rendered { .. } => Agreement::disagrees("error", "answered `rendered` where it was to run"),
        Outcome::Crashed { reason } => Agreement::disagrees("crash", format!("died: {reason}")),
        Outcome::TimedOut { after_ms } => {
            Agreement::disagrees("hang", format!("gave no answer within {after_ms} ms"))
        }
        Outcome::Error { message } => Agreement::disagrees("error", message.as_str()),
    }
}

fn rejected(diagnostics: &[Diagnostic]) -> Agreement {
    let first = diagnostics.first();
    let told = first.map(|first| match &first.code {
        // A parser has one code for all that it does not understand, and says what that is in its own words.
        Some(code) if code == Code::SyntaxError.as_str() => {
            format!("{code} {}", gist(&first.message)).trim_end().to_owned()
        }
        Some(code) => code.clone(),
        None => gist(&first.message),
    });
    let symptom = match told.filter(|told| !told.is_empty()) {
        Some(told) => format!("rejected:{told}"),
        None => "rejected".to_owned(),
    };
    let message = match first {
        Some(first) => format!("expected to be accepted, rejected: {}", diagnostic(first)),
        None => "expected to be accepted, rejected without a reason".to_owned(),
    };
    Agreement::disagrees(symptom, message)
}

/// What is left of the message of a compiler without codes when a program gets smaller: the first of its words, without what
/// it quotes, without names and numbers that a generator made.
fn gist(message: &str) -> String {
    const WORDS: usize = 6;
    let quote = |character: char| "'\"`".contains(character);
    // Every other piece stands between quotation marks.
    let said = message.lines().next().unwrap_or_default().split(quote).step_by(2);
    let words = said.flat_map(str::split_whitespace);
    let plain = |word: &&str| {
        word.bytes()
            .all(|byte| byte.is_ascii_alphabetic() || b",.:;()-".contains(&byte))
    };
    let words: Vec<String> = words
        .filter(plain)
        .map(|word| {
            word.trim_matches(|end: char| !end.is_ascii_alphabetic())
                .to_ascii_lowercase()
        })
        .filter(|word| !word.is_empty())
        .take(WORDS)
        .collect();
    words.join(" ")
}

/// One diagnostic in one line.
pub(crate) fn diagnostic(diagnostic: &Diagnostic) -> String {
    let mut text = diagnostic.code.clone().unwrap_or_else(|| "error".to_owned());
    if let Some(line) = diagnostic.line {
        text.push_str(&format!(" on line {line}"));
    }
    text.push_str(": ");
    text.push_str(&diagnostic.message);
    text
}

fn values_agree(expected: &[(String, Value)], got: &[(String, Value)]) -> Agreement {
    let differing = expected
        .iter()
        .filter(|(name, value)| find(got, name) != Some(value));
    // A checksum differs because something else does, which tells more.
    let Some((name, value)) = differing.min_by_key(|(name, _)| is_checksum(name)) else {
        return Agreement::Agrees;
    };
    let ty = value.type_name();
    match find(got, name) {
        Some(other) => Agreement::disagrees(
            format!("value:{ty}"),
            format!("{name}: expected {value}, got {other}"),
        ),
        None => Agreement::disagrees(
            format!("missing:{ty}"),
            format!("{name}: expected {value}, got no value"),
        ),
    }
}

fn find<'v>(values: &'v [(String, Value)], name: &str) -> Option<&'v Value> {
    values
        .iter()
        .find(|(other, _)| other == name)
        .map(|(_, value)| value)
}

/// Whether the generator computes it from everything else.
fn is_checksum(name: &str) -> bool {
    name.starts_with("checksum")
}

#[cfg(test)]
mod tests {
    use super::gist;

    #[test]
    fn the_gist_of_a_message_has_no_names_and_no_numbers() {
        assert_eq!(
            gist("Variable v17 of type 'INT' is not declared (line 5)."),
            "variable of type is not declared"
        );
        assert_eq!(
            gist("unknown error in program declaration."),
            "unknown error in program declaration"
        );
        assert_eq!(gist("\"x\": 5"), "");
        assert_eq!(gist(""), "");
    }
}
