//! Mistakes in case files, with their place and a hint, and suggestions for names that nobody knows.

use std::fmt;

/// One mistake in one case file. The rest of the suite still loads.
///
/// Messages are lower-case fragments, for `file:line: message`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default, thiserror::Error)]
pub struct CaseFileError {
    /// The file, relative to the suite's parent folder, with forward slashes.
    pub file: String,
    /// The 1-based line; 1 where the whole file is meant.
    pub line: u32,
    /// The wrong key, if the mistake belongs to one: `probe.values`.
    pub key: Option<String>,
    /// A description of the mistake.
    pub message: String,
    /// A suggestion how to correct the mistake, if there is one.
    pub hint: Option<String>,
}

impl fmt::Display for CaseFileError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}:{}: ", self.file, self.line)?;
        if let Some(key) = &self.key {
            write!(formatter, "`{key}`: ")?;
        }
        formatter.write_str(&self.message)?;
        self.hint
            .as_ref()
            .map_or(Ok(()), |hint| write!(formatter, " ({hint})"))
    }
}

/// A mistake whose file is still to be named: the error of the functions that read a part of a file.
pub(crate) type Mistake = CaseFileError;

impl CaseFileError {
    /// Returns a mistake of a file that [`in_file`](CaseFileError::in_file) names.
    pub(crate) fn new(line: u32, message: impl Into<String>) -> Self {
        CaseFileError {
            line,
            message: message.into(),
            ..CaseFileError::default()
        }
    }

    pub(crate) fn key(mut self, key: impl Into<String>) -> Self {
        self.key = Some(key.into());
        self
    }

    pub(crate) fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }

    pub(crate) fn in_file(self, file: &str) -> CaseFileError {
        let file = file.to_owned();
        CaseFileError { file, ..self }
    }
}

/// Returns mistakes as those of a file.
pub(crate) fn in_file(mistakes: Vec<Mistake>, file: &str) -> Vec<CaseFileError> {
    let mistakes = mistakes.into_iter();
    mistakes.map(|mistake| mistake.in_file(file)).collect()
}

/// The number of names up to which all of them are told.
const FEW: usize = 12;

/// Returns what a message about an unknown name ends with: the nearest of the `known` names, or all of them where none is near
/// and they are few.
pub(crate) fn suggestion<'n>(name: &str, known: impl Iterator<Item = &'n str>) -> String {
    let known: Vec<&str> = known.collect();
    let distance = |other: &str| strsim::damerau_levenshtein(&name.to_lowercase(), &other.to_lowercase());
    let nearest = known.iter().map(|other| (distance(other), *other)).min();
    match nearest {
        Some((distance, other)) if distance <= (other.chars().count() / 3).max(1) => {
            format!("did you mean `{other}`?")
        }
        None => "there is none".to_owned(),
        Some(_) if known.len() <= FEW => format!("there are {}", known.join(" · ")),
        Some((_, other)) => format!("there are {}, the nearest is `{other}`", known.len()),
    }
}
