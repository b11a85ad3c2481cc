//! Programs as they stand in the registry: indented there, flush when they are shown.

/// The columns by which the registry indents every line of a program.
const INDENT: usize = 16;

/// The length of what [`program`] makes of a text.
pub(super) const fn program_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let (mut at, mut column, mut length) = (0, 0, 0);
    while at < bytes.len() {
        if keeps(bytes[at], at, column) {
            length += 1;
        }
        column = if bytes[at] == b'\n' { 0 } else { column + 1 };
        at += 1;
    }
    length
}

/// The text without its first line break and without the indent of its lines.
///
/// `LENGTH` must be what [`program_length`] gives for the same text.
pub(super) const fn program<const LENGTH: usize>(text: &str) -> [u8; LENGTH] {
    let bytes = text.as_bytes();
    let mut kept = [0; LENGTH];
    let (mut at, mut column, mut length) = (0, 0, 0);
    while at < bytes.len() {
        if keeps(bytes[at], at, column) {
            kept[length] = bytes[at];
            length += 1;
        }
        column = if bytes[at] == b'\n' { 0 } else { column + 1 };
        at += 1;
    }
    kept
}

/// Whether a byte belongs to the program: neither the line break behind the opening quote, nor the indent of a line.
const fn keeps(byte: u8, at: usize, column: usize) -> bool {
    let opening = at == 0 && byte == b'\n';
    let indent = column < INDENT && byte == b' ';
    !opening && !indent
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_indent_of_the_registry_is_taken_off_and_that_of_the_program_stays() {
        const TEXT: &str = "
                VAR
                    x : INT;

                END_VAR
                ";
        const LENGTH: usize = program_length(TEXT);
        assert_eq!(
            str::from_utf8(&program::<LENGTH>(TEXT)),
            Ok("VAR\n    x : INT;\n\nEND_VAR\n")
        );
    }
}
