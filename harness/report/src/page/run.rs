//! The data of a run that the page shows at once: its header, totals, claims and causes, and where engines disagree.

use crate::discrepancies::cause_page_of;
use crate::overview::Overview;
use crate::terminal::causes::said;
use crate::text::visible;
use serde_json::{Value, json};
use stickler_run::{Cause, Fact, Reproducer, clip_facts};

/// The maximum number of lines of the facts of a cause.
const MAX_LINES: usize = 60;

/// The maximum number of bytes of all causes; those that explain the fewest cases are counted, and `discrepancies` has them all.
const MAX_CAUSE_BYTES: usize = 2 << 20;

/// The maximum number of lists of disagreements; the others are counted.
const MAX_DISAGREEMENTS: usize = 5000;

/// Returns the data of a run; `None` for a run without header or footer.
pub(super) fn data(overview: &Overview) -> Option<Value> {
    let (header, footer) = (overview.header.as_ref()?, overview.footer.as_ref()?);
    let causes = causes(overview);
    let mut disagreements = match overview.engines()[..] {
        [engine] => overview.observed.of_one(engine),
        ref engines => overview.observed.disagreements(engines),
    };
    let disagreements_left_out = disagreements.len().saturating_sub(MAX_DISAGREEMENTS);
    disagreements.truncate(MAX_DISAGREEMENTS);
    Some(json!({
        "header": header,
        "footer": footer,
        // By engine, dialect and area.
        "totals": overview.totals,
        "claims": claims(overview),
        "lacks": overview.lacks.iter().map(lack_data).collect::<Vec<_>>(),
        "causes_left_out": overview.causes.len() - causes.len(),
        "causes": causes,
        "observations": overview.observations,
        // Where engines part; of a single engine, what it does.
        "disagreements": disagreements,
        "disagreements_left_out": disagreements_left_out,
    }))
}

/// Returns the sections of sources, each with the results of the engines in the order of the header, and its address, which is empty where the
/// header does not name the source.
fn claims(overview: &Overview) -> Vec<Value> {
    let rows = overview.claims.rows(&overview.engines());
    let claims = rows.into_iter().filter(|row| !row.sum).map(|row| {
        let source = overview.source(row.source);
        let address = source.map_or_else(String::new, |source| source.address_of(row.section));
        json!({ "source": row.source, "section": row.section, "address": address, "standings": row.standings })
    });
    claims.collect()
}

/// Returns as many causes as the page has room for.
fn causes(overview: &Overview) -> Vec<Value> {
    let mut bytes = 0;
    let causes = overview.causes.iter().map(|cause| cause_data(cause, overview));
    let fitting = causes.take_while(|cause| {
        bytes += cause.to_string().len();
        bytes <= MAX_CAUSE_BYTES
    });
    fitting.collect()
}

/// Returns a feature that an engine lacks, with what the compiler said of the minimal program, who promises the feature, and how many cases
/// wait for it.
fn lack_data(lack: &Cause) -> Value {
    json!({
        "engine": lack.engine,
        "feature": lack.title,
        "said": said(lack),
        "fails": lack.is_failing_lack(),
        "waiting": lack.number(),
    })
}

fn cause_data(cause: &Cause, overview: &Overview) -> Value {
    let engine = overview.engine(&cause.engine);
    json!({
        "engine": cause.engine,
        "title": cause.title,
        // Whether no case of it contradicts a source that binds the engine.
        "differs": cause.differs(),
        "number": cause.number(),
        // The number of its cases that are not as expected, before that of all where they are not all.
        "cases_shown": cause.cases_shown(),
        "cases": cause.cases,
        "reduction": cause.reduction,
        // The number of runs that showed it and of all runs, where the engine does not do the same each time.
        "flaky": cause.flaky.as_ref().map(|repeats| (repeats.seen, repeats.of)),
        "shown": reproducer(&cause.shown),
        // The text for the tracker of the engine, in Markdown.
        "report": cause_page_of(&cause.engine, engine, (cause, None), overview),
    })
}

/// Returns a reproducer, with the names and texts of the files by which a person sees it without Stickler, the variables of the commands and
/// their defaults, and the commands; none where the engine has no tools.
fn reproducer(reproducer: &Reproducer) -> Value {
    let facts = |facts: &[Fact]| visible(&Fact::text(&clip_facts(facts, MAX_LINES)));
    let reproduction = reproducer.reproduction.as_ref();
    let files = reproduction.iter().flat_map(|reproduction| &reproduction.files);
    let tools = reproduction.iter().flat_map(|reproduction| &reproduction.tools);
    json!({
        "case": reproducer.case,
        "dialect": reproducer.dialect,
        "basis": reproducer.basis,
        "about": reproducer.about,
        "is_derived": reproducer.is_derived,
        "neighbours": reproducer.neighbours_told(),
        "program": visible(&reproducer.program),
        "expected": facts(&reproducer.expected),
        "got": facts(&reproducer.got),
        "files": files.map(|file| (&file.name, &file.text)).collect::<Vec<_>>(),
        "tools": tools.map(|tool| (&tool.variable, &tool.default)).collect::<Vec<_>>(),
        "commands": reproduction.map_or(&[][..], |reproduction| &reproduction.commands),
        "printed": reproducer.printed,
    })
}
