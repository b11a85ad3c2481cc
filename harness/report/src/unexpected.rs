//! The unexpected results of a run, each as one message with a place, for the formats that show a list of messages: the causes of
//! failing cases, and the failing cases that no cause explains.

use crate::overview::Overview;
use crate::text::visible;
use crate::{compared, overview};
use stickler_run::{CaseEvent, Cause, Fact, Verdict};
use stickler_types::{counted, shortened};

/// The maximum number of characters of a title.
const MAX_TITLE: usize = 200;

/// The maximum number of failing cases that have a message of their own.
pub(crate) const MAX_CASES: usize = 500;

/// A message about one thing that is not as expected.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Unexpected {
    /// The claim that is not met: source and section.
    pub(crate) basis: String,
    /// The path of the case file; empty where an older log does not name it.
    pub(crate) file: String,
    /// The line of the case in its file, where it is known.
    pub(crate) line: Option<u32>,
    /// The message in one line.
    pub(crate) title: String,
    /// The expectation, the result, the program, and the command that runs it again.
    pub(crate) text: String,
    /// A text that identifies the result: the same in every run, and of no other result of a run.
    pub(crate) key: String,
    /// The number of cases that the message stands for.
    pub(crate) cases: u64,
}

impl Unexpected {
    /// Returns the messages of a run, the causes first, those that explain most cases at the top.
    pub(crate) fn all(overview: &Overview) -> impl Iterator<Item = Unexpected> {
        let (small, unreduced) = overview.unexpected_causes();
        let cases = overview.unexplained_failures().take(MAX_CASES);
        let lacks = overview.lacks.iter().filter(|lack| lack.is_failing_lack());
        let causes = lacks.chain(small).chain(unreduced);
        causes
            .map(|cause| Unexpected::of_cause(cause, overview))
            .chain(cases.map(|case| of_case(case, overview)))
    }

    /// Returns the message about a cause of failing cases, or about a feature that an engine lacks.
    pub(crate) fn of_cause(cause: &Cause, overview: &Overview) -> Unexpected {
        let cases = match (cause.is_lack(), cause.number()) {
            (true, number) => counted(number, "case waits for it", "cases wait for it"),
            (false, 1) => "1 case".to_owned(),
            (false, _) => format!("{} cases", cause.cases_shown()),
        };
        let shown = &cause.shown;
        let rerun = overview
            .engine(&cause.engine)
            .filter(|_| !shown.case.is_empty())
            .map(|engine| engine.rerun(&shown.case, &shown.dialect))
            .unwrap_or_default();
        Unexpected {
            basis: shown.basis.clone(),
            file: shown.file.clone(),
            line: shown.line,
            title: title(&cause.engine, &format!("{} ({cases})", cause.headline())),
            text: text(
                &shown.basis,
                &Fact::text(&shown.expected),
                &Fact::text(&shown.got),
                &shown.program,
                &rerun,
            ),
            key: format!("{}: {}: {}", cause.engine, cause.symptom, cause.construct),
            cases: cause.unexpected().max(1),
        }
    }
}

fn of_case(case: &CaseEvent, overview: &Overview) -> Unexpected {
    let engine = overview.engine(&case.engine);
    let (expected, got) = compared::texts(case, overview::strictness(engine));
    let what = match case.verdict {
        Verdict::Xpass => "passes, but its baseline expects it not to",
        verdict => verdict.as_str(),
    };
    Unexpected {
        basis: case.basis.clone(),
        file: case.file.clone(),
        line: case.line,
        title: title(
            &case.engine,
            &format!("{}@{}: {what}: {}", case.id, case.dialect, case.title),
        ),
        text: text(
            &case.basis,
            &expected,
            &got,
            case.program.as_deref().unwrap_or_default(),
            &overview::rerun(engine, case),
        ),
        key: format!("{}: {}@{}", case.engine, case.id, case.dialect),
        cases: 1,
    }
}

fn title(engine: &str, message: &str) -> String {
    let line = visible(&format!("{engine}: {message}")).replace(['\n', '\t'], " ");
    shortened(&line, MAX_TITLE)
}

fn text(basis: &str, expected: &str, got: &str, program: &str, rerun: &str) -> String {
    let part = |name: &str, content: &str| match content.trim_end() {
        "" => String::new(),
        content => format!("{name}:\n{content}\n\n"),
    };
    let text = [
        format!("basis: {basis}\n\n"),
        part("expected", expected),
        part("got", got),
        part("program", program.trim_start_matches('\n')),
        part("rerun", rerun),
    ]
    .concat();
    visible(text.trim_end())
}
