//! Requests to engines: a program, its inputs and settings, and the variables to observe.

use crate::{DialectName, Value};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::sync::Arc;

/// A program to execute and what to observe of it. It carries no expectation: an engine never sees one.
#[derive(Clone, Copy, Debug)]
pub struct RunRequest<'a> {
    /// The language rules to follow.
    pub dialect: DialectName,
    /// The whole source text.
    pub source: &'a str,
    /// The number of scans to run; 0 runs only the start-up.
    pub scans: u32,
    /// The variables whose values are requested.
    pub observe: &'a [Observation],
    /// Simulated time since the start, by scan; ascending.
    pub clock: &'a [ClockSetting],
    /// Variables that are written before a scan, in this order.
    pub set: &'a [Setting],
}

impl<'a> RunRequest<'a> {
    /// Builds the request for a program that runs one scan, without settings and clock.
    pub const fn once(dialect: DialectName, source: &'a str, observe: &'a [Observation]) -> RunRequest<'a> {
        RunRequest {
            dialect,
            source,
            scans: 1,
            observe,
            clock: &[],
            set: &[],
        }
    }

    /// Returns whether an engine must support several scans, settings or observations between scans to answer the request.
    pub fn needs_scans(&self) -> bool {
        self.scans != 1
            || !self.clock.is_empty()
            || !self.set.is_empty()
            || self.observe.iter().any(|observation| observation.after.is_some())
    }
}

/// A variable whose value is requested.
///
/// The names are shared, because the many cases of one table observe the same variables.
#[derive(Clone, PartialEq, Eq, Hash, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(
    feature = "schema",
    schemars(rename = "ObserveMessage", description = "A variable to observe.")
)]
pub struct Observation {
    /// The variable, or a path to an elementary value (`a[1]`, `rec.field[2].x`).
    pub name: Arc<str>,
    /// The name of its type, a help for engines that must declare something.
    #[serde(rename = "type", default, skip_serializing_if = "str::is_empty")]
    pub type_name: Arc<str>,
    /// The scan (from 1) after which to look, otherwise after the last; the reply then names it `q@3`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(range(min = 1)))]
    pub after: Option<u32>,
}

impl Observation {
    /// Builds the observation of a variable after the last scan.
    pub fn last(name: &str, type_name: &str) -> Observation {
        Observation {
            name: name.into(),
            type_name: type_name.into(),
            after: None,
        }
    }

    /// Returns the key under which the engine returns the value.
    pub fn key(&self) -> ObservationKey<'_> {
        ObservationKey {
            name: &self.name,
            after: self.after,
        }
    }
}

/// The key under which an engine returns an observed value: `q`, or `q@3` if it is read after the third scan.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ObservationKey<'a> {
    /// The variable or path.
    pub name: &'a str,
    /// The scan after which the value is read; `None` for the last scan.
    pub after: Option<u32>,
}

impl ObservationKey<'_> {
    /// Returns whether `text` equals the output of `Display`, without producing it.
    pub fn is(&self, text: &str) -> bool {
        match (self.after, text.strip_prefix(self.name)) {
            (None, Some(rest)) => rest.is_empty(),
            (Some(scan), Some(rest)) => rest
                .strip_prefix('@')
                .is_some_and(|digits| digits == scan.to_string()),
            (_, None) => false,
        }
    }
}

impl fmt::Display for ObservationKey<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)?;
        self.after.map_or(Ok(()), |after| write!(f, "@{after}"))
    }
}

/// A variable that is written before a scan.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Setting {
    /// The scan, counted from 1.
    pub before: u32,
    /// The variable, or a path to an elementary value.
    pub name: Arc<str>,
    /// The value that it is set to, of exactly the variable's type.
    pub value: Value,
}

/// The simulated time at which a scan begins.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct ClockSetting {
    /// The scan, counted from 1.
    pub before: u32,
    /// Nanoseconds since the start of the program.
    pub nanoseconds: i64,
}

impl ClockSetting {
    /// Builds the settings of scans that are `cycle` nanoseconds apart, of which the first begins with the program.
    pub fn each(cycle: i64, scans: u32) -> Vec<ClockSetting> {
        let at = |before: u32| ClockSetting {
            before,
            nanoseconds: cycle.saturating_mul(i64::from(before) - 1),
        };
        (1..=scans).map(at).collect()
    }

    /// Builds the setting from a time literal; `None` if the value is neither a `TIME` nor an `LTIME`.
    pub fn at(before: u32, time: &Value) -> Option<ClockSetting> {
        match time {
            Value::Plain { ty, raw } if ty.is_duration() => Some(ClockSetting {
                before,
                nanoseconds: raw.cast_signed(),
            }),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_is_told_from_every_other_text() {
        let after = |after| Observation {
            after,
            ..Observation::last("q", "BOOL")
        };
        let (last, third) = (after(None), after(Some(3)));
        assert_eq!(
            (last.key().to_string(), third.key().to_string()),
            ("q".to_owned(), "q@3".to_owned())
        );
        for text in ["q", "q@3", "q@03", "q@", "q2", "p", ""] {
            assert_eq!(last.key().is(text), text == "q", "{text}");
            assert_eq!(third.key().is(text), text == "q@3", "{text}");
        }
    }
}
