//! `stickler engine`: serves an engine over the wire protocol; with `--validate`, checks whether an adapter follows the protocol.

use crate::arguments::EngineArguments;
use crate::exit::Exit;
use crate::output::{BAD, BOLD};
use crate::{engines, interrupt, shell};
use anyhow::Context;
use std::env;
use std::io::{self, Write};
use stickler_configuration::{ConfigurationFile, EngineKind};
use stickler_engines::{Check, CheckVerdict, ProcessLimits, Validation, protocol};
use stickler_types::{join, shortened};

/// Answers requests on stdin until `bye` or its end, or validates an adapter by the requests of the smoke set.
///
/// # Errors
/// A stdin or stdout that fails; an adapter that cannot be started.
pub fn execute(arguments: &EngineArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    if !arguments.validate.is_empty() {
        return validate(&arguments.validate, out);
    }
    interrupt::at_once()?;
    let engine = engines::by_name(arguments.engine.as_deref().unwrap_or(engines::REFERENCE))?;
    // The server flushes each reply, so it gets the stream itself and not the buffered one.
    protocol::serve(engine.as_ref(), io::stdin().lock(), io::stdout().lock())
        .context("the conversation broke off")?;
    Ok(Exit::AsExpected)
}

fn validate(words: &[String], out: &mut dyn Write) -> anyhow::Result<Exit> {
    interrupt::at_once()?;
    let configuration = engines::configuration()?;
    let (folder, line) = match words {
        [name] if engines::names(&configuration).contains(&name.as_str()) => {
            match configuration.engine(name).map(|entry| &entry.kind) {
                Some(EngineKind::Command { line, .. }) => (configuration.folder(), line.clone()),
                // An engine that is no process of its own is served by this program.
                _ => (None, served(name, &configuration)?),
            }
        }
        _ => (None, command_line(words)),
    };
    let validation = stickler_engines::validate(folder, &line, ProcessLimits::default());
    let validation = match words {
        [word] if !engines::names(&configuration).contains(&word.as_str()) => validation
            .with_context(|| format!("no engine is named `{word}`, so that it was taken for a command"))?,
        _ => validation?,
    };
    write_page(&validation, out)?;
    Ok(exit(&validation))
}

/// Returns the command line by which this program serves an engine.
fn served(name: &str, configuration: &ConfigurationFile) -> anyhow::Result<String> {
    let program = env::current_exe().context("this program does not know where it is")?;
    let mut words = vec![program.to_string_lossy().into_owned()];
    words.extend(["engine", "--engine", name].map(str::to_owned));
    if let Some(file) = configuration.path() {
        words.extend(["--config".to_owned(), file.to_string_lossy().into_owned()]);
    }
    Ok(command_line(&words))
}

/// Joins words into a command line that splits into the same words; one word alone is a command line already, as after `cmd:`.
fn command_line(words: &[String]) -> String {
    match words {
        [line] => line.strip_prefix(engines::COMMAND).unwrap_or(line).to_owned(),
        words => join(words.iter().map(|word| shell::quote(word)), " "),
    }
}

fn write_page(validation: &Validation, out: &mut dyn Write) -> io::Result<()> {
    let identity = &validation.identity;
    let abilities: Vec<String> = identity.abilities.iter().map(ToString::to_string).collect();
    writeln!(out, "{BOLD}{}{BOLD:#}  {}", identity.name, identity.version)?;
    writeln!(out, "  dialects    {}", engines::listed(&identity.dialects))?;
    writeln!(out, "  can         {}", abilities.join(", "))?;
    writeln!(out, "  grade       {}\n", identity.grade)?;
    for check in &validation.checks {
        write_check(check, out)?;
    }
    writeln!(out, "\n{}", conclusion(validation))
}

fn write_check(check: &Check, out: &mut dyn Write) -> io::Result<()> {
    match check.judgement {
        CheckVerdict::Right => writeln!(out, "  ok       {}", check.rule)?,
        CheckVerdict::Skipped => writeln!(out, "  skipped  {}", check.rule)?,
        CheckVerdict::Broken => writeln!(out, "  {BAD}BROKEN{BAD:#}   {}", check.rule)?,
        CheckVerdict::Wrong => writeln!(out, "  {BAD}WRONG{BAD:#}    {}", check.rule)?,
    }
    let problem = check.problem.iter().map(|problem| ("", problem));
    let notes = check.notes.iter().map(|note| ("note: ", note));
    for (label, words) in problem.chain(notes) {
        writeln!(out, "             {label}{words}")?;
    }
    if matches!(check.judgement, CheckVerdict::Broken | CheckVerdict::Wrong) {
        let lines = [("→", &check.sent), ("←", &check.received)];
        for (arrow, line) in lines {
            if let Some(line) = line {
                writeln!(out, "             {arrow} {}", excerpt(line))?;
            }
        }
    }
    Ok(())
}

/// The maximum number of characters of a line that are shown: enough to repeat most requests.
const MAX_LINE_LEN: usize = 2000;

fn excerpt(line: &str) -> String {
    // A control character of an adapter must not steer the terminal.
    let shown = line.replace(char::is_control, "");
    shortened(&shown, MAX_LINE_LEN)
}

/// Returns how many checks are right, broken, wrong and skipped.
fn counts(validation: &Validation) -> [usize; 4] {
    use CheckVerdict::{Broken, Right, Skipped, Wrong};
    [Right, Broken, Wrong, Skipped].map(|verdict| validation.count(verdict))
}

fn conclusion(validation: &Validation) -> String {
    let [right, broken, wrong, skipped] = counts(validation);
    let all = right + broken + wrong;
    let skipped = match skipped {
        0 => String::new(),
        number => format!("; skipped: {number}"),
    };
    match (broken, wrong) {
        (0, 0) => format!(
            "The adapter keeps to the protocol, and its compiler gives what it must: {right} of {all}{skipped}."
        ),
        (0, wrong) => format!(
            "The adapter keeps to the protocol. Its compiler is wrong in {wrong} of {all}, or the adapter reads it \
             wrongly{skipped}."
        ),
        (broken, _) => format!(
            "The adapter is broken: {broken} of {all} are against the protocol{skipped}. What it tells of its compiler \
             does not count before it is mended."
        ),
    }
}

fn exit(validation: &Validation) -> Exit {
    let [right, broken, wrong, _] = counts(validation);
    match (broken, wrong, right) {
        (1.., _, _) => Exit::EngineNotRun,
        (0, 1.., _) => Exit::Failures,
        (0, 0, 0) => Exit::NothingTested,
        (0, 0, _) => Exit::AsExpected,
    }
}

#[cfg(test)]
mod tests {
    use super::command_line;

    #[test]
    fn words_are_quoted_and_a_line_is_left_as_it_is() {
        let words = ["my adapter".to_owned(), "--quiet".to_owned()];
        assert_eq!(command_line(&words), "'my adapter' --quiet");
        for line in ["cmd:python3 adapter.py", "python3 adapter.py"] {
            assert_eq!(command_line(&[line.to_owned()]), "python3 adapter.py");
        }
    }
}
