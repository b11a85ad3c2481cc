//! One test suite of a JUnit document, as text: its tests come one by one, and their numbers stand before them.

use crate::spool::Spool;
use crate::xml::{add_attribute, add_text};
use std::io;

/// One test suite.
pub(super) struct Suite {
    name: String,
    /// The numbers of its tests.
    pub(super) counts: Counts,
    tests: Spool,
}

/// The numbers of a suite, or of all.
#[derive(Clone, Copy, Default)]
pub(super) struct Counts {
    pub(super) tests: u64,
    pub(super) failures: u64,
    pub(super) errors: u64,
    pub(super) skipped: u64,
    pub(super) microseconds: u64,
}

impl Counts {
    /// As attributes, each with a space before it.
    pub(super) fn attributes(&self) -> String {
        format!(
            " tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{}\"",
            self.tests,
            self.failures,
            self.errors,
            self.skipped,
            seconds(self.microseconds)
        )
    }
}

/// One test.
#[derive(Default)]
pub(super) struct Test<'a> {
    /// Its name within the suite.
    pub(super) name: &'a str,
    /// How long it took.
    pub(super) microseconds: u64,
    /// Why it did not simply pass.
    pub(super) problem: Option<Problem<'a>>,
    /// What it says beside that.
    pub(super) output: String,
}

/// Why a test did not simply pass.
pub(super) struct Problem<'a> {
    /// What JUnit calls it.
    pub(super) kind: Kind,
    /// What Stickler calls it.
    pub(super) type_name: &'a str,
    /// One line.
    pub(super) message: String,
    /// All that is to be said.
    pub(super) text: String,
}

impl Suite {
    /// A test suite without tests.
    pub(super) fn new(name: &str) -> Suite {
        Suite {
            name: name.to_owned(),
            counts: Counts::default(),
            tests: Spool::default(),
        }
    }

    /// Adds a test.
    pub(super) fn add(&mut self, test: &Test<'_>) {
        self.counts.tests += 1;
        self.counts.microseconds += test.microseconds;
        let out = &mut self.tests;
        out.add(b"<testcase");
        add_attribute(out, "name", test.name);
        add_attribute(out, "classname", &self.name);
        add_attribute(out, "time", &seconds(test.microseconds));
        if test.problem.is_none() && test.output.is_empty() {
            return out.add(b"/>\n");
        }
        out.add(b">\n");
        if let Some(problem) = &test.problem {
            self.add_problem(problem);
        }
        let out = &mut self.tests;
        if !test.output.is_empty() {
            out.add(b"<system-out>");
            add_text(out, &test.output);
            out.add(b"</system-out>\n");
        }
        out.add(b"</testcase>\n");
    }

    fn add_problem(&mut self, problem: &Problem<'_>) {
        let (element, counter) = match problem.kind {
            Kind::Failure => ("failure", &mut self.counts.failures),
            Kind::Error => ("error", &mut self.counts.errors),
            Kind::Skipped => ("skipped", &mut self.counts.skipped),
        };
        *counter += 1;
        let out = &mut self.tests;
        out.add(b"<");
        out.add(element.as_bytes());
        add_attribute(out, "type", problem.type_name);
        add_attribute(out, "message", &problem.message);
        out.add(b">");
        add_text(out, &problem.text);
        out.add(b"</");
        out.add(element.as_bytes());
        out.add(b">\n");
    }

    /// Writes the whole suite.
    ///
    /// # Errors
    /// Those of `out`.
    pub(super) fn write(&self, out: &mut impl io::Write) -> io::Result<()> {
        let mut head = Spool::default();
        head.add(b"<testsuite");
        add_attribute(&mut head, "name", &self.name);
        head.add(self.counts.attributes().as_bytes());
        head.add(b">\n");
        head.write(out)?;
        self.tests.write(out)?;
        out.write_all(b"</testsuite>\n")
    }
}

/// What JUnit calls a test that did not simply pass.
#[derive(Clone, Copy)]
pub(super) enum Kind {
    Failure,
    Error,
    Skipped,
}

fn seconds(microseconds: u64) -> String {
    format!("{}.{:06}", microseconds / 1_000_000, microseconds % 1_000_000)
}
