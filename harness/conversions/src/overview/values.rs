//! Reads operands that are given as texts on the command line.

use super::inputs;
use stickler_exact::Signature;
use stickler_types::{ElementaryType, Family, LiteralError, Value, join, shortened};

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
            join(wrong, "; ")
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
pub(crate) fn read(text: &str, ty: ElementaryType, bare_text: bool) -> Result<Value, String> {
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
