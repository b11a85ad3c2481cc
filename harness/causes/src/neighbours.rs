//! Asks about the neighbours of a shown program: the same with another type, or in another unit. They say how far a cause goes.

use crate::compiler_place::compiler_place;
use crate::find::Asking;
use crate::forms::{named_types, with_types};
use crate::growing_cause::GrowingCause;
use crate::program::{ReadProgram, read};
use crate::question::{Judged, Questioner};
use crate::reduction::is_reducible;
use crate::smaller_case::{all_variables, as_the_reference, is_as_standard};
use crate::words::{elementary, has_word};
use stickler_engines::EngineError;
use stickler_run::{Fact, Neighbour, Reduced, RunError, Symptom};
use stickler_suite::Case;
use stickler_syntax::tree::{Pou, PouKind};
use stickler_types::ElementaryType;
use stickler_workers::WorkerPool;

/// The maximum number of types of the same family that are tried in the place of one.
const MAX_ALIKE: usize = 3;

/// The types of which those of other families are tried.
const OTHERS: [ElementaryType; 6] = {
    use ElementaryType::{Bool, Int, Real, String, Time, Word};
    [Bool, Int, Word, Real, Time, String]
};

/// A PROGRAM with nothing wrong, whose statements are moved to other units too: what an engine does not take there says nothing.
const SOUND: &str = "PROGRAM main\nVAR\n    x : INT;\nEND_VAR\n    x := 1;\nEND_PROGRAM\n";

/// The units that statements of a PROGRAM are moved to, with what begins them, what ends them, and what calls them.
const UNITS: [(&str, [&str; 3]); 2] = [
    (
        "a FUNCTION_BLOCK",
        [
            "FUNCTION_BLOCK WORK",
            "END_FUNCTION_BLOCK",
            "VAR\n    work : WORK;\n    done : BOOL;\nEND_VAR\n    work();\n    done := TRUE;",
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
        let (cause, shown, symptom) = (&member.cause, &member.cause.shown, &member.sign.symptom);
        let is_asked = cause.reduction == Reduced::Smallest && cause.flaky.is_none();
        let known = self.cases.get(&(shown.case.clone(), shown.dialect.clone()));
        let Some(known) = known.filter(|_| is_asked && is_reducible(symptom)) else {
            return Ok(Vec::new());
        };
        let as_shown = |program: &str| as_the_reference(known, program, &all_variables(known, program));
        let Some(own) = as_shown(&shown.program) else {
            return Ok(Vec::new());
        };
        asked.only_checks = member.sign.accepts();
        let is_value = matches!(symptom, Symptom::Value | Symptom::Missing);
        let sound = read(SOUND, in_other_units);
        let mut programs = read(&shown.program, with_other_types);
        for (moved, (_, sound)) in read(&shown.program, in_other_units).into_iter().zip(sound) {
            if let Some(sound) = as_shown(&sound).filter(|_| !is_value && !stop())
                && asked.deviation(&sound)?.is_none()
            {
                programs.push(moved);
            }
        }
        // A neighbour has the same mistakes.
        let with_case = |(neighbour, program): (Neighbour, String)| {
            let case = as_shown(&program).filter(|case| {
                let (told, wanted) = (&case.expectation, &own.expectation);
                let codes = wanted.diagnostics.iter().map(|one| one.code);
                told.accepted == wanted.accepted
                    && told.diagnostics.iter().map(|one| one.code).eq(codes)
                    && (member.sign.accepts() || is_as_standard(&own, &program))
                    && !asked.uses_what_is_lacking(known, &program)
            });
            Some((neighbour, case?))
        };
        let cases: Vec<(Neighbour, Case)> = programs.into_iter().filter_map(with_case).collect();
        asked.ask_ahead(cases.iter().map(|(_, case)| case), stop)?;
        let mut found = Vec::new();
        let place = compiler_place(&shown.got);
        for (neighbour, case) in cases.into_iter().take_while(|_| !stop()) {
            let seen = asked.deviation(&case)?;
            let is_same = seen.as_ref().is_some_and(|seen| {
                is_alike(symptom, &seen.sign.symptom) && compiler_place(&seen.got) == place
            });
            // What goes wrong otherwise, or is not supported, says nothing; a value that is right in another type may only be less far from its
            // limits, and another unit has defects of its own.
            let tells = !is_value && !neighbour.replaced.is_empty() && seen.is_none();
            let is_right = tells && asked.again(&case, (symptom, 1), stop)?.iter().all(is_supported);
            if is_same || is_right {
                found.push(Neighbour { is_same, ..neighbour });
            }
        }
        Ok(found)
    }
}

/// Returns whether an engine took a program as one of its language.
fn is_supported((got, _): &Judged) -> bool {
    let is_lack = |fact: &Fact| matches!(fact, Fact::Unsupported { .. } | Fact::NotImplemented { .. });
    !got.iter().any(is_lack)
}

/// Returns whether an engine deviates in one way, whatever words it says it in.
fn is_alike(one: &Symptom, other: &Symptom) -> bool {
    match (one, other) {
        (Symptom::Value | Symptom::Missing, Symptom::Value | Symptom::Missing) => true,
        (Symptom::Crash(_), Symptom::Crash(_)) | (Symptom::Unusable(_), Symptom::Unusable(_)) => true,
        _ => one == other,
    }
}

/// Returns a program with other types in the place of each of its types, of which the program names none.
fn with_other_types(program: &ReadProgram<'_, '_>) -> Vec<(Neighbour, String)> {
    let there = named_types(program.text);
    let mut found = Vec::new();
    for ty in there.iter().filter_map(|name| elementary(name)) {
        let alike = ElementaryType::ALL
            .into_iter()
            .filter(|other| other.family() == ty.family());
        let alike = alike.filter(|other| *other != ty).take(MAX_ALIKE);
        let others = OTHERS.into_iter().filter(|other| other.family() != ty.family());
        let others = alike.chain(others).filter(|other| !there.contains(other.name()));
        found.extend(others.map(|other| {
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
    let has_name = ["work", "given", "done"].iter().any(|name| has_word(text, name));
    let is_moved = |pou: &&Pou<'_>| pou.kind == PouKind::Program && !pou.body.is_empty() && !has_name;
    let Some(main) = program.unit.pous().find(is_moved) else {
        return Vec::new();
    };
    let units = UNITS.into_iter().map(|(unit, [head, end, call])| {
        let neighbour = Neighbour {
            by: unit.to_owned(),
            ..Neighbour::default()
        };
        let inside = &text[main.name.span.end as usize..main.end.start as usize];
        let (before, behind) = (&text[..main.span.start as usize], &text[main.end.end as usize..]);
        let (inside, name) = (inside.trim_end(), main.name.text);
        let moved = format!("{head}{inside}\n{end}\n\nPROGRAM {name}\n{call}\nEND_PROGRAM");
        (neighbour, format!("{before}{moved}{behind}"))
    });
    units.collect()
}
