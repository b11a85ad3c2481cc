//! `stickler record`: writes a file with the answers of an engine, to be shown where the engine is not at hand.

use crate::arguments::{RecordArguments, named_or_all};
use crate::exit::Exit;
use crate::progress::Progress;
use crate::{engines, interrupt, run_plan, source_file};
use anyhow::{Context, bail};
use jiff::tz::TimeZone;
use std::env::consts;
use std::fs;
use std::io::Write;
use std::path::Path;
use stickler_conversions::recording::{RecordedSection, Recording};
use stickler_engines::Identity;
use stickler_types::{DialectName, RecordingOrigin};

/// Asks the engine, and writes the recording to the file or to `out`.
///
/// # Errors
/// An engine that cannot be run, speaks none of the dialects or does not say its version; a file that cannot be written.
pub fn execute(arguments: &RecordArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    interrupt::at_once()?;
    let engine = engines::by_name(&arguments.engine)?;
    let asked = named_or_all(&arguments.dialect, &DialectName::ALL);
    let dialects = engines::spoken(engine.identity(), asked)?;
    let origin = origin(arguments, engine.identity())?;
    let sections = named_or_all(&arguments.only, &RecordedSection::ALL);
    // A file that cannot be completed is seen before the compiler is asked for minutes.
    let older = match &arguments.output {
        Some(path) if !arguments.only.is_empty() => {
            let older = older(path, &origin)?;
            if let Some(older) = &older {
                check_commit(path, older.origin.commit.as_deref(), origin.commit.as_deref())?;
            }
            older
        }
        _ => None,
    };
    let bar = Progress::new(Recording::questions(&dialects, sections) as u64);
    let jobs = arguments.jobs.map_or(0, usize::from);
    let mut recording = Recording::ask(engine.as_ref(), origin, &dialects, sections, jobs, &|| {
        bar.advance(0)
    })?;
    bar.finish();
    if let Some(older) = older {
        recording.complete_from(older);
    }
    match &arguments.output {
        None => recording.write(out)?,
        Some(path) => write(&recording, path)?,
    }
    Ok(Exit::AsExpected)
}

/// Returns the recording that a file holds already; `None` where there is no such file.
///
/// # Errors
/// A file that cannot be read, is no recording, or is one of another product or version.
pub fn older(path: &Path, origin: &RecordingOrigin) -> anyhow::Result<Option<Recording>> {
    let shown = path.display();
    let Some(text) = source_file::text_if_any(path)? else {
        return Ok(None);
    };
    let older = Recording::parse(&shown.to_string(), &text)?;
    let (was, is) = (&older.origin, origin);
    if (&was.product, &was.version) != (&is.product, &is.version) {
        bail!(
            "{shown} is a recording of {} {}, not of {} {}; name another file, or say with --product and --product-version what it says",
            was.product,
            was.version,
            is.product,
            is.version
        );
    }
    Ok(Some(older))
}

/// Checks that a file was recorded of the commit that answers now.
///
/// # Errors
/// Another commit, or one where the other has none: two compilers of the same version need not answer the same.
fn check_commit(path: &Path, recorded: Option<&str>, asked: Option<&str>) -> anyhow::Result<()> {
    if recorded != asked {
        bail!(
            "{} was recorded of {}, and this is {}; record all sections again, or say with --commit that it is the same",
            path.display(),
            recorded.map_or("no commit".to_owned(), |commit| format!("commit {commit}")),
            asked.unwrap_or("none that is named")
        );
    }
    Ok(())
}

/// Writes a recording to a file.
///
/// # Errors
/// A file that cannot be written.
pub fn write(recording: &Recording, path: &Path) -> anyhow::Result<()> {
    let mut text = Vec::new();
    recording.write(&mut text)?;
    fs::write(path, text).with_context(|| format!("cannot write {}", path.display()))
}

/// Returns today's date, as a recording has it.
pub fn today() -> String {
    run_plan::now().to_zoned(TimeZone::UTC).date().to_string()
}

fn origin(arguments: &RecordArguments, identity: &Identity) -> anyhow::Result<RecordingOrigin> {
    let given = |argument: &Option<String>, known: &str| {
        let text = argument.as_deref().unwrap_or(known).trim().to_owned();
        (!text.is_empty()).then_some(text)
    };
    let Some(product) = given(&arguments.product, &identity.name) else {
        bail!("a recording says which product answered; name it with --product");
    };
    let Some(version) = given(&arguments.product_version, &identity.version) else {
        bail!(
            "{} does not say its version, and a recording without it is worth nothing; give it with --product-version",
            identity.name
        );
    };
    Ok(RecordingOrigin {
        product,
        version,
        commit: arguments.commit.clone(),
        platform: format!("{} {}", consts::OS, consts::ARCH),
        date: today(),
    })
}
