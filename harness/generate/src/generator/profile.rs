//! The profile of a dialect, by its documents: types, implicit conversions, and conversion functions whose results are
//! settled.

use super::TypeContext;
use super::literals;
use crate::model::{BinaryOperator, Expression, ExpressionKind, Pou, StandardFunction, Type, UnaryOperator};
use crate::reader::standard_blocks;
use std::collections::HashMap;
use std::sync::{LazyLock, OnceLock, PoisonError, RwLock};
use stickler_exact::{ImplicitResult, Signature, expected, functions, implicit, implicit_result, signatures};
use stickler_types::dialect::{OperandTypes, ResultSigns};
use stickler_types::{Dialect, DialectName, ElementaryType, Family, MatrixWord, MomentUnits, Value};

/// The extent to which documents state the results of a conversion.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum ResultCoverage {
    /// Stated for every value that the generator draws.
    Always,
    /// Stated for some values.
    Sometimes,
    /// Stated for no value.
    Never,
}

/// A conversion function with one argument.
pub(crate) struct ConversionOffer {
    pub signature: Signature,
    pub from: ElementaryType,
    pub settled: ResultCoverage,
    /// Whether the function is `<FROM>_TO_<RESULT>`.
    pub plain: bool,
    /// Whether the call alone leaves its result type open: the name has signatures with other results.
    pub ambiguous: bool,
}

/// The types and conversions of one dialect.
pub(crate) struct DialectProfile {
    pub dialect: DialectName,
    /// The elementary types to draw from, INT first; frequent types occur several times.
    pub weighted_types: Vec<ElementaryType>,
    /// The types that convert implicitly to each type, indexed by [`ElementaryType`].
    sources: Vec<Vec<ElementaryType>>,
    /// The conversion functions that give each type, indexed by [`ElementaryType`].
    offers: Vec<Vec<ConversionOffer>>,
    standard_blocks: OnceLock<Vec<Pou>>,
}

/// The profiles of the dialects that were asked for. They live as long as the process.
static PROFILES: LazyLock<RwLock<HashMap<DialectName, &'static DialectProfile>>> =
    LazyLock::new(RwLock::default);

impl DialectProfile {
    pub fn of(dialect: DialectName) -> &'static DialectProfile {
        let known = PROFILES
            .read()
            .unwrap_or_else(PoisonError::into_inner)
            .get(&dialect)
            .copied();
        known.unwrap_or_else(|| {
            let mut profiles = PROFILES.write().unwrap_or_else(PoisonError::into_inner);
            profiles
                .entry(dialect)
                .or_insert_with(|| Box::leak(Box::new(DialectProfile::build(dialect))))
        })
    }

    /// Returns the standard function blocks.
    pub fn standard_blocks(&self) -> &[Pou] {
        self.standard_blocks.get_or_init(|| standard_blocks(self.dialect))
    }

    /// Returns the types that convert implicitly to `into`.
    pub fn sources(&self, into: ElementaryType) -> &[ElementaryType] {
        &self.sources[into as usize]
    }

    /// Returns the conversion functions that give a type, without the overloaded `TO_…`, which few systems describe.
    pub fn offers(&self, result: ElementaryType) -> &[ConversionOffer] {
        &self.offers[result as usize]
    }

    /// Returns the function `<FROM>_TO_<INTO>`, if its results are settled for every value that the generator draws.
    pub fn settled(&self, from: ElementaryType, into: ElementaryType) -> Option<&Signature> {
        let mut offers = self.offers(into).iter();
        let found =
            offers.find(|offer| offer.from == from && offer.plain && offer.settled == ResultCoverage::Always);
        found.map(|offer| &offer.signature)
    }

    /// Returns whether operators on two values of different types give the type of one of them. The types in which they meet otherwise are
    /// those of the system, so that no program has such operands.
    pub fn mixes_operands(&self) -> bool {
        self.dialect.rules().operands == OperandTypes::OneOfTheirs
    }

    /// Returns whether a result that leaves the range of this type may do so until it is stored: the system computes in a wider type.
    pub fn computes_wider(&self, ty: ElementaryType) -> bool {
        self.dialect.rules().operands == OperandTypes::Promoted && ty.is_whole() && ty.bits() < 32
    }

    /// Returns whether a literal beside an operand of this type needs its own: a number beyond 31 bits may be one of 64, in which an operation
    /// on promoted operands is computed then.
    pub fn types_operands(&self, ty: ElementaryType, context: TypeContext) -> bool {
        let is_promoted = self.dialect.rules().operands == OperandTypes::Promoted;
        is_promoted && context == TypeContext::Operand && ty.is_integer() && ty.bits() == 32
    }

    /// Returns whether AND, OR and XOR of two values of this type give a value of the type; where operands are promoted, it is an integer.
    pub fn keeps_bit_strings(&self, ty: ElementaryType) -> bool {
        self.dialect.rules().operands != OperandTypes::Promoted || !ty.is_bit_string()
    }

    /// Returns whether a minus sign gives a value of the type of its operand.
    pub fn negates(&self, ty: ElementaryType) -> bool {
        let keeps = self.dialect.rules().result_signs == ResultSigns::OfOperands;
        matches!(ty.family(), Family::Signed | Family::Real | Family::Duration) && (keeps || ty.bits() >= 16)
    }

    /// Returns whether an expression gives a value of the type that the model has for it, where the value is `stored` at once or where it is
    /// not.
    pub fn has_its_type(&self, expression: &Expression, stored: bool) -> bool {
        use BinaryOperator::{Add, And, Multiply, Or, Subtract, Xor};
        let Type::Elementary(ty) = expression.ty else {
            return true;
        };
        let wraps = stored || !self.computes_wider(ty);
        match &expression.kind {
            ExpressionKind::Unary(UnaryOperator::Negate, _) => wraps && self.negates(ty),
            ExpressionKind::Unary(UnaryOperator::Not, _) => wraps && (stored || self.keeps_bit_strings(ty)),
            ExpressionKind::Binary(And | Or | Xor, ..) => stored || self.keeps_bit_strings(ty),
            ExpressionKind::Binary(Add | Subtract | Multiply, ..)
            | ExpressionKind::Standard(StandardFunction::Shl, _) => wraps,
            _ => true,
        }
    }

    /// Returns whether the dialect has a value: no duration below 0 where durations are counts without a sign.
    pub fn holds(&self, value: &Value) -> bool {
        let is_count = self.dialect.rules().conversions.moment_units == MomentUnits::Counts;
        !matches!(*value, Value::Plain { ty, raw } if is_count && ty.is_duration() && raw.cast_signed() < 0)
    }

    /// Returns whether programs may access bits of integers and bit strings; in PLCnext and STruC++ that is open.
    pub fn has_bits(&self, open: bool) -> bool {
        self.dialect.rules().documents.bits || open && Dialect::of(self.dialect).bit_access
    }

    /// Returns whether a call of a function may omit inputs, which then have their initial values.
    ///
    /// Basis: iec-61131-3: 6.6.1 (formal calls); ironplc-problem-codes: P4018 speaks of the number of arguments and makes no
    /// difference for calls by names, and its compiler refuses them, so that it is open there.
    pub fn leaves_inputs_out(&self, open: bool) -> bool {
        open || self.dialect.rules().documents.inputs_left_out
    }

    /// Returns whether a literal without its prefix stands for a value of a type in a context. Literals whose form
    /// determines the type (`TRUE`, `T#5ms`, `'text'`) do so everywhere.
    ///
    /// Basis: ironplc-type-conversions: Cross-family widening; rule: literal-as-operand.
    pub fn takes_untyped(&self, ty: ElementaryType, context: TypeContext) -> bool {
        match ty.family() {
            Family::Boolean | Family::Text => true,
            Family::Duration | Family::Date | Family::TimeOfDay | Family::DateAndTime => true,
            // `'a'` may be a text of one character, and no document says whether it is a character as well.
            Family::Character => false,
            Family::Signed | Family::Unsigned | Family::Real => context != TypeContext::Exact,
            Family::BitString => match context {
                _ if !self.dialect.rules().documents.untyped_literals => false,
                TypeContext::Exact => false,
                TypeContext::Initial | TypeContext::Operand => true,
                _ => Dialect::of(self.dialect).integer_literal_as_bit_string,
            },
        }
    }

    fn build(dialect: DialectName) -> DialectProfile {
        let types = types(dialect);
        let sources = ElementaryType::ALL.map(|into| {
            // Where the matrix has a pair, a document may still not say what arrives.
            let is_settled = |from: ElementaryType| {
                let arrives =
                    |value| matches!(implicit_result(value, into), Some(ImplicitResult::Exactly(_)));
                literals::boundaries(from).iter().any(arrives)
            };
            let becomes = |from: &ElementaryType| {
                *from != into && implicit(*from, into, dialect) == MatrixWord::Yes && is_settled(*from)
            };
            types.iter().copied().filter(becomes).collect()
        });
        DialectProfile {
            dialect,
            weighted_types: weighted_types(&types),
            sources: sources.into(),
            offers: offers(dialect, &types),
            standard_blocks: OnceLock::new(),
        }
    }
}

/// Collects the conversion functions of a dialect by their results.
fn offers(dialect: DialectName, types: &[ElementaryType]) -> Vec<Vec<ConversionOffer>> {
    let mut offers: Vec<Vec<ConversionOffer>> = ElementaryType::ALL.map(|_| Vec::new()).into();
    for function in functions(dialect) {
        if function.starts_with("TO_") || dialect.rules().lacks(&function.to_ascii_lowercase()) {
            continue;
        }
        let signatures = signatures(&function, dialect);
        let results = signatures.iter().map(|signature| signature.result);
        let ambiguous = results
            .clone()
            .any(|result| Some(result) != results.clone().next());
        for signature in signatures {
            let &[from] = &signature.operands[..] else {
                continue;
            };
            if types.contains(&from) && types.contains(&signature.result) {
                offers[signature.result as usize].push(ConversionOffer {
                    settled: settled(&signature, from, dialect),
                    from,
                    ambiguous,
                    plain: function == format!("{from}_TO_{}", signature.result),
                    signature,
                });
            }
        }
    }
    offers
}

/// Returns the elementary types of a dialect that its documents or its compiler name.
///
/// Basis: that matiec has twenty types and no WSTRING is measured.
fn types(dialect: DialectName) -> Vec<ElementaryType> {
    let has = |ty: &ElementaryType| !dialect.rules().lacks(&ty.name().to_ascii_lowercase());
    ElementaryType::ALL.into_iter().filter(has).collect()
}

/// Repeats each type by its weight: conversions, widening and bits concern numbers and bit strings.
fn weighted_types(types: &[ElementaryType]) -> Vec<ElementaryType> {
    let mut weighted_types = vec![ElementaryType::Int];
    for &ty in types {
        let times = match ty.family() {
            Family::Signed | Family::Unsigned => 4,
            Family::BitString | Family::Real => 5,
            Family::Boolean => 6,
            Family::Text | Family::Duration => 2,
            _ => 1,
        };
        weighted_types.extend(std::iter::repeat_n(ty, times));
    }
    weighted_types
}

/// Measures how far documents state the results of a conversion, for the values that the generator draws and a real that no integer type holds,
/// which a product of them may be.
fn settled(signature: &Signature, from: ElementaryType, dialect: DialectName) -> ResultCoverage {
    let mut values = literals::boundaries(from).to_vec();
    if from.is_real() {
        values.push(Value::of_real(from, 1e30));
    }
    let said = |value| {
        expected(signature, std::slice::from_ref(value), dialect)
            .basis
            .is_some()
    };
    match values.iter().filter(|value| said(value)).count() {
        0 => ResultCoverage::Never,
        some if some == values.len() => ResultCoverage::Always,
        _ => ResultCoverage::Sometimes,
    }
}
