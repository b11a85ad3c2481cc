//! The origin of a recording of a compiler's answers: what answered, in which version, and when.

use crate::Value;
use serde::{Deserialize, Serialize};

/// The origin of a recording.
#[derive(Clone, PartialEq, Eq, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct RecordingOrigin {
    /// The name of the compiler.
    pub product: String,
    /// The version of the compiler.
    pub version: String,
    /// The commit of the compiler's sources, where it is known.
    pub commit: Option<String>,
    /// The operating system and the processor on which the compiler ran.
    pub platform: String,
    /// The day, as in `2026-11-24`.
    pub date: String,
}

impl RecordingOrigin {
    /// The sentence that says what the file of a recording must have, for messages about a file that lacks some of it.
    pub const REQUIRED: &str = "a recording says in [recording] its product, version, platform and date";

    /// Returns what is wrong with the origin, and what to do, as a fragment; `None` where it says what a recording must say.
    pub fn mistake(&self) -> Option<String> {
        let said = [
            ("product", &self.product),
            ("version", &self.version),
            ("platform", &self.platform),
            ("date", &self.date),
        ];
        if let Some((key, _)) = said.iter().find(|(_, text)| text.trim().is_empty()) {
            return Some(format!(
                "`{key}` is empty; say there what was recorded, for answers differ with it"
            ));
        }
        let is_date =
            Value::parse(&format!("DATE#{}", self.date)).is_ok() && self.date.len() == "2026-11-24".len();
        (!is_date).then(|| format!("`{}` is no date such as 2026-11-24", self.date))
    }

    /// Returns whether an engine with this name is the recorded compiler: `file` is the name of the recording's file without its ending, and
    /// it or the product names the engine.
    pub fn is_of(&self, file: &str, engine: &str) -> bool {
        [file, &self.product]
            .into_iter()
            .any(|name| name.eq_ignore_ascii_case(engine))
    }
}
