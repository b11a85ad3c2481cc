//! Applying a suggestion makes the program acceptable.

use super::{ED3, RUSTY, diagnose};
use stickler_types::dialect::Dialect;
use stickler_types::{DialectName, ElementaryType};

/// Applies the suggestions of a text that has some, and says what the checker then says; `None` where it
/// suggests nothing.
fn repaired(name: DialectName, text: &str) -> Option<Vec<stickler_syntax::diagnostic::SpannedDiagnostic>> {
    let mut diagnostics = diagnose(name, text);
    diagnostics.retain(|diagnostic| diagnostic.suggestion.is_some());
    diagnostics.sort_by_key(|diagnostic| std::cmp::Reverse(diagnostic.span.start));
    let mut text = text.to_owned();
    for diagnostic in &diagnostics {
        let span = diagnostic.span.start as usize..diagnostic.span.end as usize;
        text.replace_range(span, diagnostic.suggestion.as_deref()?);
    }
    (!diagnostics.is_empty()).then(|| diagnose(name, &text))
}

/// Programs in each of which a value of type FROM stands where one of type INTO is expected.
const CONTEXTS: [&str; 9] = [
    "PROGRAM main VAR a : FROM; b : INTO; END_VAR b := a; END_PROGRAM",
    "PROGRAM main VAR a : FROM; b : INTO; END_VAR b := (a); END_PROGRAM",
    "PROGRAM main VAR a : FROM; b : INTO := a; END_VAR END_PROGRAM",
    "PROGRAM main VAR a : FROM; b : ARRAY[0..1] OF INTO := [a, a]; END_VAR b[1] := a; END_PROGRAM",
    "TYPE S : STRUCT x : INTO; END_STRUCT; END_TYPE
     PROGRAM main VAR a : FROM; b : S := (x := a); END_VAR b.x := a; END_PROGRAM",
    "FUNCTION F : BOOL VAR_INPUT p : INTO; END_VAR END_FUNCTION
     PROGRAM main VAR a : FROM; b : BOOL; END_VAR b := F(a); b := F(p := a); END_PROGRAM",
    "FUNCTION F : FROM END_FUNCTION PROGRAM main VAR b : INTO; END_VAR b := F(); END_PROGRAM",
    "FUNCTION F : INTO VAR_INPUT p : FROM; END_VAR F := p; END_FUNCTION
     PROGRAM main VAR a : FROM; b : INTO; END_VAR b := F(a); END_PROGRAM",
    "FUNCTION_BLOCK G VAR_INPUT p : INTO; END_VAR END_FUNCTION_BLOCK
     PROGRAM main VAR a : FROM; b : G; END_VAR b(p := a); END_PROGRAM",
];

#[test]
fn every_suggestion_between_elementary_types_makes_the_program_acceptable() {
    for name in DialectName::ALL {
        let dialect = Dialect::of(name);
        let types = ElementaryType::ALL.into_iter().filter(|&ty| dialect.has(ty));
        for (from, to) in types
            .clone()
            .flat_map(|from| types.clone().map(move |to| (from, to)))
        {
            for context in CONTEXTS {
                let text = context.replace("FROM", from.name()).replace("INTO", to.name());
                if let Some(left) = repaired(name, &text) {
                    assert_eq!(left, [], "{name}: {text}");
                }
            }
        }
    }
}

#[test]
fn each_pair_that_does_not_convert_but_has_a_function_has_a_suggestion() {
    for name in DialectName::ALL {
        let dialect = Dialect::of(name);
        let types = ElementaryType::ALL.into_iter().filter(|&ty| dialect.has(ty));
        for (from, to) in types
            .clone()
            .flat_map(|from| types.clone().map(move |to| (from, to)))
        {
            let text = CONTEXTS[0]
                .replace("FROM", from.name())
                .replace("INTO", to.name());
            let converts = crate::conversion::implicit(from, to, dialect).is_some();
            let function = crate::conversion::conversion_function_name(from, to, dialect);
            let suggestions: Vec<_> = diagnose(name, &text)
                .into_iter()
                .filter(|diagnostic| diagnostic.code.severity().is_error())
                .map(|diagnostic| diagnostic.suggestion)
                .collect();
            let expected = if converts {
                vec![]
            } else {
                vec![function.map(|function| format!("{function}(a)"))]
            };
            assert_eq!(suggestions, expected, "{name}: {text}");
        }
    }
}

#[test]
fn a_suggestion_takes_the_whole_expression() {
    let text = "PROGRAM main VAR a, b : DINT; s : INT; END_VAR s := a + b * 2; END_PROGRAM";
    let diagnostics = diagnose(ED3, text);
    assert_eq!(
        diagnostics[0].suggestion.as_deref(),
        Some("DINT_TO_INT(a + b * 2)")
    );
    assert_eq!(repaired(ED3, text), Some(vec![]));
}

#[test]
fn arguments_of_standard_functions_have_suggestions_that_fit() {
    for statement in [
        "i := ABS(b);",
        "w := SHL(i, 1);",
        "i := MAX(i, d);",
        "i := DINT_TO_INT(r);",
        "w := ROL(w, r);",
        "i := a[r];",
        "IF i THEN ; END_IF;",
        "i := SEL(i, i, i);",
    ] {
        let text = format!(
            "PROGRAM main VAR i : INT; b : BOOL; w : WORD; d : REAL; r : LREAL; a : ARRAY[0..1] OF INT; END_VAR
             {statement} END_PROGRAM"
        );
        let left = repaired(ED3, &text).unwrap_or_else(|| panic!("{statement} has a suggestion"));
        let argument = left.iter().all(|diagnostic| diagnostic.suggestion.is_some());
        assert!(
            argument,
            "{statement} is repaired, or what is left has its own suggestion: {left:?}"
        );
    }
}

#[test]
fn an_argument_of_a_standard_function_is_converted_to_what_is_wanted_of_the_result_or_not_at_all() {
    let suggested = |statement: &str| {
        let text = format!(
            "PROGRAM main VAR i : INT; b : BOOL; w : WORD; r : REAL; n : INT; END_VAR {statement} END_PROGRAM"
        );
        diagnose(ED3, &text).remove(0).suggestion
    };
    for (statement, suggestion) in [
        ("i := ABS(b);", Some("BOOL_TO_INT(b)")),
        ("r := ABS(w);", Some("WORD_TO_REAL(w)")),
        ("w := SHL(r, 1);", Some("REAL_TO_WORD(r)")),
        ("n := LEN(i);", Some("INT_TO_STRING(i)")),
        // What ABS gives of an LREAL is no INT.
        ("i := i + ABS(w);", None),
    ] {
        assert_eq!(suggested(statement).as_deref(), suggestion, "{statement}");
    }
}

#[test]
fn of_arguments_without_a_common_type_the_one_that_is_not_what_is_wanted_is_to_be_converted() {
    for (statement, suggestion) in [
        ("u := MIN(x, u);", "LDT_TO_USINT(x)"),
        ("u := MAX(u, x);", "LDT_TO_USINT(x)"),
        ("u := LIMIT(x, u, 5);", "LDT_TO_USINT(x)"),
        ("u := SEL(b, x, u);", "LDT_TO_USINT(x)"),
        ("u := MUX(1, x, u, 5);", "LDT_TO_USINT(x)"),
        ("x := MUX(1, x, u);", "USINT_TO_LDT(u)"),
    ] {
        let text = format!("PROGRAM main VAR u : USINT; x : LDT; b : BOOL; END_VAR {statement} END_PROGRAM");
        let diagnostics = diagnose(RUSTY, &text);
        let suggested: Vec<_> = diagnostics
            .iter()
            .map(|said| said.suggestion.as_deref())
            .collect();
        assert_eq!(suggested, [Some(suggestion)], "{statement}");
        assert_eq!(repaired(RUSTY, &text), Some(vec![]), "{statement}");
    }
}

#[test]
fn a_function_of_the_text_with_the_name_of_a_conversion_is_not_suggested() {
    let text = "FUNCTION DINT_TO_INT : BOOL VAR_INPUT x : BOOL; END_VAR END_FUNCTION
        PROGRAM main VAR a : DINT; b : INT; END_VAR b := a; END_PROGRAM";
    assert_eq!(diagnose(ED3, text)[0].suggestion, None);
}

#[test]
fn near_names_of_conversion_functions_are_named() {
    let hint = |name, call: &str| {
        let text = format!("PROGRAM main VAR x : INT; END_VAR x := {call}; END_PROGRAM");
        diagnose(name, &text)[0].message.clone()
    };
    for (call, expected) in [
        (
            "INT_TO_DNIT(x)",
            "`INT_TO_DNIT` is not declared; did you mean `INT_TO_DINT`?",
        ),
        (
            "Real_To_Itn(x)",
            "`Real_To_Itn` is not declared; did you mean `REAL_TO_INT`?",
        ),
        ("TRUNK(x)", "`TRUNK` is not declared; did you mean `TRUNC`?"),
        (
            "TRUNC_XINT(x)",
            "`TRUNC_XINT` is not declared; did you mean `TRUNC_DINT`, `TRUNC_INT` or `TRUNC_LINT`?",
        ),
        (
            "CONCAT_DATE_TOT(x)",
            "`CONCAT_DATE_TOT` is not declared; did you mean `CONCAT_DATE_TOD`?",
        ),
        ("FLOR(x)", "`FLOR` is not declared; did you mean `FLOOR`?"),
        ("INT_TO_NOTHING(x)", "`INT_TO_NOTHING` is not declared"),
    ] {
        assert_eq!(hint(ED3, call), expected);
    }
    assert_eq!(hint(super::MATIEC, "FLOR(x)"), "`FLOR` is not declared");
    assert_eq!(
        hint(super::ED2, "LTIME_TO_IN(x)"),
        "`LTIME_TO_IN` is not declared; did you mean `TIME_TO_INT`?"
    );
    let in_a_constant = "PROGRAM main VAR a : ARRAY[0..INT_TO_DNIT(1)] OF INT; END_VAR END_PROGRAM";
    assert!(
        diagnose(ED3, in_a_constant)[0]
            .message
            .ends_with("did you mean `INT_TO_DINT`?")
    );
}
