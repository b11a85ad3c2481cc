//! Finds the files and commands by which a person sees each cause on the engine, and what these print.

use crate::find::Asking;
use crate::forms::{with_last_variable, with_measured_text};
use crate::growing_cause::GrowingCause;
use crate::program::read;
use crate::question::{Deviation, wrong_values};
use crate::smaller_case::{as_the_reference, shown_case};
use crate::title::stops;
use crate::words::has_word;
use stickler_engines::{Ability, Reproduction, reproduce_and_run};
use stickler_run::{Fact, Reduced, RunError, Symptom, shown_by};
use stickler_suite::Case;
use stickler_types::{Observation, Value};
use stickler_workers::WorkerPool;

/// The maximum number of characters that are kept of what the commands of a reproduction print.
const MAX_PRINTED: usize = 10_000;

/// The number of times that the files which show a text must be longer than those which show what is measured of it, so that the latter
/// are shown.
const MUCH_LONGER: usize = 2;

impl Asking<'_> {
    /// Finds the files and commands by which a person sees each deviation on the engine, and what these print.
    pub(crate) fn reproduce(&self, causes: &mut [GrowingCause]) -> Result<(), RunError> {
        for member in causes
            .iter_mut()
            .filter(|member| !member.cause.is_partly_reduced())
        {
            self.measure_text(member)?;
            self.copy_part(member)?;
        }
        let open = || Ok::<_, RunError>(());
        let work = |(): &mut (), member: &GrowingCause| Ok::<_, RunError>(self.reproduction(member));
        let found = WorkerPool::new(self.search.plan.jobs).map(causes.iter(), open, work)?;
        for (member, found) in causes.iter_mut().zip(found) {
            if let Some((reproduction, printed, has_ended_well)) = found {
                // What dies only when Stickler looks at it is no cause that a page may tell.
                if has_ended_well && matches!(member.sign.symptom, Symptom::Crash(_) | Symptom::Unusable(_)) {
                    member.cause.reduction = Reduced::Partly;
                }
                // What stops a program is told as the compiler told it, which may have been a signal.
                if let (Symptom::Fault(_), Some(last)) = (&member.sign.symptom, printed.lines().last()) {
                    let stops = stops(&member.cause.shown.got);
                    member.cause.title = member.cause.title.replace(&stops, &format!("stops: {last}"));
                }
                member.cause.shown.reproduction = Some(reproduction);
                member.cause.shown.printed = printed;
            }
        }
        Ok(())
    }

    /// Shows in the place of a wrong text what is measured of it, where the engine shows no text but through a long program.
    fn measure_text(&self, member: &mut GrowingCause) -> Result<(), RunError> {
        let shown = &member.cause.shown;
        let wrong = wrong_values(&shown.expected, &shown.got).next();
        let (Symptom::Value, Some((name, (Value::Text { units, .. }, Value::Text { units: other, .. })))) =
            (&member.sign.symptom, wrong)
        else {
            return Ok(());
        };
        let forms = read(&shown.program, |program| {
            with_measured_text(program, name, (units, other))
        });
        let known = self.cases.get(&(shown.case.clone(), shown.dialect.clone()));
        let Some((known, whole)) =
            known.and_then(|case| Some((case, self.length(&shown_case_of(case, member))?)))
        else {
            return Ok(());
        };
        for (program, measured) in forms {
            let case = as_the_reference(known, &program, std::slice::from_ref(&measured));
            let is_shorter = |case: &Case| {
                self.length(case)
                    .is_some_and(|length| MUCH_LONGER * length < whole)
            };
            let Some(case) = case.filter(is_shorter) else {
                continue;
            };
            let seen = self.questioner().deviation(&case)?;
            if let Some(seen) = seen.filter(|seen| seen.sign.symptom == Symptom::Value) {
                let shown = &mut member.cause.shown;
                (shown.program, shown.expected, shown.got) = (program, seen.expected, seen.got);
                break;
            }
        }
        Ok(())
    }

    /// Shows in the place of a wrong part of a variable, such as an output of an instance, a variable of the PROGRAM that is given it: what a
    /// compiler shows only through a copy of Stickler's own is then plain in the program.
    fn copy_part(&self, member: &mut GrowingCause) -> Result<(), RunError> {
        let shown = &member.cause.shown;
        let wrong = wrong_values(&shown.expected, &shown.got).next();
        let part = wrong.filter(|(name, _)| name.contains(['.', '[']) && !name.contains('@'));
        let known = self.cases.get(&(shown.case.clone(), shown.dialect.clone()));
        let (Some((name, values)), Some(known)) = (part, known) else {
            return Ok(());
        };
        let copy = read(&shown.program, |program| {
            let is_free = !has_word(program.text, "seen");
            with_last_variable(program, ("seen", values.0.type_name()), name).filter(|_| is_free)
        });
        let case = copy.and_then(|(program, seen)| as_the_reference(known, &program, &[seen]));
        let Some(case) = case else { return Ok(()) };
        let seen = self.questioner().deviation(&case)?;
        let is_same =
            |seen: &Deviation| wrong_values(&seen.expected, &seen.got).any(|(_, other)| other == values);
        if let Some(seen) = seen.filter(is_same) {
            let shown = &mut member.cause.shown;
            (shown.program, shown.expected, shown.got) = (case.source.to_string(), seen.expected, seen.got);
        }
        Ok(())
    }

    /// Returns the length of the files that show what is observed of a program; `None` where there are none.
    fn length(&self, case: &Case) -> Option<usize> {
        let reproduction = self.engine.reproduce(&case.request(), Ability::Execute).ok()?;
        Some(reproduction.files.iter().map(|file| file.text.len()).sum())
    }

    /// Returns the reproduction of the shown program, what its commands print, and whether all of them succeed; nothing where the search was cancelled, ended before
    /// the program was small, since most such programs show another cause again, or where they hang.
    fn reproduction(&self, member: &GrowingCause) -> Option<(Reproduction, String, bool)> {
        let shown = &member.cause.shown;
        let case = self.cases.get(&(shown.case.clone(), shown.dialect.clone()))?;
        let case = shown_case_of(case, member);
        let tells_run = |fact: &Fact| matches!(fact, Fact::Fault { .. } | Fact::TimedOut { .. });
        let ability = match &member.sign.symptom {
            Symptom::Crash(_) | Symptom::Unusable(_) | Symptom::Hang | Symptom::Fault(_) => Ability::Execute,
            // What is accepted and should not be may stop, and the minimal program of a feature may not end.
            _ if shown.got.iter().any(tells_run) => Ability::Execute,
            _ => shown_by(&case),
        };
        let request = case.request();
        if let [Fact::TimedOut { after_ms }] = shown.got[..] {
            let reproduction = self.engine.reproduce(&request, ability).ok()?;
            return Some((reproduction.within(after_ms.div_ceil(1000)), String::new(), false));
        }
        if self.search.cancel.is_requested() || member.cause.is_partly_reduced() {
            return Some((
                self.engine.reproduce(&request, ability).ok()?,
                String::new(),
                false,
            ));
        }
        match reproduce_and_run(self.engine, &request, ability).ok()? {
            (reproduction, Ok(output)) => {
                let printed = output.text.chars().take(MAX_PRINTED).collect();
                Some((reproduction, printed, output.succeeded))
            }
            // The time of the search ended before the commands did: nobody saw what they show.
            _ => Some((
                self.engine.reproduce(&request, ability).ok()?,
                String::new(),
                true,
            )),
        }
    }
}

/// Returns a case with the program of its cause, of which only what differs is observed; where nothing is computed wrongly, nothing is.
fn shown_case_of(case: &Case, member: &GrowingCause) -> Case {
    let shown = &member.cause.shown;
    let differing = shown.expected.iter().filter(|fact| !shown.got.contains(fact));
    let wrong: Vec<&str> = differing
        .filter_map(|fact| match fact {
            Fact::Value { name, .. } => Some(name.as_str()),
            _ => None,
        })
        .collect();
    let is_wrong = |one: &Observation| {
        let key = one.key().to_string();
        wrong.iter().any(|name| name.eq_ignore_ascii_case(&key))
    };
    let mut case = shown_case(case, &member.sign, shown);
    let observe = case.observe.iter().filter(|one| is_wrong(one));
    case.observe = observe.cloned().collect();
    case
}
