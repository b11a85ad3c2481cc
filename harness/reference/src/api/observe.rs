//! The values that a request asks for, taken from the machine by their names.

use super::run::RequestError;
use crate::execution::Machine;
use crate::semantics::{CheckedProgram, ObservedType, ObservedVariable};
use stickler_types::{ElementaryType, NamedValue, Observation, Value};

/// The values that a request asks for.
pub(super) struct Observer<'a> {
    wanted: Vec<Wanted<'a>>,
    /// The entries of `wanted` that are asked for after a certain scan, by that scan.
    by_scan: Vec<(u32, usize)>,
    /// The number of entries of `by_scan` that have been taken down.
    taken: usize,
}

struct Wanted<'a> {
    observation: &'a Observation,
    place: ObservedVariable,
    value: Option<Value>,
}

impl<'a> Observer<'a> {
    /// Finds each value's place.
    pub fn new(
        program: &CheckedProgram,
        observe: &'a [Observation],
        scans: u32,
    ) -> Result<Observer<'a>, RequestError> {
        let find = |observation: &'a Observation| {
            check_scan(&observation.name, observation.after.unwrap_or(0), scans)?;
            Ok(Wanted {
                observation,
                place: resolve(program, &observation.name)?,
                value: None,
            })
        };
        let wanted = observe.iter().map(find).collect::<Result<Vec<_>, _>>()?;
        let scans = wanted.iter().enumerate();
        let mut by_scan: Vec<_> = scans
            .filter_map(|(index, wanted)| Some((wanted.observation.after?, index)))
            .collect();
        by_scan.sort_unstable();
        Ok(Observer {
            wanted,
            by_scan,
            taken: 0,
        })
    }

    /// Takes down what is wanted after this scan; scans come in order, the start as scan 0.
    pub fn after_scan(&mut self, scan: u32, machine: &Machine<'_>) {
        while let Some(&(_, index)) = self.by_scan.get(self.taken).filter(|(after, _)| *after == scan) {
            if let Some(wanted) = self.wanted.get_mut(index) {
                wanted.value = read(&wanted.place, machine);
            }
            self.taken += 1;
        }
    }

    /// Takes down what is wanted after the last scan, and gives everything.
    pub fn finish(mut self, machine: &Machine<'_>) -> Vec<NamedValue> {
        for wanted in self
            .wanted
            .iter_mut()
            .filter(|wanted| wanted.observation.after.is_none())
        {
            wanted.value = read(&wanted.place, machine);
        }
        self.wanted
            .into_iter()
            .filter_map(|wanted| Some((wanted.observation.key().to_string(), wanted.value?)))
            .collect()
    }
}

/// Returns whether a scan is among those that are run.
pub(super) fn check_scan(name: &str, scan: u32, scans: u32) -> Result<(), RequestError> {
    if scan <= scans {
        Ok(())
    } else {
        Err(RequestError::NoSuchScan {
            name: name.to_owned(),
            scan,
        })
    }
}

/// The place of a value.
pub(super) fn resolve(program: &CheckedProgram, name: &str) -> Result<ObservedVariable, RequestError> {
    let unknown = |reason| RequestError::UnknownName {
        name: name.to_owned(),
        reason,
    };
    program.resolve(name).map_err(unknown)
}

fn read(place: &ObservedVariable, machine: &Machine<'_>) -> Option<Value> {
    let plain = |ty| match place.bytes {
        Some(size) => machine.plain_in_bytes(place.address, size, ty),
        None => machine.plain(place.address),
    };
    match &place.ty {
        ObservedType::Plain(ty) => Some(Value::plain(*ty, plain(*ty)?)),
        ObservedType::Text(ty) if place.bytes.is_some() => {
            let size = place.bytes.unwrap_or_default();
            let step = 1 + u32::from(*ty == ElementaryType::Wstring);
            let positions = (0..size).step_by(step as usize);
            let units = positions.map_while(|at| {
                let unit = machine.plain_in_bytes(place.address + at, step, ElementaryType::Word)?;
                u16::try_from(unit).ok().filter(|&unit| unit != 0)
            });
            Some(Value::text(*ty, units.collect()))
        }
        ObservedType::Text(ty) => Some(Value::text(*ty, machine.text(place.address)?.to_vec())),
        ObservedType::Enumerated { type_name, values } => {
            let raw = plain(ElementaryType::Int)?;
            let named = values.iter().find(|(value, _)| value.cast_unsigned() == raw);
            // Only named values can be assigned; a number would be a defect, and shows as one.
            Some(
                named.map_or(Value::plain(ElementaryType::Lint, raw), |(_, name)| {
                    Value::enumerated(type_name.as_str(), name.as_str())
                }),
            )
        }
    }
}
