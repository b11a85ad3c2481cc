//! The places of a program in memory, and the values at the end.

use super::cell::MemoryCell;
use super::evaluator::ModelEvaluator;
use super::layout::extent;
use super::{Evaluated, EvaluationError, ill_formed};
use crate::model::{Place, PlaceSelector, Type, Unit, VariableId, VariableSection};
use stickler_types::{Fault, Value};

impl<'p> ModelEvaluator<'p> {
    /// Returns the first cell of a variable; for an in-out, that of the variable of the caller.
    pub fn variable(&self, id: VariableId) -> Evaluated<(usize, &'p Type)> {
        let unit = self.unit;
        let unknown = ill_formed("a variable that its unit does not have");
        let variable = unit.pou.variables.get(id.0).ok_or(unknown)?;
        let own = unit.base + unit.offsets.variables.get(id.0).ok_or(unknown)?;
        if variable.section != VariableSection::InOut {
            return Ok((own, &variable.ty));
        }
        match self.memory.get(own) {
            Some(MemoryCell::Plain(address)) => {
                Ok((usize::try_from(*address).map_err(|_| unknown)?, &variable.ty))
            }
            _ => Err(ill_formed("an in-out with nothing behind it")),
        }
    }

    /// Evaluates the subscripts of a place and returns its first cell.
    pub fn locate(&mut self, place: &'p Place) -> Evaluated<usize> {
        let (mut address, ty) = self.variable(place.variable)?;
        let mut ty = self.resolved(ty);
        for selector in &place.path {
            let (offset, selected) = self.select(ty, selector)?;
            address += offset;
            ty = self.resolved(selected);
        }
        Ok(address)
    }

    /// Resolves one selector: returns the offset and the type of the selected part.
    fn select(&mut self, ty: &'p Type, selector: &'p PlaceSelector) -> Evaluated<(usize, &'p Type)> {
        let nothing = ill_formed("a selection of something that its type does not have");
        match (selector, ty) {
            (PlaceSelector::Index(subscripts), Type::Array(array))
                if subscripts.len() == array.dimensions.len() =>
            {
                let mut element = 0;
                for (subscript, &(low, high)) in subscripts.iter().zip(&array.dimensions) {
                    let at = self.integer(subscript)?;
                    if !(i128::from(low)..=i128::from(high)).contains(&at) {
                        return Err(EvaluationError::Fault(Fault::SubscriptRange));
                    }
                    let inside = usize::try_from(at - i128::from(low)).map_err(|_| nothing)?;
                    element = element * extent((low, high))? + inside;
                }
                Ok((element * self.layout.size(&array.element)?, &array.element))
            }
            (PlaceSelector::Field(field), ty @ Type::Declared(structure)) => {
                let offset = self.layout.field(*structure, *field).ok_or(nothing)?;
                let fields = self.program.fields(ty).ok_or(nothing)?;
                Ok((offset, &fields.get(*field).ok_or(nothing)?.1))
            }
            (PlaceSelector::Output(output), Type::Block(block)) => {
                let offsets = self.layout.blocks.get(*block).ok_or(nothing)?;
                let block = self.program.blocks.get(*block).ok_or(nothing)?;
                let offset = offsets.variables.get(output.0).ok_or(nothing)?;
                Ok((*offset, &block.variables.get(output.0).ok_or(nothing)?.ty))
            }
            _ => Err(nothing),
        }
    }

    /// Reads a cell, and records its question if it is unsettled.
    pub fn load(&mut self, address: usize) -> Evaluated<MemoryCell> {
        let cell = self
            .memory
            .get(address)
            .ok_or(ill_formed("a place outside the memory"))?;
        if let MemoryCell::Unsettled(raw, question) = *cell {
            self.open(question, || "it is read".to_owned());
            return Ok(MemoryCell::Plain(raw));
        }
        Ok(cell.clone())
    }

    /// Writes cells from an address on.
    pub fn write(&mut self, address: usize, cells: &[MemoryCell]) -> Evaluated<()> {
        let into = self.memory.get_mut(address..address + cells.len());
        into.ok_or(ill_formed("a place outside the memory"))?
            .clone_from_slice(cells);
        Ok(())
    }

    /// Writes a cell.
    pub fn store(&mut self, address: usize, cell: MemoryCell) -> Evaluated<()> {
        let into = self
            .memory
            .get_mut(address)
            .ok_or(ill_formed("a place outside the memory"))?;
        *into = cell;
        Ok(())
    }

    /// Returns the values of [`Program::observed`](crate::model::Program::observed), in its order.
    pub fn values(&mut self) -> Evaluated<Vec<(String, Value)>> {
        let main = self.unit;
        let mut addresses = Vec::with_capacity(main.offsets.size);
        for (variable, &offset) in main.pou.variables.iter().zip(&main.offsets.variables) {
            self.observed(&variable.ty, main.base + offset, &mut addresses)?;
        }
        let values = self.program.observed().into_iter().zip(addresses);
        values
            .map(|((path, ty), address)| Ok((path, self.load(address)?.into_value(ty)?)))
            .collect()
    }

    /// Collects the addresses of the elementary values in a variable; of an instance those of its outputs.
    fn observed(&self, ty: &'p Type, address: usize, addresses: &mut Vec<usize>) -> Evaluated<()> {
        match self.resolved(ty) {
            Type::Elementary(_) => addresses.push(address),
            Type::Array(array) => {
                let size = self.layout.size(&array.element)?;
                for element in 0..super::layout::elements(array)? {
                    self.observed(&array.element, address + element * size, addresses)?;
                }
            }
            ty @ Type::Declared(index) => {
                for (field, (_, ty, _)) in self.program.fields(ty).unwrap_or_default().iter().enumerate() {
                    let offset = self.layout.field(*index, field).unwrap_or_default();
                    self.observed(ty, address + offset, addresses)?;
                }
            }
            Type::Block(index) => {
                let offsets = self.layout.blocks.get(*index).map(|block| &block.variables);
                let variables = Unit::Block(*index).variables(self.program).iter();
                for (variable, offset) in variables.zip(offsets.into_iter().flatten()) {
                    if variable.section == VariableSection::Output {
                        self.observed(&variable.ty, address + offset, addresses)?;
                    }
                }
            }
        }
        Ok(())
    }
}
