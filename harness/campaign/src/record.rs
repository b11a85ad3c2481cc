//! The record of a campaign, and whether it came to its end: a file beside its findings.

use crate::store::{StoreError, of_format};
use crate::survey::FailingPart;
use serde::{Deserialize, Serialize};
use std::fs;
use std::path::Path;

/// The name of the file.
pub const RECORD: &str = "campaign.json";

/// The version of the form of the file.
pub const FORMAT: u32 = 1;

/// A campaign, or one part of one.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub struct Record {
    /// [`FORMAT`].
    pub format: u32,
    /// The version of Stickler that ran it.
    pub stickler: String,
    /// The options of the campaign.
    pub asked: CampaignRequest,
    /// The number of the part, from 1.
    pub part: u32,
    /// The number of parts.
    pub parts: u32,
    /// Whether the campaign came to its end. A file that says `false` was left by a campaign that was cut short, or still runs.
    pub complete: bool,
    /// Inputs that were judged or passed over.
    pub programs: u64,
    /// The number of disagreements.
    pub disagreements: u64,
    /// The names of the findings.
    pub findings: Vec<String>,
    /// The parts of the language with which an engine failed alone before the campaign, so that its programs have none of them.
    #[serde(default)]
    pub failing: Vec<FailingPart>,
}

/// The options of a campaign, which are the same for all its parts.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Default, Serialize, Deserialize)]
pub struct CampaignRequest {
    /// The seed.
    pub seed: u64,
    /// The first place.
    pub first: u64,
    /// The number of places to try; `None` where a time was given.
    pub count: Option<u64>,
    /// The time in milliseconds; `None` where a number of places was given.
    pub milliseconds: Option<u64>,
    /// The targets.
    pub targets: Vec<String>,
    /// The engines, by name.
    pub engines: Vec<String>,
    /// The dialects that were asked for.
    pub dialects: Vec<String>,
    /// Whether programs could use what documents leave open.
    pub open: bool,
    /// The parts of the language that programs shall not have.
    #[serde(default)]
    pub without: Vec<String>,
    /// The number of bytes of the largest inputs, where they were limited.
    #[serde(default)]
    pub max_input: Option<usize>,
}

impl Record {
    /// Writes the file; what was there before is replaced as a whole.
    ///
    /// # Errors
    /// [`StoreError::Write`].
    pub fn write(&self, folder: &Path) -> Result<(), StoreError> {
        let path = folder.join(RECORD);
        let fresh = folder.join(format!(".{RECORD}-{}", std::process::id()));
        let text = serde_json::to_string_pretty(self).map_err(|error| StoreError::Write {
            path: path.clone(),
            error: error.into(),
        })?;
        let written = fs::write(&fresh, text + "\n").and_then(|()| fs::rename(&fresh, &path));
        written.map_err(|error| {
            // What is left has a name that begins with a point, and no reader looks at it.
            let _ = fs::remove_file(&fresh);
            StoreError::Write { path, error }
        })
    }

    /// Reads the file of a folder; `None` where there is none.
    ///
    /// # Errors
    /// [`StoreError::Read`]; [`StoreError::NotACampaign`] where it is of another form.
    pub fn read(folder: &Path) -> Result<Option<Record>, StoreError> {
        let path = folder.join(RECORD);
        let text = match fs::read_to_string(&path) {
            Ok(text) => text,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(StoreError::Read { path, error }),
        };
        let record = of_format(&text, FORMAT, RECORD, "").map(Some);
        record.map_err(|reason| StoreError::NotACampaign { path, reason })
    }
}
