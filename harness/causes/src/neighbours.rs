//! Asks about the neighbours of a shown program: the same with another type, another number, another name, or in another dialect. They say how
//! far a cause goes.

use crate::compiler_place::compiler_place;
use crate::find::Asking;
use crate::forms::{end_of_variables, named_types, with_types};
use crate::growing_cause::GrowingCause;
use crate::key::CauseKey;
use crate::line_features::lacked_function;
use crate::malformed::number_of_literal;
use crate::program::{Program, ReadProgram, read};
use crate::question::Questioner;
use crate::reduction::is_reducible;
use crate::smaller_case::{all_variables, as_the_reference, is_as_standard};
use crate::words::{elementary, has_word, tokens};
use std::collections::BTreeSet;
use stickler_engines::EngineError;
use stickler_reference::errors;
use stickler_run::{Neighbour, RunError, Symptom};
use stickler_suite::Case;
use stickler_syntax::Edits;
use stickler_syntax::source::Span;
use stickler_syntax::token::Token;
use stickler_syntax::tree::{Declaration, PouKind};
use stickler_types::ElementaryType;
use stickler_workers::WorkerPool;

/// The maximum number of types of the same family that are tried in the place of one.
const MAX_ALIKE: usize = 3;

/// The maximum number of functions that are told to be missing, too.
const MAX_FUNCTIONS: usize = 30;

/// The types of which those of other families are tried.
const OTHERS: [ElementaryType; 6] = {
    use ElementaryType::{Bool, Int, Real, String, Time, Word};
    [Bool, Int, Word, Real, Time, String]
};

/// The words for the type that no program declares.
const UNDECLARED: &str = "a type that is not declared";

/// The words for the name that stands in the place of another.
const OTHER_NAME: &str = "another name";

/// The words for a first statement that stands behind another one.
const BEHIND: &str = "the same behind another statement";

/// The keyword of a program in whose place a function block is right.
const IN_PROGRAM: &str = "`PROGRAM`";

/// A program beside a function block.
const CALLER: &str = "\nPROGRAM caller\nVAR\n    n : INT;\nEND_VAR\n    n := 0;\nEND_PROGRAM\n";

/// The maximum number of names in whose place others are tried.
const MAX_NAMES: usize = 6;

/// The numbers of bits at whose limits a compiler may do otherwise.
const BITS: [u32; 8] = [7, 8, 15, 16, 31, 32, 63, 64];

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
        let Some(known) = known.filter(|_| is_asked && is_reducible(symptom) && *symptom != Symptom::Text)
        else {
            return Ok(Default::default());
        };
        // What a valid program that is rejected would do does not matter, such as where it would stop with a fault.
        let accepted = |program: &str| {
            let is_valid = member.sign.rejects_valid() && errors(program, known.dialect).is_empty();
            is_valid.then(|| Case {
                source: program.into(),
                observe: Default::default(),
                scans: 0,
                expectation: Default::default(),
                ..(*known).clone()
            })
        };
        let as_shown = |program: &str| {
            let case = as_the_reference(known, program, &all_variables(known, program));
            case.or_else(|| accepted(program))
        };
        let Some(own) = as_shown(&shown.program) else {
            return Ok(Default::default());
        };
        asked.only_checks = member.sign.accepts();
        // A value that is right in another type may only be less far from its limits, and what is refused may not be supported.
        let is_value = matches!(symptom, Symptom::Value | Symptom::Missing);
        let tells = !is_value && !member.sign.accepts();
        // A neighbour has the same mistakes.
        let crashes = matches!(symptom, Symptom::Crash(_));
        let has_mistakes = |case: &Case| {
            let (told, wanted) = (&case.expectation, &own.expectation);
            let codes = wanted.diagnostics.iter().map(|one| one.code);
            let is_same = told.accepted == wanted.accepted;
            // No mistake may make a compiler crash.
            crashes || is_same && told.diagnostics.iter().map(|one| one.code).eq(codes)
        };
        let with_case = |program: &str| {
            as_shown(program).filter(|case| {
                has_mistakes(case)
                    && (member.sign.accepts() || is_as_standard(&own, program))
                    && !asked.uses_what_is_lacking(known, program)
            })
        };
        let dialects = self.engine.identity().dialects.iter().copied();
        let dialects = dialects.filter(|dialect| *dialect != known.dialect && !dialect.is_variant());
        let dialects = dialects.filter_map(|dialect| {
            let there = Case {
                dialect,
                ..(*known).clone()
            };
            let observed = all_variables(&there, &shown.program);
            let case = as_the_reference(&there, &shown.program, &observed).filter(has_mistakes)?;
            Some((neighbour(known.dialect.as_str(), dialect.as_str()), case))
        });
        let dialects: Vec<(Neighbour, Case)> = dialects.collect();
        let types = read(&shown.program, |program| {
            with_other_types(program, (is_value, crashes))
        })
        .into_iter();
        let types = types.filter_map(|(neighbour, program)| Some((neighbour, with_case(&program)?)));
        let types: Vec<(Neighbour, Case)> = types.collect();
        let program = Program::new(&shown.program);
        // A loop that is left by a count does what it must with other numbers, also where it never ends.
        let counts = !has_word(&shown.program, "EXIT");
        let numbers = numbers(&program.read()).into_iter().filter(|_| counts);
        let numbers = numbers.map(|(span, text, plainer)| {
            let plainer = plainer.into_iter().filter(|by| by != text).filter_map(|by| {
                let program = Edits::replacing(span, by.as_str()).apply(&shown.program);
                Some((format!("`{by}`"), with_case(&program)?))
            });
            (format!("`{text}`"), plainer.collect())
        });
        let numbers: Vec<(String, Vec<(String, Case)>)> = numbers.collect();
        // What a compiler of C finds wrong may be a name of its own.
        let is_written = matches!(symptom, Symptom::Unusable(_) | Symptom::Rejected(_));
        let names = read(&shown.program, |program| match is_written {
            true => {
                let behind = behind_statement(program).into_iter().collect();
                [with_other_names(program), without_blanks(program), behind].concat()
            }
            false if member.sign.accepts() => in_block(program).into_iter().collect(),
            false => Vec::new(),
        });
        let names = names.into_iter();
        let names = names.filter_map(|(neighbour, program)| Some((neighbour, with_case(&program)?)));
        let names: Vec<(Neighbour, Case)> = names.collect();
        asked.ask_ahead(types.iter().map(|(_, case)| case), stop)?;
        let place = compiler_place(&shown.got);
        let mut keys = Vec::new();
        // What goes wrong otherwise says nothing.
        let mut is_same = |case: &Case| {
            if stop() {
                return Ok::<_, EngineError>(None);
            }
            let seen = asked.deviation(case)?;
            // What is not accepted is found, whatever is said of it.
            let seen = seen.filter(|seen| seen.sign.accepts() || !member.sign.accepts());
            let is_same = seen.as_ref().is_none_or(|seen| {
                is_alike(symptom, &seen.sign.symptom) && compiler_place(&seen.got) == place
            });
            let is_wrong = seen.is_some();
            keys.extend(
                seen.filter(|_| is_same && !is_value)
                    .map(|seen| CauseKey::of_deviation(&case.source, seen)),
            );
            Ok(is_same.then_some(is_wrong))
        };
        // What is measured may be what the page shows no more.
        if is_same(&own)? != Some(true) {
            return Ok(Default::default());
        }
        let mut found = Vec::new();
        for (neighbour, case) in dialects {
            if let Some(is_same) = is_same(&case)? {
                found.push(Neighbour { is_same, ..neighbour });
            }
        }
        for (neighbour, case) in types {
            let tells = tells && neighbour.by != UNDECLARED;
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
            if let Some((by, case)) = plainer.get(nearer).filter(|_| !told.is_empty())
                && is_same(case)? == Some(false)
            {
                found.push(Neighbour {
                    is_same: false,
                    replaced: replaced.clone(),
                    by: by.clone(),
                });
            }
            found.extend(told.into_iter().map(|(at, is_same)| Neighbour {
                replaced: replaced.clone(),
                by: plainer[at].0.clone(),
                is_same,
            }));
        }
        Ok((found, keys))
    }
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

/// Returns a program with other types in the place of each of its types, of which the program names none; with `only_alike` those of the same
/// family alone, since a value of another is computed otherwise; and `with_undeclared` with a type that nothing declares.
fn with_other_types(
    program: &ReadProgram<'_, '_>,
    (only_alike, with_undeclared): (bool, bool),
) -> Vec<(Neighbour, String)> {
    let there = named_types(program.text);
    let mut found = Vec::new();
    for ty in there.iter().filter_map(|name| elementary(name)) {
        let alike = ElementaryType::ALL
            .into_iter()
            .filter(|other| other.family() == ty.family());
        let alike = alike.filter(|other| *other != ty).take(MAX_ALIKE);
        let others = OTHERS
            .into_iter()
            .filter(|other| !only_alike && other.family() != ty.family());
        let others = alike.chain(others).filter(|other| !there.contains(other.name()));
        found.extend(others.map(|other| {
            let program = with_types(program.text, &[(ty.name(), other.name())]);
            (neighbour(ty.name(), other.name()), program)
        }));
        found.extend(with_undeclared.then(|| {
            let by = UNDECLARED.to_owned();
            let program = with_types(program.text, &[(ty.name(), "UNDECLARED")]);
            (
                Neighbour {
                    by,
                    ..neighbour(ty.name(), "")
                },
                program,
            )
        }));
    }
    found
}

/// Returns a program with another name in the place of each name that it declares, as neighbours with which the same does not come.
fn with_other_names(program: &ReadProgram<'_, '_>) -> Vec<(Neighbour, String)> {
    let names: BTreeSet<&str> = program.names.iter().map(|one| one.name.text).collect();
    let renamed = names.into_iter().take(MAX_NAMES).map(|name| {
        let mut edits = Edits::new();
        let is_it = |token: &&Token| token.span.text(program.text).eq_ignore_ascii_case(name);
        let written = tokens(program.text);
        written
            .iter()
            .filter(is_it)
            .for_each(|token| edits.replace(token.span, "renamed"));
        let neighbour = Neighbour {
            is_same: false,
            by: OTHER_NAME.to_owned(),
            ..neighbour(name, "")
        };
        (neighbour, edits.apply(program.text))
    });
    renamed.collect()
}

/// Returns a program without the blanks before each sign before which one seldom stands, as neighbours with which the same does not come.
fn without_blanks(program: &ReadProgram<'_, '_>) -> Vec<(Neighbour, String)> {
    let signs = [";", "^", ",", ")", "]", "."].into_iter();
    let spaced = signs.map(|sign| (format!(" {sign}"), sign));
    let spaced = spaced.filter(|(spaced, _)| program.text.contains(spaced.as_str()));
    let joined = spaced.map(|(spaced, sign)| {
        let neighbour = Neighbour {
            is_same: false,
            ..neighbour(&spaced, sign)
        };
        (neighbour, program.text.replace(&spaced, sign))
    });
    joined.collect()
}

/// Returns a program with another statement before its first one, as a neighbour with which the same does not come.
fn behind_statement(program: &ReadProgram<'_, '_>) -> Option<(Neighbour, String)> {
    let pou = program.unit.pous().find(|pou| !pou.body.is_empty())?;
    let first = pou.body[0].span.start as usize;
    let end = end_of_variables(program.text, pou)?;
    let mut edits = Edits::new();
    edits.replace(end..end, "    n : INT;\n");
    edits.replace(first..first, "n := 0;\n    ");
    let written = pou.body[0].span.text(program.text);
    let neighbour = Neighbour {
        is_same: false,
        by: BEHIND.to_owned(),
        ..neighbour(written, "")
    };
    (!written.contains('\n')).then(|| (neighbour, edits.apply(program.text)))
}

/// Returns a program that has nothing but one PROGRAM with a FUNCTION_BLOCK in its place, as a neighbour with which the same does not come;
/// `None` for another one.
fn in_block(program: &ReadProgram<'_, '_>) -> Option<(Neighbour, String)> {
    let [Declaration::Pou(pou)] = &program.unit.declarations[..] else {
        return None;
    };
    let neighbour = Neighbour {
        is_same: false,
        ..neighbour("PROGRAM", "FUNCTION_BLOCK")
    };
    let block = with_types(program.text, &[("PROGRAM", "FUNCTION_BLOCK")]);
    (pou.kind == PouKind::Program).then(|| (neighbour, block + CALLER))
}

/// Returns the numbers of a program, each with plainer ones that may stand in its place, the plainest first: other digits of a location, an
/// integer in capitals, or smaller ones with the same type and base, up to the limits of some sizes.
fn numbers<'s>(program: &ReadProgram<'_, 's>) -> Vec<(Span, &'s str, Vec<String>)> {
    let literals = program.literals().map(|(part, text)| {
        let plainer = match text.to_ascii_uppercase() {
            capitals if capitals != text && number_of_literal(text).is_some() => vec![capitals],
            _ => smaller(text),
        };
        (part.expression.span, text, plainer)
    });
    let groups = program.names.iter().filter_map(|one| one.group?.location);
    let locations = groups.map(|place| {
        let letters = place.text.trim_end_matches(|sign: char| sign.is_ascii_digit());
        (place.span, place.text, vec![format!("{letters}1")])
    });
    literals.chain(locations).collect()
}

/// Returns 1 and the numbers at the limits of some sizes, of those that are nearer to zero than an integer literal, and one that is twice as far
/// away, as it is written.
fn smaller(text: &str) -> Vec<String> {
    let Some(number) = number_of_literal(text) else {
        return Vec::new();
    };
    let limits = BITS.iter().flat_map(|bits| [(1 << bits) - 1, 1 << bits]);
    let nearer = [1]
        .into_iter()
        .chain(limits)
        .filter(|limit: &i128| *limit < number.abs())
        .chain(number.abs().checked_mul(2).map(|twice| twice + 1));
    let prefix = text.rfind('#').map_or("", |at| &text[..=at]);
    let sign = if number < 0 { "-" } else { "" };
    let written = nearer.map(|limit| match prefix {
        _ if prefix.ends_with("16#") => format!("{prefix}{limit:X}"),
        _ if prefix.ends_with("8#") => format!("{prefix}{limit:o}"),
        _ if prefix.ends_with("2#") => format!("{prefix}{limit:b}"),
        _ => format!("{prefix}{sign}{limit}"),
    });
    written.collect()
}
