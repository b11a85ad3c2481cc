//! Reads operands that are given as texts on the command line.

use super::inputs;
use stickler_exact::Signature;
use stickler_types::{ElementaryType, Family, LiteralError, Value, shortened};

/// The maximum number of characters that are shown of a value.
pub(super) const MAX_VALUE_LEN: usize = 40;

/// The operands of one call.
pub type CallOperands = Vec<Value>;

/// The error for given values that are no operands of a function.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum ValueError {
    /// The last call has too few values.
    #[error("{function} takes {count} values a call ({types}), so they come in pairs")]
    Count {
        /// The function.
        function: String,
        /// The number of operands that the function takes.
        count: usize,
        /// The list of the types of the function's operands.
        types: String,
    },
    /// No signature takes one of the values; holds the message that names the value and the reason.
    #[error("{0}")]
    Misfit(String),
}

/// Returns the calls to show for each signature: with the given values that it takes, or with its boundary values where none
/// is given. Leaves out signatures that take none of the given values.
///
/// # Errors
/// A value that no signature takes, or too few values for the last call.
pub fn calls(
    texts: &[String],
    signatures: Vec<Signature>,
) -> Result<Vec<(Signature, Vec<CallOperands>)>, ValueError> {
    if texts.is_empty() {
        let with_inputs = |signature: Signature| {
            let inputs = inputs::boundaries(&signature);
            (signature, inputs)
        };
        return Ok(signatures.into_iter().map(with_inputs).collect());
    }
    let count = signatures.first().map_or(1, |signature| signature.operands.len());
    if !texts.len().is_multiple_of(count) {
        let function = signatures
            .first()
            .map_or("", |signature| signature.function.as_str());
        let types = signatures.first().map_or(String::new(), inputs::types);
        return Err(ValueError::Count {
            function: function.to_owned(),
            count,
            types,
        });
    }
    let mut rows: Vec<(Signature, Vec<CallOperands>)> = signatures
        .into_iter()
        .map(|signature| (signature, Vec::new()))
        .collect();
    let bare_text = rows.iter().all(|(signature, _)| {
        let family = signature.operands[0].family();
        matches!(family, Family::Text | Family::Character)
    });
    for call in texts.chunks(count) {
        let mut taken = false;
        for (signature, operands) in &mut rows {
            if let Ok(values) = read_all(call, signature, bare_text) {
                // A value that was given twice has one answer.
                if !operands.contains(&values) {
                    operands.push(values);
                }
                taken = true;
            }
        }
        if !taken {
            return Err(ValueError::Misfit(misfit(call, &rows, bare_text)));
        }
    }
    rows.retain(|(_, operands)| !operands.is_empty());
    Ok(rows)
}

fn read_all(call: &[String], signature: &Signature, bare_text: bool) -> Result<CallOperands, String> {
    call.iter()
        .zip(&signature.operands)
        .map(|(text, ty)| read(text, *ty, bare_text))
        .collect()
}

fn misfit(call: &[String], rows: &[(Signature, Vec<CallOperands>)], bare_text: bool) -> String {
    let texts = call.join(" ");
    match rows {
        [(signature, _)] => {
            let wrong = call.iter().zip(&signature.operands);
            let wrong = wrong.filter_map(|(text, ty)| {
                let reason = read(text, *ty, bare_text).err()?;
                Some(format!(
                    "`{}` is no value of type {ty}: {reason}",
                    shortened(text, MAX_VALUE_LEN)
                ))
            });
            wrong.collect::<Vec<_>>().join("; ")
        }
        _ => {
            let mut types: Vec<String> = rows
                .iter()
                .map(|(signature, _)| inputs::types(signature))
                .collect();
            types.dedup();
            let name = rows
                .first()
                .map_or("", |(signature, _)| signature.function.as_str());
            format!(
                "`{}` is no value of a type that {name} takes: {}",
                shortened(&texts, MAX_VALUE_LEN),
                types.join(", ")
            )
        }
    }
}

/// Parses a value of a type from a typed or untyped literal. A real may be written without its point, and a text without its
/// quotes where `bare_text` says so. The error is a fragment.
fn read(text: &str, ty: ElementaryType, bare_text: bool) -> Result<Value, String> {
    let typed = text
        .split_once('#')
        .and_then(|(prefix, rest)| Some((ElementaryType::from_literal_prefix(prefix)?, rest)));
    let rest = match typed {
        Some((named, rest)) if named == ty => rest,
        Some((named, _)) => return Err(format!("it is one of type {named}")),
        None => text,
    };
    let literal = match ty.family() {
        Family::Text | Family::Character if bare_text && !rest.starts_with(['\'', '"']) => quoted(rest, ty),
        Family::Real => with_point(rest),
        _ => rest.to_owned(),
    };
    let literal = format!("{ty}#{literal}");
    Value::parse(&literal)
        .map_err(|error| number_misfit(rest, ty).unwrap_or_else(|| reason(error, &literal, ty)))
}

/// Explains why a number is no value of an integer type; `None` where the text is no number in decimal digits.
fn number_misfit(text: &str, ty: ElementaryType) -> Option<String> {
    let (least, greatest) = ty.integer_range()?;
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    let plain = |digits: &str| !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    match digits.split_once('.') {
        None if plain(digits) => Some(format!("its values go from {least} to {greatest}")),
        Some((whole, fraction)) if plain(whole) && plain(fraction) => {
            Some("it is no whole number".to_owned())
        }
        _ => None,
    }
}

/// Explains why a text is no literal of a type, without the byte offset that the error has.
fn reason(error: LiteralError, literal: &str, ty: ElementaryType) -> String {
    let place = match literal.get(error.offset()..) {
        None | Some("") => "at its end".to_owned(),
        Some(rest) => format!("at `{}`", shortened(rest, MAX_VALUE_LEN)),
    };
    match (error, ty.integer_range()) {
        (LiteralError::Malformed { expected, .. }, _) => format!("expected {expected} {place}"),
        (LiteralError::Overflow { .. }, Some((least, greatest))) => {
            format!("its values go from {least} to {greatest}")
        }
        (LiteralError::Overflow { range, .. }, None) => format!("it is outside the range of {range}"),
        (LiteralError::Escape { .. }, _) => format!("unknown escape {place}"),
        (LiteralError::Character { .. }, _) => format!("a character that does not fit a single byte {place}"),
    }
}

/// Encloses a text in the quotes of its type.
fn quoted(text: &str, ty: ElementaryType) -> String {
    let wide = matches!(ty, ElementaryType::Wstring | ElementaryType::Wchar);
    let quote = if wide { '"' } else { '\'' };
    let escaped = text.replace('$', "$$").replace(quote, &format!("${quote}"));
    format!("{quote}{escaped}{quote}")
}

/// Rewrites a real literal in the form of the standard: `1E10` becomes `1.0E10`, and `5` becomes `5.0`.
fn with_point(text: &str) -> String {
    let digits = text.trim_start_matches(['+', '-']);
    if !digits.starts_with(|first: char| first.is_ascii_digit()) || text.contains('.') {
        return text.to_owned();
    }
    match text.find(['E', 'e']) {
        Some(at) => format!("{}.0{}", &text[..at], &text[at..]),
        None => format!("{text}.0"),
    }
}

#[cfg(test)]
mod tests {
    use super::{calls, read};
    use stickler_types::{DialectName, ElementaryType, Value};

    fn reads(text: &str, ty: ElementaryType, literal: &str) {
        assert_eq!(
            read(text, ty, true).unwrap(),
            Value::parse(literal).unwrap(),
            "{text}"
        );
    }

    #[test]
    fn a_value_may_be_written_as_people_write_it() {
        reads("1E10", ElementaryType::Real, "REAL#1.0E10");
        reads("-5", ElementaryType::Lreal, "LREAL#-5.0");
        reads("-Infinity", ElementaryType::Real, "REAL#-Infinity");
        reads("REAL#2.5", ElementaryType::Real, "REAL#2.5");
        reads("16#FF", ElementaryType::Int, "INT#255");
        reads("T#5ms", ElementaryType::Time, "TIME#5ms");
        reads("2024-02-29", ElementaryType::Date, "DATE#2024-02-29");
        reads("it's $5", ElementaryType::String, "STRING#'it$'s $$5'");
        reads("a", ElementaryType::Char, "CHAR#'a'");
        reads("a", ElementaryType::Wchar, "WCHAR#\"a\"");
        reads("'it$'s'", ElementaryType::String, "STRING#'it$'s'");
    }

    #[test]
    fn a_value_that_does_not_fit_is_told_with_the_reason() {
        let wrong = |text, ty| read(text, ty, true).unwrap_err();
        assert_eq!(
            wrong("128", ElementaryType::Sint),
            "its values go from -128 to 127"
        );
        assert_eq!(wrong("-1", ElementaryType::Word), "its values go from 0 to 65535");
        assert_eq!(wrong("1.5", ElementaryType::Dint), "it is no whole number");
        assert_eq!(wrong("REAL#2.5", ElementaryType::Sint), "it is one of type REAL");
        let long = "x".repeat(70_000);
        assert!(wrong(&long, ElementaryType::Dint).len() < 100);
        assert_eq!(wrong("1e5", ElementaryType::Dint), "expected a digit at `e5`");
        assert_eq!(wrong("", ElementaryType::Dint), "expected a digit at its end");
        assert_eq!(
            wrong("1E39", ElementaryType::Real),
            "it is outside the range of REAL"
        );
    }

    #[test]
    fn a_value_that_is_given_twice_is_asked_for_once() {
        let signatures = stickler_exact::signatures("INT_TO_DINT", DialectName::MATIEC);
        let texts = ["5", "7", "INT#5"].map(str::to_owned);
        let rows = calls(&texts, signatures).unwrap();
        let value = |literal| vec![Value::parse(literal).unwrap()];
        assert_eq!(rows[0].1, [value("INT#5"), value("INT#7")]);
    }

    #[test]
    fn a_typed_value_chooses_among_the_signatures_of_an_overloaded_name() {
        let signatures = stickler_exact::signatures("TO_INT", DialectName::IRONPLC_ED3);
        let chosen = calls(&["REAL#2.5".to_owned()], signatures.clone()).unwrap();
        assert_eq!(chosen.len(), 1);
        assert_eq!(chosen[0].0.operands, [ElementaryType::Real]);
        let error = calls(&["2.5.5".to_owned()], signatures).unwrap_err().to_string();
        assert!(error.contains("`2.5.5`") && error.contains("REAL"), "{error}");
    }

    #[test]
    fn values_of_a_call_with_two_come_in_pairs() {
        let signatures = || stickler_exact::signatures("CONCAT_DATE_TOD", DialectName::MATIEC);
        let texts = ["2024-02-29".to_owned(), "12:00:00".to_owned()];
        assert_eq!(calls(&texts, signatures()).unwrap()[0].1.len(), 1);
        let error = calls(&texts[..1], signatures()).unwrap_err().to_string();
        assert!(error.contains("2 values a call (DATE, TOD)"), "{error}");
    }
}
