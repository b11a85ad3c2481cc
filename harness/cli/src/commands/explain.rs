//! `stickler explain`: the registry of diagnostic codes.

use crate::arguments::ExplainArguments;
use crate::exit::Exit;
use crate::output::BOLD;
use anyhow::bail;
use std::io::{self, Write};
use stickler_types::{Code, wrap};

/// Explains one code, or lists all.
///
/// # Errors
/// An unknown code; the error names similar ones.
pub fn execute(arguments: &ExplainArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    match &arguments.code {
        None => list(out)?,
        Some(text) => match find(text) {
            Some(code) => explain(code, out)?,
            None => bail!("{}", unknown(text)),
        },
    }
    Ok(Exit::AsExpected)
}

fn list(out: &mut dyn Write) -> io::Result<()> {
    for code in Code::ALL {
        writeln!(out, "{BOLD}{code}{BOLD:#}  {}", code.summary())?;
    }
    Ok(())
}

/// Finds a code by its number or by its name, in any letter case.
fn find(text: &str) -> Option<Code> {
    text.parse().ok().or_else(|| {
        Code::ALL
            .iter()
            .copied()
            .find(|code| code.name().eq_ignore_ascii_case(text))
    })
}

fn explain(code: Code, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "{BOLD}{code} {}{BOLD:#}: {}", code.name(), code.summary())?;
    writeln!(out, "\n{}", wrap(code.explanation()))?;
    match code.example_dialect() {
        Some(dialect) => writeln!(out, "\n{BOLD}Example{BOLD:#} (in {dialect})\n")?,
        None => writeln!(
            out,
            "\n{BOLD}Example{BOLD:#} (other compilers give this code; the reference does not)\n"
        )?,
    }
    program(code.example(), out)?;
    writeln!(out, "\n{BOLD}Fix{BOLD:#}\n\n{}", wrap(code.fix()))?;
    if let Some(repaired) = code.repaired() {
        writeln!(out)?;
        program(repaired, out)?;
    }
    Ok(())
}

fn program(text: &str, out: &mut dyn Write) -> io::Result<()> {
    for line in text.lines() {
        match line {
            "" => writeln!(out)?,
            _ => writeln!(out, "    {line}")?,
        }
    }
    Ok(())
}

fn unknown(text: &str) -> String {
    let close = Code::ALL.iter().filter(|code| {
        let near = |name: &str| strsim::damerau_levenshtein(&name.to_lowercase(), &text.to_lowercase()) <= 1;
        near(code.as_str()) || near(code.name())
    });
    let close: Vec<&str> = close.map(|code| code.as_str()).take(5).collect();
    match close.is_empty() {
        true => format!("there is no code `{text}`; `stickler explain` lists all"),
        false => format!(
            "there is no code `{text}`; did you mean {}? `stickler explain` lists all",
            close.join(", ")
        ),
    }
}
