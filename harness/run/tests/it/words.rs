//! Expectations, outcomes and judgements as the examples write them: one claim a line.

use std::str::FromStr;
use std::sync::Arc;
use stickler_engines::{Diagnostic, NamedValue, Outcome};
use stickler_run::{Fact, Judgement};
use stickler_suite::{
    Acceptance, Case, Expectation, ExpectedDiagnostic, ExpectedFault, ExpectedText, ExpectedValue,
};
use stickler_types::{DialectName, Fault, Observation, Severity, Value, join};

fn parsed<T: FromStr>(text: &str) -> T {
    text.parse().unwrap_or_else(|_| panic!("`{text}` cannot be read"))
}

/// Returns the text before the first blank, and the text behind it.
fn word(text: &str) -> (&str, &str) {
    text.split_once(' ').unwrap_or((text, ""))
}

/// Returns a case that expects what the lines say; without a line, only that the program is accepted.
///
/// | line | claim |
/// |---|---|
/// | `rejected`, `open` | the program is rejected; it may be |
/// | `error 6 P4035`, `warning 6 C0195` | a diagnostic on line 6 |
/// | `clean 4` | none on line 4 |
/// | `fault 9 subrange` | the run ends so |
/// | `q = INT#1`, `q@3 = INT#1` | a value |
/// | `observes q : INT` | a value is recorded |
/// | `rendered a := b;` | a line of the bodies of the rendered program |
pub fn expecting(lines: &str) -> Case {
    let mut expectation = Expectation::default();
    let mut observe: Vec<Observation> = Vec::new();
    let diagnostic = |rest: &str| {
        let (line, code) = word(rest);
        ExpectedDiagnostic {
            line: parsed(line),
            code: parsed(code),
        }
    };
    let observation = |name: &str, ty: &str| {
        let (name, after) = name
            .split_once('@')
            .map_or((name, None), |(name, scan)| (name, Some(parsed(scan))));
        Observation {
            after,
            ..Observation::last(name, ty)
        }
    };
    for line in lines.lines() {
        let (first, rest) = word(line);
        match first {
            "rejected" => expectation.accepted = Acceptance::Rejected,
            "open" => expectation.accepted = Acceptance::Observed,
            "error" => {
                expectation.accepted = Acceptance::Rejected;
                expectation.diagnostics.push(diagnostic(rest));
            }
            "warning" => expectation.warnings.push(diagnostic(rest)),
            "clean" => expectation.clean_lines.push(parsed(rest)),
            "fault" => {
                let (line, fault) = word(rest);
                expectation.fault = Some(ExpectedFault {
                    fault: parsed(fault),
                    line: parsed(line),
                });
            }
            "observes" => {
                let (name, ty) = rest.split_once(" : ").unwrap();
                observe.push(observation(name, ty));
            }
            "rendered" => {
                let rendered = expectation.rendered.get_or_insert(ExpectedText {
                    lines: Vec::new(),
                    line: 8,
                });
                rendered.lines.push(rest.into());
            }
            _ => {
                let (name, value) = named(line);
                let asked = observation(&name, value.type_name());
                let (name, after) = (Arc::clone(&asked.name), asked.after);
                expectation.values.push(ExpectedValue {
                    name,
                    after,
                    value,
                    line: 9,
                });
                observe.push(asked);
            }
        }
    }
    Case {
        title: "A title".into(),
        basis: "a-source: A section".into(),
        file: "conformance-cases/area/file.st".into(),
        area: "area".into(),
        observe: observe.into(),
        expectation: Arc::new(expectation),
        ..Case::of_program("area/file", DialectName::MATIEC, "area/file")
    }
}

fn named(line: &str) -> NamedValue {
    let (name, literal) = line
        .split_once(" = ")
        .unwrap_or_else(|| panic!("`{line}` is no claim"));
    (name.to_owned(), Value::parse(literal).unwrap())
}

/// Returns a diagnostic from its place, its code and its message: `6 P4035 told`. A hyphen stands for no line or no code, and
/// `1:1` for line and column.
fn diagnostic(text: &str, severity: Severity) -> Diagnostic {
    let (place, rest) = word(text);
    let (code, message) = word(rest);
    let (line, column) = place
        .split_once(':')
        .map_or((place, None), |(line, column)| (line, Some(parsed(column))));
    Diagnostic {
        severity,
        line: line.parse().ok(),
        column,
        code: (code != "-").then(|| code.to_owned()),
        message: if message.is_empty() { "told" } else { message }.to_owned(),
        ..Diagnostic::default()
    }
}

/// Returns what an engine does: `accepted`, `executed`, `faulted subrange 9` or `rejected`, each followed by lines of values and
/// diagnostics; `rendered` and the text; or a word with its reason, such as `crashed: why`.
pub fn outcome(text: &str) -> Outcome {
    let (head, rest) = text.split_once('\n').unwrap_or((text, ""));
    let is_warning = |line: &&str| line.starts_with("warning ");
    let values = || {
        rest.lines()
            .filter(|line| !is_warning(line))
            .map(named)
            .collect::<Vec<_>>()
    };
    let warnings = rest.lines().filter_map(|line| line.strip_prefix("warning "));
    let warnings = warnings.map(|text| diagnostic(text, Severity::Warning)).collect();
    let (kind, why) = head.split_once(':').unwrap_or((head, ""));
    let why = why.trim_start();
    let reason = why.to_owned();
    match word(kind) {
        ("accepted", _) => Outcome::Accepted { warnings },
        ("executed", _) => Outcome::Executed {
            values: values(),
            warnings,
        },
        ("rejected", _) => {
            let errors = rest.lines().map(|line| diagnostic(line, Severity::Error));
            Outcome::rejected(errors.collect())
        }
        ("faulted", place) => {
            let (fault, line) = word(place);
            Outcome::Faulted {
                fault: Fault::reported(fault),
                line: line.parse().ok(),
                values: values(),
                warnings,
            }
        }
        ("rendered", _) => Outcome::Rendered {
            text: rest.to_owned(),
        },
        ("unsupported", _) => Outcome::Unsupported { reason },
        ("not", _) => Outcome::NotImplemented { reason },
        ("unusable", _) => Outcome::Unusable { reason },
        ("crashed", _) => Outcome::Crashed { reason },
        ("timed", _) => Outcome::TimedOut {
            after_ms: parsed(why),
        },
        ("error", _) => Outcome::Error { message: reason },
        _ => panic!("`{text}` is no outcome"),
    }
}

/// Shows a judgement: the verdict with the grade, `as expected` where the facts are the expected ones, the actual facts, and what is recorded
/// in brackets.
pub fn shown(judgement: &Judgement) -> String {
    let grade = judgement.grade.map_or_else(String::new, |grade| {
        format!(" by {}", format!("{grade:?}").to_lowercase())
    });
    let expected = match judgement.got == judgement.expected {
        true => " as expected",
        false => "",
    };
    let recorded = judgement.observations.iter();
    let recorded = join(recorded.map(|it| format!("\n[{} = {}]", it.name, it.value)), "");
    let (verdict, got) = (judgement.verdict, Fact::text(&judgement.got));
    format!("{verdict}{grade}{expected}: {got}{recorded}")
}
