//! Parses one number in the forms of editors and spreadsheets of all countries.

/// The content of a cell that is a number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Number {
    /// A `DINT`.
    Whole(i32),
    /// A number outside the range of `DINT`, or a rounded one.
    Other,
}

/// Parses a number in any of its forms; `None` where the text is no number.
///
/// `-5`, `+5`, `DINT#5`, `16#FF`, `2#1010_1010`, `0xFF`, `TRUE`; groups of three digits with blanks, points, commas or
/// apostrophes between them; a fraction of nothing but zeros behind a point or a comma. What has a base is taken for 32
/// bits: `16#FFFFFFFF` is -1.
pub(super) fn number(text: &str) -> Option<Number> {
    let text = text.trim_matches(|c: char| is_blank(c) || matches!(c, '"' | '\''));
    if text.eq_ignore_ascii_case("TRUE") {
        return Some(Number::Whole(1));
    }
    if text.eq_ignore_ascii_case("FALSE") {
        return Some(Number::Whole(0));
    }
    let text = without_type(text);
    if let Some((base, digits)) = based(text) {
        return in_base(base, digits);
    }
    let (negative, digits) = match text.strip_prefix(['-', '\u{2212}']) {
        Some(digits) => (true, digits),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let digits = digits.trim_start_matches(is_blank);
    if !digits.starts_with(|c: char| c.is_ascii_digit()) {
        return None;
    }
    let whole = grouped(digits).or_else(|| {
        let (whole, fraction) = digits.rsplit_once(['.', ','])?;
        let nothing = !fraction.is_empty() && fraction.bytes().all(|byte| byte == b'0');
        if nothing { grouped(whole) } else { None }
    });
    let Some(whole) = whole else {
        let numeric = digits
            .chars()
            .all(|c| c.is_ascii_digit() || is_separator(c) || matches!(c, 'e' | 'E' | '+' | '-'));
        // A date or a time of day has its signs elsewhere.
        let is_rounded = numeric && digits.matches('-').count() < 2;
        return is_rounded.then_some(Number::Other);
    };
    let value = whole
        .parse::<i64>()
        .ok()
        .map(|value| if negative { -value } else { value });
    Some(
        value
            .and_then(|value| i32::try_from(value).ok())
            .map_or(Number::Other, Number::Whole),
    )
}

/// Returns whether a character is a blank, of which editors write several kinds.
pub(super) fn is_blank(character: char) -> bool {
    character.is_whitespace() || matches!(character, '\u{feff}' | '\u{200b}')
}

fn is_separator(character: char) -> bool {
    is_blank(character) || matches!(character, '.' | ',' | '\'' | '\u{2019}' | '_')
}

/// Returns the digits of a number without separators; `None` where they are grouped otherwise than by threes.
fn grouped(text: &str) -> Option<String> {
    if text.bytes().all(|byte| byte.is_ascii_digit()) {
        return (!text.is_empty()).then(|| text.to_owned());
    }
    let separator = text.chars().find(|c| !c.is_ascii_digit())?;
    if !is_separator(separator) || separator == '\t' {
        return None;
    }
    let mut groups = text.split(separator);
    let first = groups.next()?;
    let digits = |group: &str| group.bytes().all(|byte| byte.is_ascii_digit());
    let whole = (1..=3).contains(&first.len()) && digits(first);
    let rest: Vec<&str> = groups.collect();
    let whole = whole && rest.iter().all(|group| group.len() == 3 && digits(group));
    whole.then(|| format!("{first}{}", rest.concat()))
}

/// Removes the name of the type from a typed literal such as `DINT#5`.
fn without_type(text: &str) -> &str {
    match text.split_once('#') {
        Some((name, rest)) if !name.is_empty() && name.bytes().all(|byte| byte.is_ascii_alphabetic()) => rest,
        _ => text,
    }
}

fn based(text: &str) -> Option<(u32, &str)> {
    let bases = [("16#", 16), ("2#", 2), ("8#", 8), ("0x", 16), ("0X", 16)];
    let mut bases = bases.into_iter();
    bases.find_map(|(prefix, base)| Some((base, text.strip_prefix(prefix)?)))
}

fn in_base(base: u32, digits: &str) -> Option<Number> {
    let digits: String = digits.chars().filter(|c| !is_blank(*c) && *c != '_').collect();
    if digits.is_empty() || !digits.chars().all(|c| c.is_digit(base)) {
        return None;
    }
    Some(u32::from_str_radix(&digits, base).map_or(Number::Other, |bits| Number::Whole(bits.cast_signed())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_they_are_shown_anywhere() {
        let rows = include_str!("numbers.txt")
            .lines()
            .filter(|line| line.starts_with('|'));
        for row in rows {
            let (text, expected) = row[1..].rsplit_once("| ").expect("two bars");
            let found = match number(text) {
                Some(Number::Whole(value)) => value.to_string(),
                Some(Number::Other) => "other".to_owned(),
                None => "none".to_owned(),
            };
            assert_eq!(found, expected, "{text}");
        }
    }
}
