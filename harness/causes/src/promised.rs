//! Who promises a construct that an engine does not take: the basis of a cause whose program is plainer than what the claim of its
//! case speaks of. Which documents promise which feature of the language stands in `features.toml`.

use crate::assignments::{computation, declaration};
use crate::features::{is_unread, passes_in_out};
use crate::literals::valued_types;
use crate::names::DeclaredNames;
use crate::question::wrong_values;
use crate::reduction::Smallest;
use crate::title::unimplemented;
use crate::tokens::tokens;
use stickler_engines::Identity;
use stickler_run::{Fact, Symptom, binds};
use stickler_suite::{Case, Feature, Features, SourceKind, Sources, Suite};
use stickler_syntax::features::{FeatureUse, feature_uses};
use stickler_syntax::source::Span;
use stickler_types::Dialect;

/// Returns the basis by which an engine must take the program of a cause: the first one that promises its most specific feature and
/// binds the engine. `None` where the program does something beside that nobody promises.
pub(crate) fn promise<'s>(
    shown: &Smallest,
    case: &Case,
    (engine, suite): (&Identity, &'s Suite),
) -> Option<&'s str> {
    let Suite {
        features, sources, ..
    } = suite;
    let is_of_mistake = shown
        .deviation
        .expected
        .iter()
        .any(|fact| fact.diagnostic().is_some());
    let is_refused = matches!(
        shown.deviation.sign.symptom,
        Symptom::Rejected(_) | Symptom::NotImplemented(_) | Symptom::Value
    );
    let line = suspects(shown).filter(|_| is_refused && !is_of_mistake)?;
    let feature = specific(shown, line, Dialect::of(case.dialect), features)?;
    let speaks = |basis: &&String| {
        let source = sources.of(basis);
        source.is_some_and(|(source, section)| source.speaks_for(section, case.dialect))
            && binds((basis, case.dialect), engine, sources, false)
    };
    feature.promised.iter().find(speaks).map(String::as_str)
}

/// Returns the place of the line whose constructs the engine does not take; `None` where no line is known.
fn suspects(shown: &Smallest) -> Option<Span> {
    let (program, got) = (shown.program.as_str(), &shown.deviation.got[..]);
    let line = match &shown.deviation.sign.symptom {
        Symptom::NotImplemented(_) => unimplemented(program, got),
        Symptom::Value => {
            let (name, _) = wrong_values(&shown.deviation.expected, got).next()?;
            computation(program, name).unwrap_or_else(|| declaration(program, name))
        }
        _ => {
            let reported = got.iter().find_map(|fact| fact.diagnostic()?.line)?;
            program.lines().nth(reported.checked_sub(1)? as usize)?
        }
    };
    let start = line.as_ptr() as usize - program.as_ptr() as usize;
    Some(Span {
        start: start as u32,
        end: (start + line.len()) as u32,
    })
}

/// Returns the most specific feature that a line uses, or else the innermost that surrounds it: the one that needs most others, and of
/// those the last of the list. `None` where the line has another feature too that nobody promises, or the program more types of
/// values than the feature's own, so that a conversion may be what is wrong.
fn specific<'f>(
    shown: &Smallest,
    line: Span,
    dialect: &Dialect,
    features: &'f Features,
) -> Option<&'f Feature> {
    let program = shown.program.as_str();
    let uses = feature_uses(program, dialect);
    let known = |used: &FeatureUse| features.get(&used.key);
    let begins = |used: &&FeatureUse| (line.start..line.end).contains(&used.span.start);
    let of_line = uses.iter().filter(begins).filter_map(known);
    let all = tokens(program);
    let names = DeclaredNames::new(&all);
    let words = tokens(line.text(program));
    let in_out = features
        .get("var-in-out")
        .filter(|_| passes_in_out(&words, &names));
    let mut found: Vec<&Feature> = of_line.chain(in_out).collect();
    // What an initial value is made of is told by the innermost.
    let needed: Vec<&String> = found.iter().flat_map(|one| &one.needs).collect();
    found.retain(|one| !needed.contains(&&one.key) && (!one.promised.is_empty() || !is_type(one)));
    if found.is_empty() {
        let surrounds = |used: &&FeatureUse| used.span.start <= line.start && line.end <= used.span.end;
        let around = uses.iter().rfind(surrounds).and_then(known);
        // Where nothing is done with the variables of a line, their type is at fault.
        let declared_type = || {
            let ty = words.iter().find_map(|token| names.type_of_operand(token))?;
            features.get(&ty.name().to_ascii_lowercase())
        };
        found.extend(around.or_else(declared_type));
    }
    let place = |feature: &Feature| features.iter().position(|one| one.key == feature.key);
    let is_promised = found.iter().all(|feature| !feature.promised.is_empty());
    let most = found
        .into_iter()
        .max_by_key(|feature| (feature.needs.len(), place(feature)))?;
    let number = |program: &str| valued_types(&tokens(program)).len().max(1);
    let has_its_types = number(program) <= number(&most.program);
    (is_promised && (has_its_types || is_unread(&shown.deviation.got))).then_some(most)
}

/// Returns whether a feature is an elementary type.
fn is_type(feature: &Feature) -> bool {
    stickler_types::ElementaryType::from_name(&feature.key.to_ascii_uppercase()).is_some()
}

/// Writes who promises a construct into what the engine said of it, where that is a document.
pub(crate) fn cite(got: &mut [Fact], basis: &str, sources: &Sources) {
    let is_document = sources
        .of(basis)
        .is_some_and(|(source, _)| source.kind == SourceKind::Document);
    for fact in got {
        if let Fact::NotImplemented { promised_by, .. } = fact {
            *promised_by = is_document.then(|| basis.to_owned());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::DialectName;

    /// Returns the feature that is blamed where an engine rejects the third line of a program.
    fn of(declaration: &str, code: &str) -> Option<&'static str> {
        let program = format!("PROGRAM p\nVAR\n{declaration}\nEND_VAR\nx := x;\nEND_PROGRAM\n");
        let shown = Smallest::rejected(&program, 3, code);
        let dialect = Dialect::of(DialectName::IRONPLC_ED3);
        let found = specific(&shown, suspects(&shown)?, dialect, Features::built_in());
        found.map(|feature| feature.key.as_str())
    }

    #[test]
    fn the_most_specific_feature_of_a_line_is_what_is_promised() {
        for (line, feature) in [
            ("x : STRING[1];", "string-length"),
            ("x : ARRAY[0..0] OF INT := [1(0)];", "array-repetition"),
            ("x : OWN := [INT#1];", "array-initial-value"),
            ("x : OWN := (f := 0);", "structure-initial-value"),
            ("x : BOOL := BOOL#TRUE;", "typed-literal-boolean"),
            ("x : CHAR := CHAR#'a';", "typed-literal-string"),
            ("x : INT := INT#-5;", "typed-literal-sign"),
            ("x : LTIME := LT#0s;", "long-duration-literal"),
            ("x AT %MW10 : INT;", "located-variable"),
            ("x : LTOD;", "ltod"),
            ("END_VAR VAR_IN_OUT x : INT; END_VAR VAR y : INT;", "var-in-out"),
            ("END_VAR CONTINUE;", "continue"),
            ("END_VAR x := LEN(y);", "len"),
            ("END_VAR x := min(y, y);", "min"),
            ("END_VAR { } x := x;", "pragma"),
        ] {
            assert_eq!(of(line, "P4035"), Some(feature), "{line}");
        }
    }

    #[test]
    fn nobody_promises_what_stands_beside_something_else() {
        for line in [
            "x : INT;",
            "END_VAR x := MIN(LEN(y) + 1, y);",
            "END_VAR x := MIN(INT#0, REAL#0.0);",
            "END_VAR x := INT_TO_REAL(INT#-5);",
        ] {
            assert_eq!(of(line, "P4035"), None, "{line}");
        }
    }
}
