//! The list, below a table of results, of the rules that dialects choose where systems differ; one line for each choice.

use super::page::WIDTH;
use crate::functions::dialect_list;
use anstyle::Style;
use std::io::{self, Write};
use stickler_exact::{Operation, Signature};
use stickler_types::{
    BitStringAsBool, BitStringText, BitsAsReal, ConversionChoices, DialectName, ElementaryType, Family,
    MomentUnits, OutOfRange, RealText, Rounding, TextReading, wrap_within,
};

const DIM: Style = Style::new().dimmed();

/// A rule in which systems may differ: its label, and the words for each choice.
struct Topic {
    label: String,
    choice: fn(&ConversionChoices, &Signature) -> String,
}

/// Writes the choices that matter for a signature: each with its dialects, or without them where all dialects choose the same.
///
/// # Errors
/// Errors of writing to `out`.
pub fn write(signature: &Signature, dialects: &[DialectName], out: &mut dyn Write) -> io::Result<()> {
    let topics = topics(signature);
    let labels = topics.iter().map(|topic| topic.label.len()).max().unwrap_or(0);
    for topic in &topics {
        let choices = choices(topic, signature, dialects);
        for (index, (choice, choosers)) in choices.iter().enumerate() {
            let label = if index == 0 { topic.label.as_str() } else { "" };
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
#[must_use]
pub fn rules(signature: &Signature, dialects: &[DialectName]) -> Vec<(String, String, Vec<DialectName>)> {
    let of_topic = |topic: Topic| {
        let choices = choices(&topic, signature, dialects).into_iter();
        choices.map(move |(rule, choosers)| (topic.label.clone(), rule, choosers))
    };
    topics(signature).into_iter().flat_map(of_topic).collect()
}

/// Returns each choice of a topic with the dialects that make it, in the order of the dialects.
fn choices(
    topic: &Topic,
    signature: &Signature,
    dialects: &[DialectName],
) -> Vec<(String, Vec<DialectName>)> {
    let mut found: Vec<(String, Vec<DialectName>)> = Vec::new();
    for dialect in dialects {
        let choice = (topic.choice)(&dialect.rules().conversions, signature);
        match found.iter_mut().find(|(known, _)| *known == choice) {
            Some((_, choosers)) => choosers.push(*dialect),
            None => found.push((choice, vec![*dialect])),
        }
    }
    found
}

fn topics(signature: &Signature) -> Vec<Topic> {
    let &[from] = &signature.operands[..] else {
        return Vec::new();
    };
    let to = signature.result;
    let topic = |label: &str, choice: fn(&ConversionChoices, &Signature) -> String| Topic {
        label: label.to_owned(),
        choice,
    };
    let outside = format!("outside {to}");
    match (signature.operation, from.family(), to.family()) {
        (Operation::Convert, Family::BitString, Family::Boolean) => vec![topic("TRUE", truth)],
        (Operation::Convert, Family::BitString, Family::Real) if from.bits() == to.bits() => {
            vec![topic("bits", copy)]
        }
        (Operation::Convert, Family::Real, Family::BitString) if from.bits() == to.bits() => vec![
            topic("bits", copy),
            topic("rounding", rounding),
            topic(&outside, outside_of_reals),
        ],
        (Operation::Convert, Family::Real, _) if to.is_whole() => {
            vec![topic("rounding", rounding), topic(&outside, outside_of_reals)]
        }
        (Operation::Convert, Family::Signed | Family::Unsigned | Family::BitString, _)
            if to.is_whole() && narrows(signature) =>
        {
            vec![topic(&outside, modulo)]
        }
        (Operation::Convert, Family::Text, Family::Real) => vec![topic("reading", reading)],
        (Operation::Convert, Family::Text, _) if to.is_whole() => vec![topic("reading", reading)],
        (Operation::Convert, Family::Real, Family::Text) => vec![topic("digits", digits)],
        (Operation::Convert, Family::BitString, Family::Text) => vec![topic("spelling", spelling)],
        (Operation::Convert, ..) if from.is_moment() && (to.is_whole() || to.is_real()) && to.bits() > 1 => {
            vec![topic("unit", unit)]
        }
        (Operation::Convert, ..) if to.is_moment() && from.is_number() => {
            vec![topic("unit", unit), topic(&outside, outside_of_moments)]
        }
        (Operation::Truncate | Operation::Round | Operation::Ceiling | Operation::Floor, ..) => {
            vec![topic(&outside, outside_of_reals)]
        }
        _ => Vec::new(),
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

fn rounding(choices: &ConversionChoices, _: &Signature) -> String {
    match choices.rounding {
        Rounding::Truncate => "toward zero",
        Rounding::HalfToEven => "to the nearest, halves to the even one",
        Rounding::HalfAwayFromZero => "to the nearest, halves away from zero",
        Rounding::Up => "upward",
        Rounding::Down => "downward",
        Rounding::AwayFromZero => "away from zero",
    }
    .to_owned()
}

fn outside_of_reals(choices: &ConversionChoices, signature: &Signature) -> String {
    let choices = match signature.operation {
        Operation::Truncate => choices.of_truncation(),
        _ => *choices,
    };
    match choices.out_of_range {
        OutOfRange::Wrap => format!("{}; NaN and the infinities give 0", modulo(&choices, signature)),
        OutOfRange::Saturate => "the nearest limit, for the infinities too; NaN gives 0".to_owned(),
        OutOfRange::Indefinite64 if signature.result.bits() <= 32 => {
            format!(
                "{}, but not below -2^31; 0 beyond 64 bits and for NaN",
                modulo(&choices, signature)
            )
        }
        OutOfRange::Indefinite64 => "modulo 2^64 up to 2^64; -2^63 beyond, and for NaN".to_owned(),
        OutOfRange::Indefinite32 => "the low bits of -2^31, for NaN and the infinities too".to_owned(),
    }
}

fn modulo(_: &ConversionChoices, signature: &Signature) -> String {
    format!("modulo 2^{}", signature.result.bits())
}

fn reading(choices: &ConversionChoices, _: &Signature) -> String {
    match choices.text_reading {
        TextReading::WholeText => "the whole text, blanks around it aside, must be a number; otherwise 0",
        TextReading::WholeTextInRange => {
            "the whole text, blanks around it aside, must be a number that the type holds; otherwise 0"
        }
        TextReading::LeadingDigits => {
            "the decimal digits at the beginning, behind blanks, tabs and a sign; 0 where there are none"
        }
        TextReading::WholeLiteral => {
            "the whole text, white space around it aside, must be a literal; otherwise 0"
        }
        TextReading::LooseDigits => {
            "the whole text, underscores and blanks aside, must be a number; otherwise 0"
        }
        TextReading::LeadingFixedPoint => {
            "the decimal number at the beginning, without an exponent; otherwise 0"
        }
        TextReading::LeadingNumber => "the longest beginning that is a number; 0 where there is none",
    }
    .to_owned()
}

fn digits(choices: &ConversionChoices, _: &Signature) -> String {
    match choices.real_text {
        RealText::Shortest => "the fewest that read back to the same bits".to_owned(),
        RealText::ByWidth => "about seven significant ones of a REAL, fifteen of an LREAL".to_owned(),
        RealText::SignificantDigits(number) => format!("up to {number} significant ones"),
    }
}

fn spelling(choices: &ConversionChoices, _: &Signature) -> String {
    match choices.bit_string_text {
        BitStringText::FullWidth => "all digits in upper case, as in 16#00FF",
        BitStringText::Shortest => "no zeros in front, in lower case, as in 16#ff",
        BitStringText::Decimal => "the number in decimal digits, as in 255",
    }
    .to_owned()
}

fn copy(choices: &ConversionChoices, signature: &Signature) -> String {
    match choices.bits_as_real {
        BitsAsReal::Number => match signature.result.is_real() {
            true => "the number that the bits spell",
            false => "the bits of the rounded number",
        },
        BitsAsReal::Copy => "a copy of the bits",
    }
    .to_owned()
}

fn truth(choices: &ConversionChoices, _: &Signature) -> String {
    match choices.bit_string_as_bool {
        BitStringAsBool::AnyBit => "where any bit is set",
        BitStringAsBool::LowestBit => "where the lowest bit is set",
    }
    .to_owned()
}

fn unit(choices: &ConversionChoices, signature: &Signature) -> String {
    let types = [signature.operands[0], signature.result];
    let moment = types.into_iter().find(|ty| ty.is_moment());
    match moment.map(ElementaryType::family) {
        _ if choices.moment_units == MomentUnits::Counts => {
            "the type's own: milliseconds, seconds of a DATE and a DT, nanoseconds of the long types"
        }
        Some(Family::TimeOfDay) => "the number counts milliseconds since midnight",
        Some(family @ (Family::Date | Family::DateAndTime)) => match (choices.moment_units, family) {
            (MomentUnits::Seconds | MomentUnits::Counts | MomentUnits::ShortTime, _) => {
                "the number counts seconds since 1970-01-01"
            }
            (MomentUnits::DaysAndMilliseconds, Family::Date) => "the number counts days since 1970-01-01",
            (MomentUnits::DaysSince1990, Family::Date) => "the number counts days since 1990-01-01",
            (MomentUnits::DaysAndMilliseconds | MomentUnits::DaysSince1990, _) => {
                "the number counts milliseconds since 1970-01-01"
            }
        },
        _ => "the number counts milliseconds",
    }
    .to_owned()
}

fn outside_of_moments(choices: &ConversionChoices, signature: &Signature) -> String {
    let is_short = choices.moment_units == MomentUnits::ShortTime
        && signature.result == ElementaryType::Time
        && !signature.operands[0].is_real();
    if choices.moment_units == MomentUnits::Counts || is_short {
        let bits = if signature.result.is_third_edition() {
            64
        } else {
            32
        };
        return format!("modulo 2^{bits} units");
    }
    let wrapped = match signature.result.family() {
        Family::TimeOfDay => "modulo a day",
        Family::Date => "modulo 2^64 nanoseconds, of which the day is kept",
        _ => "modulo 2^64 nanoseconds",
    };
    match signature.operands[0].is_real() {
        true => format!("{wrapped}; NaN and the infinities give 0"),
        false => wrapped.to_owned(),
    }
}
