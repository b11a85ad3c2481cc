//! Initial values: of types, of variables, and of the instances of function blocks.

use super::cell::MemoryCell;
use super::evaluator::ModelEvaluator;
use super::{Evaluated, OpenQuestion, ill_formed};
use crate::model::{InitialValue, Type, Variable, VariableSection};
use stickler_types::ElementaryType;

impl<'p> ModelEvaluator<'p> {
    /// Gives the variables of the unit their initial values, in cells that are appended to the memory at its base.
    pub fn start(&mut self) -> Evaluated<()> {
        let unit = self.unit;
        let end = unit.base + unit.offsets.size;
        if self.memory.len() < end {
            self.memory.resize(end, MemoryCell::Plain(0));
        }
        for (index, variable) in unit.pou.variables.iter().enumerate() {
            // Each call sets the address of an in-out.
            if variable.section != VariableSection::InOut {
                let offset = unit.offsets.variables.get(index).copied().unwrap_or_default();
                self.start_variable(variable, unit.base + offset)?;
            }
        }
        Ok(())
    }

    fn start_variable(&mut self, variable: &'p Variable, at: usize) -> Evaluated<()> {
        self.default(&variable.ty, at)?;
        match &variable.initial {
            None => Ok(()),
            Some(InitialValue::Expression(value)) => self.assign(at, &variable.ty, value),
            Some(InitialValue::Array(values)) => {
                let Type::Array(array) = self.resolved(&variable.ty) else {
                    return Err(ill_formed("elements of a variable that is not an array"));
                };
                let size = self.layout.size(&array.element)?;
                if values.len() > super::layout::elements(array)? {
                    return Err(ill_formed("more initial values than the array has elements"));
                }
                for (element, value) in values.iter().enumerate() {
                    self.assign(at + element * size, &array.element, value)?;
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
                    self.assign(at + offset, ty, value)?;
                }
                Ok(())
            }
        }
    }

    /// Writes the initial value of a type.
    pub fn default(&mut self, ty: &'p Type, at: usize) -> Evaluated<()> {
        match self.resolved(ty) {
            Type::Elementary(ty) => self.store(at, zero(*ty)),
            Type::Array(array) => {
                let size = self.layout.size(&array.element)?;
                for element in 0..super::layout::elements(array)? {
                    self.default(&array.element, at + element * size)?;
                }
                Ok(())
            }
            resolved @ Type::Declared(index) => match self.program.fields(resolved) {
                Some(fields) => {
                    for (field, (_, ty, initial)) in fields.iter().enumerate() {
                        let offset = self.layout.field(*index, field).unwrap_or_default();
                        self.default(ty, at + offset)?;
                        if let Some(value) = initial {
                            self.assign(at + offset, ty, value)?;
                        }
                    }
                    Ok(())
                }
                // The first value of an enumeration.
                None => self.store(at, MemoryCell::Plain(0)),
            },
            Type::Block(index) => {
                let instance = self.instance(*index, at)?;
                self.deeper(|evaluator| evaluator.within(instance, Self::start))
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
