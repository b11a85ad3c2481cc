//! Collects the statements of documents about the conversions that the cases of a run ask for, for the page of the run.

use crate::case_folder::CaseFolder;
use crate::contradicted;
use crate::output;
use std::collections::BTreeSet;
use stickler_conversions::contradictions::AskedQuestion;
use stickler_conversions::overview::{AssertedResult, CaseStatement, Statements, StatementsBuilder};
use stickler_suite::{Acceptance, Case, SourceKind, Suite};
use stickler_types::{Contradiction, DialectName, MatrixWord, Question, Value};

/// Returns what documents state: of the pairs of types, the parts of types and the calls of functions in these cases, and of the
/// boundary values of these functions; what the recorded compilers of the folder answer, and where sources contradict each other on the questions of these cases,
/// or of all where these are all. A folder or file of recordings that cannot be
/// read is reported on stderr.
pub fn statements(cases: &[&Case], suite: &Suite, folder: &CaseFolder) -> Statements {
    let builder = builder(cases, suite, &[]);
    // A run that asks about no conversion does without the recordings, whose files take longer to read than a few cases.
    let recordings = match builder.is_empty() {
        true => Vec::new(),
        false => folder.usable_recordings().unwrap_or_else(|error| {
            output::error(&error);
            Vec::new()
        }),
    };
    let mut statements = builder.finish(&recordings);
    statements.printed = suite
        .sources
        .iter()
        .flat_map(|source| source.printed.clone())
        .collect();
    // The page stays small; the command shows the rest.
    let is_whole = cases.len() == suite.cases.len();
    let gathered = contradicted::gather(cases, suite, &recordings);
    let is_wanted = |asked: &AskedQuestion| is_whole || asked.case.is_some();
    statements.contradictions = gathered.finish(300, is_wanted);
    statements
}

/// Returns what these cases state about conversions, by the sources of the system that each is about; the columns are
/// these dialects and those of the cases.
pub fn builder(cases: &[&Case], suite: &Suite, dialects: &[DialectName]) -> StatementsBuilder {
    let of_cases = cases.iter().map(|case| case.dialect);
    let dialects: BTreeSet<DialectName> = dialects.iter().copied().chain(of_cases).collect();
    let mut builder = StatementsBuilder::new(dialects.into_iter().collect());
    for case in cases.iter().filter(|case| is_of_its_system(case, suite)) {
        if let Some(question) = &case.question {
            builder.add(question, &statement(case));
        }
    }
    builder
}

/// Returns what documents state about the conversions of all cases of a folder.
pub fn of_all_cases(folder: &CaseFolder) -> Statements {
    let suite = folder.load_with([]);
    statements(&suite.cases.iter().collect::<Vec<_>>(), &suite, folder)
}

fn statement(case: &Case) -> CaseStatement<'_> {
    CaseStatement {
        case: &case.id,
        dialect: case.dialect,
        word: match (&case.cell, case.expectation.accepted) {
            (Some(cell), _) => cell.word,
            (None, Acceptance::Required) => MatrixWord::Yes,
            (None, Acceptance::Rejected) => MatrixWord::No,
            (None, Acceptance::Observed) => MatrixWord::Open,
        },
        result: asserted_value(case),
        basis: &case.basis,
    }
}

/// Returns the results that cases assert of a conversion function. A basis that is no document names what it was, with product and version.
pub fn asserted_results(suite: &Suite, function: &str) -> Vec<AssertedResult> {
    let asserted = |case: &Case| {
        let (Some(Question::Call(call)), Some(value)) = (case.question.as_deref(), asserted_value(case))
        else {
            return None;
        };
        call.function
            .eq_ignore_ascii_case(function)
            .then(|| AssertedResult {
                dialect: case.dialect,
                operands: call.operands.clone(),
                value: value.clone(),
                basis: with_product(suite, &case.basis).into(),
            })
    };
    let of_systems = suite.cases.iter().filter(|case| is_of_its_system(case, suite));
    of_systems.filter_map(asserted).collect()
}

/// Returns whether the basis of a case speaks for the system of its dialect. What another system documents is no statement about this one.
fn is_of_its_system(case: &Case, suite: &Suite) -> bool {
    let source = suite.sources.of(&case.basis);
    source.is_none_or(|(source, section)| source.speaks_for(section, case.dialect))
}

/// Returns the value that a case asserts, if it asserts exactly one.
fn asserted_value(case: &Case) -> Option<&Value> {
    match &case.expectation.values[..] {
        [only] => Some(&only.value),
        _ => None,
    }
}

/// Returns a basis, with the product and version that its source recorded or measured.
fn with_product(suite: &Suite, basis: &str) -> String {
    match suite.sources.of(basis) {
        Some((source, section)) if matches!(source.kind, SourceKind::Recording | SourceKind::Measurement) => {
            format!("{basis} ({}: {})", source.kind.as_str(), source.read_of(section))
        }
        _ => basis.to_owned(),
    }
}

/// Returns a basis, with the publisher of a document who is not the maker.
pub fn attributed(suite: &Suite, basis: &str) -> String {
    match suite.sources.of(basis) {
        Some((source, _)) if source.kind == SourceKind::Document && !source.relation.is_maker() => {
            format!("{basis} ({}: {})", source.relation, source.publisher)
        }
        _ => basis.to_owned(),
    }
}

/// Returns the contradictions that are wanted, of the sources that speak for one of these dialects: the basis, and its statement.
pub fn contradictions(
    suite: &Suite,
    dialects: &[DialectName],
    is_wanted: impl Fn(&Contradiction) -> bool,
) -> Vec<String> {
    let told = suite.sources.iter().flat_map(|source| {
        let speaks = |told: &&Contradiction| dialects.iter().any(|of| source.speaks_for(&told.section, *of));
        let shown = source.contradicts.iter().filter(speaks);
        let shown = shown.filter(|told| is_wanted(told));
        shown.map(|told| format!("{}: {} {}", source.key, told.section, told.says))
    });
    told.collect()
}
