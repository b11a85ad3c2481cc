//! Calls of functions, and invocations of the instances of function blocks.

use super::evaluator::{Activation, ModelEvaluator};
use super::memory::{Address, MemoryCell};
use super::{Evaluated, OpenQuestion, ill_formed};
use crate::model::{Argument, ExpressionKind, Place, Pou, Type, VariableId, VariableSection};

impl<'p> ModelEvaluator<'p> {
    /// Calls a function and returns its result.
    ///
    /// Basis: iec-61131-3: 6.6.1 (variables of a function start afresh with each call; an input without an argument has its
    /// initial value).
    pub fn call(&mut self, function: usize, arguments: &'p [Argument]) -> Evaluated<MemoryCell> {
        let missing = ill_formed("a call of an undeclared function");
        let called = self.program.functions.get(function).ok_or(missing)?;
        if called.result.is_none() {
            return Err(missing);
        }
        // The arguments are evaluated while the callee's variables are not there yet: an argument may be a call itself.
        let given = self.arguments(called, arguments)?;
        let unit = Activation {
            pou: called,
            at: vec![self.memory.len()],
        };
        self.within(unit, |evaluator| {
            evaluator.enter(function)?;
            evaluator.write_all(given)?;
            evaluator.statements(&called.body)
        })?;
        match self.memory.pop() {
            Some(MemoryCell::Parts(mut parts)) => parts.pop().ok_or(missing),
            _ => Err(missing),
        }
    }

    /// Appends the variables of a function in their initial state.
    fn enter(&mut self, function: usize) -> Evaluated<()> {
        if let Some(image) = self.images.get(function).and_then(Option::clone) {
            self.memory.push(image);
            return Ok(());
        }
        self.memory.push(MemoryCell::Plain(0));
        self.start()?;
        let image = self.at(&self.unit.at)?.clone();
        if let Some(slot) = self.images.get_mut(function) {
            *slot = Some(image);
        }
        Ok(())
    }

    /// Evaluates arguments, each with the number of its parameter.
    fn arguments(
        &mut self,
        callee: &'p Pou,
        arguments: &'p [Argument],
    ) -> Evaluated<Vec<(usize, MemoryCell)>> {
        let unknown = ill_formed("an argument for an undeclared parameter");
        let given = arguments.iter().map(|argument| {
            let VariableId(number) = argument.parameter;
            let parameter = callee.variables.get(number).ok_or(unknown)?;
            let value = match (parameter.section, &argument.value.kind) {
                (VariableSection::InOut, ExpressionKind::Read(place)) => {
                    MemoryCell::Reference(self.locate(place)?)
                }
                (VariableSection::InOut, _) => {
                    return Err(ill_formed("an in-out argument that is not a variable"));
                }
                _ => self.expression(&argument.value)?,
            };
            Ok((number, value))
        });
        given.collect()
    }

    /// Writes values to the parameters of the unit.
    fn write_all(&mut self, given: Vec<(usize, MemoryCell)>) -> Evaluated<()> {
        let mut given = given.into_iter();
        given.try_for_each(|(number, value)| self.store(&self.unit.part(number), value))
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
        let (at, ty) = self.variable(instance)?;
        let Type::Block(index) = self.resolved(ty) else {
            return Err(missing);
        };
        let unit = self.instance(*index, at)?;
        let given = self.arguments(unit.pou, inputs)?;
        self.check_in_outs(unit.pou, &given);
        let targets = self.places(outputs)?;
        self.within(unit.clone(), |evaluator| {
            evaluator.write_all(given)?;
            evaluator.set_clock(&unit)?;
            evaluator.statements(&unit.pou.body)?;
            evaluator.check_timer(&unit)
        })?;
        self.capture(&unit, outputs, &targets)
    }

    /// Returns the place of a variable of a standard function block; `None` where it has no such one.
    fn of_standard(unit: &Activation<'p>, name: &str) -> Option<Address> {
        let mut variables = unit.pou.variables.iter();
        let number = variables.position(|variable| variable.name == name)?;
        unit.pou.standard.then(|| unit.part(number))
    }

    /// Gives a timer the time.
    fn set_clock(&mut self, unit: &Activation<'p>) -> Evaluated<()> {
        let now = MemoryCell::Plain(self.clock.cast_unsigned());
        Self::of_standard(unit, "clock").map_or(Ok(()), |clock| self.store(&clock, now))
    }

    /// Raises a question where no source says what a timer gives.
    fn check_timer(&mut self, unit: &Activation<'p>) -> Evaluated<()> {
        if let Some(unsettled) = Self::of_standard(unit, "unsettled")
            && *self.at(&unsettled)? != MemoryCell::Plain(0)
        {
            self.open(OpenQuestion::Timer, || unit.pou.name.clone());
        }
        Ok(())
    }

    /// Raises a question where two in-outs of one invocation share a variable: copying in and out would differ from references.
    fn check_in_outs(&mut self, callee: &Pou, given: &[(usize, MemoryCell)]) {
        let mut taken: Vec<&Address> = Vec::new();
        for (_, value) in given {
            if let MemoryCell::Reference(address) = value {
                let is_shared = |other: &&Address| other.starts_with(address) || address.starts_with(other);
                if taken.iter().any(is_shared) {
                    self.open(OpenQuestion::AliasedInOut, || callee.name.clone());
                }
                taken.push(address);
            }
        }
    }

    fn places(&mut self, outputs: &'p [(VariableId, Place)]) -> Evaluated<Vec<Address>> {
        outputs.iter().map(|(_, place)| self.locate(place)).collect()
    }

    /// Copies the outputs to their places, and raises a question where the invocation has moved a place.
    fn capture(
        &mut self,
        callee: &Activation<'p>,
        outputs: &'p [(VariableId, Place)],
        before: &[Address],
    ) -> Evaluated<()> {
        let after = self.places(outputs)?;
        if after != before {
            self.open(OpenQuestion::OutputPlace, || callee.pou.name.clone());
        }
        for ((output, _), at) in outputs.iter().zip(after) {
            let value = self.within(callee.clone(), |evaluator| {
                let (from, _) = evaluator.variable(*output)?;
                evaluator.load(&from)
            })?;
            self.store(&at, value)?;
        }
        Ok(())
    }
}
