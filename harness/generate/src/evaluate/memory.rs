//! The places of a program in memory, and the values at the end.

use super::cell::{Address, MemoryCell};
use super::evaluator::ModelEvaluator;
use super::{Evaluated, EvaluationError, ill_formed};
use crate::model::{ArrayType, Place, PlaceSelector, Type, VariableId, VariableSection};
use stickler_types::{Fault, Value};

/// The maximum number of elementary values in the variables of a unit.
const MAX_CELLS: usize = 1 << 20;

const NO_PLACE: EvaluationError = ill_formed("a place outside the memory");

impl<'p> ModelEvaluator<'p> {
    /// Returns the place of a variable; for an in-out, that of the variable of the caller.
    pub fn variable(&self, id: VariableId) -> Evaluated<(Address, &'p Type)> {
        let unknown = ill_formed("a variable that its unit does not have");
        let variable = self.unit.pou.variables.get(id.0).ok_or(unknown)?;
        let own = self.unit.part(id.0);
        if variable.section != VariableSection::InOut {
            return Ok((own, &variable.ty));
        }
        match self.at(&own)? {
            MemoryCell::Reference(address) => Ok((address.clone(), &variable.ty)),
            _ => Err(ill_formed("an in-out with nothing behind it")),
        }
    }

    /// Evaluates the subscripts of a place and returns its address.
    pub fn locate(&mut self, place: &'p Place) -> Evaluated<Address> {
        let (mut address, mut ty) = self.variable(place.variable)?;
        for selector in &place.path {
            address.push(match selector {
                PlaceSelector::Index(_) => self.element(self.resolved(ty), selector)?,
                PlaceSelector::Field(field) => *field,
                PlaceSelector::Output(output) => output.0,
            });
            let nothing = ill_formed("a selection of something that its type does not have");
            ty = self.program.selected_type(ty, selector).ok_or(nothing)?;
        }
        Ok(address)
    }

    /// Evaluates subscripts and returns the number of the element, the last subscript varying fastest.
    fn element(&mut self, ty: &'p Type, selector: &'p PlaceSelector) -> Evaluated<usize> {
        let (PlaceSelector::Index(subscripts), Type::Array(array)) = (selector, ty) else {
            return Err(ill_formed("a subscript of something that is no array"));
        };
        if subscripts.len() != array.dimensions.len() {
            return Err(ill_formed("other subscripts than the array has dimensions"));
        }
        let mut element = 0;
        for (subscript, &(low, high)) in subscripts.iter().zip(&array.dimensions) {
            let at = self.integer(subscript)?;
            if !(i128::from(low)..=i128::from(high)).contains(&at) {
                return Err(EvaluationError::Fault(Fault::SubscriptRange));
            }
            let inside = usize::try_from(at - i128::from(low)).map_err(|_| NO_PLACE)?;
            element = element * extent((low, high))? + inside;
        }
        Ok(element)
    }

    /// Returns the content of a place.
    pub fn at(&self, address: &[usize]) -> Evaluated<&MemoryCell> {
        let (first, path) = address.split_first().ok_or(NO_PLACE)?;
        path.iter()
            .try_fold(
                self.memory.get(*first).ok_or(NO_PLACE)?,
                |cell, part| match cell {
                    MemoryCell::Parts(parts) => parts.get(*part),
                    _ => None,
                },
            )
            .ok_or(NO_PLACE)
    }

    /// Reads a place, and records its question if it is unsettled. An array or a structure is copied unchanged: its unsettled parts
    /// stay unsettled until they are read.
    pub fn load(&mut self, address: &[usize]) -> Evaluated<MemoryCell> {
        let cell = self.at(address)?.clone();
        Ok(self.settled(cell, "it is read"))
    }

    /// Returns the content of a place, or the result of a call, and records its question if it is unsettled.
    pub fn settled(&mut self, cell: MemoryCell, what: &str) -> MemoryCell {
        match cell {
            MemoryCell::Unsettled(raw, question) => {
                self.open(question, || what.to_owned());
                MemoryCell::Plain(raw)
            }
            settled => settled,
        }
    }

    /// Writes a place.
    pub fn store(&mut self, address: &[usize], cell: MemoryCell) -> Evaluated<()> {
        let (first, path) = address.split_first().ok_or(NO_PLACE)?;
        let mut into = self.memory.get_mut(*first).ok_or(NO_PLACE)?;
        for part in path {
            let MemoryCell::Parts(parts) = into else {
                return Err(NO_PLACE);
            };
            into = parts.get_mut(*part).ok_or(NO_PLACE)?;
        }
        *into = cell;
        Ok(())
    }

    /// Returns the values of [`Program::observed`](crate::model::Program::observed), in its order.
    pub fn values(&mut self) -> Evaluated<Vec<(String, Value)>> {
        let observed = self.program.observed_parts().into_iter();
        observed
            .map(|part| {
                let address = [&[0], &part.numbers[..]].concat();
                Ok((part.path, self.load(&address)?.into_value(part.ty)?))
            })
            .collect()
    }
}

/// Returns the number of elements of an array.
pub(super) fn elements(array: &ArrayType) -> Evaluated<usize> {
    array.dimensions.iter().try_fold(1_usize, |product, dimension| {
        limited(product.saturating_mul(extent(*dimension)?))
    })
}

/// Returns the number of subscripts of a dimension.
fn extent((low, high): (i64, i64)) -> Evaluated<usize> {
    let extent = i128::from(high) - i128::from(low) + 1;
    if extent < 1 {
        return Err(ill_formed("an array without elements"));
    }
    limited(usize::try_from(extent).unwrap_or(usize::MAX))
}

/// Returns a number of elementary values, unless a unit has more than so small a program needs.
pub(super) fn limited(size: usize) -> Evaluated<usize> {
    match size {
        ..=MAX_CELLS => Ok(size),
        _ => Err(EvaluationError::StepLimit),
    }
}
