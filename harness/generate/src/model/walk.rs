//! A walk over everything in a program that somebody may want to change; on a clone, over what somebody wants to look at.
//!
//! A [`Visitor`] overrides what it is interested in and calls the function of the same name here to go deeper. `PROGRAM
//! main` comes first, for it is what a reduction works on longest.

pub use super::Unit;
use super::{
    Argument, CaseBranch, CaseLabel, Declared, Expression, ExpressionKind, Initial, Place, Program, Selector,
    Statement, StatementKind, Target, Type, Variable, VariableId,
};

/// What is called at each part of a program; by default it goes deeper and changes nothing.
pub trait Visitor {
    /// What follows stands in this unit.
    fn enter(&mut self, _unit: Unit) {}

    /// A list of statements: a body, or a branch.
    fn statements(&mut self, statements: &mut Vec<Statement>) {
        walk_statements(self, statements);
    }

    /// A statement.
    fn statement(&mut self, statement: &mut Statement) {
        walk_statement(self, statement);
    }

    /// An expression that may be any of its type.
    fn expression(&mut self, expression: &mut Expression) {
        walk_expression(self, expression);
    }

    /// An expression that must stay a literal: a label of CASE, the value behind BY.
    fn literal(&mut self, expression: &mut Expression) {
        walk_expression(self, expression);
    }

    /// An argument of a call of a function block.
    fn input(&mut self, _instance: VariableId, argument: &mut Argument) {
        self.expression(&mut argument.value);
    }

    /// A variable, or part of one, that is read or written.
    fn place(&mut self, place: &mut Place) {
        walk_place(self, place);
    }

    /// A declared variable.
    fn variable(&mut self, variable: &mut Variable) {
        walk_variable(self, variable);
    }

    /// A type, wherever one is told: of variables, fields, expressions, places.
    fn ty(&mut self, ty: &mut Type) {
        walk_type(self, ty);
    }
}

/// All of a program.
pub fn walk_program(visitor: &mut (impl Visitor + ?Sized), program: &mut Program) {
    visitor.enter(Unit::Main);
    walk_unit(visitor, &mut program.main.variables, &mut program.main.body);
    for (index, function) in program.functions.iter_mut().enumerate() {
        visitor.enter(Unit::Function(index));
        visitor.ty(&mut function.result);
        walk_unit(visitor, &mut function.variables, &mut function.body);
    }
    for (index, block) in program.blocks.iter_mut().enumerate() {
        visitor.enter(Unit::Block(index));
        walk_unit(visitor, &mut block.variables, &mut block.body);
    }
    visitor.enter(Unit::Types);
    for declaration in &mut program.types {
        match &mut declaration.kind {
            Declared::Structure(fields) => {
                for (_, ty, initial) in fields {
                    visitor.ty(ty);
                    initial.iter_mut().for_each(|value| visitor.expression(value));
                }
            }
            Declared::Enumeration(_) => {}
            Declared::Alias(ty) => visitor.ty(ty),
        }
    }
}

fn walk_unit(visitor: &mut (impl Visitor + ?Sized), variables: &mut [Variable], body: &mut Vec<Statement>) {
    visitor.statements(body);
    variables
        .iter_mut()
        .for_each(|variable| visitor.variable(variable));
}

/// A variable's type and initial value.
pub fn walk_variable(visitor: &mut (impl Visitor + ?Sized), variable: &mut Variable) {
    visitor.ty(&mut variable.ty);
    match &mut variable.initial {
        None => {}
        Some(Initial::Expression(value)) => visitor.expression(value),
        Some(Initial::Array(values)) => values.iter_mut().for_each(|value| visitor.expression(value)),
        Some(Initial::Structure(fields)) => {
            fields.iter_mut().for_each(|(_, value)| visitor.expression(value))
        }
    }
}

/// The statements of a list.
pub fn walk_statements(visitor: &mut (impl Visitor + ?Sized), statements: &mut [Statement]) {
    statements
        .iter_mut()
        .for_each(|statement| visitor.statement(statement));
}

/// The parts of a statement.
pub fn walk_statement(visitor: &mut (impl Visitor + ?Sized), statement: &mut Statement) {
    match &mut statement.kind {
        StatementKind::Assign(target, value) => {
            match target {
                Target::Place(place) | Target::Bit(place, _) => visitor.place(place),
                Target::Result => {}
            }
            visitor.expression(value);
        }
        StatementKind::If(branches, otherwise) => {
            for (condition, body) in branches {
                visitor.expression(condition);
                visitor.statements(body);
            }
            otherwise.iter_mut().for_each(|body| visitor.statements(body));
        }
        StatementKind::Case(selector, branches, otherwise) => {
            visitor.expression(selector);
            branches
                .iter_mut()
                .for_each(|branch| walk_branch(visitor, branch));
            otherwise.iter_mut().for_each(|body| visitor.statements(body));
        }
        StatementKind::For {
            from, to, by, body, ..
        } => {
            visitor.expression(from);
            visitor.expression(to);
            by.iter_mut().for_each(|by| visitor.literal(by));
            visitor.statements(body);
        }
        StatementKind::While(condition, body) | StatementKind::Repeat(body, condition) => {
            visitor.expression(condition);
            visitor.statements(body);
        }
        StatementKind::Invoke {
            instance,
            inputs,
            outputs,
        } => {
            inputs
                .iter_mut()
                .for_each(|input| visitor.input(*instance, input));
            outputs.iter_mut().for_each(|(_, place)| visitor.place(place));
        }
        StatementKind::Exit | StatementKind::Return | StatementKind::Raw(_) => {}
    }
}

fn walk_branch(visitor: &mut (impl Visitor + ?Sized), branch: &mut CaseBranch) {
    for label in &mut branch.labels {
        match label {
            CaseLabel::One(value) => visitor.literal(value),
            CaseLabel::Range(low, high) => {
                visitor.literal(low);
                visitor.literal(high);
            }
        }
    }
    visitor.statements(&mut branch.body);
}

/// The parts of an expression.
pub fn walk_expression(visitor: &mut (impl Visitor + ?Sized), expression: &mut Expression) {
    visitor.ty(&mut expression.ty);
    match &mut expression.kind {
        ExpressionKind::Literal(..) | ExpressionKind::Enumerated(_) | ExpressionKind::Raw(_) => {}
        ExpressionKind::Read(place) | ExpressionKind::Bit(place, _) => visitor.place(place),
        ExpressionKind::Unary(_, operand)
        | ExpressionKind::Widen(operand)
        | ExpressionKind::Convert(_, operand) => {
            visitor.expression(operand);
        }
        ExpressionKind::Binary(_, left, right) => {
            visitor.expression(left);
            visitor.expression(right);
        }
        ExpressionKind::Call(_, arguments) => {
            arguments
                .iter_mut()
                .for_each(|argument| visitor.expression(&mut argument.value));
        }
        ExpressionKind::Standard(_, arguments) => {
            arguments
                .iter_mut()
                .for_each(|argument| visitor.expression(argument));
        }
    }
}

/// The subscripts in a place.
pub fn walk_place(visitor: &mut (impl Visitor + ?Sized), place: &mut Place) {
    visitor.ty(&mut place.ty);
    for selector in &mut place.path {
        match selector {
            Selector::Index(subscripts) => subscripts
                .iter_mut()
                .for_each(|subscript| visitor.expression(subscript)),
            Selector::Field(_) | Selector::Output(_) => {}
        }
    }
}

/// The type of an array's elements.
pub fn walk_type(visitor: &mut (impl Visitor + ?Sized), ty: &mut Type) {
    if let Type::Array(array) = ty {
        visitor.ty(&mut array.element);
    }
}
