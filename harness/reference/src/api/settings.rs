//! The variables that a request sets between scans.

use super::observe::{check_scan, resolve};
use super::run::RequestError;
use crate::execution::Machine;
use crate::library::CLOCKS;
use crate::semantics::{CheckedProgram, ObservedType, ObservedVariable};
use stickler_types::{RunRequest, Setting, Value};

/// The variables to set, in the form that the machine takes.
pub(super) struct Settings<'a> {
    /// By scan, and for one scan in the order of the request.
    list: Vec<ResolvedSetting<'a>>,
    /// The number of settings that have been applied.
    applied: usize,
}

/// A variable to set whose place is known.
struct ResolvedSetting<'a> {
    before: u32,
    address: u32,
    value: SettingValue<'a>,
}

#[derive(Clone, Copy)]
enum SettingValue<'a> {
    Plain(u64),
    Text(&'a [u16]),
}

impl<'a> Settings<'a> {
    /// Finds each variable's place, and holds the value against its type; the clock is set where timers look at it.
    pub fn new(program: &CheckedProgram, request: &RunRequest<'a>) -> Result<Settings<'a>, RequestError> {
        let set = request.set.iter();
        let mut list = set
            .map(|setting| ResolvedSetting::new(program, setting, request.scans))
            .collect::<Result<Vec<_>, _>>()?;
        for (ty, clock) in CLOCKS {
            let is_clock = |place: &ObservedVariable| place.ty == ObservedType::Plain(ty);
            let Some(place) = program.global(clock).filter(is_clock) else {
                continue;
            };
            list.extend(request.clock.iter().map(|time| ResolvedSetting {
                before: time.before,
                address: place.address,
                value: SettingValue::Plain(time.nanoseconds.cast_unsigned()),
            }));
        }
        list.sort_by_key(|setting| setting.before);
        Ok(Settings { list, applied: 0 })
    }

    /// Writes what is set before this scan; scans come in order.
    pub fn apply_before(&mut self, scan: u32, machine: &mut Machine<'_>) {
        while let Some(setting) = self
            .list
            .get(self.applied)
            .filter(|setting| setting.before == scan)
        {
            let written = match setting.value {
                SettingValue::Plain(raw) => machine.set_plain(setting.address, raw),
                SettingValue::Text(units) => machine.set_text(setting.address, units),
            };
            debug_assert!(written.is_some(), "a resolved variable has a cell");
            self.applied += 1;
        }
    }
}

impl<'a> ResolvedSetting<'a> {
    fn new(program: &CheckedProgram, setting: &'a Setting, scans: u32) -> Result<Self, RequestError> {
        if setting.before == 0 {
            return Err(RequestError::NoSuchScan {
                name: setting.name.to_string(),
                scan: 0,
            });
        }
        check_scan(&setting.name, setting.before, scans)?;
        let place = resolve(program, &setting.name)?;
        if place.bytes.is_some() {
            return Err(RequestError::UnknownName {
                name: setting.name.to_string(),
                reason: "a field of a UNION cannot be set from outside".to_owned(),
            });
        }
        let value = matching(&place.ty, &setting.value).ok_or_else(|| RequestError::WrongType {
            name: setting.name.to_string(),
            expected: type_name(&place.ty).to_owned(),
            value: setting.value.to_string(),
        })?;
        Ok(ResolvedSetting {
            before: setting.before,
            address: place.address,
            value,
        })
    }
}

fn type_name(ty: &ObservedType) -> &str {
    match ty {
        ObservedType::Plain(ty) | ObservedType::Text(ty) => ty.name(),
        ObservedType::Enumerated { type_name, .. } => type_name,
    }
}

/// The value as the variable holds it, where it is of the variable's type.
fn matching<'a>(expected: &ObservedType, value: &'a Value) -> Option<SettingValue<'a>> {
    match (expected, value) {
        (ObservedType::Plain(expected), Value::Plain { ty, raw }) if expected == ty => {
            Some(SettingValue::Plain(*raw))
        }
        (ObservedType::Text(expected), Value::Text { ty, units }) if expected == ty => {
            Some(SettingValue::Text(units))
        }
        (
            ObservedType::Enumerated { type_name, values },
            Value::Enumerated {
                type_name: given,
                value_name,
            },
        ) if type_name.eq_ignore_ascii_case(given) => {
            let named = values
                .iter()
                .find(|(_, name)| name.eq_ignore_ascii_case(value_name));
            named.map(|(value, _)| SettingValue::Plain(value.cast_unsigned()))
        }
        _ => None,
    }
}
