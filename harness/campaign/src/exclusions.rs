//! Parts of the language that the programs of a campaign shall not have, so that a compiler that lacks one of them does not
//! hide what else is wrong.
//!
//! The words are those that a finding shows for its program ([`crate::Finding::rule`]): what a compiler was found to reject
//! can be left out by the word that the finding has for it.

use stickler_exact::signatures;
use stickler_generate::features::features;
use stickler_generate::model::Program;
use stickler_suite::Features;
use stickler_types::{DialectName, ElementaryType};

/// The parts of the language that programs shall not have, by their words.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Exclusions(Vec<Exclusion>);

/// The word of a part of the language, and the dialect whose programs shall not have it; of all dialects where it names none.
type Exclusion = (String, Option<DialectName>);

/// A word that names no part of the language that can be left out.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error(
    "`{0}` is nothing that can be left out; there are: the elementary types (`INT`), literals with their type (`INT#`), \
     conversion functions (`INT_TO_REAL`), implicit conversions (`INT to REAL`), and the features that `stickler list --features` \
     lists (`mux`, `array-one-element`)"
)]
pub struct UnknownWord(String);

impl Exclusions {
    /// Reads the words, in any case. A word may be followed by `@` and a dialect, of whose programs alone it speaks then.
    ///
    /// # Errors
    /// [`UnknownWord`]: the first that stands for nothing, so that a slip does not pass for a wish that was granted.
    pub fn new(words: &[String]) -> Result<Exclusions, UnknownWord> {
        let known = |text: &String| {
            let parts = text.rsplit_once('@');
            let limited = parts.and_then(|(word, dialect)| Some((word, Some(dialect.parse().ok()?))));
            let (word, dialect) = limited.unwrap_or((text, None));
            match is_known(word) {
                true => Ok((word.to_owned(), dialect)),
                false => Err(UnknownWord(text.clone())),
            }
        };
        words.iter().map(known).collect::<Result<_, _>>().map(Exclusions)
    }

    /// Returns whether the program has nothing that is excluded.
    pub(crate) fn admits(&self, program: &Program) -> bool {
        let own = self.words(program.dialect);
        if own.is_empty() {
            return true;
        }
        let has = features(program);
        let unwanted = |name: &String| own.iter().any(|word| word.eq_ignore_ascii_case(name));
        !has.keys().any(unwanted)
    }

    /// Returns the words for what programs of a dialect shall not have.
    pub(crate) fn words(&self, dialect: DialectName) -> Vec<String> {
        let applies = |(_, limit): &&Exclusion| limit.is_none_or(|own| own == dialect);
        let own = self.0.iter().filter(applies);
        own.map(|(word, _)| word.clone()).collect()
    }
}

fn is_known(word: &str) -> bool {
    let is_type = |word: &str| {
        ElementaryType::ALL
            .iter()
            .any(|ty| ty.name().eq_ignore_ascii_case(word))
    };
    let is_function = || {
        DialectName::ALL
            .iter()
            .any(|&dialect| !signatures(word, dialect).is_empty())
    };
    let is_implicit = || {
        let upper = word.to_ascii_uppercase();
        let ends = upper.split_once(" TO ");
        ends.is_some_and(|(from, to)| is_type(from) && is_type(to))
    };
    Features::built_in().get(&word.to_ascii_lowercase()).is_some()
        || is_type(word.strip_suffix('#').unwrap_or(word))
        || is_function()
        || is_implicit()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inputs::Inputs;
    use stickler_generate::model::Type;
    use stickler_mdtest::assert_fits;

    fn without(words: &[&str]) -> Result<Exclusions, UnknownWord> {
        Exclusions::new(&words.iter().map(|&word| word.to_owned()).collect::<Vec<_>>())
    }

    #[test]
    fn every_feature_of_a_program_can_be_left_out() {
        for place in 0..300 {
            let program = Inputs::new(9).program(place, &DialectName::ALL, true);
            let names: Vec<String> = features(&program).into_keys().collect();
            assert_eq!(Exclusions::new(&names).map(|_| ()), Ok(()), "at {place}");
        }
    }

    #[test]
    fn a_word_that_stands_for_nothing_is_a_mistake() {
        let known = "MUX,mux,CHAR,int_to_real,INT to REAL,array-one-element,array-initial-value";
        for word in known.split(',') {
            assert!(without(&[word]).is_ok(), "{word}");
        }
        let message = without(&["MUX", "MUXX"]).unwrap_err().to_string();
        assert_fits(&message, "…`MUXX`…list --features…");
    }

    #[test]
    fn what_is_left_out_is_in_no_program() {
        let ed3 = [DialectName::IRONPLC_ED3];
        let unwanted = "MUX,SEL,BOOL#,typed-literal-sign,CHAR,array-one-element,string-escape,INT to DINT";
        let unwanted: Vec<&str> = unwanted.split(',').collect();
        let text = |program: &Program| {
            let style = stickler_generate::writer::Style::default();
            stickler_generate::writer::write(program, &style).text
        };
        let mut came = 0;
        for place in 0..200 {
            let without = without(&unwanted).unwrap();
            let Some(program) = Inputs::new(3).program_without(place, &ed3, false, &without) else {
                continue;
            };
            came += 1;
            let text = text(&program);
            let found = ["MUX(", "SEL(", " CHAR", "$", "BOOL#", "typed-literal-sign"]
                .iter()
                .find(|word| text.contains(**word));
            assert_eq!(found, None, "{text}");
        }
        assert!(came > 190, "{came}");
        let all = Inputs::new(3).program_without(1, &ed3, false, &Exclusions::default());
        assert_eq!(all, Some(Inputs::new(3).program(1, &ed3, false)));
    }

    #[test]
    fn a_word_with_a_dialect_speaks_of_its_programs_alone() {
        let without = without(&["bool@ironplc-ed3"]).unwrap();
        let program = |dialect| Inputs::new(3).program(1, &[dialect], false);
        let has_it = |program: &Program| features(program).contains_key("bool");
        let [second, third] = [DialectName::IRONPLC_ED2, DialectName::IRONPLC_ED3].map(program);
        assert!(has_it(&second) && has_it(&third));
        assert!(without.admits(&second) && !without.admits(&third));
        let unknown = Exclusions::new(&["BOOL@ed3".to_owned()]).unwrap_err().to_string();
        assert!(unknown.contains("`BOOL@ed3`"), "{unknown}");
    }

    #[test]
    fn the_checksum_has_the_widest_integer_that_is_not_left_out() {
        let without = without(&["lint", "ULINT"]).unwrap();
        let program = Inputs::new(3).program_without(0, &[DialectName::MATIEC], false, &without);
        let variables = program.unwrap().main.variables;
        let checksum = variables.iter().find(|variable| variable.name == "checksum");
        let ty = checksum.map(|variable| variable.ty.clone());
        assert_eq!(ty, Some(Type::Elementary(ElementaryType::Dint)));
    }

    #[test]
    fn where_every_program_has_it_none_comes() {
        let types = [
            &ElementaryType::ALL.map(ElementaryType::name)[..],
            &["enumeration"],
        ]
        .concat();
        let without = without(&types).unwrap();
        let program = Inputs::new(3).program_without(0, &[DialectName::MATIEC], false, &without);
        assert_eq!(program, None);
    }
}
