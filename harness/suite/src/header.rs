//! The header of a program file, and the keys that program files and tables share.

use std::sync::Arc;

use serde::Deserialize;
use toml::Spanned;

use crate::frame::Withdrawal;

/// The header of a `.st` file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Header {
    pub(crate) title: String,
    pub(crate) basis: Spanned<String>,
    pub(crate) dialects: Vec<Spanned<String>>,
    pub(crate) id: Option<Spanned<String>>,
    pub(crate) scans: Option<Spanned<u32>>,
    #[serde(default)]
    pub(crate) tags: Vec<String>,
    pub(crate) summary: Option<String>,
    pub(crate) edition: Option<Spanned<u8>>,
    #[serde(default)]
    pub(crate) set: Vec<SetKey>,
    #[serde(default)]
    pub(crate) clock: Vec<ClockKey>,
    pub(crate) withdrawn: Option<WithdrawnKey>,
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

/// `[withdrawn]`: the cases keep their ids and are not run.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct WithdrawnKey {
    pub(crate) reason: String,
    pub(crate) date: String,
}

impl From<&WithdrawnKey> for Withdrawal {
    fn from(key: &WithdrawnKey) -> Self {
        Withdrawal {
            reason: key.reason.as_str().into(),
            date: key.date.as_str().into(),
        }
    }
}

/// Tags as cases share them.
pub(crate) fn tags<'a>(tags: impl Iterator<Item = &'a String>) -> Arc<[Arc<str>]> {
    tags.map(|tag| Arc::from(tag.as_str())).collect()
}
