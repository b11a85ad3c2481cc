//! The title of a cause: what the engine does, in the words of the field, and the line of the program that shows it.

use crate::assignments::{computation, declaration, declares, last_statement};
use crate::literals::line_with_number;
use crate::operations::{LOOPS, operations_of};
use crate::reduction::Smallest;
use crate::shape::{in_declarations, is_fixed};
use crate::tokens::{ProgramToken, ProgramTokenKind, parsed, tokens};
use stickler_run::{Fact, Symptom};
use stickler_syntax::names::{DeclaredName, declared};
use stickler_syntax::tree::TypeSpecificationKind;
use stickler_types::{Code, Diagnostic, ElementaryType};

/// The maximum number of characters that are shown of a line, a message or a value.
const MAX_LENGTH: usize = 90;
/// The maximum number of variables whose types are named.
const MAX_TYPES: usize = 3;

/// Returns the title of a cause, by the smallest program that shows it. Stickler's own codes, which an adapter gives to the
/// diagnostics of an engine without codes, are left out; codes of the engine's own stay.
pub(crate) fn title(smallest: &Smallest, has_codes: bool) -> String {
    let Smallest {
        program, deviation, ..
    } = smallest;
    let (expected, got) = (&deviation.expected[..], &deviation.got[..]);
    let line = |number: Option<u32>| {
        let line = number.and_then(|number| program.lines().nth(number.checked_sub(1)? as usize));
        let is_told = |line: &&str| !line.trim_matches([' ', '\t', ';']).is_empty();
        let is_empty = || statements(program).is_empty();
        match line.filter(|line| is_told(line) || line.trim() == ";" && is_empty()) {
            Some(line) => described(program, line),
            None => described(program, culprit(program)),
        }
    };
    let first = |facts: &[Fact]| {
        let first = facts.iter().find_map(Fact::diagnostic);
        first.cloned().unwrap_or_default()
    };
    let (wanted, mut reported) = (first(expected), first(got));
    if !has_codes && reported.registered_code().is_some() {
        reported.code = None;
    }
    // A compiler that has lost the place says line 1.
    reported.line = reported.line.filter(|line| *line > 1);
    match &deviation.sign.symptom {
        Symptom::NotRejected(code) => {
            let line = line(wanted.line);
            match summary(code) {
                // What is wrong there stands nowhere on the line.
                Some(wrong) => {
                    let code = wanted.code.map(|code| format!(" ({code})")).unwrap_or_default();
                    format!("{line} is accepted, though {wrong}{code}")
                }
                None => format!("{line} is accepted, not rejected"),
            }
        }
        Symptom::Rejected(_) => {
            let place = reported
                .line
                .or_else(|| line_with_number(program, &reported.message));
            format!("{} is rejected: {}", line(place), said(&reported))
        }
        Symptom::NotImplemented(_) => {
            let line = unimplemented(program, got);
            let unit = unit_of(program, line).map_or(String::new(), |unit| format!(" in {unit}"));
            format!(
                "{}{unit} is {}",
                described(program, line),
                clipped(&Fact::text(got))
            )
        }
        Symptom::OtherCode { code, .. } => {
            let wrong = summary(code).unwrap_or("of the mistake");
            format!(
                "{} is rejected, but not because {wrong} ({code}): {}",
                line(wanted.line),
                said(&reported)
            )
        }
        Symptom::NoPlace(_) => {
            let (line, reported) = (line(wanted.line), said(&reported));
            format!("{line} is rejected without the place of the mistake: {reported}")
        }
        Symptom::OtherLine(_) => {
            format!(
                "{}: {} is reported on another line",
                line(wanted.line),
                named(&wanted)
            )
        }
        Symptom::Incomplete(code) => {
            let missing = missing(code, expected, got);
            format!(
                "{}: {} is not reported beside other mistakes",
                line(missing.line),
                named(&missing)
            )
        }
        Symptom::Surplus(_) => {
            let extra = got
                .iter()
                .find(|fact| !expected.contains(fact) && fact.diagnostic().is_some());
            let extra = extra.and_then(Fact::diagnostic).cloned().unwrap_or_default();
            let is_repeated = extra.line.is_none() && extra.code.is_some() && extra.code == wanted.code;
            if is_repeated {
                let line = line(wanted.line);
                return format!(
                    "{line}: {} is reported once more, without a place",
                    named(&wanted)
                );
            }
            format!(
                "{} is reported although nothing is wrong there: {}",
                line(extra.line),
                said(&extra)
            )
        }
        Symptom::Value | Symptom::Missing => wrong_value(program, expected, got),
        Symptom::NotWarned(_) => {
            let missing = warning(expected, got);
            let wrong = missing.code.as_deref().and_then(summary);
            let wrong = wrong.map(|wrong| format!(" that {wrong}")).unwrap_or_default();
            format!("{} is accepted without a warning{wrong}", line(missing.line))
        }
        Symptom::Warned(_) => {
            let extra = warning(got, expected);
            format!(
                "{} is accepted with a warning: {}",
                line(extra.line),
                said(&extra)
            )
        }
        Symptom::Crash(words) => format!("{} makes it crash: {}", line(None), clipped(words)),
        Symptom::Unusable(words) => format!("{} is accepted, but {}", line(None), clipped(words)),
        Symptom::Hang => {
            let is_loop = |line: &&str| {
                LOOPS
                    .iter()
                    .any(|word| tokens(line).iter().any(|token| token.is(word)))
            };
            let line = program.lines().find(is_loop).unwrap_or_else(|| culprit(program));
            format!("{}: no answer in time", described(program, line))
        }
        Symptom::Error(words) => format!("its answer makes no sense: {}", clipped(words)),
        Symptom::Fault(fault) => format!("{} stops with the fault {fault}", line(None)),
        Symptom::FaultLine(fault) => format!("the fault {fault} is reported without its line"),
        Symptom::NotFaulted(fault) => format!("{} does not stop with the fault {fault}", line(None)),
        Symptom::Text => match deviation.sign.at.as_str() {
            "blanks" => "a rendered program has other blanks".to_owned(),
            _ => rendered(expected, got),
        },
    }
}

/// Returns the first warning of `these` that the others do not have.
fn warning(these: &[Fact], others: &[Fact]) -> Diagnostic {
    let unmet = these.iter().find_map(|fact| match fact {
        Fact::Warning(warning) if !others.contains(fact) => Some(warning.clone()),
        _ => None,
    });
    unmet.unwrap_or_default()
}

/// Returns the first expected value that did not come, with the statement that computes it.
fn wrong_value(program: &str, expected: &[Fact], got: &[Fact]) -> String {
    for (wanted, reported) in expected.iter().zip(got) {
        let Fact::Value { name, value } = wanted else {
            continue;
        };
        if wanted == reported {
            continue;
        }
        let value = clipped(&value.to_string());
        return match (reported, computation(program, name)) {
            (Fact::Value { value: other, .. }, Some(line)) => match condition(program, line) {
                Some(condition) => format!(
                    "{}: {name} is {other}, not {value}",
                    described(program, condition)
                ),
                None => format!("{} gives {other}, not {value}", described(program, line)),
            },
            (Fact::Value { value: other, .. }, None) => {
                format!(
                    "{}: {name} is {other}, not {value}",
                    described(program, declaration(program, name))
                )
            }
            _ => format!(
                "the value of {name} cannot be seen: {}",
                described(program, declaration(program, name))
            ),
        };
    }
    described(program, last_statement(program)) + " computes another value"
}

/// Returns the line of the condition that decides whether a line assigns a literal, where it does more than name a variable.
fn condition<'p>(program: &'p str, line: &str) -> Option<&'p str> {
    let assigned = tokens(line);
    let is_literal = matches!(&assigned[..], [_, sign, value, _] if sign.text == ":="
        && (!matches!(value.kind, ProgramTokenKind::Word | ProgramTokenKind::Sign) || value.is("TRUE") || value.is("FALSE")));
    let before = program.lines().take_while(|one| one.as_ptr() < line.as_ptr());
    let decides = |one: &&str| {
        let first = tokens(one)
            .first()
            .is_some_and(|first| ["IF", "ELSIF", "CASE", "WHILE"].iter().any(|word| first.is(word)));
        first && operations_of(one).len() > 1
    };
    before.filter(|_| is_literal).filter(decides).last()
}

fn rendered(expected: &[Fact], got: &[Fact]) -> String {
    let rejected = got.iter().find_map(|fact| match fact {
        Fact::NotRendered {
            again: true,
            rejection,
        } => Some(rejection.as_deref().unwrap_or("no text")),
        _ => None,
    });
    if let Some(message) = rejected {
        let message = clipped(message);
        return format!("what it renders is rejected when that is rendered again: {message}");
    }
    let (expected, got) = (Fact::text(expected), Fact::text(got));
    let mut pairs = expected.lines().zip(got.lines());
    match pairs.find(|(wanted, reported)| wanted != reported) {
        Some((wanted, reported)) => format!("`{}` is rendered as `{}`", clipped(wanted), clipped(reported)),
        None => "a rendered program has other lines".to_owned(),
    }
}

/// Returns the expected diagnostic with this code that did not come; where codes are not compared, the first on whose line
/// nothing came.
fn missing(code: &str, expected: &[Fact], got: &[Fact]) -> Diagnostic {
    let reported = |line| {
        got.iter()
            .filter_map(Fact::diagnostic)
            .any(|reported| reported.line == line)
    };
    let is_missing = |one: &&Diagnostic| match &one.code {
        Some(one) => one == code,
        None => !reported(one.line),
    };
    let found = expected.iter().filter_map(Fact::diagnostic).find(is_missing);
    found.cloned().unwrap_or_default()
}

/// Returns what a code of the registry says is wrong; `None` for another code.
fn summary(code: &str) -> Option<&'static str> {
    Some(code.parse::<Code>().ok()?.summary())
}

/// Returns what an expected diagnostic says is wrong, with its code; nothing certain where codes are not compared.
fn named(wanted: &Diagnostic) -> String {
    let code = wanted.code.as_deref();
    match code.and_then(|code| Some((code, summary(code)?))) {
        Some((code, wrong)) => format!("that {wrong} ({code})"),
        None => code.unwrap_or("the mistake").to_owned(),
    }
}

/// Returns the code and the message of a diagnostic.
fn said(reported: &Diagnostic) -> String {
    let parts = [reported.code.as_deref().unwrap_or_default(), &reported.message];
    let parts: Vec<&str> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    match parts.is_empty() {
        true => "no reason is given".to_owned(),
        false => clipped(&parts.join(" ")),
    }
}

/// Returns a text of one line and no more than a title has room for.
fn clipped(text: &str) -> String {
    let line = text.lines().next().unwrap_or_default().trim();
    match line.char_indices().nth(MAX_LENGTH) {
        Some((end, _)) => format!("{}…", &line[..end]),
        None => line.to_owned(),
    }
}

/// Returns a line of a program in code quotes, with the types of its variables where these stand elsewhere.
fn described(program: &str, line: &str) -> String {
    // A reduced program may have its end on the line of a statement.
    let code = line.split_once(";END_").map_or(line, |(code, _)| code);
    let code = match code.trim().trim_end_matches(';').trim_end() {
        "" => code.trim(),
        code => code,
    };
    let unit = parsed(program);
    let names = declared(&unit);
    let mut types = Vec::new();
    for token in tokens(code).iter().filter(|token| !declares(code, token.text)) {
        let is_it = |one: &&DeclaredName<'_, '_>| token.is(one.name.text) && one.group.is_some();
        let entry = names.iter().find(is_it).and_then(|one| declared_as(program, one));
        if let Some(entry) = entry
            && types.len() < MAX_TYPES
            && !types.contains(&entry)
        {
            types.push(entry);
        }
    }
    let section = section_of(program, line);
    let section = section
        .map(|section| format!(" in {section}"))
        .unwrap_or_default();
    match types.is_empty() {
        true => format!("`{}`{section}", clipped(code)),
        false => format!("`{}`{section} ({})", clipped(code), types.join(", ")),
    }
}

/// Returns the section of variables that a line of a program stands in, unless that is the plain one or that of the inputs.
fn section_of<'p>(program: &'p str, line: &str) -> Option<&'p str> {
    let before = program.lines().take_while(|one| one.trim() != line.trim());
    let heads = before
        .map(str::trim_start)
        .filter(|one| one.starts_with("VAR") || one.starts_with("END_VAR"));
    let head = heads.last()?.split_whitespace().next()?;
    let is_there = program.lines().any(|one| one.trim() == line.trim());
    (is_there && !matches!(head, "VAR" | "VAR_INPUT" | "END_VAR")).then_some(head)
}

/// Returns a name with the location, the type and the initial value with which a program declares it, as they are written; of what is
/// no plain variable the type alone, and nothing of a structure.
fn declared_as(program: &str, declared: &DeclaredName<'_, '_>) -> Option<String> {
    let group = declared.group?;
    let ty = group.specification.span.text(program);
    let value = match &group.specification.kind {
        TypeSpecificationKind::Structure(_) | TypeSpecificationKind::Error => return None,
        TypeSpecificationKind::Named(_) => group.initializer.as_ref(),
        _ => None,
    };
    let value = value.map_or(String::new(), |value| format!(" := {}", value.span.text(program)));
    let location = group
        .location
        .map_or(String::new(), |place| format!(" AT {}", place.text));
    let ty = clipped(&format!("{ty}{value}"));
    (!ty.is_empty()).then(|| format!("{}{location} : {ty}", declared.name.text))
}

/// Returns the kind of unit that a line of a program stands in, unless that is a PROGRAM.
pub(crate) fn unit_of(program: &str, line: &str) -> Option<&'static str> {
    let behind = &program[line.as_ptr() as usize - program.as_ptr() as usize..];
    let ends = [
        ("END_PROGRAM", None),
        ("END_FUNCTION", Some("a FUNCTION")),
        ("END_FUNCTION_BLOCK", Some("a FUNCTION_BLOCK")),
    ];
    let all = tokens(behind);
    all.iter()
        .find_map(|token| ends.iter().find(|(end, _)| token.is(end)))?
        .1
}

/// Returns the line of a small program that most probably matters, where the engine names none: the last of those with most to
/// them, since a plain assignment may be there only because a program needs a statement; before a plain assignment a declaration in a
/// section that not every program has.
fn culprit(program: &str) -> &str {
    let weighed = |line: &&str| match weight(line) {
        1 if section_of(program, line).is_some() => 3,
        1 | 2 => weight(line),
        most => most + 1,
    };
    let heaviest = program
        .lines()
        .filter(|line| weight(line) > 0)
        .max_by_key(weighed);
    heaviest.unwrap_or_else(|| last_statement(program))
}

/// Returns the line of a small program that an engine does not implement, by what it says: a statement with a variable that the
/// message quotes, best with a part of it, or else the first of the statements with most to them, since calls of a body stand behind it.
pub(crate) fn unimplemented<'p>(program: &'p str, got: &[Fact]) -> &'p str {
    let statements = statements(program);
    let message = got.iter().find_map(|fact| match fact {
        Fact::NotImplemented { reason, .. } => Some(reason.as_str()),
        _ => None,
    });
    let quoted = message.unwrap_or_default().split('\'').skip(1).step_by(2);
    for name in quoted {
        let has_part = |line: &&str| {
            let tokens = tokens(line);
            let mut pairs = tokens.windows(2);
            pairs.any(|pair| pair[0].is(name) && matches!(pair[1].text, "." | "["))
        };
        let has_name = |line: &&str| tokens(line).iter().any(|token| token.is(name));
        let mut found = statements.iter().copied();
        if let Some(line) = found.clone().find(has_part).or_else(|| found.find(has_name)) {
            return line;
        }
    }
    // A part of a variable or a call may be missing rather than a condition.
    let named = |line: &str| {
        let has_more = tokens(line)
            .iter()
            .any(|token| matches!(token.text, "[" | "(" | "."));
        (has_more, weight(line))
    };
    let most = statements.iter().map(|line| named(line)).max();
    let first = statements.into_iter().find(|line| Some(named(line)) == most);
    first.unwrap_or_else(|| culprit(program))
}

/// Returns the lines of statements of a program that are no frame.
fn statements(program: &str) -> Vec<&str> {
    let all = tokens(program);
    let declared = in_declarations(&all);
    let is_declared = |number: u32| {
        let mut places = all.iter().zip(&declared);
        places.any(|(token, declared)| token.line == number && *declared)
    };
    let lines = program.lines().zip(1..);
    let statements = lines.filter(|(line, number)| weight(line) > 0 && !is_declared(*number));
    statements.map(|(line, _)| line).collect()
}

/// Returns how much there is to a line: nothing to a frame, little to a plain assignment.
fn weight(line: &str) -> u8 {
    let tokens = tokens(line);
    let first = tokens
        .first()
        .map(|first| first.text.to_ascii_uppercase())
        .unwrap_or_default();
    let is_frame = is_fixed(&first)
        && ![
            "IF", "ELSIF", "CASE", "FOR", "WHILE", "REPEAT", "UNTIL", "RETURN", "EXIT",
        ]
        .contains(&first.as_str());
    if tokens.iter().all(|token| token.text == ";") || is_frame {
        return 0;
    }
    let is_plain =
        |token: &ProgramToken<'_>| matches!(token.text, ":=" | ":" | "," | ";") || is_simple(token);
    match tokens.iter().all(is_plain) {
        true if tokens.iter().any(|token| token.text == ":=") => 2,
        true => 1,
        false => 3,
    }
}

/// Returns whether a token is a name, an elementary type, a truth value, or a plain number.
fn is_simple(token: &ProgramToken<'_>) -> bool {
    match token.kind {
        ProgramTokenKind::Word => {
            !is_fixed(token.text)
                || token.is("TRUE")
                || token.is("FALSE")
                || ElementaryType::from_name(&token.text.to_ascii_uppercase()).is_some()
        }
        ProgramTokenKind::Number => token.text.bytes().all(|byte| byte.is_ascii_digit()),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PROGRAM: &str = "FUNCTION f : INT\nVAR_INPUT n : INT; END_VAR\nf := n;\nEND_FUNCTION\nPROGRAM main\nVAR a, b : REAL; c : ARRAY[1..2] OF INT := [1, 2]; END_VAR\na := b + f(c[1]);\nEND_PROGRAM\n";

    #[test]
    fn a_line_is_shown_with_the_types_of_its_variables() {
        assert_eq!(
            described(PROGRAM, "    a := b + f(c[1]);"),
            "`a := b + f(c[1])` (a : REAL, b : REAL, c : ARRAY[1..2] OF INT)"
        );
        let located = PROGRAM.replace("a, b : REAL;", "a AT %QD1 : REAL; b : REAL;");
        assert_eq!(
            described(&located, "a := b;"),
            "`a := b` (a AT %QD1 : REAL, b : REAL)"
        );
        assert_eq!(
            described(PROGRAM, "x : LREAL := 1.0E300;"),
            "`x : LREAL := 1.0E300`"
        );
    }

    #[test]
    fn what_is_not_implemented_is_the_statement_that_the_message_is_about() {
        let program = "FUNCTION_BLOCK b\nVAR\n    list : ARRAY[0..1] OF INT;\nEND_VAR\n    IF FALSE THEN\n        list[0] := 0;\n    \
                       END_IF;\nEND_FUNCTION_BLOCK\nPROGRAM p\nVAR\n    fb : b;\n    x : INT;\nEND_VAR\n    fb();\n    x := fb.v;\nEND_PROGRAM\n";
        let of = |reason: &str| {
            let reason = reason.to_owned();
            let got = [Fact::NotImplemented {
                reason,
                promised_by: None,
            }];
            unimplemented(program, &got).trim().to_owned()
        };
        assert_eq!(of("Variable 'list' is not a structure"), "list[0] := 0;");
        assert_eq!(of("Variable 'fb' is not a structure"), "x := fb.v;");
        assert_eq!(of("Not implemented at a.rs#L7"), "list[0] := 0;");
        let got = [Fact::NotImplemented {
            reason: "Variable 'fb' is not a structure".to_owned(),
            promised_by: None,
        }];
        let until = program.replace(
            "x := fb.v;",
            "REPEAT\n        EXIT;\n    UNTIL fb.v\n    END_REPEAT;",
        );
        assert_eq!(unimplemented(&until, &got).trim(), "UNTIL fb.v");
    }

    #[test]
    fn a_semicolon_is_at_fault_where_no_other_statement_is() {
        let of = |statement: &str| {
            let program = format!("PROGRAM p\nVAR\nx : INT;\nEND_VAR\n{statement};\nEND_PROGRAM\n");
            title(&Smallest::rejected(&program, 5, "E1"), true)
        };
        assert_eq!(of(""), "`;` is rejected: E1 no");
        let beside = "PROGRAM p\nVAR\nx : INT;\nEND_VAR\n;\nx := 0;\nEND_PROGRAM\n";
        let title = title(&Smallest::rejected(beside, 5, "E1"), true);
        assert!(title.starts_with("`x := 0`"), "{title}");
    }

    #[test]
    fn a_literal_that_is_assigned_under_a_condition_is_told_by_the_condition() {
        let program = "x := 1;\nIF NOT (x < 2) THEN\n    x := 0;\nEND_IF;\n";
        let line = |number: usize| program.lines().nth(number).unwrap_or_default();
        assert_eq!(condition(program, line(2)), Some(line(1)));
        assert_eq!(condition(program, line(0)), None);
        let plain = program.replace("NOT (x < 2)", "b");
        assert_eq!(condition(&plain, plain.lines().nth(2).unwrap_or_default()), None);
    }

    #[test]
    fn a_declaration_of_a_special_section_is_at_fault_before_a_plain_assignment() {
        let program = "FUNCTION f : BOOL\nVAR_IN_OUT\nt : DATE;\nEND_VAR\nf := TRUE;\nEND_FUNCTION\n";
        assert_eq!(culprit(program), "t : DATE;");
        assert_eq!(culprit(&program.replace("VAR_IN_OUT", "VAR_INPUT")), "f := TRUE;");
        assert_eq!(culprit(&program.replace("TRUE", "g(t)")), "f := g(t);");
    }

    #[test]
    fn a_line_with_a_number_of_the_message_is_the_one_that_it_is_about() {
        let program = "VAR\n    row : ARRAY[-127..7] OF SINT;\nEND_VAR\n    f();\n";
        assert_eq!(line_with_number(program, "minimum=-127"), Some(2));
        assert_eq!(line_with_number(program, "P2002 and 7"), None);
    }
}
