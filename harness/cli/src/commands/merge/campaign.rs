//! Merges the findings of the parts of a campaign.

use crate::arguments::MergeArguments;
use crate::exit::Exit;
use crate::output;
use std::io::Write;
use stickler_campaign::{Merged, Record, Store, merge};

/// Merges the findings of all parts into one folder. Names the parts that are missing or were cut short; the exit code is then 2,
/// since the findings are incomplete.
///
/// # Errors
/// A folder that cannot be written.
pub fn execute(arguments: &MergeArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let Merged {
        findings,
        campaigns,
        missing,
    } = merge(&arguments.folders);
    let store = Store::open(&arguments.output)?;
    for finding in findings.values() {
        store.save(finding)?;
    }
    if let [campaign] = &campaigns[..] {
        campaign.write(store.folder())?;
    }
    for Record {
        asked,
        programs,
        disagreements,
        ..
    } in &campaigns
    {
        writeln!(
            out,
            "seed {}: {programs} programs, {disagreements} disagreements",
            asked.seed
        )?;
    }
    for sentence in &missing {
        output::note(sentence);
    }
    let number = findings.len();
    let noun = if number == 1 { "finding" } else { "findings" };
    writeln!(out, "{number} {noun} in {}", store.folder().display())?;
    for finding in findings.values() {
        writeln!(
            out,
            "  {}  {} {}: {}",
            finding.id,
            finding.origin.size,
            finding.unit(),
            first_line(&finding.message)
        )?;
    }
    let found = Exit::Failures.when(!findings.is_empty());
    Ok(found.worst(Exit::Usage.when(!missing.is_empty())))
}

fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}
