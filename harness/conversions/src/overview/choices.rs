//! The list, below a table of results, of the rules that dialects choose where systems differ; one line for each choice.

use super::page::WIDTH;
use crate::functions::dialect_list;
use anstyle::Style;
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::sync::LazyLock;
use stickler_exact::{Operation, Signature};
use stickler_types::{DialectName, ElementaryType, Family, grouped_by_key, wrap_within};

const DIM: Style = Style::new().dimmed();

/// The words of `choices.toml`, by topic and choice.
static WORDS: LazyLock<BTreeMap<String, BTreeMap<String, String>>> =
    LazyLock::new(|| toml::from_str(include_str!("choices.toml")).unwrap_or_default());

/// A rule in which systems may differ: its topic in `choices.toml`, and its key in the table `conversions` of a dialect's file.
type Topic = (&'static str, &'static str);

/// Writes the choices that matter for a signature: each with its dialects, or without them where all dialects choose the same.
///
/// # Errors
/// Errors of writing to `out`.
pub fn write(signature: &Signature, dialects: &[DialectName], out: &mut dyn Write) -> io::Result<()> {
    let topics = topics(signature).into_iter();
    let topics = topics.map(|topic| (said(topic, "label", signature), topic));
    let topics: Vec<(String, Topic)> = topics.collect();
    let labels = topics.iter().map(|(label, _)| label.len()).max().unwrap_or(0);
    for (label, topic) in topics {
        let choices = choices(topic, signature, dialects);
        for (index, (choice, choosers)) in choices.iter().enumerate() {
            let label = if index == 0 { label.as_str() } else { "" };
            let said = match choices.len() {
                1 => choice.clone(),
                _ => format!("{choice}: {}", dialect_list(choosers)),
            };
            // Deeper than the words of the next choice.
            let indent = labels + 4;
            let lines = wrap_within(&said, WIDTH.saturating_sub(indent));
            let text = lines.replace('\n', &format!("\n{:indent$}", ""));
            writeln!(out, "{DIM}{label:labels$}{DIM:#}  {text}")?;
        }
    }
    Ok(())
}

/// Returns whether any choice of a dialect matters for a signature.
pub fn any(signature: &Signature) -> bool {
    !topics(signature).is_empty()
}

/// Returns the rules that matter for a signature: what each is about, as in `rounding`, the rule in words, and the dialects that have it.
pub fn rules(signature: &Signature, dialects: &[DialectName]) -> Vec<(String, String, Vec<DialectName>)> {
    let of_topic = |topic: Topic| {
        let choices = choices(topic, signature, dialects).into_iter();
        choices.map(move |(rule, choosers)| (said(topic, "label", signature), rule, choosers))
    };
    topics(signature).into_iter().flat_map(of_topic).collect()
}

/// Returns each choice of a topic with the dialects that make it, in the order of the dialects.
fn choices(topic: Topic, signature: &Signature, dialects: &[DialectName]) -> Vec<(String, Vec<DialectName>)> {
    let key = format!("conversions.{}", topic.1);
    grouped_by_key(dialects.iter().map(|dialect| {
        let mut all = dialect.rules().all_choices();
        let made = all.find(|(known, _)| *known == key);
        let choice = said(topic, &made.map_or(String::new(), |(_, word)| word), signature);
        (choice, *dialect)
    }))
}

/// Returns what `choices.toml` says of a choice.
fn said((topic, _): Topic, choice: &str, signature: &Signature) -> String {
    let to = signature.result;
    let words = |choice: &str| WORDS.get(topic)?.get(choice);
    let text = words(&format!("{choice}/{}", to.bits()))
        .or_else(|| words(choice))
        .or_else(|| words("*"));
    let has_reals = signature.operands.iter().any(|ty| ty.is_real());
    let reals = if has_reals {
        "; NaN and the infinities give 0"
    } else {
        ""
    };
    let units = if to.is_third_edition() { "64" } else { "32" };
    text.map_or(choice, String::as_str)
        .replace("{to}", to.name())
        .replace("{bits}", &to.bits().to_string())
        .replace("{units}", units)
        .replace("{choice}", choice)
        .replace("{reals}", reals)
}

fn topics(signature: &Signature) -> Vec<Topic> {
    let &[from] = &signature.operands[..] else {
        return Vec::new();
    };
    let to = signature.result;
    let rounding = ("rounding", "rounding");
    let outside = match signature.operation {
        Operation::Truncate => ("outside", "truncation-out-of-range"),
        _ => ("outside", "out-of-range"),
    };
    match (signature.operation, from.family(), to.family()) {
        (Operation::Convert, Family::BitString, Family::Boolean) => vec![("truth", "bit-string-as-bool")],
        (Operation::Convert, Family::BitString, Family::Real) if from.bits() == to.bits() => {
            vec![("bits-to-real", "bits-as-real")]
        }
        (Operation::Convert, Family::Real, Family::BitString) if from.bits() == to.bits() => {
            vec![("bits-of-real", "bits-as-real"), rounding, outside]
        }
        (Operation::Convert, Family::Real, _) if to.is_whole() => vec![rounding, outside],
        (Operation::Convert, Family::Signed | Family::Unsigned | Family::BitString, _)
            if to.is_whole() && narrows(signature) =>
        {
            vec![("narrowing", "out-of-range")]
        }
        (Operation::Convert, Family::Text, _) if to.is_whole() || to.is_real() => {
            vec![("reading", "text-reading")]
        }
        (Operation::Convert, Family::Real, Family::Text) => vec![("digits", "real-text")],
        (Operation::Convert, Family::BitString, Family::Text) => vec![("spelling", "bit-string-text")],
        (Operation::Convert, ..) if from.is_moment() && (to.is_whole() || to.is_real()) && to.bits() > 1 => {
            vec![(unit(from), "moment-units")]
        }
        (Operation::Convert, ..) if to.is_moment() && from.is_number() => {
            let outside = match to.family() {
                Family::TimeOfDay => "outside-time-of-day",
                Family::Date => "outside-date",
                _ if to == ElementaryType::Time && !from.is_real() => "outside-time",
                _ => "outside-moment",
            };
            vec![(unit(to), "moment-units"), (outside, "moment-units")]
        }
        (Operation::Truncate | Operation::Round | Operation::Ceiling | Operation::Floor, ..) => vec![outside],
        _ => Vec::new(),
    }
}

/// Returns the topic of the unit in which a number counts a duration, date or time of day.
const fn unit(moment: ElementaryType) -> &'static str {
    match moment.family() {
        Family::TimeOfDay => "unit-of-time-of-day",
        Family::Date => "unit-of-date",
        Family::DateAndTime => "unit-of-date-and-time",
        _ => "unit-of-duration",
    }
}

/// Returns whether the type of the operand has values that the type of the result does not hold.
fn narrows(signature: &Signature) -> bool {
    let ranges = (
        signature.operands[0].integer_range(),
        signature.result.integer_range(),
    );
    matches!(ranges, (Some(from), Some(to)) if from.0 < to.0 || from.1 > to.1)
}
