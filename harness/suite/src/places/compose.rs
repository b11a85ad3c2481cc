//! Puts a program together of a source, a target and a surrounding.

use std::borrow::Cow;

use super::{Arrangement, PlaceKey, Places, ProgramPlace};

/// The words of a table that stand for those of `places.toml`; they may hold placeholders of the table.
#[derive(Clone, Debug)]
pub(crate) struct Wording<'a> {
    pub(crate) from: &'a str,
    pub(crate) to: &'a str,
    pub(crate) value: &'a str,
    pub(crate) typed: &'a str,
    /// The value that the target takes, as an untyped literal.
    pub(crate) arriving: &'a str,
    /// A smaller value and a greater one of the target's type, as untyped literals.
    pub(crate) beside: [&'a str; 2],
    /// The expression that stands for `{source}`, itself with `{source}`.
    pub(crate) expression: &'a str,
    /// The variable that stands for `{target}`, itself with `{target}`.
    pub(crate) variable: &'a str,
    /// Declarations in front of those of the places.
    pub(crate) declarations: &'a str,
    /// Statements before the one that is tested.
    pub(crate) before: &'a str,
    /// The condition of the mark that claims a rejection; `None` for no mark.
    pub(crate) error: Option<&'a str>,
    /// The code of the rejection, where it is not the one of the place.
    pub(crate) code: Option<&'a str>,
}

/// A program that is put together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Composed {
    pub(crate) source: String,
    /// The path at which the value arrives.
    pub(crate) observe: String,
}

/// Puts the program of an arrangement together.
pub(crate) fn compose(places: &Places, arrangement: &Arrangement, wording: &Wording<'_>) -> Composed {
    let source = &places.sources[arrangement.source].key;
    let target = &seen_by(wording, &places.targets[arrangement.target]);
    let surrounding = &places.surroundings[arrangement.surrounding].key;
    let unit = &places.units[arrangement.unit];
    let value = fill(wording.expression, &[("source", &source.value)]);
    let variable = fill(wording.variable, &[("target", &target.target)]);
    let observe = fill(&unit.observe, &[("observe", &target.observe)]);
    let error = mark(source, target, wording);
    let joined = |part: fn(&PlaceKey) -> &str, between: &str, default: &str| {
        let texts = [source, target, surrounding].map(|place| part(place).trim());
        let filled: Vec<&str> = texts.into_iter().filter(|text| !text.is_empty()).collect();
        match filled.is_empty() {
            true => default.trim().to_owned(),
            false => filled.join(between),
        }
    };
    let statement = fill(&surrounding.statement, &[("statement", &target.statement)]);
    let own = fill(wording.before, &[("target", &target.target)]);
    let before = [joined(|place| &place.before, "\n", ""), own].join("\n");
    let declarations = [
        wording.declarations.to_owned(),
        joined(|place| &place.declarations, "\n\n", ""),
    ]
    .join("\n\n");
    let globals = joined(|place| &place.globals, "\n", "");
    let configuration = match globals.is_empty() {
        true => String::new(),
        false => fill(&places.configuration, &[("globals", &globals)]),
    };
    let text = fill(
        &unit.text,
        &[
            ("declarations", &declarations),
            (
                "parameters",
                &joined(|place| &place.parameters, "\n", &unit.parameters),
            ),
            ("variables", &joined(|place| &place.variables, "\n", "")),
            ("sections", &joined(|place| &place.sections, "\n", "")),
            ("before", &before),
            ("statement", &statement),
            ("after", &joined(|place| &place.after, "\n", "")),
            ("caller", &joined(|place| &place.caller, "\n", "")),
            (
                "arguments",
                &joined(|place| &place.arguments, ", ", &unit.arguments),
            ),
            ("configuration", &configuration),
        ],
    );
    let text = fill(
        &text,
        &[
            ("source", &value),
            ("target", &variable),
            ("observe", &target.observe),
            ("error", &error),
        ],
    );
    let words = [
        ("from", wording.from),
        ("to", wording.to),
        ("value", wording.value),
        ("typed", wording.typed),
        ("arriving", wording.arriving),
        ("below", wording.beside[0]),
        ("above", wording.beside[1]),
    ];
    let source = tidied(&fill(&text, &words));
    Composed { source, observe }
}

/// Returns a target as the probe sees it: what an expression computes is of the target's type already, and a code of the probe's own
/// belongs to the line on which the value is written.
fn seen_by<'p>(wording: &Wording<'_>, target: &'p ProgramPlace) -> Cow<'p, PlaceKey> {
    let computed = wording.expression != "{source}" && target.is_behind_a_parameter;
    let elsewhere = wording.code.is_some() && !target.is_in_its_statement;
    if !computed && !elsewhere {
        return Cow::Borrowed(&target.key);
    }
    let mut target = target.key.clone();
    if computed {
        target.declarations = target.declarations.replace("{from}", "{to}");
    }
    if elsewhere {
        target.declarations = target.declarations.replace("{error}", "");
        target.statement.push_str("  {error}");
    }
    Cow::Owned(target)
}

/// Returns the mark that claims the rejection, or nothing.
fn mark(source: &PlaceKey, target: &PlaceKey, wording: &Wording<'_>) -> String {
    let code = match wording.code {
        Some(code) => code,
        None if source.call && wording.expression == "{source}" && !target.call_code.is_empty() => {
            &target.call_code
        }
        None => &target.code,
    };
    match wording.error {
        Some(condition) => format!("(*! error {code} {condition} *)").replace("  ", " "),
        None => String::new(),
    }
}

/// Replaces words in braces. A line that has nothing but such a word becomes the lines of its text, indented as the line is; it
/// goes where the text is empty. All other braces stay.
fn fill(text: &str, words: &[(&str, &str)]) -> String {
    let mut filled = String::with_capacity(text.len() * 2);
    for line in text.trim_matches('\n').lines() {
        let bare = line.trim_start();
        let indent = &line[..line.len() - bare.len()];
        match word_at(bare, words) {
            Some((replacement, "")) => {
                for inner in replacement.trim_matches('\n').lines() {
                    filled.push_str(indent);
                    filled.push_str(inner);
                    filled.push('\n');
                }
            }
            _ => {
                fill_line(&mut filled, line, indent, words);
                filled.truncate(filled.trim_end_matches(' ').len());
                filled.push('\n');
            }
        }
    }
    filled.truncate(filled.trim_end_matches('\n').len());
    filled
}

/// Appends a line with its words replaced; the lines of a text begin where the line does.
fn fill_line(filled: &mut String, line: &str, indent: &str, words: &[(&str, &str)]) {
    let mut rest = line;
    while let Some(brace) = rest.find('{') {
        filled.push_str(&rest[..brace]);
        rest = &rest[brace..];
        match word_at(rest, words) {
            Some((replacement, behind)) => {
                for (number, inner) in replacement.trim().lines().enumerate() {
                    if number > 0 {
                        filled.push('\n');
                        filled.push_str(indent);
                    }
                    filled.push_str(inner);
                }
                rest = behind;
            }
            None => {
                filled.push('{');
                rest = &rest[1..];
            }
        }
    }
    filled.push_str(rest);
}

/// Returns what stands for the word in braces with which a text begins, and the text behind the word.
fn word_at<'t>(text: &'t str, words: &[(&str, &'t str)]) -> Option<(&'t str, &'t str)> {
    let (name, behind) = text.strip_prefix('{')?.split_once('}')?;
    let (_, replacement) = words.iter().find(|(word, _)| *word == name)?;
    Some((replacement, behind))
}

/// Drops `VAR` sections without a variable, and empty lines at the start, at the end and behind another.
fn tidied(text: &str) -> String {
    let mut kept: Vec<&str> = Vec::new();
    for line in text.trim().lines() {
        match kept.last() {
            Some(&"VAR") if line == "END_VAR" => drop(kept.pop()),
            Some(&"") if line.is_empty() => {}
            _ => kept.push(line),
        }
    }
    kept.push("");
    kept.join("\n")
}
