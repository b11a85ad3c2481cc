//! The plan of a run, its summary, and its errors.

use crate::event::{RERUN_DIALECT, RERUN_ID, rerun};
use crate::{Baseline, DefinedHeader, Filter, Grade, MatchedBaseline, Totals};
use jiff::civil::Date;
use std::collections::BTreeMap;
use stickler_engines::{EngineError, Identity, Reference};
use stickler_suite::{Case, Suite};
use stickler_types::{Code, DialectName};
use stickler_workers::{Shard, SpawnError};

/// The plan of a run: which cases it runs and how. The default runs every case of the suite, each engine judged by the best
/// grade that it claims.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// The number of workers; 0 stands for one per processor.
    pub jobs: usize,
    /// Whether every program is given to an engine alone, even where the engine would take several at a time.
    pub unpacked: bool,
    /// The filters of the run; a case that fits any of them is selected, and every case where there is none.
    pub filters: Vec<Filter>,
    /// The filters of the cases that are left out, whatever else selects them.
    pub excluded: Vec<Filter>,
    /// The dialects of the run; all where there is none.
    pub dialects: Vec<DialectName>,
    /// The part of a divided run; `None` runs the whole.
    pub shard: Option<Shard>,
    /// The worst grade of a rejection or a fault that still passes; `None` stands for the best grade that each engine
    /// claims.
    pub strict: Option<Grade>,
    /// Whether an engine that misses one of Stickler's own rules fails the case; otherwise it differs.
    pub strict_rules: bool,
    /// The baselines of engines; of several for one engine the first counts.
    pub baselines: Vec<Baseline>,
    /// The features that engines are declared to lack, by the name of the engine and their keys in `features.toml`.
    pub lacks: BTreeMap<String, Vec<String>>,
    /// The custom dialects of the run, for the header.
    pub defined: Vec<DefinedHeader>,
    /// The day on which entries of baselines must hold; the caller states it, since this crate reads no calendar.
    pub today: Date,
    /// The time at which the run began, for the header.
    pub started: String,
    /// The command that was typed, for the header.
    pub command: String,
    /// The beginning of the command that runs one case again, before `--filter 'ID' --dialect D`.
    pub rerun_prefix: String,
    /// The argument of `--engine`, quoted for a shell, by the name of the engine; an engine without an entry is requested by
    /// its name.
    pub asked_for: BTreeMap<String, String>,
}

/// The summary of a run that ended.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct RunSummary {
    /// The verdict counts of all case events that reached the sink.
    pub totals: Totals,
    /// The number of case events that reached the sink.
    pub cases: u64,
    /// The number of case events that rest on answers of an earlier run.
    pub from_cache: u64,
    /// The number of baseline entries that are out of date.
    pub outdated: u64,
    /// The number of features that an engine lacks although a source that binds it promises them.
    pub lacking: u64,
    /// Whether the run was cut short, so that there was no footer.
    pub cancelled: bool,
}

/// An error that prevents or ends a run.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// Filter, dialects, shard and engines leave nothing to run. Exit code 4.
    #[error("no case is selected")]
    NoCaseSelected,
    /// An engine could not be run. Exit code 3.
    #[error(transparent)]
    Engine(#[from] EngineError),
    /// An engine rejects even a program that uses no feature of the language, so that no case can tell anything. Exit code 3.
    #[error(
        "{engine} rejects even the plainest program in the dialect {dialect}, which declares `x : INT` and has the statement `x := x;` ({said}); \
         see `stickler engine --validate`, or leave the dialect out with --dialect"
    )]
    RejectsAll {
        /// The name of the engine.
        engine: String,
        /// The dialect of the program.
        dialect: DialectName,
        /// The answer of the engine.
        said: String,
    },
    /// The worker threads could not be started.
    #[error(transparent)]
    Workers(#[from] SpawnError),
}

impl Plan {
    /// Returns the worst grade of a rejection or a fault by this engine that still passes. The reference must always meet
    /// code and line, but for the codes that only other compilers give.
    pub fn strict(&self, engine: &Identity) -> Grade {
        match engine.name.as_str() {
            Reference::NAME => Grade::Code,
            _ => self.strict.unwrap_or(engine.grade),
        }
    }

    /// Returns the worst grade of a rejection or a fault in this case by this engine that still passes: the one of
    /// [`Plan::strict`], but the line where the case asks for a code that the engine's version does not have, or of a compiler by a rule
    /// of Stickler, which names no code of it.
    pub fn needed(&self, engine: &Identity, case: &Case) -> Grade {
        let expected = case.expectation.diagnostics.iter();
        self.needed_for(engine, &case.basis, expected.map(|expected| expected.code))
    }

    /// Returns what [`Plan::needed`] returns, for a case with this basis that asks for these codes.
    pub fn needed_for(&self, engine: &Identity, basis: &str, mut codes: impl Iterator<Item = Code>) -> Grade {
        let strict = self.strict(engine);
        let is_taste = basis.starts_with("rule:") && engine.name != Reference::NAME;
        match is_taste || codes.any(|code| engine.lacks.contains(&code)) {
            true => strict.max(Grade::Line),
            false => strict,
        }
    }

    /// Returns the baseline of this engine, matched with the suite; `None` where there is none.
    pub fn matched_baseline<'s>(&self, suite: &'s Suite, engine: &Identity) -> Option<MatchedBaseline<'s>> {
        let baseline = self
            .baselines
            .iter()
            .find(|baseline| baseline.engine == engine.name)?;
        Some(MatchedBaseline::new(baseline, suite, engine, self.today))
    }

    /// Returns the command that runs this case again on this engine, for pasting into a shell.
    pub fn rerun(&self, case: &Case, engine: &str) -> String {
        rerun(&self.rerun_template(engine), &case.id, case.dialect.as_str())
    }

    /// Returns the template of the command that runs a case again on this engine, with placeholders that
    /// [`EngineHeader::rerun`] fills in.
    ///
    /// [`EngineHeader::rerun`]: crate::EngineHeader::rerun
    pub fn rerun_template(&self, engine: &str) -> String {
        let engine = match self.asked_for.get(engine).map_or(engine, String::as_str) {
            Reference::NAME => String::new(),
            asked_for => format!(" --engine {asked_for}"),
        };
        // A filter that is an id selects that case alone, so the id itself will do.
        let case = format!(" --filter '{RERUN_ID}' --dialect {RERUN_DIALECT}");
        format!("{}{engine}{case}", self.rerun_prefix)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_engines::Engine;

    #[test]
    fn an_engine_is_judged_by_what_it_claims_unless_the_plan_says_otherwise_and_the_reference_never_less_than_exactly()
     {
        let reference = Reference::new();
        let compiler = Identity {
            name: "compiler".to_owned(),
            grade: Grade::Line,
            lacks: Vec::new(),
            ..reference.identity().clone()
        };
        let strict = |strict| {
            let plan = Plan {
                strict,
                ..Plan::default()
            };
            (plan.strict(&compiler), plan.strict(reference.identity()))
        };
        assert_eq!(strict(None), (Grade::Line, Grade::Code));
        assert_eq!(strict(Some(Grade::Code)), (Grade::Code, Grade::Code));
        assert_eq!(strict(Some(Grade::Rejected)), (Grade::Rejected, Grade::Code));
    }
}
