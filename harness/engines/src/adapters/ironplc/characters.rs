//! The characters by which the texts of a program are read back, one by one.

use stickler_types::ElementaryType;

/// Returns the character that a literal of a type begins and ends with.
fn quote(ty: ElementaryType) -> u8 {
    match ty {
        ElementaryType::Wstring => b'"',
        _ => b'\'',
    }
}

/// Returns a literal of the [plain] characters.
pub(super) fn plain_literal(ty: ElementaryType) -> String {
    let quote = char::from(quote(ty));
    let inside: String = plain(ty).map(char::from).collect();
    format!("{quote}{inside}{quote}")
}

/// Returns a literal of the [escaped] characters.
///
/// A compiler that takes `$01` for three characters holds only [plain] characters behind the first one, which is `$` either way;
/// so each position still tells the character.
pub(super) fn escaped_literal(ty: ElementaryType) -> String {
    let quote = char::from(quote(ty));
    let mut literal = format!("{quote}$$");
    for character in escaped(ty).skip(1) {
        literal.push_str(&match ty {
            ElementaryType::Wstring => format!("${character:04X}"),
            _ => format!("${character:02X}"),
        });
    }
    literal.push(quote);
    literal
}

/// Returns the characters that stand for themselves in a literal of a type.
pub(super) fn plain(ty: ElementaryType) -> impl Iterator<Item = u8> {
    (b' '..=b'~').filter(move |&character| character != b'$' && character != quote(ty))
}

/// Returns the other characters of 7 bits but NUL, `$` first.
pub(super) fn escaped(ty: ElementaryType) -> impl Iterator<Item = u8> {
    [b'$', quote(ty), 0x7F].into_iter().chain(1..b' ')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_literals_have_each_character_but_nul_once() {
        for ty in [ElementaryType::String, ElementaryType::Wstring] {
            let mut all: Vec<u8> = plain(ty).chain(escaped(ty)).collect();
            all.sort_unstable();
            assert_eq!(all, (1..0x80).collect::<Vec<u8>>(), "{ty}");
        }
        let literal = escaped_literal(ElementaryType::String);
        assert!(
            literal.starts_with("'$$$27$7F$01$02") && literal.ends_with("$1F'"),
            "{literal}"
        );
        assert!(escaped_literal(ElementaryType::Wstring).starts_with("\"$$$0022$007F$0001"));
    }
}
