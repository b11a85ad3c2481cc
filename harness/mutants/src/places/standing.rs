//! The place of `places.toml` in which each expression of a program stands, as the tree shows it.

use super::claim::Direction;
use super::forms::Forms;
use super::names::SourceNames;
use rustc_hash::FxHashMap;
use stickler_syntax::source::LineIndex;
use stickler_syntax::tree::{
    BinaryOperator, ExpressionId, ExpressionKind, Initializer, InitializerKind, PouKind, SourceUnit,
    Statement, StatementKind, TypeDeclaration, VariableGroup, VariableKind,
};
use stickler_syntax::visitor::{Context, Part, Place, Visitor, bodies, walk};

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
    /// Returns whether the expression is read or written.
    pub const fn direction(self) -> Direction {
        match self.written {
            true => Direction::Written,
            false => Direction::Read,
        }
    }

    /// Returns the places of a bit: where it is read, its source is that of what it is part of.
    pub fn of_bit(self) -> PlaceOfExpression {
        let source = if self.written { self.source } else { self.base };
        PlaceOfExpression { source, ..self }
    }
}

/// The places of all expressions of a program; `None` for those that hold no value of the program.
#[derive(Debug)]
pub struct Standings(Vec<Option<PlaceOfExpression>>);

impl Standings {
    /// Finds the places of all expressions.
    pub fn new(unit: &SourceUnit<'_>, lines: &LineIndex) -> Standings {
        let names = SourceNames::new(unit);
        let mut finder = PlaceFinder {
            forms: Forms {
                unit,
                names: &names,
                pou: None,
            },
            lines,
            found: vec![None; unit.expressions.len()],
            initial: FxHashMap::default(),
            statements: FxHashMap::default(),
        };
        walk(unit, &mut finder);
        Standings(finder.found)
    }

    /// Returns the places of an expression.
    pub fn of(&self, id: ExpressionId) -> PlaceOfExpression {
        self.0.get(id.0 as usize).copied().flatten().unwrap_or_default()
    }
}

struct PlaceFinder<'w, 'u> {
    forms: Forms<'w, 'u>,
    lines: &'w LineIndex,
    found: Vec<Option<PlaceOfExpression>>,
    /// The places of initial values.
    initial: FxHashMap<ExpressionId, &'static str>,
    /// The places of statements, by where these begin.
    statements: FxHashMap<u32, PlaceOfStatement>,
}

/// What stands around a statement.
#[derive(Clone, Default)]
struct PlaceOfStatement {
    /// The statements around, the innermost last.
    around: Vec<&'static str>,
    /// Whether RETURN follows.
    returns: bool,
}

impl<'u> Visitor<'u, 'u> for PlaceFinder<'_, 'u> {
    fn type_declaration(&mut self, declared: &'u TypeDeclaration<'u>, _: &Context<'u, 'u>) {
        self.initial(declared.initializer.as_ref(), "type-initial-value");
    }

    fn variables(&mut self, group: &'u VariableGroup<'u>, at: &Context<'u, 'u>) {
        let is_block = at.pou.is_some_and(|pou| pou.kind == PouKind::FunctionBlock);
        let target = match at.section {
            None => "type-initial-value",
            Some(section) if is_block && section.kind == VariableKind::Input => "input-initial-value",
            Some(_) => "initial-value",
        };
        self.initial(group.initializer.as_ref(), target);
        if let Some(Initializer {
            kind: InitializerKind::Structure(fields),
            ..
        }) = &group.initializer
            && self.forms.names.is_block(&group.specification)
        {
            for (_, value) in fields {
                self.initial(Some(value), "instance-initial-value");
            }
        }
    }

    fn initializer(&mut self, initializer: &'u Initializer<'u>, _: &Context<'u, 'u>) {
        match &initializer.kind {
            InitializerKind::Expression(_) => {}
            InitializerKind::Array(elements) => {
                for element in elements {
                    let target = match element.repetition {
                        Some(_) => "array-repetition",
                        None => "array-initial-value",
                    };
                    for value in &element.values {
                        self.initial(Some(value), target);
                    }
                }
            }
            InitializerKind::Structure(fields) => {
                for (_, value) in fields {
                    self.initial(Some(value), "structure-initial-value");
                }
            }
        }
    }

    fn statements(&mut self, statements: &'u [Statement], at: &Context<'u, 'u>) {
        let mut around = self.around(at).to_vec();
        around.extend(at.statement.map(|outer| branch(outer, statements)));
        let line = |statement: &Statement| self.lines.line(statement.span.start);
        let mut before = None;
        let mut found = Vec::new();
        for (index, statement) in statements.iter().enumerate() {
            let mut around = around.clone();
            if around.is_empty() && before.replace(line(statement)) == Some(line(statement)) {
                around.push("second-on-a-line");
            }
            let next = statements.get(index + 1);
            let returns = next.is_some_and(|next| next.kind == StatementKind::Return);
            found.push((statement.span.start, PlaceOfStatement { around, returns }));
        }
        self.statements.extend(found);
    }

    fn expression(&mut self, part: Part<'u, 'u>, at: &Context<'u, 'u>) {
        let id = part.id;
        self.forms.pou = at.pou;
        let place = match part.around {
            Some(around) => {
                self.found[around.0 as usize].and_then(|outer| self.part(part.place, (around, outer), at))
            }
            None => self.whole(id, part.place, at),
        };
        self.found[id.0 as usize] = place.map(|place| match place.written && place.call.is_none() {
            // The source is that of the value.
            true => place,
            false => PlaceOfExpression {
                source: self.forms.source(id),
                base: self.forms.base(id),
                ..place
            },
        });
    }
}

impl<'u> PlaceFinder<'_, 'u> {
    /// Notes the place of an initial value that has none yet.
    fn initial(&mut self, initializer: Option<&Initializer<'_>>, target: &'static str) {
        if let Some(InitializerKind::Expression(id)) = initializer.map(|one| &one.kind) {
            self.initial.entry(*id).or_insert(target);
        }
    }

    fn around(&self, at: &Context<'u, 'u>) -> &[&'static str] {
        let statement = at.statement.and_then(|one| self.statements.get(&one.span.start));
        statement.map_or(&[], |place| &place.around)
    }

    /// Returns the places of an expression that is no part of another.
    fn whole(&self, id: ExpressionId, place: Place, at: &Context<'u, 'u>) -> Option<PlaceOfExpression> {
        let surrounding = match self.around(at) {
            [] => at.pou.map(|pou| match pou.kind {
                PouKind::Program => "program",
                PouKind::Function => "function",
                _ => "function-block",
            }),
            [.., _, _, _] => Some("nested"),
            [.., innermost] => Some(*innermost),
        };
        let here = PlaceOfExpression {
            surrounding,
            ..PlaceOfExpression::default()
        };
        let statement = at.statement.map(|statement| &statement.kind);
        let target = match (place, statement) {
            (Place::Target | Place::Value, Some(StatementKind::Assignment { target, value })) => {
                let written = place == Place::Target;
                return Some(PlaceOfExpression {
                    source: self.forms.source(*value).filter(|_| written),
                    target: self.assigned(*target, at),
                    written,
                    ..here
                });
            }
            (Place::InitialValue, _) => self.initial.get(&id).copied()?,
            (Place::Statement, _) => "call",
            (Place::Condition, Some(StatementKind::While { .. })) => "while-condition",
            (Place::Condition, Some(StatementKind::Repeat { .. })) => "until-condition",
            (Place::Condition, Some(StatementKind::If { branches, .. })) => {
                match branches.first().is_some_and(|(first, _)| *first == id) {
                    true => "if-condition",
                    false => "elsif-condition",
                }
            }
            (Place::Selector, _) => "case-selector",
            (Place::Label, _) => "case-label",
            (Place::From, _) => "for-start",
            (Place::To, _) => "for-end",
            (Place::By, _) => "for-step",
            _ => return None,
        };
        Some(PlaceOfExpression {
            target: Some(target),
            ..here
        })
    }

    /// Returns the target that an assignment writes.
    fn assigned(&self, target: ExpressionId, at: &Context<'u, 'u>) -> Option<&'static str> {
        let statement = at.statement.and_then(|one| self.statements.get(&one.span.start));
        let returns = statement.is_some_and(|place| place.returns);
        self.forms.target(target).map(|place| match (place, returns) {
            ("result", true) => "result-and-return",
            _ => place,
        })
    }

    /// Returns the places of a part of an expression that has the places `outer`.
    fn part(
        &self,
        place: Place,
        (around, outer): (ExpressionId, PlaceOfExpression),
        at: &Context<'u, 'u>,
    ) -> Option<PlaceOfExpression> {
        let target = match (place, &at.unit.expression(around)?.kind) {
            (Place::Operand, _) => return Some(outer),
            (Place::Left, ExpressionKind::Binary { operator, .. }) => operands(*operator)[0],
            (Place::Right, ExpressionKind::Binary { operator, .. }) => operands(*operator)[1],
            (Place::Base, _) => "part",
            (Place::Subscript, _) => "subscript",
            (
                Place::Argument | Place::NamedArgument | Place::OutputArgument,
                ExpressionKind::Call { callee, .. },
            ) => {
                return Some(PlaceOfExpression {
                    target: Some(self.argument(*callee, place, outer)),
                    call: Some(around),
                    written: place == Place::OutputArgument,
                    ..outer
                });
            }
            _ => return None,
        };
        Some(PlaceOfExpression {
            target: Some(target),
            call: None,
            written: false,
            ..outer
        })
    }

    /// Returns the target that an argument of a call is.
    fn argument(&self, callee: ExpressionId, place: Place, outer: PlaceOfExpression) -> &'static str {
        let name = match &self.forms.unit.expressions[callee.0 as usize].kind {
            ExpressionKind::Name(name) => name.text,
            _ => "",
        };
        let is_function = self.forms.names.pou(name) == Some(PouKind::Function);
        let within = outer.target.is_some_and(|target| target.starts_with("argument"));
        match place {
            Place::OutputArgument if is_function => "function-output",
            Place::OutputArgument => "block-output",
            Place::Argument if is_function => "argument-by-position",
            _ if is_function && within => "argument-in-an-argument",
            _ if is_function => "argument",
            _ if self.forms.is_instance(callee) => "block-input",
            _ => standard_argument(name),
        }
    }
}

/// Returns which part of a statement a list of statements is.
fn branch(outer: &Statement, list: &[Statement]) -> &'static str {
    match &outer.kind {
        StatementKind::If { branches, .. } => {
            let is_it = |body: &&[Statement]| std::ptr::eq(*body, list);
            match bodies(outer).iter().position(is_it) {
                Some(0) => "if",
                Some(index) if index < branches.len() => "elsif",
                _ => "else",
            }
        }
        StatementKind::Case { .. } => "case",
        StatementKind::For { .. } => "for",
        StatementKind::While { .. } => "while",
        _ => "repeat",
    }
}

/// Returns the places of the two operands of an operator.
const fn operands(operator: BinaryOperator) -> [&'static str; 2] {
    match operator {
        BinaryOperator::Or
        | BinaryOperator::OrElse
        | BinaryOperator::Xor
        | BinaryOperator::And
        | BinaryOperator::AndThen => ["bit-operand", "bit-operand"],
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
