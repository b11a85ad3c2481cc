//! Marks, the comments `(*! … *)` in which a program states its expectation.
//!
//! Basis: conformance-cases/README.md (marks).

use std::fmt::Display;
use std::str::FromStr;

use stickler_types::{Code, DialectName, Fault, Value};

use crate::condition::Condition;
use crate::template::Template;

/// A mark, ready to be applied to each expansion of its program.
#[derive(Clone, Debug)]
pub(crate) struct Mark {
    /// The 1-based line of the template.
    pub(crate) line: u32,
    /// The byte offset in the template.
    pub(crate) offset: usize,
    pub(crate) condition: Condition,
    /// The dialects in which the mark applies; all of them for `None`.
    pub(crate) dialects: Option<Vec<DialectName>>,
    pub(crate) claim: MarkClaim,
}

/// The claim of a mark.
#[derive(Clone, Debug)]
pub(crate) enum MarkClaim {
    /// Diagnostics with these codes name the line.
    Error(Vec<Known<Code>>),
    /// Warnings with these codes name the line; they alone reject nothing.
    Warning(Vec<Known<Code>>),
    /// No diagnostic, neither error nor warning, names the line of the mark.
    Ok,
    Fault(Known<Fault>),
    Values {
        after: Option<u32>,
        values: Vec<ValueLine>,
    },
    Rendered(Template),
    Observe {
        name: Template,
        ty: Template,
        after: Option<u32>,
    },
    ObserveAcceptance,
    Set {
        name: Template,
        value: Known<Value>,
        before: u32,
    },
    Clock {
        value: Known<Value>,
        before: u32,
    },
    /// What is set and expected in one scan, or in a table with a line for each.
    Scans {
        text: Template,
        is_table: bool,
    },
}

/// One line of a `values` block.
#[derive(Clone, Debug)]
pub(crate) struct ValueLine {
    pub(crate) name: Template,
    pub(crate) value: Known<Value>,
    /// The 1-based line of the template.
    pub(crate) line: u32,
}

/// A word of a mark that is known at once, or only when the placeholders are replaced.
#[derive(Clone, Debug)]
pub(crate) enum Known<T> {
    Now(T),
    Later(Template),
}

/// A kind of word that a mark can name.
pub(crate) trait MarkWord: Sized + Clone {
    fn read(text: &str) -> Result<Self, String>;
}

impl MarkWord for Code {
    fn read(text: &str) -> Result<Self, String> {
        from_str(text)
    }
}

impl MarkWord for Fault {
    fn read(text: &str) -> Result<Self, String> {
        from_str(text)
    }
}

impl MarkWord for Value {
    fn read(text: &str) -> Result<Self, String> {
        Value::parse_expected(text).map_err(|error| format!("`{text}` is no typed literal: {error}"))
    }
}

fn from_str<T: FromStr<Err: Display>>(text: &str) -> Result<T, String> {
    text.parse().map_err(|error: T::Err| error.to_string())
}

impl<T: MarkWord> Known<T> {
    /// Returns the word with its placeholders replaced; `scratch` is a buffer that is reused.
    pub(crate) fn get(&self, scratch: &mut String, values: &[&str]) -> Result<T, String> {
        match self {
            Known::Now(thing) => Ok(thing.clone()),
            Known::Later(template) => T::read(&template.fill(scratch, values)),
        }
    }
}
