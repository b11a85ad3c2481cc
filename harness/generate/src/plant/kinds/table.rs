//! The table of the kinds of errors.

use super::super::fault_site::FaultSite;
use super::{
    bits, blocks, calls, constants, declarations, literals, misfits, names, omitted_conversions, operands,
    statements,
};
use stickler_types::Code;

/// A kind of error.
pub(in super::super) struct FaultKind {
    /// The kind of the error in a few words.
    pub name: &'static str,
    /// The code of the diagnostic.
    pub code: Code,
    /// The function that plants the error; `None` if the program has no place for it, and then the [`FaultSite`] is of no
    /// further use.
    pub plant: fn(&mut FaultSite<'_, '_>) -> Option<()>,
}

/// Builds the table from one line a kind.
macro_rules! kinds {
    ($($code:ident $name:literal $room:ident::$plant:ident;)*) => {
        &[$(FaultKind { name: $name, code: Code::$code, plant: $room::$plant },)*]
    };
}

/// Every kind, in the order of what is wrong: types, operators, literals, names, calls, bits, statements, texts, declarations.
///
/// Basis: ironplc-problem-codes, rule: code-of-the-context; each function names the rest.
pub(in super::super) const KINDS: &[FaultKind] = kinds! {
    AssignmentTypeMismatch "a value of another type assigned" misfits::assigned;
    AssignmentTypeMismatch "a value of another type for a result" misfits::result;
    FunctionCallReturnTypeMismatch "a call of another type assigned" misfits::call_assigned;
    InitializerTypeMismatch "an initial value of another type" misfits::initial;
    FunctionCallArgTypeMismatch "an argument of another type" misfits::argument;
    FunctionCallArgTypeMismatch "an input of another type" misfits::input;
    FunctionCallArgTypeMismatch "an argument of another type than the conversion's" misfits::converted;
    FunctionCallArgTypeMismatch "an argument of another type than the standard function's" misfits::standard;
    FunctionCallArgTypeMismatch "an argument of another type in the call of a standard function alone" misfits::of_call_alone;
    ConditionTypeInvalid "an IF whose condition is no BOOL" misfits::condition_of_if;
    ConditionTypeInvalid "an ELSIF whose condition is no BOOL" misfits::condition_of_elsif;
    ConditionTypeInvalid "a WHILE whose condition is no BOOL" misfits::condition_of_while;
    ConditionTypeInvalid "a REPEAT whose condition is no BOOL" misfits::condition_of_repeat;
    CaseSelectorTypeInvalid "a selector that is no integer" misfits::selector;
    AssignmentTypeMismatch "a subscript that is no integer" misfits::subscript;
    AssignmentTypeMismatch "a bound of FOR that is no integer" misfits::bound;
    AssignmentTypeMismatch "a conversion left out of an assignment" omitted_conversions::conversion_left_out_of_assignment;
    FunctionCallArgTypeMismatch "a conversion left out of an argument" omitted_conversions::conversion_left_out_of_argument;
    ConditionTypeInvalid "a conversion left out of a condition" omitted_conversions::conversion_left_out_of_condition;
    OperatorOperandTypeMismatch "a conversion left out of an operand" omitted_conversions::conversion_left_out_of_operand;
    OperatorOperandTypeMismatch "operands with no type in common" operands::operand;
    OperatorOperandTypeMismatch "an operator with one operand of a wrong type" operands::only_operand;
    OperatorOperandTypeMismatch "an operation that the type does not have" operands::undefined_operation;
    OperatorOperandTypeMismatch "aggregates compared" operands::compared_aggregates;
    ConstantOverflow "an integer literal outside its target" literals::integer_for_target;
    ConstantOverflow "an integer literal outside the other operand's type" literals::integer_for_operand;
    ConstantOverflow "a label outside the selector's type" literals::integer_for_label;
    ConstantOverflow "a literal with too many bits" literals::bits_for_target;
    ConstantOverflow "a typed integer literal outside its type" literals::typed_integer;
    RealLiteralOutOfRange "a real literal outside its type" literals::real;
    DateLiteralOutOfRange "a day that does not exist" literals::date;
    DurationLiteralOutOfRange "a duration too long" literals::duration;
    ConstantExpressionDivisionByZero "a constant division by zero" literals::division_by_zero;
    ConstantExpressionOverflow "a constant beyond its type" literals::overflow;
    ConstantExpressionOverflow "an untyped constant beyond its target" literals::untyped_overflow;
    ArrayIndexOutOfBounds "a constant subscript outside the array" literals::subscript;
    StringLiteralCharOutOfRange "a character that a STRING does not have" literals::character;
    InvalidStringEscape "an escape that does not exist" literals::escape;
    VariableUndefined "an unknown variable read" names::variable_read;
    VariableUndefined "an unknown variable assigned" names::variable_assigned;
    VariableUndefined "an unknown variable as initial value" names::initial;
    VariableUndefined "an unknown field" names::field;
    FunctionCallUndeclared "an unknown function" names::function;
    FunctionBlockNotInScope "a call of what is no instance" names::no_instance;
    EnumValueNotDefined "an unknown enumerated value" names::enumerated_value;
    AssignmentTypeMismatch "a value of another enumeration" names::other_enumeration;
    EnumNotDeclared "an unknown enumeration" names::enumeration;
    UndeclaredUnknownType "an unknown type" names::type_name;
    SymbolDeclDuplicated "a variable declared twice" names::variable_twice;
    FunctionDeclNameDuplicated "a function declared twice" names::function_twice;
    PouDeclNameDuplicated "a function block declared twice" names::block_twice;
    DefinitionNameDuplicated "two kinds of things of one name" names::two_kinds_of_one_name;
    TypeDeclNameDuplicated "a type declared twice" names::type_twice;
    StructureDuplicatedElement "a field declared twice" names::field_twice;
    EnumTypeDeclDuplicateItem "an enumerated value declared twice" names::enumerated_value_twice;
    FunctionCallWrongArgCount "an argument too many" calls::argument_too_many;
    FunctionCallWrongArgCount "an argument too few" calls::argument_too_few;
    FunctionCallWrongArgCount "a standard function with a wrong number of arguments" calls::standard_argument;
    FunctionCallWrongArgCount "a conversion function with a wrong number of arguments" calls::conversion_argument;
    FunctionCallNamedArgUndeclared "an argument by an unknown name" calls::unknown_name;
    FunctionCallDuplicateNamedArg "an argument given twice" calls::name_twice;
    FunctionCallMixedArgTypes "arguments by name and by position" calls::mixed;
    RecursiveCycle "a function that calls itself" calls::recursive_function;
    RecursiveCycle "a function block that holds itself" calls::recursive_block;
    FunctionCallNamedArgUndeclared "an unknown input" blocks::unknown_input;
    FunctionCallDuplicateNamedArg "an input given twice" blocks::input_twice;
    FunctionInvocationUndefinedOutput "an unknown output" blocks::unknown_output;
    AssignmentTypeMismatch "an output taken by another type" blocks::output_taken;
    FunctionInvocationRequiresFormal "too many inputs by position" blocks::too_many_by_position;
    FunctionCallInOutArgNotVariable "a VAR_IN_OUT that is no variable" blocks::no_variable;
    FunctionCallInOutArgTypeMismatch "a VAR_IN_OUT of another type" blocks::other_type;
    InOutArgNotWritable "a VAR_IN_OUT that is constant" blocks::constant;
    AssignmentToConstant "a constant assigned" constants::assigned;
    AssignmentToConstant "a part of a constant assigned" constants::part_assigned;
    BitAccessOutOfRange "a bit outside its type read" bits::outside_read;
    BitAccessOutOfRange "a bit outside its type written" bits::outside_written;
    BitAccessTypeInvalid "a bit of what has none read" bits::none_read;
    BitAccessTypeInvalid "a bit of what has none written" bits::none_written;
    PartialAccessSyntaxDisabled "a bit by partial access" bits::percent_disabled;
    PartialAccessSyntaxDisabled "a byte by partial access" bits::wider_disabled;
    UnexpectedToken "a byte by partial access to bits only" bits::wider_unsupported;
    SyntaxError "a bit in matiec" bits::in_matiec;
    ExitOutsideLoop "an EXIT outside a loop" statements::exit;
    ContinueOutsideLoop "a CONTINUE outside a loop" statements::continue_;
    CaseLabelRangeInvalid "labels that descend" statements::descending_labels;
    OpenComment "an open comment" statements::open_comment;
    SyntaxError "a statement that is none" statements::no_statement;
    UnexpectedToken "characters that are no token" statements::no_token;
    CStyleComment "a comment to the end of the line" statements::line_comment;
    SyntaxError "a declaration that is none" declarations::no_colon;
    Std2013Feature "a type of the third edition" declarations::third_edition;
    ArrayDimensionInvalid "an array whose limits descend" declarations::limits_descend;
    ArraySizeOverflow "an array too large" declarations::too_large;
    SubrangeMinStrictlyLessMax "a subrange that descends" declarations::subrange_descends;
    SubrangeOutOfBounds "a subrange beyond its type" declarations::subrange_outside;
    SubrangeBaseTypeNotNumeric "a subrange of no integer" declarations::subrange_of_no_integer;
    StringLengthOutOfRange "a string too long" declarations::too_long;
    ConstantMustHaveInitializer "a constant without a value" declarations::no_value;
    FunctionBlockNotConstant "an instance that is constant" declarations::constant_instance;
    FunctionBlockInFunction "an instance in a function" declarations::instance_in_function;
};
