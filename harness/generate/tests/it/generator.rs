//! Tests of the promises of the generator: its programs are accepted, terminate, and are settled by documents, whatever the
//! bytes; and many programs contain every construct.
use std::collections::{BTreeMap, BTreeSet};
use stickler_exact::{ImplicitResult, expected, functions, implicit, implicit_result, signatures};
use stickler_generate::evaluate::evaluate;
use stickler_generate::features::features;
use stickler_generate::generator::{GeneratorSettings, program};
use stickler_generate::model::visit::{
    Visitor, walk_declaration, walk_expression, walk_program, walk_statement, walk_type, walk_variable,
};
use stickler_generate::model::{
    AssignmentTarget, DeclaredKind, Expression, ExpressionKind, LiteralForm, Program, Statement, Type,
    TypeDeclaration, UnaryOperator, Variable,
};
use stickler_generate::writer::{Style, write};
use stickler_types::{DialectName, ElementaryType, MatrixWord, MomentUnits, Value, join};

/// Returns the bytes of a seed, for programs of every size.
fn bytes(seed: u64) -> Vec<u8> {
    stickler_generate::random::bytes(seed, (seed * 7 % 3000) as usize)
}

fn made(dialect: DialectName, seed: u64) -> Program {
    program(&bytes(seed), &GeneratorSettings::of(dialect))
}

/// Returns the number of programs of a dialect to generate.
fn seeds() -> u64 {
    crate::seeds(600)
}

#[test]
fn the_reference_accepts_every_program() {
    let mut rejected = BTreeMap::new();
    for &dialect in DialectName::ALL.iter() {
        for seed in 0..seeds() {
            let text = write(&made(dialect, seed), &Style::default()).text;
            if let Some(first) = stickler_reference::errors(&text, dialect).first() {
                let (count, shown): &mut (usize, String) = rejected.entry(first.code.clone()).or_default();
                *count += 1;
                let line = first.line.and_then(|line| text.lines().nth(line as usize - 1));
                if *count <= 3 {
                    *shown += &format!("{dialect}, seed {seed}: {}: {line:?}\n", first.message);
                }
            }
        }
    }
    let shown = rejected
        .iter()
        .map(|(code, (count, shown))| format!("{code:?}, {count} times: {shown}"));
    let shown = join(shown, "\n");
    assert!(shown.is_empty(), "{shown}");
}

#[test]
fn programs_end_and_hardly_any_meets_what_documents_leave_open() {
    for &dialect in DialectName::ALL.iter() {
        let mut opened = Vec::new();
        for seed in 0..seeds() {
            match evaluate(&made(dialect, seed), 1) {
                Ok(evaluation) => {
                    opened.extend(evaluation.opened.first().map(|first| format!("{seed}: {first}")))
                }
                Err(refusal) => panic!("{dialect}, seed {seed}: {refusal:?}"),
            }
        }
        // Where numbers convert implicitly to narrower types, no document states what arrives of one that does not fit; the fewer types there are, the
        // more of the pairs narrow.
        let narrows = implicit(ElementaryType::Dint, ElementaryType::Int, dialect) == MatrixWord::Yes;
        // Where durations have no sign, the difference of two has no value as often as not.
        let unsigned = dialect.rules().conversions.moment_units == MomentUnits::Counts;
        let percent = match (narrows, unsigned) {
            (true, _) if dialect.rules().lacks("lint") => 22,
            (true, _) => 15,
            (false, true) => 4,
            (false, false) => 2,
        };
        let few = seeds() as usize * percent / 100;
        assert!(
            opened.len() <= few,
            "{dialect}: {} of {}: {opened:#?}",
            opened.len(),
            seeds()
        );
    }
}

#[test]
fn the_same_bytes_make_the_same_program() {
    for seed in 0..50 {
        let bytes = bytes(seed);
        let make = || program(&bytes, &GeneratorSettings::default());
        assert_eq!(make(), make(), "seed {seed}");
    }
}

#[test]
fn no_bytes_make_a_small_program() {
    for &dialect in DialectName::ALL.iter() {
        let program = program(&[], &GeneratorSettings::of(dialect));
        let text = write(&program, &Style::default()).text;
        assert!(text.lines().count() <= 20, "{text}");
        assert!(stickler_reference::errors(&text, dialect).is_empty(), "{text}");
    }
}

#[test]
fn the_input_chooses_the_dialect_where_the_caller_does_not() {
    let chosen: BTreeSet<DialectName> = (0..100)
        .map(|seed| program(&bytes(seed), &GeneratorSettings::default()).dialect)
        .collect();
    assert_eq!(chosen.len(), DialectName::ALL.len());
}

#[test]
fn what_is_open_is_used_only_when_asked_for() {
    let open = |seed| {
        let settings = GeneratorSettings {
            open: true,
            ..GeneratorSettings::of(DialectName::PLCNEXT)
        };
        program(&bytes(seed), &settings)
    };
    let has_bits = |program: &Program| measured(program).contains("bit read");
    assert!((0..200).any(|seed| has_bits(&open(seed))));
    assert!(!(0..200).any(|seed| has_bits(&made(DialectName::PLCNEXT, seed))));
}

/// Returns the constructs of a program with their types: `variable INT`, `read INT`, `+ of INT`.
fn measured(program: &Program) -> BTreeSet<String> {
    let mut measured = Measured {
        program,
        found: BTreeSet::new(),
    };
    walk_program(&mut measured, program);
    measured.found
}

struct Measured<'p> {
    program: &'p Program,
    found: BTreeSet<String>,
}

impl Measured<'_> {
    /// Notes a construct with a type: an elementary one by its name, others by their form.
    fn note(&mut self, construct: &str, ty: &Type) {
        let shape = match ty {
            Type::Elementary(elementary) => elementary.name().to_owned(),
            Type::Array(array) => format!("ARRAY of {} dimensions", array.dimensions.len()),
            Type::Declared(_) if self.program.fields(ty).is_some() => "structure".to_owned(),
            Type::Declared(_) if self.program.enumerated_values(ty).is_some() => "enumeration".to_owned(),
            Type::Declared(_) => "alias".to_owned(),
            Type::Block(_) => "instance".to_owned(),
            Type::Reference(_) => "reference".to_owned(),
        };
        self.found.insert(format!("{construct} {shape}"));
    }
}

impl Visitor for Measured<'_> {
    fn declaration(&mut self, declaration: &TypeDeclaration) {
        if let DeclaredKind::Structure(fields) = &declaration.kind {
            fields.iter().for_each(|(_, ty, _)| self.note("field", ty));
        }
        walk_declaration(self, declaration);
    }

    fn variable(&mut self, variable: &Variable) {
        self.note("variable", &variable.ty);
        walk_variable(self, variable);
    }

    fn ty(&mut self, ty: &Type) {
        if let Type::Array(array) = ty {
            self.note("element", &array.element);
        }
        walk_type(self, ty);
    }

    fn statement(&mut self, statement: &Statement) {
        let written = match statement {
            Statement::Assign(AssignmentTarget::Bit(..), _) => Some("bit written"),
            Statement::Assign(AssignmentTarget::Result, _) => Some("result"),
            _ => None,
        };
        self.found.extend(written.map(str::to_owned));
        walk_statement(self, statement);
    }

    fn expression(&mut self, expression: &Expression) {
        match &expression.kind {
            ExpressionKind::Literal(_, LiteralForm::Untyped) => self.note("untyped", &expression.ty),
            ExpressionKind::Read(_) => self.note("read", &expression.ty),
            ExpressionKind::Bit(..) => _ = self.found.insert("bit read".to_owned()),
            ExpressionKind::Unary(UnaryOperator::Negate, _) => self.note("negation of", &expression.ty),
            ExpressionKind::Unary(UnaryOperator::Not, _) => self.note("NOT of", &expression.ty),
            ExpressionKind::Binary(operator, left, _) => {
                self.note(&format!("{} of", operator.as_str()), &left.ty)
            }
            _ => {}
        }
        walk_expression(self, expression);
    }

    fn literal(&mut self, expression: &Expression) {
        self.expression(expression);
    }
}

/// Returns every feature that programs of a dialect must have.
fn demanded(dialect: DialectName) -> Vec<String> {
    let has = |ty: &ElementaryType| !dialect.rules().lacks(&ty.name().to_ascii_lowercase());
    let types: Vec<ElementaryType> = ElementaryType::ALL.into_iter().filter(has).collect();
    let there = |construct: &&str| !construct.split(' ').any(|word| dialect.rules().lacks(word));
    let mut demanded: Vec<String> = ALWAYS.lines().filter(there).map(str::to_owned).collect();
    for &ty in &types {
        demanded.push(format!("variable {ty}"));
        demanded.push(format!("read {ty}"));
        demanded.push(format!("{ty}#"));
        demanded.push(format!("= of {ty}"));
        let arithmetic: &[&str] = match ty {
            _ if ty.is_integer() => &["+", "-", "*", "/", "MOD", "<", "<>"],
            _ if ty.is_real() => &["+", "-", "*", "/", "<", "<>"],
            _ if ty.is_bit_string() => &["AND", "OR", "XOR", "<"],
            _ => &[],
        };
        demanded.extend(arithmetic.iter().map(|operator| format!("{operator} of {ty}")));
        for &from in &types {
            let arrives = || implicit_result(&one(from), ty);
            if from != ty
                && implicit(from, ty, dialect) == MatrixWord::Yes
                && matches!(arrives(), Some(ImplicitResult::Exactly(_)))
            {
                demanded.push(format!("{from} to {ty}"));
            }
        }
    }
    if dialect.rules().documents.bits {
        demanded.extend(["bit read", "bit written"].map(str::to_owned));
    }
    demanded.extend(settled_functions(dialect));
    demanded
}

fn one(ty: ElementaryType) -> Value {
    match ty.is_text() {
        true => Value::text(ty, vec![u16::from(b'1')]),
        false => Value::plain(ty, ty.wrap(1)),
    }
}

/// Returns the conversion functions between numbers for which documents state the result of 1, without the overloaded `TO_…`,
/// which programs of the generator do not call.
fn settled_functions(dialect: DialectName) -> Vec<String> {
    let mut settled = Vec::new();
    for function in functions(dialect)
        .into_iter()
        .filter(|name| !name.starts_with("TO_"))
    {
        let says = |signature: &stickler_exact::Signature| {
            let &[from] = &signature.operands[..] else {
                return false;
            };
            let literal = if from.is_real() { "1.0" } else { "1" };
            let one = Value::parse(&format!("{from}#{literal}"));
            one.is_ok_and(|one| expected(signature, &[one], dialect).basis.is_some())
        };
        if signatures(&function, dialect).iter().any(says) {
            settled.push(function);
        }
    }
    settled
}

/// The features that programs of every dialect must have, one a line.
const ALWAYS: &str = include_str!("always.txt");

#[test]
fn every_construct_occurs_in_some_of_the_programs() {
    // So many that the rarest function is missing once in many thousand changes of the generator.
    const PROGRAMS: u64 = 4000;
    for &dialect in DialectName::ALL.iter() {
        let mut missing: BTreeSet<String> = demanded(dialect).into_iter().collect();
        for seed in 0..PROGRAMS {
            let program = made(dialect, seed);
            for construct in measured(&program)
                .into_iter()
                .chain(features(&program).into_keys())
            {
                missing.remove(&construct);
            }
            if missing.is_empty() {
                break;
            }
        }
        assert!(missing.is_empty(), "{dialect}: {missing:?}");
    }
}
