//! All sequences of symbols of one length in as few scans as there can be: each sequence begins where the one before it has its second symbol.

/// Returns a row of symbols, each less than `symbols`, in which every sequence of `length` symbols occurs; of several parts the one of a
/// number from 1, which begins with what the one before it ends with.
pub(super) fn every_sequence(symbols: usize, length: usize, (part, parts): (usize, usize)) -> Vec<usize> {
    let mut row = Vec::new();
    extend(&mut vec![0; length + 1], 1, 1, (symbols, length), &mut row);
    let around: Vec<usize> = row.iter().take(length - 1).copied().collect();
    row.extend(around);
    let size = row.len().div_ceil(parts);
    let start = (part - 1) * size;
    let end = (start + size + length - 1).min(row.len());
    row[start.min(end)..end].to_vec()
}

/// Adds the prime words from `word[1..at]` on to a de Bruijn sequence, in the order of an alphabet.
fn extend(
    word: &mut [usize],
    at: usize,
    period: usize,
    (symbols, length): (usize, usize),
    row: &mut Vec<usize>,
) {
    if at > length {
        if length % period == 0 {
            row.extend(&word[1..=period]);
        }
        return;
    }
    word[at] = word[at - period];
    extend(word, at + 1, period, (symbols, length), row);
    for symbol in word[at - period] + 1..symbols {
        word[at] = symbol;
        extend(word, at + 1, at, (symbols, length), row);
    }
}

#[cfg(test)]
mod tests {
    use super::every_sequence;
    use std::collections::HashSet;

    #[test]
    fn every_sequence_occurs_once() {
        for (symbols, length) in [(2, 1), (2, 5), (4, 5), (8, 4), (16, 3)] {
            let row = every_sequence(symbols, length, (1, 1));
            let found: HashSet<&[usize]> = row.windows(length).collect();
            let all = symbols.pow(length as u32);
            assert_eq!((found.len(), row.len()), (all, all + length - 1));
            let parts = (1..=3).map(|part| every_sequence(symbols, length, (part, 3)));
            let parts: Vec<Vec<usize>> = parts.collect();
            let found: HashSet<&[usize]> = parts.iter().flat_map(|part| part.windows(length)).collect();
            assert_eq!(found.len(), all);
        }
    }
}
