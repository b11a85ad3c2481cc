//! Initial values: of types, of variables, and of the instances of function blocks.

use super::cell::MemoryCell;
use super::evaluator::{Activation, ModelEvaluator};
use super::{EvaluationError, OpenQuestion, ill_formed};
use crate::model::{InitialValue, Type, Variable, VariableSection};
use stickler_types::ElementaryType;

impl<'p> ModelEvaluator<'p> {
    /// Gives the variables of a unit their initial values, in cells that are appended to the memory at the base of the unit.
    pub fn start(&mut self, unit: Activation<'p>) -> Result<(), EvaluationError> {
        let end = unit.base + unit.offsets.size;
        if self.memory.len() < end {
            self.memory.resize(end, MemoryCell::Plain(0));
        }
        for (index, variable) in unit.variables.iter().enumerate() {
            // Each call sets the address of an in-out.
            if variable.section != VariableSection::InOut {
                let offset = unit.offsets.variables.get(index).copied().unwrap_or_default();
                self.start_variable(unit, variable, unit.base + offset)?;
            }
        }
        Ok(())
    }

    fn start_variable(
        &mut self,
        unit: Activation<'p>,
        variable: &'p Variable,
        at: usize,
    ) -> Result<(), EvaluationError> {
        self.default(unit, &variable.ty, at)?;
        match &variable.initial {
            None => Ok(()),
            Some(InitialValue::Expression(value)) => self.assign(unit, at, &variable.ty, value),
            Some(InitialValue::Array(values)) => {
                let Type::Array(array) = self.resolved(&variable.ty) else {
                    return Err(ill_formed("elements of a variable that is not an array"));
                };
                let size = self.layout.size(&array.element)?;
                if values.len() > super::layout::elements(array)? {
                    return Err(ill_formed("more initial values than the array has elements"));
                }
                for (element, value) in values.iter().enumerate() {
                    self.assign(unit, at + element * size, &array.element, value)?;
                }
                Ok(())
            }
            Some(InitialValue::Structure(fields)) => {
                let none = ill_formed("fields of a variable that is not a structure");
                let resolved = self.resolved(&variable.ty);
                let (Type::Declared(structure), Some(declared)) = (resolved, self.program.fields(resolved))
                else {
                    return Err(none);
                };
                for (field, value) in fields {
                    let offset = self.layout.field(*structure, *field).ok_or(none)?;
                    let (_, ty, _) = declared.get(*field).ok_or(none)?;
                    self.assign(unit, at + offset, ty, value)?;
                }
                Ok(())
            }
        }
    }

    /// Writes the initial value of a type.
    pub fn default(&mut self, unit: Activation<'p>, ty: &'p Type, at: usize) -> Result<(), EvaluationError> {
        match self.resolved(ty) {
            Type::Elementary(ty) => self.store(at, zero(*ty)),
            Type::Array(array) => {
                let size = self.layout.size(&array.element)?;
                for element in 0..super::layout::elements(array)? {
                    self.default(unit, &array.element, at + element * size)?;
                }
                Ok(())
            }
            resolved @ Type::Declared(index) => match self.program.fields(resolved) {
                Some(fields) => {
                    for (field, (_, ty, initial)) in fields.iter().enumerate() {
                        let offset = self.layout.field(*index, field).unwrap_or_default();
                        self.default(unit, ty, at + offset)?;
                        if let Some(value) = initial {
                            self.assign(unit, at + offset, ty, value)?;
                        }
                    }
                    Ok(())
                }
                // The first value of an enumeration.
                None => self.store(at, MemoryCell::Plain(0)),
            },
            Type::Block(index) => {
                let missing = ill_formed("an instance of an undeclared function block");
                let block = self.program.blocks.get(*index).ok_or(missing)?;
                let instance = Activation {
                    name: &block.name,
                    variables: &block.variables,
                    offsets: self.layout.blocks.get(*index).ok_or(missing)?,
                    base: at,
                    result: None,
                };
                self.deeper(|evaluator| evaluator.start(instance))
            }
        }
    }
}

/// Returns the initial value of an elementary type: 0, or the empty text.
///
/// A DATE and a DT begin with the year 1 in the second edition and with 1970 later, so no document settles their initial
/// value.
///
/// Basis: iec-61131-3: Table 10 (default initial values).
fn zero(ty: ElementaryType) -> MemoryCell {
    match ty {
        ElementaryType::Date | ElementaryType::Dt => MemoryCell::Unsettled(0, OpenQuestion::InitialDate),
        ty if ty.is_text() => MemoryCell::Text(Box::default()),
        _ => MemoryCell::Plain(0),
    }
}
