//! The machine: an instruction pointer, two operand stacks, and frames.
//!
//! A step is one instruction; copying, clearing and texts cost steps by their size besides, so that the step
//! limit bounds both the time and the memory that a run can take.

use super::counting::LoopCounter;
use super::memory::MachineMemory;
use super::standard::{Text, complement};
use super::stop::{Halt, Inconsistency, RaisedFault, Stop};
use super::{arithmetic, comparison, duration, power};
use crate::instruction::{
    Address, FaultKind, Instruction, Label, LogicOperator, LoopTypes, MachineProgram, RoutineId,
};
use crate::raw::narrow;

/// Runs one [`MachineProgram`]. Variables keep their values from scan to scan; a machine that has stopped may be
/// asked for the values so far.
#[derive(Debug)]
pub struct Machine<'p> {
    pub(super) program: &'p MachineProgram,
    pub(super) memory: MachineMemory<'p>,
    pub(super) operands: Vec<u64>,
    pub(super) texts: Vec<Text<'p>>,
    frames: Vec<CallFrame>,
    /// The routines that are being executed, where the program chooses methods as it runs.
    active: Vec<bool>,
    /// The next instruction.
    next: Label,
    /// The first instruction whose step has not been counted yet: steps are counted where control jumps.
    uncounted: Label,
    this: Address,
    steps_left: u64,
}

/// The state that a return goes back to.
#[derive(Clone, Copy, Debug)]
struct CallFrame {
    this: Address,
    next: Label,
    /// The routine that has been called.
    routine: RoutineId,
}

impl<'p> Machine<'p> {
    /// A machine whose memory is all zero; `step_limit` is for the whole run.
    pub fn new(program: &'p MachineProgram, step_limit: u64) -> Machine<'p> {
        Machine {
            program,
            memory: MachineMemory::new(program.memory, &program.texts),
            operands: Vec::with_capacity(16),
            texts: Vec::new(),
            frames: Vec::new(),
            active: Vec::new(),
            next: 0,
            uncounted: 0,
            this: 0,
            steps_left: step_limit,
        }
    }

    /// Gives the variables their initial values.
    ///
    /// # Errors
    /// See [`Stop`]; an initial value may be computed, and so may fault.
    pub fn startup(&mut self) -> Result<(), Stop> {
        self.run(self.program.startup)
    }

    /// Runs all program instances once.
    ///
    /// # Errors
    /// See [`Stop`].
    pub fn scan(&mut self) -> Result<(), Stop> {
        self.run(self.program.scan)
    }

    /// The raw form in a cell; `None` where there is no such cell.
    pub fn plain(&self, address: Address) -> Option<u64> {
        self.memory.load(address).ok()
    }

    /// The text of a text cell, in code units; `None` where there is none.
    pub fn text(&self, address: Address) -> Option<&[u16]> {
        self.memory.text(address).ok()
    }

    /// Writes a raw form into a cell, as the environment does between scans; `None` where there is no such cell.
    pub fn set_plain(&mut self, address: Address, value: u64) -> Option<()> {
        self.memory.store(address, value).ok()
    }

    /// Writes a text, cut to its variable's capacity; `None` where there is none.
    pub fn set_text(&mut self, address: Address, units: &[u16]) -> Option<()> {
        self.memory.store_text(address, units).ok()
    }

    fn run(&mut self, routine: RoutineId) -> Result<(), Stop> {
        self.operands.clear();
        self.texts.clear();
        self.frames.clear();
        if !self.program.methods.is_empty() {
            self.active = vec![false; self.program.routines.len()];
        }
        self.this = 0;
        self.enter(routine)
            .and_then(|()| self.execute())
            .map_err(|halt| self.stopped(halt))
    }

    /// Says where a halt happened: at the instruction before the next.
    fn stopped(&self, halt: Halt) -> Stop {
        let at = self.next.saturating_sub(1);
        match halt {
            Halt::Fault(kind) => {
                // A routine that only leads to a method has no line of its own; the call has.
                let calls = self.frames.iter().rev().map(|frame| frame.next.saturating_sub(1));
                let mut places = std::iter::once(at).chain(calls);
                let line = places.find_map(|at| {
                    let line = self.program.lines.get(at as usize).copied();
                    line.filter(|line| *line > 0)
                });
                let line = line.unwrap_or(0);
                Stop::Fault(RaisedFault { kind, line })
            }
            Halt::Missing(what) => Stop::Inconsistent(Inconsistency { what, at }),
        }
    }

    fn execute(&mut self) -> Result<(), Halt> {
        let program = self.program;
        loop {
            let instruction = *program
                .code
                .get(self.next as usize)
                .ok_or(Halt::Missing("instruction at this label"))?;
            self.next += 1;
            match instruction {
                Instruction::Push(value) => self.operands.push(value),
                Instruction::PushText(index) => self.push_constant(index)?,
                Instruction::Drop => drop(self.pop()?),
                Instruction::DropText => drop(self.pop_text()?),
                Instruction::Swap => {
                    let (first, second) = self.pop_pair()?;
                    self.operands.extend([second, first]);
                }

                Instruction::Address(address) => self.operands.push(address.into()),
                Instruction::InstanceAddress(offset) => {
                    self.operands.push(self.this.wrapping_add(offset).into());
                }
                Instruction::Dereference | Instruction::LoadIndirect => {
                    let address = self.pop_address()?;
                    self.operands.push(self.memory.load(address)?);
                }
                Instruction::Offset(offset) => {
                    let address = self.pop()?;
                    self.operands.push(address.wrapping_add(offset.into()));
                }
                Instruction::Subscript {
                    low,
                    high,
                    stride,
                    unsigned,
                } => {
                    let subscript = self.pop()?;
                    let address = self.pop()?;
                    let element = element(subscript, (low, high), unsigned)?;
                    let offset = element.wrapping_mul(stride.into());
                    self.operands.push(address.wrapping_add(offset));
                }

                Instruction::SubscriptWithin { unsigned } => {
                    let (high, stride) = self.pop_pair()?;
                    let low = self.pop()?;
                    let (address, subscript) = self.pop_pair()?;
                    let limits = (low.cast_signed(), high.cast_signed());
                    let offset = element(subscript, limits, unsigned)?.wrapping_mul(stride);
                    self.operands.push(address.wrapping_add(offset));
                }

                Instruction::Load(address) => self.operands.push(self.memory.load(address)?),
                Instruction::Store(address) => {
                    let value = self.pop()?;
                    self.memory.store(address, value)?;
                }
                Instruction::StoreIndirect => {
                    let value = self.pop()?;
                    let address = self.pop_address()?;
                    self.memory.store(address, value)?;
                }
                Instruction::LoadText => self.load_text()?,
                Instruction::StoreText => self.store_text()?,
                Instruction::Character { of, unsigned } => self.find_character(of, unsigned)?,
                Instruction::LoadCharacter => self.load_character()?,
                Instruction::StoreCharacter(of) => self.store_character(of)?,
                Instruction::Copy(count) => self.copy(count)?,
                Instruction::Replicate { stride, count } => self.replicate(stride, count)?,
                Instruction::Clear(count) => {
                    let address = self.pop_address()?;
                    self.spend(count.into())?;
                    self.memory.clear(address, count)?;
                }

                Instruction::AddressOf => self.address_of()?,
                Instruction::Locate(layout) => self.locate(layout)?,
                Instruction::Peek(layout) => self.peek(layout)?,
                Instruction::Poke(layout) => self.poke(layout)?,
                Instruction::Gather(layout) => self.transfer(layout, true)?,
                Instruction::Scatter(layout) => self.transfer(layout, false)?,

                Instruction::Part(part) => {
                    let value = self.pop()?;
                    self.operands.push(narrow(value >> (part.first & 63), part.ty));
                }
                Instruction::StorePart { part, of } => self.store_part(part, of)?,

                Instruction::Convert(conversion) => self.convert(conversion)?,
                Instruction::TryConvert(conversion) => {
                    let value = conversion.spelled(&self.pop_text()?);
                    self.operands.extend([value.unwrap_or(0), value.is_some().into()]);
                }
                Instruction::Format(from) => self.format(from)?,
                Instruction::Concatenate(concatenation) => {
                    let (date, time) = self.pop_pair()?;
                    self.operands.push(concatenation.apply_two(date, time));
                }
                Instruction::Arithmetic(operator, ty) => {
                    let (left, right) = self.pop_pair()?;
                    self.operands
                        .push(arithmetic::arithmetic(operator, ty, left, right)?);
                }
                Instruction::ScaleDuration(operator, ty, is_least) => {
                    let pair = self.pop_pair()?;
                    self.operands.push(duration::scale(operator, ty, pair, is_least)?);
                }
                Instruction::Power {
                    base,
                    exponent,
                    stops,
                } => {
                    let (left, right) = self.pop_pair()?;
                    self.operands
                        .push(power::power((base, left), (exponent, right), stops)?);
                }
                Instruction::Compare(operator, ty) => {
                    let (left, right) = self.pop_pair()?;
                    self.operands
                        .push(comparison::compare(operator, ty, left, right).into());
                }
                Instruction::CompareText(operator) => self.compare_texts(operator)?,
                Instruction::Logic(operator) => {
                    let (left, right) = self.pop_pair()?;
                    self.operands.push(match operator {
                        LogicOperator::And => left & right,
                        LogicOperator::Or => left | right,
                        LogicOperator::Xor => left ^ right,
                    });
                }
                Instruction::Not(ty) => {
                    let value = self.pop()?;
                    self.operands.push(complement(value, ty));
                }
                Instruction::Negate(ty) => {
                    let value = self.pop()?;
                    self.operands.push(arithmetic::negate(ty, value));
                }
                Instruction::CheckRange { low, high, unsigned } => {
                    let value = self.pop()?;
                    if !in_range(value, low, high, unsigned) {
                        return Err(FaultKind::Subrange.into());
                    }
                    self.operands.push(value);
                }
                Instruction::LoopTest(types) => {
                    let counting = self.pop_counting(types)?;
                    self.operands.push(counting.begins().into());
                }
                Instruction::LoopStep(types) => {
                    let (control, goes_on) = self.pop_counting(types)?.next();
                    self.operands.extend([control, goes_on.into()]);
                }
                Instruction::Standard {
                    function,
                    of,
                    count,
                    numbers,
                } => self.standard(function, of, count.into(), numbers.into())?,

                Instruction::Jump(label) => self.go_to(label)?,
                Instruction::JumpIfFalse(label) => {
                    if self.pop()? == 0 {
                        self.go_to(label)?;
                    }
                }
                Instruction::Call(routine) => {
                    self.push_frame(routine)?;
                    self.enter(routine)?;
                }
                Instruction::CallInstance(routine) => {
                    let this = self.pop_address()?;
                    self.push_frame(routine)?;
                    self.this = this;
                    self.enter(routine)?;
                }
                Instruction::CallMethod(method) => {
                    let this = self.pop_address()?;
                    let routine = self.find_method(this, method)?;
                    self.push_frame(routine)?;
                    self.this = this;
                    self.enter(routine)?;
                }
                Instruction::Return => match self.frames.pop() {
                    Some(frame) => {
                        if let Some(active) = self.active.get_mut(frame.routine as usize) {
                            *active = false;
                        }
                        self.go_to(frame.next)?;
                        self.this = frame.this;
                    }
                    None => return self.go_to(self.next),
                },
            }
        }
    }

    /// Counts the steps since control last jumped, and goes on at a label.
    #[inline]
    fn go_to(&mut self, label: Label) -> Result<(), Halt> {
        self.spend(self.next.saturating_sub(self.uncounted).into())?;
        self.next = label;
        self.uncounted = label;
        Ok(())
    }

    #[inline]
    pub(super) fn spend(&mut self, steps: u64) -> Result<(), Halt> {
        match self.steps_left.checked_sub(steps) {
            Some(left) => {
                self.steps_left = left;
                Ok(())
            }
            None => {
                self.steps_left = 0;
                Err(FaultKind::StepLimit.into())
            }
        }
    }

    /// A text costs a step for each eight code units, about what it takes to copy them.
    pub(super) fn spend_on_text(&mut self, units: u64) -> Result<(), Halt> {
        self.spend(units / 8)
    }

    fn enter(&mut self, routine: RoutineId) -> Result<(), Halt> {
        let label = *self
            .program
            .routines
            .get(routine as usize)
            .ok_or(Halt::Missing("routine of this number"))?;
        if self.frames.is_empty() {
            (self.next, self.uncounted) = (label, label);
            return Ok(());
        }
        self.go_to(label)
    }

    /// Finds the method of an instance, in its type or in those that the type extends.
    fn find_method(&mut self, this: Address, method: u32) -> Result<RoutineId, Halt> {
        let mut ty = match this {
            0 => 0,
            _ => self.memory.load(this)? as u32,
        };
        while ty != 0 {
            if let Some(routine) = self.program.methods.get(&(ty, method)) {
                return Ok(*routine);
            }
            self.spend(1)?;
            ty = self.program.bases.get(&ty).copied().unwrap_or(0);
        }
        Err(FaultKind::NullDereference.into())
    }

    /// Recursion is rejected, so no more frames than routines can be open. Where methods are chosen as the program runs, it is a fault.
    fn push_frame(&mut self, routine: RoutineId) -> Result<(), Halt> {
        if let Some(active) = self.active.get_mut(routine as usize)
            && std::mem::replace(active, true)
        {
            return Err(FaultKind::Recursion.into());
        }
        if self.frames.len() > self.program.routines.len() {
            return Err(Halt::Missing("end to its calls"));
        }
        self.frames.push(CallFrame {
            this: self.this,
            next: self.next,
            routine,
        });
        Ok(())
    }

    /// Returns whether a routine has been called and has not returned.
    pub(super) fn is_running(&self, routine: RoutineId) -> bool {
        self.frames.iter().any(|frame| frame.routine == routine)
    }

    #[inline]
    pub(super) fn pop(&mut self) -> Result<u64, Halt> {
        self.operands.pop().ok_or(Halt::Missing("operand"))
    }

    /// Gives what was pushed first first.
    #[inline]
    pub(super) fn pop_pair(&mut self) -> Result<(u64, u64), Halt> {
        let second = self.pop()?;
        Ok((self.pop()?, second))
    }

    fn pop_counting(&mut self, types: LoopTypes) -> Result<LoopCounter, Halt> {
        let (limit, step) = self.pop_pair()?;
        Ok(LoopCounter::new(types, [self.pop()?, limit, step]))
    }

    #[inline]
    pub(super) fn pop_address(&mut self) -> Result<Address, Halt> {
        Address::try_from(self.pop()?).map_err(|_| Halt::Missing("cell at this address"))
    }

    pub(super) fn pop_text(&mut self) -> Result<Text<'p>, Halt> {
        self.texts.pop().ok_or(Halt::Missing("text operand"))
    }
}

/// Counts the elements before the one with this subscript.
pub(super) fn element(subscript: u64, (low, high): (i64, i64), unsigned: bool) -> Result<u64, Halt> {
    let value = subscript.cast_signed();
    // No dimension reaches beyond an i64, so an unsigned subscript that does lies outside.
    let beyond = unsigned && value < 0;
    if !beyond && (low..=high).contains(&value) {
        Ok(subscript.wrapping_sub(low.cast_unsigned()))
    } else {
        Err(FaultKind::SubscriptRange.into())
    }
}

/// Returns whether a raw form lies in a subrange of its integer type.
fn in_range(value: u64, low: i64, high: u64, unsigned: bool) -> bool {
    if unsigned {
        (low.cast_unsigned()..=high).contains(&value)
    } else {
        (low..=high.cast_signed()).contains(&value.cast_signed())
    }
}
