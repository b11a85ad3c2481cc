//! What is left of the language in a program: its functions, operators, kinds of statements, and less common types.
//!
//! Two findings with the same symptom are the same if they need the same of the language. What most programs have is left
//! out: assignments, reads, literals, and variables of numbers, bit strings and truth values.

use std::collections::BTreeSet;
use stickler_generate::model::walk::{
    Unit, Visitor, walk_expression, walk_place, walk_program, walk_statement, walk_type, walk_variable,
};
use stickler_generate::model::{
    BinaryOperator, CaseLabel, Declared, Expression, ExpressionKind, Initial, LiteralForm, Place, Program,
    Section, Selector, StandardFunction, Statement, StatementKind, Target, Type, UnaryOperator, Variable,
    VariableId,
};
use stickler_types::{ElementaryType, Family};

/// The words that stand for one thing each; besides them there are types, conversion functions and implicit conversions.
pub(crate) const WORDS: &[&str] = &[
    "#-",
    "$",
    "ABS",
    "alias",
    "AND",
    "ARRAY",
    "ARRAY[n..n]",
    "bit read",
    "bit written",
    "call",
    "CASE",
    "CASE ..",
    "CONCAT",
    "CONSTANT",
    "enumerated value",
    "enumeration",
    "EXIT",
    ".field",
    "FOR",
    "FUNCTION",
    "FUNCTION_BLOCK",
    "IF",
    "initial array",
    "initial structure",
    "input left out",
    "invocation",
    "LEN",
    "LIMIT",
    "MAX",
    "MIN",
    "MOD",
    "MUX",
    "negation",
    "NOT",
    "OR",
    ".output",
    "REPEAT",
    "result",
    "RETURN",
    "ROL",
    "ROR",
    "SEL",
    "SHL",
    "SHR",
    "STRUCT",
    "VAR_IN_OUT",
    "VAR_OUTPUT",
    "WHILE",
    "XOR",
    "[]",
    "+",
    "-",
    "*",
    "/",
    "=",
    "<>",
    "<",
    "<=",
    ">",
    ">=",
    "=>",
];

/// The words for what the program uses, sorted, each once.
#[must_use]
pub fn rule(program: &Program) -> Vec<String> {
    gathered(program, false)
}

/// The words of [`rule`], all elementary types, and the types before literals: `INT#`, and `#-` where a minus follows.
pub(crate) fn words(program: &Program) -> Vec<String> {
    gathered(program, true)
}

fn gathered(program: &Program, is_whole: bool) -> Vec<String> {
    let mut gathering = Gathering {
        program,
        unit: Unit::Main,
        words: BTreeSet::new(),
        is_whole,
    };
    // The walker may change what it walks over, so it gets a copy.
    walk_program(&mut gathering, &mut program.clone());
    for declaration in &program.types {
        gathering.word(match declaration.kind {
            Declared::Structure(_) => "STRUCT",
            Declared::Enumeration(_) => "enumeration",
            Declared::Alias(_) => "alias",
        });
    }
    gathering.words.into_iter().collect()
}

struct Gathering<'p> {
    program: &'p Program,
    /// Where the walker is.
    unit: Unit,
    words: BTreeSet<String>,
    /// Whether what nearly every program has is told too: numbers, bit strings, literals with a type.
    is_whole: bool,
}

impl Gathering<'_> {
    fn word(&mut self, word: impl Into<String>) {
        self.words.insert(word.into());
    }

    /// How many inputs the function block of an instance has, those of VAR_IN_OUT among them.
    fn inputs_of(&self, instance: VariableId) -> usize {
        let declared = self.unit.variables(self.program).get(instance.0);
        let Some(Type::Block(block)) = declared.map(|variable| &variable.ty) else {
            return 0;
        };
        let variables = Unit::Block(*block).variables(self.program).iter();
        let inputs = variables.filter(|variable| matches!(variable.section, Section::Input | Section::InOut));
        inputs.count()
    }
}

impl Visitor for Gathering<'_> {
    fn enter(&mut self, unit: Unit) {
        self.unit = unit;
        match unit {
            Unit::Function(_) => self.word("FUNCTION"),
            Unit::Block(_) => self.word("FUNCTION_BLOCK"),
            Unit::Main | Unit::Types => {}
        }
    }

    fn variable(&mut self, variable: &mut Variable) {
        match variable.section {
            Section::Constant => self.word("CONSTANT"),
            Section::InOut => self.word("VAR_IN_OUT"),
            Section::Output => self.word("VAR_OUTPUT"),
            Section::Local | Section::Input => {}
        }
        match variable.initial {
            Some(Initial::Array(_)) => self.word("initial array"),
            Some(Initial::Structure(_)) => self.word("initial structure"),
            Some(Initial::Expression(_)) | None => {}
        }
        walk_variable(self, variable);
    }

    fn ty(&mut self, ty: &mut Type) {
        match ty {
            Type::Array(array) => {
                self.word("ARRAY");
                if array.dimensions.iter().any(|(low, high)| low == high) {
                    self.word("ARRAY[n..n]");
                }
            }
            Type::Elementary(elementary) if self.is_whole || is_less_common(*elementary) => {
                self.word(elementary.name())
            }
            Type::Elementary(_) | Type::Declared(_) | Type::Block(_) => {}
        }
        walk_type(self, ty);
    }

    fn statement(&mut self, statement: &mut Statement) {
        match &statement.kind {
            StatementKind::Assign(Target::Place(_), _) => {}
            StatementKind::Assign(Target::Bit(..), _) => self.word("bit written"),
            StatementKind::Assign(Target::Result, _) => self.word("result"),
            StatementKind::If(..) => self.word("IF"),
            StatementKind::Case(_, branches, _) => {
                self.word("CASE");
                let mut labels = branches.iter().flat_map(|branch| &branch.labels);
                if labels.any(|label| matches!(label, CaseLabel::Range(..))) {
                    self.word("CASE ..");
                }
            }
            StatementKind::For { .. } => self.word("FOR"),
            StatementKind::While(..) => self.word("WHILE"),
            StatementKind::Repeat(..) => self.word("REPEAT"),
            StatementKind::Invoke {
                instance,
                inputs,
                outputs,
            } => {
                self.word("invocation");
                if inputs.len() < self.inputs_of(*instance) {
                    self.word("input left out");
                }
                if !outputs.is_empty() {
                    self.word("=>");
                }
            }
            StatementKind::Exit => self.word("EXIT"),
            StatementKind::Return => self.word("RETURN"),
            StatementKind::Raw(_) => self.word("text"),
        }
        walk_statement(self, statement);
    }

    fn place(&mut self, place: &mut Place) {
        for selector in &place.path {
            self.word(match selector {
                Selector::Index(_) => "[]",
                Selector::Field(_) => ".field",
                Selector::Output(_) => ".output",
            });
        }
        walk_place(self, place);
    }

    fn expression(&mut self, expression: &mut Expression) {
        match &expression.kind {
            // Of all literals only those of texts and characters have an escape.
            ExpressionKind::Literal(value, _) if value.to_string().contains('$') => self.word("$"),
            ExpressionKind::Literal(value, form) if self.is_whole => {
                let name = value.type_name();
                if *form == LiteralForm::Typed {
                    self.word(format!("{name}#"));
                }
                // A duration has its prefix in either form.
                let is_duration =
                    matches!(expression.ty, Type::Elementary(ty) if ty.family() == Family::Duration);
                let is_prefixed = *form == LiteralForm::Typed || is_duration;
                if is_prefixed && value.to_string().starts_with(&format!("{name}#-")) {
                    self.word("#-");
                }
            }
            ExpressionKind::Literal(..) | ExpressionKind::Read(_) => {}
            ExpressionKind::Enumerated(_) => self.word("enumerated value"),
            ExpressionKind::Bit(..) => self.word("bit read"),
            ExpressionKind::Unary(operator, _) => self.word(unary(*operator)),
            ExpressionKind::Binary(operator, ..) => self.word(binary(*operator)),
            ExpressionKind::Widen(operand) => {
                self.word(format!("{} to {}", name(&operand.ty), name(&expression.ty)));
            }
            ExpressionKind::Convert(signature, _) => self.word(signature.function.clone()),
            ExpressionKind::Call(function, arguments) => {
                self.word("call");
                let called = self.program.functions.get(*function);
                if called.is_some_and(|called| arguments.len() < called.inputs().count()) {
                    self.word("input left out");
                }
            }
            ExpressionKind::Standard(function, _) => self.word(standard(*function)),
            ExpressionKind::Raw(_) => self.word("text"),
        }
        walk_expression(self, expression);
    }

    fn literal(&mut self, expression: &mut Expression) {
        self.expression(expression);
    }
}

/// Whether a compiler may well lack the type.
const fn is_less_common(ty: ElementaryType) -> bool {
    !matches!(
        ty.family(),
        Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString | Family::Real
    )
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inputs::Inputs;
    use crate::without::Without;
    use stickler_types::DialectName;

    #[test]
    fn every_word_of_a_program_can_be_left_out() {
        for place in 0..300 {
            let words = words(&Inputs::new(9).program(place, &DialectName::ALL, true));
            assert_eq!(Without::new(&words).map(|_| ()), Ok(()), "at {place}");
        }
    }

    #[test]
    fn an_input_is_left_out_once_a_call_gives_one_less() {
        const WORD: &str = "input left out";
        let has_word = |program: &Program| rule(program).iter().any(|word| word == WORD);
        let programs = (0..300).map(|place| Inputs::new(9).program(place, &DialectName::ALL, false));
        let (without, with): (Vec<Program>, Vec<Program>) = programs.partition(|program| !has_word(program));
        assert!(!with.is_empty());
        let mut shortened = 0;
        for mut program in without {
            let given = program
                .main
                .body
                .iter_mut()
                .find_map(|statement| match &mut statement.kind {
                    StatementKind::Invoke { inputs, .. } if !inputs.is_empty() => Some(inputs),
                    _ => None,
                });
            if let Some(inputs) = given {
                inputs.pop();
                shortened += 1;
                assert!(has_word(&program));
            }
        }
        assert!(shortened > 10, "{shortened}");
    }
}
