//! Cases with another program: what must happen with it, the reference says, and what was expected of the whole program.

use crate::failure_sign::Sign;
use crate::question::wrong_values;
use std::sync::Arc;
use stickler_reference::Limits;
use stickler_run::{Reproducer, Symptom, rendered_bodies};
use stickler_suite::{
    Acceptance, Case, Expectation, ExpectedDiagnostic, ExpectedFault, ExpectedText, ExpectedValue,
};
use stickler_types::{DialectName, Fault, NamedValue, Observation, Outcome, RunRequest, Setting};

/// The maximum number of variables of a program that are looked at.
const MAX_VARIABLES: usize = 1000;

/// Returns the case with another program in its place, made from its own by changes that keep the deviation `sign`. `None`
/// where the program must do something else than the case's own, so that the document of the case says nothing of it.
///
/// Of the variables that the case writes before scans those are written that the program has.
pub(crate) fn with_program(case: &Case, sign: &Sign, program: &str) -> Option<Case> {
    let observe = known(case, program);
    let names = stickler_reference::variables(program, case.dialect, MAX_VARIABLES);
    let has = |setting: &&Setting| {
        let set = setting.name.split(['.', '[']).next().unwrap_or_default();
        names.iter().any(|name| name.eq_ignore_ascii_case(set))
    };
    let case = &Case {
        set: case.set.iter().filter(has).cloned().collect(),
        ..case.clone()
    };
    let request = RunRequest {
        source: program,
        observe: &observe,
        ..case.request()
    };
    let outcome = stickler_reference::run(&request, Limits::default()).ok()?;
    // A program whose loop has no end shows something else.
    let is_endless =
        |outcome: &Outcome| matches!(outcome, Outcome::Faulted { fault, .. } if *fault == Fault::StepLimit);
    let of_whole = || stickler_reference::run(&case.request(), Limits::default());
    if !is_as_standard(case, program)
        || is_endless(&outcome) && !of_whole().is_ok_and(|whole| is_endless(&whole))
    {
        return None;
    }
    let expectation = match (&case.expectation.rendered, &sign.symptom) {
        (Some(whole), Symptom::Text) => rendered(whole, program, case.dialect)?,
        _ => expectation(&case.expectation, &sign.symptom, outcome)?,
    };
    // A program that must only go on to its end has no values to look at, since it may die where an adapter looks.
    let goes_on =
        matches!(sign.symptom, Symptom::Fault(_) | Symptom::Unusable(_)) && expectation.values.is_empty();
    Some(Case {
        source: program.into(),
        observe: if goes_on { Arc::default() } else { observe.into() },
        expectation: Arc::new(expectation),
        ..case.clone()
    })
}

/// Returns what a program must be rendered as that has some of the statements of a whole one, or statements that are as they are rendered; `None`
/// where it has others.
fn rendered(whole: &ExpectedText, program: &str, dialect: DialectName) -> Option<Expectation> {
    let text = stickler_reference::render(program, dialect).ok()?;
    let lines: Vec<Box<str>> = rendered_bodies(&text).into_iter().map(Box::from).collect();
    let plain = |line: &str| line.split_whitespace().collect::<String>();
    let written: Vec<String> = program.lines().map(plain).collect();
    let mut all = lines.iter();
    let is_kept = all.all(|line| whole.lines.contains(line) || written.contains(&plain(line)));
    is_kept.then(|| Expectation {
        rendered: Some(ExpectedText {
            lines,
            line: whole.line,
        }),
        ..Expectation::default()
    })
}

/// Returns whether the standard accepts a program if it accepts that of the case, so that the program needs nothing that only its dialect
/// allows.
pub(crate) fn is_as_standard(case: &Case, program: &str) -> bool {
    let accepts = |text: &str| stickler_reference::errors(text, DialectName::IEC_ED3).is_empty();
    accepts(program) || !accepts(&case.source)
}

/// Returns the observations of a case for which another program has the variable.
pub(crate) fn known(case: &Case, program: &str) -> Vec<Observation> {
    let known = stickler_reference::variables(program, case.dialect, MAX_VARIABLES);
    let is_known = |observation: &&Observation| {
        let mut names = known.iter();
        names.any(|name| name.eq_ignore_ascii_case(&observation.name))
    };
    case.observe.iter().filter(is_known).cloned().collect()
}

/// Returns observations of all variables of a program.
pub(crate) fn all_variables(case: &Case, program: &str) -> Vec<Observation> {
    match all_values(program, case.dialect) {
        (_, Some(values)) => {
            let of = |(name, value): &NamedValue| Observation::last(name, value.type_name());
            values.iter().map(of).collect()
        }
        (all, None) => all,
    }
}

/// Returns the variables of a program, and the values that they have after one scan; `None` where the program has no end of its own.
pub(crate) fn all_values(program: &str, dialect: DialectName) -> (Vec<Observation>, Option<Vec<NamedValue>>) {
    let names = stickler_reference::variables(program, dialect, MAX_VARIABLES);
    let all: Vec<Observation> = names.iter().map(|name| Observation::last(name, "")).collect();
    let request = RunRequest::once(dialect, program, &all);
    match stickler_reference::run(&request, Limits::default()) {
        Ok(Outcome::Executed { values, .. }) => (all, Some(values)),
        _ => (all, None),
    }
}

/// Returns a case with another program, held to what the reference does with it. `None` where that is neither a rejection nor
/// values.
pub(crate) fn as_the_reference(case: &Case, program: &str, observe: &[Observation]) -> Option<Case> {
    let case = Case {
        source: program.into(),
        observe: observe.into(),
        scans: 1,
        clock: Arc::default(),
        set: Arc::default(),
        ..case.clone()
    };
    let expectation = match stickler_reference::run(&case.request(), Limits::default()).ok()? {
        Outcome::Rejected { diagnostics } => Expectation {
            accepted: Acceptance::Rejected,
            diagnostics: diagnostics
                .iter()
                .filter_map(|reported| {
                    let (code, line) = (reported.registered_code()?, reported.line?);
                    Some(ExpectedDiagnostic { line, code })
                })
                .collect(),
            ..Expectation::default()
        },
        Outcome::Executed { values, .. } => Expectation {
            values: values.into_iter().map(expected_value).collect(),
            ..Expectation::default()
        },
        _ => return None,
    };
    Some(Case {
        expectation: Arc::new(expectation),
        ..case
    })
}

/// Returns the expectation that a variable has a value in the end.
pub(crate) fn expected_value((name, value): NamedValue) -> ExpectedValue {
    ExpectedValue {
        name: name.as_str().into(),
        after: None,
        value,
        line: 1,
    }
}

/// Returns the case with the program that a page shows, and the observations by which the deviation `sign` is seen there.
pub(crate) fn shown_case(case: &Case, sign: &Sign, shown: &Reproducer) -> Case {
    let program = &shown.program;
    let whole = case.without_blank_lines();
    if *whole.source == **program {
        return whole;
    }
    // A normal form may have other variables than the case, of which only the reference says what they must be.
    let alone = || as_the_reference(case, program, &all_variables(case, program));
    let kept = match sign.symptom {
        Symptom::Value | Symptom::Missing if shown.is_derived => None,
        Symptom::Value | Symptom::Missing => with_program(case, sign, program),
        // What is no value comes with the program alone, where that has one scan.
        _ if !case.set.is_empty() => alone().or_else(|| with_program(case, sign, program)),
        _ => with_program(case, sign, program),
    };
    // What is measured of a text stands in a variable that the case does not have.
    let names = wrong_values(&shown.expected, &shown.got).map(|(name, _)| name);
    let names: Vec<&str> = names.collect();
    let observes = |case: &Case| {
        let is_observed = |name: &&str| {
            case.observe
                .iter()
                .any(|one| one.key().to_string().eq_ignore_ascii_case(name))
        };
        names.iter().all(is_observed)
    };
    kept.filter(observes).or_else(alone).unwrap_or(whole)
}

/// Returns what must happen with a smaller program, by what the reference does and by what was expected of the whole one.
fn expectation(whole: &Expectation, symptom: &Symptom, outcome: Outcome) -> Option<Expectation> {
    let must_be_rejected = whole.accepted == Acceptance::Rejected;
    let is_open = whole.accepted == Acceptance::Observed;
    match outcome {
        Outcome::Rejected { diagnostics } if must_be_rejected => {
            let expected = |reported: &stickler_types::Diagnostic| {
                let (code, line) = (reported.registered_code()?, reported.line?);
                let is_expected = whole.diagnostics.iter().any(|one| one.code == code);
                is_expected.then_some(ExpectedDiagnostic { line, code })
            };
            let mut diagnostics: Vec<ExpectedDiagnostic> =
                diagnostics.iter().map(expected).collect::<Option<_>>()?;
            diagnostics.sort();
            // A program that became nonsense has mistakes that the whole one has not.
            if diagnostics.len() > whole.diagnostics.len() {
                return None;
            }
            Some(Expectation {
                accepted: Acceptance::Rejected,
                diagnostics,
                ..Expectation::default()
            })
        }
        // No program may make a compiler crash, or write what cannot be built.
        Outcome::Rejected { .. }
            if is_open && matches!(symptom, Symptom::Crash(_) | Symptom::Unusable(_)) =>
        {
            Some(Expectation {
                accepted: Acceptance::Observed,
                ..Expectation::default()
            })
        }
        // What is wrong with the program is gone, and the engine may still reject it.
        Outcome::Executed { .. } if must_be_rejected => {
            // A mistake that is told twice is not the reason for which a program without it is rejected.
            let is_expected =
                |reported: &str| whole.diagnostics.iter().any(|one| one.code.as_str() == reported);
            let may_hide = match symptom {
                Symptom::OtherCode { .. } | Symptom::Rejected(_) => true,
                Symptom::Surplus(reported) => !is_expected(reported),
                _ => false,
            };
            may_hide.then(Expectation::default)
        }
        Outcome::Executed { values, .. } if whole.fault.is_none() => accepted(whole, symptom, &values),
        // What stops when it runs is accepted before that.
        Outcome::Faulted { .. }
            if !must_be_rejected && matches!(symptom, Symptom::Rejected(_) | Symptom::NotImplemented(_)) =>
        {
            Some(Expectation::default())
        }
        Outcome::Faulted { fault, line, .. } => {
            let expected = whole.fault.filter(|expected| expected.fault == fault)?;
            let line = line.unwrap_or(expected.line);
            Some(Expectation {
                fault: Some(ExpectedFault { fault, line }),
                ..Expectation::default()
            })
        }
        _ => None,
    }
}

/// Returns what must happen with a program that is accepted: where values count, those that the whole program must have too.
fn accepted(whole: &Expectation, symptom: &Symptom, values: &[NamedValue]) -> Option<Expectation> {
    if matches!(
        symptom,
        Symptom::Rejected(_)
            | Symptom::NotImplemented(_)
            | Symptom::Crash(_)
            | Symptom::Unusable(_)
            | Symptom::Fault(_)
    ) {
        return Some(Expectation::default());
    }
    let is_kept = |expected: &&stickler_suite::ExpectedValue| {
        let key = expected.key().to_string();
        let mut values = values.iter();
        values.any(|(name, value)| name.eq_ignore_ascii_case(&key) && *value == expected.value)
    };
    let kept: Vec<_> = whole.values.iter().filter(is_kept).cloned().collect();
    let is_kept = !kept.is_empty();
    is_kept.then(|| Expectation {
        values: kept,
        ..Expectation::default()
    })
}
