//! Who promises a construct that an engine does not take: the basis of a cause whose program is plainer than what the claim of its case speaks of.

use crate::essence::Essence;
use crate::features::TYPED_LITERAL;
use crate::literals::{LONG, kind, type_of_token, valued_types};
use crate::reduction::Smallest;
use crate::tokens::{ProgramToken, ProgramTokenKind, tokens};
use stickler_engines::Identity;
use stickler_run::{Fact, Symptom, binds};
use stickler_suite::{Case, SourceKind, Sources};
use stickler_types::ElementaryType;

// Literals and the ranges of their types, as the tables of the folder `language` cite them.
const NUMBERS: &[&str] = &["iec-61131-3: Table 5"];
const TEXTS: &[&str] = &["iec-61131-3: Table 6"];
const ESCAPES: &[&str] = &["iec-61131-3: Table 7"];
const DURATIONS: &[&str] = &["iec-61131-3: Table 8"];
const MOMENTS: &[&str] = &["iec-61131-3: Table 9"];
const RANGES: &[&str] = &["iec-61131-3: Table 10"];
const REALS: &[&str] = &["iec-61131-3: 6.3.2"];
/// The grammar, which has lengths of texts, and repeated initial values of arrays.
const GRAMMAR: &[&str] = &["iec-61131-3: Annex A"];
const LONG_TYPES: &[&str] = &["strucpp-compliance: Data Types"];
const ALIASES: &[&str] = &["ironplc-problem-codes: P2012", "iec-61131-3: Table 11"];
/// IronPLC calls VAR_IN_OUT "Partial" in its list of scope keywords, which promises nothing.
const IN_OUT: &[&str] = &["iec-61131-3: 6.5.2.2"];
const COMMENTS: &[&str] = &["iec-61131-3: Table 3"];
const PRAGMAS: &[&str] = &["iec-61131-3: Table 4"];
const CONTINUE: &[&str] = &["iec-61131-3: 7.3.3.4.5"];
const LOCATIONS: &[&str] = &["ironplc-variables: io-qualifiers", "iec-61131-3: 6.5.5"];
const ENUMERATIONS: &[&str] = &["ironplc-derived-types: enumerated-types"];
const FIELDS: &[&str] = &["iec-61131-3: 6.4.4.6"];
/// Types with an initial value of their own.
const OWN_VALUES: &[&str] = &["iec-61131-3: Table 11"];
/// Initial values of arrays and of structures.
const LISTS: &[&str] = &["iec-61131-3: Table 14"];
const INITIAL_VALUES: &[&str] = &["ironplc-variables: initial-values"];
const ARRAYS: &[&str] = &["ironplc-derived-types: array-types"];
const STRUCTURES: &[&str] = &["ironplc-derived-types: structure-types"];
const BLOCKS: &[&str] = &["ironplc-pous: function-block"];
const OUTPUTS: &[&str] = &["iec-61131-3: 6.6.1.4.2"];
/// The implicit conversion of REAL to LREAL.
const REAL_WIDENING: &[&str] = &[
    "ironplc-type-conversions: Real widening",
    "iec-61131-3: 6.6.1.2.2",
];

/// Standard functions, each with who promises it, as the tables of the folder `language` cite them.
const FUNCTIONS: [(&str, &[&str]); 7] = [
    (
        "SEL",
        &["ironplc-standard-functions: sel", "iec-61131-3: Table 32"],
    ),
    (
        "MAX",
        &["ironplc-standard-functions: max", "iec-61131-3: Table 32"],
    ),
    (
        "MIN",
        &["ironplc-standard-functions: min", "iec-61131-3: Table 32"],
    ),
    (
        "LIMIT",
        &["ironplc-standard-functions: limit", "iec-61131-3: Table 32"],
    ),
    (
        "MUX",
        &["ironplc-standard-functions: mux", "iec-61131-3: Table 32"],
    ),
    (
        "LEN",
        &["ironplc-standard-functions: len", "iec-61131-3: Table 34"],
    ),
    (
        "CONCAT",
        &["ironplc-standard-functions: concat", "iec-61131-3: Table 34"],
    ),
];

/// Returns the basis by which an engine must take the program of a cause: the first source that promises its construct and binds the
/// engine. `None` where the construct is not known or nobody promises it.
pub(crate) fn promise(
    shown: &Smallest,
    essence: &Essence,
    case: &Case,
    (engine, sources): (&Identity, &Sources),
) -> Option<&'static str> {
    let promises = match &shown.deviation.sign.symptom {
        Symptom::Rejected(_) => of_rejection(shown, essence),
        Symptom::NotImplemented(_) => of_missing(essence).or_else(|| {
            let all = tokens(&shown.program);
            of_function(&all, &all)
        }),
        Symptom::Value => of_value(essence),
        _ => None,
    }?;
    let speaks = |basis: &&&str| {
        let source = sources.of(basis);
        source.is_some_and(|(source, section)| source.speaks_for(section, case.dialect))
            && binds((basis, case.dialect), engine, sources, false)
    };
    promises.iter().find(speaks).copied()
}

/// Returns who promises the construct of a valid program that is rejected.
fn of_rejection(shown: &Smallest, essence: &Essence) -> Option<&'static [&'static str]> {
    let has = |feature: &str| essence.features.contains(feature);
    if shown
        .deviation
        .expected
        .iter()
        .any(|fact| fact.diagnostic().is_some())
    {
        return None;
    }
    let all = tokens(&shown.program);
    let reported = shown
        .deviation
        .got
        .iter()
        .find_map(|fact| fact.diagnostic()?.line);
    let line: Vec<ProgramToken<'_>> = all
        .iter()
        .filter(|token| Some(token.line) == reported)
        .copied()
        .collect();
    let pair = |tokens: &[ProgramToken<'_>], is: fn(&ProgramToken<'_>, &ProgramToken<'_>) -> bool| {
        tokens.windows(2).any(|pair| is(&pair[0], &pair[1]))
    };
    let of_type = |token: &&ProgramToken<'_>| match token.kind {
        ProgramTokenKind::Word => ElementaryType::from_name(&token.text.to_ascii_uppercase()),
        _ => None,
    };
    if let Some(promises) = of_literal(essence) {
        return Some(promises);
    }
    if has(LONG) {
        return line.iter().find_map(of_typed);
    }
    if line.iter().any(|token| token.text == "{") {
        return Some(PRAGMAS);
    }
    if has(TYPED_LITERAL) {
        let typed = line.iter().find(|token| token.kind == ProgramTokenKind::Typed)?;
        let is_text = typed.text.contains(['\'', '"']);
        return Some(if is_text { TEXTS } else { NUMBERS });
    }
    if pair(&all, |word, next| {
        (word.is("STRING") || word.is("WSTRING")) && next.text == "["
    }) {
        return Some(GRAMMAR);
    }
    if pair(&line, |number, next| {
        number.kind == ProgramTokenKind::Number && next.text == "("
    }) {
        return Some(GRAMMAR);
    }
    let is_list = pair(&line, |sign, next| {
        sign.text == ":=" && matches!(next.text, "[" | "(")
    });
    if has("declaration") && is_list {
        return Some(LISTS);
    }
    if line
        .iter()
        .any(|token| token.kind == ProgramTokenKind::Number && token.text.contains('_'))
    {
        return Some(NUMBERS);
    }
    let is_long = line
        .iter()
        .find_map(|token| of_type(&token))
        .is_some_and(ElementaryType::is_third_edition);
    if has("declaration") && is_long && line.iter().all(|token| token.text != ":=") {
        return Some(LONG_TYPES);
    }
    if has("declaration") && line.iter().any(|token| token.is_located) {
        return Some(LOCATIONS);
    }
    if has("initial value by name") && has("type of one's own") {
        return Some(ENUMERATIONS);
    }
    if let [word, ..] = &line[..]
        && word.is("CONTINUE")
    {
        return Some(CONTINUE);
    }
    // Tokens have no comments, but the ends of those that stand in others.
    if pair(&line, |star, bracket| star.text == "*" && bracket.text == ")") {
        return Some(COMMENTS);
    }
    if has("type") && line.iter().any(|token| token.text == ":=") {
        return Some(OWN_VALUES);
    }
    // `NAME : INT;` alone.
    if has("type") && line.len() == 4 && line.iter().any(|token| of_type(&token).is_some()) {
        return Some(ALIASES);
    }
    let is_typed =
        |token: &ProgramToken<'_>| token.kind == ProgramTokenKind::Typed && !token.text.contains(['\'', '"']);
    let assigns_only = line.len() == 4 && line[1].text == ":=";
    if assigns_only && is_typed(&line[2]) {
        return of_typed(&line[2]).or(Some(NUMBERS));
    }
    let calls = pair(&line, |word, next| {
        word.kind == ProgramTokenKind::Word && next.text == "("
    });
    match has("VAR_IN_OUT") && !calls {
        true => Some(IN_OUT),
        false => of_function(&line, &all),
    }
}

/// Returns who promises a duration, a date or a time of day that is written with its type.
fn of_typed(token: &ProgramToken<'_>) -> Option<&'static [&'static str]> {
    let is_typed = token.kind == ProgramTokenKind::Typed;
    match type_of_token(token).filter(|_| is_typed).and_then(kind)? {
        "duration" => Some(DURATIONS),
        "date or time" => Some(MOMENTS),
        _ => None,
    }
}

/// Returns who promises the one function that is called among these tokens of a program. A function that selects one of its arguments
/// is promised where these have one type: whether it converts them is another claim.
fn of_function(called: &[ProgramToken<'_>], all: &[ProgramToken<'_>]) -> Option<&'static [&'static str]> {
    let is_call = |pair: &&[ProgramToken<'_>]| pair[0].kind == ProgramTokenKind::Word && pair[1].text == "(";
    let mut calls = called.windows(2).filter(is_call);
    let (first, None) = (calls.next()?, calls.next()) else {
        return None;
    };
    let (name, promises) = FUNCTIONS.iter().find(|(name, _)| first[0].is(name))?;
    let takes_one_type = matches!(*name, "LEN" | "CONCAT") || valued_types(all).len() < 2;
    takes_one_type.then_some(*promises)
}

/// Returns who promises the construct that is not implemented.
fn of_missing(essence: &Essence) -> Option<&'static [&'static str]> {
    let known = [
        ("VAR_IN_OUT", IN_OUT),
        ("structure", STRUCTURES),
        ("array", ARRAYS),
        ("instance of a function block", BLOCKS),
        ("output argument", OUTPUTS),
    ];
    // What is done with a bit there is another claim.
    let has_bit = essence.features.contains("bit access");
    let found = known
        .into_iter()
        .find(|(feature, _)| essence.features.contains(*feature) && !has_bit);
    found.map(|(_, promises)| promises)
}

/// Returns who promises the value of a variable that begins with it, or that is assigned a literal.
fn of_value(essence: &Essence) -> Option<&'static [&'static str]> {
    let has = |feature: &str| essence.features.contains(feature);
    if has("FUNCTION_BLOCK") && has("initial value") && essence.features.len() == 2 {
        return Some(INITIAL_VALUES);
    }
    if has("STRUCT") && has("initial value") && essence.features.len() == 2 {
        return Some(FIELDS);
    }
    if has("conversion real") && essence.features.len() == 1 {
        return Some(REAL_WIDENING);
    }
    if essence
        .features
        .iter()
        .any(|feature| feature.ends_with("-with-escape"))
    {
        return of_literal(essence);
    }
    let (kinds, others): (Vec<&str>, Vec<&str>) = essence
        .features
        .iter()
        .map(String::as_str)
        .filter(|feature| !is_literal(feature))
        .partition(|feature| {
            matches!(
                *feature,
                "integer" | "real" | "duration" | "date or time" | "text"
            )
        });
    match (&kinds[..], &others[..]) {
        (_, ["assigned value"]) if of_literal(essence).is_some() => of_literal(essence),
        (["integer"], ["assigned value"]) => Some(RANGES),
        (["real"], ["assigned value"]) => Some(REALS),
        _ => None,
    }
}

fn is_literal(feature: &str) -> bool {
    feature.ends_with('#')
        || feature.ends_with("#digits")
        || feature.contains("'text'")
        || feature.contains("\"text\"")
        || feature.starts_with("real-")
        || feature == "typed literal with a sign"
}

/// Returns who promises the form of a literal that the engine does not take alone.
fn of_literal(essence: &Essence) -> Option<&'static [&'static str]> {
    let promises = |feature: &String| match feature.as_str() {
        "typed literal with a sign" | "real-with-exponent" | "BOOL#" => Some(NUMBERS),
        "real-beyond-REAL" => Some(REALS),
        "TIME#" => Some(DURATIONS),
        "date or time#" => Some(MOMENTS),
        text if text.ends_with("-with-escape") => Some(ESCAPES),
        "\"text\"" | "STRING#" | "WSTRING#" | "CHAR#" | "WCHAR#" => Some(TEXTS),
        based if based.ends_with("#digits") => Some(NUMBERS),
        _ => None,
    };
    essence.features.iter().find_map(promises)
}

/// Writes who promises a construct into what the engine said of it, where that is a document.
pub(crate) fn cite(got: &mut [Fact], basis: &str, sources: &Sources) {
    let is_document = sources
        .of(basis)
        .is_some_and(|(source, _)| source.kind == SourceKind::Document);
    for fact in got {
        if let Fact::NotImplemented { promised_by, .. } = fact {
            *promised_by = is_document.then(|| basis.to_owned());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use std::path::Path;
    use stickler_suite::Suite;

    fn essence(features: &[&str]) -> Essence {
        Essence {
            class: String::new(),
            features: features.iter().map(|feature| (*feature).to_owned()).collect(),
            labels: BTreeSet::new(),
            is_contained: false,
            hidden: None,
        }
    }

    #[test]
    fn a_construct_that_is_rejected_is_promised_by_who_speaks_of_it() {
        let of = |declaration: &str, features: &[&str]| {
            let program = format!("PROGRAM p\nVAR\n{declaration}\nEND_VAR\nx := x;\nEND_PROGRAM\n");
            of_rejection(&Smallest::rejected(&program, 3, "P0002"), &essence(features))
        };
        assert_eq!(of("x : STRING[1];", &["declaration"]), Some(GRAMMAR));
        assert_eq!(
            of("x : ARRAY[0..0] OF INT := [1(0)];", &["declaration"]),
            Some(GRAMMAR)
        );
        assert_eq!(of("x : OWN := [INT#1];", &["declaration"]), Some(LISTS));
        assert_eq!(of("x : OWN := (f := 0);", &["declaration"]), Some(LISTS));
        assert_eq!(of("x := STRING#'';", &["STRING#"]), Some(TEXTS));
        assert_eq!(of("x : BOOL := BOOL#TRUE;", &[TYPED_LITERAL]), Some(NUMBERS));
        assert_eq!(of("x : CHAR := CHAR#'a';", &[TYPED_LITERAL]), Some(TEXTS));
        assert_eq!(of("x : BOOL := BOOL#FALSE;", &["BOOL#"]), Some(NUMBERS));
        let promises = |name: &str| {
            FUNCTIONS
                .iter()
                .find(|(known, _)| *known == name)
                .map(|(_, promises)| *promises)
        };
        assert_eq!(of("x := LEN(y);", &["LEN"]), promises("LEN"));
        assert_eq!(of("x := min(y, y);", &["MAX"]), promises("MIN"));
        assert_eq!(of("x := MIN(LEN(y), y);", &["MAX", "LEN"]), None);
        assert_eq!(of("x := MIN(INT#0, REAL#0.0);", &["MAX"]), None);
        assert_eq!(
            of("x : INT := INT#-5;", &["typed literal with a sign"]),
            Some(NUMBERS)
        );
        assert_eq!(of("x := CHAR#'a';", &["CHAR#"]), Some(TEXTS));
        assert_eq!(of("CONTINUE;", &["statement"]), Some(CONTINUE));
        assert_eq!(of("(* (* *) *)", &["statement"]), Some(COMMENTS));
        assert_eq!(of("{ } x := x;", &["statement"]), Some(PRAGMAS));
        assert_eq!(of("x : LTIME := LT#0s;", &[LONG]), Some(DURATIONS));
        assert_eq!(of("x : LDATE := LD#2024-01-01;", &[LONG]), Some(MOMENTS));
        assert_eq!(of("x AT %MW10 : INT;", &["declaration"]), Some(LOCATIONS));
        let by_name = ["declaration", "initial value by name", "type of one's own"];
        assert_eq!(of("x : OWN := a;", &by_name), Some(ENUMERATIONS));
        assert_eq!(of("x : OWN := a;", &by_name[..2]), None);
        assert_eq!(of("x : LTOD;", &["declaration"]), Some(LONG_TYPES));
        assert_eq!(of("x : INT;", &["declaration", "VAR_IN_OUT"]), Some(IN_OUT));
        assert_eq!(of("x : INT;", &["declaration"]), None);
        assert_eq!(of("x : INT := 0;", &["type"]), Some(OWN_VALUES));
        assert_eq!(of("x : INT;", &["type"]), Some(ALIASES));
        assert_eq!(of("x := BOOL#0;", &["statement"]), Some(NUMBERS));
        assert_eq!(of("x := TOD#00:00:00;", &["statement"]), Some(MOMENTS));
    }

    #[test]
    fn every_basis_has_a_source_of_the_suite() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
        let suite = Suite::load_files(&folder, &[], |_, _| false);
        let all = [
            NUMBERS,
            TEXTS,
            ESCAPES,
            DURATIONS,
            MOMENTS,
            RANGES,
            REALS,
            COMMENTS,
            PRAGMAS,
            CONTINUE,
            LOCATIONS,
            ENUMERATIONS,
            FIELDS,
            GRAMMAR,
            LISTS,
            OWN_VALUES,
            LONG_TYPES,
            ALIASES,
            IN_OUT,
            INITIAL_VALUES,
            ARRAYS,
            STRUCTURES,
            BLOCKS,
            OUTPUTS,
            REAL_WIDENING,
        ];
        let of_functions = FUNCTIONS.iter().flat_map(|(_, promises)| *promises);
        for basis in all.concat().iter().chain(of_functions) {
            assert!(suite.sources.of(basis).is_some(), "{basis}");
        }
    }

    #[test]
    fn what_is_missing_and_values_are_promised_by_their_construct() {
        assert_eq!(
            of_missing(&essence(&["array", "function or function block"])),
            Some(ARRAYS)
        );
        assert_eq!(of_missing(&essence(&["statement"])), None);
        assert_eq!(of_missing(&essence(&["array", "bit access"])), None);
        assert_eq!(
            of_missing(&essence(&["VAR_IN_OUT", "instance of a function block"])),
            Some(IN_OUT)
        );
        assert_eq!(
            of_value(&essence(&["FUNCTION_BLOCK", "initial value"])),
            Some(INITIAL_VALUES)
        );
        assert_eq!(of_value(&essence(&["STRUCT", "initial value"])), Some(FIELDS));
        assert_eq!(of_value(&essence(&["conversion real"])), Some(REAL_WIDENING));
        assert_eq!(of_value(&essence(&["conversion real", "LREAL_TO_real"])), None);
        assert_eq!(
            of_value(&essence(&["TIME#", "assigned value", "duration"])),
            Some(DURATIONS)
        );
        assert_eq!(of_value(&essence(&["assigned value", "integer"])), Some(RANGES));
        assert_eq!(
            of_value(&essence(&["arithmetic", "assigned value", "integer"])),
            None
        );
    }
}
