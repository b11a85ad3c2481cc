//! What to run and how, and what can keep a run from being one.

use crate::event::{RERUN_DIALECT, RERUN_ID, rerun};
use crate::{Baseline, DefinedHeader, Filter, Grade, MatchedBaseline, Totals};
use jiff::civil::Date;
use std::collections::BTreeMap;
use stickler_engines::{EngineError, Identity, Reference};
use stickler_suite::{Case, Suite};
use stickler_types::DialectName;
use stickler_workers::{Shard, SpawnError};

/// What to run and how. The default runs every case of the suite, each engine judged by the best grade that it claims.
#[derive(Clone, Debug)]
pub struct Plan {
    /// How many workers; 0 is one a processor.
    pub jobs: usize,
    /// Every program is given to an engine alone, also where the engine would take several at a time.
    pub unpacked: bool,
    /// Cases that fit any of these; all where there is none.
    pub filters: Vec<Filter>,
    /// Cases of any of these dialects; all where there is none.
    pub dialects: Vec<DialectName>,
    /// One part of a divided run.
    pub shard: Option<Shard>,
    /// How exact a rejection or a fault must be to pass; `None` is the best grade that each engine claims.
    pub strict: Option<Grade>,
    /// What is known of engines; of each engine the first that names it counts.
    pub baselines: Vec<Baseline>,
    /// The dialects of the run that were defined, for the header.
    pub defined: Vec<DefinedHeader>,
    /// The day on which entries of baselines must hold; this crate reads no calendar.
    pub today: Date,
    /// When the run began, for the header.
    pub started: String,
    /// The command that was typed, for the header.
    pub command: String,
    /// What stands in front of `--filter 'ID' --dialect D` in the command that runs one case again.
    pub rerun_prefix: String,
    /// What stands behind `--engine` for the engine of a name, as a shell takes it; where there is no entry, the name
    /// itself.
    pub asked_for: BTreeMap<String, String>,
}

impl Default for Plan {
    fn default() -> Plan {
        Plan {
            jobs: 0,
            unpacked: false,
            filters: Vec::new(),
            dialects: Vec::new(),
            shard: None,
            strict: None,
            baselines: Vec::new(),
            defined: Vec::new(),
            today: Date::default(),
            started: String::new(),
            command: String::new(),
            rerun_prefix: "cargo run --release -- run".to_owned(),
            asked_for: BTreeMap::new(),
        }
    }
}

/// How a run ended.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Summary {
    /// The verdicts of all case events that were given, counted.
    pub totals: Totals,
    /// How many case events were given.
    pub cases: u64,
    /// How many of them stand on what was answered in an earlier run.
    pub from_cache: u64,
    /// How many entries of baselines are out of date.
    pub outdated: u64,
    /// The run was cut short: there was no footer.
    pub cancelled: bool,
}

/// What keeps a run from being one.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// Filter, dialects, shard and engines leave nothing to run. Exit code 4.
    #[error("no case is selected")]
    NoCaseSelected,
    /// An engine could not be run. Exit code 3.
    #[error(transparent)]
    Engine(#[from] EngineError),
    /// The worker threads could not be started.
    #[error(transparent)]
    Workers(#[from] SpawnError),
}

impl Plan {
    /// How exact a rejection or a fault by this engine must be to pass. The reference must always meet code and line.
    /// Basis: design, section 6.
    #[must_use]
    pub fn strict(&self, engine: &Identity) -> Grade {
        match engine.name.as_str() {
            Reference::NAME => Grade::Code,
            _ => self.strict.unwrap_or(engine.grade),
        }
    }

    /// Returns the baseline of this engine, matched with the suite; `None` where there is none.
    #[must_use]
    pub fn matched_baseline<'s>(&self, suite: &'s Suite, engine: &Identity) -> Option<MatchedBaseline<'s>> {
        let baseline = self
            .baselines
            .iter()
            .find(|baseline| baseline.engine == engine.name)?;
        Some(MatchedBaseline::new(baseline, suite, engine, self.today))
    }

    /// The command that runs this case again on this engine, to be pasted into a shell.
    #[must_use]
    pub fn rerun(&self, case: &Case, engine: &str) -> String {
        rerun(&self.rerun_template(engine), &case.id, case.dialect.as_str())
    }

    /// Returns the command that runs a case again on this engine, with words that [`EngineHeader::rerun`] fills in.
    ///
    /// [`EngineHeader::rerun`]: crate::EngineHeader::rerun
    #[must_use]
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
