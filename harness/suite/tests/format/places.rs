//! Programs that are put together of places.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Arc;

use stickler_suite::{Acceptance, Case, Role, Suite};
use stickler_types::DialectName;

use crate::common::load;

/// Two sources, two targets, of which one takes literals, and two surroundings.
const PLACES: &str = r#"
[unit.program]
observe = "{observe}"
text    = """
{declarations}
PROGRAM main
VAR
    {variables}
END_VAR
    {before}
    {statement}
END_PROGRAM
"""

[source.variable]
title     = "a variable"
promised  = "b: c"
variables = "data : {from} := {value};"
value     = "data"

[source.literal]
title    = "a literal"
promised = "b: c"
literal  = true
value    = "{typed}"

[target.field]
title        = "a field"
promised     = "b: c"
declarations = """
TYPE
    RECORD : STRUCT
        field : {to};
    END_STRUCT;
END_TYPE
"""
variables    = "into : RECORD;"
target       = "into.field"
statement    = "{target} := {source};  {error}"
observe      = "into.field"
code         = "P4035"

[target.initial-value]
title     = "an initial value"
promised  = "b: c"
literal   = true
absent    = ["matiec"]
variables = "into : {to} := {source};  {error}"
statement = ";"
observe   = "into"
code      = "P4022"

[surrounding.program]
title     = "the body"
promised  = "b: c"
statement = "{statement}"

[surrounding.loop]
title     = "FOR"
promised  = "b: c"
statement = """
FOR i := 1 TO 1 DO
    {statement}
END_FOR;
"""
"#;

/// A matrix with a probe for its `yes` and one for its `no`, both of the keys `places`.
fn matrix(places: &str) -> String {
    format!(
        "title = 't'\nbasis = 'b: c'\ndialects = ['matiec', 'plcnext']\nmatrix = \"\"\"\n     INT DINT\nINT  -   yes\nDINT no  -\n\"\"\"\n\
         [[probe]]\nname = 'accepted'\nonly = 'yes'\nvalues = 'telling'\nplaces = {{ {places} }}\n\
         [[probe]]\nname = 'rejected'\nonly = 'no'\nvalues = 'one'\nplaces = {{ error = 'if no' }}\n"
    )
}

fn suite(places: &str, table: &str) -> Suite {
    load(&[("places.toml", places), ("a/t.toml", table)])
}

fn errors(suite: &Suite) -> Vec<String> {
    suite.errors.iter().map(ToString::to_string).collect()
}

fn ids(suite: &Suite, dialect: DialectName) -> Vec<&str> {
    let cases = suite.cases.iter().filter(|case| case.dialect == dialect);
    cases.map(|case| &*case.id).collect()
}

#[test]
fn a_cell_takes_every_source_and_every_target_that_its_dialect_has() {
    let suite = suite(PLACES, &matrix(""));
    assert!(suite.errors.is_empty(), "{:?}", errors(&suite));
    assert_eq!(
        ids(&suite, DialectName::PLCNEXT),
        [
            "a/t::accepted(INT,DINT,-32767,variable,field,program)",
            "a/t::accepted(INT,DINT,-32767,literal,field,loop)",
            "a/t::accepted(INT,DINT,-32767,literal,initial-value,program)",
            "a/t::rejected(DINT,INT,variable,field,program)",
            "a/t::rejected(DINT,INT,literal,field,loop)",
            "a/t::rejected(DINT,INT,literal,initial-value,program)",
        ]
    );
    assert!(
        !ids(&suite, DialectName::MATIEC)
            .iter()
            .any(|id| id.contains("initial-value"))
    );
}

#[test]
fn a_place_of_rejections_only_takes_no_value_that_is_accepted() {
    let places = PLACES.replace(
        "[source.literal]",
        "[source.literal]\nonly-rejected = ['plcnext']",
    );
    let suite = suite(&places, &matrix(""));
    assert!(suite.errors.is_empty(), "{:?}", errors(&suite));
    let of_literals = |dialect: DialectName, probe: &str| {
        let ids = ids(&suite, dialect).into_iter();
        ids.filter(|id| id.contains(probe) && id.contains("literal"))
            .count()
    };
    assert_eq!(of_literals(DialectName::PLCNEXT, "accepted"), 0);
    assert!(of_literals(DialectName::PLCNEXT, "rejected") > 0);
    assert!(of_literals(DialectName::MATIEC, "accepted") > 0);
}

#[test]
fn a_place_of_rejections_only_is_one_that_the_dialect_has() {
    let places = PLACES.replace(
        "absent    = [\"matiec\"]",
        "absent    = [\"matiec\"]\nonly-rejected = ['matiec']",
    );
    let errors = errors(&suite(&places, &matrix("")));
    assert!(
        matches!(&errors[..], [error] if error.contains("`only-rejected` names `matiec`, in which the place is not")),
        "{errors:?}"
    );
}

#[test]
fn declarations_of_a_probe_stand_before_those_of_its_places() {
    let suite = suite(PLACES, &matrix("declarations = 'TYPE OWN : {row}; END_TYPE'"));
    assert!(suite.errors.is_empty(), "{:?}", errors(&suite));
    let cases = suite.cases.iter();
    let accepted: Vec<&str> = cases
        .filter(|case| case.id.contains("::accepted"))
        .map(|case| &*case.source)
        .collect();
    assert!(!accepted.is_empty());
    for source in accepted {
        assert!(source.starts_with("TYPE OWN : INT; END_TYPE\n"), "{source}");
    }
}

#[test]
fn a_program_is_put_together_line_by_line() {
    let suite = suite(PLACES, &matrix(""));
    let find = |id: &str| suite.cases.iter().find(|case| &*case.id == id).unwrap();
    let case = find("a/t::rejected(DINT,INT,literal,field,loop)");
    let lines: Vec<&str> = case.source.lines().collect();
    assert_eq!(
        lines,
        [
            "TYPE",
            "    RECORD : STRUCT",
            "        field : INT;",
            "    END_STRUCT;",
            "END_TYPE",
            "PROGRAM main",
            "VAR",
            "    into : RECORD;",
            "END_VAR",
            "    FOR i := 1 TO 1 DO",
            "        into.field := DINT#1;  (*! error P4035 if no *)",
            "    END_FOR;",
            "END_PROGRAM",
        ]
    );
    assert_eq!(case.expectation.diagnostics[0].line, 11);
    assert_eq!(case.expectation.diagnostics[0].code.as_str(), "P4035");
    let placement = case.placement.as_deref().unwrap();
    assert_eq!(
        [&*placement.source, &*placement.target, &*placement.surrounding],
        ["literal", "field", "loop"]
    );
    let accepted = find("a/t::accepted(INT,DINT,-32767,literal,initial-value,program)");
    assert!(
        accepted.source.contains("    into : DINT := INT#-32767;\n"),
        "{}",
        accepted.source
    );
    assert_eq!(&*accepted.expectation.values[0].name, "into");
    assert_eq!(accepted.expectation.values[0].value.to_string(), "DINT#-32767");
}

#[test]
fn a_row_takes_its_share_of_the_combinations() {
    let table = "title = 't'\nbasis = 'b: c'\ndialects = ['plcnext']\ncolumns = ['type', 'bit', 'expected']\n\
                 rows = [['INT', '0', 'INT#1'], ['INT', '1', 'INT#2'], ['INT', '2', 'INT#4']]\nexpect = '{expected}'\n\
                 asks = 'bits({type},{bit})'\n\
                 [[probe]]\nname = 'p'\nplaces = { from = 'BOOL', to = '{type}', value = 'TRUE', typed = 'BOOL#TRUE', combinations = 1,\
                 targets = ['field'], variable = '{target}.{bit}', before = '{target} := INT#0;' }\n";
    let suite = suite(PLACES, table);
    assert!(suite.errors.is_empty(), "{:?}", errors(&suite));
    let ids = ids(&suite, DialectName::PLCNEXT);
    assert_eq!(ids.len(), 3, "{ids:?}");
    let sources: BTreeSet<&str> = suite
        .cases
        .iter()
        .map(|case| &*case.placement.as_ref().unwrap().source)
        .collect();
    assert_eq!(sources.len(), 2);
    assert!(
        suite.cases.iter().all(|case| case.question.is_none()),
        "they ask about a place as well"
    );
    let source = &suite.cases[2].source;
    assert!(source.contains("into.field := INT#0;\n"), "{source}");
    assert!(source.contains("into.field.2 := "), "{source}");
}

#[test]
fn no_probe_takes_a_combination_that_tables_ask_with_programs_of_their_own() {
    let places =
        format!("plain = [['variable', 'field', 'program'], ['literal', 'field', 'loop']]\n{PLACES}");
    let suite = suite(&places, &matrix(""));
    assert!(suite.errors.is_empty(), "{:?}", errors(&suite));
    assert_eq!(
        ids(&suite, DialectName::MATIEC),
        [
            "a/t::accepted(INT,DINT,-32767,variable,field,loop)",
            "a/t::accepted(INT,DINT,-32767,literal,field,program)",
            "a/t::rejected(DINT,INT,variable,field,loop)",
            "a/t::rejected(DINT,INT,literal,field,program)",
        ]
    );
}

#[test]
fn dialects_of_one_compiler_take_their_programs_in_turn() {
    let table = matrix("").replace("'plcnext']", "'ironplc-ed2', 'ironplc-ed3']");
    let all = suite(PLACES, &table);
    let in_turn = suite(&format!("in-turn = ['ironplc']\n{PLACES}"), &table);
    assert!(in_turn.errors.is_empty(), "{:?}", errors(&in_turn));
    let [second, third] =
        [DialectName::IRONPLC_ED2, DialectName::IRONPLC_ED3].map(|dialect| ids(&in_turn, dialect));
    assert!(!second.is_empty() && !third.is_empty(), "{second:?} {third:?}");
    assert!(
        second.iter().all(|id| !third.contains(id)),
        "{second:?} {third:?}"
    );
    let together: BTreeSet<&str> = second.into_iter().chain(third).collect();
    let expected: BTreeSet<&str> = ids(&all, DialectName::IRONPLC_ED2).into_iter().collect();
    assert_eq!(together, expected);
    assert_eq!(ids(&in_turn, DialectName::MATIEC), ids(&all, DialectName::MATIEC));
}

#[test]
fn unknown_places_are_told_with_the_nearest_name() {
    for (places, said) in [
        (
            "targets = ['feild']",
            "cases/a/t.toml:13: `probe.places`: no target `feild`; did you mean `field`?",
        ),
        (
            "surroundings = ['lop']",
            "no surrounding `lop`; did you mean `loop`?",
        ),
        (
            "sources = ['literal'], targets = ['nowhere']",
            "no target `nowhere`; there are field · initial-value",
        ),
        (
            "sources = ['variable'], targets = ['initial-value']",
            "can stand together in a surrounding",
        ),
        ("expression = '{colum}'", "no placeholder `{colum}`"),
        ("place = 'x'", "unknown field `place`"),
    ] {
        let suite = suite(PLACES, &matrix(places));
        assert!(
            errors(&suite).iter().any(|error| error.contains(said)),
            "{said}: {:?}",
            errors(&suite)
        );
    }
    let table = matrix("").replace("places = {  }", "source = 'x'\nplaces = {}");
    let suite = suite(PLACES, &table);
    assert!(
        errors(&suite)[0].contains("either `source` or `places`"),
        "{:?}",
        errors(&suite)
    );
}

#[test]
fn a_mistake_in_the_places_has_its_line() {
    for (from, to, said) in [
        (
            "{target} := {source};",
            "{tagret} := {source};",
            "places.toml:27: `target.field`: no word `{tagret}`; did you mean `target`?",
        ),
        (
            "code      = \"P4022\"",
            "",
            "`target.initial-value`: a target needs `code`",
        ),
        (
            "value     = \"data\"",
            "",
            "places.toml:15: `source.variable`: a source needs `value`",
        ),
        (
            "absent    = [\"matiec\"]",
            "absent    = [\"matic\"]",
            "`target.initial-value`: no dialect or group `matic`",
        ),
        (
            "promised  = \"b: c\"\nvariables",
            "promised  = \"b: x\"\nvariables",
            "`source.variable`: `b` has no section `x`",
        ),
        (
            "literal  = true",
            "units = ['programm']",
            "`source.literal`: no unit `programm`; did you mean `program`?",
        ),
        (
            "literal  = true",
            "only = 'into = BOOL'",
            "`source.literal`: no placeholder `into` to test; there are from, to",
        ),
        ("literal  = true", "literally = true", "unknown field `literally`"),
        (
            "[unit.program]",
            "plain = [['variable', 'feild', 'loop']]\n[unit.program]",
            "places.toml:2: `plain`: no target `feild`; did you mean `field`?",
        ),
        (
            "[unit.program]",
            "in-turn = ['iron']\n[unit.program]",
            "places.toml:2: `in-turn`: no dialect or group `iron`",
        ),
    ] {
        let changed = PLACES.replacen(from, to, 1);
        assert_ne!(changed, PLACES, "{from}");
        let suite = suite(&changed, &matrix(""));
        assert!(
            errors(&suite).iter().any(|error| error.contains(said)),
            "{said}: {:?}",
            errors(&suite)
        );
    }
}

/// The pairs of places of some cases.
fn pairs<'a>(
    cases: &[&'a Case],
    pair: fn(&'a Case) -> Option<(&'a str, &'a str)>,
) -> BTreeSet<(&'a str, &'a str)> {
    cases.iter().copied().filter_map(pair).collect()
}

#[test]
fn the_shipped_rejections_cover_the_places() {
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
    let suite = Suite::load_files(&shipped, &[], |id, _| id == "widening/contexts");
    // Dialects of one compiler take the programs that they have in common in turn.
    let ironplc = suite.dialects.resolve("ironplc").unwrap();
    let compiler = |dialect: DialectName| match ironplc.contains(&dialect) {
        true => "ironplc",
        false => dialect.as_str(),
    };
    let mut by_compiler: BTreeMap<&str, Vec<&Case>> = BTreeMap::new();
    let cases = suite
        .cases
        .iter()
        .filter(|case| case.id.starts_with("widening/contexts::placed-rejected"));
    for case in cases {
        assert_eq!(case.expectation.accepted, Acceptance::Rejected);
        by_compiler.entry(compiler(case.dialect)).or_default().push(case);
    }
    assert!(by_compiler.keys().eq(&["ironplc", "matiec", "plcnext"]));
    let dialects: BTreeSet<DialectName> = by_compiler["ironplc"].iter().map(|case| case.dialect).collect();
    assert!(dialects.iter().eq(&ironplc), "{dialects:?}");
    for (compiler, cases) in by_compiler {
        let target = |case: &&Case| case.placement.as_ref().unwrap().target.clone();
        let targets: BTreeSet<_> = cases.iter().map(target).collect();
        // The line tells cells of different matrices apart.
        let mut of_cell: BTreeMap<(u32, &str, &str), BTreeSet<_>> = BTreeMap::new();
        for case in &cases {
            let cell = case.cell.as_deref().unwrap();
            of_cell
                .entry((case.line, &cell.row, &cell.column))
                .or_default()
                .insert(target(case));
        }
        for (cell, met) in of_cell {
            let stands = |target: &&Arc<str>| {
                let mut places = suite.places.of(Role::Target).iter();
                let place = places.find(|place| place.name() == &***target).unwrap();
                place.stands(cases[0].dialect, (cell.1, cell.2), true)
            };
            let standing: BTreeSet<_> = targets.iter().filter(stands).cloned().collect();
            assert_eq!(met, standing, "{cell:?} of {compiler}");
        }
        let together = pairs(&cases, |case| {
            let placed = case.placement.as_ref()?;
            Some((&*placed.source, &*placed.target))
        });
        // A global variable stands in a program, and the parameters of a block in the block.
        let sources = [
            "variable",
            "parentheses",
            "array-element",
            "field",
            "path",
            "function-result",
            "block-output",
        ];
        for target in [
            "assignment",
            "array-element",
            "field",
            "path",
            "argument",
            "block-input",
            "external",
        ] {
            for source in sources {
                assert!(
                    together.contains(&(source, target)),
                    "{source} into {target} of {compiler}"
                );
            }
        }
        let around = pairs(&cases, |case| {
            let placed = case.placement.as_ref()?;
            Some((&*placed.target, &*placed.surrounding))
        });
        for surrounding in [
            "program",
            "function",
            "function-block",
            "if",
            "elsif",
            "else",
            "case",
            "for",
            "while",
            "repeat",
        ] {
            for target in ["assignment", "array-element", "field", "argument"] {
                assert!(
                    around.contains(&(target, surrounding)),
                    "{target} in {surrounding} of {compiler}"
                );
            }
        }
    }
}
