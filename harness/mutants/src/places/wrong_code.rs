//! Instructions that make the result of a conversion wrong as a compiler's mistake would: a sign that is lost, a fraction that is
//! dropped, a value that is limited and not wrapped.

use super::claim::PairKind;
use stickler_reference::conversion::{Conversion, ConversionRule};
use stickler_reference::instruction::{Instruction, LogicOperator};
use stickler_types::dialect::COMMON_CHOICES;
use stickler_types::{ElementaryType, OutOfRange, Rounding};

/// Instructions that replace a conversion, or follow one.
#[derive(Clone, PartialEq, Debug)]
pub struct WrongCode {
    /// Whether they stand for the conversion itself; otherwise they come behind it.
    pub replaces: bool,
    /// The instructions.
    pub code: Vec<Instruction>,
}

/// Returns the code that makes a conversion of a kind wrong. `performed` is the conversion as the program performs it, where it has
/// not been folded into a constant; `nothing` is the number of a text constant without characters. `None` where the mistake
/// needs a conversion that is performed as the program runs.
pub fn wrong_code(
    kind: PairKind,
    (from, to): (ElementaryType, ElementaryType),
    performed: Option<Conversion>,
    nothing: u32,
) -> Option<WrongCode> {
    let through = |ty| behind([converted(to, ty)?, converted(ty, to)?]);
    match kind {
        PairKind::SignedToWider
        | PairKind::UnsignedToWider
        | PairKind::IntegerToReal
        | PairKind::BitStringToWider
        | PairKind::BitStringToReal => through(other_sign(from)?),
        PairKind::BitStringToWiderInteger | PairKind::IntegerToBitString if from.bits() < to.bits() => {
            through(other_sign(from)?)
        }
        PairKind::RealToLreal | PairKind::LrealToReal => through(ElementaryType::Lint),
        PairKind::IntegerToNarrower => limited(performed?),
        PairKind::BitStringToNarrower
        | PairKind::BitStringToWiderInteger
        | PairKind::BitStringToNarrowerInteger
        | PairKind::IntegerToBitString => without_highest_bit(to),
        PairKind::RealToInteger | PairKind::RealToBitString => rounded_otherwise(performed?),
        PairKind::BoolToNumber => negative(to),
        PairKind::NumberToBool => other_truth(performed?),
        PairKind::ToText | PairKind::FromText if to.is_text() => {
            behind([Instruction::DropText, Instruction::PushText(nothing)])
        }
        PairKind::ToText | PairKind::FromText | PairKind::FromTime | PairKind::ToTime => {
            behind([Instruction::Drop, Instruction::Push(0)])
        }
    }
}

fn behind(code: impl Into<Vec<Instruction>>) -> Option<WrongCode> {
    Some(WrongCode {
        replaces: false,
        code: code.into(),
    })
}

fn instead(code: impl Into<Vec<Instruction>>) -> Option<WrongCode> {
    Some(WrongCode {
        replaces: true,
        code: code.into(),
    })
}

fn converted(from: ElementaryType, to: ElementaryType) -> Option<Instruction> {
    let rule = ConversionRule::between(from, to, &COMMON_CHOICES)?;
    Some(Instruction::Convert(Conversion { from, to, rule }))
}

/// Returns the integer of the same width that has a sign where the type has none, and none where it has one.
fn other_sign(ty: ElementaryType) -> Option<ElementaryType> {
    use ElementaryType::{Byte, Dint, Dword, Int, Lint, Lword, Sint, Udint, Uint, Ulint, Usint, Word};
    Some(match ty {
        Sint => Usint,
        Int => Uint,
        Dint => Udint,
        Lint => Ulint,
        Usint | Byte => Sint,
        Uint | Word => Int,
        Udint | Dword => Dint,
        Ulint | Lword => Lint,
        _ => return None,
    })
}

/// Limits to the values of the target what must wrap.
fn limited(Conversion { from, to, .. }: Conversion) -> Option<WrongCode> {
    let rule = ConversionRule::FromReal(Rounding::Truncate, OutOfRange::Saturate);
    let from_real = Conversion {
        from: ElementaryType::Lreal,
        to,
        rule,
    };
    instead([
        converted(from, ElementaryType::Lreal)?,
        Instruction::Convert(from_real),
    ])
}

fn without_highest_bit(to: ElementaryType) -> Option<WrongCode> {
    let others = (1_u64 << (to.bits() - 1)) - 1;
    behind([Instruction::Push(others), Instruction::Logic(LogicOperator::And)])
}

/// Rounds where a fraction must be dropped, and drops it where it must be rounded.
fn rounded_otherwise(performed: Conversion) -> Option<WrongCode> {
    let ConversionRule::FromReal(rounding, range) = performed.rule else {
        return None;
    };
    let rounding = match rounding {
        Rounding::Truncate => Rounding::HalfAwayFromZero,
        _ => Rounding::Truncate,
    };
    let rule = ConversionRule::FromReal(rounding, range);
    instead([Instruction::Convert(Conversion { rule, ..performed })])
}

/// Makes -1 of TRUE; of an unsigned type and a bit string, all bits.
fn negative(to: ElementaryType) -> Option<WrongCode> {
    if to.is_signed() || to.is_real() {
        return behind([Instruction::Negate(to)]);
    }
    let signed = other_sign(to)?;
    behind([
        converted(to, signed)?,
        Instruction::Negate(signed),
        converted(signed, to)?,
    ])
}

/// Looks at the lowest bit only where every number but zero is TRUE, and the other way round.
fn other_truth(Conversion { from, to, rule }: Conversion) -> Option<WrongCode> {
    if rule == ConversionRule::Wrap {
        let rule = ConversionRule::NonZero;
        return instead([Instruction::Convert(Conversion { from, to, rule })]);
    }
    let rule = ConversionRule::Wrap;
    let wrap = |from| Instruction::Convert(Conversion { from, to, rule });
    match from.is_real() {
        true => instead([converted(from, ElementaryType::Lint)?, wrap(ElementaryType::Lint)]),
        false => instead([wrap(from)]),
    }
}
