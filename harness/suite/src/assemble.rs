//! Collects the marks that apply to one expansion of a program into its expectation.

use std::sync::Arc;

use rustc_hash::FxHashMap;
use stickler_types::{Acceptance, ClockSetting, Code, ElementaryType, Observation, Setting, Severity, Value};

use crate::assembly::{Assembly, contradiction, shared};
use crate::error::Mistake;
use crate::mark::{Known, Mark, MarkClaim, ValueLine};
use crate::model::{Expectation, ExpectedDiagnostic, ExpectedFault, ExpectedText, ExpectedValue};
use crate::observed;
use crate::timing::{self, Variables};

/// The text of a mark `scan` or `scans`.
#[derive(Debug)]
struct TimedText {
    text: Arc<str>,
    is_table: bool,
    /// The line of its beginning, of the template and of the case file.
    line: u32,
    file_line: u32,
    /// Whether each line of the text is a line of the template.
    has_lines: bool,
}

/// Collector of the claims that the marks of one expansion make.
#[derive(Debug, Default)]
pub(crate) struct Assembler {
    expectation: Expectation,
    recorded: Vec<Observation>,
    /// The settings of variables and of the clock, with the lines of their marks.
    set: Vec<(u32, Setting)>,
    clock: Vec<(u32, ClockSetting)>,
    /// The texts of the marks `scan` and `scans`.
    timed: Vec<TimedText>,
    /// The first value that a clock setting has and that is not a time.
    no_time: Option<Value>,
    acceptance_observed: bool,
    /// The line of the last mark, on which contradictions between several marks are reported.
    line: u32,
    scratch: String,
}

impl Assembler {
    /// Adds the claim of a mark on `line` of the program, and tells its mistakes there; `file_line` maps a line of the template to a line of the case
    /// file.
    pub(crate) fn mark(
        &mut self,
        mark: &Mark,
        line: u32,
        file_line: impl Fn(u32) -> u32,
        texts: &[&str],
    ) -> Result<(), Mistake> {
        self.line = mark.line;
        let wrong = |message: String| Mistake::new(mark.line, message);
        match &mark.claim {
            MarkClaim::Values { after, values } => {
                for value in values {
                    self.value_line(value, *after, file_line(value.line), texts)?;
                }
                Ok(())
            }
            MarkClaim::Scans { text, is_table } => {
                // The lines of a table begin below its word.
                let below = mark.line + u32::from(*is_table);
                self.timed.push(TimedText {
                    has_lines: text.fixed().is_some(),
                    text: text.fill(&mut self.scratch, texts),
                    is_table: *is_table,
                    line: below,
                    file_line: file_line(below),
                });
                Ok(())
            }
            claim => self.claim(claim, line, texts).map_err(wrong),
        }
    }

    fn value_line(
        &mut self,
        value: &ValueLine,
        after: Option<u32>,
        line: u32,
        texts: &[&str],
    ) -> Result<(), Mistake> {
        let name = value.name.fill(&mut self.scratch, texts);
        let literal = value.value.get(&mut self.scratch, texts);
        let literal = literal.map_err(|message| Mistake::new(value.line, message))?;
        self.expectation.values.push(ExpectedValue {
            name,
            after,
            value: literal,
            line,
        });
        Ok(())
    }

    fn claim(&mut self, claim: &MarkClaim, line: u32, texts: &[&str]) -> Result<(), String> {
        let scratch = &mut self.scratch;
        match claim {
            MarkClaim::Error(codes) => {
                self.expectation.accepted = Acceptance::Rejected;
                let reported = diagnostics(codes, Severity::Error, line, scratch, texts)?;
                self.expectation.diagnostics.extend(reported);
            }
            MarkClaim::Warning(codes) => {
                let reported = diagnostics(codes, Severity::Warning, line, scratch, texts)?;
                self.expectation.warnings.extend(reported);
            }
            MarkClaim::Ok => self.expectation.clean_lines.push(line),
            MarkClaim::Fault(fault) => {
                let fault = ExpectedFault {
                    fault: fault.get(scratch, texts)?,
                    line,
                };
                if self.expectation.fault.replace(fault).is_some() {
                    return Err("execution stops only once, but two `fault` marks apply".to_owned());
                }
            }
            MarkClaim::Values { .. } | MarkClaim::Scans { .. } => {}
            MarkClaim::Rendered(text) => {
                let rendered = ExpectedText {
                    lines: body_lines(&text.fill(scratch, texts)),
                    line,
                };
                if self.expectation.rendered.replace(rendered).is_some() {
                    return Err("a program is rendered once, but two `rendered` marks apply".to_owned());
                }
            }
            MarkClaim::Observe { name, ty, after } => {
                self.recorded.push(Observation {
                    name: name.fill(scratch, texts),
                    type_name: ty.fill(scratch, texts),
                    after: *after,
                });
            }
            MarkClaim::ObserveAcceptance => self.acceptance_observed = true,
            MarkClaim::Set { name, value, before } => {
                let (name, value) = (name.fill(scratch, texts), value.get(scratch, texts)?);
                if matches!(value, Value::Near { .. }) {
                    return Err(format!("a variable is set to one value, not to `{value}`"));
                }
                let before = *before;
                self.set.push((self.line, Setting { before, name, value }));
            }
            MarkClaim::Clock { value, before } => {
                let time = value.get(scratch, texts)?;
                self.clock(*before, time);
            }
        }
        Ok(())
    }

    /// Adds a variable that must have a value after the last scan.
    pub(crate) fn value(&mut self, name: Arc<str>, value: Value, line: u32) {
        // Most cases assert one value; a list that grows by itself begins with room for four.
        self.expectation.values.reserve_exact(1);
        self.expectation.values.push(ExpectedValue {
            name,
            after: None,
            value,
            line,
        });
    }

    /// Adds a variable whose value is recorded.
    pub(crate) fn observe(&mut self, name: Arc<str>, type_name: Arc<str>) {
        self.recorded.push(Observation {
            name,
            type_name,
            after: None,
        });
    }

    /// Records that acceptance is only observed, not asserted.
    pub(crate) fn observe_acceptance(&mut self) {
        self.acceptance_observed = true;
    }

    /// Adds settings that do not come from a mark.
    pub(crate) fn settings(&mut self, set: &[Setting], clock: &[(u32, Value)]) {
        self.set.extend(set.iter().map(|set| (self.line, set.clone())));
        for (before, time) in clock {
            self.clock(*before, time.clone());
        }
    }

    /// Sets the clock before a scan.
    fn clock(&mut self, before: u32, time: Value) {
        match ClockSetting::at(before, &time) {
            Some(setting) => self.clock.push((self.line, setting)),
            None => self.no_time = self.no_time.take().or(Some(time)),
        }
    }

    /// Reads the marks `scan` and `scans`, and holds all settings against the variables of a program; returns the last scan of these marks.
    fn timed(&mut self, source: &str) -> Result<u32, Mistake> {
        let variables = Variables::of(source);
        for (line, Setting { name, value, .. }) in &self.set {
            let fits = variables.value(name, &value.to_string());
            fits.map_err(|message| Mistake::new(*line, message))?;
        }
        let mut last = 0;
        let mut names: FxHashMap<String, Arc<str>> = FxHashMap::default();
        let mut shared = |name: &str| Arc::clone(names.entry(name.to_owned()).or_insert_with(|| name.into()));
        for timed in std::mem::take(&mut self.timed) {
            let rows = match timed.is_table {
                true => timing::scan_table(&timed.text),
                false => timing::one_scan(&timed.text)
                    .map(|row| vec![row])
                    .map_err(|message| (0, message)),
            };
            let line = |of_text: u32| timed.line + if timed.has_lines { of_text } else { 0 };
            let rows = rows.map_err(|(of_text, message)| Mistake::new(line(of_text), message))?;
            for row in rows {
                self.line = line(row.line);
                let wrong = |message: String| Mistake::new(line(row.line), message);
                if let Some(time) = row.clock {
                    let time = timing::time(time).map_err(wrong)?;
                    self.clock(row.scan, time);
                }
                for (name, literal) in row.set {
                    let value = variables.value(name, literal).map_err(wrong)?;
                    let (before, name) = (row.scan, shared(name));
                    self.set.push((self.line, Setting { before, name, value }));
                }
                for (name, literal) in row.expected {
                    let value = variables.value(name, literal).map_err(wrong)?;
                    self.expectation.values.push(ExpectedValue {
                        name: shared(name),
                        after: Some(row.scan),
                        value,
                        line: timed.file_line + line(row.line) - timed.line,
                    });
                }
                last = last.max(row.scan);
            }
        }
        Ok(last)
    }

    /// Returns the expectation, or the first contradiction in the collected claims, on a line of the program. Where no number of
    /// scans is given, it is that of the last scan of which a mark speaks.
    pub(crate) fn finish(
        mut self,
        scans: Option<u32>,
        source: impl FnOnce() -> Arc<str>,
    ) -> Result<Assembly, Mistake> {
        let last = match self.timed.is_empty() && self.set.is_empty() {
            true => 1,
            false => self.timed(&source())?,
        };
        let scans = scans.unwrap_or(last.max(1));
        let line = self.line;
        let wrong = |message: String| Mistake::new(line, message);
        if self.acceptance_observed {
            self.expectation.accepted = Acceptance::Observed;
        }
        if let Some(message) = contradiction(&self.expectation) {
            return Err(wrong(message.to_owned()));
        }
        self.check_scans(scans).map_err(wrong)?;
        let mut recorded = self.recorded;
        if self.expectation.accepted == Acceptance::Rejected {
            recorded.clear();
        }
        let observe = observed::all(&self.expectation.values, recorded).map_err(wrong)?;
        self.expectation.diagnostics.sort();
        self.expectation.warnings.sort();
        let mut set: Vec<Setting> = self.set.into_iter().map(|(_, set)| set).collect();
        set.sort_by_key(|set| set.before);
        let clock = ascending(self.clock)?;
        Ok(Assembly {
            expectation: Arc::new(self.expectation),
            observe: shared(observe),
            set: shared(set),
            clock: shared(clock),
            scans,
        })
    }

    /// Checks that every scan number is at most `scans` and that every clock setting is a time.
    fn check_scans(&self, scans: u32) -> Result<(), String> {
        let values = self.expectation.values.iter().filter_map(|value| value.after);
        let recorded = self.recorded.iter().filter_map(|observe| observe.after);
        let set = self.set.iter().map(|(_, set)| set.before);
        let clock = self.clock.iter().map(|(_, clock)| clock.before);
        if let Some(late) = values
            .chain(recorded)
            .chain(set)
            .chain(clock)
            .find(|&scan| scan > scans)
        {
            return Err(format!("scan {late} never comes, for `scans` is {scans}"));
        }
        match &self.no_time {
            Some(value) => Err(format!("the clock is set to a TIME or LTIME, not to `{value}`")),
            None => Ok(()),
        }
    }
}

/// Returns clock settings by scan.
///
/// # Errors
/// A mistake on the line of a setting to an earlier time than that of the scan before it, or of a second one of a scan.
fn ascending(mut clock: Vec<(u32, ClockSetting)>) -> Result<Vec<ClockSetting>, Mistake> {
    clock.sort_by_key(|(_, clock)| clock.before);
    let literal =
        |clock: &ClockSetting| Value::plain(ElementaryType::Time, clock.nanoseconds.cast_unsigned());
    for pair in clock.windows(2) {
        let [(_, earlier), (line, later)] = pair else {
            continue;
        };
        let before = later.before;
        if earlier.before == before {
            return Err(Mistake::new(
                *line,
                format!("the clock is set twice before scan {before}"),
            ));
        }
        if earlier.nanoseconds > later.nanoseconds {
            let (from, to) = (literal(earlier), literal(later));
            return Err(Mistake::new(
                *line,
                format!("the clock goes back before scan {before}, from {from} to {to}"),
            ));
        }
    }
    Ok(clock.into_iter().map(|(_, clock)| clock).collect())
}

/// Returns the diagnostics with these codes on a line.
///
/// # Errors
/// A message, if a code is not one of this severity.
fn diagnostics(
    codes: &[Known<Code>],
    severity: Severity,
    line: u32,
    scratch: &mut String,
    texts: &[&str],
) -> Result<Vec<ExpectedDiagnostic>, String> {
    let diagnostic = |code: &Known<Code>| {
        let code = code.get(scratch, texts)?;
        let own = code.severity().as_str();
        match code.severity() == severity {
            true => Ok(ExpectedDiagnostic { line, code }),
            false => Err(format!("{code} is the code of {own}s; write `{own} {code}`")),
        }
    };
    codes.iter().map(diagnostic).collect()
}

/// Returns the trimmed lines of a text, without empty ones at its start and end.
fn body_lines(text: &str) -> Vec<Box<str>> {
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    let filled = |line: &&str| !line.is_empty();
    let first = lines.iter().position(filled).unwrap_or(lines.len());
    let end = lines.iter().rposition(filled).map_or(first, |last| last + 1);
    lines[first..end].iter().map(|&line| line.into()).collect()
}
