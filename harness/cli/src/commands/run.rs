//! `stickler run`: runs cases on engines, judges the outcomes, and writes the reports.

mod watch;

use crate::arguments::RunArguments;
use crate::case_folder::{self, CaseFolder, Loaded};
use crate::cause_stage::CauseStage;
use crate::documented::statements;
use crate::engines::NamedEngine;
use crate::exit::{self, Exit};
use crate::progress::Progress;
use crate::{baselines, caches, engines, interrupt, output, run_plan, shell};
use anyhow::bail;
use std::collections::BTreeMap;
use std::env;
use std::io::Write;
use std::path::PathBuf;
use std::time::Duration;
use stickler_causes::Search;
use stickler_conversions::overview::Statements;
use stickler_engines::{Engine, limit_programs};
use stickler_report::terminal::{self, Detail, Surroundings};
use stickler_report::{Overview, ReportError, Reports, annotations};
use stickler_run::{AnswerStore, Baseline, Event, Filter, Plan, RunError, RunSummary, is_asked, select};
use stickler_suite::{Case, Suite};
use stickler_types::{DialectName, sorted};
use stickler_workers::Cancellation;
use watch::CaseWatch;

/// Runs the selected cases, writes the reports, and shows a summary.
///
/// # Errors
/// A wrong command line, an engine that cannot be run, no case, or reports that cannot be written. All errors but a disk that
/// fills up are found before the first case.
pub fn execute(arguments: &RunArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    // An engine may take its time to start; the run itself ends in an orderly way.
    interrupt::at_once()?;
    if let Some(seconds) = arguments.timeout {
        limit_programs(Duration::from_secs(seconds));
    }
    let engines = engines::by_names(&arguments.engine)?;
    let asked_for = asked_for(&engines);
    let lacks = engines::declared_lacks(&engines)?;
    let engines: Vec<&dyn Engine> = engines.iter().map(|named| named.engine.as_ref()).collect();
    let folder = CaseFolder::locate(arguments.selection.cases.as_deref())?;
    let plan = Plan {
        asked_for,
        baselines: baselines(arguments, &folder, &engines)?,
        lacks,
        ..plan(arguments)
    };
    if arguments.watch && folder.is_carried {
        bail!("the cases inside the program do not change; name a folder of cases with --cases DIR");
    }
    let caches = match arguments.no_cache || arguments.no_report {
        true => Vec::new(),
        false => caches::open(&folder.root.join("reports").join("cache"), &engines),
    };
    let stores = caches::stores(&caches);
    let exit = run(arguments, &folder, &plan, &engines, &stores, out);
    caches::report_problems(&caches);
    let exit = exit?;
    if !arguments.watch || exit == Exit::Interrupted {
        return Ok(exit);
    }
    let watch = CaseWatch {
        folder: &folder,
        plan: Plan {
            baselines: Vec::new(),
            ..plan
        },
        engines: &engines,
        stores: &stores,
        failures: arguments.failures,
        cancel: interrupt::cancellation_ending_engines()?,
    };
    let exit = watch.watch(out);
    caches::report_problems(&caches);
    exit
}

/// Runs the cases once.
///
/// # Errors
/// As [`execute`].
fn run(
    arguments: &RunArguments,
    folder: &CaseFolder,
    plan: &Plan,
    engines: &[&dyn Engine],
    stores: &[Option<&dyn AnswerStore>],
    out: &mut dyn Write,
) -> anyhow::Result<Exit> {
    let Loaded { suite, defined, .. } = folder.load_for(plan, &spoken(engines))?;
    let plan = &Plan {
        defined,
        ..plan.clone()
    };
    let selected = select(plan, &suite.cases);
    if selected.is_empty() {
        let whole = folder.load_whole(plan);
        let beside = select(plan, &whole.cases);
        if !beside.is_empty() {
            understood(plan, &beside, engines)?;
        }
        return Ok(case_folder::nothing_selected(plan, &whole));
    }
    understood(plan, &selected, engines)?;
    note_filters_without_cases(plan, &suite);
    begun(&selected, engines, &suite)?;
    let report_folder =
        (!arguments.no_report).then(|| run_plan::report_folder(arguments.report.as_deref(), &folder.root));
    let cancel = interrupt::cancellation_ending_engines()?;
    let stated = match &report_folder {
        Some(_) => statements(&selected, &suite, folder),
        None => Statements::default(),
    };
    let mut sink = EventSink {
        reports: Reports::create(report_folder.as_deref(), stated, arguments.prose)?,
        shows_progress: !arguments.quiet,
        progress: None,
        cancel,
    };
    let mut causes = CauseStage::new(arguments, plan, engines);
    let take = &mut |event| causes.pass(event, &mut |event| sink.take(&event));
    let summary = stickler_run::run_with(plan, &suite, engines, stores, take, cancel);
    let search = Search {
        plan,
        suite: &suite,
        engines,
        stores,
        limits: causes.limits(),
        cancel,
    };
    causes.finish(&search, &mut |event| sink.take(&event));
    let overview = sink.finish()?;
    if annotates(arguments) {
        annotations::write_github(&overview, out)?;
    }
    let shown = report_folder.map(|folder| folder.display().to_string());
    let around = Surroundings {
        reports: shown.as_deref(),
        failures: arguments.failures,
        detail: detail(arguments),
        width: output::width(),
        from_cache: summary.as_ref().map_or(0, |summary| summary.from_cache),
    };
    terminal::write(out, &overview, around)?;
    let exit = exit(&summary?).max(case_folder::exit_of(&suite));
    // The process is about to end, and freeing hundreds of thousands of cases one by one takes it a while.
    std::mem::forget(suite);
    Ok(exit)
}

fn detail(arguments: &RunArguments) -> Detail {
    match (arguments.quiet, arguments.verbose) {
        (true, _) => Detail::Result,
        (false, true) => Detail::Whole,
        (false, false) => Detail::Summary,
    }
}

/// Returns whether unexpected results are written as annotations of GitHub, whose jobs have a variable that says so.
fn annotates(arguments: &RunArguments) -> bool {
    let in_job = || env::var_os("GITHUB_ACTIONS").is_some_and(|value| value == "true");
    arguments.annotate.unwrap_or_else(in_job)
}

/// Returns the dialects that any of the engines speaks.
fn spoken(engines: &[&dyn Engine]) -> Vec<DialectName> {
    let every = DialectName::ALL.into_iter().chain(DialectName::defined());
    let is_spoken = |dialect: &DialectName| {
        let mut engines = engines.iter();
        engines.any(|engine| engine.identity().asked_in(*dialect).is_some())
    };
    every.filter(is_spoken).collect()
}

/// Notes each of several filters that fits no case: it is most probably mistyped.
fn note_filters_without_cases(plan: &Plan, suite: &Suite) {
    for filter in plan.filters.iter().filter(|_| plan.filters.len() > 1) {
        let alone = Plan {
            filters: vec![filter.clone()],
            shard: None,
            ..plan.clone()
        };
        if select(&alone, &suite.cases).is_empty() {
            let text = shell::quote(filter.as_str());
            eprintln!("note: --filter {text} fits no case of these dialects");
        }
    }
}

/// # Errors
/// Engines that speak the dialect of no case: then there is no run that could be reported.
fn understood(plan: &Plan, cases: &[&Case], engines: &[&dyn Engine]) -> anyhow::Result<()> {
    let dialects = sorted(cases.iter().map(|case| case.dialect));
    let mut failed = None;
    for engine in engines {
        match engines::spoken(engine.identity(), &dialects) {
            Ok(_) => return Ok(()),
            Err(error) => failed = failed.or(Some(error)),
        }
    }
    let filters = case_folder::options("--filter", plan.filters.iter().map(Filter::as_str));
    match failed {
        Some(error) if !filters.is_empty() => {
            Err(error.context(format!("{filters} fits no case of its dialects")))
        }
        Some(error) => Err(error),
        None => Ok(()),
    }
}

/// # Errors
/// Engines whose versions are earlier than those with which the claims of all cases begin.
fn begun(cases: &[&Case], engines: &[&dyn Engine], suite: &Suite) -> anyhow::Result<()> {
    let mut asked = engines
        .iter()
        .map(|engine| cases.iter().any(|case| is_asked(case, engine.identity(), suite)));
    match asked.any(|is_any| is_any) {
        true => Ok(()),
        false => Err(anyhow::Error::new(RunError::NoCaseSelected)
            .context("the claims of all that is asked for begin with a later version of the engine")),
    }
}

/// Returns, by the name of each engine, the argument of `--engine` that names it again, quoted for a shell.
fn asked_for(engines: &[NamedEngine]) -> BTreeMap<String, String> {
    let entry = |named: &NamedEngine| {
        let name = named.identity().name.clone();
        (name, shell::quote(&named.asked_for).into_owned())
    };
    engines.iter().map(entry).collect()
}

/// Loads the baselines of the engines, unless the command line excludes them.
///
/// # Errors
/// A baseline that [`baselines::load`] cannot read.
fn baselines(
    arguments: &RunArguments,
    folder: &CaseFolder,
    engines: &[&dyn Engine],
) -> anyhow::Result<Vec<Baseline>> {
    if arguments.no_baseline {
        return Ok(Vec::new());
    }
    let names: Vec<&str> = engines
        .iter()
        .map(|engine| engine.identity().name.as_str())
        .collect();
    baselines::load(&arguments.baseline, &folder.root, &names)
}

fn plan(arguments: &RunArguments) -> Plan {
    let mut plan = run_plan::plan(&arguments.selection, arguments.shard);
    plan.rerun_prefix.push_str(&judged_alike(arguments));
    Plan {
        jobs: arguments.jobs.map_or(0, usize::from),
        unpacked: arguments.unpacked,
        strict: arguments.strict,
        strict_rules: arguments.strict_rules,
        ..plan
    }
}

/// Returns the options with which a rerun of a case is judged in the same way.
fn judged_alike(arguments: &RunArguments) -> String {
    let options = [
        arguments
            .strict
            .map(|grade| format!(" --strict {}", grade.as_str())),
        arguments.timeout.map(|seconds| format!(" --timeout {seconds}")),
        arguments.strict_rules.then(|| " --strict-rules".to_owned()),
        arguments.no_baseline.then(|| " --no-baseline".to_owned()),
    ];
    let baseline = |file: &PathBuf| format!(" --baseline {}", shell::quote(&file.to_string_lossy()));
    let baselines = arguments.baseline.iter().map(baseline);
    options.into_iter().flatten().chain(baselines).collect()
}

/// The receiver of the events of a run, which passes them to every report.
struct EventSink<'c> {
    reports: Reports,
    shows_progress: bool,
    progress: Option<Progress>,
    cancel: &'c Cancellation,
}

impl EventSink<'_> {
    fn take(&mut self, event: &Event) {
        let is_reported = self.reports.take(event);
        match event {
            Event::Header(header) => {
                self.progress = self.shows_progress.then(|| Progress::new(header.cases));
            }
            Event::Case(_) => self
                .progress
                .iter()
                .for_each(|bar| bar.advance(self.reports.overview().failed)),
            Event::Cause(_) | Event::Footer(_) => {}
        }
        if !is_reported && !self.cancel.is_requested() {
            // Further results could not be reported.
            self.cancel.request();
            stickler_engines::stop_all_processes();
        }
    }

    /// Completes the reports.
    fn finish(self) -> Result<Overview, ReportError> {
        self.progress.iter().for_each(Progress::finish);
        self.reports.finish()
    }
}

fn exit(summary: &RunSummary) -> Exit {
    if summary.cancelled {
        return Exit::Interrupted;
    }
    exit::of_totals(&summary.totals, summary.outdated > 0 || summary.lacking > 0)
}
