//! The normal form of a small program: the plainest program with which the engine still fails in the same way.
//!
//! Two programs with one normal form show one defect, whatever tables and types they come from. The reducer finds it with passes of
//! its own: first an operand alone or fewer statements, then plainer types and numbers. Only the reference says what must happen with
//! it, so it decides which cases belong together, and what the title names, and no case is failed by it.

mod draft_judge;
mod other_forms;

pub(crate) use other_forms::{NUMBERS_PLACELESS, is_whatever_comes};

use crate::alone::{alone, is_loop_alone, shows};
use crate::compiler_place::compiler_place;
use crate::failure_sign::{is_of_a_value, is_of_reading, is_unread};
use crate::forms;
use crate::passes::{plain_method, structure_method, unused_method};
use crate::patterns::{OUT_OF_RANGE, leaves_range, number_pattern};
use crate::program::read;
use crate::question::{Deviation, Questioner};
use crate::reduction::{LONG, Smallest};
use crate::smaller_case::{all_variables, as_the_reference, is_as_standard};
use crate::words::tokens;
use draft_judge::DraftJudge;
use std::collections::BTreeSet;
use std::rc::Rc;
use stickler_engines::EngineError;
use stickler_reduce::{
    Interestingness, ReductionBudget, ReductionMethod, ReferenceRules, StopReason, TextDraft, minimise,
};
use stickler_reference::errors;
use stickler_run::{Fact, Symptom};
use stickler_suite::{Acceptance, Case};
use stickler_types::{Code, Observation};

/// The maximum number of places of a line in which a value of quite another type is tried.
const MAX_OTHER_OPERANDS: usize = 4;

/// The normal form of a small program.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Normal {
    pub(crate) program: String,
    pub(crate) deviation: Deviation,
    /// Whether the program is an operand or a statement of the small one alone.
    pub(crate) is_operand: bool,
    /// The way in which the engine does an operation, or tells a mistake, where another program shows it.
    pub(crate) way: Option<&'static str>,
    /// Whether the program has variables in the place of literals, and fails as well.
    pub(crate) has_variables: bool,
    /// Whether the engine was asked for each operand of the program alone, so that none of them fails but the program does.
    pub(crate) is_asked: bool,
    /// The number of times that the engine was asked.
    pub(crate) questions: u64,
}

impl Normal {
    /// Returns the small program itself, where nothing was asked.
    pub(crate) fn unasked(smallest: &Smallest) -> Normal {
        Normal {
            program: smallest.program.clone(),
            deviation: smallest.deviation.clone(),
            is_operand: false,
            has_variables: false,
            way: None,
            is_asked: false,
            questions: 0,
        }
    }

    /// Returns the normal form as the program to show in the place of the small one.
    pub(crate) fn as_smallest(&self, smallest: &Smallest) -> Smallest {
        Smallest {
            program: self.program.clone(),
            deviation: self.deviation.clone(),
            ..smallest.clone()
        }
    }

    /// Returns whether a value of quite another type is accepted in the place of the mistake.
    pub(crate) fn is_unchecked(&self) -> bool {
        let line = self
            .deviation
            .expected
            .iter()
            .find_map(|fact| fact.diagnostic()?.line);
        matches!(&self.deviation.sign.symptom, Symptom::NotRejected(code) if is_of_a_value(code))
            && line.is_some_and(|line| read(&self.program, |program| forms::is_other_operand(program, line)))
    }

    /// Returns the literals that the engine takes alone.
    pub(crate) fn innocent_literals(&self) -> BTreeSet<String> {
        let operands = read(&self.program, alone).into_iter().filter(|_| self.is_asked);
        operands.filter_map(|one| one.literal).collect()
    }
}

/// Finds the normal form of the smallest program of a case, with at most so many questions to the engine. `stop` is asked before
/// each.
///
/// # Errors
/// [`EngineError`] where the engine crashed and cannot be started again.
pub(crate) fn normal_form(
    asked: &mut Questioner<'_>,
    case: &Case,
    smallest: &Smallest,
    tries: u64,
    stop: &dyn Fn() -> bool,
) -> Result<Normal, EngineError> {
    let mut search = NormalSearch {
        asked,
        case,
        left: tries,
        stop,
        normal: Normal::unasked(smallest),
    };
    let symptom = smallest.deviation.sign.symptom.clone();
    // A long program has no page, and each form of it takes long to write and to ask about; a loop alone that runs has other limits only.
    let is_plain = is_loop_alone(&smallest.program) && !matches!(symptom, Symptom::NotImplemented(_));
    if smallest.flaky.is_some() || smallest.program.len() > LONG || is_plain {
        if is_plain && symptom == Symptom::Value {
            search.loop_alone()?;
        }
        return Ok(search.normal);
    }
    search.whatever_comes()?;
    if search.normal.way.is_some() {
        if is_not_built(&symptom) {
            search.variables_for_literals()?;
        }
        search.normal.questions = tries - search.left;
        return Ok(search.normal);
    }
    search.minimise(&structure_method(&symptom))?;
    let now = search.normal.deviation.sign.symptom.clone();
    if now == Symptom::Value && symptom != Symptom::Value {
        search.minimise(&structure_method(&now))?;
    }
    if matches!(&now, Symptom::NotRejected(code) if is_of_a_value(code)) {
        search.unchecked_place(smallest)?;
    }
    if search.normal.program != smallest.program {
        search.minimise(&unused_method())?;
    }
    search.normal.is_operand = search.normal.program != smallest.program && !search.normal.is_unchecked();
    if matches!(now, Symptom::Value | Symptom::Rejected(_) | Symptom::Unusable(_)) {
        search.ordered_arguments()?;
    }
    search.other_forms()?;
    match now {
        _ if search.normal.way.is_some() => {}
        // The types and values of such an operation do not matter.
        Symptom::Value | Symptom::Missing => search.minimise(&plain_method(true))?,
        Symptom::Rejected(_) | Symptom::Fault(_) | Symptom::NotImplemented(_) | Symptom::Crash(_) => {
            search.minimise(&plain_method(false))?;
        }
        Symptom::NoPlace(_) => search.places()?,
        Symptom::Incomplete(_) => search.beside_others()?,
        Symptom::Unusable(_) if is_not_built(&now) => {
            search.variables_for_literals()?;
            if search.normal.way.is_none() {
                search.single_bytes()?;
            }
        }
        _ => {}
    }
    let mut normal = search.normal;
    let asks_for_operands = !matches!(
        now,
        Symptom::Hang | Symptom::Fault(_) | Symptom::NotImplemented(_)
    );
    normal.is_asked = asks_for_operands && search.left > 0 && !stop();
    normal.questions = tries - search.left;
    Ok(normal)
}

struct NormalSearch<'s, 'e> {
    asked: &'s mut Questioner<'e>,
    case: &'s Case,
    left: u64,
    stop: &'s dyn Fn() -> bool,
    normal: Normal,
}

impl NormalSearch<'_, '_> {
    /// Makes the normal form lighter while the engine fails with it in the same way.
    fn minimise(&mut self, method: &ReductionMethod<'_, TextDraft>) -> Result<(), EngineError> {
        let (text, dialect) = (&self.normal.program, self.case.dialect);
        let start = TextDraft::new(text, dialect, Rc::new(ReferenceRules::new(text, dialect)));
        let stop = self.stop;
        let budget = ReductionBudget {
            tries: self.left + 1,
            stop,
        };
        let mut judge = DraftJudge {
            search: self,
            is_start: true,
            error: None,
        };
        let found = minimise(start, method, &mut judge, &budget);
        let error = judge.error;
        if found.ended == StopReason::OutOfTries {
            self.left = 0;
        }
        error.map_or(Ok(()), Err)
    }

    /// Returns the case with a program that may be the normal form; `None` where it says nothing.
    fn case_of(&self, text: &str) -> Option<Case> {
        let former = &self.normal;
        // Of a program that cannot be read, an operand with a literal that the program does not have says nothing: that may not be read
        // either.
        let is_read = !is_unread(&former.deviation.got);
        if !(is_read || literals(text).is_subset(&literals(&former.program)))
            || !(former.deviation.sign.accepts() || is_as_standard(self.case, text))
            || self.asked.uses_what_is_lacking(self.case, text)
        {
            return None;
        }
        let case = as_the_reference(self.case, text, &self.observe(text))?;
        // A value of another type that is right there says nothing.
        let says_nothing =
            former.deviation.sign.accepts() && case.expectation.accepted != Acceptance::Rejected;
        (!says_nothing).then_some(case)
    }

    /// Takes the program of a case as the normal form if the engine fails with it in the same way.
    fn judge_case(&mut self, text: &str, case: &Case) -> Result<Interestingness, EngineError> {
        self.left = self.left.saturating_sub(1);
        let seen = self.asked.deviation(case)?;
        let former = &self.normal;
        // A value that wraps is another defect than one that is within the range of its type; where a real number is converted, so is one that
        // is rounded.
        let leaves = |text: &str, seen: &Deviation| read(text, |program| leaves_range(program, seen));
        let is_converted = |text: &str, seen: &Deviation| {
            read(text, |program| {
                number_pattern(program, seen) == Some(OUT_OF_RANGE)
            })
        };
        let stays = |seen: &Deviation| match leaves(&former.program, &former.deviation) {
            true => !is_converted(&former.program, &former.deviation) || is_converted(text, seen),
            false => !leaves(text, seen),
        };
        // That one form of a literal is rejected otherwise does not tell that another is accepted.
        let is_other = |seen: &Deviation| {
            former.deviation.sign.is_rejected_otherwise()
                && seen.sign.accepts()
                && !literals(text).is_subset(&literals(&former.program))
        };
        let stays = |seen: &Deviation| stays(seen) && !is_other(seen);
        let same = seen.filter(|seen| is_same(&former.deviation, seen) && stays(seen) && shows(text, seen));
        let is_same = same.is_some();
        if let Some(deviation) = same {
            self.normal.program = text.to_owned();
            self.normal.deviation = deviation;
        }
        Ok(Interestingness::from(is_same))
    }

    /// Takes quite another type in the place of the value of the mistake, where the engine takes that too: in the normal form, or else in
    /// the small program, since a place of its own may be checked where that of the small one is not.
    fn unchecked_place(&mut self, smallest: &Smallest) -> Result<(), EngineError> {
        let dialect = self.case.dialect;
        let code: Option<Code> = match &self.normal.deviation.sign.symptom {
            Symptom::NotRejected(code) => code.parse().ok(),
            _ => None,
        };
        // A literal that is accepted alone is checked nowhere, whatever its place takes.
        let is_of_literal = matches!(code, Some(Code::ConstantOverflow | Code::RealLiteralOutOfRange));
        let is_alone = is_of_literal && self.normal.program != smallest.program;
        let small = (!is_alone).then(|| smallest.program.clone());
        for text in [self.normal.program.clone()].into_iter().chain(small) {
            let others = read(&text, |program| {
                let line = errors(program.text, dialect).iter().find_map(|error| error.line);
                line.map_or(Vec::new(), |line| forms::with_other_operand(program, line))
            });
            let codes = |text: &String| {
                let errors = errors(text, dialect).into_iter();
                errors.map(|error| error.registered_code()).collect::<Vec<_>>()
            };
            // The same mistake alone says more than another one, which may be checked elsewhere.
            let (same, rest): (Vec<String>, Vec<String>) =
                others.into_iter().partition(|text| codes(text) == [code]);
            let mut asked = match same.is_empty() {
                true => rest
                    .into_iter()
                    .filter(|text| codes(text).len() == 1)
                    .take(1)
                    .collect(),
                false => same,
            };
            asked.truncate(MAX_OTHER_OPERANDS);
            for other in asked {
                let is_asked = !self.normal.is_unchecked() && self.left > 0 && !(self.stop)();
                if let Some(case) = Some(other)
                    .filter(|_| is_asked)
                    .and_then(|other| self.case_of(&other))
                {
                    self.judge_case(&case.source, &case)?;
                }
            }
        }
        Ok(())
    }

    /// Returns the observations that show what is wrong with a program: those of the case and of an operand alone, or of all variables
    /// where these keep what they begin with.
    fn observe(&self, text: &str) -> Vec<Observation> {
        let has_values = matches!(
            self.normal.deviation.sign.symptom,
            Symptom::Value | Symptom::Missing | Symptom::Hang | Symptom::Fault(_)
        );
        if !has_values {
            return Vec::new();
        }
        let all = all_variables(self.case, text);
        let (initial, is_empty) = read(text, |program| {
            let is_empty = program.unit.pous().all(|pou| pou.body.is_empty());
            (forms::only_initial_values(program), is_empty)
        });
        let keeps = is_empty || initial.iter().any(|initial| initial == text);
        let is_observed = |one: &&Observation| {
            let mut observed = self.case.observe.iter();
            one.name.eq_ignore_ascii_case("into")
                || observed.any(|known| known.name.eq_ignore_ascii_case(&one.name))
        };
        let observed: Vec<Observation> = all.iter().filter(is_observed).cloned().collect();
        if keeps || observed.is_empty() {
            all
        } else {
            observed
        }
    }

    /// Returns how the engine deviates with a case; `None` where there is none, or no question is left.
    fn deviation_of(&mut self, case: Option<&Case>) -> Result<Option<Option<Deviation>>, EngineError> {
        let Some(case) = case.filter(|_| self.left > 0 && !(self.stop)()) else {
            return Ok(None);
        };
        self.left -= 1;
        self.asked.deviation(case).map(Some)
    }
}

/// Returns whether an engine makes of a program what a compiler of C does not take, where literals and variables may differ.
fn is_not_built(symptom: &Symptom) -> bool {
    matches!(symptom, Symptom::Unusable(words) if words.contains("error:"))
}

/// Returns the literals of a program, as they are written.
fn literals(text: &str) -> BTreeSet<&str> {
    let literals = tokens(text).into_iter().filter(|token| token.kind.is_literal());
    literals.map(|token| token.span.text(text)).collect()
}

/// Returns whether an engine fails in the same way with another program, which may have the place or the types of another.
fn is_same(former: &Deviation, seen: &Deviation) -> bool {
    match (&former.sign.symptom, &seen.sign.symptom) {
        // Without the mistake the same is said of the same construct.
        (Symptom::OtherLine(_), Symptom::Rejected(reason)) => {
            let reported = former.got.iter().find_map(Fact::diagnostic);
            reported.is_some_and(|reported| reported.code.as_ref() == Some(reason))
        }
        (Symptom::Rejected(reason), Symptom::Rejected(other)) => {
            reason == other || !is_of_reading(reason) && !is_of_reading(other)
        }
        (Symptom::OtherCode { reported, .. } | Symptom::Surplus(reported), Symptom::Rejected(reason)) => {
            reported == reason
        }
        // The code that was expected is not missed alone.
        (Symptom::OtherCode { code, .. }, Symptom::NotRejected(same)) => code == same,
        (Symptom::NotImplemented(_), Symptom::NotImplemented(_)) => {
            compiler_place(&former.got) == compiler_place(&seen.got)
        }
        (Symptom::NotRejected(_), Symptom::NotRejected(_))
        | (Symptom::Value | Symptom::Missing | Symptom::Hang | Symptom::Fault(_), Symptom::Value) => true,
        (Symptom::Fault(words), Symptom::Fault(other))
        | (Symptom::Crash(words), Symptom::Crash(other))
        | (Symptom::Unusable(words), Symptom::Unusable(other)) => words == other,
        _ => false,
    }
}
