//! One request to one reply.

use super::{ClockMessage, HelloReply, HelloRequest, ObserveMessage, PROTOCOL, ProgramRequest, Reply};
use super::{RunMessage, SetMessage};
use crate::{ClockStep, Identity, Observation, Outcome, RunRequest, Session, Setting};
use std::str::FromStr;
use stickler_types::{DialectName, ElementaryType, Value};

/// Answers `hello`.
pub(super) fn hello(identity: &Identity, request: &HelloRequest) -> Reply {
    if request.protocol != PROTOCOL {
        let message = format!(
            "protocol {} is not spoken here; this engine speaks protocol {PROTOCOL}",
            request.protocol
        );
        return Reply::error(None, message);
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
pub(super) fn program(
    request: &ProgramRequest,
    ask: impl FnOnce(DialectName, &str) -> Outcome,
) -> Result<Outcome, String> {
    Ok(ask(dialect(&request.dialect)?, &request.source))
}

/// Answers `run`; the error is about this request alone.
pub(super) fn run(session: &mut dyn Session, request: &RunMessage) -> Result<Outcome, String> {
    let dialect = dialect(&request.dialect)?;
    let clock = clock(&request.clock, request.scans)?;
    let values = setting_values(&request.set)?;
    let set = settings(&request.set, &values, request.scans)?;
    let observe = observations(request)?;
    Ok(session.run(&RunRequest {
        dialect,
        source: &request.source,
        scans: request.scans,
        observe: &observe,
        clock: &clock,
        set: &set,
    }))
}

fn dialect(name: &str) -> Result<DialectName, String> {
    DialectName::from_str(name).map_err(|error| error.to_string())
}

fn observations(request: &RunMessage) -> Result<Vec<Observation<'_>>, String> {
    request
        .observe
        .iter()
        .map(|asked| observation(asked, request.scans))
        .collect()
}

fn observation(asked: &ObserveMessage, scans: u32) -> Result<Observation<'_>, String> {
    if let Some(after) = asked.after {
        within(after, scans, || format!("observe {}", asked.name))?;
    }
    Ok(Observation {
        name: &asked.name,
        type_name: &asked.type_name,
        after: asked.after,
    })
}

fn clock(steps: &[ClockMessage], scans: u32) -> Result<Vec<ClockStep>, String> {
    steps.iter().map(|step| clock_step(step, scans)).collect()
}

fn clock_step(step: &ClockMessage, scans: u32) -> Result<ClockStep, String> {
    within(step.before, scans, || "clock".to_owned())?;
    let value = Value::parse(&step.value).map_err(|error| format!("clock: {}: {error}", step.value))?;
    match value {
        Value::Plain {
            ty: ElementaryType::Time | ElementaryType::Ltime,
            raw,
        } => Ok(ClockStep {
            before: step.before,
            nanoseconds: raw.cast_signed(),
        }),
        _ => Err(format!("clock: {} is neither TIME nor LTIME", step.value)),
    }
}

fn setting_values(set: &[SetMessage]) -> Result<Vec<Value>, String> {
    let parse = |setting: &SetMessage| {
        Value::parse(&setting.value)
            .map_err(|error| format!("set {}: {}: {error}", setting.name, setting.value))
    };
    set.iter().map(parse).collect()
}

fn settings<'a>(set: &'a [SetMessage], values: &'a [Value], scans: u32) -> Result<Vec<Setting<'a>>, String> {
    let borrow = |(setting, value): (&'a SetMessage, &'a Value)| {
        within(setting.before, scans, || format!("set {}", setting.name))?;
        Ok(Setting {
            before: setting.before,
            name: &setting.name,
            value,
        })
    };
    set.iter().zip(values).map(borrow).collect()
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
