//! A program that is one call of a function, read from its text.
//!
//! The tables of conversion functions consist of such programs. This is not a parser of the language: a program that is not
//! written in exactly this form is ignored.

use stickler_types::{ElementaryType, Value};

/// A program that declares variables, at most one of them with an initial value, and assigns the result of one call to one
/// of them.
pub(crate) struct ConversionCall<'s> {
    /// The name of the called function.
    pub(crate) function: &'s str,
    /// The value of the argument.
    pub(crate) operand: Value,
    /// The variable that takes the result.
    pub(crate) into: &'s str,
    /// The type of the variable that takes the result.
    pub(crate) result: ElementaryType,
}

/// A variable of the program.
struct CallVariable<'s> {
    name: &'s str,
    ty: ElementaryType,
    initial: Option<&'s str>,
}

impl<'s> ConversionCall<'s> {
    /// Reads the call from a program; `None` if the program is anything else.
    pub(crate) fn read(source: &'s str) -> Option<ConversionCall<'s>> {
        let mut lines = source.lines().map(str::trim).filter(|line| !line.is_empty());
        if lines.next()? != "PROGRAM main" {
            return None;
        }
        let mut variables = Vec::new();
        let mut line = lines.next()?;
        while matches!(line, "VAR" | "VAR CONSTANT") {
            loop {
                match lines.next()? {
                    "END_VAR" => break,
                    declaration => variables.push(variable(declaration)?),
                }
            }
            line = lines.next()?;
        }
        if lines.next()? != "END_PROGRAM" || lines.next().is_some() {
            return None;
        }
        let (into, call) = line.strip_suffix(';')?.split_once(":=")?;
        let (function, argument) = call.trim().strip_suffix(')')?.split_once('(')?;
        let into = variables.iter().find(|variable| variable.name == into.trim())?;
        let plain = |text: &str| text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        if !plain(function) || into.initial.is_some() {
            return None;
        }
        Some(ConversionCall {
            function,
            operand: operand(argument.trim(), &variables)?,
            into: into.name,
            result: into.ty,
        })
    }
}

/// Reads `name : TYPE;` or `name : TYPE := literal;`.
fn variable(line: &str) -> Option<CallVariable<'_>> {
    let (name, rest) = line.strip_suffix(';')?.split_once(':')?;
    let (ty, initial) = match rest.split_once(":=") {
        Some((ty, initial)) => (ty, Some(initial.trim())),
        None => (rest, None),
    };
    Some(CallVariable {
        name: name.trim(),
        ty: ElementaryType::from_name(ty.trim())?,
        initial,
    })
}

/// Returns the value of an argument: a typed literal, or a variable with an initial value.
fn operand(argument: &str, variables: &[CallVariable<'_>]) -> Option<Value> {
    let Some(variable) = variables.iter().find(|variable| variable.name == argument) else {
        return Value::parse(argument).ok();
    };
    let initial = variable.initial?;
    let has_type = |value: &Value| match value {
        Value::Plain { ty, .. } | Value::Text { ty, .. } => *ty == variable.ty,
        Value::Enumerated { .. } | Value::OutOfRange { .. } => false,
    };
    let typed = format!("{}#{initial}", variable.ty);
    [initial, &typed]
        .into_iter()
        .filter_map(|literal| Value::parse(literal).ok())
        .find(has_type)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(declarations: &str, statement: &str) -> Option<String> {
        let text = format!("PROGRAM main\n{declarations}    {statement}\nEND_PROGRAM\n");
        let call = ConversionCall::read(&text)?;
        let ConversionCall {
            function,
            operand,
            into,
            result,
        } = call;
        Some(format!("{into} : {result} := {function}({operand})"))
    }

    #[test]
    fn a_call_is_read_with_its_operand() {
        let variables =
            |ty: &str, value: &str| format!("VAR\n    data : {ty} := {value};\n    into : INT;\nEND_VAR\n");
        let call = |ty: &str, value: &str| read(&variables(ty, value), "into := TO_INT(data);");
        for (ty, value, operand) in [
            ("REAL", "-2.5", "REAL#-2.5"),
            ("STRING", "'a:=b'", "STRING#'a:=b'"),
            ("WORD", "16#FF", "WORD#16#00FF"),
            ("TIME", "T#5ms", "TIME#5ms"),
            ("LREAL", "LREAL#1.0", "LREAL#1.0"),
            ("BOOL", "TRUE", "BOOL#TRUE"),
        ] {
            let expected = format!("into : INT := TO_INT({operand})");
            assert_eq!(call(ty, value), Some(expected), "{ty} {value}");
        }
        let typed = read(
            "VAR\n    into : DINT;\nEND_VAR\n",
            "into := REAL_TO_DINT(REAL#2.5);",
        );
        assert_eq!(typed.as_deref(), Some("into : DINT := REAL_TO_DINT(REAL#2.5)"));
        let constant = "VAR CONSTANT\n    given : REAL := 1.5;\nEND_VAR\nVAR\n    into : INT;\nEND_VAR\n";
        assert!(read(constant, "into := REAL_TO_INT(given);").is_some());
    }

    #[test]
    fn anything_else_is_passed_over() {
        let variables = "VAR\n    data : REAL := 2.5;\n    into : INT;\nEND_VAR\n";
        for statement in [
            "into := REAL_TO_INT(data) + 1;",
            "into := REAL_TO_INT(data + 1.0);",
            "into := DINT_TO_INT(REAL_TO_DINT(data));",
            "into := REAL_TO_INT(IN := data);",
            "into := data;",
            "into := REAL_TO_INT(data); into := 5;",
            "other := REAL_TO_INT(data);",
            "(*! ok *) into := REAL_TO_INT(data);",
            "IF TRUE THEN",
        ] {
            assert_eq!(read(variables, statement), None, "{statement}");
        }
        assert_eq!(
            read("VAR\n    into : INT;\nEND_VAR\n", "into := REAL_TO_INT(2.5);"),
            None
        );
        assert!(ConversionCall::read("").is_none());
    }
}
