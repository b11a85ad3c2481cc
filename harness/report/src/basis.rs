//! The basis of a case: a document that makes a claim, and the section of the claim.

use std::cmp::Ordering;

/// A document and one of its sections. The order is the natural one: `Table 4` comes before `Table 31`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Basis<'a> {
    /// The document, such as `ironplc-type-conversions`.
    pub source: &'a str,
    /// The section of the document, such as `Integer widening`; empty where the whole document is meant.
    pub section: &'a str,
}

impl<'a> Basis<'a> {
    /// Parses the `basis` of a case. It is written `source: section`.
    pub fn of(basis: &'a str) -> Basis<'a> {
        let (source, section) = basis.split_once(':').unwrap_or((basis, ""));
        Basis {
            source: source.trim(),
            section: section.trim(),
        }
    }

    /// Returns whether the basis is one of Stickler's own rules.
    pub fn is_rule(&self) -> bool {
        self.source == "rule"
    }
}

impl Ord for Basis<'_> {
    fn cmp(&self, other: &Self) -> Ordering {
        // The natural order does not tell names such as 1.01 and 1.1 apart; here they differ, so that it agrees with `Eq`.
        let sections = || alphanumeric_sort::compare_str(self.section, other.section);
        let source = self.source.cmp(other.source);
        source
            .then_with(sections)
            .then_with(|| self.section.cmp(other.section))
    }
}

impl PartialOrd for Basis<'_> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

#[cfg(test)]
mod tests {
    use super::Basis;
    use std::cmp::Ordering;

    #[test]
    fn a_basis_is_a_document_and_a_section() {
        let read = |text| {
            let Basis { source, section } = Basis::of(text);
            (source, section)
        };
        assert_eq!(read("doc: A: B"), ("doc", "A: B"));
        assert_eq!(read("doc"), ("doc", ""));
    }

    #[test]
    fn sections_are_sorted_by_their_numbers() {
        let sorted = [
            "doc",
            "doc: 6.4.2",
            "doc: 6.6.2",
            "doc: 6.6.2.5",
            "doc: 6.6.10",
            "doc: Table 4",
            "doc: Table 31",
            "other: 1",
        ];
        let mut shuffled = sorted;
        shuffled.sort_unstable_by(|a, b| b.cmp(a));
        shuffled.sort_by_key(|basis| Basis::of(basis));
        assert_eq!(shuffled, sorted);
        assert_ne!(
            Basis::of("doc: 1.01").cmp(&Basis::of("doc: 1.1")),
            Ordering::Equal
        );
    }
}
