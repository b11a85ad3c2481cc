//! The operand types for which operators are defined, and the types of their results.
//!
//! Basis: rule: mixed-operands (one converts to the other, or nothing; no third type is sought);
//! iec-61131-3: the tables of the arithmetic, comparison, bitwise and time functions.

use super::common::TypeRules;
use super::contexts::elementary_value;
use super::inferred::Inferred;
use super::places::counting;
use super::types::{TypeId, TypeKind};
use crate::conversion::implicit;
use crate::instruction::{ArithmeticOperator, ComparisonOperator, LogicOperator};
use stickler_syntax::tree::BinaryOperator;
use stickler_types::dialect::ComparedTypes;
use stickler_types::{ElementaryType, Family};

/// An operator whose operands are known: what each is converted to, what is done, and what comes of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct TypedOperation {
    pub(super) left: TypeId,
    pub(super) right: TypeId,
    pub(super) action: Action,
    /// The type of the value that the machine has then; where operands are promoted, it is wider than the result.
    pub(super) computed: TypeId,
    pub(super) result: TypeId,
}

impl TypedOperation {
    /// An operation that the machine computes in the type of its result.
    fn new((left, right): (TypeId, TypeId), action: Action, result: TypeId) -> TypedOperation {
        TypedOperation {
            left,
            right,
            action,
            computed: result,
            result,
        }
    }
}

/// The action of an operator.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Action {
    Arithmetic(ArithmeticOperator, ElementaryType),
    /// A duration by a number of the type; `swapped` where the number stands on the left.
    Scale {
        operator: ArithmeticOperator,
        number: ElementaryType,
        swapped: bool,
    },
    Power {
        base: ElementaryType,
        exponent: ElementaryType,
    },
    /// An address moves by a number of variables of its type.
    Move(ArithmeticOperator),
    Compare(ComparisonOperator, ElementaryType),
    CompareText(ComparisonOperator),
    Logic(LogicOperator),
    /// The right operand is computed only where the left one does not decide; `decisive` is the value that does.
    ShortCircuit {
        decisive: bool,
    },
}

/// The meaning of an operator for operands of certain types.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum OperatorSignature {
    /// An operation of the machine.
    Defined(TypedOperation),
    /// Both operands, or the base of a power, are untyped literals, and so is the result.
    Untyped(Inferred),
    /// The operator is not defined for them.
    Undefined,
    /// Something has been said already.
    Silent,
}

impl TypeRules<'_> {
    /// Finds the meaning of an operator for its operands.
    pub(super) fn signature(
        self,
        operator: BinaryOperator,
        left: Inferred,
        right: Inferred,
    ) -> OperatorSignature {
        if let (Inferred::Error, _) | (_, Inferred::Error) = (left, right) {
            return OperatorSignature::Silent;
        }
        if let (Inferred::Enumerated, Inferred::Enumerated) = (left, right) {
            return OperatorSignature::Silent;
        }
        let is_pointer = |value| matches!(value, Inferred::Known(ty) if self.types.pointer(ty).is_some());
        let moves = self.dialect.pointers_count_variables && (is_pointer(left) || is_pointer(right));
        let unmoved = (left, right);
        let (left, right) = (self.address(left), self.address(right));
        let operation = match self.group(operator) {
            OperatorGroup::Arithmetic(arithmetic) if moves => self.moved(arithmetic, unmoved),
            OperatorGroup::Comparison(comparison) => self.comparison(comparison, left, right),
            OperatorGroup::ShortCircuit { decisive } => {
                let is_bool = |operand| operand == Inferred::Known(TypeId::BOOL);
                let operands = (TypeId::BOOL, TypeId::BOOL);
                let action = Action::ShortCircuit { decisive };
                (is_bool(left) && is_bool(right)).then(|| TypedOperation::new(operands, action, TypeId::BOOL))
            }
            OperatorGroup::Power if self.dialect.integers_as_lreal => self.power(left, right),
            // The exponent keeps a type of its own, so there is no operand whose type the base could take.
            OperatorGroup::Power if left == Inferred::Real && is_integer(right) => {
                return OperatorSignature::Untyped(Inferred::Real);
            }
            _ if left.is_untyped_number() && right.is_untyped_number() => {
                return match self.untyped(left, right) {
                    Inferred::Error => OperatorSignature::Undefined,
                    inferred => OperatorSignature::Untyped(inferred),
                };
            }
            OperatorGroup::Logic(logic) => self.logic(logic, left, right),
            OperatorGroup::Arithmetic(arithmetic) => self.arithmetic(arithmetic, left, right),
            OperatorGroup::Power => self.power(left, right),
        };
        operation.map_or(OperatorSignature::Undefined, OperatorSignature::Defined)
    }

    /// The operation on untyped operands that take a type from outside.
    pub(super) fn at(
        self,
        operator: BinaryOperator,
        right: Inferred,
        ty: ElementaryType,
    ) -> Option<TypedOperation> {
        let known = Inferred::from(ty);
        match self.group(operator) {
            OperatorGroup::Comparison(_) | OperatorGroup::ShortCircuit { .. } => None,
            OperatorGroup::Logic(logic) => self.logic(logic, known, known),
            OperatorGroup::Arithmetic(arithmetic) => self.arithmetic(arithmetic, known, known),
            OperatorGroup::Power => self.power(known, right),
        }
    }

    /// Returns the types as which a value of an interface is compared with another one, with NULL, or with the number 0, which is none.
    ///
    /// Basis: iec-61131-3: third edition, 6.6.6; codesys-pages: _cds_implementing_interface.
    fn addresses(self, left: Inferred, right: Inferred) -> Option<(TypeId, TypeId)> {
        let interface = |value| match value {
            Inferred::Known(ty) => self.types.is_interface(ty).then_some(ty),
            _ => None,
        };
        let beside = |value, other| match value {
            Inferred::Known(TypeId::ADDRESS) => Some(other),
            Inferred::Integer(_) => Some(TypeId::of(ElementaryType::Ulint)),
            _ => None,
        };
        match (interface(left), interface(right)) {
            (Some(one), Some(other)) => Some((one, other)),
            (Some(one), None) => Some((one, beside(right, one)?)),
            (None, Some(other)) => Some((beside(left, other)?, other)),
            (None, None) => None,
        }
    }

    fn comparison(
        self,
        operator: ComparisonOperator,
        left: Inferred,
        right: Inferred,
    ) -> Option<TypedOperation> {
        if let Some(sides) = self.addresses(left, right) {
            let is_equality = matches!(operator, ComparisonOperator::Equal | ComparisonOperator::NotEqual);
            let action = Action::Compare(operator, ElementaryType::Ulint);
            return is_equality.then(|| TypedOperation::new(sides, action, TypeId::BOOL));
        }
        let (left, right) = if left == right {
            (left, right)
        } else {
            (self.number(left), self.number(right))
        };
        if let Some(promoted) = self.promoted(left, right) {
            let action = Action::Compare(operator, promoted.computed);
            return Some(promoted.operation(action, TypeId::BOOL, TypeId::BOOL));
        }
        if self.dialect.compared == ComparedTypes::OfOneKind && !are_of_one_kind(left, right) {
            return None;
        }
        let common = self.common(left, right)?;
        let equality = matches!(
            operator,
            ComparisonOperator::Equal | ComparisonOperator::NotEqual | ComparisonOperator::LessOrGreater
        );
        let action = match (common.elementary(), self.types.kind(common)) {
            (Some(ty), _) if ty.is_text() => Action::CompareText(operator),
            (Some(ty), _) => Action::Compare(operator, ty),
            (None, TypeKind::Enumeration(_) | TypeKind::Pointer(_)) if equality => {
                Action::Compare(operator, ElementaryType::Lint)
            }
            _ => return None,
        };
        Some(TypedOperation::new((common, common), action, TypeId::BOOL))
    }

    /// Returns an address as the number that it may count as, and any other value as it is.
    fn address(self, value: Inferred) -> Inferred {
        match value {
            Inferred::Known(ty) if self.types.pointer(ty).is_some() => self.number(value),
            _ => value,
        }
    }

    /// Returns a value of an enumeration as the number that it may count as, and any other as it is.
    fn number(self, value: Inferred) -> Inferred {
        match value {
            Inferred::Known(ty) => {
                elementary_value(ty, self.types, self.dialect).map_or(value, Inferred::from)
            }
            _ => value,
        }
    }

    fn logic(self, operator: LogicOperator, left: Inferred, right: Inferred) -> Option<TypedOperation> {
        if let Some(promoted) = self.promoted(left, right)
            && promoted.result.is_integer()
            && (is_integer(left) || is_integer(right))
        {
            return Some(promoted.bits().of_numbers(Action::Logic(operator)));
        }
        let common = self.common(left, right)?;
        let ty = common.elementary()?;
        (ty == ElementaryType::Bool || ty.is_bit_string()).then_some(TypedOperation::new(
            (common, common),
            Action::Logic(operator),
            common,
        ))
    }

    fn arithmetic(
        self,
        operator: ArithmeticOperator,
        left: Inferred,
        right: Inferred,
    ) -> Option<TypedOperation> {
        if let Some(operation) = self
            .scale(operator, left, right)
            .or_else(|| self.moment(operator, left, right))
        {
            return Some(operation);
        }
        if let Some(promoted) = self.promoted(left, right) {
            return Some(promoted.of_numbers(Action::Arithmetic(operator, promoted.computed)));
        }
        let common = self.common(left, right)?;
        let ty = common.elementary()?;
        let additive = matches!(operator, ArithmeticOperator::Add | ArithmeticOperator::Subtract);
        let defined = match ty.family() {
            Family::Signed | Family::Unsigned => true,
            Family::Real => !matches!(
                operator,
                ArithmeticOperator::Modulo | ArithmeticOperator::ModuloOrZero
            ),
            Family::Duration => additive,
            _ => false,
        };
        let action = Action::Arithmetic(operator, ty);
        defined.then_some(TypedOperation::new((common, common), action, common))
    }

    /// Returns the type in which two integers or bit strings meet for the checker, where the dialect promotes operands.
    pub(super) fn meeting(
        self,
        operator: BinaryOperator,
        left: Inferred,
        right: Inferred,
    ) -> Option<ElementaryType> {
        let promoted = self.promoted(left, right)?;
        match self.group(operator) {
            OperatorGroup::Logic(_) => Some(promoted.bits().result),
            OperatorGroup::Arithmetic(_) | OperatorGroup::Comparison(_) => Some(promoted.result),
            OperatorGroup::Power | OperatorGroup::ShortCircuit { .. } => None,
        }
    }

    /// A duration multiplied or divided by a number, or a number by which a duration is multiplied.
    fn scale(self, operator: ArithmeticOperator, left: Inferred, right: Inferred) -> Option<TypedOperation> {
        let is_number = |ty: ElementaryType| ty.is_real() || counting(ty, self.dialect).is_some();
        let (duration, number, swapped) = match (left.elementary(), right.elementary()) {
            (Some(ty), other) if ty.is_duration() && other.is_none_or(is_number) => (ty, right, false),
            (other, Some(ty)) if ty.is_duration() && other.is_none_or(is_number) => (ty, left, true),
            _ => return None,
        };
        let defined = match operator {
            ArithmeticOperator::Multiply => true,
            ArithmeticOperator::Divide | ArithmeticOperator::DivideOrStop => !swapped,
            _ => false,
        };
        let number = match number {
            Inferred::Integer(magnitude) => magnitude.ty(),
            Inferred::Real => ElementaryType::Lreal,
            _ => number.elementary()?,
        };
        let (duration, factor) = (TypeId::of(duration), TypeId::of(number));
        let (left, right) = if swapped {
            (factor, duration)
        } else {
            (duration, factor)
        };
        let action = Action::Scale {
            operator,
            number: counting(number, self.dialect).unwrap_or(number),
            swapped,
        };
        defined.then_some(TypedOperation::new((left, right), action, duration))
    }

    /// An address to which the number of variables is added by which it moves, or from which it is taken.
    ///
    /// Basis: strucpp-tests: src/runtime/include/iec_ptr.hpp.
    fn moved(self, operator: ArithmeticOperator, sides: (Inferred, Inferred)) -> Option<TypedOperation> {
        let (Inferred::Known(address), right) = sides else {
            return None;
        };
        let is_known = address != TypeId::ADDRESS && self.types.pointer(address).is_some();
        let additive = matches!(operator, ArithmeticOperator::Add | ArithmeticOperator::Subtract);
        let sides = (address, TypeId::of(ElementaryType::Lint));
        let counts = |ty| counting(ty, self.dialect).is_some();
        let is_number = matches!(right, Inferred::Integer(_)) || right.elementary().is_some_and(counts);
        (is_known && additive && is_number)
            .then(|| TypedOperation::new(sides, Action::Move(operator), address))
    }

    /// Differences of dates and times of day, and a duration added to one or taken from it.
    fn moment(self, operator: ArithmeticOperator, left: Inferred, right: Inferred) -> Option<TypedOperation> {
        let (from, by) = (left.elementary()?, right.elementary()?);
        if !from.is_date_or_time() {
            return None;
        }
        if by.is_date_or_time() {
            let common = self.common_of_known(TypeId::of(from), TypeId::of(by))?;
            let result = duration_of(common.elementary()?);
            let action = Action::Arithmetic(operator, result);
            return (operator == ArithmeticOperator::Subtract).then_some(TypedOperation::new(
                (common, common),
                action,
                TypeId::of(result),
            ));
        }
        let takes_duration = matches!(from.family(), Family::TimeOfDay | Family::DateAndTime);
        let additive = matches!(operator, ArithmeticOperator::Add | ArithmeticOperator::Subtract);
        let duration = duration_of(from);
        implicit(by, duration, self.dialect).filter(|_| by.is_duration())?;
        (takes_duration && additive).then_some(TypedOperation::new(
            (TypeId::of(from), TypeId::of(duration)),
            Action::Arithmetic(operator, from),
            TypeId::of(from),
        ))
    }

    /// The base's type is the result's; the exponent is any number. An integer is the base of a real exponent as the real that it converts to.
    fn power(self, left: Inferred, right: Inferred) -> Option<TypedOperation> {
        if self.dialect.integers_as_lreal {
            return self.long_power(left, right);
        }
        let exponent = match right {
            Inferred::Integer(magnitude) => magnitude.ty(),
            Inferred::Real => left
                .elementary()
                .filter(|ty| ty.is_real())
                .unwrap_or(ElementaryType::Lreal),
            _ => right.elementary().filter(|&ty| ty.is_number())?,
        };
        let base = match left {
            Inferred::Integer(_) if exponent.is_real() && !self.dialect.integer_literal_as_real => {
                return None;
            }
            Inferred::Integer(_) => exponent,
            Inferred::Real if exponent.is_real() => exponent,
            Inferred::Real => ElementaryType::Lreal,
            _ => {
                let base = left.elementary().filter(|&ty| ty.is_number())?;
                let mut reals = [exponent, ElementaryType::Lreal].into_iter();
                let real = reals.find(|&real| {
                    exponent.is_real() && base.is_integer() && implicit(base, real, self.dialect).is_some()
                });
                real.unwrap_or(base)
            }
        };
        Some(TypedOperation::new(
            (TypeId::of(base), TypeId::of(exponent)),
            Action::Power { base, exponent },
            TypeId::of(base),
        ))
    }

    /// The power of two REAL is one, and that of any other numbers an LREAL.
    fn long_power(self, left: Inferred, right: Inferred) -> Option<TypedOperation> {
        let is_real = |value: Inferred| value.elementary() == Some(ElementaryType::Real);
        let is_taken = |value: Inferred| {
            value.is_untyped_number() || value.elementary().is_some_and(ElementaryType::is_number)
        };
        let is_short = is_real(left) && (is_real(right) || right == Inferred::Real)
            || is_real(right) && left == Inferred::Real;
        let ty = [ElementaryType::Lreal, ElementaryType::Real][usize::from(is_short)];
        let (base, exponent) = (ty, ty);
        (is_taken(left) && is_taken(right)).then_some(TypedOperation::new(
            (TypeId::of(ty), TypeId::of(ty)),
            Action::Power { base, exponent },
            TypeId::of(ty),
        ))
    }

    /// Returns what an operator does in the dialect.
    fn group(self, operator: BinaryOperator) -> OperatorGroup {
        match operator {
            BinaryOperator::Or => OperatorGroup::Logic(LogicOperator::Or),
            BinaryOperator::Xor => OperatorGroup::Logic(LogicOperator::Xor),
            BinaryOperator::And => OperatorGroup::Logic(LogicOperator::And),
            BinaryOperator::OrElse => OperatorGroup::ShortCircuit { decisive: true },
            BinaryOperator::AndThen => OperatorGroup::ShortCircuit { decisive: false },
            BinaryOperator::Equal => OperatorGroup::Comparison(ComparisonOperator::Equal),
            BinaryOperator::NotEqual if !self.dialect.nan_differs => {
                OperatorGroup::Comparison(ComparisonOperator::LessOrGreater)
            }
            BinaryOperator::NotEqual => OperatorGroup::Comparison(ComparisonOperator::NotEqual),
            BinaryOperator::Less => OperatorGroup::Comparison(ComparisonOperator::Less),
            BinaryOperator::Greater => OperatorGroup::Comparison(ComparisonOperator::Greater),
            BinaryOperator::LessOrEqual => OperatorGroup::Comparison(ComparisonOperator::LessOrEqual),
            BinaryOperator::GreaterOrEqual => OperatorGroup::Comparison(ComparisonOperator::GreaterOrEqual),
            BinaryOperator::Add => OperatorGroup::Arithmetic(ArithmeticOperator::Add),
            BinaryOperator::Subtract => OperatorGroup::Arithmetic(ArithmeticOperator::Subtract),
            BinaryOperator::Multiply => OperatorGroup::Arithmetic(ArithmeticOperator::Multiply),
            BinaryOperator::Divide if self.dialect.division_stops => {
                OperatorGroup::Arithmetic(ArithmeticOperator::DivideOrStop)
            }
            BinaryOperator::Divide => OperatorGroup::Arithmetic(ArithmeticOperator::Divide),
            BinaryOperator::Modulo if self.dialect.modulo_by_zero_is_zero => {
                OperatorGroup::Arithmetic(ArithmeticOperator::ModuloOrZero)
            }
            BinaryOperator::Modulo => OperatorGroup::Arithmetic(ArithmeticOperator::Modulo),
            BinaryOperator::Power => OperatorGroup::Power,
        }
    }
}

fn is_integer(value: Inferred) -> bool {
    match value {
        Inferred::Integer(_) => true,
        _ => value.elementary().is_some_and(ElementaryType::is_integer),
    }
}

/// The duration that two dates or times of day are apart.
fn duration_of(moment: ElementaryType) -> ElementaryType {
    match moment.is_third_edition() {
        true => ElementaryType::Ltime,
        false => ElementaryType::Time,
    }
}

/// Returns whether two operands are both bit strings, both integers with a sign, both integers without, or numbers of which one is a real. An untyped
/// literal is of each kind, and so is what is neither number nor bit string.
fn are_of_one_kind(left: Inferred, right: Inferred) -> bool {
    let is_of_a_kind = |ty: &ElementaryType| ty.is_number() || ty.is_bit_string();
    let kind = |value: Inferred| value.elementary().filter(is_of_a_kind);
    let (Some(left), Some(right)) = (kind(left), kind(right)) else {
        return true;
    };
    left.family() == right.family()
        || (left.is_number() && right.is_number() && (left.is_real() || right.is_real()))
}

enum OperatorGroup {
    Arithmetic(ArithmeticOperator),
    Comparison(ComparisonOperator),
    Logic(LogicOperator),
    ShortCircuit { decisive: bool },
    Power,
}
