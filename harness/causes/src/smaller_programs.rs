//! The judge of the smaller programs that a reduction tries: what they may become, and whether the engine still deviates with them.

use crate::failure_sign::{Sign, is_of_reading};
use crate::guard::Constructs;
use crate::malformed::{forms_of_literals, words_with_digits};
use crate::question::{Deviation, Questioner, Takes, until_interesting};
use crate::reduction::{has_fault, has_same_value};
use crate::smaller_case::with_program;
use crate::words::{LOOPS, words};
use std::cell::Cell;
use stickler_engines::EngineError;
use stickler_reduce::{CandidateJudge, Interestingness};
use stickler_run::{CaseEvent, Symptom};
use stickler_suite::Case;
use stickler_types::Code;

/// The judge of what the program of a case may become: the engine is asked about it.
pub(crate) struct SmallerPrograms<'a, 'e> {
    pub(crate) asked: &'a mut Questioner<'e>,
    pub(crate) case: &'a Case,
    pub(crate) event: &'a CaseEvent,
    pub(crate) sign: &'a Sign,
    pub(crate) start: &'a str,
    pub(crate) constructs: Constructs,
    pub(crate) takes: Takes,
    /// The number of programs without an answer in time.
    pub(crate) hangs: &'a Cell<u32>,
    pub(crate) stop: &'a dyn Fn() -> bool,
    /// The maximum number of times that the engine is asked about one program before it deviates: one, unless it does so by chance.
    pub(crate) times: usize,
    /// The number of times that the engine was asked.
    pub(crate) questions: u64,
    /// The reason why the engine cannot be asked any more.
    pub(crate) error: Option<EngineError>,
}

impl SmallerPrograms<'_, '_> {
    /// Returns whether the literals of a program may be what they are. Another literal that should not be read is another mistake, and no
    /// document says how large an array may be.
    fn keeps_literals(&self, program: &str) -> bool {
        let Symptom::NotRejected(code) = &self.sign.symptom else {
            return true;
        };
        let is_of_size = code == Code::ArraySizeOverflow.as_str();
        // A part of such a literal may have its form.
        let has_form = || {
            let forms = forms_of_literals(program);
            !forms.is_empty() && forms == forms_of_literals(self.start)
        };
        !(is_of_reading(code) || is_of_size)
            || words_with_digits(program).is_subset(&words_with_digits(self.start))
            || !is_of_size && has_form()
    }

    /// Returns whether a program with a loop still leaves it where the whole program does, by an EXIT: without that it may never end.
    fn keeps_exits(&self, program: &str) -> bool {
        let is_run = matches!(
            self.sign.symptom,
            Symptom::Value | Symptom::Missing | Symptom::Fault(_)
        );
        let number = |text: &str, sought: &[&str]| {
            let words = words(text);
            let is_sought = |word: &&&str| sought.iter().any(|one| one.eq_ignore_ascii_case(word));
            words.iter().filter(is_sought).count()
        };
        let needed = number(self.start, &["EXIT"]).min(number(program, &LOOPS));
        !is_run || number(program, &["EXIT"]) >= needed
    }

    /// Judges one program.
    pub(crate) fn takes_one(&mut self, program: &String) -> bool {
        self.admits(program) && self.judge(std::slice::from_ref(program)) == [Interestingness::Interesting]
    }

    /// Returns the first deviation of the kind that is sought, asking several times.
    fn deviation_by_chance(&mut self, smaller: &Case) -> Result<Option<Deviation>, EngineError> {
        let sign = self.sign;
        for _ in 0..self.times {
            if (self.stop)() {
                break;
            }
            let seen = self.asked.again(smaller, (&sign.symptom, 1), self.stop)?;
            let mut deviations = seen.into_iter().filter_map(|(_, deviation)| deviation);
            let sought = deviations.find(|seen| sign.is_kept_by(&seen.sign));
            if sought.is_some() {
                return Ok(sought);
            }
        }
        Ok(None)
    }

    /// Returns whether the engine deviates with a program as it does with that of the case.
    fn deviates(&mut self, program: &str, smaller: &Case) -> Result<bool, EngineError> {
        self.questions += 1;
        let seen = match self.times {
            1 => self.asked.deviation(smaller)?,
            _ => self.deviation_by_chance(smaller)?,
        };
        let event = self.event;
        Ok(seen.is_some_and(|seen| {
            let is_hang = seen.sign.symptom == Symptom::Hang;
            self.hangs.set(self.hangs.get() + u32::from(is_hang));
            self.sign.is_kept_by(&seen.sign)
                && (has_fault(&event.got) || !has_fault(&seen.got))
                && (program == self.start || has_same_value(event, &seen))
        }))
    }
}

impl CandidateJudge<String> for SmallerPrograms<'_, '_> {
    fn admits(&mut self, program: &String) -> bool {
        let may_become = |smaller: &Constructs| self.constructs.may_become(smaller, self.takes);
        self.error.is_none()
            && (program == self.start
                || may_become(&Constructs::of(program))
                    && self.keeps_literals(program)
                    && self.keeps_exits(program)
                    && !self.asked.uses_what_is_lacking(self.case, program))
    }

    fn judge(&mut self, programs: &[String]) -> Vec<Interestingness> {
        let cases = programs
            .iter()
            .map(|program| with_program(self.case, self.sign, program));
        let cases: Vec<Option<Case>> = cases.collect();
        let ahead = match self.times {
            1 => self.asked.ask_ahead(cases.iter().flatten(), self.stop),
            _ => Ok(()),
        };
        let judge = |at: usize, case: &Case| Ok(Interestingness::from(self.deviates(&programs[at], case)?));
        let judged = ahead.and_then(|()| until_interesting(&cases, judge));
        judged.unwrap_or_else(|failed| {
            self.error = Some(failed);
            vec![Interestingness::Invalid; programs.len()]
        })
    }

    fn pack_size(&self) -> usize {
        match self.hangs.get() {
            0 => self.asked.pack_size_of(&self.sign.symptom),
            _ => 1,
        }
    }
}
