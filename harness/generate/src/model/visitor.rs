//! Traversal of programs, read-only ([`visit`]) and mutable ([`visit_mut`]).
//!
//! Both traits have the same hooks and the same default traversal. A visitor overrides the hooks that it is interested in, and
//! calls the free function of the same name (`walk_…`) to descend into the children of a node. `PROGRAM main` is visited first,
//! because a reduction spends most of its time there.

use super::{
    Argument, AssignmentTarget, CaseBranch, CaseLabel, DeclaredKind, Expression, ExpressionKind, ForLoop,
    InitialValue, Place, PlaceSelector, Program, Statement, Type, TypeDeclaration, Unit, Variable,
    VariableId,
};

/// Defines a visitor trait and its traversal; `$mutability` is `mut` or nothing, `$list` the type of a list of statements.
macro_rules! define_visitor {
    ($visitor:ident, $list:ty $(, $mutability:tt)?) => {
        use super::*;

        /// Hooks that a traversal calls on each part of a program; by default each hook descends into its node.
        pub trait $visitor {
            /// Enters a program organization unit, or the type declarations; the nodes that follow stand there.
            fn enter(&mut self, _unit: Unit) {}

            /// Visits a list of statements: a body or a branch.
            fn statements(&mut self, statements: &$($mutability)? $list) {
                walk_statements(self, statements);
            }

            /// Visits a statement.
            fn statement(&mut self, statement: &$($mutability)? Statement) {
                walk_statement(self, statement);
            }

            /// Visits an expression.
            fn expression(&mut self, expression: &$($mutability)? Expression) {
                walk_expression(self, expression);
            }

            /// Visits an expression that must stay a literal: a CASE label, or the value after BY.
            fn literal(&mut self, expression: &$($mutability)? Expression) {
                walk_expression(self, expression);
            }

            /// Visits an argument in the call of a function block instance.
            fn input(&mut self, _instance: VariableId, argument: &$($mutability)? Argument) {
                self.expression(&$($mutability)? argument.value);
            }

            /// Visits a variable, or a part of one, that is read or written.
            fn place(&mut self, place: &$($mutability)? Place) {
                walk_place(self, place);
            }

            /// Visits the declaration of a variable.
            fn variable(&mut self, variable: &$($mutability)? Variable) {
                walk_variable(self, variable);
            }

            /// Visits the declaration of a type.
            fn declaration(&mut self, declaration: &$($mutability)? TypeDeclaration) {
                walk_declaration(self, declaration);
            }

            /// Visits the type of a variable, field, expression, place or function result.
            fn ty(&mut self, ty: &$($mutability)? Type) {
                walk_type(self, ty);
            }
        }

        /// Visits a program: main, functions, function blocks, then type declarations; of each unit the body before the
        /// variables. Standard function blocks have no text to be visited.
        pub fn walk_program(visitor: &mut (impl $visitor + ?Sized), program: &$($mutability)? Program) {
            let Program { types, functions, blocks, main, .. } = program;
            let functions = functions.into_iter().enumerate();
            let functions = functions.map(|(index, function)| (Unit::Function(index), function));
            let blocks = blocks.into_iter().enumerate().filter(|(_, block)| !block.standard);
            let blocks = blocks.map(|(index, block)| (Unit::Block(index), block));
            for (unit, pou) in [(Unit::Main, main)].into_iter().chain(functions).chain(blocks) {
                visitor.enter(unit);
                if let Some(result) = &$($mutability)? pou.result {
                    visitor.ty(result);
                }
                visitor.statements(&$($mutability)? pou.body);
                for variable in &$($mutability)? pou.variables {
                    visitor.variable(variable);
                }
            }
            visitor.enter(Unit::Types);
            for declaration in types {
                visitor.declaration(declaration);
            }
        }

        /// Visits the types and initial values in the declaration of a type.
        pub fn walk_declaration(
            visitor: &mut (impl $visitor + ?Sized),
            declaration: &$($mutability)? TypeDeclaration,
        ) {
            match &$($mutability)? declaration.kind {
                DeclaredKind::Structure(fields) => {
                    for (_, ty, initial) in fields {
                        visitor.ty(ty);
                        if let Some(value) = initial {
                            visitor.expression(value);
                        }
                    }
                }
                DeclaredKind::Enumeration(_) => {}
                DeclaredKind::Alias(ty) => visitor.ty(ty),
            }
        }

        /// Visits the type and the initial value of a variable.
        pub fn walk_variable(
            visitor: &mut (impl $visitor + ?Sized),
            variable: &$($mutability)? Variable,
        ) {
            visitor.ty(&$($mutability)? variable.ty);
            if let Some(initial) = &$($mutability)? variable.initial {
                for value in initial_values(initial) {
                    visitor.expression(value);
                }
            }
        }

        /// Returns the expressions of an initial value, in the order of the text.
        pub fn initial_values(initial: &$($mutability)? InitialValue) -> Vec<&$($mutability)? Expression> {
            match initial {
                InitialValue::Expression(value) => vec![value],
                InitialValue::Array(values) => values.into_iter().collect(),
                InitialValue::Structure(fields) => fields.into_iter().map(|(_, value)| value).collect(),
            }
        }

        /// Visits the statements of a list.
        pub fn walk_statements(
            visitor: &mut (impl $visitor + ?Sized),
            statements: &$($mutability)? [Statement],
        ) {
            for statement in statements {
                visitor.statement(statement);
            }
        }

        /// Visits the parts of a statement.
        pub fn walk_statement(
            visitor: &mut (impl $visitor + ?Sized),
            statement: &$($mutability)? Statement,
        ) {
            match statement {
                Statement::Assign(target, value) => {
                    match target {
                        AssignmentTarget::Place(place) | AssignmentTarget::Bit(place, _) => visitor.place(place),
                        AssignmentTarget::Result => {}
                    }
                    visitor.expression(value);
                }
                Statement::If(branches, otherwise) => {
                    for (condition, body) in branches {
                        visitor.expression(condition);
                        visitor.statements(body);
                    }
                    if let Some(body) = otherwise {
                        visitor.statements(body);
                    }
                }
                Statement::Case(selector, branches, otherwise) => {
                    visitor.expression(selector);
                    for branch in branches {
                        walk_branch(visitor, branch);
                    }
                    if let Some(body) = otherwise {
                        visitor.statements(body);
                    }
                }
                Statement::For(ForLoop { from, to, by, body, .. }) => {
                    visitor.expression(from);
                    visitor.expression(to);
                    if let Some(by) = by {
                        visitor.literal(by);
                    }
                    visitor.statements(body);
                }
                Statement::While(condition, body) | Statement::Repeat(body, condition) => {
                    visitor.expression(condition);
                    visitor.statements(body);
                }
                Statement::Invoke { instance, inputs, outputs } => {
                    for input in inputs {
                        visitor.input(*instance, input);
                    }
                    for (_, place) in outputs {
                        visitor.place(place);
                    }
                }
                Statement::Exit | Statement::Return | Statement::Raw(_) => {}
            }
        }

        fn walk_branch(visitor: &mut (impl $visitor + ?Sized), branch: &$($mutability)? CaseBranch) {
            for label in &$($mutability)? branch.labels {
                match label {
                    CaseLabel::One(value) => visitor.literal(value),
                    CaseLabel::Range(low, high) => {
                        visitor.literal(low);
                        visitor.literal(high);
                    }
                }
            }
            visitor.statements(&$($mutability)? branch.body);
        }

        /// Visits the parts of an expression.
        pub fn walk_expression(
            visitor: &mut (impl $visitor + ?Sized),
            expression: &$($mutability)? Expression,
        ) {
            visitor.ty(&$($mutability)? expression.ty);
            if let ExpressionKind::Read(place)
            | ExpressionKind::Bit(place, _)
            | ExpressionKind::Reference(place) = &$($mutability)? expression.kind
            {
                visitor.place(place);
            }
            for operand in operands(expression) {
                visitor.expression(operand);
            }
        }

        /// Visits the type of a place and its subscripts.
        pub fn walk_place(visitor: &mut (impl $visitor + ?Sized), place: &$($mutability)? Place) {
            visitor.ty(&$($mutability)? place.ty);
            for selector in &$($mutability)? place.path {
                if let PlaceSelector::Index(subscripts) = selector {
                    for subscript in subscripts {
                        visitor.expression(subscript);
                    }
                }
            }
        }

        /// Visits the element type of an array type.
        pub fn walk_type(visitor: &mut (impl $visitor + ?Sized), ty: &$($mutability)? Type) {
            if let Type::Array(array) = ty {
                visitor.ty(&$($mutability)? array.element);
            }
        }

        /// Returns the operands or arguments of an expression, from left to right; none for a literal or a place.
        pub fn operands(expression: &$($mutability)? Expression) -> Vec<&$($mutability)? Expression> {
            match &$($mutability)? expression.kind {
                ExpressionKind::Unary(_, operand)
                | ExpressionKind::Widen(operand)
                | ExpressionKind::Convert(_, operand) => vec![operand],
                ExpressionKind::Binary(_, left, right) => vec![left, right],
                ExpressionKind::Call(_, arguments) => {
                    let values = arguments.into_iter();
                    values.map(|argument| &$($mutability)? argument.value).collect()
                }
                ExpressionKind::Standard(_, arguments) => arguments.into_iter().collect(),
                ExpressionKind::Literal(..)
                | ExpressionKind::Enumerated(_)
                | ExpressionKind::Read(_)
                | ExpressionKind::Reference(_)
                | ExpressionKind::Bit(..)
                | ExpressionKind::Raw(_) => Vec::new(),
            }
        }

        /// Returns the lists of statements directly inside a statement, in the order of the text.
        pub fn bodies(statement: &$($mutability)? Statement) -> Vec<&$($mutability)? Vec<Statement>> {
            match statement {
                Statement::If(branches, otherwise) => {
                    let bodies = branches.into_iter().map(|(_, body)| body);
                    bodies.chain(otherwise).collect()
                }
                Statement::Case(_, branches, otherwise) => {
                    let bodies = branches.into_iter().map(|branch| &$($mutability)? branch.body);
                    bodies.chain(otherwise).collect()
                }
                Statement::For(ForLoop { body, .. })
                | Statement::While(_, body)
                | Statement::Repeat(body, _) => vec![body],
                Statement::Assign(..)
                | Statement::Invoke { .. }
                | Statement::Exit
                | Statement::Return
                | Statement::Raw(_) => Vec::new(),
            }
        }
    };
}

/// Read-only traversal.
pub mod visit {
    define_visitor!(Visitor, [Statement]);
}

/// Mutable traversal.
pub mod visit_mut {
    define_visitor!(VisitorMut, Vec<Statement>, mut);
}
