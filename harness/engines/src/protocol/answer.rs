//! Turns one request into one reply.

use super::{ClockMessage, HelloReply, PROTOCOL, ProgramRequest, Reply, RunMessage, SetMessage};
use crate::{ClockSetting, Identity, RunRequest, Setting};
use std::str::FromStr;
use stickler_types::{DialectName, Value};

/// Answers `hello` of a caller who speaks this version of the protocol.
pub(super) fn hello(identity: &Identity, protocol: u32) -> Reply {
    if protocol != PROTOCOL {
        return Reply::error(
            None,
            format!("protocol {protocol} is not spoken here; this engine speaks protocol {PROTOCOL}"),
        );
    }
    Reply::Hello(HelloReply {
        protocol: PROTOCOL,
        name: identity.name.clone(),
        version: identity.version.clone(),
        dialects: identity
            .dialects
            .iter()
            .map(|dialect| dialect.as_str().to_owned())
            .collect(),
        abilities: identity.abilities.clone(),
        grade: identity.grade,
    })
}

/// Answers `check` and `render`, which differ only in what the session is asked.
///
/// # Errors
/// A message about this request alone.
pub(super) fn program<T>(
    request: &ProgramRequest,
    ask: impl FnOnce(DialectName, &str) -> T,
) -> Result<T, String> {
    Ok(ask(dialect(&request.dialect)?, &request.source))
}

/// Answers `run`.
///
/// # Errors
/// A message about this request alone.
pub(super) fn run<T>(request: &RunMessage, ask: impl FnOnce(&RunRequest<'_>) -> T) -> Result<T, String> {
    let dialect = dialect(&request.dialect)?;
    let scans = request.scans;
    let clock = request.clock.iter().map(|step| clock_setting(step, scans));
    let clock: Vec<ClockSetting> = clock.collect::<Result<_, _>>()?;
    let set = request.set.iter().map(|message| setting(message, scans));
    let set: Vec<Setting> = set.collect::<Result<_, _>>()?;
    for asked in &request.observe {
        if let Some(after) = asked.after {
            within(after, scans, || format!("observe {}", asked.name))?;
        }
    }
    Ok(ask(&RunRequest {
        dialect,
        source: &request.source,
        scans,
        observe: &request.observe,
        clock: &clock,
        set: &set,
    }))
}

fn dialect(name: &str) -> Result<DialectName, String> {
    DialectName::from_str(name).map_err(|error| error.to_string())
}

fn clock_setting(step: &ClockMessage, scans: u32) -> Result<ClockSetting, String> {
    within(step.before, scans, || "clock".to_owned())?;
    let time = Value::parse(&step.value).map_err(|error| format!("clock: {}: {error}", step.value))?;
    ClockSetting::at(step.before, &time)
        .ok_or_else(|| format!("clock: {} is neither TIME nor LTIME", step.value))
}

fn setting(message: &SetMessage, scans: u32) -> Result<Setting, String> {
    let SetMessage { before, name, value } = message;
    let value = Value::parse(value).map_err(|error| format!("set {name}: {value}: {error}"))?;
    within(*before, scans, || format!("set {name}"))?;
    Ok(Setting {
        before: *before,
        name: name.as_str().into(),
        value,
    })
}

fn within(scan: u32, scans: u32, what: impl FnOnce() -> String) -> Result<(), String> {
    if (1..=scans).contains(&scan) {
        return Ok(());
    }
    Err(format!(
        "{}: there is no scan {scan} among {scans} (the first is scan 1)",
        what()
    ))
}
