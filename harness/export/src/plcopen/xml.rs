//! Writes elements, attributes and texts in XHTML so that a reader gets back what was written.

use quick_xml::Writer;
use quick_xml::escape::escape;
use quick_xml::events::BytesText;
use quick_xml::events::attributes::Attribute;
use quick_xml::name::QName;
use std::borrow::Cow;
use std::io;

/// A writer of elements.
pub(super) type Xml = Writer<Vec<u8>>;

/// Returns an attribute whose value a reader gets back as it is: of line ends and tabs it would otherwise make spaces.
pub(super) fn attribute<'a>(name: &'a str, value: &str) -> Attribute<'a> {
    let value = escape(value)
        .replace('\t', "&#9;")
        .replace('\n', "&#10;")
        .replace('\r', "&#13;");
    Attribute {
        key: QName(name.as_bytes()),
        value: Cow::Owned(value.into_bytes()),
    }
}

/// Writes an element around what `inside` writes.
pub(super) fn nested<'a>(
    xml: &mut Xml,
    name: &str,
    attributes: impl IntoIterator<Item = Attribute<'a>>,
    inside: impl FnOnce(&mut Xml) -> io::Result<()>,
) -> io::Result<()> {
    let element = xml.create_element(name).with_attributes(attributes);
    element.write_inner_content(inside).map(drop)
}

/// Writes an element that has attributes only.
pub(super) fn empty<'a>(
    xml: &mut Xml,
    name: &str,
    attributes: impl IntoIterator<Item = Attribute<'a>>,
) -> io::Result<()> {
    let element = xml.create_element(name).with_attributes(attributes);
    element.write_empty().map(drop)
}

/// The element of XHTML in which an editor looks for a text. The format asks for any one element of XHTML, and editors read different ones.
#[derive(Clone, Copy)]
pub(super) enum TextElement {
    /// `xhtml`, as CODESYS and the systems that are built on it write it.
    Xhtml,
    /// `p`, the only one that Beremiz reads.
    Paragraph,
}

/// Writes an element that holds a text in XHTML, which a reader gets back as it is.
pub(super) fn formatted(xml: &mut Xml, name: &str, within: TextElement, text: &str) -> io::Result<()> {
    let escaped = quick_xml::escape::partial_escape(text).replace('\r', "&#13;");
    nested(xml, name, [], |xml| {
        let element = xml.create_element(match within {
            TextElement::Xhtml => "xhtml",
            TextElement::Paragraph => "p",
        });
        let element = element.with_attribute(("xmlns", "http://www.w3.org/1999/xhtml"));
        element
            .write_text_content(BytesText::from_escaped(escaped))
            .map(drop)
    })
}

/// Returns whether XML can hold a character, as itself or by its number.
///
/// Basis: XML 1.0 (fifth edition), 2.2, `Char`.
pub(super) const fn fits(character: char) -> bool {
    matches!(character, '\t' | '\n' | '\r' | ' '..='\u{D7FF}' | '\u{E000}'..='\u{FFFD}' | '\u{10000}'..)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn xml_holds_no_control_characters_and_no_noncharacters() {
        for character in ['\0', '\u{8}', '\u{B}', '\u{1F}', '\u{FFFE}', '\u{FFFF}'] {
            assert!(!fits(character), "{character:?}");
        }
        for character in ['\t', '\n', '\r', ' ', '\u{7F}', 'ä', '\u{FFFD}', '\u{10FFFF}'] {
            assert!(fits(character), "{character:?}");
        }
    }
}
