//! Whether the source of an expectation binds an engine, so that a miss is a failure and not only a difference.

use std::borrow::Cow;
use stickler_engines::{Compiler, Identity, Reference};
use stickler_suite::{Acceptance, Case, Feature, FeatureKey, Source, SourceKind, Suite};
use stickler_types::{Contradiction, DialectName, Relation, Versions};

/// A claim: that a program of a dialect does what a source states.
#[derive(Clone, Copy, Debug)]
pub struct Claim<'c> {
    /// The source and the section: `source: section`.
    pub basis: &'c str,
    /// The dialect in which the program is read.
    pub dialect: DialectName,
    /// The program.
    pub program: &'c str,
    /// The id of the case that makes the claim; empty where none does.
    pub case: &'c str,
}

/// The reason why a claim binds the compilers of its dialect, or does not.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Binding {
    /// A document, a recording or a measurement of the system itself, or what `stickler.toml` states about a dialect of its own.
    Own,
    /// The standard, of features that the system declares.
    Standard,
    /// The standard, but of a feature that the system does not declare.
    Undeclared(FeatureKey),
    /// A rule of `rules.md`, which is Stickler's own.
    Rule,
    /// A document, a recording or a measurement of another system.
    OtherSystem,
    /// A claim of which a source of the system itself says otherwise: its basis.
    Contradicted(String),
    /// A claim that holds for other versions of the compiler than this one, or whose compiler says no version.
    OtherVersion(Versions),
}

impl Binding {
    /// Returns whether a miss is a failure; a rule of Stickler's own binds only where `strict_rules` says so.
    pub const fn binds(&self, strict_rules: bool) -> bool {
        match self {
            Binding::Own | Binding::Standard => true,
            Binding::Rule => strict_rules,
            Binding::Undeclared(_)
            | Binding::OtherSystem
            | Binding::Contradicted(_)
            | Binding::OtherVersion(_) => false,
        }
    }
}

/// Returns why a claim binds an engine, or does not; without an engine, any compiler of the dialect.
///
/// The source is the one that binds most closely of those that the case file names: what the documents of the system or recordings of
/// it state, then the standard, which binds in the features that the system declares, then what other systems document, where a miss
/// is only a difference. A claim that a source of the system itself contradicts binds nobody, and one that begins or ends with a version only
/// compilers of the [versions] for which it holds. The reference is bound by all of them. An engine for which Stickler has no adapter is bound by the sources
/// [that are about](stickler_suite::Sources::are_about) the dialects that it lists, since its author declared that it follows them.
pub fn binding(claim: Claim<'_>, engine: Option<&Identity>, suite: &Suite) -> Binding {
    if engine.is_some_and(|engine| engine.name == Reference::NAME) {
        return Binding::Own;
    }
    let Some((source, section)) = suite.sources.of(claim.basis) else {
        return Binding::Own;
    };
    let begins_later =
        |source: &Source| compared(engine).is_some_and(|version| source.versions.begin_after(version));
    let is_lasting = |(source, other): &(&Source, &Contradiction)| {
        other.until.is_none() && !other.outweighed && !begins_later(source)
    };
    if let Some((other, contradiction)) = contradictions(claim, engine, suite).find(is_lasting) {
        return Binding::Contradicted(format!("{}: {}", other.key, contradiction.section));
    }
    let versions = versions(claim, engine, suite);
    if compared(engine).is_some_and(|version| !versions.include(version)) {
        return Binding::OtherVersion(versions);
    }
    match source.kind {
        SourceKind::Standard => match suite.features.undeclared(claim.program, claim.dialect) {
            Some(feature) => Binding::Undeclared(feature),
            None => Binding::Standard,
        },
        SourceKind::Rule => Binding::Rule,
        _ if is_own(source, section, claim.dialect, engine, suite) => Binding::Own,
        _ => Binding::OtherSystem,
    }
}

/// Returns the versions of an engine for which a claim holds; without an engine, of any compiler of the dialect. They are those of the source, as far
/// as no other source of the system ends the claim. A source of another system limits nothing.
pub fn versions(claim: Claim<'_>, engine: Option<&Identity>, suite: &Suite) -> Versions {
    let cited = suite.sources.of(claim.basis);
    let cited = cited.filter(|(source, section)| is_own(source, section, claim.dialect, engine, suite));
    let stated = cited.map_or_else(Versions::default, |(source, _)| source.versions.clone());
    let ends = contradictions(claim, engine, suite).filter_map(|(_, other)| other.until.as_deref());
    ends.fold(stated, Versions::ending_with)
}

/// Returns what the sources of an engine's system say against a claim, whatever version they are about.
fn contradictions<'s>(
    claim: Claim<'s>,
    engine: Option<&'s Identity>,
    suite: &'s Suite,
) -> impl Iterator<Item = (&'s Source, &'s Contradiction)> {
    let sources = suite.sources.iter();
    let all = sources.flat_map(|source| source.contradicts.iter().map(move |other| (source, other)));
    all.filter(move |(source, other)| {
        other.is_of(claim.basis, (claim.case, claim.program))
            && is_own(source, &other.section, claim.dialect, engine, suite)
    })
}

/// Returns the version of an engine, if the claims of its makers are compared with it. The numbers of an engine for which Stickler has no adapter are
/// its own, and say nothing of the compiler whose dialect it lists.
fn compared(engine: Option<&Identity>) -> Option<&str> {
    let known = engine.filter(|engine| Compiler::from_word(&engine.name).is_some())?;
    Some(&known.version)
}

/// Returns whether an engine is asked a case: it speaks the dialect, and the claim begins with no later version than the engine has.
pub fn is_asked(case: &Case, engine: &Identity, suite: &Suite) -> bool {
    let begins_later = |(source, section): (&Source, &str)| {
        compared(Some(engine)).is_some_and(|version| source.versions.begin_after(version))
            && is_own(source, section, case.dialect, Some(engine), suite)
    };
    engine.speaks(case.dialect)
        && (engine.name == Reference::NAME || !suite.sources.of(&case.basis).is_some_and(begins_later))
}

/// Returns whether a source speaks for an engine: by the engine's name where Stickler has an adapter of it, otherwise by the dialect.
fn is_own(
    source: &Source,
    section: &str,
    dialect: DialectName,
    engine: Option<&Identity>,
    suite: &Suite,
) -> bool {
    match engine.filter(|engine| Compiler::from_word(&engine.name).is_some()) {
        Some(compiler) => source.speaks_of(section, &compiler.name),
        None => suite.sources.are_about(source.dialects_of(section), dialect),
    }
}

/// Returns whether a document promises an engine that it accepts the program of a case, so that it fails the case where it does not
/// implement a construct of the program.
///
/// Only a document of the makers or of an integrator promises: a third party promises nothing for them, the standard asks of no compiler to have every construct, a measurement tells what a compiler does,
/// and rules are Stickler's own, that of cases which assert nothing among them. What `stickler.toml` states about a dialect of its
/// own counts as a document. Nothing is promised where the program must be rejected or its acceptance is open, and of a rendered
/// text no document promises that its program runs.
pub fn promises(case: &Case, engine: &Identity, suite: &Suite) -> bool {
    let expectation = &*case.expectation;
    if expectation.accepted != Acceptance::Required || expectation.rendered.is_some() {
        return false;
    }
    let source = suite.sources.of(&case.basis);
    let promises =
        |source: &Source| source.kind == SourceKind::Document && source.relation != Relation::ThirdParty;
    source.is_none_or(|(source, _)| promises(source))
        && binding(Claim::of(case), Some(engine), suite) == Binding::Own
}

impl<'c> Claim<'c> {
    /// Returns the claim of a case.
    pub fn of(case: &'c Case) -> Claim<'c> {
        Claim {
            basis: &case.basis,
            dialect: case.dialect,
            program: &case.source,
            case: &case.id,
        }
    }
}

/// Returns the first of the bases that promise a feature of the language, or a place, which binds an engine in a program of a dialect; `None`
/// where there is none.
pub fn promise<'f>(
    promised: impl IntoIterator<Item = &'f str>,
    (program, dialect): (&str, DialectName),
    engine: &Identity,
    suite: &Suite,
) -> Option<&'f str> {
    let speaks = |basis: &&str| {
        let source = suite.sources.of(basis);
        let claim = Claim {
            basis,
            dialect,
            program,
            case: "",
        };
        source.is_some_and(|(source, section)| source.speaks_for(section, dialect))
            && binding(claim, Some(engine), suite).binds(false)
    };
    promised.into_iter().find(speaks)
}

/// Returns the basis by which an engine must take a feature of the language in a program of a dialect: the first one that promises it, or
/// else the table of the standard by which the dialect declares it; `None` where there is none.
pub fn promise_of<'f>(
    feature: &'f Feature,
    (program, dialect): (&str, DialectName),
    engine: &Identity,
    suite: &Suite,
) -> Option<Cow<'f, str>> {
    let promised = promise(feature.promises(), (program, dialect), engine, suite).map(Cow::from);
    promised.or_else(|| declared_by(feature, dialect, engine, suite).map(Cow::from))
}

/// Returns the table of the standard by which a dialect declares a feature; `None` where it does not, or no table of the third edition,
/// which is the one that is cited, is about the feature.
fn declared_by(feature: &Feature, dialect: DialectName, engine: &Identity, suite: &Suite) -> Option<String> {
    let row = feature.tables.get(&3)?;
    let table = row.split(',').next().unwrap_or(row);
    let basis = format!("iec-61131-3: {table}");
    let claim = Claim {
        basis: &basis,
        dialect,
        program: &feature.program,
        case: "",
    };
    (binding(claim, Some(engine), suite) == Binding::Standard).then_some(basis)
}
