//! The program that calls a function block or function which is judged.

use crate::source_file::running;
use anyhow::Context;
use stickler_syntax::tree::{Pou, PouKind, SourceUnit, VariableGroup, VariableKind};
use stickler_types::{Dialect, DialectName, join};

/// The program that calls.
const CALLER: &str = "stickler_judge";

/// The instance of the function block in the program that calls it.
const INSTANCE: &str = "stickler_block";

/// The result of the function in the program that calls it.
const RESULT: &str = "stickler_result";

/// A text with a program, and how a trace names its variables.
pub(in crate::commands) struct Judged {
    /// The whole text.
    pub text: String,
    /// The paths that stand before the names of a trace, the first that fits first.
    pub prefixes: &'static [&'static str],
    /// The function whose result a trace calls by its name.
    pub function: Option<String>,
}

impl Judged {
    /// Returns the path of a variable that a trace names.
    pub(in crate::commands) fn path<'n>(&self, name: &'n str) -> &'n str {
        let is_result = |function: &String| function.eq_ignore_ascii_case(name);
        match &self.function {
            Some(function) if is_result(function) => RESULT,
            _ => name,
        }
    }

    /// Returns the name by which a trace knows the variable of a path.
    pub(in crate::commands) fn shown(&self, path: &str) -> String {
        let name = path.strip_prefix(self.prefixes[0]).unwrap_or(path);
        match (&self.function, name.strip_prefix(RESULT)) {
            (Some(function), Some(parts)) => format!("{function}{parts}"),
            _ => name.to_owned(),
        }
    }

    /// Returns a text with a program that calls the named unit once a scan: with the program of the text where no unit is named
    /// and there is one, else its last function block, or else its last function. Lines stay where they are.
    ///
    /// # Errors
    /// No unit of that name, or nothing to call.
    pub(in crate::commands) fn of(
        text: &str,
        dialect: DialectName,
        named: Option<&str>,
    ) -> anyhow::Result<Judged> {
        let (unit, _) = stickler_syntax::parse(text, Dialect::of(dialect));
        let has_program = last(&unit, PouKind::Program).is_some();
        let is_program =
            |pou: &Pou<'_>| pou.kind == PouKind::Program && named.is_none_or(|name| pou.name.is(name));
        if unit.pous().any(is_program) {
            return Ok(Judged {
                text: named.map_or_else(|| Ok(text.to_owned()), |name| running(text, name, dialect))?,
                prefixes: &[""],
                function: None,
            });
        }
        let called = called(&unit, named)?;
        let is_function = called.kind == PouKind::Function;
        let caller = match is_function {
            true => caller_of_function(text, called),
            false => caller_of_block(text, called),
        };
        let all = format!("{text}\n{caller}");
        // The program that calls runs alone.
        let is_alone = !has_program && unit.configurations().next().is_none();
        Ok(Judged {
            text: match is_alone {
                true => all,
                false => running(&all, CALLER, dialect)?,
            },
            prefixes: match is_function {
                true => &[""],
                false => &["stickler_block.", ""],
            },
            function: is_function.then(|| called.name.text.to_owned()),
        })
    }
}

/// Returns the last unit of a kind.
fn last<'t, 's>(unit: &'t SourceUnit<'s>, kind: PouKind) -> Option<&'t Pou<'s>> {
    unit.pous().rfind(|pou| pou.kind == kind)
}

/// Returns the function block or function of a name, or the one to call where none is named.
fn called<'t, 's>(unit: &'t SourceUnit<'s>, named: Option<&str>) -> anyhow::Result<&'t Pou<'s>> {
    let Some(name) = named else {
        let called = last(unit, PouKind::FunctionBlock).or_else(|| last(unit, PouKind::Function));
        return called.context("the file has no program, function block or function that could be called");
    };
    let is_called = |pou: &&Pou<'_>| matches!(pou.kind, PouKind::Function | PouKind::FunctionBlock);
    let callable: Vec<&Pou<'_>> = unit.pous().filter(is_called).collect();
    let found = callable.iter().find(|pou| pou.name.is(name)).copied();
    found.with_context(|| {
        let names = join(callable.iter().map(|pou| pou.name.text), ", ");
        format!("there is no function block or function `{name}`; there are: {names}")
    })
}

fn caller_of_block(text: &str, block: &Pou<'_>) -> String {
    let mut variables = format!("    {INSTANCE} : {};\n", block.name.text);
    let mut arguments = Vec::new();
    for (name, group) in parameters(block, VariableKind::InOut) {
        declare(text, name, group, &mut variables);
        arguments.push(format!("{name} := {name}"));
    }
    program(&variables, &format!("{INSTANCE}({});", arguments.join(", ")))
}

fn caller_of_function(text: &str, function: &Pou<'_>) -> String {
    let mut variables = String::new();
    let mut arguments = Vec::new();
    let kinds = [
        (VariableKind::Input, ":="),
        (VariableKind::InOut, ":="),
        (VariableKind::Output, "=>"),
    ];
    for (kind, arrow) in kinds {
        for (name, group) in parameters(function, kind) {
            declare(text, name, group, &mut variables);
            arguments.push(format!("{name} {arrow} {name}"));
        }
    }
    let call = format!("{}({});", function.name.text, arguments.join(", "));
    match &function.result {
        None => program(&variables, &call),
        Some(result) => {
            variables.push_str(&format!("    {RESULT} : {};\n", result.span.text(text)));
            program(&variables, &format!("{RESULT} := {call}"))
        }
    }
}

fn parameters<'t, 's>(
    pou: &'t Pou<'s>,
    kind: VariableKind,
) -> impl Iterator<Item = (&'s str, &'t VariableGroup<'s>)> {
    let blocks = pou.blocks.iter().filter(move |block| block.kind == kind);
    let groups = blocks.flat_map(|block| &block.groups);
    groups.flat_map(|group| group.names.iter().map(move |name| (name.text, group)))
}

/// Writes the declaration of a variable of the type, and with the initial value, of a parameter.
fn declare(text: &str, name: &str, group: &VariableGroup<'_>, into: &mut String) {
    let ty = group.specification.span.text(text);
    into.push_str(&match &group.initializer {
        Some(initial) => format!("    {name} : {ty} := {};\n", initial.span.text(text)),
        None => format!("    {name} : {ty};\n"),
    });
}

fn program(variables: &str, call: &str) -> String {
    format!("PROGRAM {CALLER}\nVAR\n{variables}END_VAR\n    {call}\nEND_PROGRAM\n")
}
