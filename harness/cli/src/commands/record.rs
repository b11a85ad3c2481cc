//! `stickler record`: writes a file with the answers of an engine, to be shown where the engine is not at hand.

use crate::arguments::RecordArguments;
use crate::exit::Exit;
use crate::progress::Progress;
use crate::{engines, interrupt};
use anyhow::{Context, bail};
use jiff::Timestamp;
use jiff::tz::TimeZone;
use std::env::consts;
use std::fs;
use std::io::Write;
use stickler_conversions::recording::{Recording, RecordingOrigin};
use stickler_engines::Identity;
use stickler_types::DialectName;

/// Asks the engine, and writes the recording to the file or to `out`.
///
/// # Errors
/// An engine that cannot be run, speaks none of the dialects or does not say its version; a file that cannot be written.
pub fn execute(arguments: &RecordArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    interrupt::at_once()?;
    let engine = engines::by_name(&arguments.engine)?;
    let asked = match &arguments.dialect[..] {
        [] => &DialectName::ALL[..],
        named => named,
    };
    let dialects = engines::spoken(engine.identity(), asked)?;
    let origin = origin(arguments, engine.identity())?;
    let bar = Progress::new(Recording::questions(&dialects) as u64);
    let jobs = arguments.jobs.map_or(0, usize::from);
    let recording = Recording::ask(engine.as_ref(), origin, &dialects, jobs, &|| bar.advance(0))?;
    bar.finish();
    match &arguments.output {
        None => recording.write(out)?,
        Some(path) => {
            let mut text = Vec::new();
            recording.write(&mut text)?;
            fs::write(path, text).with_context(|| format!("cannot write {}", path.display()))?;
        }
    }
    Ok(Exit::AsExpected)
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
        date: Timestamp::now().to_zoned(TimeZone::UTC).date().to_string(),
    })
}
