//! `stickler fuzz`: runs a campaign, or judges one input again.

mod bar;
mod keeper;
mod page;
mod replay;

use crate::arguments::FuzzArguments;
use crate::case_folder::CaseFolder;
use crate::engines::{self, NamedEngine};
use crate::exit::Exit;
use crate::{interrupt, shell};
use anyhow::bail;
use bar::FuzzBar;
use keeper::Keeper;
use page::FuzzPage;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Duration;
use stickler_campaign::{
    CampaignEnd, CampaignEvent, CampaignPlan, CampaignRequest, CampaignSummary, DifferentialOracle,
    EngineUnderTest, Exclusions, Inputs, Oracle, PackPolicy, ReproductionCommands, Store, TargetOracle,
    Until,
};
use stickler_generate::oracles::FuzzTarget;
use stickler_types::DialectName;
use stickler_workers::Shard;

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
    let without = Exclusions::new(&arguments.without)?;
    let engines = engines_of(&arguments.engine)?;
    let store = Store::open(&findings_folder(arguments.findings.as_ref()))?;
    let inputs = Inputs::new(arguments.seed);
    let commands = commands(arguments, &store);
    if engines.is_empty() {
        if !arguments.dialect.is_empty() {
            bail!("--dialect needs an --engine; the oracles of the reference choose dialects by their input");
        }
        let targets = match &arguments.target[..] {
            [] => TargetOracle::TARGETS.to_vec(),
            named => named.to_vec(),
        };
        let request = request(arguments, &targets, Vec::new(), &[]);
        let oracle = TargetOracle {
            targets,
            inputs,
            commands,
        };
        return campaign(&oracle, 64, arguments, request, store, out);
    }
    let dialects = dialects_of(arguments, &engines)?;
    let names = engines
        .iter()
        .map(|named| named.identity().name.clone())
        .collect();
    let request = request(arguments, &[FuzzTarget::Differential], names, &dialects);
    let oracle = DifferentialOracle {
        engines: engines.iter().map(under_test).collect(),
        inputs,
        dialects,
        open: arguments.open,
        without,
        packs: PackPolicy::WhereSlow,
        commands,
    };
    campaign(&oracle, 16, arguments, request, store, out)
}

/// Runs a campaign on an oracle.
fn campaign(
    oracle: &dyn Oracle,
    batch: usize,
    arguments: &FuzzArguments,
    request: CampaignRequest,
    store: Store,
    out: &mut dyn Write,
) -> anyhow::Result<Exit> {
    let shard = arguments.shard.unwrap_or(Shard::WHOLE);
    let plan = CampaignPlan {
        first: arguments.first,
        until: match (arguments.count, arguments.time) {
            (Some(count), _) => Until::Count(count),
            (None, time) => Until::Time(time.unwrap_or(DEFAULT_TIME)),
        },
        shard,
        jobs: arguments.jobs.map_or(0, usize::from),
        batch,
    };
    let mut page = FuzzPage::new(out);
    page.begin(&request, shard)?;
    let cancel = interrupt::cancellation()?;
    let mut keeper = Keeper::begin(store, request, shard)?;
    let bar = FuzzBar::new(&plan);
    let mut tell = |event: CampaignEvent<'_>| match event {
        CampaignEvent::Progress(progress) => bar.reach(progress),
        CampaignEvent::Found(finding) => keeper.keep(finding),
    };
    let summary = stickler_campaign::run(&plan, oracle, &mut tell, cancel);
    bar.finish();
    let summary = summary?;
    let unsaved = keeper.end(&summary);
    page.end(&summary, &unsaved)?;
    Ok(exit(&summary).worst(unsaved.exit()))
}

fn exit(summary: &CampaignSummary) -> Exit {
    let found = match summary.findings.is_empty() {
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

/// Returns the requested dialects, or all where none is requested, that an engine other than the reference speaks; without such
/// an engine, all of these.
///
/// # Errors
/// A dialect of stickler.toml; an engine that speaks none of the dialects.
fn dialects_of(arguments: &FuzzArguments, engines: &[NamedEngine]) -> anyhow::Result<Vec<DialectName>> {
    let asked = match &arguments.dialect[..] {
        [] => &DialectName::ALL[..],
        named => named,
    };
    if let Some(defined) = asked.iter().find(|dialect| dialect.definition().is_some()) {
        bail!(
            "programs are made by the rules of documented systems alone, and {defined} overrides some; --dialect {} has those \
             that it extends",
            defined.base().name()
        );
    }
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
    spoken.sort_unstable();
    spoken.dedup();
    Ok(spoken)
}

/// Returns the given path, or that of the finding of this name in the folder of findings.
pub fn finding_place(given: &Path, folder: Option<&PathBuf>) -> PathBuf {
    let known = findings_folder(folder).join(given);
    if !given.exists() && known.is_dir() {
        return known;
    }
    given.to_owned()
}

/// Returns the folder of findings: the named one, or `reports/findings` beside the folder of cases, or in the current folder where
/// there is none.
fn findings_folder(named: Option<&PathBuf>) -> PathBuf {
    let default = || {
        let root = CaseFolder::locate(None)
            .map(|folder| folder.root)
            .unwrap_or_default();
        root.join("reports").join("findings")
    };
    named.cloned().unwrap_or_else(default)
}

fn commands(arguments: &FuzzArguments, store: &Store) -> ReproductionCommands {
    ReproductionCommands {
        program: shell::program().to_owned(),
        folder: store.folder().to_owned(),
        engines: arguments.engine.clone(),
        dialects: arguments.dialect.clone(),
        targets: arguments
            .target
            .iter()
            .map(|target| target.name().to_owned())
            .collect(),
        without: arguments.without.clone(),
    }
}

fn request(
    arguments: &FuzzArguments,
    targets: &[FuzzTarget],
    engines: Vec<String>,
    dialects: &[DialectName],
) -> CampaignRequest {
    let time = arguments.time.unwrap_or(DEFAULT_TIME).as_millis();
    CampaignRequest {
        seed: arguments.seed,
        first: arguments.first,
        count: arguments.count,
        milliseconds: arguments
            .count
            .is_none()
            .then(|| u64::try_from(time).unwrap_or(u64::MAX)),
        targets: targets.iter().map(|target| target.name().to_owned()).collect(),
        engines,
        dialects: dialects
            .iter()
            .map(|dialect| dialect.as_str().to_owned())
            .collect(),
        open: arguments.open,
        without: arguments.without.clone(),
    }
}
