//! The counts and findings of a campaign.

use super::{CampaignEnd, CampaignProgress, CampaignSummary};
use crate::finding::{Confirmation, Finding};
use crate::oracle::{InputVerdict, Mismatch};
use crate::plan::is_reduced;
use std::collections::BTreeMap;
use std::time::Duration;

/// The counts and findings of a campaign. Verdicts are entered in the order of their places.
#[derive(Default)]
pub(super) struct Ledger {
    summary: CampaignSummary,
    /// The number of mismatches that were given out to be reduced, by subject and symptom.
    reduced: BTreeMap<(String, String), u64>,
}

impl Ledger {
    /// Counts a verdict, and returns those of its mismatches that are to be reduced.
    pub(super) fn enter(&mut self, verdict: InputVerdict) -> Vec<Mismatch> {
        self.summary.programs += 1;
        self.summary.deaths += verdict.deaths;
        if let Some(word) = verdict.passed_over {
            *self.summary.passed_over.entry(word).or_default() += 1;
        }
        let mut reduced = Vec::new();
        for mismatch in verdict.mismatches {
            let number = self.summary.disagreements.entry(key(&mismatch)).or_default();
            *number += 1;
            if is_reduced(*number) {
                reduced.push(mismatch);
            } else {
                self.summary.left += 1;
            }
        }
        reduced
    }

    /// Takes a finding. Returns it where it is new, or better than the earlier one of its name.
    pub(super) fn found(&mut self, finding: Finding) -> Option<&Finding> {
        let id = finding.id.clone();
        *self.summary.times.entry(id.clone()).or_default() += 1;
        let findings = &mut self.summary.findings;
        if findings.get(&id).is_some_and(|known| !finding.improves_on(known)) {
            return None;
        }
        findings.insert(id.clone(), finding);
        findings.get(&id)
    }

    /// Returns whether a finding that was confirmed probably has the cause of a mismatch.
    pub(super) fn explains(&self, mismatch: &Mismatch) -> bool {
        let mut findings = self.summary.findings.values();
        findings
            .any(|finding| finding.standing == Confirmation::Confirmed && mismatch.is_explained_by(finding))
    }

    /// Notes that a mismatch is given out to be reduced.
    pub(super) fn reduces(&mut self, mismatch: &Mismatch) {
        *self.reduced.entry(key(mismatch)).or_default() += 1;
    }

    /// Returns the number of mismatches with the same symptom that were given out to be reduced.
    pub(super) fn reduced(&self, mismatch: &Mismatch) -> u64 {
        self.reduced.get(&key(mismatch)).copied().unwrap_or(0)
    }

    /// Counts disagreements that are not reduced.
    pub(super) fn leave(&mut self, number: usize) {
        self.summary.left += number as u64;
    }

    /// Notes that an engine can no longer be used.
    pub(super) fn lost(&mut self, reason: String) {
        if self.summary.ended == CampaignEnd::Done {
            self.summary.ended = CampaignEnd::Lost(reason);
        }
    }

    /// Returns the progress of the campaign.
    pub(super) fn progress(&self) -> CampaignProgress {
        CampaignProgress {
            programs: self.summary.programs,
            disagreements: self.summary.disagreements.values().sum(),
            findings: self.summary.findings.len() as u64,
        }
    }

    /// Returns the result of the campaign.
    pub(super) fn summary(self, elapsed: Duration, interrupted: bool) -> CampaignSummary {
        let ended = match self.summary.ended {
            CampaignEnd::Done if interrupted => CampaignEnd::Interrupted,
            ended => ended,
        };
        CampaignSummary {
            ended,
            elapsed,
            ..self.summary
        }
    }
}

fn key(mismatch: &Mismatch) -> (String, String) {
    (mismatch.subject.clone(), mismatch.symptom.clone())
}
