//! The memory of a program: a cell for each elementary value, lists of cells for arrays, structures and units, the places of a program in
//! them, and the values at the end.

use super::evaluator::ModelEvaluator;
use super::{Evaluated, EvaluationError, OpenQuestion, ill_formed};
use crate::model::{ArrayType, Place, PlaceSelector, Type, VariableId, VariableSection};
use stickler_types::{ElementaryType, Fault, Value};

/// A place in memory: the number of a unit under execution, then that of a part, of a part of this one, and so on.
pub(super) type Address = Vec<usize>;

/// The content of a variable, or of a part of one.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum MemoryCell {
    /// The raw form of a value (see [`ElementaryType`]), or the index of an enumerated value.
    Plain(u64),
    /// The code units of a text.
    Text(Box<[u16]>),
    /// A value that no document settles, until the variable is assigned: a guess, and the question that it depends on.
    Unsettled(u64, OpenQuestion),
    /// The elements of an array, the last subscript varying fastest; the fields of a structure; or the variables of a unit, behind
    /// which stands the result of a function.
    Parts(Vec<MemoryCell>),
    /// The variable that an in-out stands for, or a reference leads to.
    Reference(Address),
}

impl MemoryCell {
    /// Converts the content to a value of an elementary type.
    pub fn into_value(self, ty: ElementaryType) -> Evaluated<Value> {
        match self {
            MemoryCell::Plain(raw) | MemoryCell::Unsettled(raw, _) if !ty.is_text() => {
                Ok(Value::plain(ty, raw))
            }
            MemoryCell::Text(units) if ty.is_text() => Ok(Value::text(ty, units.into_vec())),
            _ => Err(ill_formed("a text where a number is stored, or the reverse")),
        }
    }

    /// Creates the cell of an elementary value.
    pub fn of_value(value: Value) -> Evaluated<MemoryCell> {
        match value {
            Value::Plain { raw, .. } => Ok(MemoryCell::Plain(raw)),
            Value::Text { units, .. } => Ok(MemoryCell::Text(units.into_boxed_slice())),
            Value::Enumerated { .. } | Value::OutOfRange { .. } | Value::Near { .. } => {
                Err(ill_formed("a value without a literal of its own"))
            }
        }
    }

    /// Creates the cell of a unit or a structure with so many parts, which get their contents afterwards.
    pub fn of_parts(number: usize) -> MemoryCell {
        MemoryCell::Parts(vec![MemoryCell::Plain(0); number])
    }

    /// Returns the number of elementary values.
    pub fn size(&self) -> usize {
        match self {
            MemoryCell::Parts(parts) => parts.iter().map(MemoryCell::size).sum(),
            _ => 1,
        }
    }
}

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
            match selector {
                PlaceSelector::Index(_) => address.push(self.element(self.resolved(ty), selector)?),
                PlaceSelector::Field(field) => address.push(*field),
                PlaceSelector::Output(output) => address.push(output.0),
                PlaceSelector::Followed => match self.at(&address)? {
                    MemoryCell::Reference(to) => address = to.clone(),
                    _ => return Err(EvaluationError::Fault(Fault::NullDereference)),
                },
            }
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
