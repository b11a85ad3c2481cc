//! Programs that are damaged at random, from a fixed seed: whatever comes of them, the oracle `parse` finds no failure.

use stickler_generate::oracles::FuzzTarget;
use stickler_mdtest::expanded;
use stickler_syntax::parse;
use stickler_types::{Dialect, DialectName, SplitMix64};

/// Programs that use every production between them.
const SAMPLES: [&str; 4] = [
    include_str!("../samples/types-and-configuration.st"),
    include_str!("../samples/function.st"),
    include_str!("../samples/function-block.st"),
    include_str!("../samples/dates.st"),
];

/// Pieces that are put in where something was cut, besides a line feed and a character that is not seen.
const PIECES: &str = "; := ( ) [ ] (* *) // ' \" $ . .. %X1 # END_IF IF THEN END_VAR VAR END_PROGRAM PROGRAM STRUCT ARRAY OF \
    CASE REPEAT - NOT x 5 1.5 T#1s é @ REF_TO ^";

struct TokenChoices(SplitMix64);

impl TokenChoices {
    fn piece(&mut self) -> &'static str {
        let pieces: Vec<_> = PIECES.split_whitespace().chain(["\u{0}", "\n"]).collect();
        pieces[self.below(pieces.len())]
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.0.draw() >> 33) as usize % bound.max(1)
    }
}

/// Returns the positions at which the words and marks of `text` begin and end, roughly.
fn boundaries(text: &str) -> Vec<usize> {
    let mut cuts: Vec<usize> = text
        .char_indices()
        .filter(|(_, character)| !character.is_alphanumeric() && *character != '_')
        .flat_map(|(at, character)| [at, at + character.len_utf8()])
        .collect();
    cuts.extend([0, text.len()]);
    cuts.sort_unstable();
    cuts.dedup();
    cuts
}

/// Cuts, doubles, swaps or replaces a piece of `text`.
fn mutate_tokens(text: &str, random: &mut TokenChoices) -> String {
    let cuts = boundaries(text);
    let mut from = random.below(cuts.len());
    let mut to = (from + 1 + random.below(4)).min(cuts.len() - 1);
    if from > to {
        std::mem::swap(&mut from, &mut to);
    }
    let (before, piece, after) = (
        &text[..cuts[from]],
        &text[cuts[from]..cuts[to]],
        &text[cuts[to]..],
    );
    match random.below(5) {
        0 => format!("{before}{after}"),
        1 => format!("{before}{piece} {piece}{after}"),
        2 => format!("{before} {} {after}", random.piece()),
        3 => format!("{before}{piece} {} {after}", random.piece()),
        _ => before.to_owned(),
    }
}

/// Changes single bytes, which may leave no UTF-8.
fn mutate_bytes(text: &str, random: &mut TokenChoices) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..=random.below(3) {
        let at = random.below(bytes.len());
        match random.below(3) {
            0 => bytes[at] ^= 1 << random.below(8),
            1 => drop(bytes.remove(at)),
            _ => bytes.insert(at, random.below(256) as u8),
        }
    }
    bytes
}

/// Holds the reference to its promises for a text in one of the dialects.
fn hold(text: &[u8], dialect: DialectName) {
    let first = dialect.index() as u8;
    if let Err(failure) = FuzzTarget::Parse.judge(&[&[first], text].concat()) {
        panic!("{failure}");
    }
}

/// Returns the dialect of a round, so that each has its turn.
fn dialect(round: usize) -> DialectName {
    DialectName::ALL[round % DialectName::ALL.len()]
}

#[test]
fn the_samples_are_accepted() {
    for sample in SAMPLES {
        for dialect in [DialectName::IRONPLC_RUSTY, DialectName::PLCNEXT] {
            let (_, diagnostics) = parse(sample, Dialect::of(dialect));
            assert_eq!(diagnostics, [], "{sample}");
            hold(sample.as_bytes(), dialect);
        }
    }
}

#[test]
fn damaged_tokens_are_diagnosed() {
    let mut random = TokenChoices(SplitMix64::new(0x5EED_0001));
    let mut accepted = 0;
    for round in 0..4000 {
        let mut text = SAMPLES[round % SAMPLES.len()].to_owned();
        for _ in 0..=random.below(3) {
            text = mutate_tokens(&text, &mut random);
        }
        hold(text.as_bytes(), dialect(round));
        let (_, diagnostics) = parse(&text, Dialect::of(dialect(round)));
        accepted += usize::from(diagnostics.is_empty());
    }
    assert!(
        accepted > 50,
        "{accepted} of the damaged texts were still programs"
    );
}

#[test]
fn damaged_bytes_are_diagnosed() {
    let mut random = TokenChoices(SplitMix64::new(0x5EED_0002));
    for round in 0..4000 {
        let bytes = mutate_bytes(SAMPLES[round % SAMPLES.len()], &mut random);
        hold(&bytes, dialect(round));
    }
}

#[test]
fn shuffled_pieces_are_diagnosed() {
    let mut random = TokenChoices(SplitMix64::new(0x5EED_0003));
    for round in 0..3000 {
        let mut text = String::from("PROGRAM p VAR x : INT; END_VAR ");
        for _ in 0..random.below(60) {
            text.push_str(random.piece());
            text.push(' ');
        }
        hold(text.as_bytes(), dialect(round));
    }
}

#[test]
fn hostile_texts_need_little_stack() {
    let deep: Vec<String> = include_str!("../samples/hostile.txt")
        .lines()
        .map(expanded)
        .collect();
    let work = move || {
        for text in &deep {
            hold(text.as_bytes(), DialectName::PLCNEXT);
        }
    };
    let thread = std::thread::Builder::new()
        .stack_size(2 << 20)
        .spawn(work)
        .expect("a thread");
    thread.join().expect("no text overflows the stack");
}
