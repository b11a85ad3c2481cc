//! Lowers statements.

use super::contexts::ValueContext;
use super::emitter::{Jump, Loop};
use super::locations::{Location, VariablePlace};
use super::lowering::Lowering;
use super::scope::Scope;
use super::trace::UseKind;
use super::types::TypeId;
use crate::instruction::{Instruction, Label};
use stickler_syntax::tree::{CaseFolded, ExpressionId, ExpressionKind, Statement, StatementKind};
use stickler_types::{Code, TextReading};

/// A label of a list of statements.
#[derive(Debug, Default)]
pub(super) struct DeclaredLabel {
    /// The place in the code; `None` before the label.
    position: Option<Label>,
    /// The jumps before the label.
    jumps: Vec<Jump>,
}

impl<'m> Lowering<'m> {
    /// Lowers statements one after the other.
    pub(super) fn statements(&mut self, statements: &'m [Statement]) {
        let labels = self.labels_of(statements);
        let has_labels = !labels.is_empty();
        if has_labels {
            self.labels.push(labels);
        }
        for statement in statements {
            self.set_line(statement.span);
            self.statement(statement);
        }
        if has_labels {
            self.labels.pop();
        }
    }

    fn statement(&mut self, statement: &'m Statement) {
        match &statement.kind {
            StatementKind::Assignment { target, value } => self.assignment(*target, *value),
            StatementKind::Binding { target, value } => self.binding(*target, *value),
            StatementKind::Call(id) => self.call_statement(*id),
            StatementKind::If { branches, otherwise } => self.if_statement(branches, otherwise.as_deref()),
            StatementKind::Case {
                selector,
                branches,
                otherwise,
            } => {
                self.case(*selector, branches, otherwise.as_deref());
            }
            StatementKind::For {
                control,
                from,
                to,
                by,
                body,
            } => {
                self.for_loop(*control, (*from, *to, *by), body);
            }
            StatementKind::While { condition, body } => self.while_loop(*condition, body),
            StatementKind::Repeat { body, until } => self.repeat_loop(body, *until),
            StatementKind::Exit => match self.loops.last_mut() {
                Some(around) => around.exits.push(self.emitter.jump()),
                None => self.report(Code::ExitOutsideLoop, statement.span, "EXIT stands in no loop"),
            },
            StatementKind::Continue => match self.loops.last_mut() {
                Some(around) => around.continues.push(self.emitter.jump()),
                None => {
                    let message = "CONTINUE stands in no loop";
                    self.report(Code::ContinueOutsideLoop, statement.span, message);
                }
            },
            StatementKind::Return => self.emit(Instruction::Return),
            StatementKind::Jump(name) => self.jump_to(*name),
            StatementKind::Label(name) => self.land_label(*name),
            StatementKind::Empty => {}
        }
    }

    /// Lowers `target := value`.
    pub(super) fn assignment(&mut self, target: ExpressionId, value: ExpressionId) {
        if let Some(property) = self.property(target) {
            return self.write_property(target, property, value);
        }
        let Some(place) = self.place(target) else {
            self.value(value, None);
            return;
        };
        if place.constant {
            self.refuse_constant(target);
        }
        let bare = self.expression(self.model.source.bare(value));
        let context = match bare.kind {
            ExpressionKind::Call { .. } => ValueContext::CallResult,
            _ => ValueContext::Assignment,
        };
        let is_loose = self.model.source.dialect.conversions.text_reading == TextReading::LooseDigits;
        self.fallible = (is_loose && context == ValueContext::CallResult).then_some(bare.span);
        self.begin_store(place);
        self.coerce(value, place.content(), context);
        let place = self.fit_result(&bare.kind, target, place);
        self.finish_store(place, self.span(target));
        self.keep_after_failure(place);
        self.record_written(target, place);
    }

    /// Leads what a conversion that failed jumped with past the store, so that the variable keeps its value.
    ///
    /// Basis: omron-instructions: 319.
    fn keep_after_failure(&mut self, place: VariablePlace) {
        self.fallible = None;
        let Some(failed) = self.failed.take() else { return };
        let stored = self.emitter.jump();
        self.emitter.land(failed);
        self.emit(Instruction::Drop);
        if place.part.is_some() || !matches!(place.location, Location::Absolute(_)) {
            self.emit(Instruction::Drop);
        }
        self.emitter.land(stored);
    }

    /// Records that a part of a variable has been written, where the place is one.
    pub(super) fn record_written(&mut self, target: ExpressionId, place: VariablePlace) {
        if let (Some(_), Some(of)) = (place.part, self.model.elementary(place.ty)) {
            self.emitter.record(target, UseKind::BitWritten(of));
        }
    }

    /// Leaves the value of a condition on the stack.
    fn condition(&mut self, id: ExpressionId) {
        self.set_line(self.span(id));
        self.coerce(id, TypeId::BOOL, ValueContext::Condition);
    }

    fn if_statement(
        &mut self,
        branches: &'m [(ExpressionId, Vec<Statement>)],
        otherwise: Option<&'m [Statement]>,
    ) {
        let mut ends = Vec::with_capacity(branches.len());
        for (index, (condition, body)) in branches.iter().enumerate() {
            self.condition(*condition);
            let next = self.emitter.jump_if_false();
            self.statements(body);
            if index + 1 < branches.len() || otherwise.is_some() {
                ends.push(self.emitter.jump());
            }
            self.emitter.land(next);
        }
        self.statements(otherwise.unwrap_or_default());
        self.land_all(ends);
    }

    fn while_loop(&mut self, condition: ExpressionId, body: &'m [Statement]) {
        let top = self.emitter.position();
        self.condition(condition);
        let out = self.emitter.jump_if_false();
        let done = self.body(body);
        self.land_all(done.continues);
        self.emit(Instruction::Jump(top));
        self.emitter.land(out);
        self.land_all(done.exits);
    }

    fn repeat_loop(&mut self, body: &'m [Statement], until: ExpressionId) {
        let top = self.emitter.position();
        let done = self.body(body);
        self.land_all(done.continues);
        self.condition(until);
        self.emit(Instruction::JumpIfFalse(top));
        self.land_all(done.exits);
    }

    /// Returns the labels of a list of statements.
    fn labels_of(&mut self, statements: &'m [Statement]) -> Scope<'m, DeclaredLabel> {
        let mut labels = Scope::default();
        for statement in statements {
            let StatementKind::Label(name) = statement.kind else {
                continue;
            };
            let text = self.model.source.text_of(name);
            if labels
                .insert(CaseFolded(text), DeclaredLabel::default())
                .is_some()
            {
                let message = format!("the label `{text}` stands twice in one list of statements");
                self.report(Code::SymbolDeclDuplicated, statement.span, message);
            }
        }
        labels
    }

    /// Lowers a jump to a label of the statements around it. No value is on the stack between statements, so that only the place in the
    /// code changes.
    fn jump_to(&mut self, name: ExpressionId) {
        let text = self.model.source.text_of(name);
        let mut around = self.labels.iter_mut().rev();
        match around.find_map(|labels| labels.get_mut(&CaseFolded(text))) {
            Some(DeclaredLabel {
                position: Some(position),
                ..
            }) => self.emitter.emit(Instruction::Jump(*position)),
            Some(label) => label.jumps.push(self.emitter.jump()),
            None => {
                let message = format!("no label `{text}` stands in the statements around the jump");
                self.report(Code::LabelNotAround, self.span(name), message);
            }
        }
    }

    fn land_label(&mut self, name: ExpressionId) {
        let text = self.model.source.text_of(name);
        let label = self.labels.last_mut();
        if let Some(label) = label.and_then(|labels| labels.get_mut(&CaseFolded(text))) {
            label.position = Some(self.emitter.position());
            let jumps = std::mem::take(&mut label.jumps);
            self.land_all(jumps);
        }
    }

    /// Lowers the body of a loop; gives the jumps that leave it.
    pub(super) fn body(&mut self, body: &'m [Statement]) -> Loop {
        self.loops.push(Loop::default());
        self.statements(body);
        self.loops.pop().unwrap_or_default()
    }

    /// Leads jumps here.
    pub(super) fn land_all(&mut self, jumps: Vec<Jump>) {
        for jump in jumps {
            self.emitter.land(jump);
        }
    }
}
