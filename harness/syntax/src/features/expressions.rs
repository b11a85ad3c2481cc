//! The features of expressions: literals, operators, calls and parts of variables.

use super::FeatureFinder;
use crate::names::DeclaredKind;
use crate::source::Span;
use crate::tree::{
    Argument, BinaryOperator, CaseFolded, Expression, ExpressionId, ExpressionKind, Literal, LiteralKind,
    PouKind, TypeSpecificationKind, UnaryOperator, own_instance,
};
use crate::visitor::Context;
use stickler_types::ElementaryType;

impl<'t, 's> FeatureFinder<'t, 's> {
    /// Notes the features of an expression itself; `around` is the one that it is a part of.
    pub(super) fn expression_features(
        &mut self,
        expression: &Expression<'s>,
        around: Option<&Expression<'s>>,
        at: &Context<'t, 's>,
    ) {
        use ExpressionKind::{
            Aggregate, Assigned, Binary, Bit, Call, Dereference, EnumeratedValue, Error, Field, Index,
            Literal, Name, Parenthesized, Part, Unary,
        };
        use PouKind::{Getter, Setter};
        let span = expression.span;
        let key = match expression.kind {
            Literal(ref literal) => return self.literal(literal, expression),
            Call {
                callee,
                ref arguments,
            } => return self.call(callee, arguments, expression, at),
            Name(name) => match self.declared(name.text) {
                Some(DeclaredKind::EnumeratedValue) => "enumerated-value",
                None if name.text.eq_ignore_ascii_case("NULL") => "null",
                _ => {
                    self.own_instance(name.text, span);
                    return;
                }
            },
            EnumeratedValue(_) => "enumerated-value-typed",
            Field { field, .. }
                if matches!(
                    self.declared(field.text),
                    Some(DeclaredKind::Pou(Getter | Setter))
                ) =>
            {
                return;
            }
            Field { base, .. } => {
                let name = self.name_of(base, at);
                let is_output = || name.is_some_and(|name| self.block_of(name).is_some());
                match name.and_then(|name| self.qualifier(name)) {
                    Some(key) => key,
                    None if is_output() => "function-block-output",
                    None => "field",
                }
            }
            Index { base, .. } if self.is_text(base, at) => "text-element",
            Index { .. } => "array-element",
            Dereference { .. } => "dereference",
            Assigned { .. } => "assignment-expression",
            Bit { .. } if !span.text(self.text).contains('%') => "bit-access",
            Unary { operator, .. } => match operator {
                UnaryOperator::Negate if self.negates_literal(expression, at) => return,
                UnaryOperator::Negate => "negation",
                UnaryOperator::Plus => "unary-plus",
                UnaryOperator::Not => "not",
            },
            Binary {
                operator,
                left,
                right,
            } => {
                use BinaryOperator::{Add, Subtract};
                let is_pointer = |id| self.name_of(id, at).is_some_and(|name| self.is_pointer(name));
                let is_address =
                    matches!(operator, Add | Subtract) && (is_pointer(left) || is_pointer(right));
                if is_address {
                    "pointer-arithmetic"
                } else {
                    operator_key(operator)
                }
            }
            Parenthesized(_) if !around.is_some_and(|around| matches!(around.kind, Call { .. })) => {
                "parentheses"
            }
            Parenthesized(_) | Aggregate(_) | Bit { .. } | Part { .. } | Error => return,
        };
        self.note(key, span);
    }

    /// Returns the feature of a name behind that of an enumeration, or behind one that the program does not declare; `None` behind others.
    fn qualifier(&self, name: &str) -> Option<&'static str> {
        match self.declared(name) {
            None if self.namespaces.has(name) => None,
            Some(DeclaredKind::Type) => Some("enumerated-value-qualified"),
            Some(_) => None,
            None => (own_instance(name).is_none()).then_some("qualified-name"),
        }
    }

    /// Returns the name behind that of a library; `None` where an expression is something else.
    fn behind_library(&self, id: ExpressionId, at: &Context<'t, 's>) -> Option<&'s str> {
        let ExpressionKind::Field { base, field } = at.unit.expression(id)?.kind else {
            return None;
        };
        let library = self.name_of(base, at)?;
        let is_known = self.declared(library).is_some() || self.namespaces.has(library);
        (!is_known && own_instance(library).is_none()).then_some(field.text)
    }

    /// Returns whether an expression is a variable or a field that the program declares as a text.
    fn is_text(&self, id: ExpressionId, at: &Context<'t, 's>) -> bool {
        use TypeSpecificationKind::{Named, Text};
        let name = match at.unit.expression(id).map(|expression| &expression.kind) {
            Some(ExpressionKind::Name(name) | ExpressionKind::Field { field: name, .. }) => name.text,
            _ => return false,
        };
        // A name may stand for a text in one unit and for an array in another.
        let mut own = at
            .pou
            .iter()
            .flat_map(|pou| &pou.blocks)
            .flat_map(|block| &block.groups);
        let own = own.find(|group| group.names.iter().any(|one| one.text.eq_ignore_ascii_case(name)));
        let anywhere = || self.types.get(&CaseFolded(name)).copied();
        let declared = own.map(|group| &group.specification).or_else(anywhere);
        match declared.map(|ty| &ty.kind) {
            Some(Named(ty)) => ElementaryType::from_name(ty.text).is_some_and(ElementaryType::is_text),
            other => matches!(other, Some(Text { .. })),
        }
    }

    /// Returns the name that an expression is; `None` where it is something else.
    fn name_of(&self, id: ExpressionId, at: &Context<'t, 's>) -> Option<&'s str> {
        match at.unit.expression(id)?.kind {
            ExpressionKind::Name(name) => Some(name.text),
            _ => None,
        }
    }

    /// Notes a name that stands for the instance whose code is running; says whether it is one.
    fn own_instance(&mut self, name: &str, span: Span) -> bool {
        let Some(word) = own_instance(name).filter(|_| self.declared(name).is_none()) else {
            return false;
        };
        self.note_if(name.ends_with('^'), "pointer-to-this", span);
        self.note(if word == "THIS" { "this" } else { "super" }, span);
        true
    }

    /// Returns whether a minus stands before an untyped number, as a part of which it is understood.
    fn negates_literal(&self, expression: &Expression<'s>, at: &Context<'t, 's>) -> bool {
        let ExpressionKind::Unary { operand, .. } = expression.kind else {
            return false;
        };
        let operand = at.unit.expression(operand).map(|operand| &operand.kind);
        matches!(operand, Some(ExpressionKind::Literal(literal)) if literal.prefix().is_none())
    }

    fn call(
        &mut self,
        callee: ExpressionId,
        arguments: &[Argument<'s>],
        call: &Expression<'s>,
        at: &Context<'t, 's>,
    ) {
        let span = call.span;
        let mut given = 0;
        for argument in arguments {
            let controls = self.controls_execution(argument);
            self.note_if(controls, "execution-control", span);
            given += usize::from(!controls && !matches!(argument, Argument::Output { .. }));
            match argument {
                Argument::Positional(_) => {}
                Argument::Named { .. } => self.note("named-argument", span),
                Argument::Output { negated, .. } => {
                    self.note("output-argument", span);
                    self.note_if(*negated, "output-argument-negated", span);
                }
            }
        }
        let library = self.behind_library(callee, at);
        self.note_if(library.is_some(), "qualified-name", span);
        let name = match at.unit.expression(callee).map(|callee| &callee.kind) {
            Some(ExpressionKind::Name(name)) if self.own_instance(name.text, span) => None,
            Some(ExpressionKind::Name(name)) => Some(name.text),
            Some(ExpressionKind::Field { field, .. }) if self.declared(field.text).is_some() => {
                Some(field.text)
            }
            _ => library,
        };
        let block = name.and_then(|name| self.block_of(name));
        match name.and_then(|name| self.declared(name)) {
            Some(DeclaredKind::Pou(PouKind::Function)) => self.note("function-call", span),
            Some(DeclaredKind::Pou(PouKind::Method)) => self.note("method-call", span),
            None if name.is_some() => return self.standard_call(name.unwrap_or_default(), call, at),
            _ => self.note("function-block-call", span),
        }
        let inputs = self.inputs.get(&CaseFolded(block.or(name).unwrap_or_default()));
        self.note_if(
            inputs.is_some_and(|&inputs| given < inputs),
            "input-left-out",
            span,
        );
    }

    /// Returns whether an argument is EN or ENO, which the program does not declare.
    fn controls_execution(&self, argument: &Argument<'s>) -> bool {
        let name = match argument {
            Argument::Positional(_) => return false,
            Argument::Named { name, .. } if name.text.eq_ignore_ascii_case("EN") => name,
            Argument::Output { name, .. } if name.text.eq_ignore_ascii_case("ENO") => name,
            _ => return false,
        };
        self.declared(name.text).is_none()
    }

    /// Notes the call of a function that the program does not declare.
    fn standard_call(&mut self, name: &str, call: &Expression<'s>, at: &Context<'t, 's>) {
        let dialect = self.dialect;
        let upper = dialect.standard_name(name).to_ascii_uppercase();
        let elementary = |name: &str| dialect.elementary(name);
        let has = |word: &str| upper.split('_').any(|part| part == word);
        let parts_are_types = || upper.split('_').skip(1).all(|part| elementary(part).is_some());
        let rounds = || ["ROUND", "CEIL", "CEILING", "FLOOR"].into_iter().any(has);
        if let Some(family) = family(&upper) {
            return self.note(family, call.span);
        }
        if let ("REF" | "ADR", ExpressionKind::Call { arguments, .. }) = (upper.as_str(), &call.kind)
            && let [Argument::Positional(operand)] = arguments[..]
        {
            use ExpressionKind::{Field, Index};
            let operand = at.unit.expression(operand).map(|operand| &operand.kind);
            let is_part = matches!(operand, Some(Field { .. } | Index { .. }));
            self.note_if(is_part, "reference-to-part", call.span);
        }
        let key = match upper.split_once("_TO_") {
            Some(("BCD", _) | (_, "BCD")) => "conversion-bcd-one-type",
            _ if has("BCD") => "conversion-bcd",
            Some((from, to)) if elementary(from).is_some() && elementary(to).is_some() => "conversion",
            _ if has("TRUNC") && upper != "TRUNC" => "trunc-typed",
            _ if upper.contains('_') && rounds() && parts_are_types() => "rounding-typed",
            _ if upper.starts_with("TO_") && parts_are_types() => "conversion-overloaded",
            // The name alone is the key of the operator.
            _ if ["ADD", "AND", "MOD", "NOT", "OR", "XOR"].contains(&upper.as_str()) => {
                return self.note(format!("{}-function", upper.to_ascii_lowercase()), call.span);
            }
            _ => return self.note(upper.to_ascii_lowercase(), call.span),
        };
        self.note(key, call.span);
    }

    fn literal(&mut self, literal: &Literal<'s>, expression: &Expression<'s>) {
        let span = expression.span;
        let prefix = literal.prefix();
        let ty = prefix.and_then(|prefix| ElementaryType::from_literal_prefix(prefix.text));
        let is_long = ty.is_some_and(ElementaryType::is_third_edition);
        let text = literal.text();
        let is_signed = text.starts_with(['-', '+']);
        let is_octal = literal.kind == LiteralKind::BasedInteger
            && text.trim_start_matches(['-', '+']).starts_with("8#");
        self.note_if(is_octal, "octal-literal", span);
        let key = match literal.kind {
            LiteralKind::Integer if ty == Some(ElementaryType::Bool) => Some("typed-literal-boolean-digit"),
            LiteralKind::BasedInteger => Some("based-literal"),
            LiteralKind::Real if text.contains(['E', 'e']) => Some("literal-exponent"),
            LiteralKind::Integer | LiteralKind::Real => None,
            LiteralKind::Boolean => prefix.map(|_| "typed-literal-boolean"),
            LiteralKind::SingleByteText => self.text_literal("string-literal", ty, text, expression),
            LiteralKind::DoubleByteText => self.text_literal("wide-string-literal", ty, text, expression),
            LiteralKind::Duration if is_long => Some("long-duration-literal"),
            LiteralKind::Duration => Some("duration-literal"),
            LiteralKind::Date if is_long => Some("long-date-literal"),
            LiteralKind::Date => Some("date-literal"),
            LiteralKind::TimeOfDay if is_long => Some("long-time-of-day-literal"),
            LiteralKind::TimeOfDay => Some("time-of-day-literal"),
            LiteralKind::DateAndTime if is_long => Some("long-date-and-time-literal"),
            LiteralKind::DateAndTime => Some("date-and-time-literal"),
        };
        if let Some(key) = key {
            self.note(key, span);
        }
        if let Some(ty) = ty {
            self.note_type(ty, span);
            let is_number = ty.is_integer() || ty.is_bit_string() || ty.is_real();
            let is_duration = literal.kind == LiteralKind::Duration;
            self.note_if(is_number, "typed-literal", span);
            self.note_if(is_number && is_signed, "typed-literal-sign", span);
            self.note_if(is_duration && is_signed, "duration-sign", span);
        }
    }

    /// Returns the feature of a text in quotes, and notes its escapes.
    fn text_literal(
        &mut self,
        plain: &'static str,
        ty: Option<ElementaryType>,
        text: &str,
        expression: &Expression<'s>,
    ) -> Option<&'static str> {
        self.note_if(text.contains('$'), "string-escape", expression.span);
        self.note_if(ty.is_some(), "typed-literal-string", expression.span);
        Some(plain)
    }
}

/// Returns the key of the functions of which one is a member, by its name in capital letters, where several have a key together.
fn family(name: &str) -> Option<&'static str> {
    let (first, rest) = name.split_once('_')?;
    let types: Option<Vec<ElementaryType>> = rest.split('_').map(ElementaryType::from_name).collect();
    Some(match (first, types.as_deref()) {
        ("ADD" | "SUB", Some(types)) if types.iter().any(|ty| ty.is_third_edition()) => {
            "typed-long-time-function"
        }
        ("ADD" | "SUB", Some(_)) => "typed-time-function",
        ("MUL" | "DIV", Some([ElementaryType::Ltime])) => "typed-long-time-function",
        ("MUL" | "DIV", Some(_)) => "scaled-time-function",
        ("CONCAT", Some([_])) => "compose-date-time",
        ("CONCAT", Some(_)) => "concat-date-time",
        ("SPLIT", Some(_)) => "split-date-time",
        ("DAY", None) if rest == "OF_WEEK" => "day-of-week",
        ("TO" | "FROM", None) if rest.ends_with("_ENDIAN") => "byte-order",
        ("LOWER" | "UPPER", None) if rest == "BOUND" => "bound-function",
        ("IS", None) if rest.starts_with("VALID") => "validity",
        _ => return None,
    })
}

/// Returns the key of an infix operator.
const fn operator_key(operator: BinaryOperator) -> &'static str {
    match operator {
        BinaryOperator::Or => "or",
        BinaryOperator::Xor => "xor",
        BinaryOperator::And => "and",
        BinaryOperator::OrElse | BinaryOperator::AndThen => "short-circuit",
        BinaryOperator::Equal => "equal",
        BinaryOperator::NotEqual => "not-equal",
        BinaryOperator::Less => "less",
        BinaryOperator::Greater => "greater",
        BinaryOperator::LessOrEqual => "less-or-equal",
        BinaryOperator::GreaterOrEqual => "greater-or-equal",
        BinaryOperator::Add => "add",
        BinaryOperator::Subtract => "subtract",
        BinaryOperator::Multiply => "multiply",
        BinaryOperator::Divide => "divide",
        BinaryOperator::Modulo => "mod",
        BinaryOperator::Power => "power",
    }
}
