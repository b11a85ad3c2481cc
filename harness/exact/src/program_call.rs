//! Recognizes programs that make one call of a conversion function, or take one part out of a variable, and do nothing else, as
//! those of most cases do.

use stickler_types::{ElementaryType, Value};

/// The one call of a program.
#[derive(Clone, PartialEq, Debug)]
pub struct ProgramCall<'p> {
    /// The name of the function, as the program writes it.
    pub function: &'p str,
    /// The operand.
    pub operand: Value,
    /// The variable that takes the result.
    pub target: &'p str,
    /// The type of the variable that takes the result.
    pub result: ElementaryType,
}

/// Returns the call of a program whose body is one assignment, `into := F(data);` or `into := F(INT#5);`, of declared variables
/// of elementary types; `None` for all other programs.
#[must_use]
pub fn call_of_program(source: &str) -> Option<ProgramCall<'_>> {
    let (declarations, target, value) = one_assignment(source)?;
    let (function, argument) = value.trim().strip_suffix(')')?.split_once('(')?;
    let (function, argument) = (function.trim(), argument.trim());
    if !(is_name(target) && is_name(function)) {
        return None;
    }
    let (result, _) = declared(declarations, target)?;
    let operand = if is_name(argument) {
        let (ty, initial) = declared(declarations, argument)?;
        value_of(ty, initial?)?
    } else {
        Value::parse(argument).ok()?
    };
    Some(ProgramCall {
        function,
        operand,
        target,
        result,
    })
}

/// A bit or a part of a variable that a program reads or writes.
#[derive(Clone, PartialEq, Debug)]
pub struct PartAccess<'p> {
    /// The type of the variable.
    pub ty: ElementaryType,
    /// The text behind the variable's dot: `7`, `%X7` or `%B1`.
    pub part: &'p str,
}

/// Returns the access of a program whose body is one assignment, `r := v.7;` or `v.%X7 := TRUE;`, to a declared variable of an
/// elementary type; `None` for all other programs.
#[must_use]
pub fn part_of_program(source: &str) -> Option<PartAccess<'_>> {
    let (declarations, target, value) = one_assignment(source)?;
    let access = |text: &'_ str| -> Option<(usize, ElementaryType)> {
        let (variable, part) = text.split_once('.')?;
        let index = part
            .strip_prefix('%')
            .map_or(part, |part| part.get(1..).unwrap_or_default());
        let is_part = !index.is_empty() && index.bytes().all(|byte| byte.is_ascii_digit());
        let (ty, _) = declared(declarations, variable).filter(|_| is_part && is_name(variable))?;
        Some((variable.len() + 1, ty))
    };
    match (access(target), access(value)) {
        (Some((at, ty)), None) => Some(PartAccess {
            ty,
            part: &target[at..],
        }),
        (None, Some((at, ty))) => Some(PartAccess {
            ty,
            part: &value[at..],
        }),
        _ => None,
    }
}

/// Returns the declarations of a program, and both sides of the one assignment that is its body.
fn one_assignment(source: &str) -> Option<(&str, &str, &str)> {
    let declarations = source.trim_start().strip_prefix("PROGRAM")?;
    let (declarations, body) = declarations.rsplit_once("END_VAR")?;
    let (body, _) = body.split_once("END_PROGRAM")?;
    // A mark behind the statement is a comment.
    let statement = match body.split_once("(*") {
        Some((statement, rest)) if rest.trim_end().ends_with("*)") => statement,
        Some(_) => return None,
        None => body,
    };
    let (target, value) = statement.trim().strip_suffix(';')?.split_once(":=")?;
    // In a text, a semicolon ends no statement.
    let is_one = !value.contains(';') || value.contains(['\'', '"']);
    is_one.then_some((declarations, target.trim(), value.trim()))
}

/// Returns the type and the initial value of a variable that is declared on a line of its own.
fn declared<'p>(declarations: &'p str, name: &str) -> Option<(ElementaryType, Option<&'p str>)> {
    declarations.lines().find_map(|line| {
        let (declared, rest) = line.split_once(':')?;
        let (ty, initial) = match rest.split_once(":=") {
            Some((ty, initial)) => (ty, Some(initial.trim().strip_suffix(';')?.trim_end())),
            None => (rest.trim().strip_suffix(';')?, None),
        };
        (declared.trim() == name).then_some((ElementaryType::from_name(ty.trim())?, initial))
    })
}

/// Parses an initial value, with or without its type.
fn value_of(ty: ElementaryType, literal: &str) -> Option<Value> {
    let value = Value::parse(&format!("{ty}#{literal}")).or_else(|_| Value::parse(literal));
    value.ok().filter(|value| value.type_name() == ty.name())
}

fn is_name(text: &str) -> bool {
    let mut characters = text.chars();
    let first = characters.next();
    first.is_some_and(|first| first.is_ascii_alphabetic() || first == '_')
        && characters.all(|character| character.is_ascii_alphanumeric() || character == '_')
}

#[cfg(test)]
mod tests {
    use super::{call_of_program, part_of_program};

    fn call(declarations: &str, body: &str) -> Option<String> {
        let source = format!("PROGRAM main\nVAR\n{declarations}\nEND_VAR\n    {body}\nEND_PROGRAM\n");
        let call = call_of_program(&source)?;
        assert_eq!(call.target, "into");
        Some(format!("{}({}) : {}", call.function, call.operand, call.result))
    }

    #[test]
    fn a_call_of_a_variable_or_of_a_literal_is_recognized() {
        let variables = "    data : REAL := 2.5;\n    into : INT;";
        let expected = Some("REAL_TO_INT(REAL#2.5) : INT".to_owned());
        assert_eq!(call(variables, "into := REAL_TO_INT(data);"), expected);
        assert_eq!(
            call(variables, "into := REAL_TO_INT(REAL#2.5);  (*! error P4035 *)"),
            expected
        );
        assert_eq!(
            call(
                "    data : TIME := T#5ms;\n    into : DINT := 5;",
                "into := TIME_TO_DINT(data);"
            ),
            Some("TIME_TO_DINT(TIME#5ms) : DINT".to_owned())
        );
        assert_eq!(
            call(
                "    data : STRING := 'a; b(c)';\n    into : DINT;",
                "into := TO_DINT(data);"
            ),
            Some("TO_DINT(STRING#'a; b(c)') : DINT".to_owned())
        );
    }

    #[test]
    fn programs_that_do_more_are_not() {
        let variables = "    data : REAL := 2.5;\n    into : INT;";
        for body in [
            "into := REAL_TO_INT(data) + 1;",
            "data := 3.5; into := REAL_TO_INT(data);",
            "into := REAL_TO_INT(data + 1.0);",
            "into := DINT_TO_INT(REAL_TO_DINT(data));",
            "into := REAL_TO_INT(IN := data);",
            "into := REAL_TO_INT(2.5);",
            "into := REAL_TO_INT(data); into := 5;",
            "(*! ok *) into := REAL_TO_INT(data);",
            "into := data;",
            "IF TRUE THEN into := REAL_TO_INT(data); END_IF;",
            "other := REAL_TO_INT(data);",
            "into[1] := REAL_TO_INT(data);",
        ] {
            assert_eq!(call(variables, body), None, "{body}");
        }
        assert_eq!(
            call("    data : REAL;\n    into : INT;", "into := REAL_TO_INT(data);"),
            None
        );
        assert_eq!(
            call(
                "    data : Own := 1.5;\n    into : INT;",
                "into := REAL_TO_INT(data);"
            ),
            None
        );
    }

    #[test]
    fn a_part_that_is_read_or_written_is_recognized() {
        let part = |body: &str| {
            let source = format!(
                "PROGRAM main\nVAR\n    v : BYTE := 5;\n    r : BOOL;\nEND_VAR\n    {body}\nEND_PROGRAM\n"
            );
            part_of_program(&source).map(|access| format!("{}.{}", access.ty, access.part))
        };
        assert_eq!(part("r := v.7;"), Some("BYTE.7".to_owned()));
        assert_eq!(
            part("v.%X8 := TRUE;  (*! error P4025 *)"),
            Some("BYTE.%X8".to_owned())
        );
        for body in [
            "r := v;",
            "r := s.f;",
            "v.1 := v.2;",
            "r := NOT v.7;",
            "v.7 := TRUE; r := v.7;",
            "v.x := TRUE;",
        ] {
            assert_eq!(part(body), None, "{body}");
        }
    }
}
