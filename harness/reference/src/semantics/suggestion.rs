//! Messages about values that do not fit where they stand, and suggestions in messages: the conversion that would make a value fit, a name that was perhaps meant.

use super::contexts::ValueContext;
use super::inferred::Inferred;
use super::lowering::Lowering;
use super::model::Model;
use super::similarity::{Candidate, MAX_CHANGES, distance};
use super::standard_signatures::STANDARD_FUNCTIONS;
use super::types::{TypeId, TypeTable};
use crate::conversion::{self, conversion_function_name};
use crate::library;
use std::fmt::Display;
use std::sync::LazyLock;
use stickler_syntax::diagnostic::SpannedDiagnostic;
use stickler_syntax::tree::{Declaration, ExpressionId, Name, PouKind};
use stickler_types::{ElementaryType, joined};

/// The most names of the text that are compared with an unknown one.
const MAX_CANDIDATES: usize = 2000;

/// The most similar names that are looked at, each with its namespaces.
const MAX_NEAR: usize = 8;

/// The most letters of a name for which similar ones are looked for.
const MAX_NAME_LEN: usize = 40;

impl<'m> Lowering<'m> {
    /// Reports a value that does not fit where it stands, with the conversion call that would make it fit.
    ///
    /// Basis: harness/engines/README.md (the suggestion replaces the value and makes the program acceptable).
    pub(super) fn report_misfit(
        &mut self,
        id: ExpressionId,
        inferred: Inferred,
        target: TypeId,
        context: ValueContext,
    ) {
        let message = misfit(&self.model.types, inferred, target, context);
        self.report_misfit_as(id, inferred, target, context, message);
    }

    /// Reports a value that does not fit where it stands, with a message of its own, and the conversion call that would make it fit.
    pub(super) fn report_misfit_as(
        &mut self,
        id: ExpressionId,
        inferred: Inferred,
        target: TypeId,
        context: ValueContext,
        message: String,
    ) {
        let suggestion = match (inferred.elementary(), target.elementary()) {
            (Some(from), Some(to)) => self.conversion_call(id, from, to),
            _ => None,
        };
        let span = self.span(id);
        self.reporter.push(SpannedDiagnostic {
            suggestion,
            ..SpannedDiagnostic::new(context.code(), span, message)
        });
    }

    /// `INT_TO_DINT(x)` for `x`; nothing where the dialect has no such function, or where the text declares one
    /// of that name itself.
    fn conversion_call(&self, id: ExpressionId, from: ElementaryType, to: ElementaryType) -> Option<String> {
        let source = self.model.source;
        let name = conversion_function_name(from, to, source.dialect)?;
        let span = self.span(id);
        let hidden =
            self.variable(&name).is_some() || self.model.definition(Name { text: &name, span }).is_some();
        (!hidden).then(|| format!("{name}({})", source.text_of(id)))
    }

    /// Names an inferred type in a message.
    pub(super) fn describe(&self, inferred: Inferred) -> String {
        describe(&self.model.types, inferred)
    }

    /// Returns the end of a message about an undeclared function.
    pub(super) fn similar_function(&mut self, id: ExpressionId) -> String {
        let (text, span) = (self.model.source.text_of(id), self.span(id));
        match similar_function(self.model, text, &mut self.guesses) {
            none if none.is_empty() => {
                similar_declared(self.model, Name { text, span }, true, &mut self.guesses)
            }
            similar => similar,
        }
    }

    /// Returns the end of a message about an undeclared variable.
    pub(super) fn similar_variable(&mut self, name: &str) -> String {
        let local = self.entry().map(|entry| entry.scope.keys()).into_iter().flatten();
        let known = local
            .chain(self.model.globals.keys())
            .map(|name| Candidate::new(name.0));
        similar(name, known.take(MAX_CANDIDATES), |_| true, &mut self.guesses)
    }
}

/// Returns the end of a message about an undeclared function: standard functions, type conversion functions and
/// functions of the text whose names are near. `guesses` is how many more messages may look for some.
fn similar_function(model: &Model<'_>, name: &str, guesses: &mut u32) -> String {
    let dialect = model.source.dialect;
    if !dialect.rounding_functions
        && let Some(idiom) = rounding_idiom(name)
    {
        return idiom.to_owned();
    }
    let declared = model
        .pous
        .iter()
        .filter(|entry| entry.is_function())
        .map(|entry| Candidate::new(entry.pou.name.text))
        .take(MAX_CANDIDATES);
    let conversions = conversion::catalogue_names();
    let exists = |name: &str| {
        !conversions.iter().any(|known| known == name)
            || conversion::function(name, dialect).is_some()
            || conversion::concatenation(name, dialect).is_some()
    };
    similar(
        name,
        standard_of_about(name.len()).iter().copied().chain(declared),
        exists,
        guesses,
    )
}

/// Returns the end of a message about a type that is not declared, or a function where `is_function` says so: those of the text whose
/// names are near, with the namespaces that must stand before them.
pub(super) fn similar_declared(
    model: &Model<'_>,
    name: Name<'_>,
    is_function: bool,
    guesses: &mut u32,
) -> String {
    let last = name.text.rsplit('.').next().unwrap_or_default();
    if *guesses == 0 || !(3..=MAX_NAME_LEN).contains(&last.len()) {
        return String::new();
    }
    *guesses -= 1;
    let (wanted, allowed) = (Candidate::new(last), allowed_changes(last));
    let (mut path, mut near) = (Vec::new(), Vec::new());
    let mut compare = |path: &[&str], text: &str| {
        let is_near = Candidate::new(text).may_be_similar(wanted, allowed) && distance(last, text) <= allowed;
        if is_near && near.len() < MAX_NEAR {
            let is_known = path.is_empty() || model.definition(Name { text, ..name }).is_some();
            let meant = if is_known {
                text.to_owned()
            } else {
                format!("{}.{text}", path.join("."))
            };
            near.push((distance(last, text), meant));
        }
    };
    for declaration in &model.source.unit.declarations {
        match declaration {
            Declaration::Namespace(name) => path.push(name.text),
            Declaration::EndNamespace(_) => _ = path.pop(),
            Declaration::Pou(pou) if pou.kind == PouKind::Program => {}
            Declaration::Pou(pou) if (pou.kind == PouKind::Function) == is_function => {
                compare(&path, pou.name.text);
            }
            Declaration::Types(types) if !is_function => {
                types.iter().for_each(|ty| compare(&path, ty.name.text));
            }
            _ => {}
        }
    }
    near.retain(|(_, meant)| meant != name.text);
    did_you_mean(near)
}

/// Every standard function and type conversion function, the shortest names first.
pub(super) static STANDARD: LazyLock<Vec<Candidate<'static>>> = LazyLock::new(|| {
    let standard = STANDARD_FUNCTIONS.iter().map(|function| function.name);
    let standard = standard
        .filter(|name| !name.starts_with("STICKLER"))
        .chain(library::functions());
    let conversions = conversion::catalogue_names().iter().map(String::as_str);
    let mut all: Vec<_> = standard.chain(conversions).map(Candidate::new).collect();
    all.sort_by_key(|candidate| candidate.name.len());
    all
});

/// Returns the standard names that a few changes can make as long as this.
fn standard_of_about(length: usize) -> &'static [Candidate<'static>] {
    let first = STANDARD.partition_point(|candidate| candidate.name.len() + MAX_CHANGES < length);
    let end = STANDARD.partition_point(|candidate| candidate.name.len() <= length + MAX_CHANGES);
    &STANDARD[first..end]
}

/// `; did you mean …?` with the nearest of some names, if any is near; of near ones those that exist.
fn similar<'n>(
    name: &str,
    known: impl Iterator<Item = Candidate<'n>>,
    exists: impl Fn(&str) -> bool,
    guesses: &mut u32,
) -> String {
    if *guesses == 0 || !(3..=MAX_NAME_LEN).contains(&name.len()) {
        return String::new();
    }
    *guesses -= 1;
    let wanted = Candidate::new(name);
    let allowed = allowed_changes(name);
    let near = known
        .filter(|other| other.may_be_similar(wanted, allowed))
        .map(|other| (distance(name, other.name), other.name))
        .filter(|&(changes, other)| changes > 0 && changes <= allowed && exists(other));
    did_you_mean(near.collect())
}

/// Returns how many changes may make a name that was meant of one.
fn allowed_changes(name: &str) -> usize {
    if name.len() < 6 { 1 } else { MAX_CHANGES }
}

/// The end of a message with the names of fewest changes.
fn did_you_mean<N: Ord + Display>(mut near: Vec<(usize, N)>) -> String {
    near.sort_unstable();
    near.dedup();
    let nearest = near.first().map_or(0, |&(changes, _)| changes);
    let names: Vec<_> = near
        .iter()
        .take_while(|&&(changes, _)| changes == nearest)
        .map(|(_, name)| format!("`{name}`"))
        .take(3)
        .collect();
    match joined(&names, "or") {
        none if none.is_empty() => none,
        names => format!("; did you mean {names}?"),
    }
}

/// Returns the advice of the ForgeIEC page instead of a rounding function.
///
/// Basis: forgeiec-conversion-functions: TRUNC vs. ROUND.
fn rounding_idiom(name: &str) -> Option<&'static str> {
    match name.to_ascii_uppercase().as_str() {
        "ROUND" => Some("; the standard library has none: write REAL_TO_DINT(x + SEL(x < 0.0, 0.5, -0.5))"),
        "CEIL" | "CEILING" => Some("; the standard library has none: write TRUNC_DINT(x + 0.999999)"),
        "FLOOR" => Some(
            "; the standard library has none: write TRUNC_DINT(x), less 1 for a negative x with a fraction",
        ),
        _ => None,
    }
}

/// Names an inferred type in a message.
pub(super) fn describe(types: &TypeTable, inferred: Inferred) -> String {
    match inferred {
        Inferred::Known(ty) => types.name(ty),
        Inferred::Integer(_) => "an integer literal".to_owned(),
        Inferred::Real => "a real literal".to_owned(),
        Inferred::Text { wide: true, .. } => "a text literal in double quotes".to_owned(),
        Inferred::Text { .. } => "a text literal".to_owned(),
        Inferred::Nothing => "what has no value by itself".to_owned(),
        Inferred::Enumerated => "an enumerated value".to_owned(),
        Inferred::Pending | Inferred::Error => "an error".to_owned(),
    }
}

/// Says why a value does not fit where it stands.
pub(super) fn misfit(types: &TypeTable, inferred: Inferred, target: TypeId, context: ValueContext) -> String {
    let name = types.name(target);
    let value = describe(types, inferred);
    match (inferred, context) {
        (Inferred::Nothing, _) => "the call gives no value".to_owned(),
        (Inferred::Known(_), ValueContext::Condition) => format!("a condition is {name}, not {value}"),
        (Inferred::Known(_), _) => format!("{value} does not convert implicitly to {name}"),
        _ => format!("{value} is no {name} here"),
    }
}

/// Says why a value is no argument of a function that takes several types as they come. A long list would hide the point.
pub(super) fn misfit_of_any(types: &TypeTable, inferred: Inferred, allowed: &[ElementaryType]) -> String {
    let value = describe(types, inferred);
    let names: Vec<_> = allowed.iter().map(|ty| ty.name()).collect();
    match (inferred, names.len()) {
        (Inferred::Nothing, _) => "the call gives no value".to_owned(),
        (_, 2..=4) => format!("the function takes {}, not {value}", joined(&names, "or")),
        _ => format!("the function does not take {value}"),
    }
}
