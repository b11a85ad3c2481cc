//! The lines of a small program that give a variable its value.

use crate::lines::{LinePlace, place_of};
use crate::program::{Part, ReadProgram, read};
use crate::question::Deviation;
use crate::words::tokens;
use stickler_run::Fact;
use stickler_syntax::names::{UseKind, used};
use stickler_syntax::source::Span;
use stickler_syntax::tree::{Argument, ExpressionKind, StatementKind, TypeSpecificationKind};
use stickler_syntax::visitor::Place;

/// The maximum number of variables through which a value is followed.
const MAX_COPIES: usize = 4;

impl<'t, 's> ReadProgram<'t, 's> {
    /// Returns the line that computes the value of a variable: behind those that only copy it from another variable of its type, the
    /// line that assigns that one. An output of a function block is computed from what the block is given last, and the result of a
    /// function by its body.
    pub(crate) fn computation(&self, path: &str) -> Option<u32> {
        // A block that is given nothing computes it by itself.
        let in_block = || {
            let (instance, member) = path.split_once('.')?;
            let assigned = self.assignment(member).filter(|_| self.is_instance(instance))?;
            (self.copied(&assigned) != Some(member)).then_some(assigned)
        };
        // What nothing assigns by its name may be assigned through a reference.
        let is_referenced = |part: &&Part<'t, 's>| {
            let outermost = self.outermost(part);
            outermost.place == Place::Target
                && matches!(outermost.expression.kind, ExpressionKind::Dereference { .. })
        };
        let by_reference = || self.parts.iter().rfind(is_referenced).copied();
        let assigned = self.assignment(path).or_else(in_block);
        let Some(mut last) = assigned.or_else(by_reference) else {
            return self.field_value(path).map(|span| self.line(span));
        };
        for _ in 0..MAX_COPIES {
            let source = self.copied(&last).and_then(|source| self.assignment(source));
            match source {
                Some(source)
                    if self.start(&source) < self.start(&last) && !self.is_passed_on(&source, &last) =>
                {
                    last = source
                }
                _ => break,
            }
        }
        last.statement.map(|statement| self.line(statement.span))
    }

    /// Returns the last place that assigns a variable, a field or an element of it, counts with it, gives it to an output or an in-out
    /// variable of a call, or gives it something where it is an instance.
    fn assignment(&self, path: &str) -> Option<Part<'t, 's>> {
        let name = path.split(['@', '[', '.']).next().unwrap_or(path);
        let assigns = |part: &&Part<'t, 's>| {
            let targets = [Place::Target, Place::Control, Place::OutputArgument];
            let is_given = |name: &str| {
                let call = part.around.and_then(|call| self.call(call));
                self.is_instance(name) && call.is_some_and(|(_, arguments)| !arguments.is_empty())
            };
            part.is(name)
                && match part.place {
                    // An argument that is the variable alone may be changed by the call.
                    Place::NamedArgument => true,
                    Place::Callee => is_given(name),
                    _ => targets.contains(&self.outermost(part).place),
                }
        };
        self.parts
            .iter()
            .filter(assigns)
            .max_by_key(|part| self.start(part))
            .copied()
    }

    /// Returns the variable with all of its fields, subscripts and bits that a name is a part of.
    pub(crate) fn outermost(&self, name: &Part<'t, 's>) -> Part<'t, 's> {
        let mut outer = *name;
        while outer.place == Place::Base
            && let Some(around) = self.around(&outer)
        {
            outer = *around;
        }
        outer
    }

    fn start(&self, part: &Part<'t, 's>) -> u32 {
        part.statement
            .map_or(part.expression.span, |statement| statement.span)
            .start
    }

    /// Returns where a field is given a value in the initial value of a structure.
    fn field_value(&self, path: &str) -> Option<Span> {
        let (_, field) = path.split('@').next()?.rsplit_once('.')?;
        let field = field.split('[').next()?;
        let is_selected = |span: Span| {
            let covers = |part: &Part<'_, '_>| {
                part.expression.span.start <= span.start && span.end <= part.expression.span.end
            };
            self.parts.iter().any(covers)
        };
        let mut uses = used(&self.unit).into_iter();
        let found =
            uses.find(|one| one.kind == UseKind::Field && one.name.is(field) && !is_selected(one.name.span))?;
        Some(found.name.span)
    }

    /// Returns the line that declares a variable, or the field that a path ends with.
    pub(crate) fn declaration(&self, path: &str) -> u32 {
        let name = last_name(path);
        let declared = self
            .names
            .iter()
            .find(|one| one.name.is(name) && one.group.is_some());
        declared.map_or_else(|| self.last_statement(), |one| self.line(one.name.span))
    }

    /// Returns the variable that nothing assigns and that another one is a copy of.
    fn copied_alone(&self, path: &str) -> Option<&'s str> {
        let source = self.copied(&self.assignment(path)?)?;
        self.assignment(source).is_none().then_some(source)
    }

    /// Returns with which value a variable begins that nothing assigns, or that another one is a copy of, where its type declares one.
    pub(crate) fn initial_value_of_type(&self, path: &str) -> Option<&'static str> {
        let path = self.copied_alone(path).unwrap_or(path);
        let group = self
            .group(last_name(path))
            .filter(|_| self.computation(path).is_none())?;
        match (&group.specification.kind, &group.initializer) {
            (_, Some(_)) => matches!(place_of(self, self.declaration(path)), LinePlace::Types)
                .then_some("initial value of a field"),
            (TypeSpecificationKind::Named(ty), None) => {
                let declared = self.declared_type(ty.text);
                declared
                    .is_some_and(|ty| ty.initializer.is_some())
                    .then_some("initial value of a type")
            }
            _ => None,
        }
    }

    /// Returns the line on which the first loop begins in a unit that a line calls.
    pub(crate) fn loop_in_callee(&self, line: u32) -> Option<u32> {
        let on_line = |part: &&Part<'_, '_>| self.line(part.expression.span) == line;
        let mut called = self.at(Place::Callee).filter(on_line);
        let unit = called.find_map(|part| self.unit_of(part.name()?))?;
        let is_inside = |span: Span| unit.span.start <= span.start && span.end <= unit.span.end;
        let loops = self.parts.iter().filter_map(|part| part.statement);
        let inside = loops.filter(|one| is_loop(&one.kind) && is_inside(one.span));
        inside.map(|one| self.line(one.span)).min()
    }

    /// Returns the line on which the innermost loop begins that a line stands in.
    pub(crate) fn loop_around(&self, line: u32) -> Option<u32> {
        let is_around = |span: &Span| self.line(*span) < line && line < self.lines.line(span.end);
        let loops = self.parts.iter().filter_map(|part| part.statement);
        let loops = loops.filter(|one| is_loop(&one.kind));
        let around = loops.map(|one| one.span).filter(is_around);
        around.map(|span| self.line(span)).max()
    }

    /// Returns the variable that a statement copies to another of the same type, or the function whose result it copies and that
    /// it gives variables and literals only; `None` where it does more.
    fn copied(&self, assigning: &Part<'t, 's>) -> Option<&'s str> {
        let StatementKind::Assignment { target, value } = assigning.statement?.kind else {
            return None;
        };
        let is_same = self.type_of(value)? == self.type_of(target)?;
        let source = self.text(value);
        match &self.part(value)?.expression.kind {
            ExpressionKind::Name(_) | ExpressionKind::Field { .. } | ExpressionKind::Index { .. } => {
                is_same.then_some(source)
            }
            ExpressionKind::Call { .. } => {
                let (callee, arguments) = self.call(value)?;
                let is_plain = |argument: &Argument<'s>| match argument {
                    Argument::Positional(value) | Argument::Named { value, .. } => {
                        self.literal(*value).is_some() || self.specification(*value).is_some()
                    }
                    Argument::Output { .. } => false,
                };
                let is_own = self.unit_of(callee).is_some() && arguments.iter().all(is_plain);
                (is_own && is_same).then_some(callee)
            }
            _ => None,
        }
    }

    /// Returns whether a function only passes a literal on, so that it computes nothing.
    fn is_passed_on(&self, source: &Part<'t, 's>, last: &Part<'t, 's>) -> bool {
        let value = |part: &Part<'_, '_>| match part.statement?.kind {
            StatementKind::Assignment { value, .. } => self.part(value),
            _ => None,
        };
        let is_call = value(last).is_some_and(|part| self.call(part.id).is_some());
        let is_plain = is_call && value(source).is_some_and(|part| part.name().is_some());
        let text = last
            .statement
            .map_or("", |statement| statement.span.text(self.program.text));
        is_plain && tokens(text).iter().any(|token| token.kind.is_literal())
    }

    /// Returns the last line of a program that is no end of anything.
    pub(crate) fn last_statement(&self) -> u32 {
        let lines = self.program.text.lines().zip(1..);
        let is_statement = |(line, _): &(&str, u32)| {
            let first = line.trim().to_ascii_uppercase();
            !first.trim_matches(';').is_empty() && !first.starts_with("END_")
        };
        lines.filter(is_statement).last().map_or(1, |(_, number)| number)
    }
}

/// Returns whether a statement is a loop.
fn is_loop(statement: &StatementKind) -> bool {
    use StatementKind::{For, Repeat, While};
    matches!(statement, For { .. } | While { .. } | Repeat { .. })
}

/// Returns the name of the variable or the field that a path ends with.
fn last_name(path: &str) -> &str {
    let last = path.split('@').next().and_then(|path| path.rsplit('.').next());
    last.and_then(|last| last.split('[').next()).unwrap_or(path)
}

/// Returns whether the first value that a small program has wrong is one that a variable begins with, and nothing assigns.
pub(crate) fn shows_initial_value(text: &str, deviation: &Deviation) -> bool {
    let differs = |fact: &&Fact| !deviation.got.contains(fact);
    let Some(Fact::Value { name, .. }) = deviation.expected.iter().find(differs) else {
        return false;
    };
    read(text, |program| {
        let declaration = program.line_text(program.declaration(name));
        program.computation(name).is_none() && declaration.is_some_and(|line| line.contains(":="))
    })
}
