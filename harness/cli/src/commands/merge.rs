//! `stickler merge`: merges the parts of a run, or of a campaign.

mod campaign;
mod run;

use crate::arguments::MergeArguments;
use crate::exit::Exit;
use anyhow::bail;
use std::io::Write;
use std::path::Path;
use stickler_campaign::Record;
use stickler_report::events;

/// Merges the parts of a run or of a campaign, depending on the contents of the folders.
///
/// # Errors
/// Folders of both kinds; a folder that cannot be written.
pub fn execute(arguments: &MergeArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let run = arguments.folders.iter().find(|folder| is_of_run(folder));
    let campaign = arguments
        .folders
        .iter()
        .find(|folder| !is_of_run(folder) && !matches!(Record::read(folder), Ok(None)));
    match (run, campaign) {
        (Some(run), Some(campaign)) => bail!(
            "{} is a part of a run and {} one of a campaign; only parts of one kind can be put together",
            run.display(),
            campaign.display()
        ),
        (Some(_), None) => run::execute(arguments, out),
        (None, _) => campaign::execute(arguments, out),
    }
}

/// Returns whether a path is a folder of a run's reports, or an event log.
fn is_of_run(path: &Path) -> bool {
    path.is_file() || path.join(events::NAME).exists()
}
