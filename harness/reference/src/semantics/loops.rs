//! Lowers FOR.
//!
//! The limit and the step are evaluated once. The step is taken by an instruction that knows no width, so that
//! a loop up to the greatest value of its control variable ends. After the loop the control variable has the
//! value that ended it, wrapped to its type; one with limits keeps its last value instead.
//!
//! Basis: iec-61131-3: 7.3.3.4.2 (FOR bounds); iec-61131-3: FOR statement (the control variable's
//! value after the loop is left to the implementer).

use super::contexts::ValueContext;
use super::locations::{VariablePlace, check_range};
use super::lowering::{LoweredValue, Lowering};
use super::types::{TypeId, TypeKind};
use crate::conversion::{Conversion, ConversionRule};
use crate::instruction::{Instruction, LoopTypes};
use stickler_syntax::source::Span;
use stickler_syntax::tree::{ExpressionId, Statement};
use stickler_types::{Code, ElementaryType};

/// A limit or a step that is kept while the loop runs.
#[derive(Clone, Copy)]
struct LoopBound {
    cell: u32,
    ty: ElementaryType,
}

impl<'m> Lowering<'m> {
    /// Lowers a FOR loop.
    pub(super) fn for_loop(
        &mut self,
        control: ExpressionId,
        (from, to, by): (ExpressionId, ExpressionId, Option<ExpressionId>),
        body: &'m [Statement],
    ) {
        let Some((place, ty)) = self.control(control) else {
            for bound in [Some(from), Some(to), by].into_iter().flatten() {
                self.integer(bound, ElementaryType::Lint, ValueContext::Integer);
            }
            self.body(body);
            return;
        };
        let span = self.span(control);
        self.begin_store(place);
        self.first_value(from, place, ty);
        let wraps = self.model.source.dialect.loops_wrap;
        // A limit beyond the type of the control variable is never met.
        let wanted = if wraps && ty != ElementaryType::Ulint {
            ElementaryType::Lint
        } else {
            ty
        };
        let limit = self.keep(to, wanted);
        let step = self.keep_step(by, span);
        self.finish_store(place, span);
        let types = LoopTypes {
            control: ty,
            limit: limit.ty,
            step: step.ty,
            wraps,
        };

        self.load_three(place, limit, step);
        self.emit(Instruction::LoopTest(types));
        let out = self.emitter.jump_if_false();
        let top = self.emitter.position();
        let done = self.body(body);
        self.land_all(done.continues);
        self.set_line(span);
        self.load_three(place, limit, step);
        self.emit(Instruction::LoopStep(types));
        self.next_turn(place, top, span);
        self.emitter.land(out);
        self.land_all(done.exits);
    }

    /// The control variable and its type.
    fn control(&mut self, control: ExpressionId) -> Option<(VariablePlace, ElementaryType)> {
        let place = self.place(control)?;
        if place.constant {
            self.refuse_constant(control);
        }
        let elementary = self.model.elementary(place.content());
        let Some(ty) = elementary.and_then(|ty| self.counting(ty)) else {
            let name = self.model.types.name(place.content());
            let message = format!("the control variable of FOR is an integer, not {name}");
            self.report(Code::AssignmentTypeMismatch, self.span(control), message);
            return None;
        };
        let location = self.pinned(place, self.span(control));
        Some((VariablePlace { location, ..place }, ty))
    }

    /// Puts the first value on the stack, as the control variable holds it.
    fn first_value(&mut self, from: ExpressionId, place: VariablePlace, ty: ElementaryType) {
        let Some(value) = self.integer(from, ty, ValueContext::Integer) else {
            return;
        };
        if let Some(own) = value.ty.elementary().filter(|&own| own != ty) {
            self.emit(Instruction::Convert(Conversion {
                from: own,
                to: ty,
                rule: ConversionRule::Wrap,
            }));
        }
        self.check_limits(
            from,
            LoweredValue {
                constant: None,
                ..value
            },
            place.ty,
        );
    }

    fn keep(&mut self, bound: ExpressionId, wanted: ElementaryType) -> LoopBound {
        let value = self.integer(bound, wanted, ValueContext::Integer);
        let cell = self.temporary(self.span(bound));
        self.emit(Instruction::Store(cell));
        LoopBound {
            cell,
            ty: value.and_then(|value| value.ty.elementary()).unwrap_or(wanted),
        }
    }

    /// The step. An untyped one may be negative whatever the control variable's type is.
    fn keep_step(&mut self, by: Option<ExpressionId>, span: Span) -> LoopBound {
        if let Some(by) = by {
            return self.keep(by, ElementaryType::Lint);
        }
        let cell = self.temporary(span);
        self.emit(Instruction::Push(1));
        self.emit(Instruction::Store(cell));
        LoopBound {
            cell,
            ty: ElementaryType::Lint,
        }
    }

    fn load_three(&mut self, place: VariablePlace, limit: LoopBound, step: LoopBound) {
        self.load(place);
        self.emit(Instruction::Load(limit.cell));
        self.emit(Instruction::Load(step.cell));
    }

    /// The next value, and above it whether the loop goes on, are on the stack.
    fn next_turn(&mut self, place: VariablePlace, top: u32, span: Span) {
        if let TypeKind::Subrange(limits) = *self.model.types.kind(place.ty) {
            let last = self.emitter.jump_if_false();
            self.emit_at(span, check_range(limits));
            self.store(
                VariablePlace {
                    ty: TypeId::of(limits.base),
                    ..place
                },
                span,
            );
            self.emit(Instruction::Jump(top));
            self.emitter.land(last);
            self.emit(Instruction::Drop);
        } else {
            self.emit(Instruction::Swap);
            self.store(place, span);
            let last = self.emitter.jump_if_false();
            self.emit(Instruction::Jump(top));
            self.emitter.land(last);
        }
    }
}
