//! Engines by the names that people give them on the command line.

use crate::exit::{NoSuchEngine, SpeaksNone};
use stickler_engines::{Compiler, Engine, Identity, ProcessEngine, ProcessLimits, Reference};
use stickler_types::DialectName;

/// The name of the engine that is always there.
pub const REFERENCE: &str = "reference";

/// What stands in front of the command line of an engine that is a process.
pub const COMMAND: &str = "cmd:";

/// The engine of this name: `reference`, a compiler for which there is an adapter, or `cmd:COMMAND LINE` for a program
/// that speaks the wire protocol.
///
/// # Errors
/// [`NoSuchEngine`] where nothing is called so; an [`EngineError`](stickler_engines::EngineError) where the compiler is
/// not on this machine, or the program cannot be started or says no `hello`.
pub fn by_name(name: &str) -> anyhow::Result<Box<dyn Engine>> {
    distinct(name, &[])
}

/// An engine, and the name by which it was asked for.
pub struct Named {
    /// The engine.
    pub engine: Box<dyn Engine>,
    /// What stands behind `--engine` to get it again.
    pub asked_for: String,
}

impl Named {
    /// Who it is.
    pub fn identity(&self) -> &Identity {
        self.engine.identity()
    }
}

/// The engines of these names, each once; the reference where none is named. No two of them have the same identity:
/// where one calls itself as another does, it gets a number, as in `my-compiler-2`.
///
/// # Errors
/// Those of [`by_name`], for the first name that has one.
pub fn by_names(names: &[String]) -> anyhow::Result<Vec<Named>> {
    let reference = [REFERENCE.to_owned()];
    let names = if names.is_empty() { &reference[..] } else { names };
    let mut engines: Vec<Named> = Vec::with_capacity(names.len());
    for (index, name) in names.iter().enumerate() {
        if names[..index].contains(name) {
            continue;
        }
        // The reference never gets a number, so no engine before it may be called so.
        let taken: Vec<&str> = names
            .iter()
            .map(String::as_str)
            .filter(|name| *name == REFERENCE)
            .chain(engines.iter().map(|named| named.identity().name.as_str()))
            .collect();
        let engine = distinct(name, &taken)?;
        engines.push(Named {
            engine,
            asked_for: name.clone(),
        });
    }
    Ok(engines)
}

/// Those of the dialects that an engine speaks.
///
/// # Errors
/// Where it speaks none of them.
pub fn spoken(identity: &Identity, asked: &[DialectName]) -> anyhow::Result<Vec<DialectName>> {
    let speaks = |dialect: &DialectName| identity.speaks(*dialect);
    let spoken: Vec<DialectName> = asked.iter().copied().filter(speaks).collect();
    if spoken.is_empty() {
        let names = |dialects: &[DialectName]| {
            let names: Vec<&str> = dialects.iter().map(|dialect| dialect.as_str()).collect();
            names.join(", ")
        };
        return Err(SpeaksNone {
            engine: identity.name.clone(),
            asked: names(asked),
            spoken: names(&identity.dialects),
        }
        .into());
    }
    Ok(spoken)
}

/// The engine of this name, under an identity that none of the others has.
fn distinct(name: &str, taken: &[&str]) -> anyhow::Result<Box<dyn Engine>> {
    if name == REFERENCE {
        return Ok(Box::new(Reference::default()));
    }
    if let Some(compiler) = Compiler::from_name(name) {
        return Ok(compiler.engine(&free(compiler.name(), taken))?);
    }
    let Some(line) = name.strip_prefix(COMMAND) else {
        return Err(NoSuchEngine(name.to_owned()).into());
    };
    let engine = ProcessEngine::start(line, ProcessLimits::default())?;
    let own = engine.identity().name.clone();
    let engine = match free(&own, taken) {
        free if free == own => engine,
        free => engine.named(free),
    };
    Ok(Box::new(engine))
}

fn free(own: &str, taken: &[&str]) -> String {
    if !taken.contains(&own) {
        return own.to_owned();
    }
    let mut number = 2;
    loop {
        let name = format!("{own}-{number}");
        if !taken.contains(&name.as_str()) {
            return name;
        }
        number += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::{by_name, by_names, free};

    #[test]
    fn an_engine_that_is_named_twice_is_used_once() {
        let names = ["reference".to_owned(), "reference".to_owned()];
        assert_eq!(by_names(&names).unwrap().len(), 1);
        assert_eq!(by_names(&[]).unwrap().len(), 1);
    }

    #[test]
    fn a_name_that_no_engine_has_is_an_error() {
        let names = ["reference".to_owned(), "nobody".to_owned()];
        let error = by_names(&names).err().unwrap().to_string();
        assert!(
            error.contains("`nobody`") && error.contains("`cmd:COMMAND LINE`"),
            "{error}"
        );
        assert!(by_name("cmd:no-such-program-anywhere").is_err());
    }

    #[test]
    fn engines_that_call_themselves_the_same_are_told_apart() {
        assert_eq!(free("st", &["reference"]), "st");
        assert_eq!(free("st", &["st", "st-2"]), "st-3");
    }
}
