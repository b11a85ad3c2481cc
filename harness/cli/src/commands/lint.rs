//! `stickler lint`: checks the case files themselves.

use crate::arguments::LintArguments;
use crate::case_folder::CaseFolder;
use crate::exit::Exit;
use crate::output::BAD;
use anstyle::{AnsiColor, Style};
use std::io::{self, Write};
use stickler_engines::Compiler;
use stickler_suite::{LintFinding, LintSeverity};
use stickler_types::counted;

const WARNING: Style = AnsiColor::Yellow.on_default().bold();

/// Shows every finding. The exit code is 2 where a file is broken, 1 where all cases can be run but a finding is doubtful.
///
/// # Errors
/// No folder of cases.
pub fn execute(arguments: &LintArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let folder = CaseFolder::locate(arguments.cases.as_deref())?;
    let engines = Compiler::ALL.map(Compiler::as_str);
    let findings = stickler_suite::lint(&folder.path, &engines);
    findings.iter().try_for_each(|finding| write(finding, out))?;
    let recordings = folder.recordings()?;
    let refused: Vec<_> = recordings.iter().filter_map(|read| read.as_ref().err()).collect();
    for error in &refused {
        writeln!(out, "{BAD}error:{BAD:#} {error}")?;
    }
    match findings.len() + refused.len() {
        0 => writeln!(out, "{}: nothing to complain about", folder.path.display())?,
        number => writeln!(out, "\n{}", counted(number as u64, "finding", "findings"))?,
    }
    let severities = findings.iter().map(|finding| finding.severity);
    Ok(severities
        .chain(refused.iter().map(|_| LintSeverity::Error))
        .map(exit)
        .fold(Exit::AsExpected, Exit::max))
}

fn write(finding: &LintFinding, out: &mut dyn Write) -> io::Result<()> {
    match finding.severity {
        LintSeverity::Error => writeln!(out, "{BAD}error:{BAD:#} {}", finding.what),
        LintSeverity::Warning => writeln!(out, "{WARNING}warning:{WARNING:#} {}", finding.what),
    }
}

fn exit(severity: LintSeverity) -> Exit {
    match severity {
        LintSeverity::Error => Exit::Usage,
        LintSeverity::Warning => Exit::Failures,
    }
}
