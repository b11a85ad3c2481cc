//! The title of a value that is wrong: the line that computes it, or the one that decides it.

use super::Titled;
use crate::lines::{clipped, described};
use crate::malformed::number_of_literal;
use crate::patterns::is_no_moment;
use crate::program::{Part, ReadProgram};
use crate::words::{LOOPS, has_word, tokens, words};
use crate::work::operations;
use stickler_run::Fact;
use stickler_syntax::token::TokenKind;
use stickler_syntax::visitor::Place;

impl Titled<'_, '_> {
    /// Returns the first expected value that did not come, with the statement that computes it.
    pub(super) fn wrong_value(&self) -> String {
        let configured = self
            .program
            .unit
            .configurations()
            .next()
            .map(|_| " under a CONFIGURATION");
        let described =
            |line: u32| described(&self.program, line) + &self.unit(line) + configured.unwrap_or_default();
        let pairs = self
            .expected
            .iter()
            .zip(self.got)
            .filter(|(wanted, reported)| wanted != reported);
        let mut values = pairs.filter_map(|(wanted, reported)| match wanted {
            Fact::Value { name, value } => Some((name, clipped(&value.to_string()), reported)),
            _ => None,
        });
        let Some((name, value, reported)) = values.next() else {
            return described(self.program.last_statement()) + " computes another value";
        };
        let declared = self.program.declaration(name);
        let Fact::Value { value: other, .. } = reported else {
            return format!("the value of {name} cannot be seen: {}", described(declared));
        };
        // A count that no date or time of day of the type has says nothing to a reader.
        let other = match is_no_moment(other) {
            true => format!("no {}", other.type_name()),
            false => clipped(&other.to_string()),
        };
        let computed = self.program.computation(name);
        // A line that only copies a value, or counts, is not at fault where a loop decides how often it does.
        let loops = |line: u32| {
            let code = self.program.line_text(line).unwrap_or_default();
            let begins = LOOPS.iter().any(|word| code.trim_start().starts_with(word));
            let around = self.program.loop_around(line);
            let counts = code
                .split_once(":=")
                .is_some_and(|(target, value)| has_word(value, target.trim()));
            let copies = operations(&format!("PROGRAM p {code} END_PROGRAM")).is_empty();
            let around = around.filter(|_| copies || counts);
            match begins {
                true => Some(line),
                false => around.or_else(|| self.program.loop_in_callee(line)),
            }
        };
        // An output that a line copies is computed by the call of its instance.
        let call = computed.and_then(|line| call_of_copied(&self.program, line));
        let name = call.map_or(name.as_str(), |(_, output)| output);
        let decides = computed.map_or(Some(declared), |line| {
            let call = call.map(|(line, _)| line);
            call.or_else(|| condition(&self.program, line))
                .or_else(|| loops(line))
        });
        match (decides, computed) {
            // A line computes the value: the title tells what it gives, if it names what has the value.
            (None, Some(line)) if !self.assigns_another(line, name) => {
                let later = self.changed_later(line);
                let later = later.map_or(String::new(), |code| format!(", and then `{}`,", clipped(code)));
                format!("{}{later} gives {other}, not {value}", described(line))
            }
            // A condition decides the value, or nothing computes it: the title tells that line, and names the variable.
            (line, computed) => {
                let guarded = computed.filter(|at| line.is_some() && condition(&self.program, *at) == line);
                let guarded = guarded.and_then(|at| self.statement_on(at));
                let around = guarded.map_or(String::new(), |code| {
                    let (_, assigned) = code.split_once(":=").unwrap_or_default();
                    let assigned = number_of_literal(assigned);
                    let is = |value: &str| assigned.is_some() && number_of_literal(value) == assigned;
                    let outcome = match (is(&other), is(&value)) {
                        (true, false) => " is taken",
                        (false, true) => " is not taken",
                        _ => "",
                    };
                    format!(" around `{}`{outcome}", clipped(code))
                });
                let told = described(line.or(computed).unwrap_or(declared));
                // An initial value is seen at an output, whatever loses it.
                let told = told.replace(" in VAR_OUTPUT in a FUNCTION_BLOCK", " in a FUNCTION_BLOCK");
                format!("{told}{around}: {name} is {other}, not {value}")
            }
        }
    }

    /// Returns the statement that a line is.
    pub(super) fn statement_on(&self, line: u32) -> Option<&str> {
        Some(self.program.line_text(line)?.trim().trim_end_matches(';'))
    }

    /// Returns the first statement behind a line that changes what the line reads.
    fn changed_later(&self, line: u32) -> Option<&str> {
        let (_, value) = self.statement_on(line)?.split_once(":=")?;
        let place = |part: &Part<'_, '_>| self.program.line(part.expression.span);
        let changes = |part: &&Part<'_, '_>| {
            self.program.outermost(part).place == Place::Target
                && part.name().is_some_and(|name| has_word(value, name))
        };
        let mut behind = self.program.parts.iter().filter(|part| place(part) > line);
        self.statement_on(place(behind.find(changes)?))
    }

    /// Returns whether a line assigns an element by a subscript that is no number, and another variable than this is at fault.
    fn assigns_another(&self, line: u32, name: &str) -> bool {
        let code = self.program.line_text(line).unwrap_or_default();
        let target = code.split_once(":=").map_or("", |(target, _)| target.trim());
        let subscript = target
            .split_once('[')
            .and_then(|(_, rest)| rest.split(']').next());
        let is_number = |subscript: &str| subscript.trim().parse::<i64>().is_ok();
        let is_computed = subscript.is_some_and(|subscript| !subscript.split(',').all(is_number));
        is_computed && !target.eq_ignore_ascii_case(name)
    }
}

/// Returns the last line that calls an instance before another line copies an output of it, with that output.
fn call_of_copied<'s>(program: &ReadProgram<'_, 's>, line: u32) -> Option<(u32, &'s str)> {
    let (_, output) = program.line_text(line)?.split_once(":=")?;
    let output = output.trim().trim_end_matches(';');
    let [instance, ".", _] = words(output)[..] else {
        return None;
    };
    let calls =
        |text: &str| matches!(words(text)[..], [name, "(", ..] if name.eq_ignore_ascii_case(instance));
    let before = program.text.lines().zip(1..line);
    let call = before.filter(|(text, _)| calls(text)).last()?;
    Some((call.1, output))
}

/// Returns the line of the condition that decides whether a line assigns a literal, where it does more than name a variable.
pub(crate) fn condition(program: &ReadProgram<'_, '_>, line: u32) -> Option<u32> {
    let text = program.text;
    let all = tokens(program.line_text(line)?);
    let is_literal =
        matches!(&all[..], [_, sign, value, _] if sign.kind == TokenKind::Assign && value.kind.is_literal());
    // The statement itself is one operation; a second one is what the condition computes.
    let decides = |(line, _): &(&str, u32)| {
        let first = tokens(line).first().map(|first| first.kind);
        matches!(
            first,
            Some(TokenKind::If | TokenKind::Elsif | TokenKind::Case | TokenKind::While)
        ) && operations(&format!("PROGRAM p {line} END_PROGRAM")).len() > 1
    };
    let before = text.lines().zip(1..line);
    before
        .filter(|_| is_literal)
        .filter(decides)
        .last()
        .map(|(_, number)| number)
}
