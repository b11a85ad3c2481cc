//! `stickler contradictions`: where sources give different answers to one question.

use crate::arguments::ContradictionsArguments;
use crate::case_folder::{self, CaseFolder};
use crate::contradicted;
use crate::exit::Exit;
use crate::output;
use std::io::Write;
use stickler_conversions::contradictions::AskedQuestion;

/// Shows the contradictions of documents, recordings and measurements, the largest first. Asks no engine.
///
/// # Errors
/// No folder of cases, or recordings that cannot be read.
pub fn execute(arguments: &ContradictionsArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let folder = CaseFolder::locate(arguments.cases.as_deref())?;
    let suite = folder.load_with([]);
    let words: Vec<String> = arguments.words.iter().map(|word| word.to_lowercase()).collect();
    let is_wanted = |asked: &AskedQuestion| {
        let of_case = [&asked.case, &asked.program].map(|text| text.as_deref().unwrap_or_default());
        let all = [&asked.text, &*asked.kind, of_case[0], of_case[1]]
            .join("\n")
            .to_lowercase();
        words.iter().all(|word| all.contains(word))
    };
    let cases: Vec<_> = suite.cases.iter().collect();
    let most = if arguments.all { usize::MAX } else { 40 };
    let found = contradicted::gather(&cases, &suite, &folder.usable_recordings()?).finish(most, is_wanted);
    if found.number == 0 && !words.is_empty() && !arguments.json {
        output::note("no question on which sources differ has all of these words");
    }
    if arguments.json {
        output::json_line(out, &found)?;
    } else {
        found.write(out)?;
    }
    Ok(case_folder::exit_of(&suite))
}
