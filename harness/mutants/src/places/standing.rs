//! The place of `places.toml` in which each expression of a program stands, as the tree shows it.

use super::forms::Forms;
use super::names::{SourceNames, Variables};
use stickler_syntax::source::{LineIndex, Span};
use stickler_syntax::tree::{
    Argument, BinaryOperator, CaseLabel, Declaration, ExpressionId, ExpressionKind, Initializer,
    InitializerKind, Pou, PouKind, SourceUnit, Statement, StatementKind, TypeSpecification,
    TypeSpecificationKind, VariableGroup, VariableKind,
};

/// The places of an expression, by their names in `places.toml`; a place that is not among those has a name of its own, or none.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct PlaceOfExpression {
    /// The form of the expression; of one that is written, the form of the value.
    pub source: Option<&'static str>,
    /// The form of what a bit is selected of, where the expression selects one.
    pub base: Option<&'static str>,
    /// The place that the value goes to.
    pub target: Option<&'static str>,
    /// The statement or the body around both.
    pub surrounding: Option<&'static str>,
    /// The call that the expression is an argument of.
    pub call: Option<ExpressionId>,
    /// Whether the expression is written, not read.
    pub written: bool,
}

impl PlaceOfExpression {
    /// Returns the places of a bit: where it is read, its source is that of what it is part of.
    pub fn of_bit(self) -> PlaceOfExpression {
        let source = if self.written { self.source } else { self.base };
        PlaceOfExpression { source, ..self }
    }
}

/// The places of all expressions of a program.
#[derive(Debug)]
pub struct Standings(Vec<PlaceOfExpression>);

impl Standings {
    /// Finds the places of all expressions.
    pub fn new(unit: &SourceUnit<'_>, lines: &LineIndex) -> Standings {
        let names = SourceNames::new(unit);
        let mut walk = Walk {
            forms: Forms {
                unit,
                names: &names,
                variables: Variables::default(),
            },
            lines,
            found: vec![PlaceOfExpression::default(); unit.expressions.len()],
            around: Vec::new(),
            body: None,
            waiting: Vec::new(),
        };
        for declaration in &unit.declarations {
            walk.declaration(declaration);
        }
        Standings(walk.found)
    }

    /// Returns the places of an expression.
    pub fn of(&self, id: ExpressionId) -> PlaceOfExpression {
        self.0.get(id.0 as usize).copied().unwrap_or_default()
    }
}

struct Walk<'w, 'u> {
    forms: Forms<'w, 'u>,
    lines: &'w LineIndex,
    found: Vec<PlaceOfExpression>,
    /// The statements around, the innermost last.
    around: Vec<&'static str>,
    /// The body around.
    body: Option<&'static str>,
    /// Expressions whose parts have not been visited yet.
    waiting: Vec<(ExpressionId, PlaceOfExpression)>,
}

impl<'u> Walk<'_, 'u> {
    fn declaration(&mut self, declaration: &'u Declaration<'u>) {
        match declaration {
            Declaration::Pou(pou) => self.pou(pou),
            Declaration::Types(types) => {
                for declared in types {
                    self.specification(&declared.specification);
                    if let Some(initializer) = &declared.initializer {
                        self.initializer(initializer, "type-initial-value", false);
                    }
                }
            }
            Declaration::Globals(block) => self.groups(&block.groups, "initial-value"),
            Declaration::Configuration(configuration) => {
                for block in &configuration.globals {
                    self.groups(&block.groups, "initial-value");
                }
            }
        }
    }

    fn pou(&mut self, pou: &'u Pou<'u>) {
        self.forms.variables = Variables::new(pou);
        let body = match pou.kind {
            PouKind::Program => "program",
            PouKind::Function => "function",
            PouKind::FunctionBlock => "function-block",
        };
        self.body = Some(body);
        for block in &pou.blocks {
            let input = block.kind == VariableKind::Input && pou.kind == PouKind::FunctionBlock;
            let target = if input {
                "input-initial-value"
            } else {
                "initial-value"
            };
            self.groups(&block.groups, target);
        }
        self.statements(&pou.body);
        self.forms.variables = Variables::default();
        self.body = None;
    }

    fn groups(&mut self, groups: &'u [VariableGroup<'u>], target: &'static str) {
        for group in groups {
            self.specification(&group.specification);
            if let Some(initializer) = &group.initializer {
                self.initializer(
                    initializer,
                    target,
                    self.forms.names.is_block(&group.specification),
                );
            }
        }
    }

    fn specification(&mut self, specification: &'u TypeSpecification<'u>) {
        match &specification.kind {
            TypeSpecificationKind::Structure(groups) => self.groups(groups, "type-initial-value"),
            TypeSpecificationKind::Array { element, .. } => self.specification(element),
            _ => {}
        }
    }

    fn initializer(&mut self, initializer: &'u Initializer<'u>, target: &'static str, instance: bool) {
        match &initializer.kind {
            InitializerKind::Expression(id) => self.value(*id, target),
            InitializerKind::Array(elements) => {
                for element in elements {
                    let target = match element.repetition {
                        Some(_) => "array-repetition",
                        None => "array-initial-value",
                    };
                    if let Some(value) = &element.value {
                        self.initializer(value, target, false);
                    }
                }
            }
            InitializerKind::Structure(fields) => {
                let target = if instance {
                    "instance-initial-value"
                } else {
                    "structure-initial-value"
                };
                for (_, value) in fields {
                    self.initializer(value, target, false);
                }
            }
        }
    }

    fn statements(&mut self, statements: &'u [Statement]) {
        for (index, statement) in statements.iter().enumerate() {
            let before = index.checked_sub(1).and_then(|before| statements.get(before));
            let on_its_line =
                before.is_some_and(|before| self.line(before.span) == self.line(statement.span));
            let returns = statements
                .get(index + 1)
                .is_some_and(|next| next.kind == StatementKind::Return);
            let depth = self.around.len();
            if on_its_line && depth == 0 {
                self.around.push("second-on-a-line");
            }
            self.statement(statement, returns);
            self.around.truncate(depth);
        }
    }

    fn line(&self, span: Span) -> u32 {
        self.lines.line(span.start)
    }

    fn inside(&mut self, around: &'static str, statements: &'u [Statement]) {
        self.around.push(around);
        self.statements(statements);
        self.around.pop();
    }

    fn statement(&mut self, statement: &'u Statement, returns: bool) {
        match &statement.kind {
            StatementKind::Assignment { target, value } => self.assignment(*target, *value, returns),
            StatementKind::Call(id) => self.value(*id, "call"),
            StatementKind::If { branches, otherwise } => {
                for (index, (condition, body)) in branches.iter().enumerate() {
                    let (target, around) = match index {
                        0 => ("if-condition", "if"),
                        _ => ("elsif-condition", "elsif"),
                    };
                    self.value(*condition, target);
                    self.inside(around, body);
                }
                self.inside("else", otherwise.as_deref().unwrap_or_default());
            }
            StatementKind::Case {
                selector,
                branches,
                otherwise,
            } => {
                self.value(*selector, "case-selector");
                for branch in branches {
                    for label in &branch.labels {
                        match label {
                            CaseLabel::Value(value) => self.value(*value, "case-label"),
                            CaseLabel::Range(low, high) => {
                                self.value(*low, "case-label");
                                self.value(*high, "case-label");
                            }
                        }
                    }
                    self.inside("case", &branch.body);
                }
                self.inside("case", otherwise.as_deref().unwrap_or_default());
            }
            StatementKind::For {
                from, to, by, body, ..
            } => {
                self.value(*from, "for-start");
                self.value(*to, "for-end");
                if let Some(by) = by {
                    self.value(*by, "for-step");
                }
                self.inside("for", body);
            }
            StatementKind::While { condition, body } => {
                self.value(*condition, "while-condition");
                self.inside("while", body);
            }
            StatementKind::Repeat { body, until } => {
                self.inside("repeat", body);
                self.value(*until, "until-condition");
            }
            StatementKind::Exit | StatementKind::Continue | StatementKind::Return | StatementKind::Empty => {}
        }
    }

    fn assignment(&mut self, target: ExpressionId, value: ExpressionId, returns: bool) {
        let place = self.forms.target(target).map(|place| match (place, returns) {
            ("result", true) => "result-and-return",
            _ => place,
        });
        let written = PlaceOfExpression {
            source: self.forms.source(value),
            target: place,
            written: true,
            ..self.here()
        };
        self.found[target.0 as usize] = written;
        self.parts(target, written);
        let arriving = PlaceOfExpression {
            target: place,
            ..self.here()
        };
        self.visit(value, arriving);
    }

    /// Returns the surrounding of what stands here, with no source and no target.
    fn here(&self) -> PlaceOfExpression {
        let surrounding = match self.around[..] {
            [] => self.body,
            [.., _, _, _] => Some("nested"),
            [.., innermost] => Some(innermost),
        };
        PlaceOfExpression {
            surrounding,
            ..PlaceOfExpression::default()
        }
    }

    fn value(&mut self, id: ExpressionId, target: &'static str) {
        let standing = PlaceOfExpression {
            target: Some(target),
            ..self.here()
        };
        self.visit(id, standing);
    }

    /// Visits an expression and all of its parts. A chain of operators may be long, so this does not recurse.
    fn visit(&mut self, id: ExpressionId, standing: PlaceOfExpression) {
        self.waiting.push((id, standing));
        while let Some((id, standing)) = self.waiting.pop() {
            self.found[id.0 as usize] = PlaceOfExpression {
                source: self.forms.source(id),
                base: self.forms.base(id),
                ..standing
            };
            self.parts(id, standing);
        }
    }

    /// Visits the parts of an expression later.
    fn parts(&mut self, id: ExpressionId, standing: PlaceOfExpression) {
        let elsewhere = |target| PlaceOfExpression {
            target: Some(target),
            call: None,
            written: false,
            ..standing
        };
        match &self.forms.unit.expressions[id.0 as usize].kind {
            ExpressionKind::Parenthesized(inner) | ExpressionKind::Unary { operand: inner, .. } => {
                self.waiting.push((*inner, standing));
            }
            ExpressionKind::Binary {
                operator,
                left,
                right,
            } => {
                let [left_place, right_place] = operands(*operator);
                let operands = [(*right, elsewhere(right_place)), (*left, elsewhere(left_place))];
                self.waiting.extend(operands);
            }
            ExpressionKind::Field { base, .. }
            | ExpressionKind::Bit { base, .. }
            | ExpressionKind::Part { base, .. } => {
                self.waiting.push((*base, elsewhere("part")));
            }
            ExpressionKind::Index { base, subscripts } => {
                self.waiting.push((*base, elsewhere("part")));
                let subscripts = subscripts.iter().map(|&id| (id, elsewhere("subscript")));
                self.waiting.extend(subscripts);
            }
            ExpressionKind::Call { callee, arguments } => {
                let arguments = arguments
                    .iter()
                    .map(|argument| self.argument(id, *callee, argument, standing));
                let arguments: Vec<_> = arguments.collect();
                self.waiting.extend(arguments);
            }
            ExpressionKind::Literal(_)
            | ExpressionKind::Name(_)
            | ExpressionKind::EnumeratedValue(_)
            | ExpressionKind::Error => {}
        }
    }

    fn argument(
        &self,
        call: ExpressionId,
        callee: ExpressionId,
        argument: &Argument<'_>,
        standing: PlaceOfExpression,
    ) -> (ExpressionId, PlaceOfExpression) {
        let name = match &self.forms.unit.expressions[callee.0 as usize].kind {
            ExpressionKind::Name(name) => name.text,
            _ => "",
        };
        let called = self.forms.names.pou(name);
        let function = called == Some(PouKind::Function);
        let block = self.forms.is_instance(callee);
        let within = standing
            .target
            .is_some_and(|target| target.starts_with("argument"));
        let (id, target) = match argument {
            Argument::Positional(id) if function => (*id, "argument-by-position"),
            Argument::Named { value, .. } if function && within => (*value, "argument-in-an-argument"),
            Argument::Named { value, .. } if function => (*value, "argument"),
            Argument::Named { value: id, .. } | Argument::Positional(id) if block => (*id, "block-input"),
            Argument::Output { target, .. } if function => (*target, "function-output"),
            Argument::Output { target, .. } => (*target, "block-output"),
            Argument::Named { value: id, .. } | Argument::Positional(id) => (*id, standard_argument(name)),
        };
        let standing = PlaceOfExpression {
            target: Some(target),
            call: Some(call),
            written: matches!(argument, Argument::Output { .. }),
            ..standing
        };
        (id, standing)
    }
}

/// Returns the places of the two operands of an operator.
const fn operands(operator: BinaryOperator) -> [&'static str; 2] {
    match operator {
        BinaryOperator::Or | BinaryOperator::Xor | BinaryOperator::And => ["bit-operand", "bit-operand"],
        BinaryOperator::Add
        | BinaryOperator::Subtract
        | BinaryOperator::Multiply
        | BinaryOperator::Divide
        | BinaryOperator::Modulo
        | BinaryOperator::Power => ["left-operand", "right-operand"],
        BinaryOperator::Equal
        | BinaryOperator::NotEqual
        | BinaryOperator::Less
        | BinaryOperator::Greater
        | BinaryOperator::LessOrEqual
        | BinaryOperator::GreaterOrEqual => ["compared-operand", "compared-operand"],
    }
}

/// Returns the place of the arguments of a function that the text does not declare.
fn standard_argument(name: &str) -> &'static str {
    const PLACES: [(&str, &str); 4] = [
        ("SEL", "sel-argument"),
        ("MUX", "mux-argument"),
        ("MAX", "max-argument"),
        ("LIMIT", "limit-argument"),
    ];
    let place = PLACES
        .iter()
        .find(|(function, _)| function.eq_ignore_ascii_case(name));
    place.map_or("standard-argument", |(_, place)| place)
}
