//! What is left of the language in a program: its functions, operators and kinds of statements.
//!
//! Two findings with the same symptom are the same if they need the same of the language. What every program has is left
//! out: assignments, reads, literals, variables of elementary types.

use std::collections::BTreeSet;
use stickler_generate::model::{
    Argument, BinaryOperator, CaseLabel, Declared, Expression, ExpressionKind, Initial, Place, Program,
    Section, Selector, StandardFunction, Statement, StatementKind, Target, Type, UnaryOperator, Variable,
};

/// The words for what the program uses, sorted, each once.
#[must_use]
pub fn rule(program: &Program) -> Vec<String> {
    let mut gathering = Gathering::default();
    gathering.program(program);
    gathering.words.into_iter().collect()
}

#[derive(Default)]
struct Gathering {
    words: BTreeSet<String>,
}

impl Gathering {
    fn word(&mut self, word: impl Into<String>) {
        self.words.insert(word.into());
    }

    fn program(&mut self, program: &Program) {
        for declaration in &program.types {
            match &declaration.kind {
                Declared::Structure(fields) => {
                    self.word("STRUCT");
                    for (_, ty, initial) in fields {
                        self.ty(ty);
                        initial.iter().for_each(|initial| self.expression(initial));
                    }
                }
                Declared::Enumeration(_) => self.word("enumeration"),
                Declared::Alias(ty) => {
                    self.word("alias");
                    self.ty(ty);
                }
            }
        }
        for function in &program.functions {
            self.word("FUNCTION");
            self.variables(&function.variables);
            self.statements(&function.body);
        }
        for block in &program.blocks {
            self.word("FUNCTION_BLOCK");
            self.variables(&block.variables);
            self.statements(&block.body);
        }
        self.variables(&program.main.variables);
        self.statements(&program.main.body);
    }

    fn variables(&mut self, variables: &[Variable]) {
        for variable in variables {
            self.ty(&variable.ty);
            match variable.section {
                Section::Constant => self.word("CONSTANT"),
                Section::InOut => self.word("VAR_IN_OUT"),
                Section::Output => self.word("VAR_OUTPUT"),
                Section::Local | Section::Input => {}
            }
            match &variable.initial {
                Some(Initial::Expression(value)) => self.expression(value),
                Some(Initial::Array(values)) => {
                    self.word("initial array");
                    values.iter().for_each(|value| self.expression(value));
                }
                Some(Initial::Structure(fields)) => {
                    self.word("initial structure");
                    fields.iter().for_each(|(_, value)| self.expression(value));
                }
                None => {}
            }
        }
    }

    fn ty(&mut self, ty: &Type) {
        if let Type::Array(array) = ty {
            self.word("ARRAY");
            self.ty(&array.element);
        }
    }

    fn statements(&mut self, statements: &[Statement]) {
        for statement in statements {
            self.statement(&statement.kind);
        }
    }

    fn statement(&mut self, kind: &StatementKind) {
        match kind {
            StatementKind::Assign(target, value) => {
                self.target(target);
                self.expression(value);
            }
            StatementKind::If(branches, other) => {
                self.word("IF");
                for (condition, body) in branches {
                    self.expression(condition);
                    self.statements(body);
                }
                other.iter().for_each(|body| self.statements(body));
            }
            StatementKind::Case(selector, branches, other) => {
                self.word("CASE");
                self.expression(selector);
                for branch in branches {
                    branch.labels.iter().for_each(|label| self.label(label));
                    self.statements(&branch.body);
                }
                other.iter().for_each(|body| self.statements(body));
            }
            StatementKind::For {
                from, to, by, body, ..
            } => {
                self.word("FOR");
                [Some(from), Some(to), by.as_ref()]
                    .into_iter()
                    .flatten()
                    .for_each(|bound| self.expression(bound));
                self.statements(body);
            }
            StatementKind::While(condition, body) => {
                self.word("WHILE");
                self.expression(condition);
                self.statements(body);
            }
            StatementKind::Repeat(body, condition) => {
                self.word("REPEAT");
                self.statements(body);
                self.expression(condition);
            }
            StatementKind::Invoke { inputs, outputs, .. } => {
                self.word("invocation");
                self.arguments(inputs);
                if !outputs.is_empty() {
                    self.word("=>");
                }
                outputs.iter().for_each(|(_, place)| self.place(place));
            }
            StatementKind::Exit => self.word("EXIT"),
            StatementKind::Return => self.word("RETURN"),
            StatementKind::Raw(_) => self.word("text"),
        }
    }

    fn label(&mut self, label: &CaseLabel) {
        match label {
            CaseLabel::One(value) => self.expression(value),
            CaseLabel::Range(low, high) => {
                self.word("CASE ..");
                self.expression(low);
                self.expression(high);
            }
        }
    }

    fn target(&mut self, target: &Target) {
        match target {
            Target::Place(place) => self.place(place),
            Target::Bit(place, _) => {
                self.word("bit written");
                self.place(place);
            }
            Target::Result => self.word("result"),
        }
    }

    fn place(&mut self, place: &Place) {
        for selector in &place.path {
            match selector {
                Selector::Index(subscripts) => {
                    self.word("[]");
                    subscripts.iter().for_each(|subscript| self.expression(subscript));
                }
                Selector::Field(_) => self.word(".field"),
                Selector::Output(_) => self.word(".output"),
            }
        }
    }

    fn arguments(&mut self, arguments: &[Argument]) {
        arguments
            .iter()
            .for_each(|argument| self.expression(&argument.value));
    }

    fn expression(&mut self, expression: &Expression) {
        match &expression.kind {
            ExpressionKind::Literal(..) => {}
            ExpressionKind::Enumerated(_) => self.word("enumerated value"),
            ExpressionKind::Read(place) => self.place(place),
            ExpressionKind::Bit(place, _) => {
                self.word("bit read");
                self.place(place);
            }
            ExpressionKind::Unary(operator, operand) => {
                self.word(unary(*operator));
                self.expression(operand);
            }
            ExpressionKind::Binary(operator, left, right) => {
                self.word(binary(*operator));
                self.expression(left);
                self.expression(right);
            }
            ExpressionKind::Widen(operand) => {
                self.word(format!("{} to {}", name(&operand.ty), name(&expression.ty)));
                self.expression(operand);
            }
            ExpressionKind::Convert(signature, operand) => {
                self.word(signature.function.clone());
                self.expression(operand);
            }
            ExpressionKind::Call(_, arguments) => {
                self.word("call");
                self.arguments(arguments);
            }
            ExpressionKind::Standard(function, operands) => {
                self.word(standard(*function));
                operands.iter().for_each(|operand| self.expression(operand));
            }
            ExpressionKind::Raw(_) => self.word("text"),
        }
    }
}

const fn name(ty: &Type) -> &'static str {
    match ty {
        Type::Elementary(elementary) => elementary.name(),
        Type::Array(_) => "ARRAY",
        Type::Declared(_) => "declared",
        Type::Block(_) => "instance",
    }
}

const fn unary(operator: UnaryOperator) -> &'static str {
    match operator {
        UnaryOperator::Negate => "negation",
        UnaryOperator::Not => "NOT",
    }
}

const fn binary(operator: BinaryOperator) -> &'static str {
    match operator {
        BinaryOperator::Add => "+",
        BinaryOperator::Subtract => "-",
        BinaryOperator::Multiply => "*",
        BinaryOperator::Divide => "/",
        BinaryOperator::Modulo => "MOD",
        BinaryOperator::And => "AND",
        BinaryOperator::Or => "OR",
        BinaryOperator::Xor => "XOR",
        BinaryOperator::Equal => "=",
        BinaryOperator::NotEqual => "<>",
        BinaryOperator::Less => "<",
        BinaryOperator::LessOrEqual => "<=",
        BinaryOperator::Greater => ">",
        BinaryOperator::GreaterOrEqual => ">=",
    }
}

const fn standard(function: StandardFunction) -> &'static str {
    match function {
        StandardFunction::Abs => "ABS",
        StandardFunction::Sel => "SEL",
        StandardFunction::Mux => "MUX",
        StandardFunction::Min => "MIN",
        StandardFunction::Max => "MAX",
        StandardFunction::Limit => "LIMIT",
        StandardFunction::Shl => "SHL",
        StandardFunction::Shr => "SHR",
        StandardFunction::Rol => "ROL",
        StandardFunction::Ror => "ROR",
        StandardFunction::Len => "LEN",
        StandardFunction::Concat => "CONCAT",
    }
}
