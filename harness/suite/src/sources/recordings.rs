//! The recordings of compilers below `recordings/` as a source: a case cites one by the name of its file, `recording: my-plc`.

use std::collections::BTreeMap;

use serde::Deserialize;
use stickler_types::{RecordingOrigin, Relation, sorted};

use super::{RECORDING, RecordedOrigin, Sections, Source, SourceKind};
use crate::files::{self, RECORDINGS};

/// The part of the file of a recording that says what answered; the answers are none of the suite's business.
#[derive(Deserialize)]
struct RecordingHead {
    recording: RecordingOrigin,
    #[serde(default)]
    answers: Vec<RecordedDialects>,
}

#[derive(Deserialize)]
struct RecordedDialects {
    dialects: Vec<String>,
}

/// Returns the recordings of the suite at `root` as a source, whose sections are their files.
pub(super) fn read(root: &files::Root) -> Source {
    let read = |name: String| {
        let text = files::read(&root.path().join(format!("{RECORDINGS}/{name}.toml")));
        let section = text
            .map_err(|mistake| mistake.message)
            .and_then(|text| section(&text));
        (name, section)
    };
    let names = files::names(&root.path().join(RECORDINGS), "toml");
    let recorded: BTreeMap<String, Result<RecordedOrigin, String>> = names.into_iter().map(read).collect();
    let usable = recorded
        .iter()
        .filter_map(|(name, section)| Some((name, section.as_ref().ok()?)));
    let dialects = sorted(usable.clone().flat_map(|(_, section)| section.dialects.clone()));
    Source {
        key: RECORDING.to_owned(),
        title: "Recordings of compilers".to_owned(),
        publisher: "Contributors".to_owned(),
        relation: Relation::Maker,
        kind: SourceKind::Recording,
        address: root.shown(&format!("{RECORDINGS}/{{section}}.toml")),
        read: "as each file says".to_owned(),
        dialects,
        sections: Sections {
            headings: usable.map(|(name, _)| (name.clone(), 1)).collect(),
            forms: Vec::new(),
        },
        recorded,
        line: 1,
        ..Source::default()
    }
}

/// Returns what the text of a recording says about its origin.
///
/// # Errors
/// A message where it does not say its product, version, platform and date: nobody could tell for whom it speaks.
fn section(text: &str) -> Result<RecordedOrigin, String> {
    let RecordingHead { recording, answers } = toml::from_str(&head(text)).map_err(|error| {
        let message = error.message().trim_end().replace('\n', "; ");
        format!("{message}; {}", RecordingOrigin::REQUIRED)
    })?;
    if let Some(mistake) = recording.mistake() {
        return Err(mistake);
    }
    let names = answers.iter().flat_map(|answers| &answers.dialects);
    Ok(RecordedOrigin {
        origin: recording,
        dialects: names.filter_map(|name| name.parse().ok()).collect(),
    })
}

/// Returns the text without the tables of its answers, so that reading it costs little.
fn head(text: &str) -> String {
    let mut is_answer = false;
    let mut head = String::new();
    for line in text.lines() {
        if line.starts_with('[') {
            is_answer = line.starts_with("[answers.");
        }
        if !is_answer {
            head.push_str(line);
            head.push('\n');
        }
    }
    head
}
