//! The machine's longer instructions: texts, aggregates, conversions and standard functions.

use super::machine::{Machine, element};
use crate::conversion::{Conversion, formatted};
use crate::execution::stop::Halt;
use crate::execution::{comparison, standard};
use crate::instruction::{Address, ComparisonOperator, Part, StandardFunction};
use crate::raw::narrow;
use std::borrow::Cow;
use stickler_types::ElementaryType;
use stickler_types::dialect::TextElements;

impl Machine<'_> {
    pub(super) fn push_constant(&mut self, index: u32) -> Result<(), Halt> {
        let constant = self.program.text_constants.get(index as usize);
        self.texts.push(Cow::Borrowed(
            constant.ok_or(Halt::Missing("text constant of this number"))?,
        ));
        Ok(())
    }

    pub(super) fn load_text(&mut self) -> Result<(), Halt> {
        let address = self.pop_address()?;
        let text = self.memory.text(address)?.to_vec();
        self.spend_on_text(text.len() as u64)?;
        self.texts.push(Cow::Owned(text));
        Ok(())
    }

    pub(super) fn store_text(&mut self) -> Result<(), Halt> {
        let address = self.pop_address()?;
        let text = self.pop_text()?;
        self.spend_on_text(text.len() as u64)?;
        self.memory.store_text(address, &text)
    }

    /// Replaces the address of a text and a subscript by the place of a character: the address, and above it the position from 0.
    pub(super) fn find_character(&mut self, of: TextElements, unsigned: bool) -> Result<(), Halt> {
        let subscript = self.pop()?;
        let address = self.pop_address()?;
        let limits = match of {
            TextElements::Codes => (0, i64::from(self.memory.capacity(address)?)),
            TextElements::Characters | TextElements::None => (1, self.memory.text(address)?.len() as i64),
        };
        let position = element(subscript, limits, unsigned)?;
        self.operands.push(position << 32 | u64::from(address));
        Ok(())
    }

    pub(super) fn load_character(&mut self) -> Result<(), Halt> {
        let place = self.pop()?;
        let unit = self.memory.unit(place as Address, (place >> 32) as u32)?;
        self.operands.push(unit.into());
        Ok(())
    }

    pub(super) fn store_character(&mut self, of: TextElements) -> Result<(), Halt> {
        let (place, unit) = self.pop_pair()?;
        let (address, position) = (place as Address, (place >> 32) as u32);
        if of == TextElements::Characters {
            return self.memory.set_character(address, position, unit as u16);
        }
        let capacity = self.memory.capacity(address)?;
        self.spend_on_text(capacity.into())?;
        self.memory.set_unit(address, capacity, position, unit as u16)
    }

    pub(super) fn copy(&mut self, count: u32) -> Result<(), Halt> {
        let from = self.pop_address()?;
        let to = self.pop_address()?;
        self.spend(count.into())?;
        let texts = self.memory.copy(from, to, count)?;
        self.spend_on_text(texts)
    }

    pub(super) fn replicate(&mut self, stride: u32, count: u32) -> Result<(), Halt> {
        let first = self.pop_address()?;
        let mut place = first;
        for _ in 1..count {
            self.spend(u64::from(stride) + 1)?;
            place = place
                .checked_add(stride)
                .ok_or(Halt::Missing("cell at this address"))?;
            let texts = self.memory.copy(first, place, stride)?;
            self.spend_on_text(texts)?;
        }
        Ok(())
    }

    pub(super) fn store_part(&mut self, part: Part, of: ElementaryType) -> Result<(), Halt> {
        let value = self.pop()?;
        let address = self.pop_address()?;
        let first = part.first & 63;
        let mask = narrow(u64::MAX, part.ty) << first;
        let old = self.memory.load(address)?;
        let new = (old & !mask) | ((value << first) & mask);
        self.memory.store(address, narrow(new, of))
    }

    pub(super) fn convert(&mut self, conversion: Conversion) -> Result<(), Halt> {
        match (conversion.from.is_text(), conversion.to.is_text()) {
            (false, false) => {
                let value = self.pop()?;
                self.operands.push(conversion.apply(value));
            }
            (true, false) => {
                let text = self.pop_text()?;
                self.operands.push(conversion.apply_from_text(&text));
            }
            (false, true) => {
                let value = self.pop()?;
                self.texts.push(Cow::Owned(conversion.apply_to_text(value)));
            }
            (true, true) => {
                let text = self.pop_text()?;
                self.spend_on_text(text.len() as u64)?;
                self.texts.push(Cow::Owned(conversion.text_to_text(&text)));
            }
        }
        Ok(())
    }

    pub(super) fn format(&mut self, from: ElementaryType) -> Result<(), Halt> {
        let (value, format) = (self.pop()?, self.pop_text()?);
        self.spend_on_text(format.len() as u64)?;
        self.texts.push(Cow::Owned(formatted(value, from, &format)));
        Ok(())
    }

    pub(super) fn compare_texts(&mut self, operator: ComparisonOperator) -> Result<(), Halt> {
        let right = self.pop_text()?;
        let left = self.pop_text()?;
        self.operands
            .push(comparison::holds(operator, Some(left.cmp(&right))).into());
        Ok(())
    }

    pub(super) fn standard(
        &mut self,
        function: StandardFunction,
        of: ElementaryType,
        count: usize,
        numbers: usize,
    ) -> Result<(), Halt> {
        if of.is_text() {
            return self.standard_on_texts(function, count, numbers);
        }
        let first = self.operands.len().checked_sub(count + numbers);
        let first = first.ok_or(Halt::Missing("operand"))?;
        let result = standard::of_plain(function, of, self.operands.get(first..).unwrap_or_default())?;
        self.operands.truncate(first);
        self.operands.push(result);
        Ok(())
    }

    fn standard_on_texts(
        &mut self,
        function: StandardFunction,
        count: usize,
        numbers: usize,
    ) -> Result<(), Halt> {
        if function == StandardFunction::Len {
            let length = standard::length(&self.pop_text()?);
            self.operands.push(length);
            return Ok(());
        }
        if let StandardFunction::InOrder(operator) = function {
            let first = self.first_text(count)?;
            let mut pairs = self.texts[first..].windows(2);
            let is_in_order = pairs.all(|pair| comparison::holds(operator, Some(pair[0].cmp(&pair[1]))));
            self.texts.truncate(first);
            self.operands.push(is_in_order.into());
            return Ok(());
        }
        if function == StandardFunction::Find {
            let (sought, text) = (self.pop_text()?, self.pop_text()?);
            self.spend_on_text((text.len() + sought.len()) as u64)?;
            let found = standard::position(&text, &sought);
            self.operands.push(narrow(found, ElementaryType::Int));
            return Ok(());
        }
        let deepest = self.operands.len().checked_sub(numbers);
        let numbers = self.operands.split_off(deepest.ok_or(Halt::Missing("operand"))?);
        let first = self.first_text(count)?;
        let texts = self.texts.get_mut(first..).unwrap_or_default();
        let result = standard::of_texts(function, &numbers, texts)?;
        self.spend_on_text(result.len() as u64)?;
        self.texts.truncate(first);
        self.texts.push(result);
        Ok(())
    }

    /// Returns the index of the deepest of the uppermost texts on the stack.
    fn first_text(&self, count: usize) -> Result<usize, Halt> {
        let first = self.texts.len().checked_sub(count);
        first.ok_or(Halt::Missing("text operand"))
    }
}
