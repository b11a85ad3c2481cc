//! Reads the test data of this crate: Markdown in which each second heading is the name of a test.
//!
//! Blocks of code behind a first heading are the files of an engine that stands in for a compiler; those behind a second heading
//! replace or add files for one test, and a block `st` is its program. A table has the requests of one session, in order: what a
//! comment of the program asks the stand-in for, the request, and the outcome, in which `…` stands for anything.
//!
//! Requests: `check`, `render`, `run: x INT, a[1]@2 DINT`, `run 3 scans before 2 clock TIME#1s before 3 in = INT#5: x INT`;
//! `in matiec` names another dialect than the first of the engine. Rows that begin with `packed` instead of `run` are run together.

use stickler_engines::{
    ClockSetting, Diagnostic, NamedValue, Observation, Outcome, RunRequest, Session, Setting,
};
use stickler_mdtest::{Section, sections};
use stickler_types::{DialectName, Value, join};

/// Returns the sections of a file, each with a first heading: with all that stands behind that, and the tests that follow.
pub fn files(text: &str) -> Vec<(Section, Vec<Section>)> {
    let mut files: Vec<(Section, Vec<Section>)> = Vec::new();
    for section in sections(text).unwrap() {
        match files.last_mut().filter(|_| section.level > 1) {
            Some((_, tests)) => tests.push(section),
            None => files.push((section, Vec::new())),
        }
    }
    files
}

/// Returns the text of the block with these words behind its fence.
pub fn block(section: &Section, info: &str) -> Option<String> {
    let found = section.blocks.iter().find(|block| block.info == info)?;
    Some(format!("{}\n", found.text))
}

/// A request, as a row of a table has it.
pub struct Asked {
    pub verb: String,
    pub dialect: DialectName,
    pub scans: u32,
    pub observe: Vec<Observation>,
    pub clock: Vec<ClockSetting>,
    pub set: Vec<Setting>,
}

impl Asked {
    /// Reads a request, which is in this dialect unless it names another.
    pub fn read(text: &str, dialect: DialectName) -> Asked {
        let (head, observed) = text.split_once(": ").unwrap_or((text, ""));
        let mut words = head.split_whitespace().peekable();
        let mut asked = Asked {
            verb: words.next().unwrap().to_owned(),
            dialect,
            scans: 1,
            observe: observed
                .split(", ")
                .filter(|one| !one.is_empty())
                .map(observation)
                .collect(),
            clock: Vec::new(),
            set: Vec::new(),
        };
        while let Some(word) = words.next() {
            let mut next = || words.next().unwrap_or_else(|| panic!("{text}"));
            match word {
                "in" => asked.dialect = next().parse().unwrap(),
                "before" => {
                    let (before, name) = (next().parse().unwrap(), next());
                    if name == "clock" {
                        let time = Value::parse(next()).unwrap();
                        asked.clock.push(ClockSetting::at(before, &time).unwrap());
                    } else {
                        assert_eq!(next(), "=", "{text}");
                        asked.set.push(Setting {
                            before,
                            name: name.into(),
                            value: Value::parse(next()).unwrap(),
                        });
                    }
                }
                scans => {
                    asked.scans = scans.parse().unwrap_or_else(|_| panic!("{text}"));
                    next();
                }
            }
        }
        asked
    }

    /// Asks a session about a program.
    pub fn ask(&self, session: &mut dyn Session, source: &str) -> Outcome {
        match self.verb.as_str() {
            "run" => session.run(&self.of(source)),
            "check" => session.check(self.dialect, source),
            "render" => session.render(self.dialect, source),
            other => panic!("there is no request `{other}`"),
        }
    }

    /// Returns the request for a program.
    pub fn of<'r>(&'r self, source: &'r str) -> RunRequest<'r> {
        RunRequest {
            dialect: self.dialect,
            source,
            scans: self.scans,
            observe: &self.observe,
            clock: &self.clock,
            set: &self.set,
        }
    }
}

fn observation(asked: &str) -> Observation {
    let (name, type_name) = asked.split_once(' ').unwrap_or((asked, ""));
    let (name, after) = match name.split_once('@') {
        Some((name, scan)) => (name, Some(scan.parse().unwrap())),
        None => (name, None),
    };
    Observation {
        after,
        ..Observation::last(name, type_name)
    }
}

/// Returns an outcome as a row of a table has it, with `...` where a message is cut, since `…` stands for anything there.
pub fn shown(outcome: &Outcome) -> String {
    let line = match outcome {
        Outcome::Accepted { warnings } => with_diagnostics("accepted".to_owned(), warnings),
        Outcome::Executed { values, warnings } => {
            with_diagnostics(format!("executed {}", list(values)), warnings)
        }
        Outcome::Rejected { diagnostics } => with_diagnostics("rejected".to_owned(), diagnostics),
        Outcome::Faulted {
            fault,
            line,
            values,
            warnings,
        } => {
            let line = line.map_or_else(String::new, |line| format!(" on line {line}"));
            with_diagnostics(format!("faulted {fault}{line} {}", list(values)), warnings)
        }
        Outcome::Rendered { text } => format!("rendered {text}"),
        Outcome::Unsupported { reason } => format!("unsupported {reason}"),
        Outcome::NotImplemented { reason } => format!("not implemented {reason}"),
        Outcome::Unusable { reason } => format!("unusable {reason}"),
        Outcome::Crashed { reason } => format!("crashed {reason}"),
        Outcome::TimedOut { after_ms } => format!("timed out after {after_ms} ms"),
        Outcome::Error { message } => format!("error {message}"),
    };
    line.trim_end().replace('\n', "⏎").replace('…', "...")
}

fn list(values: &[NamedValue]) -> String {
    let values = values.iter();
    join(values.map(|(name, value)| format!("{name} = {value}")), ", ")
}

fn with_diagnostics(mut line: String, diagnostics: &[Diagnostic]) -> String {
    for reported in diagnostics {
        let code = reported.code.as_deref();
        let code = code.map_or_else(String::new, |code| format!("[{code}]"));
        let place = |line: Option<u32>, column: Option<u32>| {
            let line = line.map_or_else(String::new, |line| line.to_string());
            column.map_or(line.clone(), |column| format!("{line}:{column}"))
        };
        let begin = place(reported.line, reported.column);
        let end = place(reported.end_line, reported.end_column);
        let end = if end.is_empty() { end } else { format!("-{end}") };
        let place = if begin.is_empty() {
            begin
        } else {
            format!(" {begin}{end}")
        };
        let severity = reported.severity.as_str();
        line.push_str(&format!("; {severity}{code}{place}: {}", reported.message));
    }
    line
}
