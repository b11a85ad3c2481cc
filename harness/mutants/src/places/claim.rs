//! The claims that saboteurs break, and the ways in which they break them.

use std::fmt;
use stickler_types::{ElementaryType, Family};

/// A claim of the documents about values that change their type, or about bits.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum ConversionClaim {
    /// Whether a value converts implicitly where another type is expected, and to what.
    Implicit(PairKind),
    /// Whether an operand converts to the type in which its operator computes, and to what.
    Operand(PairKind),
    /// Whether an untyped literal may stand where a type is expected.
    Literal(LiteralPair),
    /// The result of a type conversion function.
    Function(PairKind),
    /// A bit that is selected.
    Bit(BitClaim, Direction, PartForm),
}

/// The kinds of pairs of types between which values convert.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum PairKind {
    /// A signed integer to one that holds all its values.
    SignedToWider,
    /// An unsigned integer to one that holds all its values.
    UnsignedToWider,
    /// An integer to one that does not hold all its values.
    IntegerToNarrower,
    /// An integer to REAL or LREAL.
    IntegerToReal,
    /// An integer to a bit string.
    IntegerToBitString,
    /// REAL to LREAL.
    RealToLreal,
    /// LREAL to REAL.
    LrealToReal,
    /// A real number to an integer.
    RealToInteger,
    /// A real number to a bit string.
    RealToBitString,
    /// A bit string to a wider one.
    BitStringToWider,
    /// A bit string to a narrower one.
    BitStringToNarrower,
    /// A bit string to an integer that holds all its values.
    BitStringToWiderInteger,
    /// A bit string to an integer that does not hold all its values.
    BitStringToNarrowerInteger,
    /// A bit string to a real number.
    BitStringToReal,
    /// BOOL to a number or a bit string.
    BoolToNumber,
    /// A number or a bit string to BOOL.
    NumberToBool,
    /// A duration, a date or a time of day to another type.
    FromTime,
    /// Another type to a duration, a date or a time of day.
    ToTime,
    /// A text or a character to another type.
    FromText,
    /// Another type to a text or a character.
    ToText,
}

/// The kinds of literals without a type, and of types that they meet.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum LiteralPair {
    /// An integer where an integer is expected.
    IntegerAsInteger,
    /// An integer where a real number is expected.
    IntegerAsReal,
    /// An integer where a bit string is expected.
    IntegerAsBitString,
    /// An integer where a type of another family is expected.
    IntegerAsOther,
    /// A real number where a real number is expected.
    RealAsReal,
    /// A real number where a type of another family is expected.
    RealAsOther,
    /// A text where a text is expected.
    TextAsText,
    /// A text where a type of another family is expected.
    TextAsOther,
}

/// The claims about bits.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum BitClaim {
    /// The bit of that number is read or written.
    Selected,
    /// A bit that the type does not have is rejected.
    Outside,
    /// A bit of a type that has none is rejected.
    NoBits,
    /// A form that the dialect does not have is rejected.
    NoSuchForm,
    /// A rendered selection names the bit of the program.
    Rendered,
}

/// Whether a bit is read or written.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Direction {
    /// The bit is read.
    Read,
    /// The bit is written.
    Written,
}

/// The forms of partial access.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum PartForm {
    /// `.n`.
    Short,
    /// `.%Xn`.
    PartialAccess,
    /// `.%Bn`, `.%Wn`, `.%Dn` and `.%Ln`.
    Wider,
}

/// The way in which a claim is broken.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum ClaimBreach {
    /// A program that must be accepted is rejected.
    Refused,
    /// A program that must be rejected is accepted.
    Admitted,
    /// The value, the bit or the text is another.
    Wrong,
}

/// A claim and the way in which it is broken.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Rule {
    /// The claim.
    pub claim: ConversionClaim,
    /// The way in which it is broken.
    pub fault: ClaimBreach,
}

impl PairKind {
    /// All kinds.
    pub const ALL: [PairKind; 20] = [
        PairKind::SignedToWider,
        PairKind::UnsignedToWider,
        PairKind::IntegerToNarrower,
        PairKind::IntegerToReal,
        PairKind::IntegerToBitString,
        PairKind::RealToLreal,
        PairKind::LrealToReal,
        PairKind::RealToInteger,
        PairKind::RealToBitString,
        PairKind::BitStringToWider,
        PairKind::BitStringToNarrower,
        PairKind::BitStringToWiderInteger,
        PairKind::BitStringToNarrowerInteger,
        PairKind::BitStringToReal,
        PairKind::BoolToNumber,
        PairKind::NumberToBool,
        PairKind::FromTime,
        PairKind::ToTime,
        PairKind::FromText,
        PairKind::ToText,
    ];

    /// Returns the kind of a pair of types; `None` for a type and itself.
    #[must_use]
    pub fn of(from: ElementaryType, to: ElementaryType) -> Option<PairKind> {
        use Family::{BitString, Boolean, Character, Real, Signed, Text, Unsigned};
        let wider = from.bits() < to.bits();
        Some(match (from.family(), to.family()) {
            _ if from == to => return None,
            (Text | Character, _) => PairKind::FromText,
            (_, Text | Character) => PairKind::ToText,
            (Signed, Signed) if wider => PairKind::SignedToWider,
            (Unsigned, Signed | Unsigned) if wider => PairKind::UnsignedToWider,
            (Signed | Unsigned, Signed | Unsigned) => PairKind::IntegerToNarrower,
            (Signed | Unsigned, Real) => PairKind::IntegerToReal,
            (Signed | Unsigned, BitString) => PairKind::IntegerToBitString,
            (Real, Real) if wider => PairKind::RealToLreal,
            (Real, Real) => PairKind::LrealToReal,
            (Real, Signed | Unsigned) => PairKind::RealToInteger,
            (Real, BitString) => PairKind::RealToBitString,
            (BitString, BitString) if wider => PairKind::BitStringToWider,
            (BitString, BitString) => PairKind::BitStringToNarrower,
            (BitString, Signed | Unsigned) if wider => PairKind::BitStringToWiderInteger,
            (BitString, Unsigned) if from.bits() == to.bits() => PairKind::BitStringToWiderInteger,
            (BitString, Signed | Unsigned) => PairKind::BitStringToNarrowerInteger,
            (BitString, Real) => PairKind::BitStringToReal,
            (Boolean, Signed | Unsigned | BitString | Real) => PairKind::BoolToNumber,
            (Signed | Unsigned | BitString | Real, Boolean) => PairKind::NumberToBool,
            (Boolean, Boolean) => return None,
            (Boolean | Signed | Unsigned | BitString | Real, _) => PairKind::ToTime,
            (_, _) => PairKind::FromTime,
        })
    }

    const fn name(self) -> &'static str {
        match self {
            PairKind::SignedToWider => "signed-to-wider",
            PairKind::UnsignedToWider => "unsigned-to-wider",
            PairKind::IntegerToNarrower => "integer-to-narrower",
            PairKind::IntegerToReal => "integer-to-real",
            PairKind::IntegerToBitString => "integer-to-bit-string",
            PairKind::RealToLreal => "real-to-lreal",
            PairKind::LrealToReal => "lreal-to-real",
            PairKind::RealToInteger => "real-to-integer",
            PairKind::RealToBitString => "real-to-bit-string",
            PairKind::BitStringToWider => "bit-string-to-wider",
            PairKind::BitStringToNarrower => "bit-string-to-narrower",
            PairKind::BitStringToWiderInteger => "bit-string-to-wider-integer",
            PairKind::BitStringToNarrowerInteger => "bit-string-to-narrower-integer",
            PairKind::BitStringToReal => "bit-string-to-real",
            PairKind::BoolToNumber => "bool-to-number",
            PairKind::NumberToBool => "number-to-bool",
            PairKind::FromTime => "from-time",
            PairKind::ToTime => "to-time",
            PairKind::FromText => "from-text",
            PairKind::ToText => "to-text",
        }
    }
}

impl LiteralPair {
    /// All kinds.
    pub const ALL: [LiteralPair; 8] = [
        LiteralPair::IntegerAsInteger,
        LiteralPair::IntegerAsReal,
        LiteralPair::IntegerAsBitString,
        LiteralPair::IntegerAsOther,
        LiteralPair::RealAsReal,
        LiteralPair::RealAsOther,
        LiteralPair::TextAsText,
        LiteralPair::TextAsOther,
    ];

    const fn name(self) -> &'static str {
        match self {
            LiteralPair::IntegerAsInteger => "integer-as-integer",
            LiteralPair::IntegerAsReal => "integer-as-real",
            LiteralPair::IntegerAsBitString => "integer-as-bit-string",
            LiteralPair::IntegerAsOther => "integer-as-other",
            LiteralPair::RealAsReal => "real-as-real",
            LiteralPair::RealAsOther => "real-as-other",
            LiteralPair::TextAsText => "text-as-text",
            LiteralPair::TextAsOther => "text-as-other",
        }
    }
}

impl Rule {
    /// Returns whether a program that must be rendered is rejected.
    pub(super) fn refuses_rendering(self) -> bool {
        let is_rendered = matches!(self.claim, ConversionClaim::Bit(BitClaim::Rendered, ..));
        is_rendered && self.fault == ClaimBreach::Refused
    }

    /// Returns all rules, in the order of the table.
    #[must_use]
    pub fn all() -> Vec<Rule> {
        let pairs = |claim: fn(PairKind) -> ConversionClaim, faults: &'static [ClaimBreach]| {
            let rules = PairKind::ALL.into_iter().flat_map(move |kind| {
                let claim = claim(kind);
                faults.iter().map(move |&fault| Rule { claim, fault })
            });
            rules.collect::<Vec<_>>()
        };
        let mut rules = pairs(
            ConversionClaim::Implicit,
            &[ClaimBreach::Refused, ClaimBreach::Wrong, ClaimBreach::Admitted],
        );
        rules.extend(LiteralPair::ALL.into_iter().flat_map(|pair| {
            let claim = ConversionClaim::Literal(pair);
            [ClaimBreach::Refused, ClaimBreach::Admitted].map(|fault| Rule { claim, fault })
        }));
        rules.extend(pairs(
            ConversionClaim::Operand,
            &[ClaimBreach::Refused, ClaimBreach::Wrong],
        ));
        rules.extend(pairs(
            ConversionClaim::Function,
            &[ClaimBreach::Refused, ClaimBreach::Wrong],
        ));
        rules.extend(bit_rules());
        rules
    }
}

fn bit_rules() -> Vec<Rule> {
    const CLAIMS: [(BitClaim, &[ClaimBreach], &[PartForm]); 5] = [
        (
            BitClaim::Selected,
            &[ClaimBreach::Refused, ClaimBreach::Wrong],
            &[PartForm::Short, PartForm::PartialAccess],
        ),
        (
            BitClaim::Outside,
            &[ClaimBreach::Admitted],
            &[PartForm::Short, PartForm::PartialAccess],
        ),
        (
            BitClaim::NoBits,
            &[ClaimBreach::Admitted],
            &[PartForm::Short, PartForm::PartialAccess],
        ),
        (
            BitClaim::NoSuchForm,
            &[ClaimBreach::Admitted],
            &[PartForm::PartialAccess, PartForm::Wider],
        ),
        (
            BitClaim::Rendered,
            &[ClaimBreach::Refused, ClaimBreach::Wrong],
            &[PartForm::Short, PartForm::PartialAccess],
        ),
    ];
    let mut rules = Vec::new();
    for (claim, faults, forms) in CLAIMS {
        for direction in [Direction::Read, Direction::Written] {
            for &form in forms {
                let claim = ConversionClaim::Bit(claim, direction, form);
                rules.extend(faults.iter().map(|&fault| Rule { claim, fault }));
            }
        }
    }
    rules
}

impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let fault = match self.fault {
            ClaimBreach::Refused => "refused",
            ClaimBreach::Admitted => "admitted",
            ClaimBreach::Wrong => "wrong",
        };
        match self.claim {
            ConversionClaim::Implicit(kind) => write!(f, "implicit.{}", kind.name()),
            ConversionClaim::Operand(kind) => write!(f, "operand.{}", kind.name()),
            ConversionClaim::Literal(pair) => write!(f, "literal.{}", pair.name()),
            ConversionClaim::Function(kind) => write!(f, "function.{}", kind.name()),
            ConversionClaim::Bit(claim, direction, form) => {
                let claim = match claim {
                    BitClaim::Selected => "bit",
                    BitClaim::Outside => "bit-outside",
                    BitClaim::NoBits => "no-bits",
                    BitClaim::NoSuchForm => "no-such-form",
                    BitClaim::Rendered => "rendered-bit",
                };
                let direction = match direction {
                    Direction::Read => "read",
                    Direction::Written => "written",
                };
                let form = match form {
                    PartForm::Short => "short",
                    PartForm::PartialAccess => "partial-access",
                    PartForm::Wider => "wider",
                };
                write!(f, "{claim}.{direction}-{form}")
            }
        }?;
        write!(f, ".{fault}")
    }
}
