//! Walks a syntax tree in the order of its text, with the context of each part: POU, section, statement, place.
//!
//! The walk keeps its own stack for expressions, so that a chain of a million operators is walked without recursion.

use crate::source::Span;
use crate::tree::{
    Argument, ArrayElement, CaseLabel, Declaration, Expression, ExpressionId, ExpressionKind, Initializer,
    InitializerKind, Pou, SourceUnit, Statement, StatementKind, TypeDeclaration, TypeSpecification,
    TypeSpecificationKind, VariableBlock, VariableGroup,
};

/// The place of an expression in what directly surrounds it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Place {
    /// The variable that an assignment writes.
    Target,
    /// The value that an assignment writes.
    Value,
    /// A call that is a statement.
    Statement,
    /// The condition of IF, ELSIF, WHILE or UNTIL.
    Condition,
    /// The selector of CASE.
    Selector,
    /// A label of a CASE branch, or a limit of one.
    Label,
    /// The control variable of FOR.
    Control,
    /// The first value of FOR.
    From,
    /// The limit of FOR.
    To,
    /// The increment of FOR.
    By,
    /// The initial value of a variable, type, field or array element.
    InitialValue,
    /// The number of repetitions in the initial value of an array.
    Repetition,
    /// A limit of a subrange or of a dimension of an array.
    Limit,
    /// The length of a text type.
    Length,
    /// The number that a value of an enumeration is given.
    EnumerationNumber,
    /// A property of a task.
    TaskProperty,
    /// The function or instance that a call names.
    Callee,
    /// An argument without the name of its parameter.
    Argument,
    /// The value of an argument with the name of its parameter.
    NamedArgument,
    /// The variable that takes an output.
    OutputArgument,
    /// What a field, an element or a bit is selected of.
    Base,
    /// A subscript.
    Subscript,
    /// The operand of a prefix operator, or an expression in parentheses.
    Operand,
    /// The left operand of an infix operator.
    Left,
    /// The right operand of an infix operator.
    Right,
}

/// An expression where it stands.
#[derive(Clone, Copy, Debug)]
pub struct Part<'t, 's> {
    /// The number of the expression.
    pub id: ExpressionId,
    /// The expression.
    pub expression: &'t Expression<'s>,
    /// The place in what directly surrounds it.
    pub place: Place,
    /// The expression that it is a part of.
    pub around: Option<ExpressionId>,
    /// The innermost statement; `None` in a declaration.
    pub statement: Option<&'t Statement>,
    /// The program organization unit, the innermost where one is a method; `None` outside of all.
    pub pou: Option<&'t Pou<'s>>,
}

impl<'s> Part<'_, 's> {
    /// Returns the name that the expression is; `None` of another expression.
    pub fn name(&self) -> Option<&'s str> {
        match &self.expression.kind {
            ExpressionKind::Name(name) => Some(name.text),
            _ => None,
        }
    }

    /// Returns whether the expression is this name.
    pub fn is(&self, name: &str) -> bool {
        self.name().is_some_and(|own| own.eq_ignore_ascii_case(name))
    }

    /// Returns whether the expression is a field or an element.
    pub const fn is_part_of_variable(&self) -> bool {
        matches!(
            self.expression.kind,
            ExpressionKind::Field { .. } | ExpressionKind::Index { .. }
        )
    }
}

/// The surroundings of a part of a tree.
#[derive(Debug)]
pub struct Context<'t, 's> {
    /// The whole tree.
    pub unit: &'t SourceUnit<'s>,
    /// The program organization unit, the innermost where one is a method; `None` outside of all.
    pub pou: Option<&'t Pou<'s>>,
    /// The section of variables; `None` outside of all.
    pub section: Option<&'t VariableBlock<'s>>,
    /// The declaration of a type; `None` outside of all.
    pub declared: Option<&'t TypeDeclaration<'s>>,
    /// The innermost statement; `None` outside of all.
    pub statement: Option<&'t Statement>,
    /// The statements around the innermost one, outer ones first.
    pub around: Vec<&'t Statement>,
    /// The span of the innermost part around that has a span; `None` where only the whole text is.
    pub outer: Option<Span>,
}

impl Context<'_, '_> {
    /// Returns whether a visited declaration is one of the fields of a structure, and not one of the variables of a section.
    pub fn is_field(&self) -> bool {
        self.section.map(|section| section.span) != self.outer
    }
}

/// Hooks that [`walk`] calls for each part of a tree, before its children.
pub trait Visitor<'t, 's: 't> {
    /// Visits a program organization unit.
    fn pou(&mut self, _pou: &'t Pou<'s>, _at: &Context<'t, 's>) {}

    /// Visits the declaration of a type.
    fn type_declaration(&mut self, _declaration: &'t TypeDeclaration<'s>, _at: &Context<'t, 's>) {}

    /// Visits a section of variables.
    fn section(&mut self, _section: &'t VariableBlock<'s>, _at: &Context<'t, 's>) {}

    /// Visits a declaration of variables or of fields.
    fn variables(&mut self, _group: &'t VariableGroup<'s>, _at: &Context<'t, 's>) {}

    /// Visits a type as it is written in a declaration; the element of an array has a visit of its own.
    fn specification(&mut self, _specification: &'t TypeSpecification<'s>, _at: &Context<'t, 's>) {}

    /// Visits an initial value; those of elements and fields have visits of their own.
    fn initializer(&mut self, _initializer: &'t Initializer<'s>, _at: &Context<'t, 's>) {}

    /// Visits a list of statements: a body or a branch.
    fn statements(&mut self, _statements: &'t [Statement], _at: &Context<'t, 's>) {}

    /// Visits a statement.
    fn statement(&mut self, _statement: &'t Statement, _at: &Context<'t, 's>) {}

    /// Visits an expression.
    fn expression(&mut self, _part: Part<'t, 's>, _at: &Context<'t, 's>) {}
}

/// Visits all parts of a tree in the order of the text.
pub fn walk<'t, 's>(unit: &'t SourceUnit<'s>, visitor: &mut impl Visitor<'t, 's>) {
    let context = Context {
        unit,
        pou: None,
        section: None,
        declared: None,
        statement: None,
        around: Vec::new(),
        outer: None,
    };
    let mut walk = Walk {
        visitor,
        at: context,
        open: Vec::new(),
    };
    for declaration in &unit.declarations {
        match declaration {
            Declaration::Pou(pou) => walk.pou(pou),
            Declaration::Types(types) => types.iter().for_each(|declared| walk.type_declaration(declared)),
            Declaration::Globals(section) => walk.section(section),
            Declaration::Configuration(configuration) => {
                walk.at.outer = Some(configuration.span);
                configuration
                    .globals
                    .iter()
                    .for_each(|section| walk.section(section));
                let resources = configuration.resources.iter();
                let properties = resources
                    .flat_map(|resource| &resource.tasks)
                    .flat_map(|task| &task.properties);
                properties.for_each(|(_, value)| walk.expression(*value, Place::TaskProperty));
                let configured = configuration.configured.iter();
                configured.for_each(|section| walk.section(section));
                walk.at.outer = None;
            }
            Declaration::Namespace(_) | Declaration::EndNamespace(_) | Declaration::Using(_) => {}
        }
    }
}

/// Returns the lists of statements inside a statement, in the order of the text.
pub fn bodies(statement: &Statement) -> Vec<&[Statement]> {
    match &statement.kind {
        StatementKind::If { branches, otherwise } => {
            let branches = branches.iter().map(|(_, body)| body.as_slice());
            branches.chain(otherwise.as_deref()).collect()
        }
        StatementKind::Case {
            branches, otherwise, ..
        } => {
            let branches = branches.iter().map(|branch| branch.body.as_slice());
            branches.chain(otherwise.as_deref()).collect()
        }
        StatementKind::For { body, .. }
        | StatementKind::While { body, .. }
        | StatementKind::Repeat { body, .. } => vec![body],
        StatementKind::Assignment { .. }
        | StatementKind::Binding { .. }
        | StatementKind::Call(_)
        | StatementKind::Exit
        | StatementKind::Continue
        | StatementKind::Return
        | StatementKind::Jump(_)
        | StatementKind::Label(_)
        | StatementKind::Empty => Vec::new(),
    }
}

/// Returns the expressions that an expression directly consists of, with their places, in the order of the text.
pub fn operands(expression: &Expression<'_>) -> Vec<(ExpressionId, Place)> {
    match &expression.kind {
        ExpressionKind::Unary { operand, .. } | ExpressionKind::Parenthesized(operand) => {
            vec![(*operand, Place::Operand)]
        }
        ExpressionKind::Binary { left, right, .. } => vec![(*left, Place::Left), (*right, Place::Right)],
        ExpressionKind::Assigned { target, value } => vec![(*target, Place::Target), (*value, Place::Value)],
        ExpressionKind::Call { callee, arguments } => {
            let arguments = arguments.iter().map(|argument| match argument {
                Argument::Positional(value) => (*value, Place::Argument),
                Argument::Named { value, .. } => (*value, Place::NamedArgument),
                Argument::Output { target, .. } => (*target, Place::OutputArgument),
            });
            std::iter::once((*callee, Place::Callee))
                .chain(arguments)
                .collect()
        }
        ExpressionKind::Field { base, .. }
        | ExpressionKind::Dereference { base }
        | ExpressionKind::Bit { base, .. }
        | ExpressionKind::Part { base, .. } => vec![(*base, Place::Base)],
        ExpressionKind::Index { base, subscripts } => {
            let subscripts = subscripts.iter().map(|subscript| (*subscript, Place::Subscript));
            std::iter::once((*base, Place::Base)).chain(subscripts).collect()
        }
        ExpressionKind::Literal(_)
        | ExpressionKind::Name(_)
        | ExpressionKind::EnumeratedValue(_)
        | ExpressionKind::Aggregate(_)
        | ExpressionKind::Error => Vec::new(),
    }
}

/// A walk that is under way.
struct Walk<'w, 't, 's, V> {
    visitor: &'w mut V,
    at: Context<'t, 's>,
    /// The expressions that are still to be visited, the next one last.
    open: Vec<(ExpressionId, Place, Option<ExpressionId>)>,
}

impl<'t, 's, V: Visitor<'t, 's>> Walk<'_, 't, 's, V> {
    fn pou(&mut self, pou: &'t Pou<'s>) {
        let around = self.at.pou.replace(pou);
        self.visitor.pou(pou, &self.at);
        let outer = self.at.outer.replace(pou.span);
        if let Some(result) = &pou.result {
            self.specification(result);
        }
        pou.blocks.iter().for_each(|section| self.section(section));
        pou.members.iter().for_each(|member| self.pou(member));
        self.statements(&pou.body);
        self.at.outer = outer;
        self.at.pou = around;
    }

    fn type_declaration(&mut self, declared: &'t TypeDeclaration<'s>) {
        self.at.declared = Some(declared);
        self.visitor.type_declaration(declared, &self.at);
        self.specification(&declared.specification);
        if let Some(initializer) = &declared.initializer {
            self.initializer(initializer);
        }
        self.at.declared = None;
    }

    fn section(&mut self, section: &'t VariableBlock<'s>) {
        self.at.section = Some(section);
        self.visitor.section(section, &self.at);
        let outer = self.at.outer.replace(section.span);
        section.groups.iter().for_each(|group| self.variables(group));
        self.at.outer = outer;
        self.at.section = None;
    }

    fn variables(&mut self, group: &'t VariableGroup<'s>) {
        self.visitor.variables(group, &self.at);
        self.specification(&group.specification);
        if let Some(initializer) = &group.initializer {
            self.initializer(initializer);
        }
    }

    fn specification(&mut self, specification: &'t TypeSpecification<'s>) {
        self.visitor.specification(specification, &self.at);
        let outer = self.at.outer.replace(specification.span);
        match &specification.kind {
            TypeSpecificationKind::Named(_) | TypeSpecificationKind::Error => {}
            TypeSpecificationKind::Text { length, .. } => self.expression(*length, Place::Length),
            TypeSpecificationKind::Subrange { limits, .. } => self.limits(*limits),
            TypeSpecificationKind::Array { dimensions, element } => {
                dimensions.iter().for_each(|limits| self.limits(*limits));
                self.specification(element);
            }
            TypeSpecificationKind::Pointer { target: inner, .. }
            | TypeSpecificationKind::VariableLengthArray { element: inner, .. } => self.specification(inner),
            TypeSpecificationKind::Enumeration { values, .. } => {
                let numbers = values.iter().filter_map(|(_, number)| *number);
                numbers.for_each(|number| self.expression(number, Place::EnumerationNumber));
            }
            TypeSpecificationKind::Structure(fields) | TypeSpecificationKind::Union(fields) => {
                fields.iter().for_each(|field| self.variables(field));
            }
        }
        self.at.outer = outer;
    }

    fn limits(&mut self, (low, high): (ExpressionId, ExpressionId)) {
        self.expression(low, Place::Limit);
        self.expression(high, Place::Limit);
    }

    fn initializer(&mut self, initializer: &'t Initializer<'s>) {
        self.visitor.initializer(initializer, &self.at);
        let outer = self.at.outer.replace(initializer.span);
        match &initializer.kind {
            InitializerKind::Expression(value) => self.expression(*value, Place::InitialValue),
            InitializerKind::Array(elements) => {
                for ArrayElement { repetition, values } in elements {
                    if let Some(repetition) = repetition {
                        self.expression(*repetition, Place::Repetition);
                    }
                    values.iter().for_each(|value| self.initializer(value));
                }
            }
            InitializerKind::Structure(fields) => {
                fields.iter().for_each(|(_, value)| self.initializer(value))
            }
        }
        self.at.outer = outer;
    }

    fn statements(&mut self, statements: &'t [Statement]) {
        self.visitor.statements(statements, &self.at);
        let outer = self.at.statement;
        self.at.around.extend(outer);
        for statement in statements {
            self.at.statement = Some(statement);
            self.statement(statement);
        }
        self.at.statement = outer;
        if outer.is_some() {
            self.at.around.pop();
        }
    }

    fn statement(&mut self, statement: &'t Statement) {
        self.visitor.statement(statement, &self.at);
        let outer = self.at.outer.replace(statement.span);
        match &statement.kind {
            StatementKind::Assignment { target, value } | StatementKind::Binding { target, value } => {
                self.expression(*target, Place::Target);
                self.expression(*value, Place::Value);
            }
            StatementKind::Call(call) => self.expression(*call, Place::Statement),
            StatementKind::If { branches, otherwise } => {
                for (condition, body) in branches {
                    self.expression(*condition, Place::Condition);
                    self.statements(body);
                }
                self.otherwise(otherwise.as_deref());
            }
            StatementKind::Case {
                selector,
                branches,
                otherwise,
            } => {
                self.expression(*selector, Place::Selector);
                for branch in branches {
                    branch.labels.iter().for_each(|label| self.label(label));
                    self.statements(&branch.body);
                }
                self.otherwise(otherwise.as_deref());
            }
            StatementKind::For {
                control,
                from,
                to,
                by,
                body,
            } => {
                self.expression(*control, Place::Control);
                self.expression(*from, Place::From);
                self.expression(*to, Place::To);
                if let Some(by) = by {
                    self.expression(*by, Place::By);
                }
                self.statements(body);
            }
            StatementKind::While { condition, body } => {
                self.expression(*condition, Place::Condition);
                self.statements(body);
            }
            StatementKind::Repeat { body, until } => {
                self.statements(body);
                self.expression(*until, Place::Condition);
            }
            StatementKind::Exit | StatementKind::Continue | StatementKind::Return | StatementKind::Empty => {}
            // Labels are no variables.
            StatementKind::Jump(_) | StatementKind::Label(_) => {}
        }
        self.at.outer = outer;
    }

    fn otherwise(&mut self, otherwise: Option<&'t [Statement]>) {
        if let Some(body) = otherwise {
            self.statements(body);
        }
    }

    fn label(&mut self, label: &CaseLabel) {
        match label {
            CaseLabel::Value(value) => self.expression(*value, Place::Label),
            CaseLabel::Range(low, high) => {
                self.expression(*low, Place::Label);
                self.expression(*high, Place::Label);
            }
        }
    }

    fn expression(&mut self, id: ExpressionId, place: Place) {
        self.open.push((id, place, None));
        while let Some((id, place, around)) = self.open.pop() {
            let Some(expression) = self.at.unit.expression(id) else {
                continue;
            };
            let part = Part {
                id,
                expression,
                place,
                around,
                statement: self.at.statement,
                pou: self.at.pou,
            };
            self.visitor.expression(part, &self.at);
            if let ExpressionKind::Aggregate(initializer) = &expression.kind {
                let open = std::mem::take(&mut self.open);
                self.initializer(initializer);
                self.open = open;
            }
            let parts = operands(expression).into_iter().rev();
            self.open
                .extend(parts.map(|(part, place)| (part, place, Some(id))));
        }
    }
}
