//! Whether the source of an expectation binds an engine, so that a miss is a failure and not only a difference.

use stickler_engines::{Compiler, Identity, Reference};
use stickler_suite::{Acceptance, Case, Feature, SourceKind, Sources};
use stickler_types::DialectName;

/// Returns whether the source that a basis names binds an engine that runs a program in a dialect.
///
/// The reference is bound by every source, and every engine by a standard. A rule of Stickler binds others only where
/// `strict_rules` says so. Any other source binds the compilers that it names, and a recording the compiler that was recorded. An engine for which Stickler has no adapter is
/// bound by the sources that speak for the dialects it lists, since its author declared that it follows them; so is every engine
/// by what `stickler.toml` states about a dialect of its own.
#[must_use]
pub fn binds(
    (basis, dialect): (&str, DialectName),
    engine: &Identity,
    sources: &Sources,
    strict_rules: bool,
) -> bool {
    if engine.name == Reference::NAME {
        return true;
    }
    let Some((source, section)) = sources.of(basis) else {
        return true;
    };
    match source.kind {
        SourceKind::Standard => true,
        SourceKind::Rule => strict_rules,
        _ if Compiler::from_name(&engine.name).is_some() => source.speaks_of(section, &engine.name),
        _ => source.speaks_for(section, dialect),
    }
}

/// Returns whether a document promises an engine that it accepts the program of a case, so that it fails the case where it does not
/// implement a construct of the program.
///
/// Only a document promises: the standard asks of no compiler to have every construct, a measurement tells what a compiler does,
/// and rules are Stickler's own, that of cases which assert nothing among them. What `stickler.toml` states about a dialect of its
/// own counts as a document. Nothing is promised where the program must be rejected or its acceptance is open, and of a rendered
/// text no document promises that its program runs.
#[must_use]
pub fn promises(case: &Case, engine: &Identity, sources: &Sources) -> bool {
    let expectation = &*case.expectation;
    if expectation.accepted != Acceptance::Required || expectation.rendered.is_some() {
        return false;
    }
    let source = sources.of(&case.basis);
    source.is_none_or(|(source, _)| source.kind == SourceKind::Document)
        && binds((&case.basis, case.dialect), engine, sources, false)
}

/// Returns the first basis that promises a feature of the language and binds an engine in a dialect; `None` where nobody promises it.
#[must_use]
pub fn promise<'f>(
    feature: &'f Feature,
    dialect: DialectName,
    engine: &Identity,
    sources: &Sources,
) -> Option<&'f str> {
    let speaks = |basis: &&String| {
        let source = sources.of(basis);
        source.is_some_and(|(source, section)| source.speaks_for(section, dialect))
            && binds((basis, dialect), engine, sources, false)
    };
    feature.promised.iter().find(speaks).map(String::as_str)
}
