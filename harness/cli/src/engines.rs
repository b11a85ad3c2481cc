//! Engines by the names that people give them on the command line.

use crate::exit::NoSuchEngine;
use stickler_engines::{Engine, Reference};

/// The engine of this name: `reference`.
///
/// # Errors
/// [`NoSuchEngine`] where nothing is called so.
pub fn by_name(name: &str) -> anyhow::Result<Box<dyn Engine>> {
    match name {
        "reference" => Ok(Box::new(Reference::default())),
        _ => Err(NoSuchEngine(name.to_owned()).into()),
    }
}

/// The engines of these names, each once; the reference where none is named.
///
/// # Errors
/// Those of [`by_name`], for the first name that has one.
pub fn by_names(names: &[String]) -> anyhow::Result<Vec<Box<dyn Engine>>> {
    if names.is_empty() {
        return Ok(vec![by_name("reference")?]);
    }
    names
        .iter()
        .enumerate()
        .filter(|(index, name)| !names[..*index].contains(name))
        .map(|(_, name)| by_name(name))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::by_names;

    #[test]
    fn an_engine_that_is_named_twice_is_used_once() {
        let names = ["reference".to_owned(), "reference".to_owned()];
        assert_eq!(by_names(&names).unwrap().len(), 1);
        assert_eq!(by_names(&[]).unwrap().len(), 1);
    }

    #[test]
    fn a_name_that_no_engine_has_is_an_error() {
        let error = by_names(&["reference".to_owned(), "nobody".to_owned()])
            .err()
            .unwrap();
        assert!(error.to_string().contains("`nobody`"), "{error}");
    }
}
