//! The suite that ships with Stickler is sound.

use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::path::Path;
use std::sync::{Arc, LazyLock};

use stickler_suite::{Acceptance, Case, Role, Suite, Wanted};
use stickler_types::{Dialect, DialectName, Question, join};

/// The keywords of the standard that the reference takes for names, since what they begin is not implemented there.
/// Basis: iec-61131-3: second edition, Annex C.
const KEYWORDS: &str =
    "ACTION END_ACTION END_STEP END_TRANSITION FROM INITIAL_STEP READ_ONLY READ_WRITE STEP TRANSITION";

/// The standard functions whose names a program could also give to something of its own.
/// Basis: iec-61131-3: third edition, Tables 28 to 36.
const STANDARD_FUNCTIONS: &str = "ABS ACOS ADD ADD_DT_TIME ADD_TIME ADD_TOD_TIME ASIN ATAN ATAN2 CONCAT COS DELETE DIV EQ EXP EXPT FIND \
    GE GT INSERT LE LEFT LEN LIMIT LN LOG LT MAX MID MIN MOVE MUL MUX NE REPLACE RIGHT ROL ROR SEL SHL SHR SIN SQRT SUB TAN TRUNC";

/// The suite, which takes long to read and is read once.
static SHIPPED: LazyLock<Suite> =
    LazyLock::new(|| Suite::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases")));

/// Returns the keywords and names of a program, each in capitals with the place behind it.
fn words(source: &str) -> Vec<(String, usize)> {
    let words = stickler_syntax::words(source, Dialect::of(DialectName::IEC_ED3));
    words
        .map(|word| (word.text.to_ascii_uppercase(), word.span.end as usize))
        .collect()
}

#[test]
fn no_program_that_must_be_accepted_has_a_keyword_for_a_name() {
    // Compilers that know sequential function charts would reject it for that.
    let accepted = SHIPPED
        .cases
        .iter()
        .filter(|case| case.expectation.accepted != Acceptance::Rejected);
    let mut seen = HashSet::new();
    let mut files = BTreeSet::new();
    // The dialects share most programs.
    for case in accepted.filter(|case| seen.insert(&case.source)) {
        if words(&case.source)
            .iter()
            .any(|(word, _)| KEYWORDS.split(' ').any(|keyword| keyword == word))
        {
            files.insert(&*case.file);
        }
    }
    assert!(files.is_empty(), "{files:#?}");
}

#[test]
fn no_program_that_an_engine_is_given_has_a_mark() {
    let mut cases = SHIPPED.cases.iter();
    let marked = cases.find(|case| case.source.contains("(*!") && !case.source.contains("'(*!"));
    assert_eq!(marked.map(Case::key), None);
}

#[test]
fn no_program_gives_the_name_of_a_standard_function_to_something_else() {
    // A compiler may take the name for the function's, and no document says that it must not, except by an example of its own.
    let is_printed = |case: &Case| case.tags.iter().any(|tag| tag.starts_with("example-"));
    let functions: HashSet<&str> = STANDARD_FUNCTIONS.split_whitespace().collect();
    let mut seen = HashSet::new();
    let mut found = BTreeSet::new();
    let cases = SHIPPED.cases.iter();
    for case in cases.filter(|case| !is_printed(case) && seen.insert(&case.source)) {
        for (word, end) in words(&case.source) {
            // `LT#` begins a duration.
            let is_call_or_literal = || case.source[end..].trim_start().starts_with(['(', '#']);
            if functions.contains(&*word) && !is_call_or_literal() {
                found.insert(format!("{}: {word}", case.file));
            }
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn results_of_functions_of_reals_are_those_of_exact_arithmetic() {
    let mut checked = HashSet::new();
    for case in &SHIPPED.cases {
        let (Some(Question::Call(call)), [expected]) =
            (case.question.as_deref(), &case.expectation.values[..])
        else {
            continue;
        };
        if !case.file.contains("language/functions-of-") {
            continue;
        }
        let nearest = stickler_exact::nearest_result(&call.function, &call.operands, call.result);
        let nearest = nearest.map(|value| value.to_string()).unwrap_or_default();
        let stated = expected.value.to_string();
        assert_eq!(stated.split(" within ").next(), Some(&*nearest), "{}", case.id);
        checked.insert(case.id.to_string());
    }
    assert!(checked.len() > 150, "only {} calls", checked.len());
}

#[test]
fn lint_has_nothing_to_say() {
    let suite = &*SHIPPED;
    let findings = join(suite.findings().iter().map(|finding| &finding.what), "\n");
    assert!(findings.is_empty(), "{findings}");
    assert_eq!(suite.dialects.resolve("all").unwrap(), DialectName::ALL);
    let but = suite.dialects.resolve("all but ironplc matiec").unwrap();
    assert_eq!(but, DialectName::ALL[4..]);
    assert!(!suite.version.is_empty());
}

#[test]
fn each_minimal_program_uses_its_feature_and_those_that_it_needs() {
    let features = &SHIPPED.features;
    assert!(features.iter().count() > 100);
    for feature in features.iter() {
        let used = stickler_syntax::features::features(&feature.program, Dialect::of(DialectName::IEC_ED3));
        let used: BTreeSet<&str> = used.iter().map(AsRef::as_ref).collect();
        let stated = feature.needs.iter().map(String::as_str);
        let stated: BTreeSet<&str> = stated.chain([feature.key.as_str()]).collect();
        assert_eq!(used, stated, "{}", feature.key);
    }
}

#[test]
fn every_feature_of_a_case_is_in_the_list() {
    let mut asked = HashSet::new();
    let cases = SHIPPED.cases.iter().filter(|case| asked.insert(&case.source));
    // A mistake of a case may be the name of a function that no dialect has.
    let accepted = cases.filter(|case| case.expectation.accepted != Acceptance::Rejected);
    let used = accepted
        .step_by(5)
        .flat_map(|case| case.features().into_iter().map(|key| (key, &case.id)));
    let unlisted: BTreeSet<_> = used
        .filter(|(key, _)| SHIPPED.features.get(key).is_none())
        .collect();
    assert_eq!(unlisted, BTreeSet::new());
}

#[test]
fn every_feature_and_function_that_a_dialect_names_is_in_the_list() {
    for dialect in DialectName::ALL {
        for name in dialect.rules().names.values() {
            assert!(
                SHIPPED.features.is_standard(name, dialect),
                "`{name}` of {dialect}"
            );
        }
        let declared = &dialect.rules().features;
        for word in declared.has.iter().chain(&declared.lacks) {
            assert!(SHIPPED.features.get(word).is_some(), "`{word}` of {dialect}");
        }
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
    let wanted = Wanted {
        with_repeats: true,
        ..Wanted::default()
    };
    let suite = Suite::load_files(&shipped, wanted, |id, _| id == "widening/contexts");
    let mut by_dialect: BTreeMap<DialectName, Vec<&Case>> = BTreeMap::new();
    let cases = suite
        .cases
        .iter()
        .filter(|case| case.id.starts_with("widening/contexts::placed-rejected"));
    for case in cases.filter(|case| !case.dialect.is_variant()) {
        assert_eq!(case.expectation.accepted, Acceptance::Rejected);
        by_dialect.entry(case.dialect).or_default().push(case);
    }
    assert!(by_dialect.len() > 4, "{:?}", by_dialect.keys());
    for (dialect, cases) in by_dialect {
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
            assert_eq!(met, standing, "{cell:?} of {dialect}");
        }
        let together = pairs(&cases, |case| {
            let placed = case.placement.as_ref()?;
            Some((&*placed.source, &*placed.target))
        });
        // A global variable stands in a program, and the parameters of a block in the block.
        let sources = "variable parentheses array-element field path function-result block-output";
        let targets = "assignment array-element field path argument block-input external";
        for target in targets.split(' ') {
            for source in sources.split(' ') {
                assert!(
                    together.contains(&(source, target)),
                    "{source} into {target} of {dialect}"
                );
            }
        }
        let around = pairs(&cases, |case| {
            let placed = case.placement.as_ref()?;
            Some((&*placed.target, &*placed.surrounding))
        });
        let surroundings = "program function function-block if elsif else case for while repeat";
        for surrounding in surroundings.split(' ') {
            for target in ["assignment", "array-element", "field", "argument"] {
                assert!(
                    around.contains(&(target, surrounding)),
                    "{target} in {surrounding} of {dialect}"
                );
            }
        }
    }
}
