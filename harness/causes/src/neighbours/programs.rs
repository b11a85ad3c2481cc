//! The neighbours of a shown program: what differs from it in one respect.

use super::{BEHIND, OTHER_NAME, UNDECLARED, neighbour};
use crate::forms::{end_of_variables, named_types, with_types};
use crate::malformed::number_of_literal;
use crate::program::ReadProgram;
use crate::words::{elementary, tokens};
use std::collections::BTreeSet;
use stickler_run::Neighbour;
use stickler_syntax::Edits;
use stickler_syntax::source::Span;
use stickler_syntax::token::Token;
use stickler_syntax::tree::{Declaration, PouKind};
use stickler_types::ElementaryType;

/// The maximum number of types of the same family that are tried in the place of one.
const MAX_ALIKE: usize = 3;

/// The types of which those of other families are tried.
const OTHERS: [ElementaryType; 6] = {
    use ElementaryType::{Bool, Int, Real, String, Time, Word};
    [Bool, Int, Word, Real, Time, String]
};

/// A program beside a function block.
const CALLER: &str = "\nPROGRAM caller\nVAR\n    n : INT;\nEND_VAR\n    n := 0;\nEND_PROGRAM\n";

/// The maximum number of names in whose place others are tried.
const MAX_NAMES: usize = 6;

/// The numbers of bits at whose limits a compiler may do otherwise.
const BITS: [u32; 8] = [7, 8, 15, 16, 31, 32, 63, 64];

/// Returns a program with other types in the place of each of its types, of which the program names none; with `only_alike` those of the same
/// family alone, since a value of another is computed otherwise; and `with_undeclared` with a type that nothing declares.
pub(super) fn with_other_types(
    program: &ReadProgram<'_, '_>,
    (only_alike, with_undeclared): (bool, bool),
) -> Vec<(Neighbour, String)> {
    let there = named_types(program.text);
    let mut found = Vec::new();
    for ty in there.iter().filter_map(|name| elementary(name)) {
        let alike = ElementaryType::ALL
            .into_iter()
            .filter(|other| other.family() == ty.family());
        let alike = alike.filter(|other| *other != ty).take(MAX_ALIKE);
        let others = OTHERS
            .into_iter()
            .filter(|other| !only_alike && other.family() != ty.family());
        let others = alike.chain(others).filter(|other| !there.contains(other.name()));
        found.extend(others.map(|other| {
            let program = with_types(program.text, &[(ty.name(), other.name())]);
            (neighbour(ty.name(), other.name()), program)
        }));
        found.extend(with_undeclared.then(|| {
            let by = UNDECLARED.to_owned();
            let program = with_types(program.text, &[(ty.name(), "UNDECLARED")]);
            (
                Neighbour {
                    by,
                    ..neighbour(ty.name(), "")
                },
                program,
            )
        }));
    }
    found
}

/// Returns a program with another name in the place of each name that it declares, as neighbours with which the same does not come.
pub(super) fn with_other_names(program: &ReadProgram<'_, '_>) -> Vec<(Neighbour, String)> {
    let names: BTreeSet<&str> = program.names.iter().map(|one| one.name.text).collect();
    let renamed = names.into_iter().take(MAX_NAMES).map(|name| {
        let mut edits = Edits::new();
        let is_it = |token: &&Token| token.span.text(program.text).eq_ignore_ascii_case(name);
        let written = tokens(program.text);
        written
            .iter()
            .filter(is_it)
            .for_each(|token| edits.replace(token.span, "renamed"));
        let neighbour = Neighbour {
            is_same: false,
            by: OTHER_NAME.to_owned(),
            ..neighbour(name, "")
        };
        (neighbour, edits.apply(program.text))
    });
    renamed.collect()
}

/// Returns a program without the blanks before each sign before which one seldom stands, as neighbours with which the same does not come.
pub(super) fn without_blanks(program: &ReadProgram<'_, '_>) -> Vec<(Neighbour, String)> {
    let signs = [";", "^", ",", ")", "]", "."].into_iter();
    let spaced = signs.map(|sign| (format!(" {sign}"), sign));
    let spaced = spaced.filter(|(spaced, _)| program.text.contains(spaced.as_str()));
    let joined = spaced.map(|(spaced, sign)| {
        let neighbour = Neighbour {
            is_same: false,
            ..neighbour(&spaced, sign)
        };
        (neighbour, program.text.replace(&spaced, sign))
    });
    joined.collect()
}

/// Returns a program with another statement before its first one, as a neighbour with which the same does not come.
pub(super) fn behind_statement(program: &ReadProgram<'_, '_>) -> Option<(Neighbour, String)> {
    let pou = program.unit.pous().find(|pou| !pou.body.is_empty())?;
    let first = pou.body[0].span.start as usize;
    let end = end_of_variables(program.text, pou)?;
    let mut edits = Edits::new();
    edits.replace(end..end, "    n : INT;\n");
    edits.replace(first..first, "n := 0;\n    ");
    let written = pou.body[0].span.text(program.text);
    let neighbour = Neighbour {
        is_same: false,
        by: BEHIND.to_owned(),
        ..neighbour(written, "")
    };
    (!written.contains('\n')).then(|| (neighbour, edits.apply(program.text)))
}

/// Returns a program that has nothing but one PROGRAM with a FUNCTION_BLOCK in its place, as a neighbour with which the same does not come;
/// `None` for another one.
pub(super) fn in_block(program: &ReadProgram<'_, '_>) -> Option<(Neighbour, String)> {
    let [Declaration::Pou(pou)] = &program.unit.declarations[..] else {
        return None;
    };
    let neighbour = Neighbour {
        is_same: false,
        ..neighbour("PROGRAM", "FUNCTION_BLOCK")
    };
    let block = with_types(program.text, &[("PROGRAM", "FUNCTION_BLOCK")]);
    (pou.kind == PouKind::Program).then(|| (neighbour, block + CALLER))
}

/// Returns the numbers of a program, each with plainer ones that may stand in its place, the plainest first: other digits of a location, an
/// integer in capitals, or smaller ones with the same type and base, up to the limits of some sizes.
pub(super) fn numbers<'s>(program: &ReadProgram<'_, 's>) -> Vec<(Span, &'s str, Vec<String>)> {
    let literals = program.literals().map(|(part, text)| {
        let plainer = match text.to_ascii_uppercase() {
            capitals if capitals != text && number_of_literal(text).is_some() => vec![capitals],
            _ => smaller(text),
        };
        (part.expression.span, text, plainer)
    });
    let groups = program.names.iter().filter_map(|one| one.group?.location);
    let locations = groups.map(|place| {
        let letters = place.text.trim_end_matches(|sign: char| sign.is_ascii_digit());
        (place.span, place.text, vec![format!("{letters}1")])
    });
    literals.chain(locations).collect()
}

/// Returns 1 and the numbers at the limits of some sizes, of those that are nearer to zero than an integer literal, and one that is twice as far
/// away, as it is written.
fn smaller(text: &str) -> Vec<String> {
    let Some(number) = number_of_literal(text) else {
        return Vec::new();
    };
    let limits = BITS.iter().flat_map(|bits| [(1 << bits) - 1, 1 << bits]);
    let nearer = [1]
        .into_iter()
        .chain(limits)
        .filter(|limit: &i128| *limit < number.abs())
        .chain(number.abs().checked_mul(2).map(|twice| twice + 1));
    let prefix = text.rfind('#').map_or("", |at| &text[..=at]);
    let sign = if number < 0 { "-" } else { "" };
    let written = nearer.map(|limit| match prefix {
        _ if prefix.ends_with("16#") => format!("{prefix}{limit:X}"),
        _ if prefix.ends_with("8#") => format!("{prefix}{limit:o}"),
        _ if prefix.ends_with("2#") => format!("{prefix}{limit:b}"),
        _ => format!("{prefix}{sign}{limit}"),
    });
    written.collect()
}
