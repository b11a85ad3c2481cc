//! Asks about the neighbours of a shown program: the same with another type, another number, another name, or in another dialect. They say how
//! far a cause goes.

mod programs;

use crate::compiler_place::compiler_place;
use crate::find::Asking;
use crate::growing_cause::GrowingCause;
use crate::key::CauseKey;
use crate::line_features::lacked_function;
use crate::malformed::number_of_literal;
use crate::program::{Program, read};
use crate::question::Questioner;
use crate::reduction::is_reducible;
use crate::smaller_case::{all_variables, as_the_reference, is_as_standard};
use crate::words::{elementary, has_word};
use programs::{behind_statement, in_block, numbers, with_other_names, with_other_types, without_blanks};
use std::collections::BTreeSet;
use stickler_engines::EngineError;
use stickler_reference::errors;
use stickler_run::{Neighbour, RunError, Symptom};
use stickler_suite::Case;
use stickler_syntax::Edits;
use stickler_types::DialectName;
use stickler_workers::WorkerPool;

/// The maximum number of functions that are told to be missing, too.
const MAX_FUNCTIONS: usize = 30;

/// The words for the type that no program declares.
const UNDECLARED: &str = "a type that is not declared";

/// The words for the name that stands in the place of another.
const OTHER_NAME: &str = "another name";

/// The words for a first statement that stands behind another one.
const BEHIND: &str = "the same behind another statement";

/// The keyword of a program in whose place a function block is right.
const IN_PROGRAM: &str = "`PROGRAM`";

impl Asking<'_> {
    /// Asks about the neighbours of each program that was made small. `stop` is asked before each.
    pub(crate) fn neighbours(
        &self,
        causes: &mut [GrowingCause],
        stop: &(dyn Fn() -> bool + Sync),
    ) -> Result<(), RunError> {
        let open = || Ok::<_, RunError>(self.questioner());
        let work = |asked: &mut Questioner<'_>, member: &GrowingCause| {
            Ok::<_, RunError>(self.neighbours_of(asked, member, stop)?)
        };
        let found = WorkerPool::new(self.search.plan.jobs).map(causes.iter(), open, work)?;
        for (member, (neighbours, keys)) in causes.iter_mut().zip(found) {
            if let Some(first) = first_wrong(&neighbours) {
                member.cause.title += &format!(", from {first} on");
            }
            // A type that is not declared says nothing where each type does.
            let is_of_type = |one: &Neighbour| !one.is_same && elementary(one.by.trim_matches('`')).is_some();
            let crashes =
                matches!(member.sign.symptom, Symptom::Crash(_)) && neighbours.iter().any(is_of_type);
            let decides = |one: &Neighbour| match one.by.as_str() {
                OTHER_NAME => Some(format!(", by the name {}", one.replaced)),
                BEHIND => Some(", as the first statement".to_owned()),
                UNDECLARED if one.is_same && crashes => {
                    Some(", as with a type that is not declared".to_owned())
                }
                by if one.replaced.starts_with("` ") => Some(format!(", with a blank before {by}")),
                _ if one.replaced == IN_PROGRAM => {
                    Some(", in a PROGRAM but not in a FUNCTION_BLOCK".to_owned())
                }
                _ => None,
            };
            let deciding: BTreeSet<String> = neighbours.iter().filter_map(decides).collect();
            member.cause.title += &deciding.into_iter().collect::<String>();
            let own = format!("`{}`", member.cause.shown.dialect);
            let others = || neighbours.iter().filter(|one| one.replaced == own);
            if others().next().is_some() && others().all(|one| !one.is_same) {
                let names: Vec<&str> = others().map(|one| one.by.as_str()).collect();
                member.cause.title += &format!(", but not in {}", names.join(" or "));
            }
            member.cause.shown.neighbours = neighbours;
            let shown = &member.cause.shown;
            let own = read(&shown.program, |program| {
                lacked_function(program, &shown.got).map(str::to_ascii_uppercase)
            });
            let others = member.functions.iter().filter(|by| Some(*by) != own.as_ref());
            let others = others.take(MAX_FUNCTIONS).zip(own.iter().cycle());
            let others = others.map(|(by, replaced)| neighbour(replaced, by));
            member.cause.shown.neighbours.extend(others);
            member.neighbours = keys;
        }
        Ok(())
    }

    fn neighbours_of(
        &self,
        asked: &mut Questioner<'_>,
        member: &GrowingCause,
        stop: &dyn Fn() -> bool,
    ) -> Result<(Vec<Neighbour>, Vec<CauseKey>), EngineError> {
        let (cause, shown, symptom) = (&member.cause, &member.cause.shown, &member.sign.symptom);
        let is_asked = !cause.is_partly_reduced() && cause.flaky.is_none();
        let known = self.cases.get(&(shown.case.clone(), shown.dialect.clone()));
        let known = known.filter(|_| is_asked && is_reducible(symptom) && *symptom != Symptom::Text);
        let Some(around) = known.and_then(|known| ShownProgram::new(member, known)) else {
            return Ok(Default::default());
        };
        asked.only_checks = member.sign.accepts();
        let dialects = around.in_dialects(&self.engine.identity().dialects);
        let types = around.with_types(asked);
        let names = around.with_forms(asked);
        let numbers = around.with_numbers(asked);
        asked.ask_ahead(types.iter().map(|(_, case)| case), stop)?;
        let mut keys = Vec::new();
        let mut is_same = |case: &Case| around.is_same(asked, case, (stop, &mut keys));
        // What is measured may be what the page shows no more.
        if is_same(&around.own)? != Some(true) {
            return Ok(Default::default());
        }
        let mut found = Vec::new();
        for (neighbour, case) in dialects {
            if let Some(is_same) = is_same(&case)? {
                found.push(Neighbour { is_same, ..neighbour });
            }
        }
        for (neighbour, case) in types {
            // A value that is right in another type may only be less far from its limits, and what is refused may not be supported.
            let tells = !around.is_value() && !member.sign.accepts() && neighbour.by != UNDECLARED;
            if let Some(is_same) = is_same(&case)?.filter(|is_same| *is_same || tells) {
                found.push(Neighbour { is_same, ..neighbour });
            }
        }
        for (neighbour, case) in names {
            if is_same(&case)? == Some(false) {
                found.push(neighbour);
            }
        }
        for (replaced, plainer) in numbers {
            let nearer = plainer.partition_point(|(by, _)| amount(by) <= amount(&replaced));
            let told = limits(nearer, |at| is_same(&plainer[at].1))?;
            // A limit is one only where what is beyond it is wrong, too.
            let beyond = plainer.get(nearer).filter(|_| !told.is_empty());
            let is_right = match beyond {
                Some((_, case)) => is_same(case)? == Some(false),
                None => false,
            };
            let beyond = is_right.then_some((nearer, false));
            found.extend(beyond.into_iter().chain(told).map(|(at, is_same)| Neighbour {
                replaced: replaced.clone(),
                by: plainer[at].0.clone(),
                is_same,
            }));
        }
        Ok((found, keys))
    }
}

/// The program of a page, whose neighbours are asked about.
struct ShownProgram<'a> {
    member: &'a GrowingCause,
    known: &'a Case,
    /// The case of the program itself.
    own: Case,
}

impl<'a> ShownProgram<'a> {
    fn new(member: &'a GrowingCause, known: &'a Case) -> Option<ShownProgram<'a>> {
        let own = as_shown(member, known, &member.cause.shown.program)?;
        Some(ShownProgram { member, known, own })
    }

    fn text(&self) -> &'a str {
        &self.member.cause.shown.program
    }

    fn is_value(&self) -> bool {
        matches!(self.member.sign.symptom, Symptom::Value | Symptom::Missing)
    }

    fn crashes(&self) -> bool {
        matches!(self.member.sign.symptom, Symptom::Crash(_))
    }

    /// Returns whether a neighbour has the same mistakes. No mistake may make a compiler crash.
    fn has_mistakes(&self, case: &Case) -> bool {
        let (told, wanted) = (&case.expectation, &self.own.expectation);
        let codes = wanted.diagnostics.iter().map(|one| one.code);
        let is_same = told.accepted == wanted.accepted;
        self.crashes() || is_same && told.diagnostics.iter().map(|one| one.code).eq(codes)
    }

    /// Returns the case of a neighbour; `None` where it says nothing of the program.
    fn with_case(&self, asked: &Questioner<'_>, program: &str) -> Option<Case> {
        as_shown(self.member, self.known, program).filter(|case| {
            self.has_mistakes(case)
                && (self.member.sign.accepts() || is_as_standard(&self.own, program))
                && !asked.uses_what_is_lacking(self.known, program)
        })
    }

    fn with_cases(&self, asked: &Questioner<'_>, found: Vec<(Neighbour, String)>) -> Vec<(Neighbour, Case)> {
        let found = found.into_iter();
        let found =
            found.filter_map(|(neighbour, program)| Some((neighbour, self.with_case(asked, &program)?)));
        found.collect()
    }

    /// Returns the program in the other dialects of an engine that are no variants.
    fn in_dialects(&self, dialects: &[DialectName]) -> Vec<(Neighbour, Case)> {
        let known = self.known;
        let others = dialects.iter().copied();
        let others = others.filter(|dialect| *dialect != known.dialect && !dialect.is_variant());
        let others = others.filter_map(|dialect| {
            let there = Case {
                dialect,
                ..known.clone()
            };
            let observed = all_variables(&there, self.text());
            let case = as_the_reference(&there, self.text(), &observed);
            let case = case.filter(|case| self.has_mistakes(case))?;
            Some((neighbour(known.dialect.as_str(), dialect.as_str()), case))
        });
        others.collect()
    }

    fn with_types(&self, asked: &Questioner<'_>) -> Vec<(Neighbour, Case)> {
        let how = (self.is_value(), self.crashes());
        self.with_cases(asked, read(self.text(), |program| with_other_types(program, how)))
    }

    /// Returns the program with other names, without blanks, behind a statement, or in a block, as the symptom may need.
    fn with_forms(&self, asked: &Questioner<'_>) -> Vec<(Neighbour, Case)> {
        let sign = &self.member.sign;
        // What a compiler of C finds wrong may be a name of its own.
        let is_written = matches!(sign.symptom, Symptom::Unusable(_) | Symptom::Rejected(_));
        let forms = read(self.text(), |program| match is_written {
            true => {
                let behind = behind_statement(program).into_iter().collect();
                [with_other_names(program), without_blanks(program), behind].concat()
            }
            false if sign.accepts() => in_block(program).into_iter().collect(),
            false => Vec::new(),
        });
        self.with_cases(asked, forms)
    }

    /// Returns each number of the program, with the cases of plainer ones in its place.
    fn with_numbers(&self, asked: &Questioner<'_>) -> Vec<(String, Vec<(String, Case)>)> {
        // A loop that is left by a count does what it must with other numbers, also where it never ends.
        if has_word(self.text(), "EXIT") {
            return Vec::new();
        }
        let program = Program::new(self.text());
        let numbers = numbers(&program.read()).into_iter();
        let numbers = numbers.map(|(span, text, plainer)| {
            let plainer = plainer.into_iter().filter(|by| by != text).filter_map(|by| {
                let program = Edits::replacing(span, by.as_str()).apply(self.text());
                Some((format!("`{by}`"), self.with_case(asked, &program)?))
            });
            (format!("`{text}`"), plainer.collect())
        });
        numbers.collect()
    }

    /// Returns whether the engine deviates with a neighbour in the same way, and adds the key of the neighbour; `None` where it does something
    /// else, which says nothing.
    fn is_same(
        &self,
        asked: &mut Questioner<'_>,
        case: &Case,
        (stop, keys): (&dyn Fn() -> bool, &mut Vec<CauseKey>),
    ) -> Result<Option<bool>, EngineError> {
        if stop() {
            return Ok(None);
        }
        let sign = &self.member.sign;
        let place = || compiler_place(&self.member.cause.shown.got);
        let seen = asked.deviation(case)?;
        // What is not accepted is found, whatever is said of it.
        let seen = seen.filter(|seen| seen.sign.accepts() || !sign.accepts());
        let is_same = seen.as_ref().is_none_or(|seen| {
            is_alike(&sign.symptom, &seen.sign.symptom) && compiler_place(&seen.got) == place()
        });
        let is_wrong = seen.is_some();
        let told = seen.filter(|_| is_same && !self.is_value());
        keys.extend(told.map(|seen| CauseKey::of_deviation(&case.source, seen)));
        Ok(is_same.then_some(is_wrong))
    }
}

/// Returns the case with another program, by what the reference does with it. What a valid program that is rejected would do does not matter,
/// such as where it would stop with a fault.
fn as_shown(member: &GrowingCause, known: &Case, program: &str) -> Option<Case> {
    let accepted = || {
        let is_valid = member.sign.rejects_valid() && errors(program, known.dialect).is_empty();
        is_valid.then(|| Case {
            source: program.into(),
            observe: Default::default(),
            scans: 0,
            expectation: Default::default(),
            ..known.clone()
        })
    };
    as_the_reference(known, program, &all_variables(known, program)).or_else(accepted)
}

/// Returns a neighbour with one word in the place of another, with which the same comes.
fn neighbour(replaced: &str, by: &str) -> Neighbour {
    Neighbour {
        replaced: format!("`{replaced}`"),
        by: format!("`{by}`"),
        is_same: true,
    }
}

/// Returns the last of some programs with which an engine does what it must, and the first with which it deviates. Nothing where it already
/// deviates with the first of all, and no further than it is known what it does.
fn limits(
    number: usize,
    mut is_same: impl FnMut(usize) -> Result<Option<bool>, EngineError>,
) -> Result<Vec<(usize, bool)>, EngineError> {
    if number == 0 || is_same(0)? != Some(false) {
        return Ok(Vec::new());
    }
    let (mut right, mut wrong) = (0, number);
    while right + 1 < wrong {
        let at = right + (wrong - right) / 2;
        match is_same(at)? {
            Some(false) => right = at,
            Some(true) => wrong = at,
            None => break,
        }
    }
    let first = (wrong < number).then_some((wrong, true));
    Ok([(right, false)].into_iter().chain(first).collect())
}

/// Returns the number from which on an engine deviates, where it does what it must with the number before: a limit of a type, which are those
/// above 127.
fn first_wrong(neighbours: &[Neighbour]) -> Option<&str> {
    neighbours.iter().filter(|one| !one.is_same).find_map(|right| {
        let others = || neighbours.iter().filter(|one| one.replaced == right.replaced);
        let wrong = others().find(|one| one.is_same);
        let wrong = wrong.map_or(right.replaced.as_str(), |one| &one.by);
        let is_last = others().all(|one| one.is_same || amount(&one.by) <= amount(&right.by));
        let is_limit = amount(wrong)? == amount(&right.by)? + 1 && amount(wrong)? > 127;
        (is_last && is_limit).then_some(wrong)
    })
}

/// Returns how far from zero an integer literal is, between the accents with which a page writes it.
fn amount(text: &str) -> Option<u128> {
    Some(number_of_literal(text.trim_matches('`'))?.unsigned_abs())
}

/// Returns whether an engine deviates in one way, whatever words it says it in.
fn is_alike(one: &Symptom, other: &Symptom) -> bool {
    match (one, other) {
        (Symptom::Value | Symptom::Missing, Symptom::Value | Symptom::Missing) => true,
        (Symptom::Crash(_), Symptom::Crash(_)) | (Symptom::Unusable(_), Symptom::Unusable(_)) => true,
        _ => one == other,
    }
}
