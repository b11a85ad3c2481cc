//! Calls of functions, and invocations of the instances of function blocks.

use super::cell::MemoryCell;
use super::evaluator::{Activation, ModelEvaluator};
use super::{EvaluationError, OpenQuestion, ill_formed};
use crate::model::{Argument, ExpressionKind, Place, Type, VariableId, VariableSection};
use std::rc::Rc;

impl<'p> ModelEvaluator<'p> {
    /// Calls a function and returns the cells of its result.
    ///
    /// Basis: iec-61131-3: 6.6.1 (variables of a function start afresh with each call; an input without an argument has its
    /// initial value).
    pub fn call(
        &mut self,
        caller: Activation<'p>,
        function: usize,
        arguments: &'p [Argument],
    ) -> Result<Vec<MemoryCell>, EvaluationError> {
        let missing = ill_formed("a call of an undeclared function");
        let called = self.program.functions.get(function).ok_or(missing)?;
        let offsets = self.layout.functions.get(function).ok_or(missing)?;
        let base = self.memory.len();
        let size = self.layout.size(&called.result)?;
        let unit = Activation {
            name: &called.name,
            variables: &called.variables,
            offsets,
            base,
            result: Some((base + offsets.size, &called.result)),
        };
        // The arguments are evaluated while the callee's cells are not there yet: an argument may be a call itself.
        let given = self.arguments(caller, unit, arguments)?;
        self.enter(unit, function)?;
        for (offset, cells) in given {
            self.write(base + offset, cells)?;
        }
        self.statements(unit, &called.body)?;
        let end = base + offsets.size;
        let result = self
            .memory
            .get(end..end + size)
            .map(<[MemoryCell]>::to_vec)
            .ok_or(missing)?;
        self.memory.truncate(base);
        Ok(result)
    }

    /// Appends the cells of a function in their initial state, followed by those of its result.
    fn enter(&mut self, unit: Activation<'p>, function: usize) -> Result<(), EvaluationError> {
        if let Some(image) = self.images.get(function).and_then(Option::clone) {
            self.memory.extend_from_slice(&image);
            return Ok(());
        }
        self.start(unit)?;
        if let Some((at, ty)) = unit.result {
            let size = self.layout.size(ty)?;
            self.memory.resize(at + size, MemoryCell::Plain(0));
            self.default(unit, ty, at)?;
        }
        let image: Rc<[MemoryCell]> = self.memory.get(unit.base..).unwrap_or_default().into();
        if let Some(slot) = self.images.get_mut(function) {
            *slot = Some(image);
        }
        Ok(())
    }

    /// Evaluates arguments, each with the offset of its parameter.
    fn arguments(
        &mut self,
        caller: Activation<'p>,
        callee: Activation<'p>,
        arguments: &'p [Argument],
    ) -> Result<Vec<(usize, Vec<MemoryCell>)>, EvaluationError> {
        let unknown = ill_formed("an argument for an undeclared parameter");
        let mut given = Vec::with_capacity(arguments.len());
        for argument in arguments {
            let offset = *callee
                .offsets
                .variables
                .get(argument.parameter.0)
                .ok_or(unknown)?;
            let parameter = callee.variables.get(argument.parameter.0).ok_or(unknown)?;
            let cells = if parameter.section == VariableSection::InOut {
                vec![self.behind(caller, argument)?]
            } else {
                self.cells(caller, &argument.value)?
            };
            given.push((offset, cells));
        }
        Ok(given)
    }

    /// Returns the address of the variable that an in-out argument refers to.
    fn behind(
        &mut self,
        caller: Activation<'p>,
        argument: &'p Argument,
    ) -> Result<MemoryCell, EvaluationError> {
        let ExpressionKind::Read(place) = &argument.value.kind else {
            return Err(ill_formed("an in-out argument that is not a variable"));
        };
        let address = self.locate(caller, place)?;
        Ok(MemoryCell::Plain(address as u64))
    }

    fn write(&mut self, address: usize, cells: Vec<MemoryCell>) -> Result<(), EvaluationError> {
        for (index, cell) in cells.into_iter().enumerate() {
            self.store(address + index, cell)?;
        }
        Ok(())
    }

    /// Invokes an instance: copies the inputs, executes the body, copies the outputs. Inputs that are not given keep their
    /// values.
    ///
    /// Basis: iec-61131-3: 6.6.3.
    pub fn invoke(
        &mut self,
        caller: Activation<'p>,
        instance: VariableId,
        inputs: &'p [Argument],
        outputs: &'p [(VariableId, Place)],
    ) -> Result<(), EvaluationError> {
        let missing = ill_formed("an invocation of a variable that is not an instance");
        let (base, ty) = self.variable(caller, instance)?;
        let Type::Block(index) = self.resolved(ty) else {
            return Err(missing);
        };
        let block = self.program.blocks.get(*index).ok_or(missing)?;
        let unit = Activation {
            name: &block.name,
            variables: &block.variables,
            offsets: self.layout.blocks.get(*index).ok_or(missing)?,
            base,
            result: None,
        };
        let given = self.arguments(caller, unit, inputs)?;
        for (offset, cells) in given {
            self.write(base + offset, cells)?;
        }
        self.check_in_outs(caller, unit, inputs)?;
        let targets = self.places(caller, outputs)?;
        self.statements(unit, &block.body)?;
        self.capture(caller, unit, outputs, &targets)
    }

    /// Raises a question where two in-outs of one invocation share a cell: copying in and out would differ from references.
    fn check_in_outs(
        &mut self,
        caller: Activation<'p>,
        callee: Activation<'p>,
        inputs: &'p [Argument],
    ) -> Result<(), EvaluationError> {
        let mut taken: Vec<std::ops::Range<usize>> = Vec::new();
        for argument in inputs {
            let is_in_out = callee
                .variables
                .get(argument.parameter.0)
                .is_some_and(|parameter| parameter.section == VariableSection::InOut);
            if !is_in_out {
                continue;
            }
            let (start, ty) = self.variable(callee, argument.parameter)?;
            let cells = start..start + self.layout.size(ty)?;
            if taken
                .iter()
                .any(|other| other.start < cells.end && cells.start < other.end)
            {
                self.open(OpenQuestion::AliasedInOut, caller, || callee.name.to_owned());
            }
            taken.push(cells);
        }
        Ok(())
    }

    fn places(
        &mut self,
        caller: Activation<'p>,
        outputs: &'p [(VariableId, Place)],
    ) -> Result<Vec<usize>, EvaluationError> {
        outputs
            .iter()
            .map(|(_, place)| self.locate(caller, place))
            .collect()
    }

    /// Copies the outputs to their places, and raises a question where the invocation has moved a place.
    fn capture(
        &mut self,
        caller: Activation<'p>,
        callee: Activation<'p>,
        outputs: &'p [(VariableId, Place)],
        before: &[usize],
    ) -> Result<(), EvaluationError> {
        let after = self.places(caller, outputs)?;
        if after != before {
            self.open(OpenQuestion::OutputPlace, caller, || callee.name.to_owned());
        }
        for ((output, _), at) in outputs.iter().zip(after) {
            let (from, ty) = self.variable(callee, *output)?;
            for index in 0..self.layout.size(ty)? {
                let cell = self.load(callee, from + index)?;
                self.store(at + index, cell)?;
            }
        }
        Ok(())
    }
}
