//! The program that calls a function block or function which is judged.

use anyhow::bail;
use std::fmt::Write;
use stickler_syntax::tree::{Pou, PouKind, SourceUnit, VariableGroup, VariableKind};
use stickler_types::Dialect;

/// The instance of the function block in the program that calls it.
const INSTANCE: &str = "stickler_block";

/// The result of the function in the program that calls it.
const RESULT: &str = "stickler_result";

/// A text with a program, and how a trace names its variables.
pub(super) struct Judged {
    /// The whole text.
    pub text: String,
    /// The paths that stand before the names of a trace, the first that fits first.
    pub prefixes: Vec<String>,
    /// The function whose result a trace calls by its name.
    pub function: Option<String>,
}

impl Judged {
    /// Returns the path of a variable that a trace names.
    pub(super) fn path<'n>(&self, name: &'n str) -> &'n str {
        let is_result = |function: &String| function.eq_ignore_ascii_case(name);
        match &self.function {
            Some(function) if is_result(function) => RESULT,
            _ => name,
        }
    }

    /// Returns the name by which a trace knows the variable of a path.
    pub(super) fn shown(&self, path: &str) -> String {
        let prefix = self
            .prefixes
            .iter()
            .find(|prefix| path.starts_with(prefix.as_str()));
        let name = &path[prefix.map_or(0, String::len)..];
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
    pub(super) fn of(text: &str, dialect: &Dialect, named: Option<&str>) -> anyhow::Result<Judged> {
        let (unit, _) = stickler_syntax::parse(text, dialect);
        let pous = || unit.pous();
        let last = |kind: PouKind| pous().rfind(|pou| pou.kind == kind);
        let called = match named {
            Some(name) => {
                let found = pous().find(|pou| pou.name.text.eq_ignore_ascii_case(name));
                let Some(found) = found.filter(|found| found.kind != PouKind::Program) else {
                    let called = pous().filter(|pou| pou.kind != PouKind::Program);
                    let names: Vec<&str> = called.map(|pou| pou.name.text).collect();
                    bail!(
                        "there is no function block or function `{name}`; there are: {}",
                        names.join(", ")
                    );
                };
                found
            }
            None if last(PouKind::Program).is_some() => {
                return Ok(Judged {
                    text: text.to_owned(),
                    prefixes: vec![String::new()],
                    function: None,
                });
            }
            None => match last(PouKind::FunctionBlock).or_else(|| last(PouKind::Function)) {
                Some(called) => called,
                None => bail!("the file has no program, function block or function that could be called"),
            },
        };
        let caller = match called.kind {
            PouKind::Function => caller_of_function(text, called),
            _ => caller_of_block(text, called),
        };
        let is_function = called.kind == PouKind::Function;
        Ok(Judged {
            text: format!("{}\n{caller}", without_programs(text, &unit)),
            prefixes: match is_function {
                true => vec![String::new()],
                false => vec![format!("{INSTANCE}."), String::new()],
            },
            function: is_function.then(|| called.name.text.to_owned()),
        })
    }
}

/// Returns a text whose programs are blanks, so that only the caller runs.
fn without_programs(text: &str, unit: &SourceUnit<'_>) -> String {
    let mut text = text.to_owned();
    for pou in unit.pous().filter(|pou| pou.kind == PouKind::Program) {
        let range = pou.span.start as usize..pou.span.end as usize;
        let blank: String = text[range.clone()]
            .chars()
            .flat_map(|letter| match letter {
                '\n' | '\r' => vec![letter],
                other => vec![' '; other.len_utf8()],
            })
            .collect();
        text.replace_range(range, &blank);
    }
    text
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
            let ty = &text[result.span.start as usize..result.span.end as usize];
            // Writing into a String does not fail.
            let _ = writeln!(variables, "    {RESULT} : {ty};");
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
    let part = |start: u32, end: u32| text.get(start as usize..end as usize).unwrap_or_default();
    let ty = part(group.specification.span.start, group.specification.span.end);
    let _ = match &group.initializer {
        Some(initial) => writeln!(
            into,
            "    {name} : {ty} := {};",
            part(initial.span.start, initial.span.end)
        ),
        None => writeln!(into, "    {name} : {ty};"),
    };
}

fn program(variables: &str, call: &str) -> String {
    format!("PROGRAM stickler_judge\nVAR\n{variables}END_VAR\n    {call}\nEND_PROGRAM\n")
}
