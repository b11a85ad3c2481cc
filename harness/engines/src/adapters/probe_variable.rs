//! Variables that an adapter adds to a program, so that a compiler shows what it would not show otherwise.

use super::source::MainProgram;
use crate::{Observation, Outcome, RunRequest};
use std::collections::BTreeSet;
use stickler_types::ElementaryType;

/// A variable that is added to a program and takes the value of an expression at the end of its main program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct ProbeVariable {
    /// The name of the variable, which no program has: see [`ProbeVariable::name`].
    pub(crate) name: String,
    /// The type of the variable, as it is declared, with an initial value where the variable keeps one.
    pub(crate) type_name: String,
    /// The expression whose value the variable takes; empty where it keeps its initial value.
    pub(crate) expression: String,
}

impl ProbeVariable {
    /// Returns the name of the probe variable of this number.
    pub(super) fn name(number: usize) -> String {
        format!("stickler_probe_{number}")
    }
}

/// Translates a program with its probe variables. Where the compiler does not accept those, the program is translated without
/// them, to tell whether it is accepted itself.
///
/// # Errors
/// The error of `translate` for the program without probe variables; [`Outcome::Unsupported`] where that is accepted, and the
/// probe variables would show nothing or are not accepted.
pub(super) fn translate_with<T>(
    request: &RunRequest<'_>,
    main: &MainProgram,
    probes: &[ProbeVariable],
    mut translate: impl FnMut(&str) -> Result<T, Outcome>,
) -> Result<T, Outcome> {
    if probes.is_empty() {
        return translate(request.source);
    }
    let reason = match with_shown_probes(request, main, probes) {
        Err(reason) => reason,
        Ok(text) => match translate(&text) {
            Ok(translated) => return Ok(translated),
            Err(outcome) => format!("with copies of its values: {outcome}"),
        },
    };
    translate(request.source)?;
    Err(Outcome::Unsupported { reason })
}

/// Adds probe variables to the program of a request, as [`with_probes`] does.
///
/// # Errors
/// A fragment that says why the probe variables would show nothing.
pub(super) fn with_shown_probes(
    request: &RunRequest<'_>,
    main: &MainProgram,
    probes: &[ProbeVariable],
) -> Result<String, String> {
    if probes.is_empty() {
        Ok(request.source.to_owned())
    } else if main.returns {
        Err("a program that may return early shows only its simple variables".to_owned())
    } else if request.scans == 0 {
        Err("before the first scan only simple variables are shown".to_owned())
    } else {
        Ok(with_probes(request.source, main, probes))
    }
}

/// Adds probe variables to a program. Each line keeps its number: the declarations stand behind the last section of
/// variables, so that those of the program keep their places in memory, the assignments before its `END_PROGRAM`. A
/// variable that takes several values in turn is declared once.
pub(super) fn with_probes(source: &str, main: &MainProgram, probes: &[ProbeVariable]) -> String {
    let body = main.body;
    let mut text = source[..body].to_owned();
    text.push_str(" VAR");
    let mut declared = BTreeSet::new();
    for probe in probes.iter().filter(|probe| declared.insert(&probe.name)) {
        text.push_str(&format!(" {} : {};", probe.name, probe.type_name));
    }
    text.push_str(" END_VAR");
    text.push_str(&source[body..main.inside.end]);
    for probe in probes.iter().filter(|probe| !probe.expression.is_empty()) {
        text.push_str(&format!("{} := {}; ", probe.name, probe.expression));
    }
    text.push_str(&source[main.inside.end..]);
    text
}

/// The probe variables of a request: one for each observed value that is no variable of its own, such as an element, a field or
/// an output of a function block.
pub(super) struct ProbeVariables {
    list: Vec<ProbeVariable>,
}

impl ProbeVariables {
    /// Makes a probe variable for each observed path of a request, in the order in which they are observed.
    pub(super) fn of(request: &RunRequest<'_>) -> ProbeVariables {
        let mut probes = ProbeVariables { list: Vec::new() };
        for asked in request.observe {
            if is_path(&asked.name) && probes.copy(&asked.name).is_none() {
                let ty = ElementaryType::from_name(&asked.type_name);
                probes.list.push(ProbeVariable {
                    name: ProbeVariable::name(probes.list.len()),
                    type_name: ty.map_or(&*asked.type_name, |ty| ty.name()).to_owned(),
                    expression: asked.name.to_string(),
                });
            }
        }
        probes
    }

    /// Returns the variables to add to the program.
    pub(super) fn list(&self) -> &[ProbeVariable] {
        &self.list
    }

    /// Returns the name of the variable that shows an observed value.
    pub(super) fn variable<'v>(&'v self, asked: &'v Observation) -> &'v str {
        self.copy(&asked.name).unwrap_or(&asked.name)
    }

    fn copy(&self, path: &str) -> Option<&str> {
        let found = self.list.iter().find(|probe| probe.expression == path);
        found.map(|probe| probe.name.as_str())
    }
}

/// Tells whether a name is a path to a part of a variable.
fn is_path(name: &str) -> bool {
    name.contains(['.', '['])
}
