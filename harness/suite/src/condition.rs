//! Conditions under which a mark or a probe applies: `if no|open`, `if row = ANY_INT and column <> row`.

use stickler_types::{ElementaryType, GenericType, MatrixWord};

/// A conjunction of tests; without a test it always holds.
#[derive(Clone, Debug, Default)]
pub(crate) struct Condition(Vec<PlaceholderTest>);

#[derive(Clone, Debug)]
struct PlaceholderTest {
    /// The index of the placeholder that is tested.
    slot: usize,
    /// Whether the test is `<>`: then none of the alternatives may match.
    negated: bool,
    alternatives: Vec<Alternative>,
}

#[derive(Clone, Debug)]
enum Alternative {
    Text(Box<str>),
    /// The text of another placeholder.
    Slot(usize),
    Generic(GenericType),
}

/// The placeholders that a condition may test.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Testable<'a> {
    /// The names of the placeholders, by index.
    pub(crate) names: &'a [Box<str>],
    /// The number of placeholders, counted from the first, whose values are known when conditions are tested.
    pub(crate) known: usize,
    /// The placeholder that a condition without a name tests: the word of the cell.
    pub(crate) unnamed: Option<usize>,
}

impl Condition {
    /// Reads the words behind `if`.
    pub(crate) fn parse(words: &[&str], testable: Testable<'_>) -> Result<Condition, String> {
        words
            .split(|&word| word == "and")
            .map(|test| PlaceholderTest::parse(test, testable))
            .collect::<Result<_, _>>()
            .map(Condition)
    }

    /// Adds the tests of another condition.
    pub(crate) fn and(&mut self, other: Condition) {
        self.0.extend(other.0);
    }

    /// Returns whether the condition holds for these values of the placeholders.
    pub(crate) fn holds(&self, values: &[&str]) -> bool {
        self.0.iter().all(|test| test.holds(values))
    }

    /// Returns the indices of the placeholders that the condition tests.
    pub(crate) fn slots(&self) -> impl Iterator<Item = usize> {
        self.0.iter().flat_map(|test| {
            let others = test
                .alternatives
                .iter()
                .filter_map(|alternative| match alternative {
                    Alternative::Slot(slot) => Some(*slot),
                    _ => None,
                });
            std::iter::once(test.slot).chain(others)
        })
    }
}

impl PlaceholderTest {
    fn parse(words: &[&str], testable: Testable<'_>) -> Result<PlaceholderTest, String> {
        match words {
            [] => Err("`if` and `and` need a condition behind them".to_owned()),
            [name, sign @ ("=" | "<>"), rest @ ..] if !rest.is_empty() && rest[0] != "|" => {
                let slot = testable.slot(name)?;
                let alternatives = alternatives(rest, testable)?;
                Ok(PlaceholderTest {
                    slot,
                    negated: *sign == "<>",
                    alternatives,
                })
            }
            _ => match testable.unnamed {
                Some(slot) => Ok(PlaceholderTest {
                    slot,
                    negated: false,
                    alternatives: words_of_cells(words)?,
                }),
                None => Err(format!(
                    "`{}` is no condition; write `if NAME = WORD`",
                    words.join(" ")
                )),
            },
        }
    }

    fn holds(&self, values: &[&str]) -> bool {
        let text = values[self.slot];
        let fits = self.alternatives.iter().any(|alternative| match alternative {
            Alternative::Text(word) => **word == *text,
            Alternative::Slot(slot) => values[*slot] == text,
            Alternative::Generic(generic) => {
                ElementaryType::from_name(text).is_some_and(|ty| generic.contains(ty))
            }
        });
        fits != self.negated
    }
}

impl Testable<'_> {
    fn slot(self, name: &str) -> Result<usize, String> {
        match self.names.iter().position(|known| **known == *name) {
            Some(slot) if slot < self.known => Ok(slot),
            Some(_) => Err(format!("a condition cannot test `{name}`: it is not known yet")),
            None => Err(format!(
                "no placeholder `{name}` to test; there are {}",
                self.names[..self.known].join(", ")
            )),
        }
    }
}

fn alternatives(words: &[&str], testable: Testable<'_>) -> Result<Vec<Alternative>, String> {
    let joined = words.join(" ");
    joined
        .split('|')
        .map(|word| match word.trim() {
            "" => Err(format!("`{joined}` has an empty alternative")),
            word => Ok(match (GenericType::from_word(word), testable.slot(word)) {
                (Some(generic), _) => Alternative::Generic(generic),
                (None, Ok(slot)) => Alternative::Slot(slot),
                (None, Err(_)) => Alternative::Text(word.into()),
            }),
        })
        .collect()
}

fn words_of_cells(words: &[&str]) -> Result<Vec<Alternative>, String> {
    let joined = words.concat();
    joined
        .split('|')
        .map(|word| match MatrixWord::from_word(word) {
            Some(word) => Ok(Alternative::Text(word.as_str().into())),
            None => Err(format!(
                "`{word}` is no word of a cell; there are yes, warn, no, open and =, and `NAME = WORD`"
            )),
        })
        .collect()
}
