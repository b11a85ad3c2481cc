//! Reading of expressions and places back into the model.

use super::{BOOL, Reader, named, typed};
use crate::evaluate::arithmetic;
use crate::generator::TypeContext;
use crate::model::{
    Argument, BinaryOperator, Expression, ExpressionKind, Place, PlaceSelector, StandardFunction, Type,
    UnaryOperator, VariableId, VariableSection,
};
use stickler_exact::{Signature, signatures};
use stickler_syntax::tree::{self, ExpressionId, Name};
use stickler_types::{ElementaryType, Family};

const INT: Type = Type::Elementary(ElementaryType::Int);

impl Reader<'_> {
    /// Reads an expression in a place for a value of the type `wanted`, to which it may convert implicitly.
    pub(super) fn value(&self, id: ExpressionId, wanted: &Type, context: TypeContext) -> Option<Expression> {
        let wanted = self.program.unaliased(wanted);
        let own = match context {
            TypeContext::Assigned => self
                .operation(id)
                .filter(|own| self.profile.has_its_type(own, true)),
            _ => self.own(id),
        };
        match (own, wanted) {
            (Some(own), _) => self.fitted(own, wanted),
            (None, Type::Elementary(ty)) => self
                .number(id, *ty, context)
                .or_else(|| self.converted_to(id, *ty, context)),
            (None, _) => None,
        }
    }

    /// Reads a call of a conversion function that gives several types, of which its place takes one.
    fn converted_to(&self, id: ExpressionId, ty: ElementaryType, context: TypeContext) -> Option<Expression> {
        let tree::ExpressionKind::Call { callee, arguments } = &self.unit.expression(id)?.kind else {
            return None;
        };
        match (&self.unit.expression(*callee)?.kind, arguments.as_slice()) {
            (tree::ExpressionKind::Name(name), [tree::Argument::Positional(operand)])
                if context == TypeContext::Assigned =>
            {
                self.converted(name, *operand, Some(ty))
            }
            _ => None,
        }
    }

    /// Reads a condition, which must be a BOOL by itself.
    pub(super) fn condition(&self, id: ExpressionId) -> Option<Expression> {
        self.own(id).filter(|condition| condition.ty == BOOL)
    }

    /// Returns an expression with the type `wanted`: itself, or converted implicitly.
    fn fitted(&self, own: Expression, wanted: &Type) -> Option<Expression> {
        if own.ty == *wanted {
            return Some(own);
        }
        self.widens(&own.ty, wanted)
            .then(|| Expression::widened(wanted.clone(), own))
    }

    fn widens(&self, from: &Type, into: &Type) -> bool {
        match (from, into) {
            (Type::Elementary(from), Type::Elementary(into)) => self.profile.sources(*into).contains(from),
            _ => false,
        }
    }

    /// Reads an expression whose text determines its type; `None` also for a number without the prefix of its type.
    pub(super) fn own(&self, id: ExpressionId) -> Option<Expression> {
        self.operation(id)
            .filter(|own| self.profile.has_its_type(own, false))
    }

    /// Reads the same where a value is stored at once, which settles the type of an operation in more dialects.
    fn operation(&self, id: ExpressionId) -> Option<Expression> {
        match &self.unit.expression(id)?.kind {
            tree::ExpressionKind::Parenthesized(inner) => self.operation(*inner),
            tree::ExpressionKind::Literal(literal) => typed(literal),
            tree::ExpressionKind::Name(name) => self.enumerated(name).or_else(|| self.read(id)),
            tree::ExpressionKind::Field { .. }
            | tree::ExpressionKind::Index { .. }
            | tree::ExpressionKind::Dereference { .. } => self.read(id),
            tree::ExpressionKind::Bit { .. } => {
                let (place, bit) = self.bit(id)?;
                Some(Expression::elementary(
                    ElementaryType::Bool,
                    ExpressionKind::Bit(place, bit),
                ))
            }
            tree::ExpressionKind::Call { callee, arguments } => match &self.unit.expression(*callee)?.kind {
                tree::ExpressionKind::Name(name) => self.call(name, arguments),
                tree::ExpressionKind::Field { base, field } => {
                    let Type::Block(block) = self.place(*base)?.ty else {
                        return None;
                    };
                    self.called(self.function(Some(block), field)?, arguments)
                }
                _ => None,
            },
            tree::ExpressionKind::Unary { operator, operand } => self.unary(*operator, *operand),
            tree::ExpressionKind::Binary {
                operator,
                left,
                right,
            } => self.binary(*operator, *left, *right),
            tree::ExpressionKind::EnumeratedValue(_)
            | tree::ExpressionKind::Part { .. }
            | tree::ExpressionKind::Assigned { .. }
            | tree::ExpressionKind::Aggregate(_)
            | tree::ExpressionKind::Error => None,
        }
    }

    fn enumerated(&self, name: &Name<'_>) -> Option<Expression> {
        (0..self.program.types.len()).find_map(|declared| {
            let ty = Type::Declared(declared);
            let value = named(self.program.enumerated_values(&ty)?.iter(), name.text)?;
            let kind = ExpressionKind::Enumerated(value);
            Some(Expression { ty, kind })
        })
    }

    fn read(&self, id: ExpressionId) -> Option<Expression> {
        let place = self.place(id)?;
        Some(Expression::read(place))
    }

    /// Reads a bit of a place.
    pub(super) fn bit(&self, id: ExpressionId) -> Option<(Place, u32)> {
        let tree::ExpressionKind::Bit { base, index } = &self.unit.expression(id)?.kind else {
            return None;
        };
        let place = self.place(*base)?;
        let bit = u32::try_from(*index).ok()?;
        let has_it = matches!(place.ty, Type::Elementary(ty) if bit < ty.bits() && (ty.is_integer() || ty.is_bit_string()));
        has_it.then_some((place, bit))
    }

    /// Reads a variable, or a part of one.
    pub(super) fn place(&self, id: ExpressionId) -> Option<Place> {
        let (mut place, selector) = match &self.unit.expression(id)?.kind {
            tree::ExpressionKind::Name(name) => {
                let id = named(self.variables.iter().map(|one| &one.name), name.text)?;
                let ty = self.program.unaliased(&self.variables.get(id)?.ty);
                return Some(Place::whole(VariableId(id), ty.clone()));
            }
            tree::ExpressionKind::Index { base, subscripts } => {
                let place = self.place(*base)?;
                match &place.ty {
                    Type::Array(array) if array.dimensions.len() == subscripts.len() => {}
                    _ => return None,
                }
                let subscripts = subscripts.iter().map(|id| self.subscript(*id));
                (place, PlaceSelector::Index(subscripts.collect::<Option<_>>()?))
            }
            tree::ExpressionKind::Dereference { base } => (self.place(*base)?, PlaceSelector::Followed),
            tree::ExpressionKind::Field { base, field } => {
                let place = self.place(*base)?;
                let selector = match &place.ty {
                    Type::Block(block) => PlaceSelector::Output(self.parameter(
                        &self.program.blocks.get(*block)?.variables,
                        field,
                        &[VariableSection::Output],
                    )?),
                    ty => {
                        let fields = self.program.fields(ty)?.iter();
                        PlaceSelector::Field(named(fields.map(|(name, ..)| name), field.text)?)
                    }
                };
                (place, selector)
            }
            _ => return None,
        };
        let selected = self.program.selected_type(&place.ty, &selector)?;
        place.ty = self.program.unaliased(selected).clone();
        place.path.push(selector);
        Some(place)
    }

    fn subscript(&self, id: ExpressionId) -> Option<Expression> {
        let subscript = self
            .own(id)
            .or_else(|| self.number(id, ElementaryType::Int, TypeContext::Assigned))?;
        matches!(subscript.ty, Type::Elementary(ty) if ty.is_integer()).then_some(subscript)
    }

    /// Returns the parameter with a name in one of these sections.
    pub(super) fn parameter(
        &self,
        variables: &[crate::model::Variable],
        name: &Name<'_>,
        sections: &[VariableSection],
    ) -> Option<VariableId> {
        let parameter = named(variables.iter().map(|one| &one.name), name.text)?;
        sections
            .contains(&variables.get(parameter)?.section)
            .then_some(VariableId(parameter))
    }

    fn unary(&self, operator: tree::UnaryOperator, operand: ExpressionId) -> Option<Expression> {
        let operand = self.own(operand)?;
        let Type::Elementary(ty) = operand.ty else {
            return None;
        };
        let operator = match operator {
            tree::UnaryOperator::Negate => UnaryOperator::Negate,
            tree::UnaryOperator::Not => UnaryOperator::Not,
            tree::UnaryOperator::Plus => return None,
        };
        arithmetic::unary(operator, ty, 0)?;
        Some(Expression::elementary(
            ty,
            ExpressionKind::Unary(operator, Box::new(operand)),
        ))
    }

    fn binary(
        &self,
        operator: tree::BinaryOperator,
        left: ExpressionId,
        right: ExpressionId,
    ) -> Option<Expression> {
        let operator = BinaryOperator::from_word(operator.as_str())?;
        let (left, right) = match (self.own(left), self.own(right)) {
            (Some(one), Some(two)) => match (self.widens(&one.ty, &two.ty), self.widens(&two.ty, &one.ty)) {
                _ if one.ty == two.ty => (one, two),
                _ if !self.profile.mixes_operands() => return None,
                (true, false) => (self.fitted(one, &two.ty)?, two),
                // TIME and LTIME convert both ways.
                (_, true) => {
                    let two = self.fitted(two, &one.ty)?;
                    (one, two)
                }
                _ => return None,
            },
            (Some(one), None) => {
                let two = self.value(right, &one.ty, TypeContext::Operand)?;
                (one, two)
            }
            (None, Some(two)) => (self.value(left, &two.ty, TypeContext::Operand)?, two),
            (None, None) => return None,
        };
        let result = result(operator, &left.ty)?;
        Some(Expression::binary(operator, left, right, result))
    }

    /// Returns the function with a name, or the method of a function block.
    fn function(&self, owner: Option<usize>, name: &Name<'_>) -> Option<usize> {
        let mut functions = self.program.functions.iter();
        functions.position(|one| one.owner == owner && name.is(&one.name))
    }

    fn call(&self, name: &Name<'_>, arguments: &[tree::Argument<'_>]) -> Option<Expression> {
        if let Some(function) = self.function(None, name) {
            return self.called(function, arguments);
        }
        let positional = arguments.iter().map(|argument| match argument {
            tree::Argument::Positional(value) => Some(*value),
            _ => None,
        });
        let arguments: Vec<ExpressionId> = positional.collect::<Option<_>>()?;
        if let (Some((_, word)), [place]) = (self.program.reference_words(), &arguments[..])
            && name.is(word)
        {
            let place = self.place(*place)?;
            return Some(Expression::new(
                Type::Reference(Box::new(place.ty.clone())),
                ExpressionKind::Reference(place),
            ));
        }
        match StandardFunction::from_word(&name.text.to_ascii_uppercase()) {
            Some(function) => self.standard(function, &arguments),
            None => match arguments[..] {
                [operand] => self.converted(name, operand, None),
                _ => None,
            },
        }
    }

    /// Reads a call of a function of the program, whose arguments have names, or all of them none.
    fn called(&self, function: usize, arguments: &[tree::Argument<'_>]) -> Option<Expression> {
        let called = self.program.functions.get(function)?;
        let is_positional = |argument: &tree::Argument<'_>| matches!(argument, tree::Argument::Positional(_));
        let inputs: Vec<VariableId> = called.inputs().map(|(input, _)| input).collect();
        // A call with empty parentheses is positional, and so must have all arguments.
        if arguments.iter().all(is_positional) && arguments.len() != inputs.len() {
            return None;
        }
        let mut read = Vec::new();
        for (number, argument) in arguments.iter().enumerate() {
            let (parameter, value) = match argument {
                tree::Argument::Positional(value) => (*inputs.get(number)?, *value),
                tree::Argument::Named { name, value } => (
                    self.parameter(&called.variables, name, &[VariableSection::Input])?,
                    *value,
                ),
                tree::Argument::Output { .. } => return None,
            };
            let ty = &called.variables.get(parameter.0)?.ty;
            let value = self.value(value, ty, TypeContext::Argument)?;
            read.push(Argument { parameter, value });
        }
        Some(Expression::new(
            self.program.unaliased(called.result.as_ref()?).clone(),
            ExpressionKind::Call(function, read),
        ))
    }

    /// Reads a call of a standard function: each argument determines its own type.
    fn standard(&self, function: StandardFunction, arguments: &[ExpressionId]) -> Option<Expression> {
        use StandardFunction as S;
        let arguments = arguments.iter().map(|id| self.own(*id));
        let arguments: Vec<Expression> = arguments.collect::<Option<_>>()?;
        let types: Vec<&Type> = arguments.iter().map(|argument| &argument.ty).collect();
        let alike = |types: &[&Type]| types.windows(2).all(|pair| pair[0] == pair[1]);
        let ty = match (function, types.as_slice()) {
            (S::Abs, [ty]) => ty,
            (S::Sel, [selector, all @ ..]) if **selector == BOOL && all.len() == 2 && alike(all) => all[0],
            (S::Mux, [selector, first, rest @ ..])
                if **selector == INT && rest.iter().all(|ty| ty == first) =>
            {
                first
            }
            (S::Min | S::Max | S::Concat, all) if all.len() == 2 && alike(all) => all[0],
            (S::Limit, all) if all.len() == 3 && alike(all) => all[0],
            (S::Shl | S::Shr | S::Rol | S::Ror, [ty, count]) if **count == INT => ty,
            (S::Len, [_]) => &INT,
            (S::Left | S::Right, [ty, count]) if **count == INT => ty,
            (S::Find, all) if all.len() == 2 && alike(all) => &INT,
            (S::SquareRoot, [ty]) if matches!(ty, Type::Elementary(ty) if ty.is_real()) => ty,
            _ => return None,
        };
        Some(Expression::new(
            ty.clone(),
            ExpressionKind::Standard(function, arguments),
        ))
    }

    /// Reads a call of a type conversion function, of those with this result where it gives several types. Its operand is of a
    /// type that the function takes, or widens to the only one.
    fn converted(
        &self,
        name: &Name<'_>,
        operand: ExpressionId,
        result: Option<ElementaryType>,
    ) -> Option<Expression> {
        let operand = self.own(operand)?;
        let mut all = signatures(name.text, self.program.dialect);
        all.retain(|signature| result.is_none_or(|result| signature.result == result));
        let from = |signature: &Signature| match signature.operands[..] {
            [ty] => Some(Type::Elementary(ty)),
            _ => None,
        };
        let exact: Vec<&Signature> = { all.iter() }
            .filter(|signature| from(signature).as_ref() == Some(&operand.ty))
            .collect();
        let (signature, operand) = match (exact.as_slice(), all.as_slice()) {
            ([signature], _) => (*signature, operand),
            ([], [only]) => (only, self.fitted(operand, &from(only)?)?),
            _ => return None,
        };
        Some(Expression::elementary(
            signature.result,
            ExpressionKind::Convert(signature.clone(), Box::new(operand)),
        ))
    }
}

/// Returns the type of an operation on two operands of a type; `None` where it does not have the operator.
fn result(operator: BinaryOperator, operands: &Type) -> Option<ElementaryType> {
    let is_equality = matches!(operator, BinaryOperator::Equal | BinaryOperator::NotEqual);
    let has_it = match operands {
        // No document orders truth values and texts.
        Type::Elementary(ty) if operator.is_comparison() => {
            is_equality || !matches!(ty.family(), Family::Boolean | Family::Text | Family::Character)
        }
        Type::Elementary(ty) => arithmetic::binary(operator, *ty, 1, 1) != arithmetic::Binary::Undefined,
        Type::Declared(_) => is_equality,
        Type::Array(_) | Type::Block(_) | Type::Reference(_) => false,
    };
    match (has_it, operands) {
        (false, _) => None,
        (true, Type::Elementary(ty)) if !operator.is_comparison() => Some(*ty),
        (true, _) => Some(ElementaryType::Bool),
    }
}
