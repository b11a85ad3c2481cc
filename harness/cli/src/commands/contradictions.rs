//! `stickler contradictions`: where sources give different answers to one question.

use crate::arguments::ContradictionsArguments;
use crate::case_folder::{self, CaseFolder};
use crate::contradicted;
use crate::exit::Exit;
use crate::output;
use std::io::Write;
use stickler_conversions::contradictions::AskedQuestion;

/// The maximum number of topics that are shown where not all are asked for.
const MAX_TOPICS: usize = 40;

/// Shows the contradictions of documents, recordings and measurements, the largest first. Asks no engine.
///
/// # Errors
/// No folder of cases, or recordings that cannot be read.
pub fn execute(arguments: &ContradictionsArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let folder = CaseFolder::locate(arguments.cases.as_deref())?;
    let suite = folder.load_with([]);
    let words: Vec<String> = arguments.words.iter().map(|word| word.to_lowercase()).collect();
    let is_wanted = |asked: &AskedQuestion| {
        let AskedQuestion {
            text,
            kind,
            case,
            program,
        } = asked;
        let (case, program) = (
            case.as_deref().unwrap_or_default(),
            program.as_deref().unwrap_or_default(),
        );
        let all = format!("{text}\n{kind}\n{case}\n{program}").to_lowercase();
        words.iter().all(|word| all.contains(word))
    };
    let cases: Vec<_> = suite.cases.iter().collect();
    let mut found = contradicted::gather(&cases, &suite, &folder.usable_recordings()?).finish(is_wanted);
    if !arguments.all {
        found.keep(MAX_TOPICS);
    }
    if arguments.json {
        serde_json::to_writer(&mut *out, &found)?;
        writeln!(out)?;
    } else {
        found.write(out)?;
        if found.topics.len() < found.number {
            output::note(
                "--all shows every contradiction, and a word such as REAL_TO_INT those of one function",
            );
        }
    }
    Ok(case_folder::exit_of(&suite))
}
