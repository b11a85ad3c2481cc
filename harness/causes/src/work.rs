//! The pieces of work of a compiler that a program asks for: the features that it uses, where those that one change would mend are one.

use crate::shape::escape;
use crate::words::{ANY, elementary, tokens};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;
use stickler_syntax::features::{FeatureUse, feature_uses};
use stickler_syntax::source::Span;

/// The subject of a piece of work.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Role {
    /// The operations of a program on its values.
    Operation,
    /// A form of literals that a compiler may not know.
    Literal,
    /// A kind of declaration that not every program has.
    Declaration,
    /// What matters to no cause by itself.
    Beside,
}

/// A piece of work where a program asks for it.
#[derive(Clone, Debug)]
pub(crate) struct Work {
    pub(crate) role: Role,
    pub(crate) words: String,
    pub(crate) span: Span,
}

/// The roles and words of each feature, from `work.toml`.
pub(crate) static WORKS: LazyLock<BTreeMap<String, Vec<(Role, String)>>> = LazyLock::new(|| {
    let text = include_str!("work.toml");
    let roles: BTreeMap<Role, BTreeMap<String, Vec<String>>> = toml::from_str(text).unwrap_or_default();
    let mut works: BTreeMap<String, Vec<(Role, String)>> = BTreeMap::new();
    for (role, pieces) in roles {
        for (words, features) in pieces {
            for feature in features {
                works.entry(feature).or_default().push((role, words.clone()));
            }
        }
    }
    works
});

/// Returns the pieces of work that a program asks for, in the order of its text.
pub(crate) fn works(program: &str) -> Vec<Work> {
    let uses = feature_uses(program, &ANY).into_iter();
    let uses = uses.filter(|used| elementary(&used.key).is_none() && !is_negative_literal(program, used));
    let work = |used: FeatureUse| {
        let written = used.span.text(program);
        let own = || vec![(Role::Operation, used.key.to_ascii_uppercase())];
        let found = match &*used.key {
            "conversion"
            | "conversion-overloaded"
            | "conversion-bcd"
            | "conversion-bcd-one-type"
            | "trunc-typed"
            | "concat-date-time" => {
                let name = written.split(['(', ' ']).next().unwrap_or_default();
                vec![(Role::Operation, families(name))]
            }
            // How large a base or an exponent is matters to those who read it.
            "based-literal" => vec![(Role::Literal, format!("{}#digits", base(written)))],
            "string-escape" => vec![(Role::Literal, escape(written).unwrap_or_default().to_owned())],
            "literal-exponent" => vec![(Role::Literal, exponent(written).to_owned())],
            key => WORKS.get(key).cloned().unwrap_or_else(own),
        };
        let span = Span {
            start: used.span.start + written.find(beginning(&used.key)).unwrap_or_default() as u32,
            ..used.span
        };
        found
            .into_iter()
            .map(move |(role, words)| Work { role, words, span })
    };
    uses.flat_map(work).collect()
}

/// Returns the word by which a feature begins that stands within a statement of several lines.
fn beginning(feature: &str) -> &'static str {
    match feature {
        "repeat" => "UNTIL",
        "elsif" => "ELSIF",
        _ => "",
    }
}

/// Returns the words of the pieces of work with a role.
pub(crate) fn words_of<'w>(works: impl IntoIterator<Item = &'w Work>, role: Role) -> BTreeSet<String> {
    let works = works.into_iter().filter(|work| work.role == role);
    works.map(|work| work.words.clone()).collect()
}

/// Returns the operators, functions and statements of a program; an assignment and a field are none.
pub(crate) fn operations(program: &str) -> BTreeSet<String> {
    words_of(&works(program), Role::Operation)
}

/// Returns whether a feature is the sign of a literal with a type, of which it is a part.
fn is_negative_literal(program: &str, used: &FeatureUse) -> bool {
    let parts = || tokens(used.span.text(program));
    used.key == "negation" && matches!(parts()[..], [_, literal] if literal.kind.is_literal())
}

/// Returns the base of a number, behind a type or not.
fn base(written: &str) -> &str {
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let mut parts = written.split('#');
    parts.find(|part| digits(part)).unwrap_or_default()
}

/// Returns the form of a real number with an exponent: REAL ends at 3.4E38.
pub(crate) fn exponent(written: &str) -> &'static str {
    let digits = written.to_ascii_uppercase();
    match digits
        .rsplit_once('E')
        .map(|(_, exponent)| exponent.parse::<i32>())
    {
        Some(Ok(exponent)) if exponent.abs() > 37 => "real number beyond REAL",
        _ => "real number with an exponent",
    }
}

/// Returns the name of a function with the types in it replaced by their families: `INT_TO_REAL` is `signed_TO_real`, and
/// `TRUNC_LINT` is `TRUNC_signed`.
pub(crate) fn families(name: &str) -> String {
    let upper = name.to_ascii_uppercase();
    let family = |word: &str| elementary(word).map(|ty| format!("{:?}", ty.family()).to_lowercase());
    let part = |part: &str| family(part).unwrap_or_else(|| part.to_owned());
    let side = |side: &str| {
        let parts = || side.split('_').map(part).collect::<Vec<_>>().join("_");
        family(side).unwrap_or_else(parts)
    };
    let sides: Vec<String> = upper.split("_TO_").map(side).collect();
    sides.join("_TO_")
}

/// Returns the name of a conversion between a real number and an integer without the family of the integer: how it rounds is one piece of
/// work, and numbers that one family does not have are properties of the value. The conversions of a date and time to its date and to its
/// time of day have one name.
pub(crate) fn of_numbers(operation: &str) -> String {
    let side = |side: &str| match side {
        "signed" | "unsigned" | "bitstring" => "integer".to_owned(),
        other => other.to_owned(),
    };
    match operation.split_once("_TO_") {
        Some((from, into)) if from == "real" || into == "real" => format!("{}_TO_{}", side(from), side(into)),
        Some(("dateandtime", "date" | "timeofday")) => "parts of a date and time".to_owned(),
        _ => operation.to_owned(),
    }
}

/// Returns the name of a conversion and its opposite, where an operation is one: a compiler that lacks one of them lacks the pair of
/// types, and one that lacks some of those from and to texts, of those of durations, dates and times of day, or of those between these
/// and BOOL, lacks them all.
pub(crate) fn either_way(operation: &str) -> String {
    let moments = ["duration", "date", "timeofday", "dateandtime"];
    match operation.split_once("_TO_") {
        Some((from, into)) if from == "text" || into == "text" => "conversion of texts".to_owned(),
        Some((from, into)) if from == "BCD" || into == "BCD" => "conversion of BCD".to_owned(),
        Some((from, into))
            if [from, into].contains(&"boolean") && moments.iter().any(|one| [from, into].contains(one)) =>
        {
            "conversion between BOOL and durations, dates and times".to_owned()
        }
        Some((from, into)) if moments.contains(&from) || moments.contains(&into) => {
            "conversion of durations, dates and times".to_owned()
        }
        Some((from, into)) => format!("{}_TO_{}", from.min(into), from.max(into)),
        None if operation == "TO_text" => "conversion of texts".to_owned(),
        None => operation.to_owned(),
    }
}
