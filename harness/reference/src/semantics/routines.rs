//! Makes the routines of a program: initial values, the bodies of POUs, start-up and scan.

use super::inferred::Inferred;
use super::locations::{Location, VariablePlace};
use super::lowering::Lowering;
use super::model::{ConfiguredValue, InitialRoutine, PouEntry};
use super::trace::TracedUse;
use crate::instruction::{Instruction, LogicOperator, MachineProgram};
use stickler_syntax::tree::{Edge, VariableKind};

impl<'m> Lowering<'m> {
    /// Lowers everything that is declared. Gives the program, and its uses where a record of them is kept.
    pub(super) fn lower(mut self) -> (MachineProgram, Vec<TracedUse>) {
        let model = self.model;
        let expressions = model.source.unit.expressions.len();
        self.emitter.reserve(model.routines, expressions);
        self.inferred = vec![Inferred::Pending; expressions];
        for &InitialRoutine { routine, value, pou } in &model.initial_values {
            (self.pou, self.constants_only) = (pou, true);
            self.initial_value(routine, value);
        }
        self.constants_only = false;
        let mut methods = MachineProgram::default();
        for (entry, pou) in model.pous.iter().zip(0..) {
            self.pou = Some(pou);
            if entry.is_function() {
                self.function(entry);
            } else {
                self.instance(entry);
            }
            if entry.has_body(model) {
                self.dispatch_routine(entry, &mut methods);
            }
            if let Some(base) = entry.base {
                methods.bases.insert(pou + 1, base + 1);
            }
        }
        self.pou = None;
        let startup = self.startup();
        let scan = self.emitter.begin_new();
        for instance in model.instances.iter().filter(|instance| instance.runs) {
            self.set_line(model.pous[instance.pou as usize].pou.name.span);
            self.emit(Instruction::Address(instance.base));
            self.emit(Instruction::CallInstance(model.pous[instance.pou as usize].body));
        }
        self.emit(Instruction::Return);
        self.report_recursion();
        let (memory, texts) = (self.memory.cells(), std::mem::take(&mut self.memory.texts));
        let uses = self.emitter.uses();
        let addresses = self.address_map();
        let program = MachineProgram {
            startup,
            scan,
            memory,
            texts,
            methods: methods.methods,
            bases: methods.bases,
            addresses,
            ..self.emitter.finish()
        };
        (program, uses)
    }

    /// A function begins anew at each call; inputs that a call leaves out take their defaults.
    fn function(&mut self, entry: &'m PouEntry<'m>) {
        let muted = self.reporter.mute(entry.is_frame);
        self.emitter.begin(entry.initial);
        self.set_line(entry.pou.name.span);
        for &parameter in &entry.parameters {
            if self.model.variable(parameter).kind == VariableKind::Input {
                self.begin_anew(parameter);
            }
        }
        self.emit(Instruction::Return);
        self.reporter.mute(muted);
        if entry.is_frame {
            return;
        }
        self.emitter.begin(entry.body);
        self.set_line(entry.pou.name.span);
        self.clear(
            Location::Absolute(entry.cleared.start),
            entry.cleared.end - entry.cleared.start,
        );
        for index in entry.variables.clone() {
            let kind = self.model.variable(index).kind;
            if kind.is_held() && !matches!(kind, VariableKind::Input | VariableKind::Static) {
                self.begin_with(index);
            }
        }
        self.statements(&entry.pou.body);
        self.emit(Instruction::Return);
    }

    /// An instance of a function block or program keeps its variables, VAR_TEMP excepted.
    fn instance(&mut self, entry: &'m PouEntry<'m>) {
        self.emitter.begin(entry.initial);
        self.set_line(entry.pou.name.span);
        if let Some(base) = entry.base {
            self.emit(Instruction::InstanceAddress(0));
            self.emit(Instruction::CallInstance(self.model.pous[base as usize].initial));
        }
        if let (true, Some(pou)) = (entry.has_type_number, self.pou) {
            self.emit(Instruction::InstanceAddress(0));
            self.emit(Instruction::Push(u64::from(pou) + 1));
            self.emit(Instruction::StoreIndirect);
        }
        for index in entry.variables.clone() {
            let kind = self.model.variable(index).kind;
            if kind.is_held() && !matches!(kind, VariableKind::Temporary | VariableKind::Static) {
                self.begin_with(index);
            }
        }
        self.begin_edges(entry);
        self.emit(Instruction::Return);
        self.emitter.begin(entry.body);
        // A body without statements has steps all the same, and a limit that they exceed has a line.
        self.set_line(entry.pou.name.span);
        for index in entry.variables.clone() {
            if self.model.variable(index).kind == VariableKind::Temporary {
                self.begin_anew(index);
            }
        }
        self.detect_edges(entry);
        self.statements(&entry.pou.body);
        self.emit(Instruction::Return);
    }

    /// Sets the inputs with a falling edge to TRUE for the call before the first, where that one falls at FALSE.
    fn begin_edges(&mut self, entry: &'m PouEntry<'m>) {
        let falls = self.model.source.dialect.first_call_falls;
        for input in entry.variables.clone().filter(|_| falls) {
            if self.model.variable(input).edge == Some(Edge::Falling) {
                let before = VariablePlace::of(self.model.variable(input + 2));
                self.begin_store(before);
                self.emit(Instruction::Push(1));
                self.finish_store(before, entry.pou.name.span);
            }
        }
    }

    /// Finds the edges of the inputs that have an edge qualifier, in the block and in those that it extends.
    fn detect_edges(&mut self, entry: &'m PouEntry<'m>) {
        let (model, span) = (self.model, entry.pou.name.span);
        let Some(pou) = self.pou else { return };
        let levels = model.levels(pou);
        let variables = levels.iter().flat_map(|level| level.variables.clone());
        for (input, edge) in variables.filter_map(|index| Some((index, model.variable(index).edge?))) {
            let [now, seen, before] =
                [0, 1, 2].map(|behind| VariablePlace::of(model.variable(input + behind)));
            let (is_true, is_false) = match edge {
                Edge::Rising => (now, before),
                Edge::Falling => (before, now),
            };
            self.begin_store(seen);
            self.load(is_true);
            self.load(is_false);
            self.emit(Instruction::Push(1));
            self.emit(Instruction::Logic(LogicOperator::Xor));
            self.emit(Instruction::Logic(LogicOperator::And));
            self.finish_store(seen, span);
            self.begin_store(before);
            self.load(now);
            self.finish_store(before, span);
        }
    }

    /// Global variables in the order of the text, then the static ones of each POU, then program instances in their order.
    fn startup(&mut self) -> u32 {
        let model = self.model;
        let startup = self.emitter.begin_new();
        for (variable, index) in model.variables.iter().zip(0..) {
            if variable.kind == VariableKind::Global {
                self.begin_with(index);
            }
        }
        for (entry, pou) in model.pous.iter().zip(0..) {
            self.pou = Some(pou);
            for index in entry.variables.clone() {
                if model.variable(index).kind == VariableKind::Static {
                    self.begin_with(index);
                }
            }
        }
        self.pou = None;
        for instance in &model.instances {
            self.emit(Instruction::Address(instance.base));
            self.emit(Instruction::CallInstance(
                model.pous[instance.pou as usize].initial,
            ));
        }
        for &ConfiguredValue {
            instance,
            offset,
            ty,
            initializer,
        } in &model.configured
        {
            self.set_line(initializer.span);
            let location = Location::Absolute(model.instances[instance].base + offset);
            self.initialize(location, ty, Some(initializer));
        }
        self.emit(Instruction::Return);
        startup
    }

    /// Gives a variable, which is all zero, its initial value. Only variables before it are known there.
    fn begin_with(&mut self, index: u32) {
        self.visible = index;
        self.initialize_variable(&self.model.variables[index as usize]);
        self.visible = u32::MAX;
    }

    /// Clears a variable that has been used before, and gives it its initial value.
    fn begin_anew(&mut self, index: u32) {
        let variable = self.model.variable(index);
        let location = VariablePlace::of(variable).location;
        let cells = self.model.types.extent(variable.ty).size;
        self.clear(location, cells);
        self.begin_with(index);
    }
}
