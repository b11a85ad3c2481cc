//! The claims that saboteurs break, and the ways in which they break them.

use std::fmt;
use stickler_types::{ElementaryType, Family, words};

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

words! {
    /// The kinds of pairs of types between which values convert.
    PairKind {
        /// A signed integer to one that holds all its values.
        SignedToWider = "signed-to-wider",
        /// An unsigned integer to one that holds all its values.
        UnsignedToWider = "unsigned-to-wider",
        /// An integer to one that does not hold all its values.
        IntegerToNarrower = "integer-to-narrower",
        /// An integer to REAL or LREAL.
        IntegerToReal = "integer-to-real",
        /// An integer to a bit string.
        IntegerToBitString = "integer-to-bit-string",
        /// REAL to LREAL.
        RealToLreal = "real-to-lreal",
        /// LREAL to REAL.
        LrealToReal = "lreal-to-real",
        /// A real number to an integer.
        RealToInteger = "real-to-integer",
        /// A real number to a bit string.
        RealToBitString = "real-to-bit-string",
        /// A bit string to a wider one.
        BitStringToWider = "bit-string-to-wider",
        /// A bit string to a narrower one.
        BitStringToNarrower = "bit-string-to-narrower",
        /// A bit string to an integer that holds all its values.
        BitStringToWiderInteger = "bit-string-to-wider-integer",
        /// A bit string to an integer that does not hold all its values.
        BitStringToNarrowerInteger = "bit-string-to-narrower-integer",
        /// A bit string to a real number.
        BitStringToReal = "bit-string-to-real",
        /// BOOL to a number or a bit string.
        BoolToNumber = "bool-to-number",
        /// A number or a bit string to BOOL.
        NumberToBool = "number-to-bool",
        /// A duration, a date or a time of day to another type.
        FromTime = "from-time",
        /// Another type to a duration, a date or a time of day.
        ToTime = "to-time",
        /// A text or a character to another type.
        FromText = "from-text",
        /// Another type to a text or a character.
        ToText = "to-text",
    }
}

words! {
    /// The kinds of literals without a type, and of types that they meet.
    LiteralPair {
        /// An integer where an integer is expected.
        IntegerAsInteger = "integer-as-integer",
        /// An integer where a real number is expected.
        IntegerAsReal = "integer-as-real",
        /// An integer where a bit string is expected.
        IntegerAsBitString = "integer-as-bit-string",
        /// An integer where a type of another family is expected.
        IntegerAsOther = "integer-as-other",
        /// A real number where a real number is expected.
        RealAsReal = "real-as-real",
        /// A real number where a type of another family is expected.
        RealAsOther = "real-as-other",
        /// A text where a text is expected.
        TextAsText = "text-as-text",
        /// A text where a type of another family is expected.
        TextAsOther = "text-as-other",
    }
}

words! {
    /// The claims about bits.
    BitClaim {
        /// The bit of that number is read or written.
        Selected = "bit",
        /// A bit that the type does not have is rejected.
        Outside = "bit-outside",
        /// A bit of a type that has none is rejected.
        NoBits = "no-bits",
        /// A form that the dialect does not have is rejected.
        NoSuchForm = "no-such-form",
        /// A rendered selection names the bit of the program.
        Rendered = "rendered-bit",
    }
}

words! {
    /// Whether a bit is read or written.
    Direction {
        /// The bit is read.
        Read = "read",
        /// The bit is written.
        Written = "written",
    }
}

words! {
    /// The forms of partial access.
    PartForm {
        /// `.n`.
        Short = "short",
        /// `.%Xn`.
        PartialAccess = "partial-access",
        /// `.%Bn`, `.%Wn`, `.%Dn` and `.%Ln`.
        Wider = "wider",
    }
}

words! {
    /// The way in which a claim is broken.
    ClaimBreach {
        /// A program that must be accepted is rejected.
        Refused = "refused",
        /// A program that must be rejected is accepted.
        Admitted = "admitted",
        /// The value, the bit or the text is another.
        Wrong = "wrong",
    }
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
    /// Returns the kind of a pair of types; `None` for a type and itself.
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
}

impl Rule {
    /// Returns whether a program that must be rendered is rejected.
    pub(super) fn refuses_rendering(self) -> bool {
        let is_rendered = matches!(self.claim, ConversionClaim::Bit(BitClaim::Rendered, ..));
        is_rendered && self.fault == ClaimBreach::Refused
    }

    /// Returns all rules, in the order of the table.
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
    use ClaimBreach::{Admitted, Refused, Wrong};
    use PartForm::{PartialAccess, Short, Wider};
    const CLAIMS: [(BitClaim, &[ClaimBreach], [PartForm; 2]); 5] = [
        (BitClaim::Selected, &[Refused, Wrong], [Short, PartialAccess]),
        (BitClaim::Outside, &[Admitted], [Short, PartialAccess]),
        (BitClaim::NoBits, &[Admitted], [Short, PartialAccess]),
        (BitClaim::NoSuchForm, &[Admitted], [PartialAccess, Wider]),
        (BitClaim::Rendered, &[Refused, Wrong], [Short, PartialAccess]),
    ];
    let mut rules = Vec::new();
    for (claim, faults, forms) in CLAIMS {
        for direction in [Direction::Read, Direction::Written] {
            for form in forms {
                let claim = ConversionClaim::Bit(claim, direction, form);
                rules.extend(faults.iter().map(|&fault| Rule { claim, fault }));
            }
        }
    }
    rules
}

impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.claim {
            ConversionClaim::Implicit(kind) => write!(f, "implicit.{}", kind.as_str()),
            ConversionClaim::Operand(kind) => write!(f, "operand.{}", kind.as_str()),
            ConversionClaim::Literal(pair) => write!(f, "literal.{}", pair.as_str()),
            ConversionClaim::Function(kind) => write!(f, "function.{}", kind.as_str()),
            ConversionClaim::Bit(claim, direction, form) => {
                write!(f, "{}.{}-{}", claim.as_str(), direction.as_str(), form.as_str())
            }
        }?;
        write!(f, ".{}", self.fault.as_str())
    }
}
