//! Selection of the constructs that one program may use: drawn first, so that programs differ in kind and not only in size.
//!
//! A program with every construct hides much, because one construct masks the defects of another. So each program gets about
//! half of the constructs and a handful of types, and uses those often. Basis: Groce and others, "Swarm testing" (ISSTA
//! 2012).

use super::profile::DialectProfile;
use crate::random::Random;
use stickler_types::{ElementaryType, distinct};

/// A construct that a program may use or not.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Construct {
    /// Implicit conversions.
    Widening,
    /// Conversion functions.
    Conversions,
    /// Literals without a type.
    Untyped,
    /// Initial values.
    Initials,
    /// VAR CONSTANT.
    Constants,
    /// Arrays.
    Arrays,
    /// Structures.
    Structures,
    /// Enumerations.
    Enumerations,
    /// Other names for types.
    Aliases,
    /// Functions of the program.
    Functions,
    /// Function blocks of the program.
    Blocks,
    /// Standard function blocks.
    StandardBlocks,
    /// References or pointers.
    References,
    /// `+`, `-`, `*`.
    Arithmetic,
    /// `/`, `MOD`.
    Division,
    /// AND, OR, XOR, NOT.
    Logic,
    /// Comparisons outside of conditions.
    Comparisons,
    /// Bits of integers and bit strings.
    Bits,
    /// SEL, MUX, MIN, MAX, LIMIT, ABS.
    Selection,
    /// SHL, SHR, ROL, ROR.
    Shifts,
    /// IF.
    If,
    /// CASE.
    Case,
    /// FOR.
    For,
    /// WHILE.
    While,
    /// REPEAT.
    Repeat,
    /// EXIT.
    Exit,
    /// RETURN.
    Return,
    /// Expressions of many levels.
    Deep,
    /// Deeply nested statements.
    Nested,
    /// Methods of the function blocks of the program.
    Methods,
}

/// The constructs that a program may have to do without, with the features of the language that are forms of each, or that each of
/// its forms needs.
const FORMS: &[(Construct, &[&str])] = &[
    (Construct::Conversions, &["conversion"]),
    (Construct::Initials, &["initial-value"]),
    (Construct::Constants, &["constant"]),
    (Construct::Arrays, &["array"]),
    (Construct::Structures, &["structure"]),
    (Construct::Enumerations, &["enumeration"]),
    (Construct::Aliases, &["type-alias", "array-type"]),
    (Construct::Functions, &["function"]),
    (Construct::Blocks, &["function-block"]),
    (Construct::Arithmetic, &["add", "subtract", "multiply"]),
    (Construct::Division, &["divide", "mod"]),
    (Construct::Logic, &["and", "or", "xor"]),
    (Construct::Bits, &["bit-access"]),
    (Construct::If, &["if"]),
    (Construct::Case, &["case"]),
    (Construct::For, &["for"]),
    (Construct::While, &["while"]),
    (Construct::Repeat, &["repeat"]),
    (Construct::Exit, &["exit"]),
    (Construct::Return, &["return"]),
    (Construct::Methods, &["method"]),
    (Construct::Methods, &["method-call"]),
    (Construct::Methods, &["access-specifier"]),
];

/// The set of constructs of one program.
#[derive(Clone, Copy, Debug)]
pub(super) struct ConstructSet(u32);

impl ConstructSet {
    /// Draws a set: each construct with probability 1/2, the subjects of the suite more often, and all constructs in one
    /// program of sixteen.
    pub fn drawn(random: &mut Random<'_, '_>) -> ConstructSet {
        use Construct as F;
        let all = random.chance(1, 16);
        let [drawn, often, mostly] = [random.bits(), random.bits(), random.bits()].map(|bits| bits as u32);
        let bits = |constructs: &[Construct]| {
            constructs
                .iter()
                .fold(0, |bits, feature| bits | 1 << *feature as u32)
        };
        let often = often
            & bits(&[
                F::Widening,
                F::Conversions,
                F::Arithmetic,
                F::Bits,
                F::If,
                F::Initials,
                F::Untyped,
            ]);
        // Without initial values nearly everything stays zero.
        let mostly = mostly & bits(&[F::Initials, F::Arithmetic]);
        ConstructSet(if all { u32::MAX } else { drawn | often | mostly })
    }

    /// Returns the set without the constructs of which every form is lacking.
    pub fn without(self, lacks: &dyn Fn(&str) -> bool) -> ConstructSet {
        let lacking = FORMS
            .iter()
            .filter(|(_, forms)| forms.iter().all(|form| lacks(form)));
        ConstructSet(lacking.fold(self.0, |bits, (construct, _)| bits & !(1 << *construct as u32)))
    }

    /// Returns whether the set contains a construct.
    pub const fn has(self, feature: Construct) -> bool {
        self.0 >> feature as u32 & 1 == 1
    }
}

/// The maximum number of types of a program, besides those that its conversions add.
const MAX_TYPES: usize = 7;

/// Draws the elementary types of one program, each once; INT alone when the bytes have run out.
pub(super) fn palette(
    profile: &DialectProfile,
    random: &mut Random<'_, '_>,
    lacks: &dyn Fn(&str) -> bool,
) -> Vec<ElementaryType> {
    let types = 0..=random.below(MAX_TYPES);
    let drawn = types.map(|_| random.pick(&profile.weighted_types).copied());
    let mut palette = distinct(drawn.map(|ty| ty.unwrap_or(ElementaryType::Int)));
    palette.retain(|ty| !lacks(ty.name()));
    if palette.is_empty() {
        let there = |ty: &ElementaryType| !lacks(ty.name());
        palette.extend(profile.weighted_types.iter().copied().find(there));
    }
    palette
}
