//! What a message suggests: the conversion that would make a value fit, a name that was perhaps meant.

use super::contexts::Context;
use super::inferred::Inferred;
use super::lowering::Lowering;
use super::types::TypeId;
use crate::conversion::conversion_function_name;
use crate::diagnostic::Diagnostic;
use crate::syntax::tree::ExpressionId;
use stickler_types::ElementaryType;

/// No more names than this are compared with one that is not known.
const CANDIDATES: usize = 2000;

impl<'m> Lowering<'m> {
    /// Reports a value that does not fit where it stands, with the conversion call that would make it fit.
    ///
    /// Basis: stickler-design: §7 (the suggestion replaces the value and makes the program acceptable).
    pub(super) fn report_misfit(
        &mut self,
        id: ExpressionId,
        inferred: Inferred,
        target: TypeId,
        context: Context,
    ) {
        let name = self.model.types.name(target);
        let value = self.describe(inferred);
        let message = match (inferred, context) {
            (Inferred::Nothing, _) => "the call gives no value".to_owned(),
            (Inferred::Known(_), Context::Condition) => format!("a condition is {name}, not {value}"),
            (Inferred::Known(_), _) => format!("{value} does not convert implicitly to {name}"),
            _ => format!("{value} is no {name} here"),
        };
        let suggestion = match (inferred.elementary(), target.elementary()) {
            (Some(from), Some(to)) if context != Context::Label => self.conversion_call(id, from, to),
            _ => None,
        };
        let span = self.span(id);
        self.reporter.push(Diagnostic {
            suggestion,
            ..Diagnostic::new(context.code(), span, message)
        });
    }

    /// `INT_TO_DINT(x)` for `x`; nothing where the dialect has no such function, or where the text declares one
    /// of that name itself.
    fn conversion_call(&self, id: ExpressionId, from: ElementaryType, to: ElementaryType) -> Option<String> {
        let source = self.model.source;
        let name = conversion_function_name(from, to, source.dialect)?;
        let hidden = self.variable(&name).is_some()
            || self.model.definitions.contains_key(&super::scope::Folded(&name));
        (!hidden).then(|| format!("{name}({})", source.text_of(id)))
    }

    /// The end of a message about a function that nobody declared.
    pub(super) fn similar_function(&mut self, name: &str) -> String {
        if self.model.source.dialect.only_standard_rounding
            && let Some(idiom) = rounding_idiom(name)
        {
            return idiom.to_owned();
        }
        let model = self.model;
        let declared = model
            .pous
            .iter()
            .filter(|entry| entry.is_function())
            .map(|entry| entry.pou.name.text);
        let standard = super::standard::NAMES.iter().map(|(name, _)| *name);
        self.similar(name, standard.chain(declared))
    }

    /// The end of a message about a variable that nobody declared.
    pub(super) fn similar_variable(&mut self, name: &str) -> String {
        let local = self.entry().map(|entry| entry.scope.keys()).into_iter().flatten();
        let model = self.model;
        self.similar(name, local.chain(model.globals.keys()).map(|name| name.0))
    }

    fn similar(&mut self, name: &str, candidates: impl Iterator<Item = &'m str>) -> String {
        const LONGEST: usize = 40;
        if self.guesses == 0 || !(3..=LONGEST).contains(&name.len()) {
            return String::new();
        }
        self.guesses -= 1;
        let lower = name.to_ascii_lowercase();
        let allowed = if name.len() < 6 { 1 } else { 2 };
        let near = candidates
            .take(CANDIDATES)
            .filter(|other| other.len().abs_diff(name.len()) <= allowed)
            .map(|other| (distance(&lower, &other.to_ascii_lowercase()), other))
            .min();
        match near {
            Some((changes, other)) if changes <= allowed => format!("; did you mean `{other}`?"),
            _ => String::new(),
        }
    }
}

/// What the ForgeIEC page says instead of a rounding function.
///
/// Basis: forgeiec-conversion-functions: TRUNC vs. ROUND.
fn rounding_idiom(name: &str) -> Option<&'static str> {
    match name.to_ascii_uppercase().as_str() {
        "ROUND" => Some("; there is none in the standard library: REAL_TO_DINT(x + SEL(x < 0.0, 0.5, -0.5))"),
        "CEIL" | "CEILING" => Some("; there is none in the standard library: TRUNC_DINT(x + 0.999999)"),
        "FLOOR" => Some(
            "; there is none in the standard library: TRUNC_DINT(x), less 1 for a negative x with a fraction",
        ),
        _ => None,
    }
}

/// How many characters must be changed, added or left out to make one name of another.
fn distance(left: &str, right: &str) -> usize {
    let right = right.as_bytes();
    let mut row: Vec<usize> = (0..=right.len()).collect();
    for (line, byte) in left.bytes().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], line + 1);
        for (column, other) in right.iter().enumerate() {
            let replaced = diagonal + usize::from(byte != *other);
            diagonal = row[column + 1];
            row[column + 1] = replaced.min(diagonal + 1).min(row[column] + 1);
        }
    }
    row[right.len()]
}

#[cfg(test)]
mod tests {
    use super::distance;

    #[test]
    fn distance_counts_changes() {
        assert_eq!(distance("limit", "limit"), 0);
        assert_eq!(distance("limt", "limit"), 1);
        assert_eq!(distance("sle", "sel"), 2);
        assert_eq!(distance("", "abs"), 3);
    }
}
