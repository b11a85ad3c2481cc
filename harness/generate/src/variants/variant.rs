//! The variants by name.

use super::{branches, capitals, dead_code, literals, loops, operands, spelling};
use crate::dialect::has_partial_access;
use crate::model::Program;
use crate::random::Random;
use crate::writer::{ArgumentForm, Bits, Keywords, LineEnds, Notation, Style, WideningForm, write};
use arbitrary::Unstructured;
use stickler_reference::render;

/// A way to write a program differently without changing its meaning.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Variant {
    /// Keywords in lower or mixed case.
    Keywords,
    /// Every letter outside texts and comments in a random case; names are case-insensitive too.
    Capitals,
    /// Comments in the place of blanks.
    Comments,
    /// Lines that end with a carriage return and a line feed.
    LineEnds,
    /// Literals in other notations: bases, underscores, exponents, `T#1m30s`, characters by their codes.
    Notation,
    /// `.%Xn` for `.n`.
    Bits,
    /// A conversion function for each implicit conversion.
    ExplicitConversions,
    /// Named arguments for positional ones.
    NamedArguments,
    /// Literals moved to variables and named constants.
    ConstantsHoisted,
    /// `INT#5` for `5`.
    TypedLiterals,
    /// Exchanged operands of commutative operators and of comparisons.
    OperandsSwapped,
    /// Operands in variables of their own, assigned just before.
    Temporaries,
    /// FOR loops unrolled; the first iteration of WHILE and REPEAT peeled off.
    LoopUnrolled,
    /// Statements that are never reached, assignments of a variable to itself, variables that are never read.
    DeadCode,
    /// `IF NOT c THEN b ELSE a` for `IF c THEN a ELSE b`.
    BranchesSwapped,
    /// The output of the renderer of the reference.
    Rendered,
}

impl Variant {
    /// Every variant, in the order of the declaration.
    pub const ALL: [Variant; 16] = [
        Variant::Keywords,
        Variant::Capitals,
        Variant::Comments,
        Variant::LineEnds,
        Variant::Notation,
        Variant::Bits,
        Variant::ExplicitConversions,
        Variant::NamedArguments,
        Variant::ConstantsHoisted,
        Variant::TypedLiterals,
        Variant::OperandsSwapped,
        Variant::Temporaries,
        Variant::LoopUnrolled,
        Variant::DeadCode,
        Variant::BranchesSwapped,
        Variant::Rendered,
    ];

    /// Returns the name in symptoms and reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Variant::Keywords => "keywords",
            Variant::Capitals => "capitals",
            Variant::Comments => "comments",
            Variant::LineEnds => "line-ends",
            Variant::Notation => "notation",
            Variant::Bits => "bits",
            Variant::ExplicitConversions => "explicit-conversions",
            Variant::NamedArguments => "named-arguments",
            Variant::ConstantsHoisted => "constants-hoisted",
            Variant::TypedLiterals => "typed-literals",
            Variant::OperandsSwapped => "operands-swapped",
            Variant::Temporaries => "temporaries",
            Variant::LoopUnrolled => "loop-unrolled",
            Variant::DeadCode => "dead-code",
            Variant::BranchesSwapped => "branches-swapped",
            Variant::Rendered => "rendered",
        }
    }

    /// Returns the text of this variant of a program; `None` if the program has nothing that could be varied.
    ///
    /// The input chooses what is varied. Variables that a variant adds come after those of the program, and every path of
    /// [`Program::observed`] keeps its meaning.
    #[must_use]
    pub fn text(self, program: &Program, input: &mut Unstructured<'_>) -> Option<String> {
        let mut random = Random::new(input);
        match self {
            Variant::Keywords => {
                let keywords = [Keywords::Lower, Keywords::Mixed];
                let keywords = *random.pick(&keywords)?;
                spelling::other(
                    program,
                    Style {
                        keywords,
                        seed: random.bits(),
                        ..Style::default()
                    },
                )
            }
            Variant::Capitals => capitals::random_case(program, &mut random),
            Variant::Comments => {
                let style = Style {
                    comments: true,
                    seed: random.bits(),
                    ..Style::default()
                };
                spelling::other(program, style)
            }
            Variant::LineEnds => spelling::other(
                program,
                Style {
                    line_ends: LineEnds::CrLf,
                    ..Style::default()
                },
            ),
            Variant::Notation => spelling::other(
                program,
                Style {
                    notation: Notation::Varied,
                    seed: random.bits(),
                    ..Style::default()
                },
            ),
            Variant::Bits if has_partial_access(program.dialect) => spelling::other(
                program,
                Style {
                    bits: Bits::Percent,
                    ..Style::default()
                },
            ),
            Variant::Bits => None,
            Variant::ExplicitConversions => spelling::other(
                program,
                Style {
                    widening: WideningForm::Explicit,
                    ..Style::default()
                },
            ),
            Variant::NamedArguments => spelling::other(
                program,
                Style {
                    arguments: ArgumentForm::Named,
                    ..Style::default()
                },
            ),
            Variant::ConstantsHoisted => changed(program, &mut random, literals::hoist),
            Variant::TypedLiterals => changed(program, &mut random, literals::type_all),
            Variant::OperandsSwapped => changed(program, &mut random, operands::swap),
            Variant::Temporaries => changed(program, &mut random, operands::split),
            Variant::LoopUnrolled => changed(program, &mut random, loops::unroll),
            Variant::DeadCode => changed(program, &mut random, dead_code::insert),
            Variant::BranchesSwapped => changed(program, &mut random, branches::swap),
            Variant::Rendered => Some(rendered(program, &mut random)),
        }
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
    let notations = [Notation::Canonical, Notation::Varied];
    let style = Style {
        notation: random.pick(&notations).copied().unwrap_or_default(),
        seed: random.bits(),
        ..Style::default()
    };
    let text = write(program, &style).text;
    render(&text, program.dialect).unwrap_or_else(|diagnostics| {
        let described: Vec<String> = diagnostics.iter().map(ToString::to_string).collect();
        format!("(* the renderer refuses the text: {} *)", described.join("; "))
    })
}
