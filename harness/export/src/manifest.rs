//! What an export writes beside its pages, so that an import needs nothing else: which page is which, and which case stands
//! in which element.

use crate::ExportError;
use crate::page::{FIRST_OBSERVATION, Page};
use crate::record::CaseRecord;
use serde::{Deserialize, Serialize};
use std::fs;
use std::io::ErrorKind;
use std::path::Path;
use stickler_run::DefinedHeader;

/// What its file is called.
pub const MANIFEST: &str = "manifest.json";

/// The version of its format.
const FORMAT: u32 = 1;

/// No array has as many elements; a page has a thousand, and more only where one case alone has.
const MAX_ARRAY_ELEMENTS: usize = 1_000_000;

/// An export.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub(crate) struct Manifest {
    /// The version of this format.
    pub(crate) format: u32,
    /// The version of Stickler that wrote it.
    pub(crate) stickler: String,
    /// The version of the suite.
    pub(crate) suite: String,
    /// The dialect of all cases.
    pub(crate) dialect: String,
    /// What it was when they were exported, where stickler.toml defines it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) defined: Option<DefinedHeader>,
    /// Its pages, in the order of their numbers.
    pub(crate) pages: Vec<PageRecord>,
}

/// A page.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub(crate) struct PageRecord {
    /// The file of the page.
    pub(crate) file: String,
    /// Its number, from 1.
    pub(crate) number: usize,
    /// Its own number, which every array of its results holds; 0 where it is only compiled.
    pub(crate) identity: i32,
    /// How many elements its array has; 0 where it is only compiled.
    pub(crate) elements: usize,
    /// Its cases, in order.
    pub(crate) cases: Vec<CaseRecord>,
    /// Its observations, in order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) steps: Vec<StepRecord>,
    /// The cases that had an answer, by their places: their programs are not there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) answered: Vec<usize>,
    /// What messages about it can be led back by.
    pub(crate) lines: LinesRecord,
}

/// The lines of a page.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub(crate) struct LinesRecord {
    /// How many lines of POUs and types stand before its program; the other numbers count from there.
    pub(crate) units: usize,
    /// How many lines stand before its statements.
    pub(crate) declarations: usize,
    /// The lines of each case, stretch by stretch. Of a page that is only compiled, those of the first statement and of the last come behind
    /// them.
    pub(crate) cases: Vec<Vec<(usize, usize)>>,
}

/// An observation.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub(crate) struct StepRecord {
    /// The case, by its place among those of the page.
    pub(crate) case: usize,
    /// The variable, by its place among those that the case observes; none where the case only has to run.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) observe: Option<usize>,
    /// Its first element.
    pub(crate) place: usize,
}

impl Manifest {
    pub(crate) fn new(suite: &str, dialect: &str) -> Manifest {
        Manifest {
            format: FORMAT,
            stickler: env!("CARGO_PKG_VERSION").to_owned(),
            suite: suite.to_owned(),
            dialect: dialect.to_owned(),
            defined: None,
            pages: Vec::new(),
        }
    }

    /// Tells whether a file is the manifest of an export, of whatever format.
    pub(crate) fn is_at(path: &Path) -> bool {
        #[derive(Deserialize)]
        struct Origin {
            #[serde(rename = "stickler")]
            _stickler: String,
        }
        fs::read(path).is_ok_and(|bytes| serde_json::from_slice::<Origin>(&bytes).is_ok())
    }

    /// Reads that of a folder.
    ///
    /// # Errors
    /// [`ExportError::NoExport`] where there is none, [`ExportError::Read`] and [`ExportError::Manifest`] where it cannot be
    /// understood.
    pub(crate) fn read(folder: &Path) -> Result<Manifest, ExportError> {
        let path = folder.join(MANIFEST);
        let text = match fs::read_to_string(&path) {
            Ok(text) => text,
            Err(error) if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => {
                return Err(ExportError::NoExport(folder.to_owned()));
            }
            Err(error) => return Err(ExportError::Read(path, error)),
        };
        let broken = |what: String| ExportError::Manifest(path.clone(), what);
        let manifest: Manifest = serde_json::from_str(&text).map_err(|error| broken(error.to_string()))?;
        if manifest.format != FORMAT {
            return Err(broken(format!(
                "its format is {}, and this version of Stickler reads {FORMAT}",
                manifest.format
            )));
        }
        manifest.check().map_err(broken)?;
        Ok(manifest)
    }

    /// # Errors
    /// A fragment that says what points nowhere.
    fn check(&self) -> Result<(), String> {
        for page in &self.pages {
            let ends = if page.is_compiled() { 2 } else { 0 };
            if page.lines.cases.len() != page.cases.len() + ends {
                return Err(format!(
                    "the lines of page {} are not those of its cases",
                    page.number
                ));
            }
            let has_array = (FIRST_OBSERVATION + 1..=MAX_ARRAY_ELEMENTS).contains(&page.elements);
            if !page.is_compiled() && !has_array {
                return Err(format!("page {} has no array of results", page.number));
            }
            let is_outside = |step: &StepRecord| {
                step.case >= page.cases.len() || step.place.saturating_add(2) >= page.elements.max(3)
            };
            if page.steps.iter().any(is_outside) {
                return Err(format!(
                    "an observation of page {} stands outside it",
                    page.number
                ));
            }
            if page.answered.iter().any(|case| *case >= page.cases.len()) {
                return Err(format!(
                    "page {} has an answer for none of its cases",
                    page.number
                ));
            }
            if page
                .lines
                .cases
                .iter()
                .flatten()
                .any(|(first, last)| first > last)
            {
                return Err(format!("lines of page {} end before they begin", page.number));
            }
        }
        Ok(())
    }
}

impl PageRecord {
    /// Tells whether it is only compiled, and has no array.
    pub(crate) fn is_compiled(&self) -> bool {
        self.identity == 0
    }

    pub(crate) fn of(page: &Page<'_, '_>, file: String) -> PageRecord {
        let steps = page.steps.iter().map(|step| StepRecord {
            case: step.case,
            observe: step.observe,
            place: step.place,
        });
        PageRecord {
            file,
            number: page.number,
            identity: page.identity,
            elements: page.elements,
            cases: page
                .cases
                .iter()
                .map(|ready| CaseRecord::of(ready.case))
                .collect(),
            steps: steps.collect(),
            answered: (0..page.cases.len())
                .filter(|case| page.cases[*case].answered)
                .collect(),
            lines: LinesRecord {
                units: if page.units.is_empty() {
                    0
                } else {
                    page.units.matches('\n').count() + 2
                },
                declarations: page.declarations.matches('\n').count(),
                cases: page.lines.clone(),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value as Json, json};

    /// Returns what is said of a manifest with one page, of which these keys are other ones.
    fn read(changes: &[(&str, Json)]) -> Result<Manifest, String> {
        let mut page = json!({
            "file": "page-001.st", "number": 1, "identity": 1000, "elements": 11, "cases": [],
            "lines": { "units": 0, "declarations": 1, "cases": [] },
        });
        for (key, value) in changes {
            page[key] = value.clone();
        }
        let manifest =
            json!({ "format": FORMAT, "stickler": "1", "suite": "1", "dialect": "matiec", "pages": [page] });
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join(MANIFEST), manifest.to_string()).expect("written");
        Manifest::read(folder.path()).map_err(|error| error.to_string())
    }

    #[test]
    fn what_points_nowhere_is_told() {
        assert!(read(&[]).is_ok());
        let lines = |cases: Json| ("lines", json!({ "units": 0, "declarations": 1, "cases": cases }));
        for (changes, told) in [
            (
                vec![lines(json!([[]]))],
                "the lines of page 1 are not those of its cases",
            ),
            (vec![("elements", json!(5))], "page 1 has no array of results"),
            (
                vec![("elements", json!(u64::MAX))],
                "page 1 has no array of results",
            ),
            (
                vec![("steps", json!([{ "case": 0, "place": 8 }]))],
                "an observation of page 1 stands outside it",
            ),
            (
                vec![("answered", json!([0]))],
                "page 1 has an answer for none of its cases",
            ),
            (
                vec![("identity", json!(0)), lines(json!([[[3, 2]], []]))],
                "lines of page 1 end before they begin",
            ),
        ] {
            let error = read(&changes).expect_err(told);
            assert!(
                error.ends_with(&format!("{MANIFEST}: {told}; export again")),
                "{error}"
            );
        }
    }
}
