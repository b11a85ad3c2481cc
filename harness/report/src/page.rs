//! `index.html`: the run as one page that a browser opens, without anything else.
//!
//! The page is a skeleton, a style sheet and scripts, which stand in files of their own beside this module and are part of the
//! program, and the data of the run as JSON, compressed (gzip) and in Base64, in elements that no browser runs. The scripts build what is looked at, and only
//! through the interface of the document, so that no text of a run becomes markup.
//!
//! | element | data |
//! |---|---|
//! | `run` | header, totals, claims, causes, observations on which engines disagree: small, read at once |
//! | `conversions` | what documents state about conversions, what recorded compilers answered and where sources contradict each other, which the caller hands over, and what engines answered: read when it is shown |
//! | `cases` | every case that did not pass, in columns of numbers into tables of texts: read when somebody looks at cases; missing in the page of a site, which has the newest run of each engine |

mod answers;
mod cases;
mod run;
mod texts;

use crate::ReportError;
use crate::groups::{GroupNumber, Groups};
use crate::overview::Overview;
use crate::pending::PendingFile;
use answers::AnswersData;
pub(crate) use answers::PageAnswers;
use cases::MissedCases;
use flate2::Compression;
use flate2::write::GzEncoder;
use serde::Serialize;
use std::io::{self, Write};
use std::path::PathBuf;
use stickler_conversions::overview::Statements;
use stickler_run::{Event, Verdict};

/// The page of a run, gathered until it is written.
pub(crate) struct Page {
    file: PendingFile,
    cases: MissedCases,
    statements: Statements,
    answers: PageAnswers,
}

/// The data of the page about conversions.
#[derive(Serialize)]
struct ConversionsData<'p> {
    statements: &'p Statements,
    answers: AnswersData,
}

/// Writes a page that shows what documents state of conversions, what the engines of `run` answered, and, where there are any, its cases.
///
/// # Errors
/// Errors of writing to `out`.
pub(crate) fn write(
    out: &mut impl Write,
    run: &impl Serialize,
    (statements, answers): (&Statements, PageAnswers),
    cases: Option<&impl Serialize>,
) -> io::Result<()> {
    let (before_style, before_data, before_script, end) = skeleton();
    write!(out, "{before_style}{STYLE}{before_data}")?;
    data(out, "run", run)?;
    let answers = answers.into_data();
    data(out, "conversions", &ConversionsData { statements, answers })?;
    if let Some(cases) = cases {
        data(out, "cases", cases)?;
    }
    out.write_all(before_script.as_bytes())?;
    for script in SCRIPTS {
        out.write_all(script.as_bytes())?;
    }
    out.write_all(end.as_bytes())
}

impl Page {
    /// Creates the file. `statements` are what documents state about the conversions of the run.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the file cannot be created.
    pub(crate) fn create(path: PathBuf, statements: Statements) -> Result<Page, ReportError> {
        Ok(Page {
            file: PendingFile::create(path)?,
            cases: MissedCases::default(),
            statements,
            answers: PageAnswers::default(),
        })
    }

    /// Adds one event, with the group of a case.
    pub(crate) fn take(&mut self, event: &Event, group: Option<GroupNumber>) {
        match (event, group) {
            (Event::Case(case), Some(group)) => {
                let number = (case.verdict != Verdict::Pass)
                    .then(|| self.cases.take(case, group))
                    .flatten();
                if let Some(question) = self.statements.question(&case.id) {
                    self.answers.take(case, question, number);
                }
            }
            // All else is taken from the overview, when the page is written.
            (Event::Header(_) | Event::Case(_) | Event::Cause(_) | Event::Footer(_), _) => {}
        }
    }

    /// Writes the page. A run without header or footer has none.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the file cannot be written.
    pub(crate) fn finish(mut self, overview: &Overview, groups: &Groups) -> Result<(), ReportError> {
        let Some(run) = run::data(overview) else {
            return Ok(());
        };
        let path = self.file.path().to_owned();
        let cases = self.cases.into_data(groups);
        self.answers.add_recordings(&self.statements, &overview.engines());
        write(
            &mut self.file,
            &run,
            (&self.statements, self.answers),
            Some(&cases),
        )
        .map_err(ReportError::writing(&path))?;
        self.file.commit()
    }
}

/// Writes an element with data that a script reads.
fn data(out: &mut impl Write, id: &str, value: &impl Serialize) -> io::Result<()> {
    let mut packed = GzEncoder::new(Vec::new(), Compression::default());
    serde_json::to_writer(&mut packed, value)?;
    let text = base64(&packed.finish()?);
    writeln!(
        out,
        "<script type=\"text/plain\" id=\"data-{id}\">{text}</script>"
    )
}

/// Returns bytes in Base64 (RFC 4648), whose digits end no element.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let byte = |at: usize| u32::from(three.get(at).copied().unwrap_or_default());
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for digit in 0..4 {
            let index = (bits >> (18 - 6 * digit)) as usize % 64;
            text.push(if digit <= three.len() {
                DIGITS[index].into()
            } else {
                '='
            });
        }
    }
    text
}

/// The style sheet.
pub(crate) const STYLE: &str = include_str!("page/page.css");

/// The scripts. Each file declares functions; the last one runs them.
const SCRIPTS: [&str; 18] = [
    include_str!("page/dom.js"),
    include_str!("page/address.js"),
    include_str!("page/data.js"),
    include_str!("page/program.js"),
    include_str!("page/conversions.js"),
    include_str!("page/system.js"),
    include_str!("page/explorer.js"),
    include_str!("page/curves.js"),
    include_str!("page/plots.js"),
    include_str!("page/matrices.js"),
    include_str!("page/bits.js"),
    include_str!("page/contradictions.js"),
    include_str!("page/claims.js"),
    include_str!("page/causes.js"),
    include_str!("page/cases.js"),
    include_str!("page/observations.js"),
    include_str!("page/site.js"),
    include_str!("page/main.js"),
];

/// The skeleton of the page, in which three marks stand for what is put in.
const SKELETON: &str = include_str!("page/page.html");

/// Returns the four parts of the skeleton: before the style, before the data, before the scripts, and the rest.
fn skeleton() -> (&'static str, &'static str, &'static str, &'static str) {
    let parts = SKELETON.split_once("{style}").and_then(|(before_style, rest)| {
        let (before_data, rest) = rest.split_once("{data}")?;
        let (before_script, end) = rest.split_once("{script}")?;
        Some((before_style, before_data, before_script, end))
    });
    parts.expect("the skeleton has its three marks, as a test sees")
}

#[cfg(test)]
pub(crate) use browser_tests::{browser, open};
#[cfg(test)]
pub(crate) use tests::data_of;

#[cfg(test)]
mod browser_tests;
#[cfg(test)]
mod keyboard_tests;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod web_driver;
