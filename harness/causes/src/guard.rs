//! Constructs that a reduction must keep: a smaller program shows the same defect only where the construct
//! at fault is still there, and nothing came in that the whole program does not have.

use crate::malformed::has_misplaced_underscore;
use crate::program::{Part, Program, ReadProgram};
use crate::question::Takes;
use crate::shape::is_name;
use crate::words::{ANY, elementary, has_word, tokens, words};
use std::collections::{BTreeMap, BTreeSet};
use stickler_syntax::features::features;
use stickler_syntax::names::{DeclaredKind, DeclaredName};
use stickler_syntax::token::{Token, TokenKind};
use stickler_syntax::tree::{
    Configuration, Declaration, ExpressionId, ExpressionKind, LiteralKind, VariableKind,
};
use stickler_syntax::visitor::Place;
use stickler_types::{DialectName, ElementaryType};

/// The constructs of a program.
#[derive(Debug)]
pub(crate) struct Constructs {
    /// The constructs that a smaller program may have only where the whole one has them.
    limited: BTreeSet<String>,
    /// The ways in which its statements use each name, in capitals: by itself, an element, a bit, a field.
    uses: BTreeMap<String, BTreeSet<String>>,
    /// The elementary types that names are declared with, in capitals.
    elementary: BTreeMap<String, ElementaryType>,
    /// Whether there is a section of variables, which some compilers demand.
    has_variables: bool,
    /// Whether there is a PROGRAM, without which some compilers take no text.
    has_program: bool,
    /// Whether a section of variables is empty, which some compilers reject.
    has_empty_section: bool,
    /// Whether a body has no statement, which some compilers reject.
    has_empty_body: bool,
    /// Whether a semicolon alone is a statement, which some compilers reject.
    has_empty_statement: bool,
}

impl Constructs {
    /// Returns the constructs of a program.
    pub(crate) fn of(text: &str) -> Constructs {
        let program = Program::new(text);
        let program = program.read();
        let all = tokens(text);
        let uses = uses(&program);
        let mut limited = literals(text, &all);
        let features: Vec<String> = features(text, &ANY).into_iter().map(String::from).collect();
        let has_empty_statement = features.iter().any(|key| key == "empty-statement");
        // An operator between two operands does not become one before an operand.
        limited.extend(
            features
                .into_iter()
                .filter(|key| ["negation", "unary-plus"].contains(&&**key)),
        );
        limited.extend(unpromised(&program, &all).into_iter().map(str::to_owned));
        limited.extend(words_alone(text, &all));
        // Of a text that cannot be read nobody reports a name that is not declared. A function may be one of the library.
        let is_value = |ways: &BTreeSet<String>| ways.iter().any(|way| way != "()");
        let undeclared = uses
            .iter()
            .filter(|(name, ways)| !program.declares(name) && is_value(ways));
        limited.extend(undeclared.map(|(name, _)| format!("undeclared {name}")));
        Constructs {
            limited,
            elementary: elementary_types(&program),
            has_variables: all.iter().any(|token| token.kind == TokenKind::EndVar),
            has_program: all.iter().any(|token| token.kind == TokenKind::Program),
            has_empty_section: has_pair(&all, |one, next| one.opens_section() && next == TokenKind::EndVar),
            has_empty_body: has_pair(&all, |one, next| one == TokenKind::EndVar && next.closes_pou()),
            has_empty_statement,
            uses,
        }
    }

    /// Returns whether a program with these constructs may become one with the constructs `smaller`, for an engine that takes this as the least.
    pub(crate) fn may_become(&self, smaller: &Constructs, takes: Takes) -> bool {
        (takes.no_variables || smaller.has_variables)
            && (takes.no_program || !self.has_program || smaller.has_program)
            && !smaller.has_empty_section
            && (takes.empty_bodies || !smaller.has_empty_body)
            && (takes.empty_statements || self.has_empty_statement || !smaller.has_empty_statement)
            && smaller.limited.is_subset(&self.limited)
            && smaller.uses.keys().all(|name| self.keeps_uses(name, smaller))
    }

    /// Returns whether no use of a name lost a subscript, a bit or a field, as `a[1]` would become `a`. A variable that has an
    /// elementary type now has lost those of its former type, and a BOOL the bits.
    fn keeps_uses(&self, name: &str, smaller: &Constructs) -> bool {
        let (Some(before), Some(now)) = (self.uses.get(name), smaller.uses.get(name)) else {
            return true;
        };
        let (former, ty) = (self.elementary.get(name), smaller.elementary.get(name));
        let is_unwrapped =
            ty.is_some() && (former.is_none() || ty != former && ty == Some(&ElementaryType::Bool));
        let is_cut = |way: &String| {
            !before.contains(way) && before.iter().any(|longer| longer.starts_with(way.as_str()))
        };
        is_unwrapped || !now.iter().any(is_cut)
    }
}

/// Returns the forms of the literals; bounds, subscripts, bits and numbers of repetitions are none. They are told by their tokens, since
/// the program may be one that cannot be read.
fn literals(text: &str, tokens: &[Token]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    // For each open bracket, whether it holds values.
    let mut lists = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        let before = at.checked_sub(1).map(|before| tokens[before].kind);
        let next = tokens.get(at + 1).map(|next| next.kind);
        match token.kind {
            TokenKind::LeftBracket => lists.push(matches!(
                before,
                Some(TokenKind::Assign | TokenKind::Comma | TokenKind::LeftParen | TokenKind::LeftBracket)
            )),
            TokenKind::RightBracket => {
                lists.pop();
            }
            _ => {}
        }
        let is_value = lists.last() != Some(&false)
            && before != Some(TokenKind::Dot)
            && next != Some(TokenKind::LeftParen);
        found.extend(literal(token.span.text(text)).filter(|_| is_value));
        let is_truth_value = matches!(token.kind, TokenKind::True | TokenKind::False);
        if is_truth_value && [before, next].into_iter().flatten().any(takes_numbers) {
            found.insert("truth value as an operand".to_owned());
        }
    }
    found
}

/// Returns whether a token is an operator whose operands are numbers, or that compares.
const fn takes_numbers(kind: TokenKind) -> bool {
    use TokenKind::*;
    matches!(
        kind,
        Mod | Plus
            | Minus
            | Star
            | Slash
            | Power
            | Equal
            | NotEqual
            | Less
            | LessOrEqual
            | Greater
            | GreaterOrEqual
    )
}

/// Returns the form of a literal.
fn literal(written: &str) -> Option<String> {
    // A truth value may stand for what has the type BOOL, or must have it.
    let of_truth = ["TRUE", "FALSE", "BOOL", "IF", "ELSIF", "WHILE", "UNTIL"];
    if of_truth.iter().any(|word| written.eq_ignore_ascii_case(word)) {
        return Some("truth value".to_owned());
    }
    if written.starts_with(['\'', '"']) {
        return written.get(..1).map(str::to_owned);
    }
    // An underscore that separates no digits is read by mistake in one way, in an integer and in a real number.
    let is_number = written.starts_with(|first: char| first.is_ascii_digit());
    if is_number && has_misplaced_underscore(&written.to_ascii_uppercase()) {
        return Some("misplaced underscore".to_owned());
    }
    if let Some((prefix, _)) = written.split_once('#') {
        return Some(format!("{}#", prefix.to_ascii_uppercase()));
    }
    let plain = if written.contains('.') { "real" } else { "integer" };
    is_number.then(|| plain.to_owned())
}

/// Returns the ways in which the statements use each name, such as `[].` for a bit of an element.
fn uses(program: &ReadProgram<'_, '_>) -> BTreeMap<String, BTreeSet<String>> {
    let mut found: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for part in program.parts.iter().filter(|part| part.statement.is_some()) {
        let Some(name) = part.name() else { continue };
        let whole = program.text(program.outermost(part).id);
        let mut depth = 0_usize;
        let behind = whole.chars().skip(name.len()).filter(|sign| {
            depth = depth + usize::from(*sign == '[') - usize::from(*sign == ']');
            (depth == 0 || *sign == '[') && !sign.is_ascii_digit()
        });
        let way = match part.place {
            Place::Callee => "()".to_owned(),
            _ => behind.collect::<String>().to_ascii_uppercase(),
        };
        found.entry(name.to_ascii_uppercase()).or_default().insert(way);
    }
    found
}

/// Returns the elementary types that names are declared with.
fn elementary_types(program: &ReadProgram<'_, '_>) -> BTreeMap<String, ElementaryType> {
    let typed = |one: &DeclaredName<'_, '_>| {
        let written = one.group?.specification.span.text(program.text);
        Some((one.name.text.to_ascii_uppercase(), elementary(written)?))
    };
    program.names.iter().filter_map(typed).collect()
}

/// Returns the words that begin something whose end is not there, as where `END_PROGRAM` became `ENDPROGRAM`, and the locations of
/// variables.
fn words_alone(text: &str, tokens: &[Token]) -> BTreeSet<String> {
    let number = |word: &str| tokens.iter().filter(|token| token.is(word, text)).count();
    let is_alone = |token: &&Token| {
        let word = token.span.text(text);
        let end = format!("END_{}", word.to_ascii_uppercase());
        token.kind == TokenKind::Direct || TokenKind::of_word(&end).closes() && number(word) > number(&end)
    };
    let alone = tokens.iter().filter(is_alone);
    alone
        .map(|token| token.span.text(text).to_ascii_uppercase())
        .collect()
}

/// Returns the names of the constructs of a program that no document promises, or not every one: where the whole program does
/// without one, a smaller program with it shows another mistake than the one under test.
fn unpromised(program: &ReadProgram<'_, '_>, tokens: &[Token]) -> BTreeSet<&'static str> {
    let mut found = BTreeSet::new();
    let adjacent = |one, other| {
        let mut pairs = tokens.windows(2);
        pairs.any(|pair| (pair[0].kind, pair[1].kind) == (one, other))
    };
    let words = words(program.text);
    let number = |word: &str| words.iter().filter(|one| one.eq_ignore_ascii_case(word)).count();
    let of_statement = has_expression_as_statement(program.text, tokens);
    found.extend(repeats_nothing(program, tokens).then_some("repetition of nothing"));
    found.extend(of_statement.then_some("expression as a statement"));
    let is_positional = |part: &&Part<'_, '_>| {
        let callee = part.around.and_then(|around| program.call(around));
        callee.is_some_and(|(name, _)| program.is_instance(name))
    };
    let positional = program.at(Place::Argument).find(is_positional);
    found.extend(positional.map(|_| "argument of a block by its position"));
    found.extend(has_no_result(program).then_some("function without a result"));
    let has_unit = program.unit.pous().next().is_some();
    found.extend((!has_unit).then_some("no program organization unit"));
    // The standard leaves out what finds no element (6.4.4.5.2), which is a mistake in CODESYS.
    let has_list = program.text.contains('[');
    let errors = has_list.then(|| stickler_reference::errors(program.text, DialectName::CODESYS));
    let mut errors = errors.iter().flatten();
    let has_more_values = errors.any(|error| error.message.contains(" initial values for "));
    found.extend(has_more_values.then_some("more values than elements"));
    // Basis of these: iec-61131-3: Annex A (`Case_Stmt`, `Struct_Decl`, `Config_Decl`, `Single_Resource_Decl`, `Task_Init`).
    let has_no_branch = [TokenKind::EndCase, TokenKind::Else].map(|end| adjacent(TokenKind::Of, end));
    found.extend(has_no_branch.contains(&true).then_some("CASE without a branch"));
    let is_empty = adjacent(TokenKind::Struct, TokenKind::EndStruct);
    found.extend(is_empty.then_some("empty structure"));
    found.extend(has_empty_resource(program).then_some("resource without a program"));
    found.extend((number("TASK") > number("PRIORITY")).then_some("task without a priority"));
    for part in &program.parts {
        found.extend(of_value(program, part));
    }
    found
}

/// Returns what is odd about a value where it is given, or about a variable where it is used.
fn of_value(program: &ReadProgram<'_, '_>, part: &Part<'_, '_>) -> Option<&'static str> {
    let target = program.target(part);
    let literal = match &part.expression.kind {
        ExpressionKind::Literal(literal) if literal.prefix().is_none() => Some(literal.kind),
        _ => None,
    };
    let is_in_out = |input: &DeclaredName<'_, '_>| input.kind == DeclaredKind::Variable(VariableKind::InOut);
    if literal.is_some() && program.input(part).is_some_and(is_in_out) {
        return Some("literal for a VAR_IN_OUT");
    }
    let is_alone = program.specification(part.id).is_some() || literal == Some(LiteralKind::Boolean);
    let source = match literal {
        Some(LiteralKind::Boolean) => Some(ElementaryType::Bool),
        _ => program.type_of(part.id),
    };
    let is_truth_value = |ty: ElementaryType| ty == ElementaryType::Bool;
    let is_integer = |ty: ElementaryType| ty.is_integer() || ty.is_bit_string();
    if part.statement.is_some()
        && is_alone
        && let (Some(target), Some(source)) = (target, source)
        && is_truth_value(target) != is_truth_value(source)
    {
        return Some("truth value for another type");
    }
    let value = match part.expression.kind {
        ExpressionKind::Unary { operand, .. } => program.text(operand),
        _ => program.text(part.id),
    };
    // Whether an integer literal is a bit string is another question.
    let is_bit_string = |ty: ElementaryType| ty.is_bit_string() && ty != ElementaryType::Bool;
    let is_beside_bits = || {
        let beside = program
            .parts
            .iter()
            .filter(|other| other.around == part.around && other.id != part.id);
        beside
            .filter_map(|other| program.type_of(other.id))
            .any(is_bit_string)
    };
    if literal == Some(LiteralKind::Integer) && part.place == Place::Argument && is_beside_bits() {
        return Some("integer beside a bit string");
    }
    let is_real = value.starts_with(|first: char| first.is_ascii_digit()) && value.contains('.');
    if is_real && target.is_some_and(is_integer) {
        return Some("real number for an integer");
    }
    let name = part.name()?;
    let section = program.section(name, part.pou);
    // Basis of both: iec-61131-3: 6.5.2.2 (VAR_EXTERNAL; VAR_INPUT: not modifiable within the unit).
    match part.place {
        Place::InitialValue if begins_with_variable(program, name) => Some("initial value of a variable"),
        _ if section == Some(VariableKind::Global)
            && part.pou.is_some()
            && !has_word(program.text, "VAR_EXTERNAL") =>
        {
            Some("global variable that is not external")
        }
        _ if section == Some(VariableKind::Input) && is_assigned(program, part) => {
            Some("input that is assigned")
        }
        _ => None,
    }
}

/// Returns whether a unit assigns the variable of its own that a name is, or an element, a field or a bit of it.
fn is_assigned(program: &ReadProgram<'_, '_>, name: &Part<'_, '_>) -> bool {
    let own = program
        .named(program.text(name.id), name.pou)
        .and_then(|one| one.inside);
    let is_own = own.map(|pou| pou.span) == name.pou.map(|pou| pou.span);
    is_own && program.outermost(name).place == Place::Target
}

/// Returns whether a name is that of a variable of a section that is not `CONSTANT`.
fn begins_with_variable(program: &ReadProgram<'_, '_>, name: &str) -> bool {
    let sections = program.unit.pous().flat_map(|pou| &pou.blocks);
    let mut variables = sections
        .filter(|section| !section.constant)
        .flat_map(|section| &section.groups);
    variables.any(|group| group.names.iter().any(|one| one.is(name)))
}

/// Returns whether something is repeated zero times, as in `[0(5)]`, or counted by zero, or nothing is repeated, as in `[5()]`.
fn repeats_nothing(program: &ReadProgram<'_, '_>, tokens: &[Token]) -> bool {
    let is_zero = |id: ExpressionId| program.text(id).bytes().all(|digit| matches!(digit, b'0' | b'_'));
    let mut counts = program
        .parts
        .iter()
        .filter(|part| matches!(part.place, Place::Repetition | Place::By));
    let is_number = |token: &Token| token.kind == TokenKind::Integer;
    let mut triples = tokens.windows(3);
    counts.any(|part| is_zero(part.id))
        || triples.any(|triple| {
            is_number(&triple[0])
                && (triple[1].kind, triple[2].kind) == (TokenKind::LeftParen, TokenKind::RightParen)
        })
}

/// Returns whether a literal, a comparison or a name stands where a statement must, as where `d := D#2024-01-1.5;` becomes
/// `D#2024-01-1;`, `d = D#2024-01-1;` or `d`.
fn has_expression_as_statement(text: &str, tokens: &[Token]) -> bool {
    use TokenKind::*;
    (1..tokens.len()).any(|at| {
        let begins = matches!(
            tokens[at - 1].kind,
            Semicolon | EndVar | Do | Then | Else | Repeat
        );
        let is_literal =
            tokens[at].kind.is_literal() && tokens.get(at + 1).is_some_and(|next| next.kind == Semicolon);
        let mut behind = tokens[at..].iter().map(|token| token.kind);
        let sign = behind
            .find(|kind| matches!(kind, Assign | Equal | LeftParen | Semicolon | Colon) || kind.is_keyword());
        let is_value = sign.is_some_and(|sign| matches!(sign, Equal | Semicolon) || sign.closes());
        begins && (is_literal || is_name(&tokens[at], text) && is_value)
    })
}

/// Returns whether a function that has a result gives it no value.
fn has_no_result(program: &ReadProgram<'_, '_>) -> bool {
    let mut functions = program.unit.pous().filter(|pou| pou.result.is_some());
    functions.any(|pou| {
        let is_own = |part: &Part<'_, '_>| part.pou.is_some_and(|one| one.span == pou.span);
        let gives = |part: &Part<'_, '_>| {
            program.outermost(part).place == Place::Target
                && part.name().is_some_and(|name| pou.name.is(name))
        };
        !program.parts.iter().any(|part| is_own(part) && gives(part))
    })
}

/// Returns whether a configuration has no resource, or a resource no program.
fn has_empty_resource(program: &ReadProgram<'_, '_>) -> bool {
    let mut declarations = program.unit.declarations.iter();
    declarations.any(|declaration| match declaration {
        Declaration::Configuration(Configuration { resources, .. }) => {
            resources.is_empty() || resources.iter().any(|resource| resource.programs.is_empty())
        }
        _ => false,
    })
}

fn has_pair(tokens: &[Token], is_one: impl Fn(TokenKind, TokenKind) -> bool) -> bool {
    tokens.windows(2).any(|pair| is_one(pair[0].kind, pair[1].kind))
}
