//! What a program is made of, counted: for measuring the generator, and for telling findings apart by what is in them.

use crate::model::{
    CaseLabel, Declared, Expression, ExpressionKind, Initial, LiteralForm, Place, Program, Section, Selector,
    Statement, StatementKind, Target, Type, UnaryOperator, Variable,
};
use std::collections::BTreeMap;

/// How often each construct stands in a program, by a name for people, such as `statement FOR`, `widen INT to DINT`,
/// `convert DINT_TO_INT`, `operator MOD of UINT`, `bit written`.
#[must_use]
pub fn census(program: &Program) -> BTreeMap<String, u64> {
    let mut census = Census {
        program,
        counted: BTreeMap::new(),
    };
    census.types();
    for function in &program.functions {
        census.count("function");
        census.pou(&function.variables, &function.body);
    }
    for block in &program.blocks {
        census.count("function block");
        census.pou(&block.variables, &block.body);
    }
    census.pou(&program.main.variables, &program.main.body);
    census.counted
}

struct Census<'p> {
    program: &'p Program,
    counted: BTreeMap<String, u64>,
}

impl Census<'_> {
    fn count(&mut self, construct: impl Into<String>) {
        *self.counted.entry(construct.into()).or_default() += 1;
    }

    fn types(&mut self) {
        let program = self.program;
        for declaration in &program.types {
            match &declaration.kind {
                Declared::Enumeration(_) => self.count("enumeration"),
                Declared::Alias(_) => self.count("alias"),
                Declared::Structure(fields) => {
                    self.count("structure");
                    for (_, ty, initial) in fields {
                        self.declared("field", ty);
                        if let Some(initial) = initial {
                            self.count("initial value of a field");
                            self.expression(initial);
                        }
                    }
                }
            }
        }
    }

    fn declared(&mut self, what: &str, ty: &Type) {
        match ty {
            Type::Elementary(ty) => self.count(format!("{what} {ty}")),
            Type::Array(array) => {
                self.count(format!("{what} ARRAY of {} dimensions", array.dimensions.len()));
                self.declared("element", &array.element);
            }
            Type::Declared(_) => match self.program.unaliased(ty) {
                Type::Declared(_) if self.program.fields(ty).is_some() => {
                    self.count(format!("{what} structure"))
                }
                Type::Declared(_) => self.count(format!("{what} enumeration")),
                _ => self.count(format!("{what} alias")),
            },
            Type::Block(_) => self.count(format!("{what} instance")),
        }
    }

    fn pou(&mut self, variables: &[Variable], body: &[Statement]) {
        for variable in variables {
            self.declared("variable", &variable.ty);
            self.count(match variable.section {
                Section::Local => "section VAR",
                Section::Constant => "section VAR CONSTANT",
                Section::Input => "section VAR_INPUT",
                Section::Output => "section VAR_OUTPUT",
                Section::InOut => "section VAR_IN_OUT",
            });
            self.initial(variable.initial.as_ref());
        }
        self.statements(body);
    }

    fn initial(&mut self, initial: Option<&Initial>) {
        match initial {
            None => {}
            Some(Initial::Expression(value)) => {
                self.count("initial value");
                self.expression(value);
            }
            Some(Initial::Array(values)) => {
                self.count("initial value of an array");
                values.iter().for_each(|value| self.expression(value));
            }
            Some(Initial::Structure(values)) => {
                self.count("initial value of a structure");
                values.iter().for_each(|(_, value)| self.expression(value));
            }
        }
    }

    fn statements(&mut self, statements: &[Statement]) {
        for statement in statements {
            self.statement(statement);
        }
    }

    fn statement(&mut self, statement: &Statement) {
        match &statement.kind {
            StatementKind::Assign(target, value) => {
                self.target(target);
                self.expression(value);
            }
            StatementKind::If(branches, otherwise) => {
                self.count("statement IF");
                for (number, (condition, body)) in branches.iter().enumerate() {
                    if number > 0 {
                        self.count("ELSIF");
                    }
                    self.expression(condition);
                    self.statements(body);
                }
                self.otherwise("ELSE of IF", otherwise.as_deref());
            }
            StatementKind::Case(selector, branches, otherwise) => {
                self.count("statement CASE");
                self.expression(selector);
                for branch in branches {
                    branch.labels.iter().for_each(|label| self.label(label));
                    self.statements(&branch.body);
                }
                self.otherwise("ELSE of CASE", otherwise.as_deref());
            }
            StatementKind::For {
                from, to, by, body, ..
            } => {
                self.count("statement FOR");
                self.expression(from);
                self.expression(to);
                if let Some(by) = by {
                    self.count("BY");
                    self.expression(by);
                }
                self.statements(body);
            }
            StatementKind::While(condition, body) => {
                self.count("statement WHILE");
                self.expression(condition);
                self.statements(body);
            }
            StatementKind::Repeat(body, condition) => {
                self.count("statement REPEAT");
                self.statements(body);
                self.expression(condition);
            }
            StatementKind::Invoke { inputs, outputs, .. } => {
                self.count("statement call of a function block");
                for input in inputs {
                    self.count("argument of a function block");
                    self.expression(&input.value);
                }
                for (_, place) in outputs {
                    self.count("output =>");
                    self.place(place);
                }
            }
            StatementKind::Exit => self.count("statement EXIT"),
            StatementKind::Return => self.count("statement RETURN"),
            StatementKind::Raw(_) => self.count("statement that breaks a rule"),
        }
    }

    fn otherwise(&mut self, what: &str, body: Option<&[Statement]>) {
        if let Some(body) = body {
            self.count(what);
            self.statements(body);
        }
    }

    fn target(&mut self, target: &Target) {
        match target {
            Target::Place(place) => {
                self.count("statement assignment");
                self.place(place);
            }
            Target::Bit(place, _) => {
                self.count("bit written");
                self.place(place);
            }
            Target::Result => self.count("result assigned"),
        }
    }

    fn label(&mut self, label: &CaseLabel) {
        match label {
            CaseLabel::One(value) => {
                self.count("label");
                self.expression(value);
            }
            CaseLabel::Range(low, high) => {
                self.count("label ..");
                self.expression(low);
                self.expression(high);
            }
        }
    }

    fn place(&mut self, place: &Place) {
        for selector in &place.path {
            match selector {
                Selector::Index(subscripts) => {
                    self.count("element");
                    subscripts.iter().for_each(|subscript| self.expression(subscript));
                }
                Selector::Field(_) => self.count("field selected"),
                Selector::Output(_) => self.count("output of an instance"),
            }
        }
    }

    fn expression(&mut self, expression: &Expression) {
        let ty = self.type_name(&expression.ty);
        match &expression.kind {
            ExpressionKind::Literal(_, LiteralForm::Typed) => {
                self.count(format!("literal {ty} with its type"))
            }
            ExpressionKind::Literal(_, LiteralForm::Untyped) => {
                self.count(format!("literal {ty} without its type"))
            }
            ExpressionKind::Enumerated(_) => self.count("enumerated value"),
            ExpressionKind::Read(place) => {
                self.count(format!("read {ty}"));
                self.place(place);
            }
            ExpressionKind::Bit(place, _) => {
                self.count("bit read");
                self.place(place);
            }
            ExpressionKind::Unary(operator, operand) => {
                let operator = if *operator == UnaryOperator::Not {
                    "NOT"
                } else {
                    "- before"
                };
                self.count(format!("operator {operator} {ty}"));
                self.expression(operand);
            }
            ExpressionKind::Binary(operator, left, right) => {
                let operands = self.type_name(&left.ty);
                self.count(format!(
                    "operator {} of {operands}",
                    crate::writer::operator_text(*operator)
                ));
                self.expression(left);
                self.expression(right);
            }
            ExpressionKind::Widen(operand) => {
                let from = self.type_name(&operand.ty);
                self.count(format!("widen {from} to {ty}"));
                self.expression(operand);
            }
            ExpressionKind::Convert(signature, operand) => {
                self.count(format!("convert {}", signature.function));
                self.expression(operand);
            }
            ExpressionKind::Call(function, arguments) => {
                self.count("call of a function");
                let called = self.program.functions.get(*function);
                if called.is_some_and(|called| arguments.len() < called.inputs().count()) {
                    self.count("call of a function that leaves inputs out");
                }
                arguments
                    .iter()
                    .for_each(|argument| self.expression(&argument.value));
            }
            ExpressionKind::Standard(function, arguments) => {
                self.count(format!("standard {}", crate::writer::function_name(*function)));
                arguments.iter().for_each(|argument| self.expression(argument));
            }
            ExpressionKind::Raw(_) => self.count("expression that breaks a rule"),
        }
    }

    fn type_name(&self, ty: &Type) -> &'static str {
        match self.program.unaliased(ty) {
            Type::Elementary(ty) => ty.name(),
            Type::Array(_) => "an array",
            Type::Declared(_) if self.program.fields(ty).is_some() => "a structure",
            Type::Declared(_) => "an enumeration",
            Type::Block(_) => "a function block",
        }
    }
}
