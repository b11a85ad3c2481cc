//! Programs that are damaged at random, from a fixed seed: whatever comes of them, the syntax half of the
//! reference gives a tree and diagnostics that point into the text, and what it accepts it renders.

use stickler_syntax::decoding::decode;
use stickler_syntax::source::LineIndex;
use stickler_syntax::{parse, render};
use stickler_types::dialect::Dialect;
use stickler_types::{DialectName, SplitMix64};

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

/// Holds every promise of the parser and the renderer against a text; says whether it was accepted.
fn hold(text: &str, dialect: &Dialect) -> bool {
    let (unit, diagnostics) = parse(text, dialect);
    let lines = LineIndex::new(text);
    for diagnostic in &diagnostics {
        let (start, end) = (diagnostic.span.start as usize, diagnostic.span.end as usize);
        assert!(start <= end && end <= text.len(), "{diagnostic:?}\n{text}");
        assert!(
            text.is_char_boundary(start) && text.is_char_boundary(end),
            "{diagnostic:?}\n{text}"
        );
        assert!(!diagnostic.code.as_str().is_empty() && !diagnostic.message.is_empty());
        assert!(lines.position(text, diagnostic.span.start).line <= lines.lines());
    }
    for expression in &unit.expressions {
        assert!(
            expression.span.start <= expression.span.end,
            "{expression:?}\n{text}"
        );
        assert!(!expression.span.text(text).is_empty(), "{expression:?}\n{text}");
    }
    let rendered = render(&unit, text);
    if !diagnostics.is_empty() {
        return false;
    }
    let (again, complaints) = parse(&rendered, dialect);
    assert_eq!(complaints, [], "{text}\n{rendered}");
    assert_eq!(render(&again, &rendered), rendered, "{text}");
    if text.len() > 100_000 {
        return true; // A tree of that size takes long to print.
    }
    let shapes = [format!("{unit:?}"), format!("{again:?}")].map(|shape| without_places(&shape));
    assert!(
        shapes[0] == shapes[1],
        "the tree has changed:\n{text}\n{rendered}"
    );
    true
}

/// The tree without its places, in one case, and with one form of bit access: what rendering has to keep.
fn without_places(tree: &str) -> String {
    let mut shape = String::with_capacity(tree.len());
    let mut rest = tree;
    while let Some(at) = rest.find("start: ") {
        shape.push_str(&rest[..at]);
        rest = rest[at..].trim_start_matches(|character| !matches!(character, ',' | '}'));
        if let Some(behind) = rest.strip_prefix(", end: ") {
            rest = behind.trim_start_matches(|character: char| character.is_ascii_digit());
        }
    }
    shape.push_str(rest);
    shape.to_ascii_uppercase().replace("FORM: BIT,", "FORM: SHORT,")
}

#[test]
fn the_samples_are_accepted_and_keep_their_trees() {
    for sample in SAMPLES {
        for dialect in [DialectName::IRONPLC_RUSTY, DialectName::PLCNEXT] {
            let (_, diagnostics) = parse(sample, Dialect::of(dialect));
            assert_eq!(diagnostics, [], "{sample}");
            assert!(hold(sample, Dialect::of(dialect)));
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
        accepted += usize::from(hold(
            &text,
            Dialect::of(DialectName::ALL[round % DialectName::ALL.len()]),
        ));
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
        let (text, diagnostics) = decode(&bytes);
        assert_eq!(diagnostics.is_empty(), std::str::from_utf8(&bytes).is_ok());
        hold(
            &text,
            Dialect::of(DialectName::ALL[round % DialectName::ALL.len()]),
        );
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
        hold(
            &text,
            Dialect::of(DialectName::ALL[round % DialectName::ALL.len()]),
        );
    }
}

#[test]
fn hostile_texts_need_little_stack() {
    let begun = [
        "(",
        "[",
        "f(",
        "a[",
        "-",
        "NOT ",
        "IF a THEN ",
        "CASE a OF 1: ",
        "(*",
        "a.",
        "+ a ** (b ",
    ];
    let begun = begun.map(|piece| format!("PROGRAM p x := {}", piece.repeat(100_000)));
    let nested = |first: &str, before: &str, inner: &str, after: &str, times| {
        let (before, after) = (before.repeat(times), after.repeat(times));
        format!("PROGRAM p {first}{before}{inner}{after}; END_PROGRAM")
    };
    let others = [
        nested("", "IF a THEN ", "", "END_IF; ", 200),
        nested("x := ", "(", "1", ")", 200),
        nested("x := ", "a OR b XOR (", "1", ")", 150),
        format!("PROGRAM p x := 1{}; END_PROGRAM", "+1".repeat(500_000)),
        format!("TYPE t : {}", "STRUCT a : ".repeat(100_000)),
        format!("TYPE t : {}INT; END_TYPE", "ARRAY[1..2] OF ".repeat(199)),
        format!("PROGRAM p VAR x : t := {}", "[(a := ".repeat(100_000)),
        format!("PROGRAM p x := {}; END_PROGRAM", "9".repeat(1_000_000)),
    ];
    let deep: Vec<String> = begun.into_iter().chain(others).collect();
    let work = move || {
        for text in &deep {
            hold(text, Dialect::of(DialectName::PLCNEXT));
        }
    };
    let thread = std::thread::Builder::new()
        .stack_size(2 << 20)
        .spawn(work)
        .expect("a thread");
    thread.join().expect("no text overflows the stack");
}
