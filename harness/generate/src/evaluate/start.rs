//! Initial values: of types, of variables, and of the instances of function blocks.

use super::evaluator::ModelEvaluator;
use super::memory::{MemoryCell, elements, limited};
use super::{Evaluated, OpenQuestion, ill_formed};
use crate::model::{InitialValue, Type, Variable, VariableSection};
use stickler_types::ElementaryType;

impl<'p> ModelEvaluator<'p> {
    /// Gives the variables of the unit their initial values.
    pub fn start(&mut self) -> Evaluated<()> {
        let pou = self.unit.pou;
        let parts = pou.variables.len() + usize::from(pou.result.is_some());
        self.store(&self.unit.at.clone(), MemoryCell::of_parts(parts))?;
        let mut size = 0_usize;
        for (number, variable) in pou.variables.iter().enumerate() {
            // Each call sets the variable that an in-out stands for.
            if variable.section != VariableSection::InOut {
                let at = self.unit.part(number);
                self.start_variable(variable, &at)?;
                size = limited(size + self.at(&at)?.size())?;
            }
        }
        match &pou.result {
            Some(result) => {
                let default = self.default(result)?;
                self.store(&self.unit.part(parts - 1), default)
            }
            None => Ok(()),
        }
    }

    fn start_variable(&mut self, variable: &'p Variable, at: &[usize]) -> Evaluated<()> {
        if let Type::Block(index) = self.resolved(&variable.ty) {
            let instance = self.instance(*index, at.to_vec())?;
            return self.deeper(|evaluator| evaluator.within(instance, Self::start));
        }
        let default = self.default(&variable.ty)?;
        self.store(at, default)?;
        let values: Vec<_> = match &variable.initial {
            None => return Ok(()),
            Some(InitialValue::Expression(value)) => {
                let value = self.expression(value)?;
                return self.store(at, value);
            }
            Some(InitialValue::Array(values)) => values.iter().enumerate().collect(),
            Some(InitialValue::Structure(fields)) => {
                fields.iter().map(|(field, value)| (*field, value)).collect()
            }
        };
        for (part, value) in values {
            let value = self.expression(value)?;
            self.store(&[at, &[part]].concat(), value)?;
        }
        Ok(())
    }

    /// Returns the initial value of a type.
    fn default(&mut self, ty: &'p Type) -> Evaluated<MemoryCell> {
        Ok(match self.resolved(ty) {
            Type::Elementary(ty) => zero(*ty),
            Type::Array(array) => {
                let (number, element) = (elements(array)?, self.default(&array.element)?);
                limited(number.saturating_mul(element.size()))?;
                MemoryCell::Parts(vec![element; number])
            }
            resolved @ Type::Declared(_) => match self.program.fields(resolved) {
                Some(fields) => {
                    let fields = fields.iter().map(|(_, ty, initial)| match initial {
                        Some(value) => self.expression(value),
                        None => self.default(ty),
                    });
                    MemoryCell::Parts(fields.collect::<Evaluated<_>>()?)
                }
                // The first value of an enumeration.
                None => MemoryCell::Plain(0),
            },
            // NULL.
            Type::Reference(_) => MemoryCell::Plain(0),
            Type::Block(_) => return Err(ill_formed("an instance that is no variable")),
        })
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
