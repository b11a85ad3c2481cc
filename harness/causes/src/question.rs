//! Asks an engine about a smaller program of a case: the reference says what must happen, the engine what happens.

use crate::failed::LackedFeatures;
use crate::failure_sign::Sign;
use crate::reduction::LONG;
use crate::words::{LOOPS, has_word};
use std::collections::{BTreeSet, HashMap, HashSet};
use std::sync::{Mutex, PoisonError};
use stickler_engines::{EngineError, EngineSession};
use stickler_reduce::Interestingness;
use stickler_run::{
    AnswerStore, Answers, CaseJudge, Fact, Grade, Symptom, Verdict, ask, ask_stored, ask_stored_together,
    question,
};
use stickler_suite::{Acceptance, Case};
use stickler_syntax::features::features;
use stickler_types::{Code, Dialect, Outcome, Value};

/// The answers of an engine in a search, by the digest of the question, because groups with one cause ask for the same small
/// programs.
#[derive(Default)]
pub(crate) struct SearchAnswers(Mutex<HashMap<String, KnownAnswer>>);

/// An answer of an engine, and whether the engine gave the same answer each time that it was asked again.
#[derive(Clone)]
struct KnownAnswer {
    answers: Answers,
    is_steady: bool,
}

impl SearchAnswers {
    fn get(&self, question: &str) -> Option<KnownAnswer> {
        let answered = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        answered.get(question).cloned()
    }

    /// Keeps answers, but an error, which the machine may have caused. A program that hangs is asked about once, since each time costs
    /// the whole time limit.
    fn keep(&self, question: String, answers: &Answers, is_steady: bool) {
        let by_the_machine = |outcome: &Outcome| matches!(outcome, Outcome::Error { .. });
        if !answers.outcomes().any(by_the_machine) {
            let answers = answers.clone();
            let mut answered = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            answered.insert(question, KnownAnswer { answers, is_steady });
        }
    }
}

/// An engine with the judge of its cases.
pub(crate) struct Questioner<'e> {
    pub(crate) session: EngineSession<'e>,
    /// The judge of the run, so that a smaller program is judged like a case.
    pub(crate) judge: CaseJudge<'e>,
    /// The answers of earlier runs.
    pub(crate) store: Option<&'e dyn AnswerStore>,
    /// The answers of this search.
    pub(crate) answered: &'e SearchAnswers,
    /// The features that engines lack.
    pub(crate) lacked: &'e LackedFeatures,
    /// The number of programs that the engine is asked about together.
    pub(crate) pack_size: usize,
    /// Whether programs that must be rejected are only checked: they may die, or never end, when they are run.
    pub(crate) only_checks: bool,
}

/// A deviation that an engine showed on a program.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Deviation {
    pub(crate) sign: Sign,
    pub(crate) expected: Vec<Fact>,
    pub(crate) got: Vec<Fact>,
}

/// The facts of what an engine did with a program, and the deviation from what must happen where there is one.
pub(crate) type Judged = (Vec<Fact>, Option<Deviation>);

/// Returns the values that a program has wrong, by the names of their variables: what each must be, and what it is.
pub(crate) fn wrong_values<'f>(
    expected: &'f [Fact],
    got: &'f [Fact],
) -> impl Iterator<Item = (&'f str, (&'f Value, &'f Value))> {
    let values = expected.iter().zip(got).filter_map(|pair| match pair {
        (Fact::Value { name, value }, Fact::Value { value: other, .. }) => {
            Some((name.as_str(), (value, other)))
        }
        _ => None,
    });
    values.filter(|(_, (value, other))| value != other)
}

impl Deviation {
    /// Returns the deviation of a program with a verdict. `strict` is the worst grade of a rejection that still passed.
    pub(crate) fn new(
        program: &str,
        verdict: Verdict,
        (expected, got): (Vec<Fact>, Vec<Fact>),
        strict: Grade,
    ) -> Deviation {
        let sign = Sign::of(program, verdict, (&expected, &got), strict);
        Deviation { sign, expected, got }
    }

    /// Returns whether the engine reports a mistake with its code and, beside that, with the same code once more.
    pub(crate) fn is_told_twice(&self) -> bool {
        let Symptom::Surplus(code) = &self.sign.symptom else {
            return false;
        };
        let mut expected = self.expected.iter().filter_map(Fact::diagnostic);
        expected.any(|one| one.code.as_ref() == Some(code))
    }

    /// Removes the codes that the engine does not have from what it must report; those that begin with S are Stickler's own.
    pub(crate) fn forget_codes(&mut self, lacked: &[Code]) {
        let is_lacked = |code: Code| code.as_str().starts_with('S') || lacked.contains(&code);
        for fact in &mut self.expected {
            if let Fact::Diagnostic(diagnostic) | Fact::Warning(diagnostic) = fact
                && diagnostic.registered_code().is_some_and(is_lacked)
            {
                diagnostic.code = None;
            }
        }
    }

    /// Removes the promise from what the engine did, of a program of which the claim does not speak.
    pub(crate) fn forget_promise(&mut self) {
        for fact in &mut self.got {
            if let Fact::NotImplemented { promised_by, .. } = fact {
                *promised_by = None;
            }
        }
    }
}

/// The least that an engine takes as a program.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct Takes {
    /// Whether it takes bodies without statements.
    pub(crate) empty_bodies: bool,
    /// Whether it takes units without variables.
    pub(crate) no_variables: bool,
    /// Whether it takes a semicolon alone as a statement.
    pub(crate) empty_statements: bool,
    /// Whether it takes a text without a PROGRAM.
    pub(crate) no_program: bool,
}

/// A text without a PROGRAM.
const NO_PROGRAM: &str = "TYPE\n    OWN : INT;\nEND_TYPE\n";

/// A program with a semicolon alone as a statement.
const EMPTY_STATEMENT: &str =
    "PROGRAM main\nVAR\n    done : BOOL;\nEND_VAR\n    IF done THEN\n        ;\n    END_IF;\nEND_PROGRAM\n";

/// A program of which no unit has a variable.
const NO_VARIABLES: &str = "PROGRAM main\nEND_PROGRAM\n";

/// A program of which no body has a statement.
const EMPTY_BODIES: &str = "FUNCTION_BLOCK EMPTY\nVAR_INPUT\n    in : INT;\nEND_VAR\nEND_FUNCTION_BLOCK\n\n\
     PROGRAM main\nVAR\n    done : BOOL;\nEND_VAR\nEND_PROGRAM\n";

impl Questioner<'_> {
    /// Asks the engine about a case, or takes what it answered before, in this search or in an earlier run; `None` where it does what it must, or does
    /// not support the program.
    ///
    /// # Errors
    /// [`EngineError`] where no session can be opened.
    pub(crate) fn deviation(&mut self, case: &Case) -> Result<Option<Deviation>, EngineError> {
        let question = self.key(case);
        let answers = match self.answered.get(&question) {
            Some(known) => known.answers,
            None => {
                let answers = match self.is_only_checked(case) {
                    true => self.check(case)?,
                    false => ask_stored(&mut self.session, case, self.store)?,
                };
                self.answered.keep(question, &answers, false);
                answers
            }
        };
        Ok(self.judged(case, answers)?.1)
    }

    /// Returns whether a case must be rejected, and is one of those that are only checked.
    fn is_only_checked(&self, case: &Case) -> bool {
        self.only_checks && case.expectation.accepted == Acceptance::Rejected
    }

    /// Returns the key of the answers about a case. A check says less than a run.
    fn key(&self, case: &Case) -> String {
        let question = question(case);
        match self.is_only_checked(case) {
            true => format!("check {question}"),
            false => question,
        }
    }

    /// Asks the engine to check the program of a case.
    fn check(&mut self, case: &Case) -> Result<Answers, EngineError> {
        let checked = self.session.check(case.dialect, &case.source)?;
        Ok(Answers::of_run(checked))
    }

    /// Asks the engine about the programs that are asked about next, where it takes several together, so that the answers are known then.
    /// `stop` is asked before each pack.
    ///
    /// # Errors
    /// [`EngineError`] where no session can be opened.
    pub(crate) fn ask_ahead<'a>(
        &mut self,
        cases: impl IntoIterator<Item = &'a Case>,
        stop: &dyn Fn() -> bool,
    ) -> Result<(), EngineError> {
        if !self.takes_packs() || self.only_checks {
            return Ok(());
        }
        let mut asked = HashSet::new();
        // A long program may take all of the time, and one with a loop too, and those beside it with it.
        let has_loop = |case: &Case| LOOPS.iter().any(|word| has_word(&case.source, word));
        let is_open = |case: &&Case| {
            let question = question(case);
            case.source.len() <= LONG
                && !has_loop(case)
                && self.answered.get(&question).is_none()
                && asked.insert(question)
        };
        let open: Vec<&Case> = cases.into_iter().filter(is_open).collect();
        if open.len() < 2 {
            return Ok(());
        }
        let how = (self.pack_size, stop);
        let answers = ask_stored_together(&mut self.session, &open, self.store, how)?;
        for (case, answers) in open.iter().zip(answers) {
            if let Some(answers) = answers {
                self.answered.keep(question(case), &answers, false);
            }
        }
        Ok(())
    }

    /// Returns whether the engine is asked about several programs together.
    pub(crate) const fn takes_packs(&self) -> bool {
        self.pack_size > 1
    }

    /// Returns the number of programs with a symptom that are asked about together. One that cannot be run hides what the others do.
    pub(crate) fn pack_size_of(&self, symptom: &Symptom) -> usize {
        match symptom {
            Symptom::Crash(_) | Symptom::Unusable(_) | Symptom::Hang => 1,
            _ => self.pack_size,
        }
    }

    /// Returns the least that the engine takes as a program, in the dialect of a case.
    ///
    /// # Errors
    /// [`EngineError`] where no session can be opened.
    pub(crate) fn takes(&mut self, case: &Case) -> Result<Takes, EngineError> {
        let mut takes = |program: &str| {
            let program = Case::of_program(&case.id, case.dialect, program);
            Ok(self.deviation(&program)?.is_none())
        };
        Ok(Takes {
            empty_bodies: takes(EMPTY_BODIES)?,
            no_variables: takes(NO_VARIABLES)?,
            empty_statements: takes(EMPTY_STATEMENT)?,
            no_program: takes(NO_PROGRAM)?,
        })
    }

    /// Returns whether a program uses a feature that the engine lacks, and the whole program of the case does not: such a program shows
    /// that instead.
    pub(crate) fn uses_what_is_lacking(&self, case: &Case, program: &str) -> bool {
        let lacked = self.lacked.get(&self.judge.engine.name);
        lacked.is_some_and(|lacked| brings_in(lacked, (&case.source, program), Dialect::of(case.dialect)))
    }

    /// Returns whether the engine answered a case in this search.
    pub(crate) fn has_answered(&self, case: &Case) -> bool {
        self.answered.get(&self.key(case)).is_some()
    }

    /// Returns whether the engine gave the same answer about a case each time in this search.
    pub(crate) fn is_steady(&self, case: &Case) -> bool {
        self.answered
            .get(&self.key(case))
            .is_some_and(|known| known.is_steady)
    }

    /// Notes that the engine gives the same answer about a case each time.
    pub(crate) fn note_steady(&self, case: &Case) {
        let question = self.key(case);
        if let Some(known) = self.answered.get(&question) {
            self.answered.keep(question, &known.answers, true);
        }
    }

    /// Asks the engine about a case, also where it answered before. Returns what it does, and whether that is a deviation, as often as it was
    /// asked: at most so often, and once where it takes one program at a time.
    ///
    /// # Errors
    /// [`EngineError`] where no session can be opened.
    pub(crate) fn again(
        &mut self,
        case: &Case,
        (symptom, times): (&Symptom, usize),
        stop: &dyn Fn() -> bool,
    ) -> Result<Vec<Judged>, EngineError> {
        let answers = match self.pack_size_of(symptom).min(times) {
            _ if self.is_only_checked(case) => vec![Some(self.check(case)?)],
            0 | 1 => vec![Some(ask(&mut self.session, case)?)],
            size => ask_stored_together(&mut self.session, &vec![case; size], None, (size, stop))?,
        };
        let answers = answers.into_iter().flatten();
        answers.map(|answers| self.judged(case, answers)).collect()
    }

    /// Returns the sign of a case, of which the run saw `sign`: one that must be rejected and dies may only have been executed, and one
    /// that fails for a place that is lost is not asked for its code.
    ///
    /// # Errors
    /// [`EngineError`] where no session can be opened.
    pub(crate) fn sign(&mut self, case: &Case, sign: &Sign) -> Result<Sign, EngineError> {
        let died = matches!(sign.symptom, Symptom::Crash(_) | Symptom::Hang);
        let has_code = matches!(sign.symptom, Symptom::OtherCode { .. });
        if !(died || has_code) || case.expectation.accepted != Acceptance::Rejected {
            return Ok(sign.clone());
        }
        let seen = self.deviation(case)?.map(|seen| seen.sign);
        let seen = seen.filter(|seen| died || matches!(seen.symptom, Symptom::NoPlace(_)));
        Ok(seen.unwrap_or_else(|| sign.clone()))
    }

    fn judged(&mut self, case: &Case, answers: Answers) -> Result<Judged, EngineError> {
        let answers = self.without_execution(case, answers)?;
        let judged = self.judge.judgement(case, &answers);
        if !judged.verdict.is_discrepancy() {
            return Ok((judged.got, None));
        }
        let strict = self.judge.plan.needed(self.judge.engine, case);
        let facts = (judged.expected, judged.got.clone());
        let deviation = Deviation::new(&case.source, judged.verdict, facts, strict);
        Ok((judged.got, Some(deviation)))
    }

    /// Returns the answers about a program without what came after it was accepted: one that must be rejected and dies or stops
    /// only when it is executed was accepted wrongly, whatever it does then.
    fn without_execution(&mut self, case: &Case, answers: Answers) -> Result<Answers, EngineError> {
        let died = matches!(
            answers.run,
            Outcome::Crashed { .. } | Outcome::TimedOut { .. } | Outcome::Faulted { .. }
        );
        if !died || case.expectation.accepted != Acceptance::Rejected {
            return Ok(answers);
        }
        let checked = self.session.check(case.dialect, &case.source)?;
        if !matches!(checked, Outcome::Accepted { .. }) {
            return Ok(answers);
        }
        // Where no source that binds the engine forbids the program, that it dies is all that is wrong.
        let accepted = Answers::of_run(checked);
        let judged = self.judge.judgement(case, &accepted);
        Ok(match judged.verdict {
            Verdict::Differs => answers,
            _ => accepted,
        })
    }
}

/// Judges the cases of programs in their order until one is interesting: those behind it are judged again, as changes of it. A program
/// without a case says nothing.
pub(crate) fn until_interesting(
    cases: &[Option<Case>],
    mut judge: impl FnMut(usize, &Case) -> Result<Interestingness, EngineError>,
) -> Result<Vec<Interestingness>, EngineError> {
    let mut answers = vec![Interestingness::Invalid; cases.len()];
    for (at, case) in cases.iter().enumerate() {
        if let Some(case) = case {
            answers[at] = judge(at, case)?;
        }
        if answers[at] == Interestingness::Interesting {
            break;
        }
    }
    Ok(answers)
}

/// Returns whether a program that was made from a whole one uses one of some features which that does not use.
pub(crate) fn brings_in(some: &BTreeSet<String>, (whole, program): (&str, &str), dialect: &Dialect) -> bool {
    let used = features(program, dialect);
    used.iter()
        .any(|key| some.contains(&**key) && !features(whole, dialect).contains(key))
}
