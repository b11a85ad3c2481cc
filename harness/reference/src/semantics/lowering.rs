//! Lowers the bodies of POUs to code, and says what is wrong with them.
//!
//! Each expression is inferred at most once, silently, and lowered exactly once, which reports. So everything
//! wrong is said once, and nothing is said about what follows from something wrong. Once anything has been
//! reported the code is thrown away, so code for what is wrong need not make sense.

use super::address_layouts::AddressLayouts;
use super::check::Reporter;
use super::common::TypeRules;
use super::emitter::{Emitter, Jump, Loop};
use super::inferred::Inferred;
use super::memory::MemoryLayout;
use super::model::{DeclaredVariable, Model, PouEntry};
use super::scope::Scope;
use super::statements::DeclaredLabel;
use super::types::TypeId;
use crate::instruction::Instruction;
use rustc_hash::FxHashSet;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{CaseFolded, Expression, ExpressionId, VariableKind};
use stickler_types::{Code, ElementaryType};

/// The state of lowering.
pub(super) struct Lowering<'m> {
    pub(super) model: &'m Model<'m>,
    pub(super) reporter: &'m mut Reporter,
    pub(super) emitter: Emitter,
    pub(super) memory: MemoryLayout,
    /// The layouts in bytes of the types that references and pointers lead to.
    pub(super) addresses: AddressLayouts,
    /// The inferred type of each expression.
    pub(super) inferred: Vec<Inferred>,
    /// The POU whose code is being made; `None` for what belongs to the top level.
    pub(super) pou: Option<u32>,
    /// The position up to which an initial value knows the variables of its own scope.
    pub(super) visible: u32,
    /// Whether only the constants of the POU are known, since its variables do not exist where the code is run.
    pub(super) constants_only: bool,
    /// The loops around the statement, the innermost last.
    pub(super) loops: Vec<Loop>,
    /// The labels of those lists of statements around the statement that have some, the innermost last.
    pub(super) labels: Vec<Scope<'m, DeclaredLabel>>,
    /// The calls of POUs, as pairs of caller and callee with the first place of each.
    pub(super) calls: Vec<(u32, u32, Span)>,
    /// The pairs in `calls`.
    pub(super) known_calls: FxHashSet<(u32, u32)>,
    /// The call of a conversion that is all that is assigned, where one that fails leaves the variable as it is.
    pub(super) fallible: Option<Span>,
    /// The jump of that conversion where it fails.
    pub(super) failed: Option<Jump>,
    /// The number of messages that may still look for a similar name, which takes time.
    pub(super) guesses: u32,
}

/// A value on top of the stack: of which type, and which number where that is known.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct LoweredValue {
    /// A value's type; [`TypeId::ERROR`] where something wrong has been reported.
    pub(super) ty: TypeId,
    /// The number of a constant expression of an integer type or an enumeration.
    pub(super) constant: Option<i128>,
}

impl LoweredValue {
    /// A value about which no more is reported.
    pub(super) const ERROR: LoweredValue = LoweredValue {
        ty: TypeId::ERROR,
        constant: None,
    };

    /// Returns a value of an elementary type that is computed as the program runs.
    pub(super) const fn of(ty: ElementaryType) -> LoweredValue {
        LoweredValue::computed(TypeId::of(ty))
    }

    /// Returns a value that is computed as the program runs.
    pub(super) const fn computed(ty: TypeId) -> LoweredValue {
        LoweredValue { ty, constant: None }
    }
}

impl<'m> Lowering<'m> {
    /// Prepares lowering.
    pub(super) fn new(model: &'m Model<'m>, memory: MemoryLayout, reporter: &'m mut Reporter) -> Self {
        Lowering {
            model,
            reporter,
            emitter: Emitter::default(),
            memory,
            addresses: AddressLayouts::default(),
            inferred: Vec::new(),
            pou: None,
            visible: u32::MAX,
            constants_only: false,
            loops: Vec::new(),
            labels: Vec::new(),
            calls: Vec::new(),
            known_calls: FxHashSet::default(),
            fallible: None,
            failed: None,
            guesses: 20,
        }
    }

    /// Reports something wrong.
    pub(super) fn report(&mut self, code: Code, span: Span, message: impl Into<String>) {
        self.reporter.report(code, span, message);
    }

    /// Adds an instruction.
    pub(super) fn emit(&mut self, instruction: Instruction) {
        self.emitter.emit(instruction);
    }

    /// Adds an instruction that may fault, which is then said of the line where the span begins.
    pub(super) fn emit_at(&mut self, span: Span, instruction: Instruction) {
        let before = self.emitter.line();
        self.set_line(span);
        self.emitter.emit(instruction);
        self.emitter.set_line(before);
    }

    /// Sets the line of the instructions that follow.
    pub(super) fn set_line(&mut self, span: Span) {
        self.emitter.set_line(self.model.source.lines.line(span.start));
    }

    /// Returns the rules of operators.
    pub(super) fn rules(&self) -> TypeRules<'m> {
        TypeRules {
            types: &self.model.types,
            dialect: self.model.source.dialect,
        }
    }

    /// Returns an expression of the tree.
    pub(super) fn expression(&self, id: ExpressionId) -> &'m Expression<'m> {
        self.model.source.expression(id)
    }

    /// Returns the span of an expression.
    pub(super) fn span(&self, id: ExpressionId) -> Span {
        self.expression(id).span
    }

    /// The POU whose code is being made.
    pub(super) fn entry(&self) -> Option<&'m PouEntry<'m>> {
        self.pou.map(|pou| &self.model.pous[pou as usize])
    }

    /// Finds the variable of a name: one of the POU, or else a global one. In an initial value those of its own scope
    /// that are declared later do not count.
    pub(super) fn variable(&self, name: &str) -> Option<(u32, &'m DeclaredVariable<'m>)> {
        let local = self.entry().and_then(|entry| self.local(entry, name));
        let local = local.map(|index| index + u32::from(self.model.variable(index).edge.is_some()));
        let limited = local.is_some() || self.pou.is_none();
        let index = local.or_else(|| self.model.globals.get(&CaseFolded(name)).copied())?;
        let variable = &self.model.variables[index as usize];
        let external = variable.kind == VariableKind::External;
        let later = limited
            && index >= self.visible
            && !external
            && !self.model.source.dialect.initial_values_name_all;
        let away = self.constants_only && local.is_some() && !external && !variable.value.is_known();
        (!later && !away).then_some((index, variable))
    }

    /// Finds the variable of a name in a POU, of a method also in its block, and in those that the block extends. A method knows no
    /// VAR_TEMP of its block.
    ///
    /// Basis: codesys-pages: _cds_obj_method.
    pub(super) fn local(&self, entry: &PouEntry<'_>, name: &str) -> Option<u32> {
        let mut scope = Some(entry);
        let mut around = entry.owner.or(entry.base);
        while let Some(inner) = scope {
            if let Some(&index) = inner.scope.get(&CaseFolded(name)) {
                let kind = self.model.variable(index).kind;
                let is_hidden = inner.owner.is_none() && kind == VariableKind::Temporary;
                return Some(index).filter(|_| std::ptr::eq(inner, entry) || !is_hidden);
            }
            scope = around.map(|around| &self.model.pous[around as usize]);
            around = scope.and_then(|scope| scope.base);
        }
        None
    }

    /// Takes a plain cell for what must be kept while other code runs. Recursion is forbidden, so it
    /// may lie at a fixed address.
    pub(super) fn temporary(&mut self, span: Span) -> u32 {
        self.temporary_of(TypeId::of(ElementaryType::Ulint), span)
    }

    /// Takes room for a value of a type.
    pub(super) fn temporary_of(&mut self, ty: TypeId, span: Span) -> u32 {
        let model = self.model;
        let cell = self.memory.allocate(&model.types, ty).unwrap_or_else(|| {
            self.report(Code::LimitExceeded, span, "the program needs too much memory");
            0
        });
        self.addresses.temporaries.push((cell, ty));
        cell
    }

    /// Notes that the POU calls another.
    pub(super) fn note_call(&mut self, callee: u32, span: Span) {
        if let Some(caller) = self.pou
            && self.known_calls.insert((caller, callee))
        {
            self.calls.push((caller, callee, span));
        }
    }
}
