//! What a dialect has, by its documents: types, implicit conversions, and conversion functions whose results are settled.

use super::literals;
use std::sync::LazyLock;
use stickler_exact::{Signature, Word, expected, functions, implicit, signatures};
use stickler_types::{DialectName, ElementaryType, Value};

/// How much of what a conversion gives is said by documents.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Settled {
    /// What every value gives.
    Always,
    /// What some values give.
    Sometimes,
    /// Nothing.
    Never,
}

/// A conversion function of one argument.
pub(super) struct Offer {
    pub signature: Signature,
    pub settled: Settled,
}

/// One dialect.
pub(super) struct Language {
    /// The elementary types, BOOL and INT first.
    pub types: Vec<ElementaryType>,
    /// The types that become a type without a call, by that type's place in the declaration.
    sources: Vec<Vec<ElementaryType>>,
    /// The conversion functions that give a type, by that type's place in the declaration.
    offers: Vec<Vec<Offer>>,
}

static LANGUAGES: [LazyLock<Language>; DialectName::ALL.len()] = [
    LazyLock::new(|| Language::written_out(DialectName::IronplcEd2)),
    LazyLock::new(|| Language::written_out(DialectName::IronplcEd3)),
    LazyLock::new(|| Language::written_out(DialectName::IronplcRusty)),
    LazyLock::new(|| Language::written_out(DialectName::Matiec)),
    LazyLock::new(|| Language::written_out(DialectName::Plcnext)),
];

impl Language {
    pub fn of(dialect: DialectName) -> &'static Language {
        &LANGUAGES[dialect as usize]
    }

    /// The types that become `into` without a call.
    pub fn sources(&self, into: ElementaryType) -> &[ElementaryType] {
        &self.sources[into as usize]
    }

    /// The conversion functions that give a value of this type.
    pub fn offers(&self, result: ElementaryType) -> &[Offer] {
        &self.offers[result as usize]
    }

    /// The function `<FROM>_TO_<INTO>`, if its results are always settled.
    pub fn settled(&self, from: ElementaryType, into: ElementaryType) -> Option<&Signature> {
        let name = format!("{from}_TO_{into}");
        let offers = self.offers(into).iter();
        let mut settled = offers.filter(|offer| offer.settled == Settled::Always);
        settled
            .find(|offer| offer.signature.function == name)
            .map(|offer| &offer.signature)
    }

    fn written_out(dialect: DialectName) -> Language {
        let types = types(dialect);
        let sources = ElementaryType::ALL.map(|into| {
            let becomes =
                |from: &ElementaryType| *from != into && implicit(*from, into, dialect) == Word::Yes;
            types.iter().copied().filter(becomes).collect()
        });
        let mut offers: Vec<Vec<Offer>> = ElementaryType::ALL.map(|_| Vec::new()).into();
        for function in functions(dialect) {
            for signature in signatures(&function, dialect) {
                let &[from] = &signature.operands[..] else {
                    continue;
                };
                if types.contains(&from) && types.contains(&signature.result) {
                    offers[signature.result as usize].push(Offer {
                        settled: settled(&signature, from, dialect),
                        signature,
                    });
                }
            }
        }
        Language {
            types,
            sources: sources.into(),
            offers,
        }
    }
}

/// The elementary types of a dialect; those that its documents or its compiler name.
///
/// Basis: ironplc-bit-access: Edition 3 Partial-Access Syntax (the editions of its dialects); stickler-design: §8.
fn types(dialect: DialectName) -> Vec<ElementaryType> {
    let third_edition = !matches!(dialect, DialectName::IronplcEd2 | DialectName::Matiec);
    let has = |ty: &ElementaryType| {
        (third_edition || !ty.is_third_edition())
            && !(dialect == DialectName::Matiec && *ty == ElementaryType::Wstring)
    };
    ElementaryType::ALL.into_iter().filter(has).collect()
}

/// How much of what a conversion gives documents say, tried on boundary values.
fn settled(signature: &Signature, from: ElementaryType, dialect: DialectName) -> Settled {
    let values = literals::boundaries(from);
    let said = values
        .iter()
        .filter(|value| {
            let operand: [Value; 1] = [(*value).clone()];
            expected(signature, &operand, dialect).basis.is_some()
        })
        .count();
    match said {
        0 => Settled::Never,
        _ if said == values.len() => Settled::Always,
        _ => Settled::Sometimes,
    }
}
