//! Puts code together, routine after routine.

use super::trace::{Trace, TracedUse, UseKind};
use crate::conversion::{Concatenation, Conversion};
use crate::instruction::{Instruction, Label, MachineProgram, RoutineId};
use rustc_hash::FxHashMap;
use stickler_syntax::tree::ExpressionId;

/// The code so far. Routines are made one after the other, so it only ever grows at its end.
#[derive(Debug, Default)]
pub(super) struct Emitter {
    code: Vec<Instruction>,
    lines: Vec<u32>,
    line: u32,
    routines: Vec<Label>,
    text_constants: Vec<Box<[u16]>>,
    known_texts: FxHashMap<Box<[u16]>, u32>,
    /// The record of uses, where one is kept.
    trace: Option<Trace>,
}

/// The most code units of a text that is copied freely.
pub(super) const MAX_SHORT_TEXT: usize = 255;

/// A jump whose destination is not known yet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jump(usize);

/// The jumps out of a loop, and to its next turn, whose destinations are not known yet.
#[derive(Debug, Default)]
pub(super) struct Loop {
    /// The jumps of its EXITs.
    pub(super) exits: Vec<Jump>,
    /// The jumps of its CONTINUEs.
    pub(super) continues: Vec<Jump>,
}

impl Emitter {
    /// Makes room for the labels of this many routines and for the instructions that this many expressions ordinarily
    /// take.
    pub(super) fn reserve(&mut self, routines: RoutineId, expressions: usize) {
        // Each routine ends with a return, and so do start-up and scan, which begin with a little more.
        let instructions = expressions + routines as usize + 8;
        self.code.reserve(instructions);
        self.lines.reserve(instructions);
        self.routines = vec![0; routines as usize];
    }

    /// Keeps a record of uses from here on, if one is given.
    pub(super) fn keep(&mut self, trace: Option<Trace>) {
        self.trace = trace;
    }

    /// Records a use whose code ends here.
    pub(super) fn record(&mut self, expression: ExpressionId, kind: UseKind) {
        let end = Some(self.position());
        if let Some(trace) = &mut self.trace {
            trace.push(TracedUse {
                expression,
                kind,
                end,
            });
        }
    }

    /// Takes the recorded uses out; none where no record is kept.
    pub(super) fn uses(&mut self) -> Vec<TracedUse> {
        self.trace.take().map(Trace::finish).unwrap_or_default()
    }

    /// Begins a routine.
    pub(super) fn begin(&mut self, routine: RoutineId) {
        self.routines[routine as usize] = self.position();
    }

    /// Adds a routine that was not counted before, and begins it.
    pub(super) fn begin_new(&mut self) -> RoutineId {
        self.routines.push(self.position());
        u32::try_from(self.routines.len() - 1).unwrap_or(u32::MAX)
    }

    /// The source line of what follows, counted from 1.
    pub(super) fn set_line(&mut self, line: u32) {
        self.line = line;
    }

    /// The source line of what follows.
    pub(super) fn line(&self) -> u32 {
        self.line
    }

    /// Adds an instruction.
    pub(super) fn emit(&mut self, instruction: Instruction) {
        self.code.push(instruction);
        self.lines.push(self.line);
    }

    /// Adds the push of a text constant.
    pub(super) fn push_text(&mut self, units: Vec<u16>) {
        let units = units.into_boxed_slice();
        let index = match self.known_texts.get(&units) {
            Some(&index) => index,
            None => {
                let index = u32::try_from(self.text_constants.len()).unwrap_or(u32::MAX);
                self.text_constants.push(units.clone());
                self.known_texts.insert(units, index);
                index
            }
        };
        self.emit(Instruction::PushText(index));
    }

    /// Adds a conversion of what is on the stack. Where that is a constant, what it becomes is pushed instead.
    /// No jump leads between the two, for statements only are jumped to.
    pub(super) fn convert(&mut self, conversion: Conversion) {
        let (from_text, to_text) = (conversion.from.is_text(), conversion.to.is_text());
        match self.code.last() {
            Some(&Instruction::Push(raw)) if !from_text && !to_text => {
                self.replace(1, Instruction::Push(conversion.apply(raw)));
            }
            Some(&Instruction::Push(raw)) if !from_text => {
                self.truncate(self.position().saturating_sub(1));
                self.push_text(conversion.apply_to_text(raw));
            }
            Some(&Instruction::PushText(text)) if from_text => self.convert_text(text, conversion),
            _ => self.emit(Instruction::Convert(conversion)),
        }
    }

    /// Adds a conversion of a text constant. A long one that stays a text is left to the machine, lest the
    /// program hold many of them.
    fn convert_text(&mut self, text: u32, conversion: Conversion) {
        let units = &self.text_constants[text as usize];
        if !conversion.to.is_text() {
            let raw = conversion.apply_from_text(units);
            self.replace(1, Instruction::Push(raw));
        } else if units.len() <= MAX_SHORT_TEXT {
            let units = conversion.text_to_text(units);
            self.truncate(self.position().saturating_sub(1));
            self.push_text(units);
        } else {
            self.emit(Instruction::Convert(conversion));
        }
    }

    /// Adds the joining of a date and a time of day, constants like others.
    pub(super) fn concatenate(&mut self, function: Concatenation) {
        match self.code[..] {
            [.., Instruction::Push(date), Instruction::Push(time)] => {
                self.replace(2, Instruction::Push(function.apply_two(date, time)));
            }
            _ => self.emit(Instruction::Concatenate(function)),
        }
    }

    /// The two constants that have just been pushed, where those are the last that happened.
    pub(super) fn pushed_pair(&self) -> Option<(u64, u64)> {
        match self.code[..] {
            [.., Instruction::Push(left), Instruction::Push(right)] => Some((left, right)),
            _ => None,
        }
    }

    /// The constant that is all that has been pushed since a position.
    pub(super) fn pushed_since(&self, position: Label) -> Option<u64> {
        match self.code.get(position as usize..) {
            Some(&[Instruction::Push(raw)]) => Some(raw),
            _ => None,
        }
    }

    /// Returns the text constant that is all that has been pushed since a position.
    pub(super) fn text_pushed_since(&self, position: Label) -> Option<&[u16]> {
        match self.code.get(position as usize..) {
            Some(&[Instruction::PushText(text)]) => Some(&self.text_constants[text as usize]),
            _ => None,
        }
    }

    /// Puts an instruction in the place of the last ones.
    pub(super) fn replace(&mut self, count: u32, by: Instruction) {
        self.truncate(self.position().saturating_sub(count));
        self.emit(by);
    }

    /// Returns the label of the next instruction.
    pub(super) fn position(&self) -> Label {
        u32::try_from(self.code.len()).unwrap_or(u32::MAX)
    }

    /// Takes back everything behind a position that no jump leads to.
    pub(super) fn truncate(&mut self, position: Label) {
        self.code.truncate(position as usize);
        self.lines.truncate(position as usize);
        if let Some(trace) = &mut self.trace {
            trace.truncate(position);
        }
    }

    /// Adds a jump that is to be given its destination later.
    pub(super) fn jump(&mut self) -> Jump {
        self.emit(Instruction::Jump(0));
        Jump(self.code.len() - 1)
    }

    /// Adds a jump that is taken where the BOOL on the stack is FALSE.
    pub(super) fn jump_if_false(&mut self) -> Jump {
        self.emit(Instruction::JumpIfFalse(0));
        Jump(self.code.len() - 1)
    }

    /// Leads a jump to where the next instruction will stand.
    pub(super) fn land(&mut self, jump: Jump) {
        let here = self.position();
        if let Some(Instruction::Jump(to) | Instruction::JumpIfFalse(to)) = self.code.get_mut(jump.0) {
            *to = here;
        }
    }

    /// The code, with nothing said yet of memory and of which routine runs when.
    pub(super) fn finish(self) -> MachineProgram {
        MachineProgram {
            code: self.code,
            lines: self.lines,
            routines: self.routines,
            text_constants: self.text_constants,
            ..MachineProgram::default()
        }
    }
}
