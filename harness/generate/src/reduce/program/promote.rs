//! Passes that put functions and function blocks in the place of `PROGRAM main`, and turn enumerations into numbers.

use super::removal::keep_only;
use super::usage::DeclarationUsage;
use crate::model::visit::{self, Visitor};
use crate::model::visit_mut::{self, VisitorMut};
use crate::model::{
    Argument, AssignmentTarget, DeclaredKind, Expression, ExpressionKind, InitialValue, LiteralForm, Place,
    Program, Statement, StatementKind, Type, Variable, VariableId, VariableSection,
};
use stickler_reduce::Sites;
use stickler_types::{ElementaryType, Value};

/// Replaces the variables and the body of `PROGRAM main` by those of a function or a function block.
///
/// If a defect does not need the call, that saves its two lines and those around the unit. Literals that were passed to the
/// unit become initial values.
pub(super) fn promote(program: &mut Program, sites: &mut Sites) {
    let functions = program.functions.len();
    for unit in 0..functions + program.blocks.len() {
        if !sites.here() {
            continue;
        }
        let (mut variables, body, result) = match unit.checked_sub(functions) {
            None => {
                let function = &program.functions[unit];
                let result = free_name(&function.variables).map(|name| (name, function.result.clone()));
                (function.variables.clone(), function.body.clone(), result)
            }
            Some(block) => {
                let block = &program.blocks[block];
                (block.variables.clone(), block.body.clone(), None)
            }
        };
        for variable in &mut variables {
            if variable.section != VariableSection::Constant {
                variable.section = VariableSection::Local;
            }
        }
        let mut calls = ArgumentLiterals {
            unit,
            functions,
            instances: program
                .main
                .variables
                .iter()
                .map(|variable| variable.ty.clone())
                .collect(),
            arguments: Vec::new(),
        };
        calls.statements(&program.main.body);
        for argument in calls.arguments {
            if let Some(variable) = variables.get_mut(argument.parameter.0) {
                variable.initial = Some(InitialValue::Expression(argument.value));
            }
        }
        program.main.body = body;
        if let Some((name, ty)) = result {
            let place = Place::whole(VariableId(variables.len()), ty.clone());
            variables.push(Variable {
                name,
                ty,
                section: VariableSection::Local,
                initial: None,
            });
            let mut results = ResultReplacer(place);
            results.statements(&mut program.main.body);
        }
        program.main.variables = variables;
        // A unit that another one calls has to stay.
        let now = DeclarationUsage::of(program);
        let mut keep = DeclarationUsage::uniform(program, true);
        let (kept, used) = match unit.checked_sub(functions) {
            None => (keep.functions.get_mut(unit), now.functions.get(unit)),
            Some(block) => (keep.blocks.get_mut(block), now.blocks.get(block)),
        };
        if let (Some(kept), Some(used)) = (kept, used) {
            *kept = *used;
        }
        keep_only(program, &keep);
        return;
    }
}

/// The literals that a program passes to a function or function block; `unit` is counted as in [`promote`].
struct ArgumentLiterals {
    unit: usize,
    functions: usize,
    /// The types of the variables of main.
    instances: Vec<Type>,
    arguments: Vec<Argument>,
}

impl ArgumentLiterals {
    fn take(&mut self, arguments: &[Argument]) {
        let literals = arguments
            .iter()
            .filter(|argument| matches!(argument.value.kind, ExpressionKind::Literal(..)));
        self.arguments.extend(literals.cloned());
    }
}

impl Visitor for ArgumentLiterals {
    fn statement(&mut self, statement: &Statement) {
        if let StatementKind::Invoke { instance, inputs, .. } = &statement.kind
            && let Some(Type::Block(block)) = self.instances.get(instance.0)
            && block + self.functions == self.unit
        {
            self.take(inputs);
        }
        visit::walk_statement(self, statement);
    }

    fn expression(&mut self, expression: &Expression) {
        if let ExpressionKind::Call(function, arguments) = &expression.kind
            && *function == self.unit
        {
            self.take(arguments);
        }
        visit::walk_expression(self, expression);
    }
}

/// Returns a name that no variable has.
fn free_name(variables: &[Variable]) -> Option<String> {
    (0..=variables.len())
        .map(|number| format!("result{number}"))
        .find(|name| variables.iter().all(|variable| variable.name != *name))
}

/// Assigns the former result of a function to a variable.
struct ResultReplacer(Place);

impl VisitorMut for ResultReplacer {
    fn statement(&mut self, statement: &mut Statement) {
        if let StatementKind::Assign(target, _) = &mut statement.kind
            && *target == AssignmentTarget::Result
        {
            *target = AssignmentTarget::Place(self.0.clone());
        }
        visit_mut::walk_statement(self, statement);
    }
}

/// Replaces the values of enumerations by numbers.
///
/// No engine is asked for a value of an enumeration; a program that shows one by its effects needs a line more for each.
/// LINT is the type of the checksum, in which such a difference is found.
pub(super) fn enumerations_to_numbers(program: &mut Program, sites: &mut Sites) {
    let chosen: Vec<bool> = program
        .types
        .iter()
        .map(|declaration| matches!(declaration.kind, DeclaredKind::Enumeration(_)) && sites.here())
        .collect();
    if chosen.contains(&true) {
        visit_mut::walk_program(&mut Numbers(chosen), program);
    }
}

struct Numbers(Vec<bool>);

impl Numbers {
    fn has(&self, ty: &Type) -> bool {
        matches!(ty, Type::Declared(index) if self.0.get(*index) == Some(&true))
    }
}

impl VisitorMut for Numbers {
    fn expression(&mut self, expression: &mut Expression) {
        if let ExpressionKind::Enumerated(which) = expression.kind
            && self.has(&expression.ty)
        {
            let value = Value::plain(ElementaryType::Lint, which as u64);
            expression.kind = ExpressionKind::Literal(value, LiteralForm::Typed);
        }
        visit_mut::walk_expression(self, expression);
    }

    fn literal(&mut self, expression: &mut Expression) {
        self.expression(expression);
    }

    fn ty(&mut self, ty: &mut Type) {
        if self.has(ty) {
            *ty = Type::Elementary(ElementaryType::Lint);
        }
        visit_mut::walk_type(self, ty);
    }
}
