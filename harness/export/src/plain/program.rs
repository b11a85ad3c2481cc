//! The file of a case that a person reads and any compiler runs: a comment with the claim and its source, the program, and
//! variables that become TRUE where it has the values that it must have.

use crate::page::{literal, shown};
use stickler_run::{Fact, breaks_reading, expected_facts};
use stickler_suite::{Acceptance, Case, ExpectedValue, Sources};
use stickler_syntax::token::TokenKind;
use stickler_syntax::tree::{Pou, PouKind};
use stickler_types::{Diagnostic, Dialect, ElementaryType, Value};

/// The start of the names of the variables that become TRUE.
pub(super) const CHECK: &str = "CHECK_";

/// Returns the text of the file of a case.
///
/// # Errors
/// The reason why the case has none.
pub(super) fn text(case: &Case, sources: &Sources) -> Result<String, &'static str> {
    let expectation = &*case.expectation;
    if case.is_open() {
        return Err("no source says what must come");
    }
    if expectation.rendered.is_some() {
        return Err("they ask for the program in normal form");
    }
    if !case.clock.is_empty() {
        return Err("time passes between scans as a program cannot say");
    }
    let program = case.source.trim_start();
    let program = match expectation.accepted {
        Acceptance::Rejected => marked(case),
        // What stands behind the statement that stops is never executed.
        _ if expectation.values.is_empty() || expectation.fault.is_some() => program.to_owned(),
        _ => checked(case)?,
    };
    let skipped = case.source.len() - case.source.trim_start().len();
    let skipped = case.source[..skipped].lines().count() as u32;
    let added = head(case, sources, (0, 0)).lines().count() as u32;
    let head = head(case, sources, (added, skipped));
    Ok(format!("{head}{}\n", program.trim_end()))
}

/// Returns the comment before the program, which has so many lines before it, and has lost so many of the case's.
fn head(case: &Case, sources: &Sources, (added, lost): (u32, u32)) -> String {
    let mut head = format!(
        "(* {}\n   case     {}@{}\n   source   {}",
        case.title, case.id, case.dialect, case.basis
    );
    if let Some((source, section)) = sources.of(&case.basis) {
        head.push_str(&format!(", {}", source.address_of(section)));
        if !source.speaks_for(section, case.dialect) {
            head.push_str("\n            (the document of another system, which binds none of this dialect)");
        }
    }
    let mut facts = expected_facts(case);
    for fact in &mut facts {
        if let Fact::Diagnostic(Diagnostic { line, .. })
        | Fact::Warning(Diagnostic { line, .. })
        | Fact::Fault { line, .. } = fact
        {
            *line = line.map(|line| (line + added).saturating_sub(lost));
        }
    }
    let facts = Fact::text(&facts);
    for (number, fact) in facts.lines().enumerate() {
        let word = if number == 0 { "expects" } else { "" };
        head.push_str(&format!("\n   {word:<8} {fact}"));
    }
    if case.scans > 1 {
        head.push_str(&format!("\n   scans    {}", case.scans));
    }
    let head = head.replacen("(* ", "", 1);
    format!("(* {} *)\n", shown(&head))
}

/// Returns a program that must be rejected, with a comment at the end of each line that an error names. A mistake in reading may be
/// one about comments, so then there are none.
fn marked(case: &Case) -> String {
    let diagnostics = &case.expectation.diagnostics;
    let is_readable = diagnostics.iter().all(|one| !breaks_reading(one.code));
    let skipped = case
        .source
        .lines()
        .take_while(|line| line.trim().is_empty())
        .count();
    let mut text = String::with_capacity(case.source.len());
    for (number, line) in (1..).zip(case.source.lines()).skip(skipped) {
        text.push_str(line);
        for one in diagnostics.iter().filter(|one| one.line == number && is_readable) {
            text.push_str(&format!(" (* error {} *)", one.code.as_str()));
        }
        text.push('\n');
    }
    text
}

/// Returns a program that must be accepted, with a variable for each value that becomes TRUE where the value is there.
fn checked(case: &Case) -> Result<String, &'static str> {
    let text = &*case.source;
    let (unit, _) = stickler_syntax::parse(text, Dialect::of(case.dialect));
    let mut programs = unit.pous().filter(|pou| pou.kind == PouKind::Program);
    let (Some(main), None) = (programs.next(), programs.next()) else {
        return Err("they have no program, or several");
    };
    let inside = main.span.start..main.span.end;
    let words = stickler_syntax::tokens(text, Dialect::of(case.dialect)).list;
    let mut words = words.iter().filter(|word| inside.contains(&word.span.start));
    if words.any(|word| word.kind == TokenKind::Return) {
        return Err("they may end before their last statement");
    }
    if text.to_ascii_uppercase().contains(CHECK) {
        return Err("they have names that begin with CHECK_");
    }
    let counts = case.scans > 1 || !case.set.is_empty();
    let mut declared = String::from("VAR\n");
    let mut after = String::new();
    if counts {
        declared.push_str(&format!("    {CHECK}scan : DINT;\n"));
    }
    for (number, value) in (1..).zip(&case.expectation.values) {
        let Some(condition) = condition(value) else {
            return Err("they expect -0.0, which no comparison tells from 0.0");
        };
        declared.push_str(&format!("    {CHECK}{number} : BOOL;\n"));
        let check = format!("{CHECK}{number} := {condition};");
        after.push_str(&match value.after {
            Some(scan) => format!("    IF {CHECK}scan = {scan} THEN {check} END_IF;\n"),
            None => format!("    {check}\n"),
        });
    }
    declared.push_str("END_VAR\n");
    let mut before = String::new();
    if counts {
        before.push_str(&format!("    {CHECK}scan := {CHECK}scan + 1;\n"));
    }
    for setting in case.set.iter() {
        let value = literal(&setting.value).ok_or("a value that is set has no literal")?;
        before.push_str(&format!(
            "    IF {CHECK}scan = {} THEN {} := {value}; END_IF;\n",
            setting.before, setting.name
        ));
    }
    let (statements, end) = (first_statement(main), main.end.start as usize);
    let start = text.len() - text.trim_start().len();
    let checked = format!(
        "{}\n{declared}{before}{}{after}{}",
        text[start..statements].trim_end(),
        indented(&text[statements..end]),
        &text[end..]
    );
    match stickler_reference::errors(&checked, case.dialect).is_empty() {
        true => Ok(checked),
        false => Err("their values cannot be compared inside of the program"),
    }
}

/// Returns the offset behind the declarations of a program.
fn first_statement(main: &Pou<'_>) -> usize {
    let sections = main.blocks.iter().map(|block| block.span.end);
    sections.max().unwrap_or(main.name.span.end) as usize
}

fn indented(statements: &str) -> String {
    let statements = statements.trim_matches(['\n', '\r', ';']).trim_end();
    match statements.trim().is_empty() {
        true => String::new(),
        false => format!(
            "{statements}{}\n",
            if statements.ends_with(';') { "" } else { ";" }
        ),
    }
}

/// Returns the condition that a variable has a value; `None` for -0.0.
fn condition(expected: &ExpectedValue) -> Option<String> {
    let ExpectedValue { name, value, .. } = expected;
    match value {
        Value::Plain { ty, .. } if ty.is_real() => {
            let number = value.real()?;
            if number == 0.0 && number.is_sign_negative() {
                return None;
            }
            let greatest = literal(&Value::of_real(
                *ty,
                match ty {
                    ElementaryType::Real => f32::MAX.into(),
                    _ => f64::MAX,
                },
            ))?;
            Some(match literal(value) {
                Some(literal) => format!("{name} = {literal}"),
                None if number.is_nan() => format!("NOT ({name} = {name})"),
                None if number > 0.0 => format!("{name} > {greatest}"),
                None => format!("{name} < -{greatest}"),
            })
        }
        // The raw forms of numbers of one sign are in the order of their amounts.
        Value::Near { ty, raw, units } => {
            let [one, other] = [raw - u64::from(*units), raw + u64::from(*units)];
            let ends = [one, other].map(|raw| literal(&Value::plain(*ty, raw)));
            let [one, other] = [ends[0].as_ref()?, ends[1].as_ref()?];
            let is_negative = raw >> (ty.bits() - 1) == 1;
            let (least, greatest) = if is_negative { (other, one) } else { (one, other) };
            Some(format!("({name} >= {least}) AND ({name} <= {greatest})"))
        }
        // A truth value needs no comparison, which not every dialect has of them.
        _ => match value.truth() {
            Some(true) => Some(name.to_string()),
            Some(false) => Some(format!("NOT {name}")),
            None => Some(format!("{name} = {}", literal(value)?)),
        },
    }
}
