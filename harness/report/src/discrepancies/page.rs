//! Writes the page of a cluster, and the list of an engine's pages.

use super::{Cluster, ClusterKey};
use crate::basis::Basis;
use crate::engine;
use crate::markdown::{code, fence, inline};
use crate::text::{noted, visible};
use std::fmt::Write;
use stickler_run::{EngineHeader, Fact, Grade, PROGRAM};
use stickler_types::{counted, grouped};

/// Returns the beginning of the list of an engine's pages.
pub(super) fn index(name: &str, about: Option<&EngineHeader>, pages: usize, left_out: u64) -> String {
    let mut text = format!(
        "# What {} does otherwise than documents say\n\n",
        called(name, about)
    );
    let pages = counted(pages as u64, "page", "pages");
    // Writing to a String cannot fail.
    let _ = write!(
        text,
        "{pages}, each about the cases of one file and claim with one symptom, so most probably with one cause. Each is ready \
         to be sent to those who write the compiler, once somebody has read it.\n\n"
    );
    if left_out > 0 {
        let cases = counted(left_out, "case", "cases");
        let _ = write!(
            text,
            "No page has room for {cases} of other kinds; `events.jsonl` has them.\n\n"
        );
    }
    text.push_str("| cases | page | claim |\n|--:|---|---|\n");
    text
}

/// Returns the line for one page in the list of pages.
pub(super) fn entry(file: &str, key: &ClusterKey, cluster: &Cluster) -> String {
    format!(
        "| {} | [{}: {}]({file}) | {} |\n",
        cluster.number(),
        inline(&key.file),
        inline(&key.symptom.to_string()),
        inline(&key.basis)
    )
}

/// Returns the page of a cluster.
pub(super) fn page(name: &str, about: Option<&EngineHeader>, key: &ClusterKey, cluster: &Cluster) -> String {
    let case = &cluster.smallest;
    let mut text = format!(
        "# {}: {}\n\n{}.\n\n",
        called(name, about),
        inline(&key.symptom.to_string()),
        inline(&case.title)
    );
    let program = case.program.as_deref().map(visible).unwrap_or_default();
    block(
        &mut text,
        &format!("Save this as `{PROGRAM}`:"),
        "iecst",
        &program,
    );
    let command = about.and_then(|about| about.commands.get(&case.dialect));
    match command {
        Some(command) => block(&mut text, "and run", "sh", command),
        None => text.push_str("and give it to the compiler.\n\n"),
    }
    let by = format!("Expected, by *{}*:", inline(&case.basis));
    expected_and_got(&mut text, &by, (&case.basis, &case.expected, &case.got));
    let _ = write!(text, "Lines are those of `{PROGRAM}`. ");
    if key.symptom.is_of_a_rejection() {
        text.push_str(not_compared(about.map_or(Grade::Code, |about| about.strict)));
    }
    others(&mut text, cluster);
    if let Some(note) = &case.baseline {
        let _ = write!(text, "It is known: {}.\n\n", inline(&noted(note)));
    }
    let _ = writeln!(
        text,
        "Found by Stickler, in its dialect `{}`: {}",
        case.dialect,
        code(&engine::rerun(about, case))
    );
    text
}

/// Adds the expected and the actual facts; `by` stands before the expected ones. Of a compiler that crashes, a rule of Stickler demands
/// no more than an answer.
pub(super) fn expected_and_got(
    text: &mut String,
    by: &str,
    (basis, expected, got): (&str, &[Fact], &[Fact]),
) {
    let no_answer = |fact: &Fact| matches!(fact, Fact::Crashed { .. } | Fact::TimedOut { .. });
    let is_unusable = |fact: &Fact| matches!(fact, Fact::Unusable { .. });
    let is_rule = Basis::of(basis).is_rule();
    let (wanted, reported) = (without_agreeing(expected, got), without_agreeing(got, expected));
    if is_rule && got.iter().any(no_answer) {
        block(text, "Expected:", "", "an answer, no crash");
    } else if is_rule && got.iter().any(is_unusable) {
        block(text, "Expected:", "", "a rejection, or a program that runs");
    } else {
        block(text, by, "", &visible(&Fact::text(&wanted)));
    }
    block(text, "Got:", "", &visible(&Fact::text(&reported)));
    let agreeing = (expected.len() - wanted.len()) as u64;
    if agreeing > 0 {
        let values = counted(agreeing, "other value is", "other values are");
        let _ = write!(text, "{values} as expected.\n\n");
    }
}

/// Returns the facts without those values that the other facts have too, where all that differs are values.
pub(super) fn without_agreeing(facts: &[Fact], others: &[Fact]) -> Vec<Fact> {
    let is_value = |fact: &Fact| {
        matches!(
            fact,
            Fact::Value { .. } | Fact::MissingValue { .. } | Fact::OtherValue { .. }
        )
    };
    let are_values = facts.iter().chain(others).all(is_value);
    let differs = |fact: &&Fact| !others.contains(fact);
    match are_values && facts.iter().any(|fact| differs(&fact)) {
        true => facts.iter().filter(differs).cloned().collect(),
        false => facts.to_vec(),
    }
}

/// Returns the sentence about the parts of a diagnostic that were not compared.
pub(super) const fn not_compared(strict: Grade) -> &'static str {
    match strict {
        Grade::Code => "",
        Grade::Line => "Codes are Stickler's own and were not compared, only lines. ",
        Grade::Rejected => "Codes are Stickler's own; neither they nor lines were compared. ",
    }
}

/// Adds the number of cases in the cluster, and their probes and dialects.
fn others(text: &mut String, cluster: &Cluster) {
    let number = cluster.number();
    if number == 1 {
        text.push_str("One case shows this.\n\n");
        return;
    }
    let _ = write!(text, "{} cases show this:\n\n", grouped(number));
    for ((probe, dialect), cases) in &cluster.cases {
        let _ = writeln!(text, "- {cases} of {} in {}", code(probe), inline(dialect));
    }
    text.push('\n');
}

pub(super) fn called(name: &str, about: Option<&EngineHeader>) -> String {
    let version = about.map_or("", |about| about.version.as_str());
    inline(format!("{name} {version}").trim_end())
}

/// Adds a sentence and a code block, with a fence that the code cannot close.
pub(super) fn block(text: &mut String, before: &str, language: &str, code: &str) {
    let fence = fence(code);
    let code = code.trim_end_matches('\n');
    let _ = write!(text, "{before}\n\n{fence}{language}\n{code}\n{fence}\n\n");
}
