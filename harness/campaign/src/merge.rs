//! The parts of a campaign put together: each finding once, and what is missing said.

use crate::finding::Finding;
use crate::record::{CampaignRequest, RECORD, Record};
use crate::store::Store;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The findings that several folders hold together.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Merged {
    /// The best finding of each name.
    pub findings: BTreeMap<String, Finding>,
    /// The campaigns of which there are parts, each once, put together.
    pub campaigns: Vec<Record>,
    /// Parts that are missing, cut short or unreadable, a sentence each. Where there is one, the rest is not the whole.
    pub missing: Vec<String>,
}

/// Puts folders together. It never fails: what cannot be read is told in [`Merged::missing`].
pub fn merge(folders: &[PathBuf]) -> Merged {
    let mut merged = Merged::default();
    let mut parts: BTreeMap<CampaignKey, Vec<(Record, &PathBuf)>> = BTreeMap::new();
    for folder in folders {
        match Record::read(folder) {
            Ok(Some(record)) => {
                let key = (record.asked.clone(), record.parts, record.stickler.clone());
                parts.entry(key).or_default().push((record, folder));
            }
            Ok(None) => merged.missing.push(format!(
                "{} has no {RECORD}, so nobody can tell whether its campaign came to its end",
                folder.display()
            )),
            Err(error) => merged.missing.push(error.to_string()),
        }
        merged.take_findings(folder);
    }
    parts.values().for_each(|parts| merged.take_campaign(parts));
    let names: Vec<String> = merged.findings.keys().cloned().collect();
    merged
        .campaigns
        .iter_mut()
        .for_each(|campaign| campaign.findings.clone_from(&names));
    merged
}

/// Parts of one campaign agree on what was asked, on the number of parts, and on the version of Stickler.
type CampaignKey = (CampaignRequest, u32, String);

impl Merged {
    fn take_findings(&mut self, folder: &Path) {
        let (findings, errors) = match Store::findings(folder) {
            Ok(found) => found,
            Err(error) => return self.missing.push(error.to_string()),
        };
        self.missing.extend(errors.iter().map(ToString::to_string));
        for finding in findings {
            if finding.is_best_of(&self.findings) {
                self.findings.insert(finding.id.clone(), finding);
            }
        }
    }

    fn take_campaign(&mut self, parts: &[(Record, &PathBuf)]) {
        let Some((first, _)) = parts.first() else { return };
        let (asked, count) = (&first.asked, first.parts);
        let before = self.missing.len();
        for (record, folder) in parts {
            if !record.complete {
                self.missing.push(format!(
                    "part {} of {count} ({}) was cut short, or still goes on",
                    record.part,
                    folder.display()
                ));
            }
        }
        let mut shown = 0;
        for part in 1..=count {
            let there: Vec<String> = parts
                .iter()
                .filter(|(record, _)| record.part == part)
                .map(|(_, folder)| folder.display().to_string())
                .collect();
            match &there[..] {
                [_] => {}
                // A hostile number of parts must not make as many sentences.
                [] if shown >= MOST_SENTENCES => {}
                [] => {
                    shown += 1;
                    self.missing.push(format!(
                        "part {part} of {count} of seed {} is missing",
                        asked.seed
                    ));
                }
                several => {
                    self.missing.push(format!(
                        "part {part} of {count} is there more than once: {}",
                        several.join(", ")
                    ));
                }
            }
            if shown >= MOST_SENTENCES {
                self.missing.push(format!("and so may be parts behind {part}"));
                break;
            }
        }
        let all = |of: fn(&Record) -> u64| {
            parts
                .iter()
                .map(|(record, _)| of(record))
                .fold(0, u64::saturating_add)
        };
        self.campaigns.push(Record {
            part: 1,
            parts: 1,
            complete: self.missing.len() == before,
            programs: all(|record| record.programs),
            disagreements: all(|record| record.disagreements),
            ..first.clone()
        });
    }
}

/// The number of missing parts that are named one by one.
const MOST_SENTENCES: u32 = 20;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::FORMAT;
    use crate::sample;
    use std::fs;
    use stickler_mdtest::assert_fits;

    fn record(part: u32, complete: bool) -> Record {
        Record {
            format: FORMAT,
            stickler: "0.1.0".to_owned(),
            asked: CampaignRequest {
                seed: 7,
                count: Some(100),
                targets: vec!["execute".to_owned()],
                ..CampaignRequest::default()
            },
            part,
            parts: 3,
            complete,
            programs: 33,
            disagreements: 2,
            ..Record::default()
        }
    }

    fn folder(root: &Path, name: &str, record: Option<Record>, findings: &[Finding]) -> PathBuf {
        let folder = root.join(name);
        let store = Store::open(&folder).unwrap();
        for finding in findings {
            store.save(finding).unwrap();
        }
        record.iter().for_each(|record| record.write(&folder).unwrap());
        folder
    }

    #[test]
    fn each_finding_of_the_parts_comes_once_and_the_smallest_stays() {
        let root = tempfile::tempdir().unwrap();
        let large = sample::finding("a", "crash", &["FOR"], 30);
        let small = sample::finding("a", "crash", &["FOR"], 5);
        let other = sample::finding("a", "value:INT", &["MOD"], 9);
        let folders = [
            folder(root.path(), "1", Some(record(1, true)), &[large]),
            folder(
                root.path(),
                "2",
                Some(record(2, true)),
                &[small.clone(), other.clone()],
            ),
            folder(root.path(), "3", Some(record(3, true)), &[]),
        ];
        let merged = merge(&folders);
        assert_eq!(merged.missing, Vec::<String>::new());
        assert_eq!(merged.findings.into_values().collect::<Vec<_>>(), [small, other]);
        let [campaign] = &merged.campaigns[..] else {
            panic!("one campaign")
        };
        assert_eq!(
            (campaign.programs, campaign.disagreements, campaign.complete),
            (99, 6, true)
        );
    }

    #[test]
    fn parts_that_are_missing_or_cut_short_or_there_twice_are_named() {
        let root = tempfile::tempdir().unwrap();
        let folders = [
            folder(root.path(), "1", Some(record(1, false)), &[]),
            folder(root.path(), "again", Some(record(1, true)), &[]),
            folder(root.path(), "3", Some(record(3, true)), &[]),
            folder(root.path(), "nothing", None, &[]),
            root.path().join("nowhere"),
        ];
        let merged = merge(&folders);
        let text = merged.missing.join("\n");
        for sentence in [
            "1) was cut short",
            "part 1 of 3 is there more than once: ",
            "part 2 of 3 of seed 7 is missing",
            "nothing has no campaign.json",
            "cannot read ",
        ] {
            assert!(text.contains(sentence), "{sentence} in\n{text}");
        }
        assert!(!merged.campaigns[0].complete);
    }

    #[test]
    fn a_file_of_another_version_is_not_misread() {
        let root = tempfile::tempdir().unwrap();
        let folder = folder(root.path(), "1", None, &[]);
        fs::write(folder.join(RECORD), r#"{"format": 2}"#).unwrap();
        let merged = merge(&[folder]);
        assert_fits(&merged.missing[0], "…its form is 2…");
    }
}
