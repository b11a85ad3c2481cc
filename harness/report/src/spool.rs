//! A buffer for bytes that are gathered until the beginning of their file is known.

use std::io::{self, Write};

/// The capacity of one piece, in bytes. Pieces are never moved, so that gathering costs one copy however much is added.
const PIECE: usize = 1 << 20;

/// A buffer of gathered bytes, in pieces.
#[derive(Default)]
pub(crate) struct Spool {
    pieces: Vec<Vec<u8>>,
}

impl Spool {
    /// Adds bytes at the end.
    pub(crate) fn add(&mut self, bytes: &[u8]) {
        match self.pieces.last_mut() {
            Some(piece) if piece.len() + bytes.len() <= piece.capacity() => piece.extend_from_slice(bytes),
            _ => {
                // The first piece is small: most spools are.
                let capacity = if self.pieces.is_empty() { PIECE >> 8 } else { PIECE };
                let mut piece = Vec::with_capacity(capacity.max(bytes.len()));
                piece.extend_from_slice(bytes);
                self.pieces.push(piece);
            }
        }
    }

    /// Returns whether nothing was added.
    pub(crate) fn is_empty(&self) -> bool {
        self.pieces.is_empty()
    }

    /// Writes all gathered bytes.
    ///
    /// # Errors
    /// Returns the error of writing to `out`.
    pub(crate) fn write(&self, out: &mut impl Write) -> io::Result<()> {
        self.pieces.iter().try_for_each(|piece| out.write_all(piece))
    }
}

#[cfg(test)]
mod tests {
    use super::{PIECE, Spool};

    #[test]
    fn what_is_added_comes_back_in_order_whatever_its_size() {
        let mut spool = Spool::default();
        assert!(spool.is_empty());
        let mut expected = Vec::new();
        for size in [1, PIECE / 300, 7, PIECE + 1, 3, PIECE - 1, 2] {
            let bytes = vec![u8::try_from(size % 251).expect("small"); size];
            spool.add(&bytes);
            expected.extend(bytes);
        }
        let mut written = Vec::new();
        spool.write(&mut written).expect("written");
        assert!(written == expected && !spool.is_empty());
    }
}
