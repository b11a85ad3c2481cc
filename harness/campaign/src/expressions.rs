//! Every expression of a program, visited once.

use stickler_generate::model::{
    Argument, CaseLabel, Declared, Expression, ExpressionKind, Initial, Place, Program, Selector, Statement,
    StatementKind, Target, Variable,
};

/// Calls `visit` with every expression of the program, outer ones before what stands in them.
pub(crate) fn each_expression(program: &Program, visit: &mut dyn FnMut(&Expression)) {
    for declaration in &program.types {
        if let Declared::Structure(fields) = &declaration.kind {
            fields
                .iter()
                .flat_map(|(_, _, initial)| initial)
                .for_each(|initial| within(initial, visit));
        }
    }
    let functions = program
        .functions
        .iter()
        .map(|function| (&function.variables, &function.body));
    let blocks = program.blocks.iter().map(|block| (&block.variables, &block.body));
    let main = [(&program.main.variables, &program.main.body)];
    for (variables, body) in functions.chain(blocks).chain(main) {
        variables.iter().for_each(|variable| of_variable(variable, visit));
        of_statements(body, visit);
    }
}

fn of_variable(variable: &Variable, visit: &mut dyn FnMut(&Expression)) {
    match &variable.initial {
        Some(Initial::Expression(value)) => within(value, visit),
        Some(Initial::Array(values)) => values.iter().for_each(|value| within(value, visit)),
        Some(Initial::Structure(fields)) => fields.iter().for_each(|(_, value)| within(value, visit)),
        None => {}
    }
}

fn of_statements(statements: &[Statement], visit: &mut dyn FnMut(&Expression)) {
    statements
        .iter()
        .for_each(|statement| of_statement(&statement.kind, visit));
}

fn of_statement(kind: &StatementKind, visit: &mut dyn FnMut(&Expression)) {
    match kind {
        StatementKind::Assign(target, value) => {
            if let Target::Place(place) | Target::Bit(place, _) = target {
                of_place(place, visit);
            }
            within(value, visit);
        }
        StatementKind::If(branches, other) => {
            for (condition, body) in branches {
                within(condition, visit);
                of_statements(body, visit);
            }
            other.iter().for_each(|body| of_statements(body, visit));
        }
        StatementKind::Case(selector, branches, other) => {
            within(selector, visit);
            for branch in branches {
                branch.labels.iter().for_each(|label| of_label(label, visit));
                of_statements(&branch.body, visit);
            }
            other.iter().for_each(|body| of_statements(body, visit));
        }
        StatementKind::For {
            from, to, by, body, ..
        } => {
            within(from, visit);
            within(to, visit);
            by.iter().for_each(|by| within(by, visit));
            of_statements(body, visit);
        }
        StatementKind::While(condition, body) => {
            within(condition, visit);
            of_statements(body, visit);
        }
        StatementKind::Repeat(body, condition) => {
            of_statements(body, visit);
            within(condition, visit);
        }
        StatementKind::Invoke { inputs, outputs, .. } => {
            of_arguments(inputs, visit);
            outputs.iter().for_each(|(_, place)| of_place(place, visit));
        }
        StatementKind::Exit | StatementKind::Return | StatementKind::Raw(_) => {}
    }
}

fn of_label(label: &CaseLabel, visit: &mut dyn FnMut(&Expression)) {
    match label {
        CaseLabel::One(value) => within(value, visit),
        CaseLabel::Range(low, high) => {
            within(low, visit);
            within(high, visit);
        }
    }
}

fn of_place(place: &Place, visit: &mut dyn FnMut(&Expression)) {
    for selector in &place.path {
        if let Selector::Index(subscripts) = selector {
            subscripts.iter().for_each(|subscript| within(subscript, visit));
        }
    }
}

fn of_arguments(arguments: &[Argument], visit: &mut dyn FnMut(&Expression)) {
    arguments
        .iter()
        .for_each(|argument| within(&argument.value, visit));
}

fn within(expression: &Expression, visit: &mut dyn FnMut(&Expression)) {
    visit(expression);
    match &expression.kind {
        ExpressionKind::Literal(..) | ExpressionKind::Enumerated(_) | ExpressionKind::Raw(_) => {}
        ExpressionKind::Read(place) | ExpressionKind::Bit(place, _) => of_place(place, visit),
        ExpressionKind::Unary(_, operand)
        | ExpressionKind::Widen(operand)
        | ExpressionKind::Convert(_, operand) => within(operand, visit),
        ExpressionKind::Binary(_, left, right) => {
            within(left, visit);
            within(right, visit);
        }
        ExpressionKind::Call(_, arguments) => of_arguments(arguments, visit),
        ExpressionKind::Standard(_, operands) => operands.iter().for_each(|operand| within(operand, visit)),
    }
}
