//! The progress bar of a campaign, on stderr and only where that is a terminal.

use crate::progress::bar;
use indicatif::{HumanCount, ProgressBar};
use std::time::{Duration, Instant};
use stickler_campaign::{CampaignPlan, CampaignSummary, Until};

/// A progress bar of the programs, or of the time, whichever ends the campaign.
pub struct FuzzBar {
    bar: ProgressBar,
    begun: Instant,
    /// Whether the bar counts programs; otherwise seconds.
    counts: bool,
}

impl FuzzBar {
    /// Makes the bar of a campaign.
    pub fn new(plan: &CampaignPlan) -> FuzzBar {
        let (length, counts) = match plan.until {
            Until::Count(count) => (plan.share().unwrap_or(count), true),
            Until::Time(time) => (time.as_secs(), false),
        };
        let template = if counts {
            "{wide_bar} {human_pos}/{human_len} {msg} {elapsed}"
        } else {
            "{wide_bar} {msg} {elapsed}"
        };
        FuzzBar {
            bar: bar(Some(length), template),
            begun: Instant::now(),
            counts,
        }
    }

    /// Shows the progress of the campaign.
    pub fn reach(&self, progress: &CampaignSummary) {
        let elapsed = self.begun.elapsed();
        let programs = HumanCount(progress.programs);
        let (position, total) = match self.counts {
            true => (progress.programs, String::new()),
            false => (elapsed.as_secs(), format!("{programs} programs, ")),
        };
        self.bar.set_position(position);
        let rate = HumanCount(rate(progress.programs, elapsed));
        let disagreements: u64 = progress.disagreements.values().sum();
        let findings = progress.findings.len();
        self.bar.set_message(format!(
            "{total}{rate}/s, {disagreements} disagreements, {findings} findings"
        ));
    }

    /// Removes the bar.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// Returns the number of programs per second.
pub fn rate(programs: u64, elapsed: Duration) -> u64 {
    let milliseconds = u64::try_from(elapsed.as_millis()).unwrap_or(u64::MAX).max(1);
    programs.saturating_mul(1000) / milliseconds
}
