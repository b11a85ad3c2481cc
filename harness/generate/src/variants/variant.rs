//! The variants by name, and those of the text alone.
//!
//! Basis: iec-61131-3: 6.1.2 (identifiers and keywords do not distinguish cases; literals neither, but for the characters of
//! texts).

use super::{dead_code, loops, operands};
use crate::model::Program;
use crate::random::Random;
use crate::writer::{Keywords, Style, write};
use arbitrary::Unstructured;
use stickler_reference::render;
use stickler_types::{join, words};

words! {
    /// A way to write a program differently without changing its meaning.
    Variant {
        /// Keywords in lower or mixed case.
        Keywords = "keywords",
        /// Every letter outside texts and comments in a random case; names are case-insensitive too.
        Capitals = "capitals",
        /// Comments in the place of blanks.
        Comments = "comments",
        /// Lines that end with a carriage return and a line feed.
        LineEnds = "line-ends",
        /// Literals in other notations: bases, underscores, exponents, `T#1m30s`, characters by their codes.
        Notation = "notation",
        /// `.%Xn` for `.n`.
        Bits = "bits",
        /// A conversion function for each implicit conversion.
        ExplicitConversions = "explicit-conversions",
        /// Named arguments for positional ones.
        NamedArguments = "named-arguments",
        /// Literals moved to variables and named constants.
        ConstantsHoisted = "constants-hoisted",
        /// `INT#5` for `5`.
        TypedLiterals = "typed-literals",
        /// Exchanged operands of commutative operators and of comparisons.
        OperandsSwapped = "operands-swapped",
        /// Operands in variables of their own, assigned just before.
        Temporaries = "temporaries",
        /// FOR loops unrolled; the first iteration of WHILE and REPEAT peeled off.
        LoopUnrolled = "loop-unrolled",
        /// Statements that are never reached, assignments of a variable to itself, variables that are never read.
        DeadCode = "dead-code",
        /// `IF NOT c THEN b ELSE a` for `IF c THEN a ELSE b`.
        BranchesSwapped = "branches-swapped",
        /// The output of the renderer of the reference.
        Rendered = "rendered",
    }
}

impl Variant {
    /// Returns the text of this variant of a program; `None` if the program has nothing that could be varied.
    ///
    /// The input chooses what is varied. Variables that a variant adds come after those of the program, and every path of
    /// [`Program::observed`] keeps its meaning.
    pub fn text(self, program: &Program, input: &mut Unstructured<'_>) -> Option<String> {
        let mut random = Random::new(input);
        let mut style = Style::default();
        match self {
            Variant::Keywords => {
                style.keywords = *random.pick(&[Keywords::Lower, Keywords::Mixed])?;
                style.seed = random.bits();
            }
            Variant::Comments => {
                style.comments = true;
                style.seed = random.bits();
            }
            Variant::LineEnds => style.carriage_returns = true,
            Variant::Notation => {
                style.varied_notation = true;
                style.seed = random.bits();
            }
            Variant::Bits if program.dialect.rules().documents.partial_access => style.percent_bits = true,
            Variant::Bits => return None,
            Variant::ExplicitConversions => style.explicit_conversions = true,
            Variant::NamedArguments => style.named_arguments = true,
            Variant::Capitals => return random_case(program, &mut random),
            Variant::ConstantsHoisted => return changed(program, &mut random, operands::hoist),
            Variant::TypedLiterals => return changed(program, &mut random, operands::type_all),
            Variant::OperandsSwapped => return changed(program, &mut random, operands::swap),
            Variant::Temporaries => return changed(program, &mut random, operands::split),
            Variant::LoopUnrolled => return changed(program, &mut random, loops::unroll),
            Variant::DeadCode => return changed(program, &mut random, dead_code::insert),
            Variant::BranchesSwapped => return changed(program, &mut random, loops::swap_branches),
            Variant::Rendered => return Some(rendered(program, &mut random)),
        }
        let text = write(program, &style).text;
        (text != write(program, &Style::default()).text).then_some(text)
    }
}

/// Applies a change to a copy of the program and writes it; `None` if the change, which returns the number of its edits, did
/// nothing.
fn changed(
    program: &Program,
    random: &mut Random<'_, '_>,
    change: impl FnOnce(&mut Program, &mut Random<'_, '_>) -> usize,
) -> Option<String> {
    let mut program = program.clone();
    (change(&mut program, random) > 0).then(|| write(&program, &Style::default()).text)
}

/// Renders the text of a program, written in one notation or the other, by the renderer of the reference. If the renderer
/// refuses, the result is no program, and whoever runs it will report so.
fn rendered(program: &Program, random: &mut Random<'_, '_>) -> String {
    let style = Style {
        varied_notation: random.pick(&[false, true]).copied().unwrap_or_default(),
        seed: random.bits(),
        ..Style::default()
    };
    let text = write(program, &style).text;
    render(&text, program.dialect).unwrap_or_else(|diagnostics| {
        let described = join(diagnostics, "; ");
        format!("(* the renderer refuses the text: {described} *)")
    })
}

/// Writes a program with each letter outside character strings in a random case; `None` if that changes nothing.
pub(super) fn random_case(program: &Program, random: &mut Random<'_, '_>) -> Option<String> {
    let text = write(program, &Style::default()).text;
    let mut bits = random.bits() | 1;
    // The quote that ends the character string, and whether a dollar precedes: a quote in a string follows one, or is written by
    // its code.
    let (mut quoted, mut escaped) = (None, false);
    let varied: String = text
        .chars()
        .map(|letter| {
            if let Some(quote) = quoted {
                quoted = quoted.filter(|_| escaped || letter != quote);
                escaped = !escaped && letter == '$';
                return letter;
            }
            quoted = matches!(letter, '\'' | '"').then_some(letter);
            if quoted.is_some() {
                return letter;
            }
            bits = bits.rotate_left(1);
            in_case(letter, bits & 1 == 1)
        })
        .collect();
    (varied != text).then_some(varied)
}

const fn in_case(letter: char, lower: bool) -> char {
    if lower {
        letter.to_ascii_lowercase()
    } else {
        letter.to_ascii_uppercase()
    }
}
