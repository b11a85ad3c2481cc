//! The causes that a run of the suite found on the engines of a campaign: what the campaign finds of them is nothing new.

use super::reports_folder;
use crate::arguments::FuzzArguments;
use anyhow::Context;
use std::path::PathBuf;
use stickler_campaign::Finding;
use stickler_causes::CauseKey;
use stickler_report::events::{self, Reader};
use stickler_run::{Cause, Event};

/// The causes that a run of the suite found.
#[derive(Default)]
pub struct KnownCauses {
    /// The folder of the run; `None` where there was none.
    folder: Option<PathBuf>,
    /// The causes, each with the key of the program that shows it.
    causes: Vec<(Cause, CauseKey)>,
}

impl KnownCauses {
    /// Reads the causes from the run that the command line names, or else from the last run.
    ///
    /// # Errors
    /// A run that was named and cannot be read.
    pub fn read(arguments: &FuzzArguments) -> anyhow::Result<KnownCauses> {
        let folder = arguments
            .known
            .clone()
            .unwrap_or_else(|| reports_folder().join("latest"));
        match causes(&folder) {
            Ok(causes) => Ok(KnownCauses {
                folder: (arguments.known.is_some() || !causes.is_empty()).then_some(folder),
                causes,
            }),
            // Nobody asked for the last run.
            Err(_) if arguments.known.is_none() => Ok(KnownCauses::default()),
            Err(error) => Err(error).with_context(|| format!("cannot read the run in {}", folder.display())),
        }
    }

    /// Returns the folder of the run, if it has causes of these engines or was named.
    pub fn folder(&self) -> Option<String> {
        self.folder.as_ref().map(|folder| folder.display().to_string())
    }

    /// Returns the title of the cause that explains a finding: the engine does the same, and the finding needs the same constructs as the
    /// cause, or as the program that shows it.
    pub fn of(&self, finding: &Finding) -> Option<&str> {
        let found = finding.cause.as_ref()?;
        let mut causes = self.causes.iter();
        let is_shown = |key: &CauseKey| {
            found.symptom == key.symptom
                && found.constructs == key.constructs
                && key.labels.is_subset(&found.labels)
        };
        let explains = |(cause, key): &&(Cause, CauseKey)| {
            cause.engine == finding.subject()
                && (found.is_explained_by(&cause.symptom, &cause.construct) || is_shown(key))
        };
        causes.find(explains).map(|(cause, _)| cause.title.as_str())
    }
}

fn causes(folder: &std::path::Path) -> anyhow::Result<Vec<(Cause, CauseKey)>> {
    let mut causes = Vec::new();
    for event in Reader::open(&events::locate(folder))? {
        if let Event::Cause(cause) = event? {
            let key = CauseKey::of_shown(&cause);
            causes.push((cause, key));
        }
    }
    Ok(causes)
}
