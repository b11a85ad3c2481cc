//! The data of a run that the page shows at once: its header, totals, claims and causes, and where engines disagree.

use crate::claims::Standing;
use crate::discrepancies::cause_page_of;
use crate::observations::Disagreement;
use crate::overview::Overview;
use crate::terminal::lacks::said;
use crate::text::visible;
use serde::Serialize;
use std::collections::BTreeMap;
use stickler_run::{Cause, ExplainedCases, Fact, Footer, Header, Reduced, Reproducer, Totals, clip_facts};

/// The maximum number of lines of the facts of a cause.
const MAX_LINES: usize = 60;

/// The maximum number of bytes of all causes; those that explain the fewest cases are counted, and `discrepancies` has them all.
const MAX_CAUSE_BYTES: usize = 2 << 20;

/// The maximum number of lists of disagreements; the others are counted.
const MAX_DISAGREEMENTS: usize = 5000;

#[derive(Serialize)]
pub(super) struct RunData<'o> {
    header: &'o Header,
    footer: &'o Footer,
    /// The verdict counts by engine, dialect and area.
    totals: &'o BTreeMap<String, BTreeMap<String, BTreeMap<String, Totals>>>,
    claims: Vec<ClaimData<'o>>,
    lacks: Vec<LackData<'o>>,
    causes: Vec<CauseData<'o>>,
    causes_left_out: usize,
    /// The number of values and acceptances that were recorded where no document states what they must be.
    observations: u64,
    /// Where engines part; of a single engine, what it does.
    disagreements: Vec<Disagreement<'o>>,
    disagreements_left_out: usize,
}

/// A section of a source, with the results of each engine in the order of the header.
#[derive(Serialize)]
struct ClaimData<'o> {
    source: &'o str,
    section: &'o str,
    /// The address of the section; empty where the header does not name the source.
    address: String,
    standings: Vec<Standing>,
}

/// A feature that an engine lacks.
#[derive(Serialize)]
struct LackData<'o> {
    engine: &'o str,
    feature: &'o str,
    /// What the compiler said of the minimal program, and who promises the feature.
    said: String,
    fails: bool,
    /// The number of cases that wait for it.
    waiting: u64,
}

#[derive(Serialize)]
struct CauseData<'o> {
    engine: &'o str,
    title: &'o str,
    /// Whether no case of it contradicts a source that binds the engine.
    differs: bool,
    number: u64,
    /// The number of its cases that are not as expected, before that of all where they are not all.
    cases_shown: String,
    cases: &'o [ExplainedCases],
    types: &'o [String],
    reduction: Reduced,
    /// The number of runs that showed it and of all runs, where the engine does not do the same each time.
    flaky: Option<(u32, u32)>,
    shown: ReproducerData<'o>,
    /// The text for the tracker of the engine, in Markdown.
    report: String,
}

#[derive(Serialize)]
struct ReproducerData<'o> {
    case: &'o str,
    dialect: &'o str,
    basis: &'o str,
    about: &'o str,
    is_derived: bool,
    program: String,
    expected: String,
    got: String,
    /// The names and texts of the files by which a person sees it without Stickler; none where the engine has no tools.
    files: Vec<(&'o str, &'o str)>,
    /// The variables of the commands and their defaults.
    tools: Vec<(&'o str, &'o str)>,
    commands: &'o [String],
    printed: &'o str,
}

/// Returns the data of a run; `None` for a run without header or footer.
pub(super) fn data(overview: &Overview) -> Option<RunData<'_>> {
    let (header, footer) = (overview.header.as_ref()?, overview.footer.as_ref()?);
    let causes = causes(overview);
    let mut disagreements = match overview.engines()[..] {
        [engine] => overview.observed.of_one(engine),
        ref engines => overview.observed.disagreements(engines),
    };
    let disagreements_left_out = disagreements.len().saturating_sub(MAX_DISAGREEMENTS);
    disagreements.truncate(MAX_DISAGREEMENTS);
    Some(RunData {
        header,
        footer,
        totals: &overview.totals,
        claims: claims(overview),
        lacks: overview.lacks.iter().map(lack_data).collect(),
        causes_left_out: overview.causes.len() - causes.len(),
        causes,
        observations: overview.observations,
        disagreements_left_out,
        disagreements,
    })
}

fn claims(overview: &Overview) -> Vec<ClaimData<'_>> {
    let rows = overview.claims.rows(&overview.engines());
    let claims = rows.into_iter().filter(|row| !row.sum).map(|row| ClaimData {
        source: row.source,
        section: row.section,
        address: overview
            .source(row.source)
            .map_or_else(String::new, |source| source.address_of(row.section)),
        standings: row.standings,
    });
    claims.collect()
}

/// Returns as many causes as the page has room for.
fn causes(overview: &Overview) -> Vec<CauseData<'_>> {
    let mut bytes = 0;
    let causes = overview.causes.iter().map(|cause| cause_data(cause, overview));
    let fitting = causes.take_while(|cause| {
        bytes += serde_json::to_vec(cause).map_or(0, |text| text.len());
        bytes <= MAX_CAUSE_BYTES
    });
    fitting.collect()
}

fn lack_data(lack: &Cause) -> LackData<'_> {
    LackData {
        engine: &lack.engine,
        feature: &lack.title,
        said: said(lack),
        fails: lack.is_failing_lack(),
        waiting: lack.number(),
    }
}

fn cause_data<'o>(cause: &'o Cause, overview: &'o Overview) -> CauseData<'o> {
    CauseData {
        engine: &cause.engine,
        title: &cause.title,
        differs: cause.differs(),
        number: cause.number(),
        cases_shown: cause.cases_shown(),
        cases: &cause.cases,
        types: &cause.types,
        reduction: cause.reduction,
        flaky: cause.flaky.as_ref().map(|repeats| (repeats.seen, repeats.of)),
        shown: reproducer(&cause.shown),
        report: cause_page_of(
            &cause.engine,
            overview.engine(&cause.engine),
            (cause, None),
            overview,
        ),
    }
}

fn reproducer(reproducer: &Reproducer) -> ReproducerData<'_> {
    let facts = |facts: &[Fact]| visible(&Fact::text(&clip_facts(facts, MAX_LINES)));
    let reproduction = reproducer.reproduction.as_ref();
    ReproducerData {
        case: &reproducer.case,
        dialect: &reproducer.dialect,
        basis: &reproducer.basis,
        about: &reproducer.about,
        is_derived: reproducer.is_derived,
        program: visible(&reproducer.program),
        expected: facts(&reproducer.expected),
        got: facts(&reproducer.got),
        files: reproduction.map_or_else(Vec::new, |reproduction| {
            let files = reproduction.files.iter();
            files
                .map(|file| (file.name.as_str(), file.text.as_str()))
                .collect()
        }),
        tools: reproduction.map_or_else(Vec::new, |reproduction| {
            let tools = reproduction.tools.iter();
            tools
                .map(|tool| (tool.variable.as_str(), tool.default.as_str()))
                .collect()
        }),
        commands: reproduction.map_or(&[], |reproduction| &reproduction.commands),
        printed: &reproducer.printed,
    }
}
