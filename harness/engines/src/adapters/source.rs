//! Finds the main program, a configuration and the values of an enumeration in a text by its words and signs.
//!
//! No grammar takes part, so that the main program is also found in a text that only one compiler accepts.

use std::collections::BTreeSet;
use std::ops::Range;
use stickler_syntax::token::TokenKind;
use stickler_syntax::tree::Name;
use stickler_syntax::{tokens, words};
use stickler_types::{Dialect, RunRequest};

/// Returns the words of the program of a request, in order.
pub(super) fn words_of<'s>(request: &RunRequest<'s>) -> impl Iterator<Item = Name<'s>> {
    words(request.source, Dialect::of(request.dialect))
}

/// Returns the numbers of the scans after which a request observes a value, and of the last.
pub(super) fn observed_scans(request: &RunRequest<'_>) -> BTreeSet<u32> {
    let asked = request.observe.iter().filter_map(|asked| asked.after);
    asked.chain([request.scans]).collect()
}

/// The place of the main program in a source text: the program that is called `main`, otherwise the first.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct MainProgram {
    /// The name of the program, as it is declared.
    pub(super) name: String,
    /// The range from behind its name, where sections of variables may stand, to before its `END_PROGRAM`.
    pub(super) inside: Range<usize>,
    /// The offset behind its last section of variables.
    pub(super) body: usize,
    /// Whether the program may end before its last statement.
    pub(super) returns: bool,
}

/// Finds the main program of a request; `None` where there is none.
pub(super) fn main_program(request: &RunRequest<'_>) -> Option<MainProgram> {
    let mut words = words_of(request);
    let mut first = None;
    while let Some(word) = words.next() {
        if word.is("CONFIGURATION") {
            // A program within it is an instance, and no declaration.
            words.find(|word| word.is("END_CONFIGURATION"));
        }
        if !word.is("PROGRAM") {
            continue;
        }
        let Some(program) = program(&mut words) else {
            continue;
        };
        if program.name.eq_ignore_ascii_case("main") {
            return Some(program);
        }
        first = first.or(Some(program));
    }
    first
}

/// Reads the rest of a program after its first word.
fn program<'s>(words: &mut impl Iterator<Item = Name<'s>>) -> Option<MainProgram> {
    let name = words.next()?;
    let mut returns = false;
    let mut body = name.span.end;
    let end = words.find(|word| {
        returns |= word.is("RETURN");
        if word.is("END_VAR") {
            body = word.span.end;
        }
        word.is("END_PROGRAM")
    })?;
    Some(MainProgram {
        name: name.text.to_owned(),
        inside: name.span.end as usize..end.span.start as usize,
        body: body as usize,
        returns,
    })
}

/// The place of a program in the configuration that a source text brings; the names are as they are declared.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct OwnConfiguration {
    /// The name of the configuration.
    pub(super) name: String,
    /// The name of the resource in which the program is.
    pub(super) resource: String,
    /// The name of the instance of the program.
    pub(super) instance: String,
}

/// Finds the configuration in which a program has an instance; `None` where there is none.
pub(super) fn own_configuration(request: &RunRequest<'_>, program: &str) -> Option<OwnConfiguration> {
    let mut words = words_of(request)
        .skip_while(|word| !word.is("CONFIGURATION"))
        .skip(1);
    let name = words.next()?.text.to_owned();
    let mut resource = None;
    while let Some(word) = words.next() {
        if word.is("RESOURCE") {
            resource = Some(words.next()?.text.to_owned());
        } else if word.is("PROGRAM") {
            let mut instance = words.next()?;
            if instance.is("RETAIN") || instance.is("NON_RETAIN") {
                instance = words.next()?;
            }
            let mut ty = words.next()?;
            if ty.is("WITH") {
                // The task stands between.
                ty = words.nth(1)?;
            }
            if ty.is(program) {
                let (resource, instance) = (resource?, instance.text.to_owned());
                return Some(OwnConfiguration {
                    name,
                    resource,
                    instance,
                });
            }
        }
    }
    None
}

/// Returns the names of the values of an enumeration that is declared as `NAME : (A, B, C)`, in order; `None` where it is not
/// declared so. Explicit numbers of the values are not supported.
pub(super) fn enumeration(request: &RunRequest<'_>, name: &str) -> Option<Vec<String>> {
    let tokens = tokens(request.source, Dialect::of(request.dialect)).list;
    let behind = |at: usize| tokens.get(at + 1..).unwrap_or_default();
    let named = (0..tokens.len()).filter(|&at| tokens[at].is(name, request.source));
    named.map(behind).find_map(|behind| {
        let kinds = [behind.first()?.kind, behind.get(1)?.kind];
        let list = behind
            .get(2..)?
            .split(|token| token.kind == TokenKind::RightParen)
            .next()?;
        let values = list.iter().step_by(2);
        let is_list = kinds == [TokenKind::Colon, TokenKind::LeftParen]
            && list.len() + 2 < behind.len()
            && list
                .iter()
                .skip(1)
                .step_by(2)
                .all(|token| token.kind == TokenKind::Comma)
            && values.clone().all(|token| token.kind == TokenKind::Name);
        is_list.then(|| {
            values
                .map(|token| token.span.text(request.source).to_owned())
                .collect()
        })
    })
}
