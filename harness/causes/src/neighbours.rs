//! Asks about the neighbours of a shown program: the same with another type, or in another unit. They say how far a cause goes, which its heading
//! says where it goes no further.

use crate::find::Asking;
use crate::forms::{body, named_types, with_types};
use crate::growing_cause::GrowingCause;
use crate::program::{ReadProgram, read};
use crate::question::Questioner;
use crate::reduction::is_reducible;
use crate::smaller_case::{all_variables, as_the_reference, is_as_standard};
use crate::words::{elementary, has_word, kind};
use stickler_engines::EngineError;
use stickler_run::{Neighbour, Reduced, RunError, Symptom};
use stickler_suite::Case;
use stickler_syntax::tree::PouKind;
use stickler_types::ElementaryType;
use stickler_workers::WorkerPool;

/// The maximum number of types that are tried in the place of one.
const MAX_TYPES: usize = 4;

/// The units that statements of a PROGRAM are moved to, with what begins them, what ends them, and what calls them.
const UNITS: [(&str, [&str; 3]); 2] = [
    (
        "a FUNCTION_BLOCK",
        [
            "FUNCTION_BLOCK WORK",
            "END_FUNCTION_BLOCK",
            "VAR\n    work : WORK;\nEND_VAR\n    work();",
        ],
    ),
    (
        "a FUNCTION",
        [
            "FUNCTION WORK : BOOL\nVAR_INPUT\n    given : BOOL;\nEND_VAR",
            "    WORK := given;\nEND_FUNCTION",
            "VAR\n    done : BOOL;\nEND_VAR\n    done := WORK(given := TRUE);",
        ],
    ),
];

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
        for (member, neighbours) in causes.iter_mut().zip(found) {
            member.cause.shown.neighbours = neighbours;
        }
        Ok(())
    }

    fn neighbours_of(
        &self,
        asked: &mut Questioner<'_>,
        member: &GrowingCause,
        stop: &dyn Fn() -> bool,
    ) -> Result<Vec<Neighbour>, EngineError> {
        let (cause, shown) = (&member.cause, &member.cause.shown);
        let is_asked = cause.reduction == Reduced::Smallest && cause.flaky.is_none();
        let known = self.cases.get(&(shown.case.clone(), shown.dialect.clone()));
        let Some(known) = known.filter(|_| is_asked && is_reducible(&member.sign.symptom)) else {
            return Ok(Vec::new());
        };
        asked.only_checks = member.sign.accepts();
        let as_shown = |program: &str| as_the_reference(known, program, &all_variables(known, program));
        let Some(own) = as_shown(&shown.program) else {
            return Ok(Vec::new());
        };
        let codes = |case: &Case| {
            case.expectation
                .diagnostics
                .iter()
                .map(|one| one.code)
                .collect::<Vec<_>>()
        };
        // A neighbour has the same mistakes.
        let with_case = |(neighbour, program): (Neighbour, String)| {
            let case = as_shown(&program).filter(|case| {
                case.expectation.accepted == own.expectation.accepted
                    && codes(case) == codes(&own)
                    && (member.sign.accepts() || is_as_standard(&own, &program))
                    && !asked.uses_what_is_lacking(known, &program)
            });
            Some((neighbour, case?))
        };
        let programs = read(&shown.program, |program| {
            let others = with_other_types(program).into_iter();
            others.chain(in_other_units(program)).collect::<Vec<_>>()
        });
        let cases: Vec<(Neighbour, Case)> = programs.into_iter().filter_map(with_case).collect();
        asked.ask_ahead(cases.iter().map(|(_, case)| case), stop)?;
        let mut found = Vec::new();
        for (neighbour, case) in cases {
            if stop() {
                return Ok(Vec::new());
            }
            let is_same = match asked.deviation(&case)? {
                Some(seen) if is_alike(&member.sign.symptom, &seen.sign.symptom) => true,
                None => false,
                // What goes wrong otherwise says nothing.
                Some(_) => continue,
            };
            found.push(Neighbour { is_same, ..neighbour });
        }
        Ok(found)
    }
}

/// Returns whether an engine deviates in one way, whatever words it says it in.
fn is_alike(one: &Symptom, other: &Symptom) -> bool {
    match (one, other) {
        (Symptom::Value | Symptom::Missing, Symptom::Value | Symptom::Missing) => true,
        (Symptom::Crash(_), Symptom::Crash(_)) | (Symptom::Unusable(_), Symptom::Unusable(_)) => true,
        _ => one == other,
    }
}

/// Returns a program with other types of the same kind in the place of each of its types, of which the program names none.
fn with_other_types(program: &ReadProgram<'_, '_>) -> Vec<(Neighbour, String)> {
    let there = named_types(program.text);
    let mut found = Vec::new();
    for ty in there.iter().filter_map(|name| elementary(name)) {
        let is_other = |other: &ElementaryType| {
            kind(ty).is_some() && kind(*other) == kind(ty) && !there.contains(other.name())
        };
        let mut others: Vec<ElementaryType> = ElementaryType::ALL.into_iter().filter(is_other).collect();
        others.sort_by_key(|other| other.family() != ty.family());
        found.extend(others.into_iter().take(MAX_TYPES).map(|other| {
            let neighbour = Neighbour {
                replaced: format!("`{}`", ty.name()),
                by: format!("`{}`", other.name()),
                is_same: false,
            };
            (neighbour, with_types(program.text, &[(ty.name(), other.name())]))
        }));
    }
    found
}

/// Returns a program with the statements of its PROGRAM in another unit, which the PROGRAM calls.
fn in_other_units(program: &ReadProgram<'_, '_>) -> Vec<(Neighbour, String)> {
    let text = program.text;
    let is_main = |pou: &&stickler_syntax::tree::Pou<'_>| pou.kind == PouKind::Program;
    let has_name = ["work", "given", "done"].iter().any(|name| has_word(text, name));
    let main = program.unit.pous().find(is_main).filter(|_| !has_name);
    let Some((main, _)) = main.and_then(|main| Some((main, body(text, main)?))) else {
        return Vec::new();
    };
    let units = UNITS.into_iter().map(|(unit, [head, end, call])| {
        let neighbour = Neighbour {
            by: unit.to_owned(),
            ..Neighbour::default()
        };
        let inside = &text[main.name.span.end as usize..main.end.start as usize];
        let (before, behind) = (&text[..main.span.start as usize], &text[main.end.end as usize..]);
        let inside = format!("{head}{}\n{end}", inside.trim_end());
        let name = main.name.text;
        let caller = format!("PROGRAM {name}\n{call}\nEND_PROGRAM");
        (neighbour, format!("{before}{inside}\n\n{caller}{behind}"))
    });
    units.collect()
}
