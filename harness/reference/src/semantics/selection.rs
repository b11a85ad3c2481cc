//! Lowers CASE.
//!
//! Basis: ironplc-problem-codes: P4051 (reversed range), P4053 (selector neither integer nor enumeration),
//! P4010 (a label is a constant), P2026 (a label that the selector's type does not have), P4041 (a number in another base).

use super::contexts::{Fit, ValueContext, fit};
use super::emitter::Jump;
use super::inferred::Inferred;
use super::lowering::Lowering;
use super::types::{TypeId, TypeKind};
use crate::instruction::{ComparisonOperator, Instruction, LogicOperator};
use stickler_syntax::tree::{CaseBranch, CaseLabel, ExpressionId, ExpressionKind, LiteralKind, Statement};
use stickler_types::{Code, ElementaryType};

/// The selector, which labels are compared with.
#[derive(Clone, Copy)]
struct CaseSelector {
    /// The cell that keeps it.
    cell: u32,
    /// An integer type or an enumeration; [`TypeId::ERROR`] where it is neither.
    ty: TypeId,
    /// The type in which numbers are compared.
    of: ElementaryType,
}

impl<'m> Lowering<'m> {
    /// Lowers a CASE statement.
    pub(super) fn case(
        &mut self,
        selector: ExpressionId,
        branches: &'m [CaseBranch],
        otherwise: Option<&'m [Statement]>,
    ) {
        let selector = self.selector(selector);
        let mut ends = Vec::with_capacity(branches.len());
        for branch in branches {
            let hits: Vec<_> = branch
                .labels
                .iter()
                .filter_map(|label| self.label(selector, label))
                .collect();
            let next = self.emitter.jump();
            self.land_all(hits);
            self.statements(&branch.body);
            ends.push(self.emitter.jump());
            self.emitter.land(next);
        }
        self.statements(otherwise.unwrap_or_default());
        self.land_all(ends);
    }

    fn selector(&mut self, id: ExpressionId) -> CaseSelector {
        let inferred = self.infer(id);
        let value = self.value(id, None);
        let span = self.span(id);
        let cell = self.temporary(span);
        self.emit(Instruction::Store(cell));
        let integer = value.ty.elementary().and_then(|ty| self.counting(ty));
        if let Some(of) = integer {
            return CaseSelector {
                cell,
                ty: TypeId::of(of),
                of,
            };
        }
        let enumerated = matches!(self.model.types.kind(value.ty), TypeKind::Enumeration(_));
        if !enumerated && (value.ty != TypeId::ERROR || inferred == Inferred::Nothing) {
            let message = format!(
                "CASE selects by an integer or an enumeration, not by {}",
                self.describe(inferred)
            );
            self.report(Code::CaseSelectorTypeInvalid, span, message);
        }
        let ty = if enumerated { value.ty } else { TypeId::ERROR };
        CaseSelector {
            cell,
            ty,
            of: ElementaryType::Lint,
        }
    }

    /// Compares the selector with a label; gives the jump to its branch.
    fn label(&mut self, selector: CaseSelector, label: &CaseLabel) -> Option<Jump> {
        match *label {
            CaseLabel::Value(id) => {
                self.set_line(self.span(id));
                let number = self.label_value(selector, id)?;
                self.emit(Instruction::Load(selector.cell));
                self.emit(Instruction::Push(selector.of.wrap(number)));
                self.emit(Instruction::Compare(ComparisonOperator::NotEqual, selector.of));
            }
            CaseLabel::Range(low, high) => {
                self.set_line(self.span(low));
                let (first, last) = (self.label_value(selector, low), self.label_value(selector, high));
                let (first, last) = first.zip(last)?;
                if first > last {
                    let span = self.span(low).to(self.span(high));
                    let message = format!("the range begins with {first} and ends with {last}");
                    self.report(Code::CaseLabelRangeInvalid, span, message);
                    return None;
                }
                for (operator, limit) in [
                    (ComparisonOperator::Less, first),
                    (ComparisonOperator::Greater, last),
                ] {
                    self.emit(Instruction::Load(selector.cell));
                    self.emit(Instruction::Push(selector.of.wrap(limit)));
                    self.emit(Instruction::Compare(operator, selector.of));
                }
                self.emit(Instruction::Logic(LogicOperator::Or));
            }
        }
        // What was compared is the opposite, for there is only a jump that is taken on FALSE.
        Some(self.emitter.jump_if_false())
    }

    /// The number of a label, which is a constant of the selector's type. No code is left of it.
    fn label_value(&mut self, selector: CaseSelector, id: ExpressionId) -> Option<i128> {
        if let ExpressionKind::Literal(literal) = self.expression(id).kind
            && literal.kind == LiteralKind::BasedInteger
            && !self.model.source.dialect.based_case_labels
        {
            let message = "a number in another base is no label of CASE here";
            self.report(Code::BitStringCaseLabelNotAllowed, self.span(id), message);
            return None;
        }
        let start = self.emitter.position();
        let number = self.label_number(selector, id, start);
        self.emitter.truncate(start);
        number
    }

    fn label_number(&mut self, selector: CaseSelector, id: ExpressionId, start: u32) -> Option<i128> {
        let span = self.span(id);
        if selector.ty == TypeId::ERROR {
            self.value(id, None);
            return None;
        }
        let value = if selector.ty.elementary().is_some() {
            self.integer(id, selector.of, ValueContext::Label)?
        } else {
            let inferred = self.infer(id);
            let dialect = self.model.source.dialect;
            let misfit = fit(
                inferred,
                selector.ty,
                ValueContext::Label,
                &self.model.types,
                dialect,
            ) == Fit::No;
            let value = self.coerce(id, selector.ty, ValueContext::Label);
            if misfit || value.ty == TypeId::ERROR {
                return None;
            }
            value
        };
        let ty = value.ty.elementary().unwrap_or(selector.of);
        let Some(number) = self.emitter.pushed_since(start).map(|raw| ty.integer_value(raw)) else {
            self.report(Code::VariableMustBeConst, span, "a label of CASE is a constant");
            return None;
        };
        let (low, high) = selector.of.integer_range().unwrap_or((0, 0));
        if !(low..=high).contains(&number) {
            let message = format!("{number} does not fit {} ({low}..{high})", selector.of.name());
            self.report(Code::ConstantOverflow, span, message);
            return None;
        }
        Some(number)
    }
}
