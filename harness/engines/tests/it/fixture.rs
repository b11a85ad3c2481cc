//! Reads the test data of this crate: Markdown in which each second heading is the name of a test.
//!
//! Blocks of code behind a first heading are the files of an engine that stands in for a compiler; those behind a second heading
//! replace or add files for one test, and a block `st` is its program. A table has the requests of one session, in order: what a
//! comment of the program asks the stand-in for, the request, and the outcome, in which `…` stands for anything.
//!
//! Requests: `check`, `render`, `run: x INT, a[1]@2 DINT`, `run 3 scans before 2 clock TIME#1s before 3 in = INT#5: x INT`;
//! `in matiec` names another dialect than the first of the engine. Rows that begin with `packed` instead of `run` are run together.

use std::fmt::Write;
use stickler_engines::{
    ClockSetting, Diagnostic, NamedValue, Observation, Outcome, RunRequest, Session, Setting,
};
use stickler_types::{DialectName, Value};

/// A block of code, with the words behind its fence.
pub struct Block {
    pub language: String,
    pub name: String,
    pub text: String,
}

/// A heading with the blocks and the rows of tables behind it.
#[derive(Default)]
pub struct Test {
    pub name: String,
    pub blocks: Vec<Block>,
    pub rows: Vec<Vec<String>>,
}

/// A first heading with its blocks, and the tests behind it.
#[derive(Default)]
pub struct Section {
    pub head: Test,
    pub tests: Vec<Test>,
}

/// Reads the sections of a file.
pub fn sections(text: &str) -> Vec<Section> {
    let mut sections: Vec<Section> = Vec::new();
    let mut lines = text.lines();
    let mut in_table = false;
    while let Some(line) = lines.next() {
        if let Some(name) = line.strip_prefix("# ") {
            sections.push(Section::default());
            sections.last_mut().unwrap().head.name = name.to_owned();
            continue;
        }
        let Some(section) = sections.last_mut() else {
            continue;
        };
        if let Some(name) = line.strip_prefix("## ") {
            section.tests.push(Test {
                name: name.to_owned(),
                ..Test::default()
            });
            continue;
        }
        let test = section.tests.last_mut().unwrap_or(&mut section.head);
        if let Some(fence) = line.strip_prefix("```") {
            let (language, name) = fence.split_once(' ').unwrap_or((fence, ""));
            let inside: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
            test.blocks.push(Block {
                language: language.to_owned(),
                name: name.to_owned(),
                text: inside.iter().map(|line| format!("{line}\n")).collect(),
            });
        }
        let row = line.strip_prefix('|').and_then(|row| row.strip_suffix('|'));
        match row {
            // The first row names the columns.
            Some(row) if in_table && !row.starts_with("---") => test.rows.push(cells(row)),
            _ => {}
        }
        in_table = row.is_some();
    }
    sections
}

/// Splits a row of a table into its cells; `\|` is no end of a cell.
fn cells(row: &str) -> Vec<String> {
    let kept = row.replace("\\|", "\u{0}");
    kept.split('|')
        .map(|cell| cell.trim().replace('\u{0}', "|"))
        .collect()
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
    let values: Vec<String> = values
        .iter()
        .map(|(name, value)| format!("{name} = {value}"))
        .collect();
    values.join(", ")
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
        let _ = write!(line, "; {severity}{code}{place}: {}", reported.message);
    }
    line
}
