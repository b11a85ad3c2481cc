//! Writes imported answers as a recording.

use crate::arguments::ImportArguments;
use crate::commands::record;
use anyhow::bail;
use std::io::Write;
use std::path::PathBuf;
use stickler_conversions::recording::{Recording, RecordingBuilder};
use stickler_engines::Outcome;
use stickler_suite::Case;
use stickler_types::{DialectName, RecordingOrigin, counted};

/// Gathers the answers for the file that `--record` names.
pub struct Recorder {
    path: PathBuf,
    older: Option<Recording>,
    builder: RecordingBuilder,
    title: String,
    /// The number of cases that ask nothing of what a recording holds.
    others: u64,
}

impl Recorder {
    /// Begins a recording; `None` where none is wanted.
    ///
    /// # Errors
    /// A product, version, platform or date that says nothing, or a file that is another recording.
    pub fn begin(arguments: &ImportArguments, dialect: DialectName) -> anyhow::Result<Option<Recorder>> {
        let Some(path) = arguments.record.clone() else {
            return Ok(None);
        };
        let text = |given: &Option<String>| given.as_deref().unwrap_or_default().trim().to_owned();
        let mut origin = RecordingOrigin {
            product: text(&arguments.product),
            version: text(&arguments.product_version),
            commit: None,
            platform: text(&arguments.platform),
            date: arguments.date.clone().unwrap_or_else(record::today),
        };
        if let Some(mistake) = origin.mistake() {
            bail!("nothing can be recorded: {mistake}");
        }
        let older = record::older(&path, &origin)?;
        // The copied texts are of the same version, and do not tell its commit.
        origin.commit = older.as_ref().and_then(|older| older.origin.commit.clone());
        let name = path
            .file_stem()
            .map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
        Ok(Some(Recorder {
            older,
            title: format!("{} {}", origin.product, origin.version),
            builder: RecordingBuilder::new(&name, origin, dialect),
            path,
            others: 0,
        }))
    }

    /// Adds what the compiler did with a case.
    pub fn take(&mut self, case: &Case, outcome: &Outcome) {
        if !self.builder.take(&case.source, outcome) {
            self.others += 1;
        }
    }

    /// Writes the file, and shows what is in it.
    ///
    /// # Errors
    /// No answer at all, or a file that cannot be written.
    pub fn finish(self, out: &mut dyn Write) -> anyhow::Result<()> {
        let shown = self.path.display().to_string();
        if self.builder.number() == 0 {
            bail!(
                "{shown} is not written: no result tells what a recording holds; `stickler export --recording` asks for it"
            );
        }
        let answers = counted(self.builder.number() as u64, "answer", "answers");
        let mut recording = self.builder.finish();
        let added = match self.older {
            Some(older) => {
                recording.complete_from(older);
                ", added to those that it had"
            }
            None => "",
        };
        record::write(&recording, &self.path)?;
        writeln!(out, "{shown}: {answers} of {}{added}", self.title)?;
        if self.others > 0 {
            let others = counted(self.others, "case asks", "cases ask");
            writeln!(
                out,
                "  {others} nothing that a recording holds, or showed no value"
            )?;
        }
        Ok(())
    }
}
