//! The event of a case: an engine's answers judged, and the judgement matched with the baseline.

use crate::event::CaseEvent;
use crate::judge::{judge, renders_bit_access, tells_otherwise_only};
use crate::{
    Answers, Binding, Claim, Fact, Judgement, Lacks, MatchedBaseline, Observed, Plan, Symptom, Verdict,
    binding, clip_line, promises,
};
use std::borrow::Cow;
use std::time::Duration;
use stickler_engines::Identity;
use stickler_suite::{Acceptance, Case, Expectation, Suite, ToldSymptom};
use stickler_types::Fault;

/// The basis of all but the accesses of bits in what is rendered: of words and of rendering again no document speaks.
const RENDERING: &str = "rule: rendering";

/// The basis of the line of a diagnostic that came without a place, where no document of the makers promises that each has one.
const EVERY_MISTAKE: &str = "rule: every-mistake-is-told";

/// The maximum number of characters that are recorded of a warning without a code.
const MAX_WARNING: usize = 100;

/// Judges the cases of one engine.
#[derive(Clone, Copy, Debug)]
pub struct CaseJudge<'r> {
    /// The plan of the run, which states how strictly the engine is judged.
    pub plan: &'r Plan,
    /// The suite of the cases, whose sources and features state whom an expectation binds.
    pub suite: &'r Suite,
    /// The identity of the engine.
    pub engine: &'r Identity,
    /// What the engine lacks, where it was asked.
    pub lacks: Option<&'r Lacks<'r>>,
    /// The engine's baseline, where it has one.
    pub baseline: Option<&'r MatchedBaseline<'r>>,
}

impl CaseJudge<'_> {
    /// Returns the event of a case, from what the engine answered and how long it took.
    pub fn event(&self, case: &Case, answers: &Answers, time: Duration) -> CaseEvent {
        let mut judgement = self.judgement(case, answers);
        let basis = self.basis(case, &judgement).into_owned();
        if let Some(lacks) = self.lacks
            && let waits_for @ [_, ..] = &lacks.waits_for(case, (&answers.run, judgement.verdict), || {
                promises(case, self.engine, self.suite)
            })[..]
        {
            judgement = Judgement {
                verdict: Verdict::Waiting,
                grade: None,
                expected: judgement.expected,
                got: waits_for.to_vec(),
                observations: Vec::new(),
            };
        }
        let (judgement, baseline) = match self.baseline {
            // No entry is about what a case tells nothing of.
            Some(_) if judgement.verdict == Verdict::Waiting => (judgement, None),
            Some(baseline) => baseline.apply(&case.id, case.dialect, judgement),
            None => (judgement, None),
        };
        let expectation = Fact::fingerprint(&judgement.expected);
        let passed = judgement.verdict == Verdict::Pass;
        let shown = needs_program(judgement.verdict).then_some(case);
        let (expected, got) = match passed && tells_nothing(&judgement) {
            true => (Vec::new(), Vec::new()),
            false => (judgement.expected, judgement.got),
        };
        CaseEvent {
            id: case.id.to_string(),
            dialect: case.dialect.as_str().to_owned(),
            engine: self.engine.name.clone(),
            verdict: judgement.verdict,
            open: case.is_open(),
            grade: judgement.grade,
            basis,
            file: case.file.to_string(),
            line: (!passed).then_some(case.line),
            area: case.area.to_string(),
            title: case.title.to_string(),
            expectation,
            expected,
            got,
            duration_us: u64::try_from(time.as_micros()).unwrap_or(u64::MAX),
            observations: judgement.observations,
            program: shown.map(with_diagram),
            question: shown.and_then(|case| case.question.as_deref().cloned()),
            baseline,
        }
    }

    /// Returns the judgement of a case without the baseline. A miss of an expectation that does not bind the engine is no
    /// failure, nor is a program that comes to nothing where no source that binds the engine says that it must be accepted, nor an
    /// endless loop that does not end; a construct that is not implemented is one where a document promises it.
    pub fn judgement(&self, case: &Case, answers: &Answers) -> Judgement {
        let mut judgement = judge(case, answers, self.plan.needed(self.engine, case));
        if judgement.verdict == Verdict::Fail
            && let Some(recorded) = self.with_warnings_recorded(case, answers)
        {
            return recorded;
        }
        let is_unusable = matches!(judgement.got[..], [Fact::Unusable { .. }]);
        let is_endless = case
            .expectation
            .fault
            .is_some_and(|fault| fault.fault == Fault::StepLimit)
            && matches!(judgement.got[..], [Fact::TimedOut { .. }]);
        let may_be_rejected = case.expectation.accepted == Acceptance::Observed;
        if (judgement.verdict == Verdict::Fail || is_unusable || is_endless) && !self.binds(case, &judgement)
            || is_unusable && may_be_rejected
        {
            judgement.verdict = Verdict::Differs;
        } else if let [Fact::NotImplemented { promised_by, .. }] = &mut judgement.got[..]
            && promises(case, self.engine, self.suite)
        {
            *promised_by = Some(case.basis.to_string());
            judgement.verdict = Verdict::Fail;
        }
        judgement
    }

    /// Returns the judgement of a case that nothing misses but a warning on a clean line, of which no document of the system says that there
    /// is none: the warning is recorded. `None` for any other case.
    fn with_warnings_recorded(&self, case: &Case, answers: &Answers) -> Option<Judgement> {
        let warnings = answers.run.warnings().filter(|warnings| !warnings.is_empty())?;
        if binding(Claim::of(case), Some(self.engine), self.suite) == Binding::Own {
            return None;
        }
        let expectation = Expectation {
            clean_lines: Vec::new(),
            ..(*case.expectation).clone()
        };
        let case = Case {
            expectation: expectation.into(),
            ..case.clone()
        };
        let mut judgement = judge(&case, answers, self.plan.needed(self.engine, &case));
        judgement
            .observations
            .extend(warnings.iter().map(|warning| Observed {
                name: "warning".to_owned(),
                value: clip_line(warning.code.as_ref().unwrap_or(&warning.message), MAX_WARNING),
            }));
        (judgement.verdict == Verdict::Pass).then_some(judgement)
    }

    /// Returns whether the basis of what was missed binds the engine.
    fn binds(&self, case: &Case, missed: &Judgement) -> bool {
        let claim = Claim {
            basis: &self.basis(case, missed),
            ..Claim::of(case)
        };
        let binding = binding(claim, Some(self.engine), self.suite);
        binding.binds(self.plan.strict_rules)
    }

    /// Returns the basis of a judgement: that of the case, but what tells of places where nothing but the place of a mistake was missed, and
    /// a rule of Stickler where nothing was missed but what only the rule asks for.
    fn basis<'c>(&self, case: &'c Case, judgement: &Judgement) -> Cow<'c, str> {
        let (expected, got) = (&judgement.expected[..], &judgement.got[..]);
        if !matches!(judgement.verdict, Verdict::Fail | Verdict::Differs) {
            return Cow::from(&*case.basis);
        }
        if renders_bit_access(expected, got) {
            return Cow::from(RENDERING);
        }
        let needed = self.plan.needed(self.engine, case);
        if !tells_otherwise_only(expected, got, needed) {
            return Cow::from(&*case.basis);
        }
        let symptom = Symptom::of_facts(judgement.verdict, (expected, got), needed);
        let places = matches!(symptom, Symptom::NoPlace(_)).then(|| {
            let sources = &self.suite.sources;
            sources.telling(ToldSymptom::NoPlace, &self.engine.name, "")
        });
        places.flatten().map_or(Cow::from(EVERY_MISTAKE), Cow::from)
    }
}

/// Returns whether the facts of a passed case can be derived from its expectation and its observations.
fn tells_nothing(passed: &Judgement) -> bool {
    passed.got == passed.expected
        // The acceptance is observed.
        || (passed.expected == [Fact::AcceptedOrRejected] && passed.got == [Fact::Accepted])
}

/// Returns the program of a case; where it sets or expects something in certain scans, a comment with the timing diagram of the first ones is behind it.
fn with_diagram(case: &Case) -> String {
    const MAX_SCANS: u32 = 48;
    if !case.has_timing() {
        return case.source.to_string();
    }
    let last = case.scans.clamp(1, MAX_SCANS);
    // A text may have the end of a comment in it.
    let diagram = case.timing_diagram(1..=last).replace("*)", "* )");
    let source = case.source.trim_end();
    format!(
        "{source}\n(* What is set and must come in scans 1 to {last} of {}:\n{diagram}*)\n",
        case.scans
    )
}

/// Returns whether a report shows the program: the engine did not do what was expected of it, be that known or not.
const fn needs_program(verdict: Verdict) -> bool {
    match verdict {
        Verdict::Fail
        | Verdict::Differs
        | Verdict::Xfail
        | Verdict::Crash
        | Verdict::Timeout
        | Verdict::Error => true,
        Verdict::Pass | Verdict::Xpass | Verdict::Unsupported | Verdict::Waiting => false,
    }
}
