//! Stores findings as soon as they are found, and keeps them in memory where the folder cannot be written.

use crate::exit::Exit;
use crate::output;
use std::collections::BTreeMap;
use stickler_campaign::record::FORMAT;
use stickler_campaign::{
    CampaignEnd, CampaignRequest, CampaignSummary, FailingPart, Finding, Record, Store, StoreError,
};
use stickler_workers::Shard;

/// The storage of the findings of one campaign.
pub struct Keeper {
    store: Store,
    record: Record,
    /// The findings that could not be saved; saving is tried again at the end.
    unsaved: BTreeMap<String, Finding>,
}

/// The findings that could not be saved, and the reason.
pub struct Unsaved {
    /// The path of the folder, as it was named.
    pub folder: String,
    /// The findings that could not be saved.
    pub findings: Vec<Finding>,
    /// The reason; also present where only the record of the campaign could not be written.
    pub error: Option<StoreError>,
}

impl Keeper {
    /// Writes the record that a campaign has begun.
    ///
    /// # Errors
    /// [`StoreError`] where the folder cannot be written.
    pub fn begin(
        store: Store,
        asked: CampaignRequest,
        failing: Vec<FailingPart>,
        shard: Shard,
    ) -> Result<Keeper, StoreError> {
        let record = Record {
            format: FORMAT,
            stickler: env!("CARGO_PKG_VERSION").to_owned(),
            asked,
            part: shard.index(),
            parts: shard.count(),
            failing,
            ..Record::default()
        };
        record.write(store.folder())?;
        Ok(Keeper {
            store,
            record,
            unsaved: BTreeMap::new(),
        })
    }

    /// Saves a finding; reports a failure on stderr once and goes on.
    pub fn keep(&mut self, finding: &Finding) {
        match self.store.save(finding) {
            Ok(_) => {
                self.unsaved.remove(&finding.id);
            }
            Err(error) => {
                if self.unsaved.is_empty() {
                    output::note(format!(
                        "{error}; the campaign goes on, and what cannot be saved is shown at its end"
                    ));
                }
                self.unsaved.insert(finding.id.clone(), finding.clone());
            }
        }
    }

    /// Tries again to save the findings that could not be saved, and writes the record of the campaign's end.
    pub fn end(mut self, summary: &CampaignSummary) -> Unsaved {
        let mut error = None;
        let mut findings = Vec::new();
        for finding in std::mem::take(&mut self.unsaved).into_values() {
            if let Err(reason) = self.store.save(&finding) {
                error = Some(reason);
                findings.push(finding);
            }
        }
        self.record.complete = summary.ended == CampaignEnd::Done && findings.is_empty();
        self.record.programs = summary.programs;
        self.record.disagreements = summary.disagreements.values().sum();
        self.record.findings = summary.findings.keys().cloned().collect();
        if let Err(reason) = self.record.write(self.store.folder()) {
            error = error.or(Some(reason));
        }
        Unsaved {
            folder: self.store.folder().display().to_string(),
            findings,
            error,
        }
    }
}

impl Unsaved {
    /// Returns the exit code for findings that could not be saved.
    pub fn exit(&self) -> Exit {
        Exit::Usage.when(self.error.is_some())
    }
}
