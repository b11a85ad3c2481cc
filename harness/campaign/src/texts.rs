//! Inputs for targets that read text: what can almost be read says more than noise.
//!
//! Some inputs are as the generator or a list makes them; most have been changed here and there.

use crate::inputs::Inputs;
use std::sync::LazyLock;
use stickler_generate::oracles::FuzzTarget;
use stickler_generate::writer::{Style, write};
use stickler_types::{DialectName, ElementaryType, SplitMix64, Value};

/// The input of a target at a place: bytes of the row, or a text of the kind that the target reads.
pub(crate) fn input(inputs: Inputs, place: u64, target: FuzzTarget) -> Vec<u8> {
    let mut draws = Draws::new(inputs.draws(place));
    match target {
        FuzzTarget::Parse => mutated(program(inputs, place), &mut draws),
        FuzzTarget::CaseFile => mutated(case_file(inputs, place), &mut draws),
        FuzzTarget::Literal => mutated(literal(&mut draws), &mut draws),
        FuzzTarget::Protocol => mutated(conversation(inputs, place), &mut draws),
        FuzzTarget::Convert | FuzzTarget::Check | FuzzTarget::Execute => inputs.bytes(place),
    }
}

/// The random numbers of one place, one after the other.
struct Draws {
    row: SplitMix64,
    next: u64,
}

impl Draws {
    /// Begins at the far half of the row; the near half makes the bytes of the program.
    fn new(row: SplitMix64) -> Draws {
        Draws { row, next: 1 << 63 }
    }

    fn number(&mut self) -> u64 {
        self.next = self.next.wrapping_add(1);
        self.row.at(self.next)
    }

    /// Returns a number below `count`; 0 where `count` is 0.
    fn below(&mut self, count: usize) -> usize {
        match count as u64 {
            0 => 0,
            // It is below `count`.
            count => (self.number() % count) as usize,
        }
    }

    fn pick<'t, T: ?Sized>(&mut self, from: &[&'t T]) -> Option<&'t T> {
        from.get(self.below(from.len())).copied()
    }
}

fn program(inputs: Inputs, place: u64) -> String {
    write(&inputs.program(place, &DialectName::ALL, true), &Style::default()).text
}

fn case_file(inputs: Inputs, place: u64) -> String {
    const HEADER: &str =
        "(*!\ntitle = \"Something holds\"\nbasis = \"iec-61131-3: 7.3\"\ndialects = [\"all\"]\n*)\n";
    const VALUES: &str = "(*! values\nchecksum = LINT#0\n*)\n";
    format!("{HEADER}{}{VALUES}", program(inputs, place))
}

fn conversation(inputs: Inputs, place: u64) -> String {
    const HELLO: &str = "{\"type\":\"hello\",\"protocol\":1}";
    let source = serde_json::Value::String(program(inputs, place));
    let run = format!(
        "{{\"type\":\"run\",\"id\":1,\"dialect\":\"ironplc-ed3\",\"source\":{source},\"scans\":1,\
         \"observe\":[{{\"name\":\"checksum\",\"type\":\"LINT\"}}]}}"
    );
    format!("{HELLO}\n{run}\n{{\"type\":\"bye\"}}\n")
}

/// Returns a literal of any type, in the canonical spelling or without its prefix.
fn literal(draws: &mut Draws) -> String {
    let types: Vec<&ElementaryType> = ElementaryType::ALL.iter().collect();
    let ty = draws.pick(&types).copied().unwrap_or(ElementaryType::Int);
    let value = if ty.is_text() {
        let length = draws.below(6);
        let units = (0..length).map(|_| (draws.number() % 0x180) as u16);
        // A STRING holds no unit above 16#FF.
        let most = if ty == ElementaryType::String {
            0xFF
        } else {
            u16::MAX
        };
        Value::text(ty, units.map(|unit| unit & most).collect())
    } else {
        let number = i128::from(draws.number().cast_signed() >> draws.below(64));
        Value::plain(ty, ty.wrap(number))
    };
    let text = value.to_string();
    match (draws.below(2), text.split_once('#')) {
        (0, Some((_, rest))) => rest.to_owned(),
        _ => text,
    }
}

/// Tokens of programs, literals, case files and requests, which are inserted where they do not belong.
static TOKENS: LazyLock<Vec<String>> = LazyLock::new(|| {
    // A test reads the list, so that it is never empty.
    serde_json::from_str(include_str!("texts/tokens.json")).unwrap_or_default()
});

/// Returns the text with a few changes; in one of eight cases with none.
fn mutated(text: String, draws: &mut Draws) -> Vec<u8> {
    let mut bytes = text.into_bytes();
    let changes = draws.below(8);
    for _ in 0..changes {
        change(&mut bytes, draws);
    }
    bytes
}

fn change(bytes: &mut Vec<u8>, draws: &mut Draws) {
    let at = draws.below(bytes.len() + 1);
    let length = draws.below(9).min(bytes.len() - at);
    match draws.below(6) {
        // A token more.
        0 | 1 => {
            let token = TOKENS.get(draws.below(TOKENS.len()));
            bytes.splice(at..at, token.map_or("", String::as_str).bytes());
        }
        // Some bytes less.
        2 => {
            bytes.drain(at..at + length);
        }
        // Some bytes twice.
        3 => {
            let again = bytes[at..at + length].to_vec();
            bytes.splice(at..at, again);
        }
        // Another byte.
        4 => {
            let byte = draws.number().to_le_bytes()[0];
            if let Some(place) = bytes.get_mut(at) {
                *place = byte;
            }
        }
        // The end is missing, rarely.
        _ => {
            if draws.below(4) == 0 {
                bytes.truncate(at);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXTS: [FuzzTarget; 4] = [
        FuzzTarget::Parse,
        FuzzTarget::CaseFile,
        FuzzTarget::Literal,
        FuzzTarget::Protocol,
    ];

    #[test]
    fn an_input_depends_on_seed_place_and_target_alone() {
        for target in TEXTS {
            assert_eq!(input(Inputs::new(3), 5, target), input(Inputs::new(3), 5, target));
        }
    }

    #[test]
    fn some_inputs_are_whole_and_most_are_not() {
        assert!(TOKENS.len() > 80, "the list is read");
        let inputs = Inputs::new(1);
        let whole = (0..200)
            .filter(|&place| input(inputs, place, FuzzTarget::Parse) == program(inputs, place).into_bytes());
        assert!((5..100).contains(&whole.count()));
    }

    #[test]
    fn literals_of_every_type_come() {
        let texts: Vec<String> = (0..2000)
            .map(|place| literal(&mut Draws::new(Inputs::new(1).draws(place))))
            .collect();
        for ty in ElementaryType::ALL {
            let prefix = format!("{ty}#");
            assert!(texts.iter().any(|text| text.starts_with(&prefix)), "{ty}");
        }
    }
}
