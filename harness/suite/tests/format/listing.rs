//! Cases as the examples list them.

use stickler_suite::{Acceptance, Case, ExpectedDiagnostic};

/// Lists the cases: the id and the dialects of each, and what it expects. Neighbours that differ only in their dialect stand together.
/// With `is_whole` everything else that belongs to a case is told, too, the program last.
pub fn listing(cases: &[Case], is_whole: bool) -> String {
    let mut groups: Vec<(&Case, String, String)> = Vec::new();
    for case in cases {
        assert_eq!(case.key(), format!("{}@{}", case.id, case.dialect));
        let text = description(case, is_whole);
        match groups.last_mut() {
            Some((first, dialects, known)) if first.id == case.id && *known == text => {
                *dialects += &format!(" {}", case.dialect);
            }
            _ => groups.push((case, case.dialect.to_string(), text)),
        }
    }
    let lines = groups
        .iter()
        .map(|(case, dialects, text)| format!("{}  {dialects}\n{text}", case.id));
    lines.collect()
}

/// Returns what a case expects, one claim a line.
fn description(case: &Case, is_whole: bool) -> String {
    let mut text = String::new();
    let mut line = |claim: String| {
        text.push_str(&format!("    {claim}\n"));
    };
    let expectation = &case.expectation;
    line(match expectation.accepted {
        Acceptance::Required => "accepted".to_owned(),
        Acceptance::Rejected => "rejected".to_owned(),
        Acceptance::Observed => "accepted or rejected".to_owned(),
    });
    let diagnostic = |kind: &str, it: &ExpectedDiagnostic| format!("{kind} {} in line {}", it.code, it.line);
    expectation
        .diagnostics
        .iter()
        .for_each(|it| line(diagnostic("error", it)));
    expectation
        .warnings
        .iter()
        .for_each(|it| line(diagnostic("warning", it)));
    expectation
        .clean_lines
        .iter()
        .for_each(|clean| line(format!("nothing in line {clean}")));
    for value in &expectation.values {
        let of_line = if is_whole {
            format!(" (line {})", value.line)
        } else {
            String::new()
        };
        line(format!("{} = {}{of_line}", value.key(), value.value));
    }
    if let Some(it) = expectation.fault {
        line(format!("fault {} in line {}", it.fault, it.line));
    }
    if let Some(it) = &expectation.rendered {
        line(format!("rendered, by line {}: {}", it.line, it.lines.join(" | ")));
    }
    for observed in &*case.observe {
        let is_asserted = expectation
            .values
            .iter()
            .any(|value| value.key() == observed.key());
        if is_whole || !is_asserted {
            line(format!("observes {} : {}", observed.key(), observed.type_name));
        }
    }
    for set in &*case.set {
        line(format!(
            "{} := {} before scan {}",
            set.name, set.value, set.before
        ));
    }
    for clock in &*case.clock {
        line(format!("{} ns before scan {}", clock.nanoseconds, clock.before));
    }
    if is_whole {
        line(format!(
            "{}:{} in {}: {}",
            case.file, case.line, case.area, case.title
        ));
        line(format!("basis {}", case.basis));
        if case.scans != 1 {
            line(format!("scans {}", case.scans));
        }
        case.tags.iter().for_each(|tag| line(format!("tag {tag}")));
        case.summary
            .iter()
            .for_each(|summary| line(format!("summary {summary}")));
        if let Some(question) = &case.question {
            line(format!("asks {question}"));
        }
        if let Some(cell) = &case.cell {
            line(format!(
                "cell {} of {} and {}: {}",
                cell.probe,
                cell.row,
                cell.column,
                cell.word.as_str()
            ));
        }
        if let Some(placed) = &case.placement {
            line(format!(
                "placed {} into {} in {}",
                placed.source, placed.target, placed.surrounding
            ));
        }
        case.source
            .lines()
            .for_each(|of_program| line(format!("| {of_program}")));
    }
    text
}
