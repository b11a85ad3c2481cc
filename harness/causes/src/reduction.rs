//! Makes the program of a failing case as small as it can be while the engine deviates in the same way.

use crate::alone::{Alone, alone, loops_alone, shows};
use crate::failure_sign::Sign;
use crate::guard::Constructs;
use crate::program::{Program, read};
use crate::question::{Deviation, Questioner, wrong_values};
use crate::smaller_case::{as_the_reference, is_as_standard, with_program};
use crate::smaller_programs::SmallerPrograms;
use std::cell::Cell;
use stickler_engines::EngineError;
use stickler_reduce::{ReductionBudget, StopReason, text_in_packs};
use stickler_run::{CaseEvent, Fact, Reduced, RepeatedOutcome, Repeats, Symptom};
use stickler_suite::{Case, without_blank_lines};
use stickler_types::Observation;

/// The number of times that the smallest program is run to see whether the engine does the same each time.
const REPEATS: u32 = 4;
/// The number of times that a program is run with which the engine does not do the same each time.
const REPEATS_OF_CHANCE: u32 = 20;

/// The maximum number of times that a smaller program is asked about that deviates by chance.
const TIMES_OF_CHANCE: usize = 10;

/// The number of bytes of a program above which its group waits for the others, and has no page.
pub(crate) const LONG: usize = 10_000;

/// The number of smaller programs without an answer in time after which a group is left as it is.
const MAX_HANGS: u32 = 3;

/// A program that shows what a case shows, as small as it became.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Smallest {
    pub(crate) program: String,
    pub(crate) deviation: Deviation,
    pub(crate) reduction: Reduced,
    pub(crate) flaky: Option<Repeats>,
    /// The number of times that the engine was asked.
    pub(crate) questions: u64,
}

impl Smallest {
    /// Returns a program that was made small elsewhere.
    pub(crate) const fn known(program: String, deviation: Deviation) -> Smallest {
        Smallest {
            program,
            deviation,
            reduction: Reduced::Smallest,
            flaky: None,
            questions: 0,
        }
    }

    /// Notes that no question was left for the rest of the search.
    pub(crate) fn end_partly(&mut self) {
        if self.reduction == Reduced::Smallest {
            self.reduction = Reduced::Partly;
        }
    }

    /// Returns the program of a case as it is, without blank lines.
    pub(crate) fn unreduced(event: &CaseEvent, sign: &Sign) -> Smallest {
        let (program, lines) = without_blank_lines(event.program.as_deref().unwrap_or_default());
        let deviation = Deviation {
            sign: sign.clone(),
            expected: moved(&event.expected, &lines),
            got: moved(&event.got, &lines),
        };
        Smallest {
            reduction: Reduced::Not,
            ..Smallest::known(program, deviation)
        }
    }
}

/// Reduces the program of a case that failed with this sign, with at most so many questions to the engine. `stop` is asked
/// before each.
///
/// # Errors
/// [`EngineError`] where the engine crashed and cannot be started again.
pub(crate) fn reduce(
    asked: &mut Questioner<'_>,
    (case, event): (&Case, &CaseEvent),
    sign: &Sign,
    tries: u64,
    stop: &dyn Fn() -> bool,
) -> Result<Smallest, EngineError> {
    let unreduced = Smallest::unreduced(event, sign);
    if !is_reducible(&sign.symptom) {
        return Ok(unreduced);
    }
    if let Some(found) = operand_alone(asked, (case, event), &unreduced, stop)? {
        return Ok(found);
    }
    let takes = asked.takes(case)?;
    // Of a program that takes ever longer with its size, each smaller one may take the whole time of a question.
    let hangs = Cell::new(0);
    let stop = &|| stop() || hangs.get() >= MAX_HANGS;
    let start = unreduced.program.clone();
    let mut smaller = SmallerPrograms {
        asked: &mut *asked,
        case,
        event,
        sign,
        constructs: Constructs::of(&start),
        start: &start,
        takes,
        hangs: &hangs,
        stop,
        times: 1,
        questions: 0,
        error: None,
    };
    let budget = ReductionBudget { tries, stop };
    let mut found = text_in_packs(&start, case.dialect, &mut smaller, &budget);
    // What is not seen again came by chance.
    if found.ended == StopReason::NotInteresting && !stop() {
        smaller.times = TIMES_OF_CHANCE;
        found = text_in_packs(&start, case.dialect, &mut smaller, &budget);
    }
    while takes.empty_bodies && found.ended == StopReason::Smallest {
        let mut emptied = emptied(&found.value).into_iter();
        let Some(program) = emptied.find(|one| smaller.takes_one(one)) else {
            break;
        };
        found = text_in_packs(&program, case.dialect, &mut smaller, &budget);
    }
    let SmallerPrograms { questions, error, .. } = smaller;
    if let Some(error) = error {
        return Err(error);
    }
    let (program, reduction) = match found.ended {
        // What had no answer in time says nothing.
        StopReason::NotInteresting if hangs.get() > 0 => (start, Reduced::Partly),
        StopReason::NotInteresting => (start, Reduced::Not),
        StopReason::Smallest => (found.value, Reduced::Smallest),
        StopReason::OutOfTries | StopReason::Stopped => (found.value, Reduced::Partly),
    };
    let smallest = Smallest {
        program,
        reduction,
        questions,
        ..unreduced
    };
    let smaller = with_program(case, sign, &smallest.program);
    match smaller.filter(|_| reduction != Reduced::Not) {
        // Nobody waits for what is made smaller later.
        Some(smaller) if found.ended == StopReason::OutOfTries => {
            let seen = asked.deviation(&smaller)?;
            let deviation = seen.unwrap_or_else(|| smallest.deviation.clone());
            Ok(Smallest {
                deviation,
                ..smallest
            })
        }
        Some(smaller) => repeated(asked, &smaller, sign, smallest, stop),
        // Without its marks the program does not show it.
        None => {
            let whole = repeated(asked, case, sign, smallest, stop)?;
            let unreduced = Smallest::unreduced(event, sign);
            Ok(Smallest {
                deviation: unreduced.deviation,
                ..whole
            })
        }
    }
}

/// Returns what a program may become by the loss of the one statement that a body has.
fn emptied(text: &str) -> Vec<String> {
    let program = Program::new(text);
    let alone = program.unit.pous().filter_map(|pou| match &pou.body[..] {
        [statement] => Some((statement.span.start as usize, pou.end.start as usize)),
        _ => None,
    });
    alone
        .map(|(from, to)| format!("{}\n{}", text[..from].trim_end(), &text[to..]))
        .collect()
}

/// Returns the operand of a program that gives alone the wrong value which the program gives; `None` where there is none. Most programs of
/// a table show what one conversion or literal shows alone, so that one question takes the place of all that make a program small.
///
/// # Errors
/// [`EngineError`] where the engine crashed and cannot be started again.
fn operand_alone(
    asked: &mut Questioner<'_>,
    (case, event): (&Case, &CaseEvent),
    unreduced: &Smallest,
    stop: &dyn Fn() -> bool,
) -> Result<Option<Smallest>, EngineError> {
    let mut questions = 0;
    if unreduced.deviation.sign.symptom != Symptom::Value {
        return Ok(None);
    }
    // What a variable begins with is shown by a program that does nothing else.
    let operands = read(&unreduced.program, |program| {
        let mut found = loops_alone(program, case.dialect);
        found.extend(alone(program));
        found.into_iter()
    });
    let with_case = |operand: Alone| {
        let is_shown = !operand.is_initial && is_as_standard(case, &operand.program);
        let observe = [Observation::last("into", operand.ty.name())];
        let asked = as_the_reference(case, &operand.program, &observe).filter(|_| is_shown)?;
        Some((operand.program, asked))
    };
    let mut operands = operands.filter_map(with_case);
    // Most programs show it with the first operand: only where it costs no more are others asked about with it.
    let first = if asked.takes_packs() { usize::MAX } else { 0 };
    let ahead: Vec<(String, Case)> = operands.by_ref().take(first).collect();
    let known: Vec<bool> = ahead
        .iter()
        .map(|(_, operand)| asked.has_answered(operand))
        .collect();
    asked.ask_ahead(ahead.iter().map(|(_, operand)| operand), stop)?;
    for (at, (program, operand)) in ahead.into_iter().chain(operands).enumerate() {
        if stop() {
            return Ok(None);
        }
        let is_known = known
            .get(at)
            .copied()
            .unwrap_or_else(|| asked.has_answered(&operand));
        questions += u64::from(!is_known);
        let seen = asked.deviation(&operand)?;
        let Some(deviation) = seen.filter(|seen| has_same_values(event, seen) && shows(&program, seen))
        else {
            continue;
        };
        let found = Smallest {
            questions,
            ..Smallest::known(program, deviation)
        };
        // What another group has shown is no chance.
        return match is_known {
            true => Ok(Some(found)),
            false => repeated(asked, &operand, &unreduced.deviation.sign, found, stop).map(Some),
        };
    }
    Ok(None)
}

/// Returns whether the first value that a program has wrong is one that the case has wrong, whatever their variables are called.
fn has_same_values(event: &CaseEvent, seen: &Deviation) -> bool {
    let first = wrong_values(&seen.expected, &seen.got).next();
    first.is_some_and(|(_, pair)| wrong_values(&event.expected, &event.got).any(|(_, other)| other == pair))
}

/// Returns whether a program stopped with a fault, as one does that is accepted and divides by a variable which lost its value.
pub(crate) fn has_fault(got: &[Fact]) -> bool {
    got.iter().any(|fact| matches!(fact, Fact::Fault { .. }))
}

/// Returns whether a program has a value wrong in the way in which the case has it: what it must be, and what it is. Of what is no
/// value, the sign says the way.
pub(crate) fn has_same_value(event: &CaseEvent, seen: &Deviation) -> bool {
    let mut now = wrong_values(&seen.expected, &seen.got).peekable();
    now.peek().is_none()
        || now.any(|value| wrong_values(&event.expected, &event.got).any(|other| other == value))
}

/// Runs the case with the smallest program several times, and fills in what the engine does with it. `stop` is asked before each.
pub(crate) fn repeated(
    asked: &mut Questioner<'_>,
    case: &Case,
    sign: &Sign,
    smallest: Smallest,
    stop: &dyn Fn() -> bool,
) -> Result<Smallest, EngineError> {
    let mut found = None;
    let mut repeats = Repeats::default();
    let mut unanswered = 0;
    // What was shown several times is no chance.
    if asked.is_steady(case)
        && let Some(deviation) = asked.deviation(case)?.filter(|seen| sign.is_kept_by(&seen.sign))
    {
        return Ok(Smallest {
            deviation,
            ..smallest
        });
    }
    let is_by_chance_so_far = |repeats: &Repeats| is_by_chance(repeats) && repeats.of < REPEATS_OF_CHANCE;
    let is_busy = |unanswered: u32| unanswered > REPEATS;
    while (repeats.of < REPEATS || is_by_chance_so_far(&repeats)) && !stop() && !is_busy(unanswered) {
        for (got, deviation) in asked.again(case, (&sign.symptom, REPEATS as usize), stop)? {
            // A busy machine is no property of the compiler, unless it is one that gives no answer, and the next takes too long as well.
            let is_excused = unanswered == 0 || sign.symptom != Symptom::Hang;
            if matches!(got[..], [Fact::TimedOut { .. }]) && is_excused {
                unanswered += 1;
                continue;
            }
            let deviation = deviation.filter(|seen| sign.is_kept_by(&seen.sign));
            repeats.of += 1;
            repeats.seen += u32::from(deviation.is_some());
            count(&mut repeats.outcomes, got);
            found = found.or(deviation);
        }
    }
    let questions = smallest.questions + u64::from(repeats.of + unanswered);
    if (stop() || is_busy(unanswered)) && repeats.seen == repeats.of {
        let reduction = Reduced::Partly;
        let deviation = found.unwrap_or_else(|| smallest.deviation.clone());
        return Ok(Smallest {
            deviation,
            reduction,
            questions,
            ..smallest
        });
    }
    let Some(deviation) = found else {
        // Seen once, in the run.
        (repeats.seen, repeats.of) = (1, repeats.of + 1);
        count(&mut repeats.outcomes, smallest.deviation.got.clone());
        return Ok(Smallest {
            flaky: Some(repeats),
            questions,
            reduction: Reduced::Not,
            ..smallest
        });
    };
    if !is_by_chance(&repeats) {
        asked.note_steady(case);
    }
    Ok(Smallest {
        deviation,
        flaky: is_by_chance(&repeats).then_some(repeats),
        questions,
        ..smallest
    })
}

/// Returns whether runs of one program did not all have the deviation, or had it in several forms.
fn is_by_chance(repeats: &Repeats) -> bool {
    repeats.seen < repeats.of || repeats.outcomes.len() > 1
}

/// Adds an outcome to a list.
fn count(outcomes: &mut Vec<RepeatedOutcome>, got: Vec<Fact>) {
    let is_same = |one: &&mut RepeatedOutcome| {
        one.got.len() == got.len() && one.got.iter().zip(&got).all(|(one, other)| is_alike(one, other))
    };
    match outcomes.iter_mut().find(is_same) {
        Some(one) => one.runs += 1,
        None => outcomes.push(RepeatedOutcome { got, runs: 1 }),
    }
}

/// Returns whether two facts say the same but for words, which may name processes, addresses and times.
fn is_alike(one: &Fact, other: &Fact) -> bool {
    match (one, other) {
        (Fact::Crashed { .. }, Fact::Crashed { .. })
        | (Fact::Unusable { .. }, Fact::Unusable { .. })
        | (Fact::TimedOut { .. }, Fact::TimedOut { .. }) => true,
        (Fact::Diagnostic(one), Fact::Diagnostic(other)) | (Fact::Warning(one), Fact::Warning(other)) => {
            (&one.code, one.line) == (&other.code, other.line)
        }
        _ => one == other,
    }
}

/// Returns whether programs with this symptom are made smaller. A hang would take the whole time limit of each question;
/// what a compiler warns of, and what it answers beside the point, is plain without a smaller program.
pub(crate) const fn is_reducible(symptom: &Symptom) -> bool {
    !matches!(
        symptom,
        Symptom::Hang | Symptom::Error(_) | Symptom::OtherType | Symptom::NotWarned(_) | Symptom::Warned(_)
    )
}

/// Returns facts with the numbers of their lines changed to those of a program of which only `lines` are left.
pub(crate) fn moved(facts: &[Fact], lines: &[u32]) -> Vec<Fact> {
    let place = |line: &mut u32| {
        if let Some(at) = lines.iter().position(|former| former == line) {
            *line = at as u32 + 1;
        }
    };
    let mut facts = facts.to_vec();
    for fact in &mut facts {
        match fact {
            Fact::Diagnostic(reported) | Fact::Warning(reported) => reported.line.iter_mut().for_each(place),
            Fact::Fault { line, .. } => line.iter_mut().for_each(place),
            _ => {}
        }
    }
    facts
}
