//! What is told of a case on an engine: its answers judged, held against the baseline, made an event.

use crate::event::CaseEvent;
use crate::judge::{is_open, judge};
use crate::{Answers, Fact, Held, Judgement, Plan, Verdict};
use std::time::Duration;
use stickler_engines::Identity;
use stickler_suite::Case;

/// All that has to be known of an engine to tell what came of its cases.
#[derive(Clone, Copy, Debug)]
pub struct Teller<'r> {
    /// How it is judged, and how a case is run again.
    pub plan: &'r Plan,
    /// Who it is.
    pub engine: &'r Identity,
    /// Its baseline, where it has one.
    pub held: Option<&'r Held<'r>>,
}

impl Teller<'_> {
    /// The event of a case, by what the engine answered and how long it took.
    #[must_use]
    pub fn event(&self, case: &Case, answers: &Answers, time: Duration) -> CaseEvent {
        let judgement = judge(case, answers, self.plan.strict(self.engine));
        let (judgement, baseline) = match self.held {
            Some(held) => held.apply(&case.id, case.dialect, judgement),
            None => (judgement, None),
        };
        let expectation = Fact::fingerprint(&judgement.expected);
        let passed = judgement.verdict == Verdict::Pass;
        let (expected, got) = match passed && tells_nothing(&judgement) {
            true => (Vec::new(), Vec::new()),
            false => (judgement.expected, judgement.got),
        };
        CaseEvent {
            id: case.id.to_string(),
            dialect: case.dialect.as_str().to_owned(),
            engine: self.engine.name.clone(),
            verdict: judgement.verdict,
            open: is_open(case),
            grade: judgement.grade,
            basis: case.basis.to_string(),
            file: case.file.to_string(),
            line: (!passed).then_some(case.line),
            area: case.area.to_string(),
            title: case.title.to_string(),
            expectation,
            expected,
            got,
            duration_us: u64::try_from(time.as_micros()).unwrap_or(u64::MAX),
            observations: judgement.observations,
            program: lacking(judgement.verdict).then(|| case.source.to_string()),
            baseline,
        }
    }
}

/// Returns whether what was got of a case that passed is known from its expectation and its observations.
fn tells_nothing(passed: &Judgement) -> bool {
    passed.got == passed.expected
        // The acceptance is observed.
        || (passed.expected == [Fact::AcceptedOrRejected] && passed.got == [Fact::Accepted])
}

/// Whether an engine did not do what was expected of it, be that known or not.
const fn lacking(verdict: Verdict) -> bool {
    match verdict {
        Verdict::Fail | Verdict::Xfail | Verdict::Crash | Verdict::Timeout | Verdict::Error => true,
        Verdict::Pass | Verdict::Xpass | Verdict::Unsupported => false,
    }
}
