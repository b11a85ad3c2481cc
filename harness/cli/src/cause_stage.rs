//! The search for causes after the cases of a run: holds the footer of the run back until they are found.

use crate::arguments::RunArguments;
use crate::output;
use crate::progress::bar;
use indicatif::ProgressBar;
use std::time::{Duration, Instant};
use stickler_causes::{FailedCases, Search, SearchLimits, find};
use stickler_engines::Engine;
use stickler_run::{Event, Footer, Plan};
use stickler_types::counted;

/// The part of a run between its last case and its footer.
pub struct CauseStage<'r> {
    failed: FailedCases<'r>,
    limits: Option<SearchLimits>,
    shows_progress: bool,
    footer: Option<Footer>,
}

impl<'r> CauseStage<'r> {
    /// Prepares the search; with `--no-causes` there is none.
    pub fn new(arguments: &RunArguments, plan: &'r Plan, engines: &[&'r dyn Engine]) -> CauseStage<'r> {
        let mut limits = SearchLimits::default();
        if let Some(minutes) = arguments.cause_time {
            limits.time = Duration::from_secs(minutes * 60);
        }
        CauseStage {
            failed: FailedCases::new(plan, engines),
            limits: (!arguments.no_causes).then_some(limits),
            shows_progress: !arguments.quiet,
            footer: None,
        }
    }

    /// Returns the limits of the search.
    pub fn limits(&self) -> SearchLimits {
        self.limits.unwrap_or_default()
    }

    /// Takes an event of the run and passes it on, unless it is the footer.
    pub fn pass(&mut self, event: Event, sink: &mut dyn FnMut(Event)) {
        if self.limits.is_some() {
            self.failed.take(&event);
        }
        match event {
            Event::Footer(footer) => self.footer = Some(footer),
            event => sink(event),
        }
    }

    /// Searches for the causes of what failed, and passes them on, and the footer behind them. A run that was cut short has
    /// neither. An engine that cannot be asked any more leaves no causes, which is said on stderr.
    pub fn finish(self, search: &Search<'_>, sink: &mut dyn FnMut(Event)) {
        let Some(mut footer) = self.footer else { return };
        let begun = Instant::now();
        if self.limits.is_some() && !self.failed.is_empty() {
            let bar = self.shows_progress.then(|| {
                let template = "{wide_bar} {human_pos}/{human_len} {elapsed}, looking for causes";
                bar(Some(0), template)
            });
            let found = find(&self.failed, search, &mut |reported| {
                if let Some(bar) = &bar {
                    bar.set_length(reported.of);
                    bar.set_position(reported.done);
                }
            });
            bar.iter().for_each(ProgressBar::finish_and_clear);
            let causes = found.unwrap_or_else(|error| {
                output::note(format!("the causes could not be searched for: {error}"));
                Vec::new()
            });
            let left = causes.iter().filter(|cause| cause.is_partly_reduced()).count() as u64;
            if left > 0 {
                let programs = counted(left, "program", "programs");
                output::note(format!(
                    "the search for causes ended before {programs} could be made as small as possible; --cause-time N allows more"
                ));
            }
            causes.into_iter().for_each(|cause| sink(Event::Cause(cause)));
            footer.causes_ms = u64::try_from(begun.elapsed().as_millis()).ok();
        }
        sink(Event::Footer(footer));
    }
}
