//! `stickler fuzz`: runs a campaign, or judges one input again.

mod bar;
mod keeper;
mod known;
mod page;
mod replay;
mod survey;

use crate::arguments::{FuzzArguments, named_or_all};
use crate::case_folder::CaseFolder;
use crate::engines::{self, NamedEngine};
use crate::exit::Exit;
use crate::{interrupt, shell};
use bar::FuzzBar;
use keeper::Keeper;
use known::KnownCauses;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use stickler_campaign::finding::DIFFERENTIAL;
use stickler_campaign::{
    CampaignEnd, CampaignEvent, CampaignPlan, CampaignRequest, CampaignSummary, DifferentialOracle,
    EngineUnderTest, Exclusions, Inputs, Oracle, ReproductionCommands, Store, TargetOracle, Until,
};
use stickler_generate::oracles::FuzzTarget;
use stickler_types::{DialectName, sorted};
use stickler_workers::Shard;
use survey::{Surveyed, surveyed};

/// The default duration of a campaign.
const DEFAULT_TIME: Duration = Duration::from_secs(60);

/// Runs a campaign, stores its findings, and shows a summary.
///
/// # Errors
/// A wrong command line, an engine that cannot be run, a folder that cannot be written; all before the first input.
pub fn execute(arguments: &FuzzArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    if let Some(path) = &arguments.replay {
        return replay::execute(path, arguments, out);
    }
    // An engine may take its time to start; the campaign itself ends in an orderly way.
    interrupt::at_once()?;
    Exclusions::new(&arguments.without)?;
    let engines = match arguments.engine.is_empty() && !arguments.dialect.is_empty() {
        true => engines_of(&[engines::REFERENCE.to_owned()])?,
        false => engines_of(&arguments.engine)?,
    };
    let store = Store::open(&findings_folder(arguments.findings.as_ref()))?;
    match engines.is_empty() {
        true => campaign_on_targets(arguments, store, out),
        false => campaign_on_engines(arguments, &engines, store, out),
    }
}

/// Runs a campaign that asks the reference alone, with the oracles of the fuzz targets.
fn campaign_on_targets(arguments: &FuzzArguments, store: Store, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let targets = named_or_all(&arguments.target, &TargetOracle::TARGETS).to_vec();
    let names = |targets: &[FuzzTarget]| targets.iter().map(|target| target.as_str().to_owned()).collect();
    let request = CampaignRequest {
        targets: names(&targets),
        ..request(arguments, &Surveyed::default())
    };
    let oracle = TargetOracle {
        targets,
        inputs: Inputs::new(arguments.seed),
        commands: ReproductionCommands {
            targets: names(&arguments.target),
            ..commands(arguments, &Surveyed::default(), &store)
        },
    };
    let plan = plan(arguments, Duration::ZERO, 64);
    let kept = (store, &KnownCauses::default());
    run(&plan, request, (&oracle, &Surveyed::default()), kept, out)
}

/// Runs a campaign that gives random programs to engines.
fn campaign_on_engines(
    arguments: &FuzzArguments,
    engines: &[NamedEngine],
    store: Store,
    out: &mut dyn Write,
) -> anyhow::Result<Exit> {
    let known = KnownCauses::read(arguments)?;
    let begun = Instant::now();
    let dialects = dialects_of(arguments, engines)?;
    let under_test: Vec<EngineUnderTest<'_>> = engines.iter().map(under_test).collect();
    let surveyed = surveyed(arguments, &under_test, &dialects)?;
    let request = CampaignRequest {
        targets: vec![DIFFERENTIAL.to_owned()],
        engines: engines
            .iter()
            .map(|named| named.identity().name.clone())
            .collect(),
        dialects: dialects
            .iter()
            .map(|dialect| dialect.as_str().to_owned())
            .collect(),
        ..request(arguments, &surveyed)
    };
    let largest_pack = engines.iter().map(|named| named.engine.pack_size()).max();
    let batch = largest_pack.unwrap_or(1).clamp(16, 32);
    let oracle = DifferentialOracle {
        engines: under_test,
        inputs: Inputs::new(arguments.seed).up_to(surveyed.max_input),
        dialects,
        open: arguments.open,
        without: Exclusions::new(&surveyed.without)?,
        commands: commands(arguments, &surveyed, &store),
    };
    let plan = plan(arguments, begun.elapsed(), batch);
    run(&plan, request, (&oracle, &surveyed), (store, &known), out)
}

/// Returns the plan of a campaign, of whose time some was spent already.
fn plan(arguments: &FuzzArguments, spent: Duration, batch: usize) -> CampaignPlan {
    let left = |time: Option<Duration>| time.unwrap_or(DEFAULT_TIME).saturating_sub(spent);
    CampaignPlan {
        first: arguments.first,
        until: match (arguments.count, arguments.time) {
            (Some(count), _) => Until::Count(count),
            (None, time) => Until::Time(left(time)),
        },
        shard: arguments.shard.unwrap_or(Shard::WHOLE),
        jobs: arguments.jobs.map_or(0, usize::from),
        batch,
    }
}

/// Runs a campaign on an oracle, and keeps what it finds.
fn run(
    plan: &CampaignPlan,
    request: CampaignRequest,
    (oracle, surveyed): (&dyn Oracle, &Surveyed),
    (store, known): (Store, &KnownCauses),
    out: &mut dyn Write,
) -> anyhow::Result<Exit> {
    page::begin(out, &request, plan.shard)?;
    page::surveyed(out, &surveyed.survey)?;
    let cancel = interrupt::cancellation()?;
    let mut keeper = Keeper::begin(store, request, surveyed.survey.failing.clone(), plan.shard)?;
    let bar = FuzzBar::new(plan);
    let mut tell = |event: CampaignEvent<'_>| match event {
        CampaignEvent::Progress(progress) => bar.reach(progress),
        CampaignEvent::Found(finding) => keeper.keep(finding),
    };
    let summary = stickler_campaign::run(plan, oracle, &mut tell, cancel);
    bar.finish();
    let summary = summary?;
    let unsaved = keeper.end(&summary);
    page::end(out, &summary, known, &unsaved)?;
    Ok(exit(&summary).max(unsaved.exit()))
}

fn exit(summary: &CampaignSummary) -> Exit {
    let found = match summary.findings.is_empty() {
        _ if summary.is_empty() => Exit::NothingTested,
        true => Exit::AsExpected,
        false => Exit::Failures,
    };
    match summary.ended {
        CampaignEnd::Done => found,
        CampaignEnd::Interrupted => Exit::Interrupted,
        CampaignEnd::Lost(_) => Exit::EngineNotRun,
    }
}

/// Returns the reference and the named engines; none where none is named.
///
/// # Errors
/// An engine that [`engines::by_names`] does not find.
fn engines_of(names: &[String]) -> anyhow::Result<Vec<NamedEngine>> {
    if names.is_empty() {
        return Ok(Vec::new());
    }
    let reference = engines::REFERENCE.to_owned();
    let all: Vec<String> = std::iter::once(reference).chain(names.iter().cloned()).collect();
    engines::by_names(&all)
}

fn under_test(named: &NamedEngine) -> EngineUnderTest<'_> {
    EngineUnderTest {
        engine: named.engine.as_ref(),
        asked_for: &named.asked_for,
        is_reference: named.asked_for == engines::REFERENCE,
    }
}

/// Returns the requested dialects, or all but the variants where none is requested, that an engine other than the reference speaks;
/// without such an engine, all of these.
///
/// # Errors
/// An engine that speaks none of the dialects.
fn dialects_of(arguments: &FuzzArguments, engines: &[NamedEngine]) -> anyhow::Result<Vec<DialectName>> {
    let custom = DialectName::defined()
        .into_iter()
        .filter(|dialect| dialect.is_custom());
    let all: Vec<DialectName> = DialectName::ALL.into_iter().chain(custom).collect();
    let asked = named_or_all(&arguments.dialect, &all);
    let foreign = engines
        .iter()
        .filter(|named| named.asked_for != engines::REFERENCE);
    let mut spoken: Vec<DialectName> = Vec::new();
    for named in foreign {
        spoken.extend(engines::spoken(named.identity(), asked)?);
    }
    if spoken.is_empty() {
        spoken.extend(asked);
    }
    Ok(sorted(spoken))
}

/// Returns the given path, or that of the finding of this name in the folder of findings.
pub fn finding_place(given: &Path, folder: Option<&PathBuf>) -> PathBuf {
    let known = findings_folder(folder).join(given);
    if !given.exists() && known.is_dir() {
        return known;
    }
    given.to_owned()
}

/// Returns the folder of findings: the named one, or `reports/findings`.
fn findings_folder(named: Option<&PathBuf>) -> PathBuf {
    named
        .cloned()
        .unwrap_or_else(|| reports_folder().join("findings"))
}

/// Returns the folder of reports beside the folder of cases, or in the current folder where there is none.
fn reports_folder() -> PathBuf {
    let root = CaseFolder::locate(None)
        .map(|folder| folder.root)
        .unwrap_or_default();
    root.join("reports")
}

fn commands(arguments: &FuzzArguments, surveyed: &Surveyed, store: &Store) -> ReproductionCommands {
    ReproductionCommands {
        program: shell::program().to_owned(),
        folder: store.folder().to_owned(),
        engines: arguments.engine.clone(),
        dialects: arguments.dialect.clone(),
        without: surveyed.without.clone(),
        max_input: surveyed.max_input,
        ..ReproductionCommands::default()
    }
}

fn request(arguments: &FuzzArguments, surveyed: &Surveyed) -> CampaignRequest {
    let time = arguments.time.unwrap_or(DEFAULT_TIME).as_millis();
    CampaignRequest {
        seed: arguments.seed,
        first: arguments.first,
        count: arguments.count,
        milliseconds: arguments
            .count
            .is_none()
            .then(|| u64::try_from(time).unwrap_or(u64::MAX)),
        open: arguments.open,
        without: surveyed.without.clone(),
        max_input: (surveyed.max_input != Inputs::MAX_LEN).then_some(surveyed.max_input),
        ..CampaignRequest::default()
    }
}
