//! Checks directly represented variables: `x AT %MW5 : INT;`.
//!
//! Each has memory of its own, as any other variable has. That is all that programs can see as long as no two locations have bits in
//! common; which ones have, depends on the system's units of addresses, so such pairs are not implemented.
//!
//! Basis: ironplc-problem-codes: P4036 (sections of their own); 6.5.5 of the third edition (programs, global variables).

use super::declare::Declarer;
use rustc_hash::{FxHashMap, FxHashSet};
use stickler_syntax::tree::{Pou, PouKind, VariableBlock, VariableKind};
use stickler_types::Code;

impl<'u> Declarer<'u, '_> {
    /// Checks the locations of all variables of the text.
    pub(super) fn check_locations(&mut self) {
        let mut known = KnownLocations::default();
        for pou in self.model.pous.iter().map(|entry| entry.pou).collect::<Vec<_>>() {
            for block in &pou.blocks {
                self.check_located_section(Some(pou), block, &mut known);
            }
        }
        for block in self.global_blocks.clone() {
            self.check_located_section(None, block, &mut known);
        }
        let configurations = self.configurations.iter();
        let configured = configurations.flat_map(|configuration| &configuration.configured);
        for block in configured.collect::<Vec<_>>() {
            self.check_located_section(None, block, &mut known);
        }
    }

    fn check_located_section(
        &mut self,
        pou: Option<&Pou<'u>>,
        block: &VariableBlock<'u>,
        known: &mut KnownLocations,
    ) {
        let located = || {
            let groups = block.groups.iter();
            groups.filter_map(|group| Some((group.location?, group.is_partly_located())))
        };
        let in_program = pou.is_none_or(|pou| pou.kind == PouKind::Program);
        let is_configured = block.kind == VariableKind::Configured;
        let holds = matches!(block.kind, VariableKind::Local | VariableKind::Global) || is_configured;
        let mixed = located().count() < block.groups.len() && !self.model.source.dialect.mixed_locations;
        let mixed = mixed && !is_configured;
        for (location, is_partly_located) in located() {
            if mixed {
                let message = "variables with a location stand in a section of their own";
                self.report(Code::MixedLocatedVarDeclarationNotAllowed, location.span, message);
            } else if is_partly_located && holds && pou.is_some() {
                // A VAR_CONFIG completes it, if in a function block for each instance.
            } else if !in_program || !holds {
                let message =
                    "locations of other variables than those of programs and global ones are not implemented";
                self.report(Code::NotImplemented, location.span, message);
            } else if !known.insert(location.text) {
                let message = format!(
                    "`{}` may share bits with another variable, which is not implemented",
                    location.text
                );
                self.report(Code::NotImplemented, location.span, message);
            }
        }
    }
}

/// The locations of a text so far: those of each area, with the size and the number of levels that they have in common.
#[derive(Debug, Default)]
struct KnownLocations {
    areas: FxHashMap<u8, ((u8, usize), FxHashSet<String>)>,
}

impl KnownLocations {
    /// Adds a location; returns whether it has no bit in common with an earlier one for sure: it is in another area, or of the same size with
    /// another address of as many levels.
    fn insert(&mut self, location: &str) -> bool {
        let letter = |at: usize| location.as_bytes().get(at).map_or(b'X', u8::to_ascii_uppercase);
        let size = Some(letter(2)).filter(u8::is_ascii_alphabetic).unwrap_or(b'X');
        let numbers = location.trim_start_matches(|sign: char| !sign.is_ascii_digit());
        let numbers: Vec<&str> = numbers
            .split('.')
            .map(|number| number.trim_start_matches('0'))
            .collect();
        let form = (size, numbers.len());
        let (common, addresses) = self
            .areas
            .entry(letter(1))
            .or_insert_with(|| (form, FxHashSet::default()));
        *common == form && addresses.insert(numbers.join("."))
    }
}

#[cfg(test)]
mod tests {
    use super::KnownLocations;

    #[test]
    fn locations_of_one_area_are_apart_where_size_and_address_say_so() {
        let mut known = KnownLocations::default();
        for (location, apart) in [
            ("%MW5", true),
            ("%mw6", true),
            ("%MW05", false),
            ("%MD7", false),
            ("%IX0.0", true),
            ("%I0.1", true),
            ("%IX0.01", false),
            ("%IX7", false),
            ("%QL1.2.3", true),
        ] {
            assert_eq!(known.insert(location), apart, "{location}");
        }
    }
}
