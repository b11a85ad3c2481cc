//! The places of a program where an error can be planted: every expression with its context, and every list of statements.

use super::scope::written;
use crate::model::visit_mut::{
    VisitorMut, bodies, walk_declaration, walk_expression, walk_place, walk_statement, walk_variable,
};
use crate::model::{
    Argument, AssignmentTarget, BinaryOperator, CaseLabel, Expression, ExpressionKind, Place, PlaceSelector,
    Program, StandardFunction, Statement, Type, TypeDeclaration, UnaryOperator, Unit, Variable, VariableId,
    VariableSection,
};
use std::collections::VecDeque;
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
        contexts: VecDeque::new(),
        visit,
    };
    for declaration in &mut copy.types {
        walker.declaration(declaration);
    }
    for unit in Unit::all(copy) {
        if let Some(pou) = unit.pou_mut(copy) {
            walker.unit = unit;
            for variable in &mut pou.variables {
                walker.variable(variable);
            }
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
    /// The contexts of the expressions that are visited next, in their order; that of an initial value where there are none.
    contexts: VecDeque<ExpressionContext>,
    visit: &'v mut dyn FnMut(ExpressionSite, &mut Expression),
}

impl<'p> SiteWalker<'p, '_> {
    /// Visits the operands of an expression; of an implicit conversion those of its operand.
    fn inside(&mut self, expression: &mut Expression) {
        if let ExpressionKind::Widen(operand) = &mut expression.kind {
            return self.inside(operand);
        }
        self.within(of_operands(expression), |walker| {
            walk_expression(walker, expression)
        });
    }

    fn variable_of(&self, id: VariableId) -> Option<&'p Variable> {
        self.unit.variables(self.program).get(id.0)
    }

    /// Visits the parts of something whose own expressions have these contexts.
    fn within(&mut self, contexts: Vec<ExpressionContext>, walk: impl FnOnce(&mut Self)) {
        let outer = std::mem::replace(&mut self.contexts, contexts.into());
        walk(self);
        self.contexts = outer;
    }

    /// Returns the contexts of the expressions that a statement directly consists of.
    fn of_statement(&self, statement: &Statement) -> Vec<ExpressionContext> {
        use ExpressionContext as C;
        match statement {
            Statement::Assign(AssignmentTarget::Result, _) => vec![C::Result],
            Statement::Assign(..) => vec![C::Assigned],
            Statement::If(branches, _) => {
                let others = branches.iter().skip(1).map(|_| C::ElsIf);
                [C::If].into_iter().chain(others).collect()
            }
            Statement::Case(_, branches, _) => {
                let labels = branches.iter().flat_map(|branch| &branch.labels);
                let values = labels.map(|label| match label {
                    CaseLabel::One(_) => 1,
                    CaseLabel::Range(..) => 2,
                });
                let labels = std::iter::repeat_n(C::Label, values.sum());
                [C::Selector].into_iter().chain(labels).collect()
            }
            Statement::For(_) => vec![C::Bound, C::Bound, C::Step],
            Statement::While(..) => vec![C::While],
            Statement::Repeat(..) => vec![C::Until],
            Statement::Invoke { instance, inputs, .. } => {
                let inputs = inputs.iter().map(|input| self.of_input(*instance, input));
                inputs.collect()
            }
            Statement::Exit | Statement::Return | Statement::Raw(_) => Vec::new(),
        }
    }

    fn of_input(&self, instance: VariableId, input: &Argument) -> ExpressionContext {
        let parameters = match self.variable_of(instance).map(|instance| &instance.ty) {
            Some(Type::Block(block)) => Unit::Block(*block).variables(self.program),
            _ => &[],
        };
        let parameter = parameters.get(input.parameter.0);
        match parameter.map(|parameter| parameter.section) {
            Some(VariableSection::InOut) => ExpressionContext::InOut,
            _ => ExpressionContext::Input,
        }
    }
}

impl VisitorMut for SiteWalker<'_, '_> {
    fn declaration(&mut self, declaration: &mut TypeDeclaration) {
        self.within(Vec::new(), |walker| walk_declaration(walker, declaration));
    }

    fn variable(&mut self, variable: &mut Variable) {
        self.within(Vec::new(), |walker| walk_variable(walker, variable));
    }

    fn statement(&mut self, statement: &mut Statement) {
        let contexts = self.of_statement(statement);
        self.within(contexts, |walker| walk_statement(walker, statement));
    }

    fn place(&mut self, place: &mut Place) {
        let mut within = self.variable_of(place.variable).map(|variable| &variable.ty);
        let mut contexts = Vec::new();
        for selector in &place.path {
            if let PlaceSelector::Index(subscripts) = selector {
                let limits = match within.map(|ty| self.program.unaliased(ty)) {
                    Some(Type::Array(array)) => &array.dimensions[..],
                    _ => &[],
                };
                // Only an ill-formed program subscripts something without limits.
                let limits = limits.iter().copied().chain(std::iter::repeat((0, 0)));
                let contexts_of = limits.map(|(low, high)| ExpressionContext::Subscript(low, high));
                contexts.extend(contexts_of.take(subscripts.len()));
            }
            within = within.and_then(|ty| self.program.selected_type(ty, selector));
        }
        self.within(contexts, |walker| walk_place(walker, place));
    }

    fn literal(&mut self, literal: &mut Expression) {
        self.expression(literal);
    }

    fn expression(&mut self, expression: &mut Expression) {
        let context = self.contexts.pop_front();
        let site = ExpressionSite {
            unit: self.unit,
            context: context.unwrap_or(ExpressionContext::Initial),
        };
        (self.visit)(site, expression);
        self.inside(expression);
    }
}

/// Returns the contexts of the operands or arguments of an expression.
fn of_operands(expression: &Expression) -> Vec<ExpressionContext> {
    use ExpressionContext as C;
    match &expression.kind {
        ExpressionKind::Unary(operator, _) => vec![C::UnaryOperand(*operator)],
        ExpressionKind::Binary(operator, left, right) => [right, left]
            .map(|other| C::Operand(*operator, written(other)))
            .to_vec(),
        ExpressionKind::Convert(signature, _) => {
            let is_named = |from| signature.function == format!("{from}_TO_{}", signature.result);
            match signature.operands.first().is_some_and(is_named) {
                true => vec![C::Converted],
                false => vec![C::Overloaded],
            }
        }
        ExpressionKind::Call(_, arguments) => vec![C::Argument; arguments.len()],
        ExpressionKind::Standard(function, arguments) => {
            let numbers = 0..arguments.len();
            numbers.map(|number| C::Standard(*function, number)).collect()
        }
        _ => Vec::new(),
    }
}
