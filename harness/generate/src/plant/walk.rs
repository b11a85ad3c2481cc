//! The places of a program where an error can be planted: every expression with its context, and every list of statements.

use super::scope::{element_and_limits, written};
use crate::model::visit_mut::{bodies, initial_values};
use crate::model::{
    Argument, AssignmentTarget, BinaryOperator, CaseLabel, DeclaredKind, Expression, ExpressionKind, ForLoop,
    Place, PlaceSelector, Program, StandardFunction, Statement, Type, UnaryOperator, Unit, Variable,
    VariableId, VariableSection,
};
use stickler_types::ElementaryType;

/// The context in which an expression stands.
#[derive(Clone, Copy, PartialEq, Debug, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum ExpressionContext {
    /// The right side of an assignment to a variable, a part of one, or a bit.
    Assigned,
    /// The right side of an assignment to the result of a function.
    Result,
    /// An initial value, an element or a field of one, or the default of a field.
    Initial,
    /// An argument of a function of the program.
    Argument,
    /// An input of a function block, in its call.
    Input,
    /// The argument of a function block's VAR_IN_OUT.
    InOut,
    /// The argument of a conversion function whose name states the operand type.
    Converted,
    /// The argument of any other conversion function.
    Overloaded,
    /// The argument of a standard function, and its index.
    #[serde(skip)]
    Standard(StandardFunction, usize),
    /// The condition of IF.
    If,
    /// The condition of ELSIF.
    ElsIf,
    /// The condition of WHILE.
    While,
    /// The condition of REPEAT.
    Until,
    /// The selector of CASE.
    Selector,
    /// A label of CASE.
    Label,
    /// A subscript, with the limits of its dimension.
    #[serde(skip)]
    Subscript(i64, i64),
    /// The first or last value of FOR.
    Bound,
    /// The step of FOR.
    Step,
    /// An operand of a binary operator, and the type that the text of the other operand determines; `None` if that takes its
    /// type from its context.
    #[serde(skip)]
    Operand(BinaryOperator, Option<ElementaryType>),
    /// The operand of a unary operator.
    #[serde(skip)]
    UnaryOperand(UnaryOperator),
}

impl ExpressionContext {
    /// Returns whether the expression is the whole value of a variable or a parameter, or of the result of a function, that takes it
    /// in a statement.
    pub const fn has_target(self) -> bool {
        use ExpressionContext as C;
        matches!(self, C::Assigned | C::Result | C::Argument | C::Input)
    }
}

/// The place of an expression in the program.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct ExpressionSite {
    /// The program organization unit that contains the expression.
    pub unit: Unit,
    /// The context that determines the expected type.
    pub context: ExpressionContext,
}

/// Visits every expression of `copy`, outer ones before inner ones. The operand of an implicit conversion is not visited
/// itself, only the conversion. Types are looked up in `original`, the program before anything was planted in `copy`.
pub(super) fn expressions(
    original: &Program,
    copy: &mut Program,
    visit: &mut dyn FnMut(ExpressionSite, &mut Expression),
) {
    let mut walker = SiteWalker {
        program: original,
        unit: Unit::Types,
        visit,
    };
    for declaration in &mut copy.types {
        if let DeclaredKind::Structure(fields) = &mut declaration.kind {
            for default in fields.iter_mut().filter_map(|(_, _, default)| default.as_mut()) {
                walker.expression(default, ExpressionContext::Initial);
            }
        }
    }
    for unit in Unit::all(copy) {
        if let Some(pou) = unit.pou_mut(copy) {
            walker.unit = unit;
            walker.initial_values(&mut pou.variables);
            walker.statements(&mut pou.body);
        }
    }
}

/// Visits every list of statements, with whether it stands in a loop; outer lists before inner ones.
pub(super) fn lists(copy: &mut Program, visit: &mut dyn FnMut(Unit, bool, &mut Vec<Statement>)) {
    for unit in Unit::all(copy) {
        if let Some(pou) = unit.pou_mut(copy) {
            list(unit, false, &mut pou.body, visit);
        }
    }
}

fn list(
    unit: Unit,
    in_loop: bool,
    statements: &mut Vec<Statement>,
    visit: &mut dyn FnMut(Unit, bool, &mut Vec<Statement>),
) {
    visit(unit, in_loop, statements);
    for statement in statements {
        let in_loop = in_loop || statement.is_loop();
        for body in bodies(statement) {
            list(unit, in_loop, body, visit);
        }
    }
}

/// Visits the expressions of one unit.
struct SiteWalker<'p, 'v> {
    program: &'p Program,
    unit: Unit,
    visit: &'v mut dyn FnMut(ExpressionSite, &mut Expression),
}

impl<'p> SiteWalker<'p, '_> {
    fn variable(&self, id: VariableId) -> Option<&'p Variable> {
        self.unit.variables(self.program).get(id.0)
    }

    fn initial_values(&mut self, variables: &mut [Variable]) {
        for initial in variables
            .iter_mut()
            .filter_map(|variable| variable.initial.as_mut())
        {
            for value in initial_values(initial) {
                self.expression(value, ExpressionContext::Initial);
            }
        }
    }

    fn statements(&mut self, statements: &mut [Statement]) {
        for statement in statements {
            self.statement(statement);
        }
    }

    fn statement(&mut self, statement: &mut Statement) {
        match statement {
            Statement::Assign(target, value) => {
                let context = match target {
                    AssignmentTarget::Place(place) | AssignmentTarget::Bit(place, _) => {
                        self.place(place);
                        ExpressionContext::Assigned
                    }
                    AssignmentTarget::Result => ExpressionContext::Result,
                };
                self.expression(value, context);
            }
            Statement::If(branches, otherwise) => {
                for (number, (condition, body)) in branches.iter_mut().enumerate() {
                    let is_first = number == 0;
                    let context = if is_first {
                        ExpressionContext::If
                    } else {
                        ExpressionContext::ElsIf
                    };
                    self.expression(condition, context);
                    self.statements(body);
                }
                self.statements(otherwise.as_deref_mut().unwrap_or_default());
            }
            Statement::Case(selector, branches, otherwise) => {
                self.expression(selector, ExpressionContext::Selector);
                for branch in branches {
                    for label in &mut branch.labels {
                        self.label(label);
                    }
                    self.statements(&mut branch.body);
                }
                self.statements(otherwise.as_deref_mut().unwrap_or_default());
            }
            Statement::For(ForLoop {
                from, to, by, body, ..
            }) => {
                self.expression(from, ExpressionContext::Bound);
                self.expression(to, ExpressionContext::Bound);
                if let Some(by) = by {
                    self.expression(by, ExpressionContext::Step);
                }
                self.statements(body);
            }
            Statement::While(condition, body) => {
                self.expression(condition, ExpressionContext::While);
                self.statements(body);
            }
            Statement::Repeat(body, condition) => {
                self.statements(body);
                self.expression(condition, ExpressionContext::Until);
            }
            Statement::Invoke {
                instance,
                inputs,
                outputs,
            } => {
                for input in inputs {
                    self.input(*instance, input);
                }
                for (_, place) in outputs {
                    self.place(place);
                }
            }
            Statement::Exit | Statement::Return | Statement::Raw(_) => {}
        }
    }

    fn label(&mut self, label: &mut CaseLabel) {
        match label {
            CaseLabel::One(value) => self.expression(value, ExpressionContext::Label),
            CaseLabel::Range(low, high) => {
                self.expression(low, ExpressionContext::Label);
                self.expression(high, ExpressionContext::Label);
            }
        }
    }

    fn input(&mut self, instance: VariableId, input: &mut Argument) {
        let parameters = self
            .variable(instance)
            .map_or(&[][..], |instance| match instance.ty {
                Type::Block(block) => Unit::Block(block).variables(self.program),
                _ => &[],
            });
        let context = match parameters
            .get(input.parameter.0)
            .map(|parameter| parameter.section)
        {
            Some(VariableSection::InOut) => ExpressionContext::InOut,
            _ => ExpressionContext::Input,
        };
        self.expression(&mut input.value, context);
    }

    fn place(&mut self, place: &mut Place) {
        let mut within = self.variable(place.variable).map(|variable| &variable.ty);
        for selector in &mut place.path {
            if let PlaceSelector::Index(subscripts) = selector {
                let limits = within.and_then(|ty| element_and_limits(self.program, ty));
                for (number, subscript) in subscripts.iter_mut().enumerate() {
                    // Only an ill-formed program subscripts something without limits.
                    let limits = limits.and_then(|(_, limits)| limits.get(number));
                    let &(low, high) = limits.unwrap_or(&(0, 0));
                    self.expression(subscript, ExpressionContext::Subscript(low, high));
                }
            }
            within = within.and_then(|ty| self.program.selected_type(ty, selector));
        }
    }

    fn expression(&mut self, expression: &mut Expression, context: ExpressionContext) {
        let site = ExpressionSite {
            unit: self.unit,
            context,
        };
        (self.visit)(site, expression);
        self.inside(expression);
    }

    /// Visits the operands of an expression.
    fn inside(&mut self, expression: &mut Expression) {
        match &mut expression.kind {
            ExpressionKind::Read(place) | ExpressionKind::Bit(place, _) => self.place(place),
            ExpressionKind::Unary(operator, operand) => {
                self.expression(operand, ExpressionContext::UnaryOperand(*operator));
            }
            ExpressionKind::Binary(operator, left, right) => {
                let (of_left, of_right) = (written(left), written(right));
                self.expression(left, ExpressionContext::Operand(*operator, of_right));
                self.expression(right, ExpressionContext::Operand(*operator, of_left));
            }
            ExpressionKind::Widen(operand) => self.inside(operand),
            ExpressionKind::Convert(signature, operand) => {
                let is_named = |from| signature.function == format!("{from}_TO_{}", signature.result);
                let context = match signature.operands.first().is_some_and(is_named) {
                    true => ExpressionContext::Converted,
                    false => ExpressionContext::Overloaded,
                };
                self.expression(operand, context);
            }
            ExpressionKind::Call(_, arguments) => {
                for argument in arguments {
                    self.expression(&mut argument.value, ExpressionContext::Argument);
                }
            }
            ExpressionKind::Standard(function, arguments) => {
                for (number, argument) in arguments.iter_mut().enumerate() {
                    self.expression(argument, ExpressionContext::Standard(*function, number));
                }
            }
            ExpressionKind::Literal(..) | ExpressionKind::Enumerated(_) | ExpressionKind::Raw(_) => {}
        }
    }
}
