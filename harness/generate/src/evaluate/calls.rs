//! Calls of functions, and invocations of the instances of function blocks.

use super::cell::MemoryCell;
use super::evaluator::{Activation, ModelEvaluator};
use super::{Evaluated, OpenQuestion, ill_formed};
use crate::model::{Argument, ExpressionKind, Place, Type, VariableId, VariableSection};
use std::ops::Range;
use std::rc::Rc;

impl<'p> ModelEvaluator<'p> {
    /// Calls a function and returns the cells of its result.
    ///
    /// Basis: iec-61131-3: 6.6.1 (variables of a function start afresh with each call; an input without an argument has its
    /// initial value).
    pub fn call(&mut self, function: usize, arguments: &'p [Argument]) -> Evaluated<Vec<MemoryCell>> {
        let missing = ill_formed("a call of an undeclared function");
        let called = self.program.functions.get(function).ok_or(missing)?;
        let offsets = self.layout.functions.get(function).ok_or(missing)?;
        let base = self.memory.len();
        let unit = Activation {
            pou: called,
            offsets,
            base,
        };
        let (end, ty) = unit.result().ok_or(missing)?;
        let size = self.layout.size(ty)?;
        // The arguments are evaluated while the callee's cells are not there yet: an argument may be a call itself.
        let given = self.arguments(unit, arguments)?;
        self.within(unit, |evaluator| {
            evaluator.enter(function)?;
            evaluator.write_all(given)?;
            evaluator.statements(&called.body)
        })?;
        let result = self.memory.get(end..end + size).ok_or(missing)?.to_vec();
        self.memory.truncate(base);
        Ok(result)
    }

    /// Appends the cells of a function in their initial state, followed by those of its result.
    fn enter(&mut self, function: usize) -> Evaluated<()> {
        if let Some(image) = self.images.get(function).and_then(Option::clone) {
            self.memory.extend_from_slice(&image);
            return Ok(());
        }
        self.start()?;
        if let Some((at, ty)) = self.unit.result() {
            let size = self.layout.size(ty)?;
            self.memory.resize(at + size, MemoryCell::Plain(0));
            self.default(ty, at)?;
        }
        let image: Rc<[MemoryCell]> = self.memory.get(self.unit.base..).unwrap_or_default().into();
        if let Some(slot) = self.images.get_mut(function) {
            *slot = Some(image);
        }
        Ok(())
    }

    /// Evaluates arguments, each with the first cell of its parameter.
    fn arguments(
        &mut self,
        callee: Activation<'p>,
        arguments: &'p [Argument],
    ) -> Evaluated<Vec<(usize, Vec<MemoryCell>)>> {
        let unknown = ill_formed("an argument for an undeclared parameter");
        let mut given = Vec::with_capacity(arguments.len());
        for argument in arguments {
            let VariableId(number) = argument.parameter;
            let offset = callee.offsets.variables.get(number).ok_or(unknown)?;
            let parameter = callee.pou.variables.get(number).ok_or(unknown)?;
            let cells = if parameter.section == VariableSection::InOut {
                vec![self.behind(argument)?]
            } else {
                self.cells(&argument.value)?
            };
            given.push((callee.base + offset, cells));
        }
        Ok(given)
    }

    /// Returns the address of the variable that an in-out argument refers to.
    fn behind(&mut self, argument: &'p Argument) -> Evaluated<MemoryCell> {
        let ExpressionKind::Read(place) = &argument.value.kind else {
            return Err(ill_formed("an in-out argument that is not a variable"));
        };
        let address = self.locate(place)?;
        Ok(MemoryCell::Plain(address as u64))
    }

    fn write_all(&mut self, given: Vec<(usize, Vec<MemoryCell>)>) -> Evaluated<()> {
        let mut given = given.into_iter();
        given.try_for_each(|(address, cells)| self.write(address, &cells))
    }

    /// Invokes an instance: copies the inputs, executes the body, copies the outputs. Inputs that are not given keep their
    /// values.
    ///
    /// Basis: iec-61131-3: 6.6.3.
    pub fn invoke(
        &mut self,
        instance: VariableId,
        inputs: &'p [Argument],
        outputs: &'p [(VariableId, Place)],
    ) -> Evaluated<()> {
        let missing = ill_formed("an invocation of a variable that is not an instance");
        let (base, ty) = self.variable(instance)?;
        let Type::Block(index) = self.resolved(ty) else {
            return Err(missing);
        };
        let unit = self.instance(*index, base)?;
        let given = self.arguments(unit, inputs)?;
        self.write_all(given)?;
        self.check_in_outs(unit, inputs)?;
        let targets = self.places(outputs)?;
        self.within(unit, |evaluator| evaluator.statements(&unit.pou.body))?;
        self.capture(unit, outputs, &targets)
    }

    /// Raises a question where two in-outs of one invocation share a cell: copying in and out would differ from references.
    fn check_in_outs(&mut self, callee: Activation<'p>, inputs: &'p [Argument]) -> Evaluated<()> {
        let mut taken: Vec<Range<usize>> = Vec::new();
        for argument in inputs {
            let parameter = callee.pou.variables.get(argument.parameter.0);
            if parameter.is_none_or(|parameter| parameter.section != VariableSection::InOut) {
                continue;
            }
            let (start, ty) = self.within(callee, |evaluator| evaluator.variable(argument.parameter))?;
            let cells = start..start + self.layout.size(ty)?;
            let is_shared = |other: &Range<usize>| other.start < cells.end && cells.start < other.end;
            if taken.iter().any(is_shared) {
                self.open(OpenQuestion::AliasedInOut, || callee.pou.name.clone());
            }
            taken.push(cells);
        }
        Ok(())
    }

    fn places(&mut self, outputs: &'p [(VariableId, Place)]) -> Evaluated<Vec<usize>> {
        outputs.iter().map(|(_, place)| self.locate(place)).collect()
    }

    /// Copies the outputs to their places, and raises a question where the invocation has moved a place.
    fn capture(
        &mut self,
        callee: Activation<'p>,
        outputs: &'p [(VariableId, Place)],
        before: &[usize],
    ) -> Evaluated<()> {
        let after = self.places(outputs)?;
        if after != before {
            self.open(OpenQuestion::OutputPlace, || callee.pou.name.clone());
        }
        for ((output, _), at) in outputs.iter().zip(after) {
            let cells = self.within(callee, |evaluator| {
                let (from, ty) = evaluator.variable(*output)?;
                let size = evaluator.layout.size(ty)?;
                (from..from + size)
                    .map(|address| evaluator.load(address))
                    .collect::<Evaluated<Vec<_>>>()
            })?;
            self.write(at, &cells)?;
        }
        Ok(())
    }
}
