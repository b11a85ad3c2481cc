//! The catalogue of type conversion functions, generated from pairs of types and a few rules.
//!
//! Basis: forgeiec-conversion-functions: The naming pattern; ironplc-type-conversions: Explicit Conversion
//! Functions ("for all type pairs … `<SOURCE>_TO_<TARGET>`").

use super::{Conversion, ConversionRule};
use std::sync::LazyLock;
use stickler_types::dialect::COMMON_CHOICES;
use stickler_types::{ConversionChoices, Dialect, ElementaryType, Rounding};

/// The parameter of a conversion function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Parameter {
    /// One type; an argument may widen to it.
    Exactly(ElementaryType),
    /// Any of several types, as they come; nothing widens to them.
    AnyOf {
        /// The types.
        allowed: &'static [ElementaryType],
        /// The type that an untyped literal takes where it fits; otherwise it takes DINT or LREAL as ever.
        default: ElementaryType,
    },
}

impl Parameter {
    /// The type that a message about another one names.
    pub const fn expected(self) -> ElementaryType {
        match self {
            Parameter::Exactly(ty) | Parameter::AnyOf { default: ty, .. } => ty,
        }
    }
}

/// The result type of a conversion function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ResultType {
    /// One type.
    Exactly(ElementaryType),
    /// The type of its target where that is one of several, otherwise the default.
    OfTarget {
        /// The types.
        allowed: &'static [ElementaryType],
        /// The type where there is no target, or where the target is of another type.
        default: ElementaryType,
    },
    /// DINT for REAL, LINT for LREAL (ROUND and its kin, in some dialects TRUNC).
    OfArgument,
}

/// A type conversion function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ConversionFunction {
    /// The one parameter, which named arguments call `IN`.
    pub parameter: Parameter,
    /// The type of the result.
    pub result: ResultType,
    meaning: RuleLookup,
}

/// The way in which the rule is found once both types are known.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum RuleLookup {
    /// By the pair of types.
    Pair(ConversionChoices),
    /// One rule for all types.
    Always(ConversionRule),
}

const FROM_BCD: RuleLookup = RuleLookup::Always(ConversionRule::FromBcd);
const TO_BCD: RuleLookup = RuleLookup::Always(ConversionRule::ToBcd);

const fn giving(parameter: Parameter, to: ElementaryType, meaning: RuleLookup) -> ConversionFunction {
    ConversionFunction {
        parameter,
        result: ResultType::Exactly(to),
        meaning,
    }
}

const fn any_of(allowed: &'static [ElementaryType], default: ElementaryType) -> Parameter {
    Parameter::AnyOf { allowed, default }
}

const BITS: &[ElementaryType] = &[
    ElementaryType::Byte,
    ElementaryType::Word,
    ElementaryType::Dword,
    ElementaryType::Lword,
];
const UNSIGNED: &[ElementaryType] = &[
    ElementaryType::Usint,
    ElementaryType::Uint,
    ElementaryType::Udint,
    ElementaryType::Ulint,
];
const REALS: &[ElementaryType] = &[ElementaryType::Real, ElementaryType::Lreal];
/// The types that the ForgeIEC page lists for BCD_TO_INT and INT_TO_BCD.
const BCD_BITS: &[ElementaryType] = &[ElementaryType::Byte, ElementaryType::Word];
const BCD_INTEGERS: &[ElementaryType] = &[ElementaryType::Int, ElementaryType::Dint];

/// The types that the overloaded `TO_<DST>` takes, for each target in the order of [`ElementaryType::ALL`].
type SourceTypes = [Vec<ElementaryType>; ElementaryType::ALL.len()];

/// The types that `TO_<DST>` takes; no choice decides which pairs convert.
static SOURCES: LazyLock<SourceTypes> = LazyLock::new(|| {
    let converts = |from, to| ConversionRule::between(from, to, &COMMON_CHOICES).is_some();
    ElementaryType::ALL.map(|to| {
        let all = ElementaryType::ALL.into_iter();
        all.filter(|&from| converts(from, to)).collect()
    })
});

impl ConversionFunction {
    /// Returns whether the function takes an argument of exactly this type.
    pub fn accepts(&self, argument: ElementaryType) -> bool {
        match self.parameter {
            Parameter::Exactly(ty) => ty == argument,
            Parameter::AnyOf { allowed, .. } => allowed.contains(&argument),
        }
    }

    /// The type of the result for an argument's type and, where the call has one, its target's type.
    pub fn result_type(&self, argument: ElementaryType, target: Option<ElementaryType>) -> ElementaryType {
        match self.result {
            ResultType::Exactly(ty) => ty,
            ResultType::OfTarget { allowed, default } => {
                target.filter(|ty| allowed.contains(ty)).unwrap_or(default)
            }
            ResultType::OfArgument if argument == ElementaryType::Lreal => ElementaryType::Lint,
            ResultType::OfArgument => ElementaryType::Dint,
        }
    }

    /// The types that the result may have for an argument's type: one, or where the call's target decides each
    /// that it may ask for.
    pub fn results(&self, argument: ElementaryType) -> impl Iterator<Item = ElementaryType> + use<> {
        let several: &[_] = match self.result {
            ResultType::OfTarget { allowed, .. } => allowed,
            _ => &[],
        };
        let one = several.is_empty().then(|| self.result_type(argument, None));
        several.iter().copied().chain(one)
    }

    /// The conversion that a call performs. Takes the argument's type, which [`Self::accepts`] must allow, and
    /// the result's type as [`Self::result_type`] gives it; for other types it keeps the raw form.
    pub fn conversion(&self, argument: ElementaryType, result: ElementaryType) -> Conversion {
        let rule = match self.meaning {
            RuleLookup::Pair(choices) => ConversionRule::between(argument, result, &choices),
            RuleLookup::Always(rule) => Some(rule),
        };
        Conversion {
            from: argument,
            to: result,
            rule: rule.unwrap_or(ConversionRule::Keep),
        }
    }
}

/// The conversion function of one argument of this name, in any ASCII case; `None` where the dialect has none.
/// [`super::concatenation()`] finds the functions of two arguments.
///
/// | name | takes | gives |
/// |---|---|---|
/// | `<SRC>_TO_<DST>` | SRC | DST |
/// | `TO_<DST>` | any type that converts, or those that the dialect says | DST |
/// | `TRUNC` | REAL, LREAL | DINT; in some dialects LINT of an LREAL |
/// | `TRUNC_<INTEGER>` | REAL, LREAL | the integer |
/// | `<REAL>_TRUNC_<INTEGER>` | REAL or LREAL | the integer |
/// | `BCD_TO_INT` | BYTE, WORD | INT or DINT, by the target |
/// | `INT_TO_BCD` | INT, DINT | BYTE or WORD, by the target |
/// | `<BITS>_BCD_TO_<UNSIGNED>`, `BCD_TO_<UNSIGNED>` | a bit string | the integer |
/// | `<UNSIGNED>_TO_BCD_<BITS>`, `TO_BCD_<BITS>` | an unsigned integer | the bit string |
/// | `ROUND`, `CEIL`, `CEILING`, `FLOOR` | REAL, LREAL | DINT, LINT; DINT where the dialect says so |
/// | `ROUNDUP` where the dialect says so | REAL, LREAL | DINT, LINT |
/// | `ROUND_<NUMBER>` …, `TRUNC_<REAL>` where the dialect says so | REAL, LREAL | the number |
///
/// Basis: forgeiec-conversion-functions: The naming pattern; for the overloaded and BCD names of the third
/// edition iec-61131-3: data type conversion functions; for ROUND and its kin, which the ForgeIEC page says
/// do not exist, no source: they are open elsewhere, and round to even.
pub fn function(name: &str, dialect: &Dialect) -> Option<ConversionFunction> {
    // No name of the catalogue is longer; a hostile one is not worth upper-casing.
    const MAX_NAME_LEN: usize = "LDATE_AND_TIME_TO_LTIME_OF_DAY".len();
    let mut buffer = [0; MAX_NAME_LEN];
    let upper = buffer.get_mut(..name.len())?;
    upper.copy_from_slice(name.as_bytes());
    upper.make_ascii_uppercase();
    by_upper_case_name(str::from_utf8(upper).ok()?, dialect)
}

fn by_upper_case_name(name: &str, dialect: &Dialect) -> Option<ConversionFunction> {
    if let Some(found) = rounding_function(name, dialect) {
        return Some(found);
    }
    if let Some((from, to)) = name.split_once("_TRUNC_") {
        return truncation(
            Parameter::Exactly(elementary(from, dialect)?),
            elementary(to, dialect)?,
            dialect,
        );
    }
    if let Some(to) = name.strip_prefix("TO_") {
        return overloaded(to, dialect);
    }
    let (from, to) = name.split_once("_TO_")?;
    bcd(from, to).or_else(|| pair(elementary(from, dialect)?, elementary(to, dialect)?, dialect))
}

/// The elementary type of this name where the dialect has it.
fn elementary(name: &str, dialect: &Dialect) -> Option<ElementaryType> {
    let is_short = |ty: &ElementaryType| ty.name() == dialect.standard_name(name);
    dialect
        .elementary(name)
        .filter(|ty| dialect.may_name(*ty) && (dialect.long_names_convert || is_short(ty)))
}

/// `<SRC>_TO_<DST>`.
fn pair(from: ElementaryType, to: ElementaryType, dialect: &Dialect) -> Option<ConversionFunction> {
    let has_meaning = ConversionRule::between(from, to, &dialect.conversions).is_some();
    let meaning = RuleLookup::Pair(dialect.conversions);
    (from != to && has_meaning).then_some(giving(Parameter::Exactly(from), to, meaning))
}

/// `TO_<DST>`, `TO_BCD_<BITS>`.
fn overloaded(to: &str, dialect: &Dialect) -> Option<ConversionFunction> {
    if let Some(bits) = to.strip_prefix("BCD_") {
        let parameter = any_of(UNSIGNED, ElementaryType::Uint);
        return Some(giving(parameter, one_of(BITS, bits)?, TO_BCD));
    }
    let to = elementary(to, dialect)?;
    let allowed = match dialect.inputs.get(&to) {
        Some(&inputs) => inputs,
        None => SOURCES.get(to as usize)?,
    };
    let meaning = RuleLookup::Pair(dialect.conversions);
    Some(giving(any_of(allowed, ElementaryType::Dint), to, meaning))
}

/// TRUNC and its kin, ROUND and its kin.
fn rounding_function(name: &str, dialect: &Dialect) -> Option<ConversionFunction> {
    let any_real = any_of(REALS, ElementaryType::Real);
    let (stem, named) = match name.split_once('_') {
        Some((stem, to)) => {
            let to = elementary(to, dialect).filter(|ty| ty.is_number());
            (stem, Some(to?))
        }
        None => (name, None),
    };
    if name == "TRUNC" && dialect.long_truncation {
        return truncation(any_real, ElementaryType::Dint, dialect).map(|found| ConversionFunction {
            result: ResultType::OfArgument,
            ..found
        });
    }
    let rounding = match stem {
        "TRUNC" => Rounding::Truncate,
        "ROUND" => Rounding::HalfToEven,
        "CEIL" | "CEILING" => Rounding::Up,
        "FLOOR" => Rounding::Down,
        "ROUNDUP" if dialect.rounds_up => Rounding::AwayFromZero,
        _ => return None,
    };
    let to = named.unwrap_or(ElementaryType::Dint);
    if stem == "TRUNC" && to.is_integer() {
        return truncation(any_real, to, dialect);
    }
    let result = match named {
        None if !dialect.rounds_to_dint => ResultType::OfArgument,
        Some(_) if !dialect.rounds_to_dint => return None,
        _ => ResultType::Exactly(to),
    };
    let meaning = match to.is_real() {
        true => RuleLookup::Always(ConversionRule::ToWhole(rounding)),
        false => RuleLookup::Pair(dialect.conversions.with_rounding(rounding)),
    };
    dialect.rounding_functions.then_some(ConversionFunction {
        parameter: any_real,
        result,
        meaning,
    })
}

fn truncation(parameter: Parameter, to: ElementaryType, dialect: &Dialect) -> Option<ConversionFunction> {
    let takes_real = match parameter {
        Parameter::Exactly(from) => from.is_real(),
        Parameter::AnyOf { .. } => true,
    };
    let meaning = RuleLookup::Pair(dialect.conversions.of_truncation());
    (takes_real && to.is_integer()).then_some(giving(parameter, to, meaning))
}

/// The names with BCD in them, the overloaded `TO_BCD_<BITS>` aside.
fn bcd(from: &str, to: &str) -> Option<ConversionFunction> {
    match (from, to) {
        ("BCD", "INT") => Some(ConversionFunction {
            parameter: any_of(BCD_BITS, ElementaryType::Word),
            result: ResultType::OfTarget {
                allowed: BCD_INTEGERS,
                default: ElementaryType::Int,
            },
            meaning: FROM_BCD,
        }),
        ("INT", "BCD") => Some(ConversionFunction {
            parameter: any_of(BCD_INTEGERS, ElementaryType::Int),
            result: ResultType::OfTarget {
                allowed: BCD_BITS,
                default: ElementaryType::Word,
            },
            meaning: TO_BCD,
        }),
        ("BCD", to) => {
            let parameter = any_of(BITS, ElementaryType::Word);
            Some(giving(parameter, one_of(UNSIGNED, to)?, FROM_BCD))
        }
        _ => match from.strip_suffix("_BCD") {
            Some(bits) => {
                let parameter = Parameter::Exactly(one_of(BITS, bits)?);
                Some(giving(parameter, one_of(UNSIGNED, to)?, FROM_BCD))
            }
            None => {
                let parameter = Parameter::Exactly(one_of(UNSIGNED, from)?);
                Some(giving(parameter, one_of(BITS, to.strip_prefix("BCD_")?)?, TO_BCD))
            }
        },
    }
}

fn one_of(types: &[ElementaryType], name: &str) -> Option<ElementaryType> {
    ElementaryType::from_name(name).filter(|ty| types.contains(ty))
}

/// The name of the function that converts one type to another, for suggestions (`INT_TO_DINT`); `None` where
/// the dialect has none.
pub fn conversion_function_name(
    from: ElementaryType,
    to: ElementaryType,
    dialect: &Dialect,
) -> Option<String> {
    pair(from, to, dialect).filter(|_| dialect.may_name(from) && dialect.may_name(to))?;
    Some(format!("{}_TO_{}", from.name(), to.name()))
}
