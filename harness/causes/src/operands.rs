//! The operands of a small program, each in a program of its own: whether the engine already fails with the operand alone is then
//! asked before the operation around it is blamed.

use crate::literals::special_literal;
use crate::names::{DeclaredNames, converted, literal, prefix_type};
use crate::operations::{calculates, is_comparison};
use crate::tokens::{ProgramToken, ProgramTokenKind, tokens};
use stickler_types::ElementaryType;

/// A program that does with one operand what another program does with it among other things.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Alone {
    pub(crate) program: String,
    /// The type of the variable `into`, which shows the value of the operand.
    pub(crate) ty: ElementaryType,
    /// The type of the variable `data`, where the operand is one.
    pub(crate) data: Option<ElementaryType>,
    /// The literal, where the operand is one.
    pub(crate) literal: Option<String>,
}

/// Returns a program with its bodies left out, so that its variables keep what they begin with; `None` where a part of it has no
/// variables. Each body assigns one variable to itself, since not every compiler takes a body without a statement.
pub(crate) fn only_initial_values(program: &str) -> Option<String> {
    let all = tokens(program);
    let names = DeclaredNames::new(&all);
    let mut text = String::new();
    let (mut until, mut own) = (0, None);
    let mut section = None;
    for (at, token) in all.iter().enumerate() {
        if token.is("END_VAR") {
            section = Some(token.start);
        } else if names.is_declared_at(at) && all.get(at + 1).is_some_and(|next| next.text == ":") {
            own = own.or_else(|| names.type_of(token).map(|_| token.text));
        } else if ["END_PROGRAM", "END_FUNCTION", "END_FUNCTION_BLOCK"]
            .iter()
            .any(|end| token.is(end))
        {
            let section = section.take()?;
            text.push_str(program[until..section].trim_end());
            text.push_str(&match own.take() {
                Some(own) => format!("\nEND_VAR\n    {own} := {own};\n"),
                None => "\n    done : BOOL;\nEND_VAR\n    done := TRUE;\n".to_owned(),
            });
            until = token.start;
        } else if token.is("END_TYPE") {
            own = None;
        }
    }
    text.push_str(&program[until..]);
    Some(text)
}

/// Returns a program with a variable of the right type in the place of each operand that is given to something: a program without
/// its mistake, where the type of an operand is the mistake.
pub(crate) fn with_fitting_operands(program: &str) -> Vec<String> {
    let all = tokens(program);
    let names = DeclaredNames::new(&all);
    let Some(start) = program
        .rfind("\nPROGRAM ")
        .or_else(|| program.starts_with("PROGRAM ").then_some(0))
    else {
        return Vec::new();
    };
    let Some(section) = program[start..].find("END_VAR").map(|at| start + at) else {
        return Vec::new();
    };
    let mut found = Vec::new();
    for (at, token) in all.iter().enumerate() {
        let ends = all
            .get(at + 1)
            .is_some_and(|next| matches!(next.text, ";" | "," | ")"));
        let words = names.words(&all, at).filter(|_| ends && token.start > section);
        let Some(words) = words else { continue };
        let (from, until) = (token.start, token.end());
        found.push(without_unused(&format!(
            "{}    fitting : {words};\n{}fitting{}",
            &program[..section],
            &program[section..from],
            &program[until..]
        )));
    }
    found
}

/// Returns a program without the variables of its PROGRAM that have a line of their own and are not used.
pub(crate) fn without_unused(program: &str) -> String {
    let all = tokens(program);
    let start = program.rfind("PROGRAM ").unwrap_or_default();
    // Types may stand behind the program.
    let end = program[start..]
        .find("END_PROGRAM")
        .map_or(program.len(), |end| start + end);
    let is_unused = |line: &str| {
        let is_inside = (start..end).contains(&(line.as_ptr() as usize - program.as_ptr() as usize));
        let declared = tokens(line);
        let is_plain = matches!(&declared[..], [_, colon, _, end] if colon.text == ":" && end.text == ";");
        let uses = |name: &str| all.iter().filter(|token| token.is(name)).count();
        is_plain && is_inside && uses(declared[0].text) == 1
    };
    program
        .split_inclusive('\n')
        .filter(|line| !is_unused(line))
        .collect()
}

/// Returns the operands of a program alone: literals first, then variables, then calls of conversion functions. The most
/// general place comes first: an assignment before an initial value.
pub(crate) fn alone(program: &str) -> Vec<Alone> {
    let tokens = tokens(program);
    let names = DeclaredNames::new(&tokens);
    let (mut literals, mut variables, mut calls) = (Vec::new(), Vec::new(), Vec::new());
    for (at, token) in tokens.iter().enumerate() {
        if let Some(call) = conversion(&tokens, at, &names) {
            calls.push(call);
        }
        let target = names.target(&tokens, at);
        if let Some(literal) = literal(&tokens, at) {
            let is_special = special_literal(token).is_some();
            let in_calculation = || calculated(&tokens, at, &names).filter(|_| is_special);
            let target = target.or_else(in_calculation);
            let Some(ty) = target.or_else(|| prefix_type(token)) else {
                continue;
            };
            let plain = literal.split_once('#').filter(|_| prefix_type(token) == Some(ty));
            literals.extend(plain.map(|(_, plain)| Alone::assigned(ty, plain)));
            literals.push(Alone::assigned(ty, &literal));
            if names.is_declared_at(at) {
                literals.push(Alone::initial(ty, &literal));
            }
        } else if let (Some(ty), Some(from)) = (target, names.type_of(token)) {
            let value = names.initial.get(&token.text.to_ascii_uppercase()).cloned();
            let value = value.or_else(|| names.some_value(from));
            variables.push(Alone::copied(from, ty, value.as_deref()));
        }
        if let Some((from, ty)) = names.met(&tokens, at) {
            let value = names.some_value(from);
            variables.push(Alone::copied(from, ty, value.as_deref()));
        }
        variables.extend(mixed(&names, &tokens, at));
        variables.extend(behind_arithmetic(&names, &tokens, at));
    }
    let mut found: Vec<Alone> = Vec::new();
    for one in literals.into_iter().chain(variables).chain(calls) {
        if found.iter().all(|other| other.program != one.program) && one.program.trim() != program.trim() {
            found.push(one);
        }
    }
    found
}

impl Alone {
    /// Assigns a literal.
    fn assigned(ty: ElementaryType, literal: &str) -> Alone {
        Alone {
            literal: Some(literal.to_owned()),
            ..Alone::new(None, ty, literal)
        }
    }

    /// Begins a variable with a literal, and assigns the variable.
    fn initial(ty: ElementaryType, literal: &str) -> Alone {
        Alone {
            literal: Some(literal.to_owned()),
            ..Alone::copied(ty, ty, Some(literal))
        }
    }

    /// Assigns a variable of the type `from`, which may have an initial value.
    fn copied(from: ElementaryType, ty: ElementaryType, initial: Option<&str>) -> Alone {
        Alone::new(Some((from, initial)), ty, "data")
    }

    /// Assigns an expression, which may use the variable `data` with a type and an initial value.
    fn new(data: Option<(ElementaryType, Option<&str>)>, ty: ElementaryType, expression: &str) -> Alone {
        let from = data.map(|(from, _)| from);
        let data = data.map(|(from, initial)| {
            let initial = initial.map(|value| format!(" := {value}")).unwrap_or_default();
            format!("    data : {}{initial};\n", from.name())
        });
        let (data, name) = (data.unwrap_or_default(), ty.name());
        Alone {
            program: format!(
                "PROGRAM main\nVAR\n{data}    into : {name};\nEND_VAR\n    into := {expression};\nEND_PROGRAM\n"
            ),
            ty,
            data: from,
            literal: None,
        }
    }
}

/// Returns the type of the number that a calculation is assigned to in which the operand at a place stands.
fn calculated(tokens: &[ProgramToken<'_>], at: usize, names: &DeclaredNames) -> Option<ElementaryType> {
    let sign = tokens[..at].iter().rposition(|token| token.text == ":=")?;
    let is_part =
        |token: &ProgramToken<'_>| !matches!(token.text, ";" | "(" | "[" | ",") && !is_comparison(token.text);
    let is_within = tokens[sign..at].iter().all(is_part);
    names
        .assigned(tokens, sign)
        .filter(|ty| is_within && is_number(*ty))
}

/// Returns a call of a conversion function with a variable, for the name of such a function before a bracket.
fn conversion(tokens: &[ProgramToken<'_>], at: usize, names: &DeclaredNames) -> Option<Alone> {
    let (from, ty) = converted(tokens.get(at)?)?;
    if tokens.get(at + 1)?.text != "(" || names.own.contains(&tokens[at].text.to_ascii_uppercase()) {
        return None;
    }
    let operand = literal(tokens, at + 2).or_else(|| {
        let name = tokens.get(at + 2)?.text.to_ascii_uppercase();
        names.initial.get(&name).cloned()
    });
    let operand = operand.or_else(|| names.some_value(from));
    let call = format!("{}(data)", tokens[at].text);
    Some(Alone::new(Some((from, operand.as_deref())), ty, &call))
}

/// Returns the conversions of an operand to the type of the other, for the operator between operands of different types.
fn mixed(names: &DeclaredNames, tokens: &[ProgramToken<'_>], at: usize) -> Vec<Alone> {
    let is_operator = calculates(&tokens[at]) || is_comparison(tokens[at].text);
    let operand = |place: Option<usize>| {
        let token = tokens.get(place?)?;
        match prefix_type(token) {
            Some(ty) => Some((ty, Some(token.text.to_owned()))),
            None => names.type_of(token).map(|ty| (ty, names.some_value(ty))),
        }
    };
    match (operand(at.checked_sub(1)), operand(Some(at + 1))) {
        (Some((left, first)), Some((right, second)))
            if is_operator && left != right && is_number(left) && is_number(right) =>
        {
            vec![
                Alone::copied(left, right, first.as_deref()),
                Alone::copied(right, left, second.as_deref()),
            ]
        }
        _ => Vec::new(),
    }
}

/// Returns whether operands of a type are converted to that of the other operand or of the target: a duration is multiplied by a
/// number as it is.
const fn is_number(ty: ElementaryType) -> bool {
    ty.is_integer() || ty.is_bit_string() || ty.is_real()
}

/// Returns the conversions of the operands of a calculation to the type of what is assigned, for the assignment sign before it.
fn behind_arithmetic(names: &DeclaredNames, tokens: &[ProgramToken<'_>], at: usize) -> Vec<Alone> {
    let expression = || tokens[at + 1..].iter().take_while(|token| token.text != ";");
    let is_operand = |token: &ProgramToken<'_>| token.kind != ProgramTokenKind::Sign && !token.is("MOD");
    let is_calculation = tokens[at].text == ":="
        && expression().all(|token| is_operand(token) || calculates(token))
        && expression().filter(|token| is_operand(token)).count() > 1;
    let target = names
        .assigned(tokens, at)
        .filter(|ty| is_calculation && is_number(*ty));
    let Some(target) = target else {
        return Vec::new();
    };
    let sources = expression().filter_map(|token| names.type_of_operand(token));
    sources
        .filter(|source| *source != target && is_number(*source))
        .map(|source| Alone::copied(source, target, names.some_value(source).as_deref()))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{alone, only_initial_values, with_fitting_operands};

    fn bodies(program: &str) -> Vec<String> {
        let line = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let body = |program: &str| {
            line(program)
                .trim_start_matches("PROGRAM main VAR ")
                .trim_end_matches(" END_PROGRAM")
                .to_owned()
        };
        alone(program).iter().map(|one| body(&one.program)).collect()
    }

    #[test]
    fn literals_come_before_variables_and_calls_and_assignments_before_initial_values() {
        let program = "PROGRAM p VAR m : LREAL := -1.0; r : REAL; END_VAR r := LREAL_TO_REAL(m); END_PROGRAM";
        assert_eq!(
            bodies(program),
            [
                "into : LREAL; END_VAR into := -1.0;",
                "data : LREAL := -1.0; into : LREAL; END_VAR into := data;",
                "data : LREAL := -1.0; into : REAL; END_VAR into := LREAL_TO_REAL(data);",
            ]
        );
    }

    #[test]
    fn bodies_are_left_out_and_initial_values_stay() {
        let block = "FUNCTION_BLOCK w\nVAR_OUTPUT\n    v : INT := 7;\nEND_VAR\n    v.0 := FALSE;\nEND_FUNCTION_BLOCK\n\n";
        let main = "PROGRAM main\nVAR\n    fb : w;\nEND_VAR\n    fb();\nEND_PROGRAM\n";
        assert_eq!(
            only_initial_values(&format!("{block}{main}")).as_deref(),
            Some(
                "FUNCTION_BLOCK w\nVAR_OUTPUT\n    v : INT := 7;\nEND_VAR\n    v := v;\nEND_FUNCTION_BLOCK\n\nPROGRAM main\nVAR\n    \
                 fb : w;\n    done : BOOL;\nEND_VAR\n    done := TRUE;\nEND_PROGRAM\n"
            )
        );
        assert_eq!(only_initial_values("PROGRAM main\n    f();\nEND_PROGRAM\n"), None);
    }

    #[test]
    fn a_duration_that_is_multiplied_is_not_converted() {
        let program = "PROGRAM p VAR t : TIME; r : REAL; END_VAR t := t * r; END_PROGRAM";
        assert_eq!(bodies(program), [""; 0]);
    }

    #[test]
    fn the_type_of_a_target_is_found_wherever_it_is_declared() {
        for (program, expected) in [
            (
                "TYPE t : SINT; END_TYPE PROGRAM p VAR x : t; END_VAR x := 200; END_PROGRAM",
                "into : SINT; END_VAR into := 200;",
            ),
            (
                "PROGRAM p VAR a : ARRAY[0..1] OF BYTE := [5, 6]; END_VAR a[0] := a[1]; END_PROGRAM",
                "into : BYTE; END_VAR into := 5;",
            ),
            (
                "FUNCTION f : INT VAR_INPUT n : REAL; END_VAR f := 1; END_FUNCTION PROGRAM p VAR x : INT; END_VAR x := f(5); END_PROGRAM",
                "into : REAL; END_VAR into := 5;",
            ),
            (
                "TYPE R : STRUCT f : WORD; END_STRUCT; END_TYPE PROGRAM p VAR r : R := (f := 7); END_VAR r.f := r.f; END_PROGRAM",
                "into : WORD; END_VAR into := 7;",
            ),
            (
                "FUNCTION_BLOCK h VAR_INPUT in : ULINT; END_VAR VAR_OUTPUT out : ULINT; END_VAR out := in; END_FUNCTION_BLOCK PROGRAM p VAR \
                 b : h; into : ULINT; END_VAR b.in := 18446744073709551615; b(); into := b.out; END_PROGRAM",
                "into : ULINT; END_VAR into := 18446744073709551615;",
            ),
            (
                "PROGRAM p VAR a : ARRAY[0..3] OF SINT := [1, 3(200)]; END_VAR a[0] := a[1]; END_PROGRAM",
                "into : SINT; END_VAR into := 200;",
            ),
            (
                "PROGRAM p VAR s : SINT := -5; x : LREAL; END_VAR x := s + SINT#2; END_PROGRAM",
                "data : SINT := -5; into : LREAL; END_VAR into := data;",
            ),
            (
                "PROGRAM p VAR x : DINT; t : TIME; END_VAR t := T#1s + T#2s; x := x - 1; END_PROGRAM",
                "into : TIME; END_VAR into := T#1s;",
            ),
            (
                "PROGRAM p VAR x : UDINT; END_VAR x := 2#0 * 8#0; END_PROGRAM",
                "into : UDINT; END_VAR into := 8#0;",
            ),
        ] {
            let found = bodies(program);
            assert!(found.iter().any(|body| body == expected), "{program}: {found:?}");
            assert!(
                !found
                    .iter()
                    .any(|body| body.contains(":= 1;") && body.contains("DINT")),
                "{found:?}"
            );
        }
    }

    #[test]
    fn the_operand_that_a_fitting_one_replaces_goes() {
        let types = "TYPE\n    e : INT;\nEND_TYPE\n";
        let program =
            format!("PROGRAM p\nVAR\n    d : DT;\n    x : INT;\nEND_VAR\n    x := d;\nEND_PROGRAM\n{types}");
        assert_eq!(
            with_fitting_operands(&program),
            [format!(
                "PROGRAM p\nVAR\n    x : INT;\n    fitting : INT;\nEND_VAR\n    x := fitting;\nEND_PROGRAM\n{types}"
            )]
        );
    }
}
