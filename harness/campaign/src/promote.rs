//! A finding made a case: what must happen, by the evaluator or by the planted error, never by what an engine did.

use crate::finding::{Confirmation, ExpectedBehavior, Finding};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use stickler_run::Observed;

/// The folder of cases that campaigns found, below the folder of cases.
pub const FOUND: &str = "found";

/// The reason for which a finding does not become a case.
#[derive(Debug, thiserror::Error)]
pub enum PromoteError {
    /// The finding is none that a case can be made of.
    #[error("{id} cannot become a case: {reason}")]
    Refused {
        /// The finding.
        id: String,
        /// The reason, and what else can be done.
        reason: String,
    },
    /// The name is none.
    #[error("`{0}` is no name for a case: letters, digits, `-`, `_` and `.` alone, and no point in front")]
    Name(String),
    /// A case of this name exists already.
    #[error(
        "{0} is there already; the ids of cases never change their meaning, so choose another name with --name"
    )]
    Exists(PathBuf),
    /// The case cannot be written.
    #[error("cannot write {path}: {error}")]
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
    /// The case file that was written is not sound; it was removed.
    #[error("the case would not be sound, so it was not kept: {0}")]
    Unsound(String),
}

/// A case that was made of a finding.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Promoted {
    /// The file of the case.
    pub path: PathBuf,
    /// The basis in its header.
    pub basis: String,
    /// Whether Stickler proposed the basis; a person may know a section that says it better.
    pub proposed: bool,
}

/// The head of the case that a person writes for a finding; what is left out is proposed by Stickler.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct CaseHead<'w> {
    /// The name of the case.
    pub name: Option<&'w str>,
    /// The rule that holds, in a line.
    pub title: Option<&'w str>,
    /// The document and section that say so.
    pub basis: Option<&'w str>,
}

/// Writes a finding as a case file into `cases`/found, and has the suite read it.
///
/// # Errors
/// [`PromoteError`]; then no file is left.
pub fn promote(finding: &Finding, cases: &Path, words: &CaseHead<'_>) -> Result<Promoted, PromoteError> {
    let name = words.name.unwrap_or(&finding.id);
    check_name(name)?;
    let (text, chosen) = case_file(finding, words)?;
    let folder = cases.join(FOUND);
    let path = folder.join(format!("{name}.st"));
    if path.exists() {
        return Err(PromoteError::Exists(path));
    }
    let write = || -> io::Result<()> {
        fs::create_dir_all(&folder)?;
        fs::write(&path, &text)
    };
    if let Err(error) = write() {
        let _ = fs::remove_file(&path);
        return Err(PromoteError::Write { path, error });
    }
    if let Some(mistake) = mistake(cases, &path) {
        // What cannot be removed now cannot be written a moment ago.
        let _ = fs::remove_file(&path);
        return Err(PromoteError::Unsound(mistake));
    }
    Ok(Promoted {
        path,
        basis: chosen,
        proposed: words.basis.is_none(),
    })
}

/// Checks the name of a file of cases.
///
/// # Errors
/// A name with other characters than letters, digits, `-`, `_` and `.`, or with a point in front.
pub fn check_name(name: &str) -> Result<(), PromoteError> {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-_.".contains(&byte);
    match name.is_empty() || name.starts_with('.') || !name.bytes().all(plain) {
        true => Err(PromoteError::Name(name.to_owned())),
        false => Ok(()),
    }
}

/// Returns the first mistake that the suite finds in a file, lint's warnings included.
fn mistake(cases: &Path, path: &Path) -> Option<String> {
    let (_, errors) = stickler_suite::load_file(cases, path);
    if let Some(error) = errors.first() {
        return Some(error.to_string());
    }
    let name = path.file_name()?.to_string_lossy();
    let own = format!("{FOUND}/{name}");
    let findings = stickler_suite::Suite::load(cases).findings();
    let found = findings
        .iter()
        .find(|found| found.what.to_string().contains(&own))?;
    Some(found.what.to_string())
}

/// The text of the case file, and its basis.
///
/// # Errors
/// [`PromoteError::Refused`].
fn case_file(finding: &Finding, words: &CaseHead<'_>) -> Result<(String, String), PromoteError> {
    let refused = |reason: String| PromoteError::Refused {
        id: finding.id.clone(),
        reason,
    };
    if finding.standing == Confirmation::Flaky {
        return Err(refused(
            "it is flaky: it was not seen again, so a case would say nothing".to_owned(),
        ));
    }
    if !finding.is_as_found() {
        return Err(refused(
            "its program was edited since it was found, and what must happen was said of the program that was found".to_owned(),
        ));
    }
    let (Some(program), Some(dialect)) = (&finding.program, finding.dialect()) else {
        return Err(refused(no_program(finding)));
    };
    let (proposal, marked) = match &finding.expected {
        ExpectedBehavior::Values { opened, .. } if !opened.is_empty() => {
            return Err(refused(format!(
                "no document settles what must happen: {}",
                opened.join("; ")
            )));
        }
        ExpectedBehavior::Values { values, basis, .. } => (basis, with_values(program, values)),
        ExpectedBehavior::Rejected { code, line, basis } => (basis, with_error(program, code, *line)),
        ExpectedBehavior::Property { .. } => return Err(refused(no_program(finding))),
    };
    let Some(basis) = words.basis.map(str::to_owned).or_else(|| proposal.clone()) else {
        return Err(refused(
            "nobody has said which document says so; name it with --basis".to_owned(),
        ));
    };
    let mut text = header(finding, words.title, &basis, dialect.as_str());
    text.push_str(&marked);
    Ok((text, basis))
}

fn no_program(finding: &Finding) -> String {
    format!(
        "it says nothing about a program's values or diagnostics; keep its input where tests replay it: \
         cp {}/input corpus/{}/{}",
        finding.id, finding.target, finding.id
    )
}

fn header(finding: &Finding, title: Option<&str>, basis: &str, dialect: &str) -> String {
    let uses = match &finding.rule[..] {
        [] => "assignment".to_owned(),
        rule => rule.join(", "),
    };
    let proposed = || format!("Found by a campaign: {uses} ({})", finding.symptom);
    let title = title.map_or_else(proposed, str::to_owned);
    let who = match &finding.engine {
        Some(engine) => format!("{} {}", engine.name, engine.version),
        None => format!("the reference of Stickler {}", finding.stickler),
    };
    let summary = format!("{who} disagreed when this was found: {}", finding.message);
    format!(
        "(*!\ntitle = {}\nbasis = {}\ndialects = [{}]\ntags = [\"found\"]\nsummary = {}\n*)\n",
        toml_string(&title),
        toml_string(basis),
        toml_string(dialect),
        toml_string(&summary)
    )
}

/// A TOML string that can stand in a comment of ST, with no comment in it.
fn toml_string(text: &str) -> String {
    // A string of JSON is one of TOML, but for this character.
    let quoted = serde_json::Value::from(text)
        .to_string()
        .replace('\u{7F}', "\\u007F");
    quoted.replace("*)", "*\\u0029").replace("(*", "\\u0028*")
}

fn with_values(program: &str, values: &[Observed]) -> String {
    if values.is_empty() {
        // A program without variables says that its last line is accepted.
        return format!("{} (*! ok *)\n", program.trim_end());
    }
    let mut text = program.to_owned();
    if !text.ends_with('\n') {
        text.push('\n');
    }
    text.push_str("(*! values\n");
    for Observed { name, value } in values {
        // Neither end nor beginning of a comment may stand in a mark.
        let value = value.replace("*)", "*$29").replace("(*", "($2A");
        text.push_str(&format!("{name} = {value}\n"));
    }
    text.push_str("*)\n");
    text
}

fn with_error(program: &str, code: &str, line: u32) -> String {
    let mut text = String::with_capacity(program.len() + 24);
    for (number, own) in (1_u32..).zip(program.lines()) {
        text.push_str(own);
        if number == line {
            text.push_str(&format!(" (*! error {code} *)"));
        }
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    fn cases() -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        let real = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
        for file in ["suite.toml", "dialects.toml", "sources.toml", "rules.md"] {
            fs::copy(real.join(file), folder.path().join(file)).unwrap();
        }
        let found = folder.path().join(FOUND);
        fs::create_dir(&found).unwrap();
        fs::write(found.join("README.md"), "Found.").unwrap();
        folder
    }

    fn reason(finding: &Finding) -> String {
        promote(finding, cases().path(), &CaseHead::default())
            .unwrap_err()
            .to_string()
    }

    #[test]
    fn a_finding_becomes_a_case_that_expects_what_the_evaluator_says() {
        let cases = cases();
        let finding = sample::finding("a", "value:INT", &["MOD"], 6);
        let words = CaseHead {
            name: Some("mod-of-things"),
            title: Some("MOD gives (* what is *) left"),
            basis: None,
        };
        let promoted = promote(&finding, cases.path(), &words).unwrap();
        assert!(promoted.proposed);
        let (read, errors) = stickler_suite::load_file(cases.path(), &promoted.path);
        assert_eq!(errors, []);
        let [case] = &read[..] else { panic!("one case") };
        assert_eq!(&*case.id, "found/mod-of-things");
        assert_eq!(case.expectation.values[0].value.to_string(), "INT#5");
        assert_eq!(&*case.basis.to_string(), "iec-61131-3: 7.3");
        assert_eq!(&*case.title, "MOD gives (* what is *) left");
        let again = promote(&finding, cases.path(), &words).unwrap_err();
        assert!(matches!(again, PromoteError::Exists(_)), "{again}");
    }

    #[test]
    fn a_planted_error_becomes_a_mark_on_its_line() {
        let cases = cases();
        let finding = Finding {
            expected: ExpectedBehavior::Rejected {
                code: "P4035".to_owned(),
                line: 5,
                basis: None,
            },
            ..sample::finding("a", "not-rejected:P4035", &[], 6)
        };
        let error = promote(&finding, cases.path(), &CaseHead::default())
            .unwrap_err()
            .to_string();
        assert!(error.contains("name it with --basis"), "{error}");
        let words = CaseHead {
            basis: Some("rule: code-of-the-context"),
            ..CaseHead::default()
        };
        let promoted = promote(&finding, cases.path(), &words).unwrap();
        let text = fs::read_to_string(promoted.path).unwrap();
        assert!(text.contains("    x := 5; (*! error P4035 *)\n"), "{text}");
    }

    #[test]
    fn what_says_nothing_becomes_no_case() {
        let finding = sample::finding("a", "value:INT", &["MOD"], 6);
        let flaky = Finding {
            standing: Confirmation::Flaky,
            ..finding.clone()
        };
        assert!(reason(&flaky).contains("it is flaky"));
        let edited = Finding {
            program: Some("PROGRAM main END_PROGRAM".to_owned()),
            ..finding.clone()
        };
        assert!(reason(&edited).contains("was edited"));
        let open = Finding {
            expected: ExpectedBehavior::Values {
                values: Vec::new(),
                basis: None,
                opened: vec!["a real divided by zero".to_owned()],
            },
            ..finding.clone()
        };
        assert!(reason(&open).contains("no document settles"));
        let property = Finding {
            expected: ExpectedBehavior::Property {
                claim: "it holds".to_owned(),
            },
            ..finding
        };
        assert!(reason(&property).contains("corpus/"));
    }

    #[test]
    fn a_case_with_a_basis_that_is_none_is_not_kept() {
        let cases = cases();
        let finding = sample::finding("a", "value:INT", &["MOD"], 6);
        let words = |name, basis| CaseHead {
            name: Some(name),
            basis,
            title: None,
        };
        let error = promote(&finding, cases.path(), &words("x", Some("hearsay: §1"))).unwrap_err();
        assert!(matches!(error, PromoteError::Unsound(_)), "{error}");
        assert!(!cases.path().join("found/x.st").exists());
        let error = promote(&finding, cases.path(), &words("../x", None)).unwrap_err();
        assert!(matches!(error, PromoteError::Name(_)), "{error}");
    }

    #[test]
    fn a_comment_in_a_title_opens_and_ends_none() {
        assert_eq!(toml_string(r#"a (* b *) "c""#), r#""a \u0028* b *\u0029 \"c\"""#);
    }
}
