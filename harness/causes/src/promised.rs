//! Who promises a construct that an engine does not take: the basis of a cause whose program is plainer than what the claim of its
//! case speaks of. Which documents promise which feature of the language stands in `features.toml`.

use crate::essence::{BEYOND_TYPE, Essence};
use crate::failure_sign::{is_of_reading, is_unread};
use crate::line_features::passes_in_out;
use crate::lines::{LinePlace, place_of};
use crate::loop_limits::TO_LAST_VALUE;
use crate::patterns::UNREAD_ESCAPES;
use crate::program::{Program, ReadProgram};
use crate::question::wrong_values;
use crate::reduction::Smallest;
use crate::suspect::{culprit, stopping, unimplemented};
use crate::words::{valued_types, words};
use std::borrow::Cow;
use std::collections::BTreeSet;
use stickler_engines::Identity;
use stickler_run::{Fact, Symptom, promise_of};
use stickler_suite::{Case, Feature, Features, Role, SourceKind, Sources, Suite};
use stickler_syntax::features::{FeatureUse, feature_uses};
use stickler_types::{Code, Dialect};

/// Returns the basis by which an engine must take the program of a cause: the first one that promises its most specific feature and
/// binds the engine. `None` where the program does something else that nobody promises.
pub(crate) fn promise<'s>(
    shown: &Smallest,
    case: &Case,
    (engine, suite): (&Identity, &'s Suite),
) -> Option<Cow<'s, str>> {
    let Suite { features, .. } = suite;
    let mut expected = shown.deviation.expected.iter();
    let is_of_mistake = expected.any(|fact| fact.diagnostic().is_some());
    let is_refused = matches!(
        shown.deviation.sign.symptom,
        Symptom::Rejected(_)
            | Symptom::NotImplemented(_)
            | Symptom::Unusable(_)
            | Symptom::Fault(_)
            | Symptom::Value
            | Symptom::Missing
    );
    let program = Program::new(&shown.program);
    let program = program.read();
    let line = line_at_fault(&program, shown).filter(|_| is_refused && !is_of_mistake)?;
    // What cannot be read may be the blank before a sign.
    let is_behind = |text: &str, at: usize| text[..at].ends_with(|sign: char| !"=,(".contains(sign));
    let has_blank = |text: &str| {
        let found = [" ;", " [", " ^", " )"].map(|pair| text.find(pair));
        found.into_iter().flatten().any(|at| is_behind(text, at))
    };
    if is_unread(&shown.deviation.got) && program.line_text(line).is_some_and(has_blank) {
        return None;
    }
    let feature = specific(
        &program,
        (line, &shown.deviation.got),
        Dialect::of(case.dialect),
        features,
    )?;
    let program = (shown.program.as_str(), case.dialect);
    match shown.deviation.sign.symptom {
        // The standard asks of no compiler to have every construct.
        Symptom::NotImplemented(_) => {
            stickler_run::promise(feature.promises(), program, engine, suite).map(Cow::from)
        }
        _ => promise_of(feature, program, engine, suite),
    }
}

/// The features of which a wrong value, or the size of a literal that is rejected, tells by its pattern, whatever the case was about. Table 10 has
/// the range of each type; the types here are those that hold such numbers.
pub(crate) const OF_PATTERNS: [(&str, &[&str]); 11] = [
    (
        "conversion",
        &[
            "conversion to an integer that does not bring it into its range",
            "conversion of a real number outside the range of its target",
            "negative real number into an integer without a sign",
            "conversion to a date or a time of day that gives none",
        ],
    ),
    (
        "typed-literal",
        &[BEYOND_TYPE, "REAL literal with the bits of an LREAL"],
    ),
    ("real", &["REAL literal that is rounded twice"]),
    (
        "lreal",
        &[
            "LREAL literal with the digits of a REAL",
            "integer of more than 64 bits",
        ],
    ),
    ("lint", &["integer of more than 31 bits"]),
    ("ulint", &["integer of more than 63 bits"]),
    ("for", &["FOR loop to its first value", TO_LAST_VALUE]),
    ("type-initial-value", &["initial value of a type"]),
    ("field-initial-value", &["initial value of a field"]),
    (
        "initial-value",
        &[
            "initial value, which is right where it is assigned",
            "initial value in a FUNCTION_BLOCK",
        ],
    ),
    ("string-escape", &[UNREAD_ESCAPES]),
];

/// Returns the basis by which an engine must compute the value of a program, by the construct of which the pattern of the wrong value tells,
/// or know the variables of the section that alone is at fault; `None` where there is none, or nobody whose word binds the engine
/// promises it.
pub(crate) fn promise_of_pattern<'s>(
    constructs: &BTreeSet<String>,
    (program, case): (&str, &Case),
    (engine, suite): (&Identity, &'s Suite),
) -> Option<Cow<'s, str>> {
    let mut patterns = OF_PATTERNS.iter();
    let of_pattern = patterns.find(|(_, patterns)| patterns.iter().any(|one| constructs.contains(*one)));
    let of_section = || {
        let alone = constructs.first().filter(|_| constructs.len() == 1)?;
        let section = alone.strip_prefix("VAR_")?;
        Some(format!("var-{}", section.to_ascii_lowercase().replace('_', "-")))
    };
    let key = of_pattern.map(|(key, _)| (*key).to_owned()).or_else(of_section)?;
    let feature = suite.features.get(&key)?;
    promise_of(feature, (program, case.dialect), engine, suite)
}

/// Returns the page about the code of a mistake that is accepted; `None` where this version of the engine does not have the code, or where the
/// page speaks of other mistakes: of a text that cannot be read it says nothing of what must be read, and of variables and assignments
/// nothing of the fields of an initial value and of loops.
pub(crate) fn page_of_code(
    shown: &Smallest,
    essence: &Essence,
    (engine, sources): (&Identity, &Sources),
) -> Option<String> {
    let Symptom::NotRejected(code) = &shown.deviation.sign.symptom else {
        return None;
    };
    let line = shown
        .deviation
        .expected
        .iter()
        .find_map(|fact| fact.diagnostic()?.line)?;
    let program = Program::new(&shown.program);
    let is_elsewhere = match code.parse().ok()? {
        Code::AssignmentTypeMismatch => essence.constructs.contains("condition"),
        Code::VariableUndefined => matches!(place_of(&program.read(), line), LinePlace::Section(_)),
        own => engine.lacks.contains(&own),
    };
    let page = || sources.of_code(code, &engine.name);
    (!is_elsewhere && !is_of_reading(code)).then(page).flatten()
}

/// Returns the basis by which an engine must take a value in the one place that all cases of a cause have in common. `None` where they share
/// no place or several, or where nobody promises it. The first place of each role is that of a plain variable, by which no cause is told.
pub(crate) fn promise_of_place<'s>(
    shared: &BTreeSet<String>,
    (program, case): (&str, &Case),
    (engine, suite): (&Identity, &'s Suite),
) -> Option<&'s str> {
    let placement = case.placement.as_ref()?;
    let roles = [
        (Role::Source, &placement.source),
        (Role::Target, &placement.target),
        (Role::Surrounding, &placement.surrounding),
    ];
    let places = roles.into_iter().filter_map(|(role, name)| {
        let mut special = suite.places.of(role).iter().skip(1);
        special.find(|place| place.name() == &**name && shared.contains(place.name()))
    });
    let [place] = places.collect::<Vec<_>>()[..] else {
        return None;
    };
    stickler_run::promise(place.promises(), (program, case.dialect), engine, suite)
}

/// Returns the number of the line whose constructs the engine does not take; `None` where no line is known.
fn line_at_fault(program: &ReadProgram<'_, '_>, shown: &Smallest) -> Option<u32> {
    let got = &shown.deviation.got[..];
    match &shown.deviation.sign.symptom {
        Symptom::NotImplemented(_) => Some(unimplemented(program, got)),
        Symptom::Value => {
            let (name, _) = wrong_values(&shown.deviation.expected, got).next()?;
            let computed = program.computation(name);
            Some(computed.unwrap_or_else(|| program.declaration(name)))
        }
        Symptom::Fault(_) => Some(stopping(program)),
        _ => {
            let named = got.iter().find_map(|fact| fact.diagnostic()?.line);
            Some(named.unwrap_or_else(|| culprit(program)))
        }
    }
}

/// Returns the most specific feature that a line uses, or else the innermost that surrounds it: the one that needs most others, and of
/// those the last of the list. `None` where the line has another feature too that nobody promises, or the program more types of
/// values than the feature's own, so that a conversion may be what is wrong.
pub(crate) fn specific<'f>(
    program: &ReadProgram<'_, '_>,
    (line, got): (u32, &[Fact]),
    dialect: &Dialect,
    features: &'f Features,
) -> Option<&'f Feature> {
    let text = program.text;
    let of_line = program.line_text(line)?;
    let number = |byte: u32| program.lines.line(byte);
    let uses = feature_uses(text, dialect);
    let known = |used: &FeatureUse| features.get(&used.key);
    let used_there = uses
        .iter()
        .filter(|used| number(used.span.start) == line)
        .filter_map(known);
    let passes = passes_in_out(program, |span| number(span.start) == line);
    let in_out = features.get("var-in-out").filter(|_| passes);
    let mut found: Vec<&Feature> = used_there.chain(in_out).collect();
    // Of nested initial values, only the innermost feature counts.
    let needed: Vec<&String> = found.iter().flat_map(|one| &one.needs).collect();
    found.retain(|one| !needed.contains(&&one.key) && (!one.promised.is_empty() || !is_type(one)));
    // What is done with a value counts before its type and its literals do, but for beginning with it.
    let is_value = |one: &Feature| is_type(one) || one.key.ends_with("-literal");
    if found
        .iter()
        .any(|one| !is_value(one) && one.key != "initial-value")
    {
        found.retain(|one| !is_value(one));
    }
    if found.is_empty() {
        let around = |line: u32| {
            let surrounds =
                |used: &&FeatureUse| number(used.span.start) < line && line < number(used.span.end);
            uses.iter().rfind(surrounds).and_then(known)
        };
        // What a section does to its variables is at fault before their types are.
        let of_section = || {
            let mut names = words(of_line).into_iter();
            names.find_map(|name| around(program.line(program.named(name, None)?.name.span)))
        };
        // Where nothing is done with the variables of a line, their type is at fault.
        let declared_type = || {
            let ty = words(of_line)
                .into_iter()
                .find_map(|word| program.type_of_word(word))?;
            features.get(&ty.name().to_ascii_lowercase())
        };
        found.extend(around(line).or_else(of_section).or_else(declared_type));
    }
    let place = |feature: &Feature| features.iter().position(|one| one.key == feature.key);
    // What a conversion promises is its result, not that what it is given is known.
    let converts = found.iter().any(|feature| feature.key == "conversion");
    let promises = |feature: &&Feature| !feature.promised.is_empty();
    let is_alone = found.len() == 1 && found[0].tables.contains_key(&3);
    let is_promised = !converts && (is_alone || found.iter().all(promises));
    let most = found
        .into_iter()
        .max_by_key(|feature| (feature.needs.len(), place(feature)))?;
    let types = |text: &str| valued_types(text).len().max(1);
    (is_promised && (types(text) <= types(&most.program) || is_unread(got))).then_some(most)
}

/// Returns whether a feature is an elementary type.
fn is_type(feature: &Feature) -> bool {
    stickler_types::ElementaryType::from_name(&feature.key.to_ascii_uppercase()).is_some()
}

/// Names the basis in every fact that something is not implemented, if the basis is a document.
pub(crate) fn cite(got: &mut [Fact], basis: &str, sources: &Sources) {
    // What the source limits is told below the claim, and is no promise without it.
    let is_document = sources.of(basis).is_some_and(|(source, section)| {
        source.kind == SourceKind::Document && !source.limitations.contains_key(section)
    });
    for fact in got {
        if let Fact::NotImplemented { promised_by, .. } = fact {
            *promised_by = is_document.then(|| basis.to_owned());
        }
    }
}
