//! The header of a program file, and the keys that program files and tables share.

use std::sync::Arc;

use serde::Deserialize;
use toml::Spanned;

use crate::bases::Bases;

/// The header of a `.st` file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FileHeader {
    pub(crate) title: String,
    pub(crate) basis: Option<Spanned<Bases>>,
    pub(crate) dialects: Vec<Spanned<String>>,
    pub(crate) scans: Option<Spanned<u32>>,
    #[serde(default)]
    pub(crate) tags: Vec<String>,
    pub(crate) summary: Option<String>,
    #[serde(default)]
    pub(crate) set: Vec<SetKey>,
    #[serde(default)]
    pub(crate) clock: Vec<ClockKey>,
}

/// `[[set]]`: a variable that is written before a scan.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SetKey {
    pub(crate) before: Spanned<u32>,
    pub(crate) name: String,
    pub(crate) value: Spanned<String>,
}

/// `[[clock]]`: the time before a scan.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ClockKey {
    pub(crate) before: Spanned<u32>,
    pub(crate) value: Spanned<String>,
}

/// Converts tags to the form that cases share.
pub(crate) fn tags<'a>(tags: impl Iterator<Item = &'a String>) -> Arc<[Arc<str>]> {
    tags.map(|tag| Arc::from(tag.as_str())).collect()
}
