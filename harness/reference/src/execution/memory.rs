//! The machine's memory: cells, and the texts that some of them name.

use super::stop::Halt;
use crate::instruction::{Address, FaultKind, TextCell};
use rustc_hash::FxHashMap;
use std::borrow::Cow;
use std::ops::Range;

/// All variables of a run.
#[derive(Debug)]
pub(super) struct MachineMemory<'p> {
    cells: Vec<u64>,
    /// By address. The cell of the nth holds n, its place in `texts`.
    text_cells: Cow<'p, [TextCell]>,
    texts: Vec<Vec<u16>>,
    /// What lies in and behind those texts, by their place, that pointers have written into.
    images: FxHashMap<usize, Vec<u16>>,
}

impl<'p> MachineMemory<'p> {
    /// A memory of that many cells, all zero, with empty texts.
    pub fn new(size: u32, text_cells: &'p [TextCell]) -> MachineMemory<'p> {
        let mut text_cells = Cow::Borrowed(text_cells);
        if !text_cells.is_sorted_by_key(|cell| cell.address) {
            text_cells.to_mut().sort_by_key(|cell| cell.address);
        }
        let texts = vec![Vec::new(); text_cells.len()];
        let mut memory = MachineMemory {
            cells: vec![0; size as usize],
            text_cells,
            texts,
            images: FxHashMap::default(),
        };
        memory.name_texts(0..memory.text_cells.len());
        memory
    }

    /// Writes into the cells of these texts which text is theirs.
    fn name_texts(&mut self, texts: Range<usize>) {
        for index in texts {
            let cell = self
                .text_cells
                .get(index)
                .and_then(|cell| self.cells.get_mut(cell.address as usize));
            if let Some(cell) = cell {
                *cell = index as u64;
            }
        }
    }

    #[inline]
    pub fn load(&self, address: Address) -> Result<u64, Halt> {
        self.cells
            .get(address as usize)
            .copied()
            .ok_or(Halt::Missing("cell at this address"))
    }

    #[inline]
    pub fn store(&mut self, address: Address, value: u64) -> Result<(), Halt> {
        *self
            .cells
            .get_mut(address as usize)
            .ok_or(Halt::Missing("cell at this address"))? = value;
        Ok(())
    }

    pub fn text(&self, address: Address) -> Result<&[u16], Halt> {
        let index = self.load(address)? as usize;
        Ok(self
            .texts
            .get(index)
            .ok_or(Halt::Missing("text at this address"))?)
    }

    /// Stores a text, cut to the capacity of its variable.
    pub fn store_text(&mut self, address: Address, units: &[u16]) -> Result<(), Halt> {
        let index = self.load(address)? as usize;
        let (Some(text), Some(cell)) = (self.texts.get_mut(index), self.text_cells.get(index)) else {
            return Err(Halt::Missing("text at this address"));
        };
        text.clear();
        text.extend(units.iter().take(cell.capacity as usize));
        Ok(())
    }

    /// Returns the code unit of a text at a position: behind its end a zero, and then what pointers have written there.
    pub fn unit(&self, address: Address, position: u32) -> Result<u16, Halt> {
        let position = position as usize;
        let text = self.text(address)?;
        let image = self.images.get(&(self.load(address)? as usize));
        let behind = image.filter(|_| position > text.len());
        let unit = text.get(position).or_else(|| behind?.get(position));
        Ok(unit.copied().unwrap_or(0))
    }

    /// Sets the code unit at a position of a text, which then ends before its first zero.
    pub fn set_unit(&mut self, address: Address, length: u32, position: u32, unit: u16) -> Result<(), Halt> {
        let index = self.load(address)? as usize;
        let text = self.texts.get_mut(index);
        let text = text.ok_or(Halt::Missing("text at this address"))?;
        let image = self.images.entry(index).or_default();
        image.resize(length as usize + 1, 0);
        image.splice(
            ..=text.len().min(length as usize),
            text.iter().copied().chain([0]),
        );
        image.truncate(length as usize + 1);
        if let Some(place) = image.get_mut(position as usize) {
            *place = unit;
        }
        text.clear();
        text.extend(image.iter().take(length as usize).take_while(|&&unit| unit != 0));
        Ok(())
    }

    /// Returns the greatest length of the text at an address.
    pub fn capacity(&self, address: Address) -> Result<u32, Halt> {
        let cell = self.text_cells.get(self.load(address)? as usize);
        Ok(cell.ok_or(Halt::Missing("text at this address"))?.capacity)
    }

    /// Sets a character of a text, which keeps its length. The text may have become shorter since the position was found.
    pub fn set_character(&mut self, address: Address, position: u32, unit: u16) -> Result<(), Halt> {
        let index = self.load(address)? as usize;
        let text = self.texts.get_mut(index);
        let place = text.and_then(|text| text.get_mut(position as usize));
        *place.ok_or(FaultKind::SubscriptRange)? = unit;
        Ok(())
    }

    /// Copies `count` cells, texts by their content. Gives the work done beyond the cells.
    pub fn copy(&mut self, from: Address, to: Address, count: u32) -> Result<u64, Halt> {
        let source = self.range(from, count)?;
        let target = self.range(to, count)?;
        let texts = self.texts_in(&target);
        let mut work = 0;
        for index in texts.clone() {
            work += self.copy_text(index, from, to)?;
        }
        self.cells.copy_within(source, target.start);
        self.name_texts(texts);
        Ok(work)
    }

    /// Copies the content of the text that lies as far behind `from` as the text `index` does behind `to`.
    fn copy_text(&mut self, index: usize, from: Address, to: Address) -> Result<u64, Halt> {
        let Some(&TextCell { address, .. }) = self.text_cells.get(index) else {
            return Ok(0);
        };
        let units = self.text(address.wrapping_sub(to).wrapping_add(from))?.to_vec();
        self.store_text(address, &units)?;
        Ok(units.len() as u64)
    }

    /// Sets `count` cells to zero, and their texts to empty.
    pub fn clear(&mut self, address: Address, count: u32) -> Result<(), Halt> {
        let range = self.range(address, count)?;
        let texts = self.texts_in(&range);
        self.cells.get_mut(range).unwrap_or_default().fill(0);
        self.texts
            .get_mut(texts.clone())
            .unwrap_or_default()
            .iter_mut()
            .for_each(Vec::clear);
        self.name_texts(texts);
        Ok(())
    }

    /// The cells from an address on, if there are so many.
    fn range(&self, address: Address, count: u32) -> Result<Range<usize>, Halt> {
        let start = address as usize;
        let end = start.saturating_add(count as usize);
        if end > self.cells.len() {
            return Err(Halt::Missing("cell at this address"));
        }
        Ok(start..end)
    }

    /// Returns the texts that have their cells in the range.
    fn texts_in(&self, range: &Range<usize>) -> Range<usize> {
        let first = self
            .text_cells
            .partition_point(|cell| (cell.address as usize) < range.start);
        let behind = self
            .text_cells
            .partition_point(|cell| (cell.address as usize) < range.end);
        first..behind
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXTS: [TextCell; 3] = [text(5, 2), text(1, 10), text(3, 10)];

    const fn text(address: u32, capacity: u32) -> TextCell {
        TextCell { address, capacity }
    }

    #[test]
    fn texts_are_cut_to_their_capacity_and_copied_by_content() {
        let mut memory = MachineMemory::new(6, &TEXTS);
        memory.store_text(1, &[1, 2, 3]).expect("a text");
        memory.store(2, 7).expect("a cell");
        assert_eq!(memory.copy(1, 5, 1), Ok(3));
        assert_eq!(memory.text(5), Ok(&[1, 2][..]));
        assert_eq!(memory.copy(1, 3, 2), Ok(3));
        assert_eq!(memory.text(3), Ok(&[1, 2, 3][..]));
        assert_eq!(memory.load(4), Ok(7));
        memory.store_text(1, &[9]).expect("a text");
        assert_eq!(memory.text(3), Ok(&[1, 2, 3][..]));
    }

    #[test]
    fn clearing_empties_texts_and_leaves_them_usable() {
        let mut memory = MachineMemory::new(6, &TEXTS);
        memory.store_text(3, &[1]).expect("a text");
        memory.store(4, 9).expect("a cell");
        memory.clear(2, 3).expect("cells");
        assert_eq!((memory.text(3), memory.load(4)), (Ok(&[][..]), Ok(0)));
        memory.store_text(3, &[2]).expect("a text");
        assert_eq!(memory.text(3), Ok(&[2][..]));
    }

    #[test]
    fn an_address_outside_the_memory_is_an_error() {
        let mut memory = MachineMemory::new(6, &TEXTS);
        assert!(memory.load(6).is_err());
        assert!(memory.store(u32::MAX, 0).is_err());
        assert!(memory.copy(0, 5, 2).is_err());
        assert!(memory.clear(6, 1).is_err());
        assert!(memory.clear(6, 0).is_ok());
        assert!(
            memory.text(2).is_ok_and(<[u16]>::is_empty),
            "the cell of no text names the first"
        );
    }
}
