//! Every pair of elementary types in every context and dialect: what converts implicitly is accepted, and where a
//! conversion function exists, the suggestion names it and repairs the program.

use stickler_reference::conversion::{conversion_function_name, implicit};
use stickler_reference::errors;
use stickler_types::Dialect;
use stickler_types::{Diagnostic, DialectName, ElementaryType};

/// Programs in which a value of type `FROM` named `a` stands on a line of its own where `INTO` is expected.
const CONTEXTS: [(&str, &str, &str); 7] = [
    (
        "assignment",
        "P4035",
        "PROGRAM main VAR a : FROM; b : INTO; END_VAR b :=\na\n; END_PROGRAM",
    ),
    (
        "initializer",
        "P4022",
        "PROGRAM main VAR a : FROM; b : INTO :=\na\n; END_VAR ; END_PROGRAM",
    ),
    (
        "argument",
        "P4026",
        "FUNCTION F : BOOL VAR_INPUT p : INTO; END_VAR F := TRUE; END_FUNCTION
PROGRAM main VAR a : FROM; b : BOOL; END_VAR b := F(\na\n); END_PROGRAM",
    ),
    (
        "block input",
        "P4026",
        "FUNCTION_BLOCK F VAR_INPUT p : INTO; END_VAR ; END_FUNCTION_BLOCK
PROGRAM main VAR a : FROM; f : F; END_VAR f(p :=\na\n); END_PROGRAM",
    ),
    (
        "result in the body",
        "P4035",
        "FUNCTION F : INTO VAR a : FROM; END_VAR F :=\na\n; END_FUNCTION",
    ),
    (
        "element",
        "P4035",
        "PROGRAM main VAR a : FROM; b : ARRAY[1..2] OF INTO; END_VAR b[1] :=\na\n; END_PROGRAM",
    ),
    (
        "field",
        "P4035",
        "TYPE S : STRUCT f : INTO; END_STRUCT; END_TYPE
PROGRAM main VAR a : FROM; b : S; END_VAR b.f :=\na\n; END_PROGRAM",
    ),
];

fn written(context: &str, from: ElementaryType, to: ElementaryType) -> String {
    context.replace("FROM", from.name()).replace("INTO", to.name())
}

/// The source with a diagnostic's place, a line of its own, replaced by the suggestion.
fn repaired(source: &str, found: &Diagnostic) -> Option<String> {
    let mut lines: Vec<_> = source.lines().collect();
    *lines.get_mut(found.line? as usize - 1)? = found.suggestion.as_deref()?;
    Some(lines.join("\n"))
}

fn each_pair(dialect: &Dialect, mut test: impl FnMut(ElementaryType, ElementaryType)) {
    let types = || ElementaryType::ALL.into_iter().filter(|ty| dialect.has(*ty));
    for from in types() {
        for to in types() {
            test(from, to);
        }
    }
}

#[test]
fn contexts_follow_the_one_rule_and_suggestions_repair() {
    let mut suggested = 0;
    for name in DialectName::ALL {
        let dialect = Dialect::of(name);
        each_pair(dialect, |from, to| {
            for (context, code, template) in CONTEXTS {
                let about = format!("{}, {context}: {} to {}", name.as_str(), from.name(), to.name());
                let source = written(template, from, to);
                let found = errors(&source, name);
                if implicit(from, to, dialect).is_some() {
                    assert_eq!(found, [], "{about}");
                    continue;
                }
                let [only] = &found[..] else {
                    panic!("{about}: {found:#?}")
                };
                assert_eq!(only.code.as_deref(), Some(code), "{about}");
                let line = only.line.and_then(|line| source.lines().nth(line as usize - 1));
                assert_eq!(line, Some("a"), "{about}");
                match conversion_function_name(from, to, dialect) {
                    Some(function) => {
                        assert_eq!(only.suggestion, Some(format!("{function}(a)")), "{about}");
                        let repaired = repaired(&source, only).expect("a place");
                        assert_eq!(errors(&repaired, name), [], "{about}: {repaired}");
                        suggested += 1;
                    }
                    None => assert_eq!(only.suggestion, None, "{about}"),
                }
            }
        });
    }
    assert!(suggested > 10_000, "only {suggested} suggestions were made");
}

#[test]
fn the_result_of_a_call_is_told_apart() {
    for name in DialectName::ALL {
        let dialect = Dialect::of(name);
        each_pair(dialect, |from, to| {
            let template = "FUNCTION F : FROM ; END_FUNCTION
PROGRAM main VAR b : INTO; END_VAR b :=\nF()\n; END_PROGRAM";
            let source = written(template, from, to);
            let codes: Vec<_> = errors(&source, name)
                .into_iter()
                .filter_map(|found| found.code)
                .collect();
            let expected: &[&str] = if implicit(from, to, dialect).is_some() {
                &[]
            } else {
                &["P4027"]
            };
            assert_eq!(
                codes,
                expected,
                "{}: {} to {}",
                name.as_str(),
                from.name(),
                to.name()
            );
        });
    }
}
