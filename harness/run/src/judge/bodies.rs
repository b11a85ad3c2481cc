//! Extracts the bodies of program organization units from a rendered text. Basis: conformance-cases/README.md (marks).
//!
//! The judge of mutated references includes this file too (`harness/mutants/judge`), so it needs nothing but the standard
//! library.

/// Returns the lines of the bodies of all program organization units (POUs) in a rendered text, trimmed, without empty ones.
///
/// A body is the text between a POU's header or its last `END_VAR` and its `END_PROGRAM`, `END_FUNCTION` or
/// `END_FUNCTION_BLOCK`. Headers, variable blocks, TYPE declarations and configurations are left out. Each of those words is
/// recognized only at the beginning of a line, where a renderer puts it. Basis: conformance-cases/README.md (marks).
pub fn rendered_bodies(text: &str) -> Vec<&str> {
    let mut room = Room::Outside;
    let mut bodies = Vec::new();
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty()) {
        let (next, is_body) = room.enter(first_word(line));
        room = next;
        if is_body {
            bodies.push(line);
        }
    }
    bodies
}

/// The part of the text in which a line stands.
#[derive(Clone, Copy, PartialEq)]
enum Room {
    /// Outside all POUs.
    Outside,
    /// Inside a configuration, whose PROGRAM lines declare instances instead of POUs.
    Configuration,
    /// In a variable block of a POU.
    Variables,
    /// In a POU, outside its variable blocks.
    Body,
}

impl Room {
    /// Returns the part of the text after a line that begins with this word, and whether that line belongs to a body.
    fn enter(self, word: &str) -> (Room, bool) {
        let is = |word_list: &[&str]| word_list.iter().any(|known| known.eq_ignore_ascii_case(word));
        match self {
            Room::Outside if is(&["PROGRAM", "FUNCTION", "FUNCTION_BLOCK"]) => (Room::Body, false),
            Room::Outside if is(&["CONFIGURATION"]) => (Room::Configuration, false),
            Room::Configuration if is(&["END_CONFIGURATION"]) => (Room::Outside, false),
            Room::Variables if is(&["END_VAR"]) => (Room::Body, false),
            Room::Outside | Room::Configuration | Room::Variables => (self, false),
            Room::Body if is(VARIABLE_BLOCKS) => (Room::Variables, false),
            Room::Body if is(&["END_PROGRAM", "END_FUNCTION", "END_FUNCTION_BLOCK"]) => {
                (Room::Outside, false)
            }
            Room::Body => (Room::Body, true),
        }
    }
}

const VARIABLE_BLOCKS: &[&str] = &[
    "VAR",
    "VAR_INPUT",
    "VAR_OUTPUT",
    "VAR_IN_OUT",
    "VAR_TEMP",
    "VAR_EXTERNAL",
    "VAR_GLOBAL",
    "VAR_ACCESS",
];

fn first_word(line: &str) -> &str {
    let end = line.find(|character: char| !(character.is_ascii_alphanumeric() || character == '_'));
    &line[..end.unwrap_or(line.len())]
}
