//! `stickler conversions`: the results of one conversion function, dialects side by side.

use crate::arguments::ConversionsArguments;
use crate::case_folder::CaseFolder;
use crate::documented;
use crate::engines::{self, NamedEngine, REFERENCE};
use crate::exit::Exit;
use crate::interrupt;
use crate::output;
use std::io::Write;
use stickler_conversions::overview::{
    self, AnswerSource, AssertedResult, CallOperands, OverviewPage, SignatureResults,
};
use stickler_conversions::recording::Recording;
use stickler_conversions::{FunctionDialects, NoSuchFunction, all_functions, find_function};
use stickler_engines::Identity;
use stickler_exact::Signature;
use stickler_export::{Kind, Questions, call_question};
use stickler_suite::{SourceKind, Suite};
use stickler_types::{Contradiction, DialectName, PrintedResult, distinct, wrap};

/// Shows the results of a function for boundary values, or for the given values; lists the functions where none is named.
/// Each result comes from a program that runs on an engine, and is compared with the documents.
///
/// # Errors
/// A name that is no conversion function, a value that does not fit, an engine that cannot be run, a named folder of cases that is not there.
pub fn execute(arguments: &ConversionsArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let Some(function) = &arguments.function else {
        all_functions()
            .iter()
            .try_for_each(|name| writeln!(out, "{name}"))?;
        return Ok(Exit::AsExpected);
    };
    let function = function.to_ascii_uppercase();
    let known = known(arguments, &function)?;
    let found = find_function(&function, &arguments.dialect, stickler_exact::signatures);
    let is_printed = !known.printed.is_empty() && !arguments.json;
    if matches!(found, Err(NoSuchFunction::Anywhere { .. })) && is_printed {
        let page = OverviewPage {
            results: &[],
            printed: &known.printed,
            lacking: &[],
            engines: &[],
            only_reference: true,
            attributed: &|basis| documented::attributed(&known.suite, basis),
        };
        page.write(out)?;
        return Ok(Exit::AsExpected);
    }
    let FunctionDialects { having, lacking } = found?;
    let mut calls = overview::calls(&arguments.values, signatures(&function, &having))?;
    interrupt::at_once()?;
    let engines = engines::by_names(&arguments.engine)?;
    if arguments.values.is_empty() {
        add_documented(&mut calls, &known);
    }
    let Known {
        suite,
        asserted,
        recordings,
        printed,
    } = known;
    let recorded: Vec<Identity> = recordings.iter().map(Recording::identity).collect();
    let mut asked = Vec::with_capacity(engines.len() + recordings.len());
    for named in &engines {
        let dialects = engines::spoken(named.identity(), &having)?;
        asked.push((AnswerSource::Engine(named.engine.as_ref()), dialects));
    }
    for recording in &recordings {
        let dialects = having.iter().copied();
        let dialects = dialects.filter(|dialect| recording.dialects.contains(dialect));
        asked.push((AnswerSource::Recording(recording), dialects.collect()));
    }
    let results = overview::gather(calls, &asked, &asserted)?;
    let identities: Vec<_> = engines
        .iter()
        .map(NamedEngine::identity)
        .chain(&recorded)
        .collect();
    if arguments.json {
        let questions = questions(&results, &identities, engines.len(), &suite);
        writeln!(out, "{}", serde_json::to_string_pretty(&questions)?)?;
    } else {
        let page = OverviewPage {
            results: &results,
            printed: &printed,
            lacking: &lacking,
            engines: &identities,
            only_reference: engines.iter().all(|named| named.asked_for == REFERENCE),
            attributed: &|basis| documented::attributed(&suite, basis),
        };
        page.write(out)?;
        let names = |text: &String| text.trim_matches(['(', ',']).eq_ignore_ascii_case(&function);
        let is_of_function = |told: &Contradiction| told.only.iter().any(names);
        for told in documented::contradictions(&suite, &having, is_of_function) {
            writeln!(out, "\n{}", wrap(&format!("But {told}")))?;
        }
    }
    let contradict = results.iter().any(|results| results.contradict(engines.len()));
    Ok(Exit::Failures.when(contradict))
}

/// Returns the questions with what sources state and what engines give, of which the first `asked` are asked now and the others recorded.
fn questions(all: &[SignatureResults], identities: &[&Identity], asked: usize, suite: &Suite) -> Questions {
    let mut questions = Questions::default();
    for (results, column) in all
        .iter()
        .flat_map(|of| of.columns.iter().map(move |column| (of, column)))
    {
        let kind = match identities[column.engine] {
            _ if column.engine >= asked => Kind::Recorded,
            identity => engines::kind(identity),
        };
        let source = engines::source(identities[column.engine]);
        for (call, result) in results.calls.iter().zip(&column.results) {
            let question = call_question(&results.signature, call);
            questions.add_expected(&question, column.dialect, &result.expected, &suite.sources);
            questions.add_result(&question, column.dialect, &result.got, (kind, Some(&source)));
        }
    }
    questions
}

/// What the folder of cases holds on a function.
#[derive(Default)]
struct Known {
    /// The sources, and the cases that mention the function.
    suite: Suite,
    /// The results that cases assert.
    asserted: Vec<AssertedResult>,
    /// The recordings of compilers.
    recordings: Vec<Recording>,
    /// What sources print of it without a case.
    printed: Vec<PrintedResult>,
}

/// Returns what the folder of cases holds on a function, where there is one.
///
/// # Errors
/// A folder of cases that was named and is not there, or a recording that cannot be read.
fn known(arguments: &ConversionsArguments, function: &str) -> anyhow::Result<Known> {
    let Some(folder) = CaseFolder::locate_any(arguments.cases.as_deref())? else {
        output::note(
            "values that cases hold are not shown, for there is no folder of cases; name one with --cases DIR",
        );
        return Ok(Known::default());
    };
    let suite = folder.load_mentioning(&[function], &[]);
    let recordings = match arguments.recorded || arguments.engine.is_empty() {
        true => folder.usable_recordings()?,
        false => Vec::new(),
    };
    let is_asked = |printed: &&PrintedResult| printed.call.split('(').next() == Some(function);
    let printed = suite.sources.iter().flat_map(|source| &source.printed);
    Ok(Known {
        printed: printed.filter(is_asked).cloned().collect(),
        asserted: documented::asserted_results(&suite, function),
        suite,
        recordings,
    })
}

/// Adds the operands whose results documents print, in the dialects of which no source states a result of the others, so that they are shown
/// without being asked for.
fn add_documented(calls: &mut [(Signature, Vec<CallOperands>)], known: &Known) {
    for (signature, shown) in calls {
        let is_stated = |dialect, operands: &CallOperands| {
            let mut asserted = known.asserted.iter();
            asserted.any(|one| one.dialect == dialect && one.operands == *operands)
                || stickler_exact::expected(signature, operands, dialect)
                    .basis
                    .is_some()
        };
        let is_silent = |dialect| !shown.iter().any(|operands| is_stated(dialect, operands));
        let is_documented = |one: &&AssertedResult| {
            let source = known.suite.sources.of(&one.basis);
            source.is_some_and(|(source, _)| source.kind == SourceKind::Document)
        };
        let documented = known.asserted.iter().filter(is_documented);
        let printed: Vec<CallOperands> = documented
            .filter(|one| signature.takes(&one.operands) && is_silent(one.dialect))
            .map(|one| one.operands.clone())
            .collect();
        for operands in printed {
            if !shown.contains(&operands) {
                shown.push(operands);
            }
        }
    }
}

/// Returns every signature that one of the dialects has, each once.
fn signatures(function: &str, dialects: &[DialectName]) -> Vec<Signature> {
    let signatures = |dialect: &DialectName| stickler_exact::signatures(function, *dialect);
    distinct(dialects.iter().flat_map(signatures))
}
