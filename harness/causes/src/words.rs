//! The words of a program of any dialect, also of one that nobody can read, and the types that they name.

use std::collections::{BTreeSet, HashMap};
use std::sync::LazyLock;
use stickler_syntax::token::{Token, TokenKind};
use stickler_types::dialect::PartialAccess;
use stickler_types::{Dialect, DialectName, ElementaryType, Family};

/// Rules by which a program of any dialect is read. Comments do not nest, so that the ends of those that stand in others are left, by
/// which they are seen.
pub(crate) static ANY: LazyLock<Dialect> = LazyLock::new(|| Dialect {
    nested_comments: false,
    bit_access: true,
    partial_access: PartialAccess::UpToLongWords,
    ampersand_and_power: true,
    ..Dialect::of(DialectName::IRONPLC_ED3).clone()
});

/// The words that begin a loop.
pub(crate) const LOOPS: [&str; 3] = ["FOR", "WHILE", "REPEAT"];

/// Returns the words and signs of a text, also of one that nobody can read.
pub(crate) fn tokens(text: &str) -> Vec<Token> {
    stickler_syntax::tokens(text, &ANY).list
}

/// Returns the texts of the words and signs of a text.
pub(crate) fn words(text: &str) -> Vec<&str> {
    let all = tokens(text).into_iter();
    all.map(|token| token.span.text(text)).collect()
}

/// Returns whether a text has a word, in any case of letters.
pub(crate) fn has_word(text: &str, word: &str) -> bool {
    words(text).iter().any(|one| one.eq_ignore_ascii_case(word))
}

/// Returns the elementary type with a name, in any case of letters.
pub(crate) fn elementary(name: &str) -> Option<ElementaryType> {
    ElementaryType::from_name(&name.to_ascii_uppercase())
}

/// Returns the type that a word names, or a literal by its prefix.
pub(crate) fn type_of_word(word: &str) -> Option<ElementaryType> {
    match word.split_once('#') {
        Some((prefix, _)) => ElementaryType::from_literal_prefix(&prefix.to_ascii_uppercase()),
        None => elementary(word),
    }
}

/// Returns the words of a program without the declarations of variables that it does not use.
pub(crate) fn words_in_use(text: &str) -> Vec<&str> {
    let words = words(text);
    let mut numbers: HashMap<String, usize> = HashMap::new();
    for word in &words {
        *numbers.entry(word.to_ascii_uppercase()).or_default() += 1;
    }
    let mut is_left_out = false;
    let mut is_in_use = |(at, word): (usize, &&str)| {
        let is_name = word.starts_with(|first: char| first.is_ascii_alphabetic() || first == '_');
        let is_declared = is_name && words.get(at + 1) == Some(&":");
        is_left_out |= is_declared && numbers[&word.to_ascii_uppercase()] == 1;
        let is_in_use = !is_left_out;
        is_left_out &= *word != ";";
        is_in_use
    };
    let numbered = words.iter().enumerate();
    numbered
        .filter(|one| is_in_use(*one))
        .map(|(_, word)| *word)
        .collect()
}

/// Returns the types that a program names and between which values are converted. What a TASK has is no value of the program.
pub(crate) fn valued_types(text: &str) -> BTreeSet<ElementaryType> {
    let mut is_task = false;
    let mut words = words(text);
    words.retain(|word| {
        is_task = (is_task || word.eq_ignore_ascii_case("TASK")) && *word != ";";
        !is_task
    });
    valued_types_among(words)
}

/// Returns the types that words name and between which values are converted.
pub(crate) fn valued_types_among(words: Vec<&str>) -> BTreeSet<ElementaryType> {
    let types = words.into_iter().filter_map(type_of_word);
    types.filter(|ty| kind(*ty).is_some()).collect()
}

/// Returns the kind of values between which conversions are one piece of work in a compiler; `None` for BOOL, which is the type of
/// comparisons too.
pub(crate) const fn kind(ty: ElementaryType) -> Option<&'static str> {
    Some(match ty.family() {
        Family::Boolean => return None,
        Family::Signed | Family::Unsigned | Family::BitString => "integer",
        Family::Real => "real",
        Family::Duration => "duration",
        Family::Date | Family::TimeOfDay | Family::DateAndTime => "date or time",
        Family::Text | Family::Character => "text",
    })
}

/// Returns whether a type is one of numbers, whose operands are converted to the type of the other operand or of the target.
pub(crate) const fn is_number(ty: ElementaryType) -> bool {
    ty.is_integer() || ty.is_bit_string() || ty.is_real()
}

/// Returns the types between which a function converts by its name.
pub(crate) fn converted(name: &str) -> Option<(ElementaryType, ElementaryType)> {
    let upper = name.to_ascii_uppercase();
    let (from, into) = upper.split_once("_TO_")?;
    Some((elementary(from)?, elementary(into)?))
}

/// Returns whether a token begins a section of variables or of types.
pub(crate) const fn opens_declarations(kind: TokenKind) -> bool {
    kind.opens_section() || matches!(kind, TokenKind::Type)
}
