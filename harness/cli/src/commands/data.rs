//! `stickler data`: writes what systems have and do as one JSON file, and as packages.

use crate::arguments::DataArguments;
use crate::case_folder::{self, CaseFolder};
use crate::documented;
use crate::exit::Exit;
use std::io::Write;
use stickler_export::{DATA, SupportData, write_data};
use stickler_suite::Case;
use stickler_types::{DialectName, counted};

/// Writes the data of all systems, or of those that are named.
///
/// # Errors
/// A folder that holds other files, or cannot be written; no folder of cases.
pub fn execute(arguments: &DataArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let folder = CaseFolder::locate(arguments.cases.as_deref())?;
    let suite = folder.load_with(arguments.dialect.iter().copied());
    let (all, asked) = (arguments.dialect.is_empty(), &arguments.dialect);
    let is_wanted = |case: &&Case| all || asked.contains(&case.dialect);
    let cases: Vec<&Case> = suite.cases.iter().filter(is_wanted).collect();
    let mut statements = documented::builder(&cases, &suite, if all { &DialectName::ALL } else { asked });
    statements.add_all_functions();
    let recordings = folder.usable_recordings()?;
    let data = SupportData::gather(&suite, &statements, &recordings);
    write_data(&data, &arguments.folder)?;
    let systems = counted(statements.dialects().len() as u64, "system", "systems");
    let questions = counted(data.questions() as u64, "question", "questions");
    let folder = arguments.folder.display();
    writeln!(
        out,
        "{folder}: {systems} and {questions} in {DATA}; packages in npm and pypi"
    )?;
    Ok(case_folder::exit_of(&suite))
}
