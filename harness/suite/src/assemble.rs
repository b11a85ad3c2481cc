//! The marks that apply to one expansion become its expectation.

use std::sync::Arc;

use rustc_hash::FxHashMap;
use stickler_types::{ElementaryType, Value};

use crate::mark::{Claim, Known, Mark, Word};
use crate::model::{
    Acceptance, ClockSetting, Expectation, ExpectedDiagnostic, ExpectedFault, ExpectedText, ExpectedValue,
    Observe, VariableSetting,
};

/// All that marks say about a case.
#[derive(Clone, Debug)]
pub(crate) struct Assembly {
    pub(crate) expectation: Arc<Expectation>,
    pub(crate) observe: Arc<[Observe]>,
    pub(crate) set: Arc<[VariableSetting]>,
    pub(crate) clock: Arc<[ClockSetting]>,
}

impl Assembly {
    /// What lint says of a case that claims nothing, and what to do about it.
    pub(crate) const NOTHING: &str = "claims nothing but that the program is accepted";
    pub(crate) const SAY_OK: &str = "if that is the claim, say `(*! ok *)` on the line that matters";

    /// Whether no mark says what the program is there for. What is only recorded is meant to be so.
    pub(crate) fn claims_nothing(&self) -> bool {
        let expectation = &self.expectation;
        expectation.accepted == Acceptance::Required
            && expectation.values.is_empty()
            && expectation.clean_lines.is_empty()
            && expectation.fault.is_none()
            && expectation.rendered.is_none()
            && self.observe.is_empty()
    }
}

/// What is wrong with the marks of a case, at which 1-based line of its template.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct AssemblyMistake {
    pub(crate) line: u32,
    pub(crate) message: String,
}

/// Collects what the marks of one expansion claim.
#[derive(Debug, Default)]
pub(crate) struct Assembler<'n> {
    expectation: Expectation,
    observed: Vec<Observe>,
    set: Vec<VariableSetting>,
    clock: Vec<ClockSetting>,
    acceptance_observed: bool,
    /// The line of the last mark, for mistakes that no mark alone makes.
    line: u32,
    names: Option<&'n TypeNames>,
    scratch: String,
}

/// The names of the elementary types, each once for all cases that name it.
#[derive(Debug)]
pub(crate) struct TypeNames(Vec<Arc<str>>);

impl Default for TypeNames {
    fn default() -> Self {
        TypeNames(
            ElementaryType::ALL
                .iter()
                .map(|ty| Arc::from(ty.name()))
                .collect(),
        )
    }
}

impl TypeNames {
    /// The name of a value's type.
    pub(crate) fn of(&self, value: &Value) -> Arc<str> {
        match value {
            Value::Plain { ty, .. } | Value::Text { ty, .. } => self.elementary(*ty),
            Value::Enumerated { type_name, .. } => type_name.as_str().into(),
        }
    }

    pub(crate) fn elementary(&self, ty: ElementaryType) -> Arc<str> {
        // The variants stand in the order of `ALL`; a test holds that.
        self.0
            .get(ty as usize)
            .map_or_else(|| ty.name().into(), Arc::clone)
    }
}

impl<'n> Assembler<'n> {
    pub(crate) fn new(names: &'n TypeNames) -> Assembler<'n> {
        Assembler {
            names: Some(names),
            ..Assembler::default()
        }
    }

    /// Adds what a mark claims, whose program line is `line`.
    pub(crate) fn mark(
        &mut self,
        mark: &Mark,
        line: u32,
        file_line: impl Fn(u32) -> u32,
        texts: &[&str],
    ) -> Result<(), AssemblyMistake> {
        self.line = mark.line;
        let wrong = |message| AssemblyMistake {
            line: mark.line,
            message,
        };
        let scratch = &mut self.scratch;
        match &mark.claim {
            Claim::Error(codes) => {
                for code in codes {
                    self.expectation.accepted = Acceptance::Rejected;
                    let code = code.get(scratch, texts).map_err(wrong)?;
                    self.expectation
                        .diagnostics
                        .push(ExpectedDiagnostic { line, code });
                }
            }
            Claim::Ok => self.expectation.clean_lines.push(line),
            Claim::Fault(fault) => {
                let fault = ExpectedFault {
                    fault: fault.get(scratch, texts).map_err(wrong)?,
                    line,
                };
                if self.expectation.fault.replace(fault).is_some() {
                    return Err(wrong(
                        "execution stops only once, but two `fault` marks apply".to_owned(),
                    ));
                }
            }
            Claim::Values { after, values } => {
                for value in values {
                    let expected = ExpectedValue {
                        name: value.name.fill(scratch, texts),
                        after: *after,
                        value: literal(&value.value, scratch, texts).map_err(|message| AssemblyMistake {
                            line: value.line,
                            message,
                        })?,
                        line: file_line(value.line),
                    };
                    self.expectation.values.push(expected);
                }
            }
            Claim::Rendered(text) => {
                let rendered = ExpectedText {
                    lines: body_lines(&text.fill(scratch, texts)),
                    line,
                };
                if self.expectation.rendered.replace(rendered).is_some() {
                    return Err(wrong(
                        "a program is rendered once, but two `rendered` marks apply".to_owned(),
                    ));
                }
            }
            Claim::Observe { name, ty, after } => {
                let observe = Observe {
                    name: name.fill(scratch, texts),
                    ty: ty.fill(scratch, texts),
                    after: *after,
                };
                self.observed.push(observe);
            }
            Claim::ObserveAcceptance => self.acceptance_observed = true,
            Claim::Set { name, value, before } => {
                let value = literal(value, scratch, texts).map_err(wrong)?;
                self.set.push(VariableSetting {
                    before: *before,
                    name: name.fill(scratch, texts),
                    value,
                });
            }
            Claim::Clock { value, before } => {
                let value = literal(value, scratch, texts).map_err(wrong)?;
                self.clock.push(ClockSetting {
                    before: *before,
                    value,
                });
            }
        }
        Ok(())
    }

    /// Adds a variable that must have a value after the last scan.
    pub(crate) fn value(&mut self, name: Arc<str>, value: Value, line: u32) {
        self.expectation.values.push(ExpectedValue {
            name,
            after: None,
            value,
            line,
        });
    }

    /// Adds a variable whose value is recorded.
    pub(crate) fn observe(&mut self, name: Arc<str>, ty: Arc<str>) {
        self.observed.push(Observe {
            name,
            ty,
            after: None,
        });
    }

    /// Says that acceptance is recorded, and nothing asserted.
    pub(crate) fn observe_acceptance(&mut self) {
        self.acceptance_observed = true;
    }

    /// Adds settings that do not come from a mark.
    pub(crate) fn settings(&mut self, set: &[VariableSetting], clock: &[ClockSetting]) {
        self.set.extend_from_slice(set);
        self.clock.extend_from_slice(clock);
    }

    /// The expectation, if what was said makes sense together.
    pub(crate) fn finish(mut self, scans: u32) -> Result<Assembly, AssemblyMistake> {
        let wrong = |message: String| AssemblyMistake {
            line: self.line,
            message,
        };
        self.contradiction()
            .map_or(Ok(()), |message| Err(wrong(message.to_owned())))?;
        self.beyond_the_last_scan(scans)
            .map_or(Ok(()), |message| Err(wrong(message)))?;
        if let Some(value) = self.clock.iter().find(|clock| !is_duration(&clock.value)) {
            return Err(wrong(format!(
                "the clock is set to a TIME or LTIME, not to `{}`",
                value.value
            )));
        }
        let observe = self.all_observed()?;
        let mut expectation = self.expectation;
        if self.acceptance_observed {
            expectation.accepted = Acceptance::Observed;
        }
        expectation.diagnostics.sort();
        expectation.clean_lines.sort_unstable();
        self.set.sort_by_key(|set| set.before);
        self.clock.sort_by_key(|clock| clock.before);
        Ok(Assembly {
            expectation: Arc::new(expectation),
            observe: shared(observe),
            set: shared(self.set),
            clock: shared(self.clock),
        })
    }

    /// Two claims that cannot both be met.
    fn contradiction(&self) -> Option<&'static str> {
        let Expectation {
            diagnostics,
            clean_lines,
            values,
            fault,
            rendered,
            ..
        } = &self.expectation;
        let rejected = !diagnostics.is_empty();
        if rejected && !values.is_empty() {
            return Some("an `error` mark applies, so the program does not run, but values are asserted");
        }
        if rejected && fault.is_some() {
            return Some("an `error` mark applies, so the program does not run, but a fault is asserted");
        }
        if rejected && rendered.is_some() {
            return Some("an `error` mark applies, but what the renderer gives back is asserted");
        }
        if rejected && self.acceptance_observed {
            return Some("an `error` mark and `observe acceptance` apply at once");
        }
        if self.acceptance_observed && (!values.is_empty() || fault.is_some() || rendered.is_some()) {
            return Some(
                "`observe acceptance` asserts nothing, but values, a fault or a rendered text are asserted",
            );
        }
        if self.acceptance_observed && !clean_lines.is_empty() {
            return Some("`observe acceptance` asserts nothing, but `ok` does");
        }
        // Marks come in the order of the lines, so both lists are sorted.
        let both = diagnostics
            .iter()
            .any(|error| clean_lines.binary_search(&error.line).is_ok());
        both.then_some("`ok` and `error` apply to the same line")
    }

    fn beyond_the_last_scan(&self, scans: u32) -> Option<String> {
        let values = self.expectation.values.iter().filter_map(|value| value.after);
        let observed = self.observed.iter().filter_map(|observe| observe.after);
        let set = self.set.iter().map(|set| set.before);
        let clock = self.clock.iter().map(|clock| clock.before);
        let late = values
            .chain(observed)
            .chain(set)
            .chain(clock)
            .find(|&scan| scan > scans)?;
        Some(format!("scan {late} never comes, for `scans` is {scans}"))
    }

    /// Everything that an engine has to give back, each variable and scan once.
    fn all_observed(&mut self) -> Result<Vec<Observe>, AssemblyMistake> {
        let observed = std::mem::take(&mut self.observed);
        if self.expectation.accepted == Acceptance::Rejected {
            return Ok(Vec::new());
        }
        let most = self.expectation.values.len() + observed.len();
        let mut all = Directory {
            list: Vec::with_capacity(most),
            index: FxHashMap::default(),
        };
        for value in &self.expectation.values {
            let ty = self
                .names
                .map_or_else(|| value.value.type_name().into(), |names| names.of(&value.value));
            let observe = Observe {
                name: Arc::clone(&value.name),
                ty,
                after: value.after,
            };
            if all.find_or_add(observe).is_some() {
                let message = format!("the value of `{}` is asserted twice", value.name);
                return Err(AssemblyMistake {
                    line: self.line,
                    message,
                });
            }
        }
        for observe in observed {
            let message = format!(
                "`{}` is a {} here, and another type elsewhere",
                observe.name, observe.ty
            );
            let ty = Arc::clone(&observe.ty);
            if all
                .find_or_add(observe)
                .is_some_and(|known| !known.eq_ignore_ascii_case(&ty))
            {
                return Err(AssemblyMistake {
                    line: self.line,
                    message,
                });
            }
        }
        Ok(all.list)
    }
}

/// A list that cases share; most are empty, and all empty ones are the same.
fn shared<T>(list: Vec<T>) -> Arc<[T]> {
    if list.is_empty() {
        Arc::default()
    } else {
        list.into()
    }
}

/// Variables in order, each once.
struct Directory {
    list: Vec<Observe>,
    /// Only where there are many: most cases observe one variable.
    index: FxHashMap<(Arc<str>, Option<u32>), usize>,
}

impl Directory {
    /// The type of the variable if it is there already; else it is added.
    fn find_or_add(&mut self, observe: Observe) -> Option<Arc<str>> {
        const FEW: usize = 8;
        let found = match self.list.len() {
            0..FEW => self
                .list
                .iter()
                .position(|known| known.name == observe.name && known.after == observe.after),
            _ => {
                for (at, known) in self.list.iter().enumerate().skip(self.index.len()) {
                    self.index.insert((Arc::clone(&known.name), known.after), at);
                }
                self.index
                    .get(&(Arc::clone(&observe.name), observe.after))
                    .copied()
            }
        };
        match found {
            Some(at) => Some(Arc::clone(&self.list[at].ty)),
            None => {
                self.list.push(observe);
                None
            }
        }
    }
}

/// A value, where the whole literal may be a placeholder.
fn literal(value: &Known<Value>, scratch: &mut String, texts: &[&str]) -> Result<Value, String> {
    match value {
        Known::Now(value) => Ok(value.clone()),
        Known::Later(template) => Value::read(&template.fill(scratch, texts)),
    }
}

fn is_duration(value: &Value) -> bool {
    matches!(value, Value::Plain { ty, .. } if ty.is_duration())
}

/// The trimmed lines of a text, without empty ones at its start and end.
fn body_lines(text: &str) -> Vec<Box<str>> {
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    let filled = |line: &&str| !line.is_empty();
    let first = lines.iter().position(filled).unwrap_or(lines.len());
    let end = lines
        .iter()
        .rposition(|line| filled(line))
        .map_or(first, |last| last + 1);
    lines[first..end].iter().map(|&line| line.into()).collect()
}
