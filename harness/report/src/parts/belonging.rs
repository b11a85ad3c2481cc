//! Checks whether parts belong to one run, and finds the missing ones.

use stickler_run::{EngineHeader, Header};
use stickler_workers::Shard;

/// The maximum number of missing parts that are named one by one.
const MAX_NAMED: usize = 20;

/// Returns the part of a run that a header describes.
///
/// # Errors
/// Returns the rest of a sentence about the part where its header describes none.
pub(super) fn shard(header: &Header) -> Result<Shard, String> {
    match &header.shard {
        None => Err("is a whole run, and no part of one".to_owned()),
        Some(text) => text.parse().map_err(|error| format!("cannot be used: {error}")),
    }
}

/// Describes the first difference between two parts, each given with the number of parts; `None` where they belong to one
/// run.
pub(super) fn difference(
    (one, parts): (&Header, u32),
    (other, other_parts): (&Header, u32),
) -> Option<String> {
    let differs = |what: &str, here: &str, there: &str| {
        (here != there).then(|| format!("its {what} is {there}, and that of the other {here}"))
    };
    differs("number of parts", &parts.to_string(), &other_parts.to_string())
        .or_else(|| differs("version of Stickler", &one.stickler, &other.stickler))
        .or_else(|| differs("version of the suite", &one.suite, &other.suite))
        .or_else(|| differs("list of engines", &engines(one), &engines(other)))
        .or_else(|| differs("--filter", &list(&one.filters), &list(&other.filters)))
        .or_else(|| differs("--dialect", &list(&one.dialects), &list(&other.dialects)))
        .or_else(|| {
            (one.broken_files != other.broken_files).then(|| "other case files are broken in it".to_owned())
        })
        .or_else(|| {
            (rules(one) != rules(other)).then(|| "stickler.toml defines its dialects otherwise".to_owned())
        })
        .or_else(|| {
            (one.baselines != other.baselines).then(|| "its baselines are not those of the other".to_owned())
        })
}

/// Returns the definitions of custom dialects without the numbers of dropped cases, which may differ from part to part.
fn rules(header: &Header) -> Vec<(&str, &str, &[String])> {
    let defined = header.defined.iter();
    defined
        .map(|dialect| (&*dialect.name, &*dialect.extends, &*dialect.overrides))
        .collect()
}

fn engines(header: &Header) -> String {
    let named = |engine: &EngineHeader| {
        format!(
            "{} {} judged by {}, in {}",
            engine.name,
            engine.version,
            engine.strict,
            engine.dialects.join(" ")
        )
    };
    let engines: Vec<String> = header.engines.iter().map(named).collect();
    engines.join("; ")
}

fn list(words: &[String]) -> String {
    match words {
        [] => "not given".to_owned(),
        words => words.join(", "),
    }
}

/// Describes the missing parts of so many.
pub(super) fn absent(there: &[u32], count: u32, missing: &mut Vec<String>) {
    let mut absent = (1..=count).filter(|part| !there.contains(part));
    for part in absent.by_ref().take(MAX_NAMED) {
        missing.push(format!("part {part}/{count} is missing"));
    }
    // A hostile number of parts must not make as many sentences.
    if let Some(part) = absent.next() {
        missing.push(format!("part {part}/{count} is missing, and so may be others"));
    }
}
