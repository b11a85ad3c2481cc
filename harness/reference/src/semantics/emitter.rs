//! Where code is put together, routine after routine.

use crate::instruction::{Instruction, Label, Program, RoutineId};
use rustc_hash::FxHashMap;

/// The code so far. Routines are made one after the other, so it only ever grows at its end.
#[derive(Debug)]
pub(super) struct Emitter {
    code: Vec<Instruction>,
    lines: Vec<u32>,
    line: u32,
    routines: Vec<Label>,
    text_constants: Vec<Box<[u16]>>,
    known_texts: FxHashMap<Box<[u16]>, u32>,
}

/// A jump whose destination is not known yet.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub(super) struct Jump(usize);

impl Emitter {
    /// No code, and room for the labels of this many routines.
    pub(super) fn new(routines: RoutineId) -> Emitter {
        Emitter {
            code: Vec::new(),
            lines: Vec::new(),
            line: 0,
            routines: vec![0; routines as usize],
            text_constants: Vec::new(),
            known_texts: FxHashMap::default(),
        }
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

    /// Where the next instruction will stand.
    pub(super) fn position(&self) -> Label {
        u32::try_from(self.code.len()).unwrap_or(u32::MAX)
    }

    /// Takes back everything behind a position that no jump leads to.
    pub(super) fn truncate(&mut self, position: Label) {
        self.code.truncate(position as usize);
        self.lines.truncate(position as usize);
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
    pub(super) fn finish(self) -> Program {
        Program {
            code: self.code,
            lines: self.lines,
            routines: self.routines,
            text_constants: self.text_constants,
            ..Program::default()
        }
    }
}
