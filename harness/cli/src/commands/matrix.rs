//! `stickler matrix`: shows which types convert implicitly, by the documents and by engines.

use crate::arguments::{MatrixArguments, SelectionArguments, named_or_all};
use crate::case_folder::{self, CaseFolder, Loaded};
use crate::engines::NamedEngine;
use crate::exit::Exit;
use crate::matrix_table::{DialectMatrix, Documents, EngineAnswers};
use crate::progress::Progress;
use crate::{documented, engines, interrupt, run_plan, shell};
use std::io::{self, Write};
use std::sync::Arc;
use stickler_conversions::implicit;
use stickler_conversions::recording::{Recording, pairs};
use stickler_export::{Questions, answer_word};
use stickler_suite::Case;
use stickler_types::{DialectName, ElementaryType, MatrixWord, Question, TypePair};

/// The types that are shown only where a document speaks of them. Basis: implicit-conversion-table, its rows and columns.
const FURTHER: [ElementaryType; 7] = [
    ElementaryType::Ltime,
    ElementaryType::Ldate,
    ElementaryType::Ltod,
    ElementaryType::Ldt,
    ElementaryType::Wstring,
    ElementaryType::Char,
    ElementaryType::Wchar,
];

/// Shows one table for each dialect, with all engines that speak it; as JSON the questions with all answers.
///
/// # Errors
/// No folder of cases, or an engine that cannot be run or speaks none of the dialects.
pub fn execute(arguments: &MatrixArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let selection = SelectionArguments {
        cases: arguments.cases.clone(),
        dialect: arguments.dialect.clone(),
        ..SelectionArguments::default()
    };
    let folder = CaseFolder::locate(arguments.cases.as_deref())?;
    // No document speaks of the pairs that a dialect of stickler.toml does not inherit.
    let plan = run_plan::plan(&selection, None);
    let Loaded { suite, .. } = folder.load_implicit_for(&plan)?;
    interrupt::at_once()?;
    let engines = engines::by_names(&arguments.engine)?;
    let recordings: Vec<Recording> = match arguments.recorded || arguments.engine.is_empty() {
        true => folder.usable_recordings()?,
        false => Vec::new(),
    };
    let mut exit = case_folder::exit_of(&suite);
    if !suite.cases.iter().any(|case| implicit_word(case).is_some()) {
        return Ok(case_folder::nothing_selected(&plan, &folder.load_whole(&plan)));
    }
    let asked = named_or_all(&arguments.dialect, &DialectName::ALL);
    for named in &engines {
        engines::spoken(named.identity(), asked)?;
    }
    let cases = suite.cases.iter().filter(|case| asked.contains(&case.dialect));
    let statements = documented::builder(&cases.collect::<Vec<_>>(), &suite, &[]);
    let mut questions = (arguments.json).then(|| Questions::gather(&suite.sources, &statements, &recordings));
    for dialect in asked {
        let speaking = engines.iter().filter(|named| named.identity().speaks(*dialect));
        let speaking: Vec<&NamedEngine> = speaking.collect();
        let recorded = recordings.iter();
        let recorded: Vec<&Recording> = recorded
            .filter(|recording| recording.dialects.contains(dialect))
            .collect();
        if speaking.is_empty() && recorded.is_empty() {
            continue;
        }
        let mut matrix = gather(*dialect, documents(&suite.cases, *dialect), &speaking)?;
        if let Some(questions) = &mut questions {
            add_answers(questions, &matrix, &speaking);
        }
        matrix.add_recorded(&recorded);
        if questions.is_none() {
            matrix.write(out)?;
            // The next table may take a compiler a minute.
            out.flush()?;
        }
        if matrix.differs() {
            exit = exit.max(Exit::Failures);
        }
    }
    match questions {
        Some(questions) => writeln!(out, "{}", serde_json::to_string_pretty(&questions)?)?,
        None => legend(&engines, &recordings, out)?,
    }
    Ok(exit)
}

/// Adds the answers of engines to what documents and recordings say, as `stickler data` has it.
fn add_answers(questions: &mut Questions, matrix: &DialectMatrix, engines: &[&NamedEngine]) {
    for (column, named) in matrix.engines.iter().zip(engines) {
        let (kind, source) = (engines::kind(named.identity()), engines::source(named.identity()));
        for (pair, answer) in &column.answers {
            let question = Question::Implicit(*pair).to_string();
            questions.add(
                question,
                matrix.dialect,
                answer_word(*answer),
                (kind, Some(&source)),
            );
        }
    }
}

/// Returns the pair of types of which a cell of a matrix asks whether they convert implicitly, and the word of the documents.
fn implicit_word(case: &Case) -> Option<(TypePair, MatrixWord)> {
    match (case.question.as_deref(), &case.cell) {
        (Some(Question::Implicit(pair)), Some(cell)) => Some((*pair, cell.word)),
        _ => None,
    }
}

fn documents(cases: &[Case], dialect: DialectName) -> Documents {
    let cases = cases.iter().filter(|case| case.dialect == dialect);
    let of_case = |case: &Case| {
        let (pair, word) = implicit_word(case)?;
        Some((pair, (word, Arc::clone(&case.basis))))
    };
    cases.filter_map(of_case).collect()
}

/// Asks each engine for every pair of the types that are shown.
///
/// # Errors
/// An engine that cannot be started.
fn gather(
    dialect: DialectName,
    documents: Documents,
    engines: &[&NamedEngine],
) -> anyhow::Result<DialectMatrix> {
    let named = |ty: &ElementaryType| documents.keys().any(|(row, column)| row == ty || column == ty);
    let types: Vec<ElementaryType> = ElementaryType::ALL
        .into_iter()
        .filter(|ty| !FURTHER.contains(ty) || named(ty))
        .collect();
    let pairs = pairs(&types);
    let bar = Progress::new((pairs.len() * engines.len()) as u64);
    let mut columns = Vec::with_capacity(engines.len());
    for named in engines {
        let answers = implicit::answers(named.engine.as_ref(), dialect, &pairs, 0, &|| bar.advance(0))?;
        columns.push(EngineAnswers {
            engine: named.identity().name.clone(),
            recorded: None,
            answers: pairs.iter().copied().zip(answers).collect(),
        });
    }
    bar.finish();
    Ok(DialectMatrix {
        dialect,
        types,
        documents,
        engines: columns,
    })
}

fn legend(engines: &[NamedEngine], recordings: &[Recording], out: &mut dyn Write) -> io::Result<()> {
    let (answers, differ) = match engines {
        [named] if recordings.is_empty() => (format!("engine ({})", named.identity().name), "they differ"),
        _ => ("engines, as above".to_owned(), "one differs"),
    };
    let legend = include_str!("matrix/legend.txt");
    write!(
        out,
        "{}",
        legend.replace("{engines}", &answers).replace("{differ}", differ)
    )?;
    if engines.len() > 1 {
        let asked = engines
            .iter()
            .map(|named| format!(" --engine {}", shell::quote(&named.asked_for)));
        writeln!(
            out,
            "What a conversion function gives on each: {} conversions REAL_TO_INT{}",
            shell::program(),
            asked.collect::<String>()
        )?;
    }
    Ok(())
}
