//! The constructs of a program that its reduction must not exchange for others: a smaller program shows the same defect only where
//! the construct at fault is still there, and nothing came in that the whole program does not have.

use crate::names::DeclaredNames;
use crate::operations::{calculates, ends_operand, is_comparison};
use crate::shape::{in_declarations, is_fixed, path};
use crate::tokens::{ProgramToken, ProgramTokenKind, tokens};
use std::collections::{BTreeMap, BTreeSet};
use stickler_types::ElementaryType;

/// The constructs of a program.
#[derive(Debug)]
pub(crate) struct Constructs {
    /// The forms of its literals: real numbers, based integers, the prefixes of typed literals, the quotes of texts, truth values.
    literals: BTreeSet<String>,
    /// The ways in which its statements use each name, in capitals: by itself, an element, a bit, a field.
    uses: BTreeMap<String, BTreeSet<String>>,
    /// The names that are declared with an elementary type, in capitals.
    elementary: BTreeSet<String>,
    /// The operators that stand before an operand and behind none.
    unary: BTreeSet<String>,
    /// The names of its constructs that the reference takes and that no document promises, or not every one.
    unpromised: BTreeSet<&'static str>,
    /// Whether every section of variables has one and every body has a statement, which some compilers demand.
    is_whole: bool,
    /// The locations of its directly represented variables.
    locations: BTreeSet<String>,
    /// The words that begin a unit, a section or a statement more often than its end is there.
    unclosed: BTreeSet<&'static str>,
    /// The names that its statements use and nothing declares, in capitals; of a text that cannot be read nobody reports them.
    undeclared: BTreeSet<String>,
}

impl Constructs {
    /// Returns the constructs of a program.
    pub(crate) fn of(program: &str) -> Constructs {
        let tokens = tokens(program);
        Constructs {
            literals: literals(&tokens),
            uses: uses(&tokens),
            elementary: elementary(&tokens),
            unary: unary(&tokens),
            unpromised: unpromised(&tokens),
            is_whole: is_whole(&tokens),
            locations: locations(program),
            unclosed: unclosed(&tokens),
            undeclared: undeclared(&tokens),
        }
    }

    /// Returns whether a program with these constructs may become one with the constructs `smaller`.
    pub(crate) fn may_become(&self, smaller: &Constructs) -> bool {
        smaller.is_whole
            && smaller.unpromised.is_subset(&self.unpromised)
            && smaller.locations.is_subset(&self.locations)
            && smaller.unclosed.is_subset(&self.unclosed)
            && smaller.undeclared.is_subset(&self.undeclared)
            && smaller.literals.is_subset(&self.literals)
            && smaller.unary.is_subset(&self.unary)
            && smaller.uses.keys().all(|name| self.keeps_uses(name, smaller))
    }

    /// Returns whether no use of a name lost a subscript, a bit or a field, as `a[1]` would become `a`. A variable that has an
    /// elementary type now has lost those of its former type.
    fn keeps_uses(&self, name: &str, smaller: &Constructs) -> bool {
        let (Some(before), Some(now)) = (self.uses.get(name), smaller.uses.get(name)) else {
            return true;
        };
        let is_unwrapped = smaller.elementary.contains(name) && !self.elementary.contains(name);
        let is_cut = |way: &String| {
            !before.contains(way) && before.iter().any(|longer| longer.starts_with(way.as_str()))
        };
        is_unwrapped || !now.iter().any(is_cut)
    }
}

/// Returns the forms of the literals; bounds, subscripts, bits and numbers of repetitions are none.
fn literals(tokens: &[ProgramToken<'_>]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    // For each open bracket, whether it holds values.
    let mut lists = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        let before = at.checked_sub(1).and_then(|before| tokens.get(before));
        match token.text {
            "[" => lists.push(before.is_some_and(|before| matches!(before.text, ":=" | "," | "(" | "["))),
            "]" => {
                lists.pop();
            }
            _ => {}
        }
        let is_value = lists.last() != Some(&false)
            && before.is_none_or(|before| before.text != ".")
            && tokens.get(at + 1).is_none_or(|next| next.text != "(");
        if is_value {
            found.extend(literal(token));
        }
        let is_beside_operator = [before, tokens.get(at + 1)]
            .into_iter()
            .flatten()
            .any(takes_numbers);
        if (token.is("TRUE") || token.is("FALSE")) && is_beside_operator {
            found.insert("truth value as an operand".to_owned());
        }
    }
    found
}

/// Returns whether a token is an operator whose operands are numbers, or that compares.
fn takes_numbers(token: &ProgramToken<'_>) -> bool {
    calculates(token) || is_comparison(token.text)
}

/// Returns the form of a literal.
fn literal(token: &ProgramToken<'_>) -> Option<String> {
    let prefix = |text: &str| {
        let (prefix, _) = text.split_once('#')?;
        Some(format!("{}#", prefix.to_ascii_uppercase()))
    };
    match token.kind {
        ProgramTokenKind::Number => {
            let plain = if token.text.contains('.') {
                "real"
            } else {
                "integer"
            };
            Some(prefix(token.text).unwrap_or_else(|| plain.to_owned()))
        }
        ProgramTokenKind::Typed => prefix(token.text),
        ProgramTokenKind::Text => token.text.get(..1).map(str::to_owned),
        // A truth value may stand for what has the type BOOL, or must have it.
        ProgramTokenKind::Word => ["TRUE", "FALSE", "BOOL", "IF", "ELSIF", "WHILE", "UNTIL"]
            .iter()
            .any(|word| token.is(word))
            .then(|| "truth value".to_owned()),
        ProgramTokenKind::Partial | ProgramTokenKind::Sign => None,
    }
}

/// Returns the locations of a program, which tokens leave out: `%QX0.0` is another one than `%QX00`.
fn locations(program: &str) -> BTreeSet<String> {
    let ends = |character: char| !character.is_ascii_alphanumeric() && character != '.';
    let parts = program.split('%').skip(1);
    let words = parts.filter_map(|part| part.split(ends).next());
    let words = words.map(str::to_ascii_uppercase);
    words.filter(|word| word.starts_with(['I', 'Q', 'M'])).collect()
}

/// Returns the ways in which the statements use each name, such as ` [] .bit` for a bit of an element.
fn uses(tokens: &[ProgramToken<'_>]) -> BTreeMap<String, BTreeSet<String>> {
    let mut found: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let declared = in_declarations(tokens);
    for (at, token) in tokens.iter().enumerate() {
        let is_field = at > 0 && tokens[at - 1].text == ".";
        if token.kind == ProgramTokenKind::Word && !declared[at] && !is_field && !is_fixed(token.text) {
            let ways = found.entry(token.text.to_ascii_uppercase()).or_default();
            ways.insert(way(&tokens[at + 1..]));
        }
    }
    found
}

/// Returns the way in which a name is used, by the tokens behind it.
fn way(behind: &[ProgramToken<'_>]) -> String {
    let mut way = String::new();
    let mut rest = behind;
    loop {
        rest = match rest {
            [open, ..] if open.text == "[" => {
                way.push_str(" []");
                &rest[behind_brackets(rest)..]
            }
            [point, what, ..] if point.text == "." => {
                match what.kind {
                    ProgramTokenKind::Number => way.push_str(" .bit"),
                    ProgramTokenKind::Partial => way.extend([" .", what.text.get(..2).unwrap_or("%")]),
                    _ => way.extend([" .", &what.text.to_ascii_uppercase()]),
                }
                &rest[2..]
            }
            // A call is no use of a variable by itself.
            [open, ..] if open.text == "(" => return way + " ()",
            _ => return way,
        };
    }
}

/// Returns the number of tokens up to the end of the brackets that the first one opens.
fn behind_brackets(tokens: &[ProgramToken<'_>]) -> usize {
    let mut depth = 0_usize;
    for (at, token) in tokens.iter().enumerate() {
        match token.text {
            "[" => depth += 1,
            "]" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return at + 1;
        }
    }
    tokens.len()
}

/// Returns the names that are declared with an elementary type.
fn elementary(tokens: &[ProgramToken<'_>]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    // The names of a declaration so far, as in `a, b : INT`.
    let mut names = Vec::new();
    for pair in tokens.windows(3) {
        match pair[1].text {
            "," if pair[0].kind == ProgramTokenKind::Word => names.push(pair[0].text.to_ascii_uppercase()),
            ":" if pair[0].kind == ProgramTokenKind::Word => {
                names.push(pair[0].text.to_ascii_uppercase());
                let names = std::mem::take(&mut names);
                if ElementaryType::from_name(&pair[2].text.to_ascii_uppercase()).is_some() {
                    found.extend(names);
                }
            }
            ";" => names.clear(),
            _ => {}
        }
    }
    found
}

/// Returns the names that the statements use by themselves, with a part or as the block of a call, and that no section declares.
fn undeclared(tokens: &[ProgramToken<'_>]) -> BTreeSet<String> {
    let declared = in_declarations(tokens);
    let is_head = |at: usize| {
        let heads = ["PROGRAM", "FUNCTION", "FUNCTION_BLOCK"];
        at > 0 && heads.iter().any(|head| tokens[at - 1].is(head))
    };
    let known: BTreeSet<String> = tokens
        .iter()
        .enumerate()
        .filter(|(at, _)| declared[*at] || is_head(*at))
        .map(|(_, token)| token.text.to_ascii_uppercase())
        .collect();
    let mut used = uses(tokens);
    // A function may be one of the library.
    used.retain(|name, ways| !known.contains(name) && ways.iter().any(|way| way != " ()"));
    used.into_keys().collect()
}

/// Returns the operators before an operand and behind none, so that `a - b` does not become `-b`.
fn unary(tokens: &[ProgramToken<'_>]) -> BTreeSet<String> {
    let pairs = tokens.windows(2);
    let found = pairs.filter(|pair| matches!(pair[1].text, "+" | "-") && !ends_operand(&pair[0]));
    found.map(|pair| pair[1].text.to_owned()).collect()
}

/// Returns the names of the constructs of a program that no document promises, or not every one: where the whole program does
/// without one, a smaller program with it shows another mistake than the one under test.
fn unpromised(tokens: &[ProgramToken<'_>]) -> BTreeSet<&'static str> {
    let names = DeclaredNames::new(tokens);
    let found = [
        ("repetition of nothing", repeats_nothing(tokens)),
        ("empty statement", has_empty_statement(tokens)),
        ("expression as a statement", has_expression_as_statement(tokens)),
        (
            "truth value for another type",
            becomes_truth_value(tokens, &names),
        ),
        ("real number for an integer", becomes_real(tokens, &names)),
        ("initial value of a variable", begins_with_variable(tokens)),
        ("empty structure", has_empty_structure(tokens)),
        ("resource without a program", has_empty_resource(tokens)),
        ("task without a priority", has_task_without_priority(tokens)),
        (
            "global variable that is not external",
            uses_global_directly(tokens, &names),
        ),
        ("input that is assigned", assigns_input(tokens, &names)),
    ];
    let found = found.into_iter().filter(|(_, is_there)| *is_there);
    found.map(|(name, _)| name).collect()
}

/// Returns whether something is repeated zero times, as in `[0(5)]`, or counted by zero, or nothing is repeated, as in `[5()]`.
fn repeats_nothing(tokens: &[ProgramToken<'_>]) -> bool {
    let is_zero = |token: &ProgramToken<'_>| {
        token.kind == ProgramTokenKind::Number && token.text.chars().all(|digit| matches!(digit, '0' | '_'))
    };
    let mut triples = tokens.windows(3);
    triples.any(|triple| {
        triple[0].kind == ProgramTokenKind::Number
            && triple[1].text == "("
            && (is_zero(&triple[0]) || triple[2].text == ")")
            || triple[0].is("BY") && is_zero(&triple[1])
    })
}

/// Returns whether a statement is a semicolon alone.
fn has_empty_statement(tokens: &[ProgramToken<'_>]) -> bool {
    let before = [";", ":", "END_VAR", "OF", "DO", "THEN", "ELSE", "REPEAT"];
    let mut pairs = tokens.windows(2);
    pairs.any(|pair| pair[1].text == ";" && before.iter().any(|word| pair[0].is(word)))
}

/// Returns whether a literal or a comparison stands where a statement must, as where `d := D#2024-01-1.5;` becomes `D#2024-01-1;`
/// or `d = D#2024-01-1;`.
fn has_expression_as_statement(tokens: &[ProgramToken<'_>]) -> bool {
    let before = [";", "END_VAR", "DO", "THEN", "ELSE", "REPEAT"];
    let is_literal =
        |token: &ProgramToken<'_>| !matches!(token.kind, ProgramTokenKind::Word | ProgramTokenKind::Sign);
    (1..tokens.len()).any(|at| {
        let begins = before.iter().any(|word| tokens[at - 1].is(word));
        let behind = |place: usize| tokens.get(place).map(|token| token.text);
        let is_compared = || path(tokens, at).is_some_and(|end| behind(end) == Some("="));
        begins && (is_literal(&tokens[at]) && behind(at + 1) == Some(";") || is_compared())
    })
}

/// Returns the words that begin something whose end is not there, as where `END_PROGRAM` became `ENDPROGRAM`.
fn unclosed(tokens: &[ProgramToken<'_>]) -> BTreeSet<&'static str> {
    let pairs = [
        ("PROGRAM", "END_PROGRAM"),
        ("FUNCTION", "END_FUNCTION"),
        ("FUNCTION_BLOCK", "END_FUNCTION_BLOCK"),
        ("TYPE", "END_TYPE"),
        ("STRUCT", "END_STRUCT"),
        ("IF", "END_IF"),
        ("CASE", "END_CASE"),
        ("FOR", "END_FOR"),
        ("WHILE", "END_WHILE"),
        ("REPEAT", "END_REPEAT"),
    ];
    let number = |word: &str| tokens.iter().filter(|token| token.is(word)).count();
    let open = pairs.into_iter().filter(|(head, end)| number(head) > number(end));
    open.map(|(head, _)| head).collect()
}

/// Returns whether a statement or a call assigns a variable or a truth value alone, and one side is a BOOL and the other is not.
fn becomes_truth_value(tokens: &[ProgramToken<'_>], names: &DeclaredNames) -> bool {
    let is_truth_value = |token: &ProgramToken<'_>| match token.is("TRUE") || token.is("FALSE") {
        true => Some(true),
        false => Some(names.type_of(token)? == ElementaryType::Bool),
    };
    let mut assignments = tokens.windows(4);
    assignments.any(|four| {
        let is_alone = four[1].text == ":=" && matches!(four[3].text, ";" | "," | ")");
        let sides = (is_truth_value(&four[0]), is_truth_value(&four[2]));
        is_alone && matches!(sides, (Some(target), Some(value)) if target != value)
    })
}

/// Returns whether a real number is given to an integer, as where `x := -5` becomes `x := 0.0`.
fn becomes_real(tokens: &[ProgramToken<'_>], names: &DeclaredNames) -> bool {
    let is_real =
        |token: &ProgramToken<'_>| token.kind == ProgramTokenKind::Number && token.text.contains('.');
    let is_integer = |ty: ElementaryType| ty.is_integer() || ty.is_bit_string();
    (0..tokens.len()).any(|at| is_real(&tokens[at]) && names.target(tokens, at).is_some_and(is_integer))
}

/// Returns whether a declaration begins with the value of a variable of a section that is not `CONSTANT`.
fn begins_with_variable(tokens: &[ProgramToken<'_>]) -> bool {
    let declared = in_declarations(tokens);
    let mut variables = BTreeSet::new();
    let mut is_constant = true;
    for (at, token) in tokens.iter().enumerate().filter(|(at, _)| declared[*at]) {
        let next = tokens.get(at + 1);
        let upper = token.text.to_ascii_uppercase();
        if token.kind != ProgramTokenKind::Word {
            continue;
        } else if upper == "TYPE" || upper == "VAR" || upper.starts_with("VAR_") {
            is_constant = upper == "TYPE" || next.is_some_and(|next| next.is("CONSTANT"));
        } else if !is_constant && next.is_some_and(|next| matches!(next.text, ":" | ",")) {
            variables.insert(upper);
        }
    }
    let mut pairs = tokens.windows(2).zip(&declared);
    pairs.any(|(pair, declared)| {
        *declared
            && matches!(pair[0].text, ":=" | "[" | "(")
            && variables.contains(&pair[1].text.to_ascii_uppercase())
    })
}

/// Returns whether a structure has no field.
///
/// Basis: iec-61131-3: Annex A (`Struct_Decl`).
fn has_empty_structure(tokens: &[ProgramToken<'_>]) -> bool {
    let mut pairs = tokens.windows(2);
    pairs.any(|pair| pair[0].is("STRUCT") && pair[1].is("END_STRUCT"))
}

/// Returns whether a configuration has no resource, or a resource no program.
///
/// Basis: iec-61131-3: Annex A (`Config_Decl`, `Single_Resource_Decl`).
fn has_empty_resource(tokens: &[ProgramToken<'_>]) -> bool {
    let mut needs_program = false;
    for token in tokens {
        if token.is("CONFIGURATION") || token.is("RESOURCE") {
            needs_program = true;
        } else if token.is("PROGRAM") {
            needs_program = false;
        } else if needs_program && (token.is("END_RESOURCE") || token.is("END_CONFIGURATION")) {
            return true;
        }
    }
    false
}

/// Returns whether a task has no priority.
///
/// Basis: iec-61131-3: Annex A (`Task_Init`).
fn has_task_without_priority(tokens: &[ProgramToken<'_>]) -> bool {
    let number = |word: &str| tokens.iter().filter(|token| token.is(word)).count();
    number("TASK") > number("PRIORITY")
}

/// Returns whether a body uses a global variable, and no unit declares an external one.
///
/// Basis: iec-61131-3: 6.5.2.2 (VAR_EXTERNAL).
fn uses_global_directly(tokens: &[ProgramToken<'_>], names: &DeclaredNames) -> bool {
    let is_global = |at: usize| names.globals.contains(&tokens[at].text.to_ascii_uppercase());
    let has_external = tokens.iter().any(|token| token.is("VAR_EXTERNAL"));
    !has_external && (0..tokens.len()).any(|at| !names.is_declared_at(at) && is_global(at))
}

/// Returns whether a function or a function block assigns one of its own inputs.
///
/// Basis: iec-61131-3: 6.5.2.2 (VAR_INPUT: not modifiable within the unit).
fn assigns_input(tokens: &[ProgramToken<'_>], names: &DeclaredNames) -> bool {
    let mut inputs = None;
    (1..tokens.len()).any(|at| {
        let (before, upper) = (&tokens[at - 1], tokens[at].text.to_ascii_uppercase());
        if ["FUNCTION", "FUNCTION_BLOCK", "PROGRAM"]
            .iter()
            .any(|head| before.is(head))
        {
            inputs = names.inputs.get(&upper);
        }
        let is_input = inputs.is_some_and(|inputs| inputs.contains(&upper)) && !names.is_declared_at(at);
        // An argument by name stands behind a bracket or a comma.
        is_input && !matches!(before.text, "(" | ",") && is_assigned(tokens, at)
    })
}

/// Returns whether the variable at a place is assigned, or an element, a field or a bit of it.
fn is_assigned(tokens: &[ProgramToken<'_>], at: usize) -> bool {
    let Some(end) = path(tokens, at) else {
        return false;
    };
    let text = |place: usize| tokens.get(place).map(|token| token.text);
    let sign = if text(end) == Some(".") { end + 2 } else { end };
    text(sign) == Some(":=")
}

/// Returns whether a program has variables in each of its sections, and statements: some compilers reject a program without
/// them for that alone, whatever else was wrong with it.
fn is_whole(tokens: &[ProgramToken<'_>]) -> bool {
    let mut has_variables = false;
    for pair in tokens.windows(2) {
        let opens =
            pair[0].kind == ProgramTokenKind::Word && pair[0].text.to_ascii_uppercase().starts_with("VAR");
        let closes = ["END_PROGRAM", "END_FUNCTION", "END_FUNCTION_BLOCK"]
            .iter()
            .any(|end| pair[1].is(end));
        if opens && pair[1].is("END_VAR") || closes && pair[0].is("END_VAR") {
            return false;
        }
        has_variables |= pair[0].is("END_VAR");
    }
    has_variables
}

#[cfg(test)]
mod tests;
