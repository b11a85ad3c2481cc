//! Baselines: what an engine is known to do otherwise than documents say, each with its reason, so that a run fails by
//! what is new. Basis: issue "real compilers", *Verdicts*; design, section 1.
//!
//! A baseline changes no expectation and no claim: what it expects is still counted as failed for its document. It may not
//! grow old in silence either: an unexpected pass, an entry that fits no case and one past its date each fail the run.

mod bless;
mod fold;
mod matched;
mod owned;
mod read;
mod write;

pub use bless::{Blessing, Change, ChangeKind, EngineRun, bless};
pub use matched::MatchedBaseline;
pub use read::BaselineError;

use crate::{Filter, Verdict};
use jiff::civil::Date;
use semver::VersionReq;
use stickler_suite::Suite;
use stickler_types::DialectName;

/// The baseline of one engine.
#[derive(Clone, Debug, Default)]
pub struct Baseline {
    /// The engine's name.
    pub engine: String,
    /// The file, as people are told of it.
    pub file: String,
    /// What is expected, in the order of the file.
    pub entries: Vec<Entry>,
}

/// Something that an engine is known to do otherwise.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The cases: an id, or a pattern in which `*` stands for any text; either may end in `@dialect`.
    pub case: Filter,
    /// What comes of them: one that is no pass; or any of several, of a compiler that does not do the same each time.
    pub verdicts: Vec<Verdict>,
    /// Why, for a person.
    pub reason: String,
    /// Where more is written, such as the report in the compiler's tracker.
    pub link: Option<String>,
    /// The versions of the engine for which this holds; all where nothing is said.
    pub versions: Option<VersionReq>,
    /// The last day on which this holds; for good where nothing is said.
    pub until: Option<Date>,
    /// The line of the file on which the entry begins.
    pub line: u32,
}

impl Baseline {
    /// Reads a baseline. `file` is how people are told of it; `stem`, the file's name without its extension, names the engine
    /// where the text itself does not.
    ///
    /// # Errors
    /// [`BaselineError`]: the first mistake, with its line.
    pub fn read(text: &str, file: &str, stem: &str) -> Result<Baseline, BaselineError> {
        read::baseline(text, file, stem)
    }

    /// The name of the file in which the baseline of an engine is sought. Engines of processes call themselves what they
    /// like, so all that could lead elsewhere becomes `-`.
    #[must_use]
    pub fn file_name(engine: &str) -> String {
        let harmless = |character: char| match character {
            'a'..='z' | 'A'..='Z' | '0'..='9' | '-' | '_' | '.' => character,
            _ => '-',
        };
        let stem: String = engine.chars().map(harmless).collect();
        format!("{stem}.toml")
    }

    /// Where an entry stands, such as `reports/baselines/ironplc.toml:12`.
    #[must_use]
    pub fn place(&self, entry: &Entry) -> String {
        format!("{}:{}", self.file, entry.line)
    }
}

impl Entry {
    /// Whether the entry is about a dialect that was defined and of which this suite has no cases: those of such a dialect are there only
    /// where somebody asks for them, so nothing is known of the entry.
    fn is_beside(&self, suite: &Suite) -> bool {
        let is_beside = |dialect: DialectName| {
            dialect.definition().is_some() && !suite.cases.iter().any(|case| case.dialect == dialect)
        };
        self.case.dialect().is_some_and(is_beside)
    }

    /// Whether this is what the entry says.
    fn expects(&self, verdict: Verdict) -> bool {
        self.verdicts.contains(&verdict)
    }

    /// Whether the entry is about this case.
    fn covers(&self, id: &str, dialect: &str) -> bool {
        match self.case.is_pattern() {
            true => self.case.fits(id, dialect),
            false => self.case.names(id, dialect),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Baseline;

    #[test]
    fn the_file_of_a_baseline_stands_where_baselines_stand_whatever_an_engine_calls_itself() {
        assert_eq!(Baseline::file_name("ironplc"), "ironplc.toml");
        assert_eq!(Baseline::file_name("../../etc/pass wd"), "..-..-etc-pass-wd.toml");
    }
}
