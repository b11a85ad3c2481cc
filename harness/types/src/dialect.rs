//! The language rules of a dialect: what the sources leave to a system.
//!
//! The file of a dialect, `conformance-cases/dialects/NAME.toml` or a table of `stickler.toml`, states those in which it differs
//! from the [defaults](Dialect::DEFAULT) or from the dialect that it extends. A new choice is one table of `choices.toml`, and its
//! options one of `options.toml`; its meaning is implemented twice, independently: by the reference and by exact arithmetic.

use crate::choice::{Choice, choices};
pub use crate::options::{
    ComparedTypes, ConstantTypes, FreeWords, ImplicitWarnings, OperandTypes, PartialAccess, ResultSigns,
    ShiftCounts, TextElements, TextPositions, ThirdEditionTypes, Widening,
};
use crate::{
    ConversionChoices, DeclaredFeatures, DialectName, Documents, ElementaryType, MatrixWord, Rounding, Value,
};
use std::collections::BTreeMap;
use toml::de::DeValue;

/// The kind of a dialect, which says whose cases it has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DialectKind {
    /// A documented system, which case files name.
    Documented,
    /// A documented system with compiler options on or off, which case files name; it takes over no cases.
    Variant,
    /// A dialect of `stickler.toml`, which takes over the cases of its base.
    Custom,
}

/// A statement of a dialect's file about a pair of types.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Stated {
    /// Whether the types convert.
    pub value: MatrixWord,
    /// The basis of an expectation that follows from the statement, in the form of a case file: `mine: implicit INT.BOOL
    /// (stickler.toml:9)`. `None` in the file of a documented system, whose documents are the basis.
    pub basis: Option<String>,
}

/// A pair of types: that of a value, and that of its target.
pub type Pair = (ElementaryType, ElementaryType);

/// The greatest length of a STRING that is declared without one, where a dialect says no other; the standard leaves it open.
pub const DEFAULT_TEXT_LENGTH: u32 = 254;

/// Declares the choices of `choices.toml`, which the build script puts into its call.
macro_rules! language_choices {
    ($($choices:tt)*) => {
        choices! {
            /// A dialect: the content of its file over that of the files that it extends. Each choice names a point in which the sources
            /// differ (conformance-cases/sources.toml and rules.md name the basis of each).
            ///
            /// The defaults are the rules of the third edition that most systems share, without implicit conversions. Basis: iec-61131-3: third
            /// edition, Tables 3, 5, 10, 71; rule: not-stated for what is open.
            #[derive(Clone, PartialEq, Eq, Debug)]
            Dialect { $($choices)* } beside {
                /// The handle of the dialect; that of its base while the dialect is not defined yet.
                name: DialectName = DialectName::IEC_ED3;
                /// The name as it is written.
                spelling: String = String::new();
                /// The name of the system, for people.
                title: String = String::new();
                /// The documented system that it is, or whose rules apply where the file states nothing.
                base: DialectName = DialectName::IEC_ED3;
                /// A description of the dialect, for people.
                about: Option<String> = None;
                /// The kind of the dialect.
                kind: DialectKind = DialectKind::Documented;
                /// The file and line of the definition, such as `stickler.toml:3`.
                place: String = String::new();
                /// The statements of the documents of the system, in the words by which exact arithmetic and the generator know them.
                documents: Documents = Documents::DEFAULT;
                /// The features of the language that the system declares to have or to lack.
                features: DeclaredFeatures = DeclaredFeatures::NONE;
                /// The system beside which it is asked only where the two differ, and a sample of the rest: another edition of one compiler.
                asked_beside: Option<String> = None;
                /// The pairs of types for which the file states whether they convert implicitly, whatever `widening` says.
                cells: BTreeMap<Pair, Stated> = BTreeMap::new();
                /// The names that the system has for types and functions of the standard, in capital letters.
                names: BTreeMap<String, String> = BTreeMap::new();
                /// The types that TO_INT and its kin take, by the type that they give, where they do not take all that have a meaning.
                inputs: BTreeMap<ElementaryType, &'static [ElementaryType]> = BTreeMap::new();
                /// The least and the greatest value of durations and dates that the system has, and the length of which all are multiples, in nanoseconds.
                ranges: BTreeMap<ElementaryType, Vec<i64>> = BTreeMap::new();
                /// The bases of the statements that are made beside the documents, by their keys: `mine: rounding (stickler.toml:9)`.
                stated: BTreeMap<&'static str, String> = BTreeMap::new();
                /// The choices of conversion functions, and of implicit conversions, where systems differ.
                conversions: ConversionChoices = ConversionChoices::DEFAULT;
            }
        }
    };
}

include!(concat!(env!("OUT_DIR"), "/language_choices.rs"));

/// The conversion choices that most documented systems share: the defaults, and truncation.
pub const COMMON_CHOICES: ConversionChoices = ConversionChoices::DEFAULT.with_rounding(Rounding::Truncate);

/// The tables of choices, in the order in which reports list what a dialect overrides.
pub(crate) const TABLES: [&str; 4] = ["flags", "language", "conversions", "operators"];

/// The key of the flag that stands for cells of the matrix of implicit conversions.
const CROSS_FAMILY: &str = "flags.allow-cross-family-widening";

impl Dialect {
    /// Returns the rules of a dialect.
    pub fn of(name: DialectName) -> &'static Dialect {
        name.rules()
    }

    /// Returns a custom dialect that overrides nothing of another one.
    pub fn custom(spelling: &str, base: DialectName, place: &str) -> Dialect {
        Dialect::of(base).extended(spelling, place)
    }

    /// Returns a custom dialect of this name that extends this one; what this one states is stated by the other.
    pub(crate) fn extended(&self, spelling: &str, place: &str) -> Dialect {
        let renamed = |basis: &String| {
            let rest = basis.split_once(':').map_or("", |(_, rest)| rest);
            format!("{spelling}:{rest}")
        };
        let cell = |(pair, stated): (&Pair, &Stated)| {
            let basis = stated.basis.as_ref().map(renamed);
            (*pair, Stated { basis, ..*stated })
        };
        let stated = |(key, basis): (&&'static str, &String)| (*key, renamed(basis));
        Dialect {
            spelling: spelling.to_owned(),
            about: None,
            kind: DialectKind::Custom,
            asked_beside: None,
            place: place.to_owned(),
            cells: self.cells.iter().map(cell).collect(),
            stated: self.stated.iter().map(stated).collect(),
            ..self.clone()
        }
    }

    /// Returns the dialect with another choice, which the source `basis` states beside the documents; `value` is written as in the
    /// file: `true`, `"truncate"`. `None` where there is no such key or value.
    pub fn stating(mut self, key: &str, value: &str, basis: &str) -> Option<Dialect> {
        let value = DeValue::parse(value).ok()?;
        self.state(key, value.get_ref(), Some(basis.to_owned()))?.ok()?;
        Some(self)
    }

    /// Returns the dialect with a statement about a pair of types.
    pub fn stating_cell(mut self, pair: Pair, value: MatrixWord, basis: &str) -> Dialect {
        let basis = Some(basis.to_owned());
        self.cells.insert(pair, Stated { value, basis });
        self
    }

    /// Makes the choice of a key such as `flags.bit-access`, and keeps its basis. The error is a message without the key. `None` where
    /// there is no such key.
    pub(crate) fn state(
        &mut self,
        key: &str,
        value: &DeValue<'_>,
        basis: Option<String>,
    ) -> Option<Result<(), String>> {
        let known = Dialect::keys().find(|known| *known == key)?;
        if let Err(message) = self.choice_mut(key)?.state(key, value) {
            return Some(Err(message));
        }
        if key == CROSS_FAMILY && self.kind == DialectKind::Custom {
            self.state_cross_family(basis.as_ref());
        }
        if let Some(basis) = basis {
            self.stated.insert(known, basis);
        }
        if key == "conversions.out-of-range"
            && !self.stated.contains_key("conversions.truncation-out-of-range")
        {
            self.conversions.truncation_out_of_range = self.conversions.out_of_range;
        }
        let has = |ty: &ElementaryType| !ty.is_third_edition();
        if self.third_edition_types == ThirdEditionTypes::None {
            self.cells.retain(|(from, to), _| has(from) && has(to));
        }
        Some(Ok(()))
    }

    /// States the cells that cross-family widening decides: a custom dialect may extend one whose documents do not know it.
    ///
    /// Basis: ironplc-type-conversions: Cross-family widening ("an integer type of strictly greater bit width").
    fn state_cross_family(&mut self, basis: Option<&String>) {
        let value = if self.cross_family_widening {
            MatrixWord::Yes
        } else {
            MatrixWord::No
        };
        for from in ElementaryType::ALL.into_iter().filter(|ty| ty.is_bit_string()) {
            let wider = |to: &ElementaryType| to.is_integer() && from.bits() < to.bits();
            for to in ElementaryType::ALL.into_iter().filter(wider) {
                let basis = basis.cloned();
                self.cells.insert((from, to), Stated { value, basis });
            }
        }
    }

    fn choice(&self, key: &str) -> Option<&dyn Choice> {
        match key.split_once('.') {
            Some(("conversions", _)) => self.conversions.own_choice(key),
            Some(("documents", _)) => self.documents.own_choice(key),
            _ => self.own_choice(key),
        }
    }

    fn choice_mut(&mut self, key: &str) -> Option<&mut dyn Choice> {
        match key.split_once('.') {
            Some(("conversions", _)) => self.conversions.own_choice_mut(key),
            Some(("documents", _)) => self.documents.own_choice_mut(key),
            _ => self.own_choice_mut(key),
        }
    }

    /// Returns the keys of all choices.
    fn keys() -> impl Iterator<Item = &'static str> {
        let all = [Dialect::KEYS, ConversionChoices::KEYS, Documents::KEYS];
        all.into_iter().flatten().copied()
    }

    /// Returns the keys of a table, without its name.
    pub(crate) fn keys_of(table: &str) -> impl Iterator<Item = &'static str> {
        Dialect::keys().filter_map(move |key| key.strip_prefix(table)?.strip_prefix('.'))
    }

    /// Returns the statements that are made beside the documents of the base, each with its value: `flags.bit-access`, `true`.
    pub fn statements(&self) -> impl Iterator<Item = (&'static str, String)> {
        let keys = TABLES.into_iter().flat_map(|table| {
            let is_of_table = move |key: &&str| key.split_once('.').is_some_and(|(own, _)| own == table);
            Dialect::keys().filter(is_of_table)
        });
        keys.filter(|key| self.stated.contains_key(key))
            .filter_map(|key| Some((key, self.choice(key)?.written(key).into_owned())))
    }

    /// Returns every choice of the dialect in the notation of its file: `conversions.rounding`, `truncate`.
    pub fn all_choices(&self) -> impl Iterator<Item = (&'static str, String)> {
        let is_choice = |key: &&str| TABLES.iter().any(|table| key.split('.').next() == Some(table));
        let written = |key| Some((key, self.choice(key)?.written(key).into_owned()));
        Dialect::keys().filter(is_choice).filter_map(written)
    }

    /// Returns the overrides in the notation of `stickler.toml`: `implicit INT.BOOL = yes`.
    pub fn overrides(&self) -> Vec<String> {
        // The flag stands for these.
        let cross_family = self.stated.get(CROSS_FAMILY);
        let cells = self
            .cells
            .iter()
            .filter(|(_, stated)| stated.basis.as_ref() != cross_family);
        let cells =
            cells.map(|((from, to), stated)| format!("implicit {from}.{to} = {}", stated.value.as_str()));
        let choices = self.statements().map(|(key, value)| {
            let name = key.split_once('.').map_or(key, |(_, name)| name);
            format!("{name} = {value}")
        });
        cells.chain(choices).collect()
    }

    /// Returns the basis of the statement under a key, if one is made beside the documents of the base.
    pub fn basis(&self, key: &str) -> Option<&str> {
        self.stated.get(key).map(String::as_str)
    }

    /// Returns the statement about a pair of types; `None` if there is none.
    pub fn implicit(&self, from: ElementaryType, to: ElementaryType) -> Option<&Stated> {
        self.cells.get(&(from, to))
    }

    /// Returns whether the system lacks a feature of the list `conformance-cases/features.toml`, by its own words or by the choices of its
    /// file.
    pub fn lacks(&self, feature: &str) -> bool {
        use ElementaryType::{Ldate, Ldt, Ltime, Ltod};
        let by_choice = match feature {
            "long-duration-literal" => !self.has(Ltime),
            "long-date-literal" => !self.has(Ldate),
            "long-time-of-day-literal" => !self.has(Ltod),
            "long-date-and-time-literal" => !self.has(Ldt),
            "wstring" | "wide-string-literal" => !self.documents.wide_strings,
            "bit-access" => !self.bit_access,
            "partial-access-bit" => !self.partial_access.is_enabled(),
            "partial-access-byte" | "partial-access-word" | "partial-access-double-word" => {
                !self.partial_access.has_wider_parts()
            }
            "text-element" => self.text_elements == TextElements::None,
            "line-comment" => !self.line_comments,
            "nested-comment" => !self.nested_comments,
            "ampersand" | "power" => !self.ampersand_and_power,
            "round" | "ceil" | "ceiling" | "floor" => !self.rounding_functions,
            _ => ElementaryType::from_name(feature).is_some_and(|ty| !self.has(ty)),
        };
        by_choice || self.features.lacks.iter().any(|lacked| lacked == feature)
    }

    /// Returns the name that the standard has for what the system calls by this one, which itself is returned otherwise.
    pub fn standard_name<'n>(&'n self, name: &'n str) -> &'n str {
        let has_names = !self.names.is_empty();
        let own = has_names.then(|| self.names.get(&name.to_ascii_uppercase()));
        own.flatten().map_or(name, String::as_str)
    }

    /// Returns whether the system has a value, as far as its documents say of durations and dates.
    pub fn holds(&self, value: &Value) -> bool {
        let (Value::Plain { ty, raw }, false) = (value, self.ranges.is_empty()) else {
            return true;
        };
        match (self.ranges.get(ty).map(Vec::as_slice), raw.cast_signed()) {
            (Some([least, greatest, step @ ..]), raw) => {
                (*least..=*greatest).contains(&raw) && step.iter().all(|step| raw % step == 0)
            }
            _ => true,
        }
    }

    /// Returns the elementary type of this name, by the standard or of the system's own; it may be one that the dialect does not have.
    pub fn elementary(&self, name: &str) -> Option<ElementaryType> {
        ElementaryType::from_name(self.standard_name(name))
    }

    /// Returns whether the edition of the dialect has this elementary type.
    pub const fn has(&self, ty: ElementaryType) -> bool {
        !ty.is_third_edition() || self.third_edition_types.includes(ty)
    }

    /// Returns whether a program may name this elementary type: the edition of the dialect has it, and its documents do not say that it lacks it.
    pub fn may_name(&self, ty: ElementaryType) -> bool {
        self.has(ty) && !self.features.lacked_types.contains(&ty)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_has_its_own_dialect() {
        for name in DialectName::ALL {
            assert_eq!(Dialect::of(name).name, name);
        }
    }

    #[test]
    fn the_second_edition_lacks_the_types_of_the_third() {
        let has = |name| Dialect::of(name).has(ElementaryType::Ltime);
        assert_eq!(
            DialectName::ALL.map(has),
            [
                false, true, true, false, true, true, true, true, true, true, true, true, true, true, false,
                true
            ]
        );
        assert!(Dialect::of(DialectName::IRONPLC_ED2).has(ElementaryType::Time));
    }

    #[test]
    fn a_dialect_that_overrides_nothing_says_nothing() {
        let mine = Dialect::custom("mine", DialectName::PLCNEXT, "stickler.toml:1");
        assert_eq!(mine.basis("flags.bit-access"), None);
        assert_eq!(mine.implicit(ElementaryType::Int, ElementaryType::Bool), None);
        assert_eq!(mine.overrides(), [""; 0]);
        assert!(
            mine.clone()
                .stating("flags.bit-acces", "true", "mine: it")
                .is_none()
        );
        assert!(mine.stating("flags.bit-access", "'yes'", "mine: it").is_none());
    }

    #[test]
    fn every_key_makes_its_choice_and_is_written_as_it_was_read() {
        let mine = Dialect::custom("mine", DialectName::CODESYS, "here");
        for key in Dialect::keys() {
            let written = mine.choice(key).expect(key).written(key);
            let values = [format!("{written}"), format!("'{written}'")];
            let found: Vec<Dialect> = values
                .iter()
                .filter_map(|value| mine.clone().stating(key, value, "mine: test"))
                .collect();
            let [stated] = &found[..] else {
                panic!("{key} = {written}")
            };
            assert_eq!(stated.choice(key).expect(key).written(key), written, "{key}");
            assert_eq!(stated.basis(key), Some("mine: test"));
        }
    }
}
