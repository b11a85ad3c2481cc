//! The questions that a recording answers, each with the program that asks it.

use super::{RecordedSection, WordKey};
use crate::literals::{literal, untyped_literal};
use crate::overview;
use crate::program::{self, ConversionProgram};
use std::slice;
use stickler_exact::Signature;
use stickler_types::{ConversionCall, DialectName, ElementaryType, Family, Question, TypePair, Value};

/// Returns the questions that a recording answers in a dialect: pairs of types, then parts, then comparisons, then calls.
pub fn all_questions(dialect: DialectName) -> Vec<Question> {
    let calls = signatures(dialect).into_iter().flat_map(|signature| {
        let calls = overview::boundary_calls(&signature);
        let Signature { function, result, .. } = signature;
        let call = move |operands| ConversionCall {
            function: function.clone(),
            operands,
            result,
        };
        calls.into_iter().map(call).map(Question::Call)
    });
    let words = RecordedSection::ALL.into_iter().flat_map(questions_of);
    words.chain(calls).collect()
}

/// Returns the questions of a section, which are the same in every dialect; none of the functions.
pub(super) fn questions_of(section: RecordedSection) -> Vec<Question> {
    let of_pairs = |pairs: Vec<TypePair>, question| pairs.into_iter().map(question).collect();
    match section {
        RecordedSection::Implicit => of_pairs(pairs(&ElementaryType::ALL), Question::Implicit as fn(_) -> _),
        RecordedSection::Bits => parts()
            .into_iter()
            .map(|(ty, part)| Question::Part(ty, part))
            .collect(),
        RecordedSection::Comparisons => of_pairs(pairs_compared(), Question::Comparison),
        RecordedSection::Functions => Vec::new(),
    }
}

/// Returns where a recording has the word of the answer to a question; `None` where the answer is a value.
pub(super) fn word_key(question: &Question) -> Option<WordKey> {
    let of_pair = |section, (row, column): TypePair| (section, row, column.name().to_owned());
    match question {
        Question::Implicit(pair) => Some(of_pair(RecordedSection::Implicit, *pair)),
        Question::Part(ty, part) => Some((RecordedSection::Bits, *ty, part.clone())),
        Question::Comparison(pair) => Some(of_pair(RecordedSection::Comparisons, *pair)),
        Question::Call(_) => None,
    }
}

/// Returns the program that asks a question; of a comparison, one of [`extreme`] values. Where only its acceptance counts, it observes no
/// variable.
pub fn program_of(question: &Question) -> ConversionProgram {
    match question {
        Question::Implicit((from, into)) => taken(*from, *into, ""),
        Question::Part(ty, part) => taken(*ty, type_of_part(part), &format!(".{part}")),
        Question::Comparison(pair) => comparisons(&[*pair]),
        Question::Call(ConversionCall {
            function,
            operands,
            result,
        }) => program::listed(function, *result, slice::from_ref(operands), untyped_literal),
    }
}

/// Returns every ordered pair of types: each type with each type, row by row.
pub fn pairs(types: &[ElementaryType]) -> Vec<TypePair> {
    let of_row = |row| types.iter().map(move |column| (row, *column));
    types.iter().copied().flat_map(of_row).collect()
}

/// Returns the signatures of all conversion functions of a dialect.
pub(super) fn signatures(dialect: DialectName) -> Vec<Signature> {
    let functions = stickler_exact::functions(dialect);
    let of_function = |function: &String| stickler_exact::signatures(function, dialect);
    functions.iter().flat_map(of_function).collect()
}

/// Returns the bits and parts that are asked for: of a type with bits the first one, the last one and the one behind it, in each form;
/// of all others the first bit.
fn parts() -> Vec<(ElementaryType, String)> {
    let mut parts = Vec::new();
    for ty in ElementaryType::ALL {
        for (prefix, width) in [("", 1), ("%X", 1), ("%B", 8), ("%W", 16), ("%D", 32), ("%L", 64)] {
            let count = ty.bits() / width;
            let mut indices = match (ty.is_whole() && ty.bits() > 1, width) {
                (true, _) => vec![0, count.saturating_sub(1), count],
                (false, 1) => vec![0],
                (false, _) => Vec::new(),
            };
            indices.dedup();
            parts.extend(indices.into_iter().map(|index| (ty, format!("{prefix}{index}"))));
        }
    }
    parts
}

/// Returns the type of a bit or a part of a variable.
fn type_of_part(part: &str) -> ElementaryType {
    match part.get(..2) {
        Some("%B") => ElementaryType::Byte,
        Some("%W") => ElementaryType::Word,
        Some("%D") => ElementaryType::Dword,
        Some("%L") => ElementaryType::Lword,
        _ => ElementaryType::Bool,
    }
}

/// Returns the program that assigns a variable, or with an `access` a part of it, to another.
fn taken(given: ElementaryType, into: ElementaryType, access: &str) -> ConversionProgram {
    // No name of the program is a keyword of any edition, as `from` is in sequential function charts.
    ConversionProgram {
        declarations: format!("    given : {given};\n    taken : {into};\n"),
        statements: format!("    taken := given{access};\n"),
        observed: Vec::new(),
        ty: into,
    }
}

/// Returns the pairs of types that are compared: of truth values, numbers and bit strings.
pub(super) fn pairs_compared() -> Vec<TypePair> {
    let is_compared = |ty: &ElementaryType| {
        use Family::{BitString, Boolean, Real, Signed, Unsigned};
        matches!(ty.family(), Boolean | Signed | Unsigned | Real | BitString)
    };
    let types: Vec<ElementaryType> = ElementaryType::ALL.into_iter().filter(is_compared).collect();
    pairs(&types)
}

/// Returns the value of a type that is compared with others: -1 of a type with a sign, otherwise the greatest one, so that types of
/// the same width have the same bits.
pub fn extreme(ty: ElementaryType) -> Value {
    match ty.family() {
        Family::Real => Value::of_real(ty, -1.0),
        Family::Signed => Value::plain(ty, u64::MAX),
        _ if ty.bits() >= 64 => Value::plain(ty, u64::MAX),
        _ => Value::plain(ty, (1 << ty.bits()) - 1),
    }
}

/// Returns the program that compares the [`extreme`] values of pairs of types; each variable that it observes says whether the first is
/// less.
pub(super) fn comparisons(pairs: &[TypePair]) -> ConversionProgram {
    let (mut declarations, mut statements) = (String::new(), String::new());
    let mut observed = Vec::with_capacity(pairs.len());
    let initial = |ty: ElementaryType| match ty.family() {
        Family::Signed | Family::Real => untyped_literal(&extreme(ty)),
        _ => literal(&extreme(ty)),
    };
    for (number, (left, right)) in (1..).zip(pairs) {
        let name = format!("less{number}");
        declarations.push_str(&format!(
            "    left{number} : {left} := {};\n    right{number} : {right} := {};\n    {name} : BOOL;\n",
            initial(*left),
            initial(*right)
        ));
        statements.push_str(&format!("    {name} := left{number} < right{number};\n"));
        observed.push(name);
    }
    ConversionProgram {
        declarations,
        statements,
        observed,
        ty: ElementaryType::Bool,
    }
}

/// Returns whether a comparison is true.
pub(super) fn is_true(compared: &Value) -> bool {
    *compared == Value::plain(ElementaryType::Bool, 1)
}
