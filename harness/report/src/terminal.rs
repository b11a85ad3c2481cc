//! Writes the summary of a run on the terminal.
//!
//! The most important part comes last, where the reader looks when the run ends: first the causes, or, of an engine whose
//! causes are not known, the cases that are not as expected; then the claims, then the totals, then one line with the result. The summary is written with ANSI styles; the caller's
//! stream strips them where they do not belong.

mod causes;
mod claims;
pub(crate) mod failure;
mod totals;

use crate::discrepancies::NAME;
use crate::overview::Overview;
use crate::text::{duration, judged, outdated, outdated_entries, visible};
use anstyle::{AnsiColor, Style};
use std::io::{self, Write};
use stickler_run::{CaseEvent, EngineHeader, Totals, Verdict};
use stickler_types::{counted, grouped};

pub(crate) const BOLD: Style = Style::new().bold();
pub(crate) const DIM: Style = Style::new().dimmed();
pub(crate) const GOOD: Style = AnsiColor::Green.on_default();
pub(crate) const BAD: Style = AnsiColor::Red.on_default();

/// The number of failures that are shown whole, of engines whose causes are not known, where nothing else is asked for.
const SHOWN_FAILURES: usize = 40;

/// The maximum number of baseline entries out of date that are named.
const MAX_SHOWN_OUTDATED: usize = 20;

/// The facts that the summary needs besides the run.
#[derive(Clone, Copy, Debug, Default)]
pub struct Surroundings<'a> {
    /// The path of the folder of reports, where there is one.
    pub reports: Option<&'a str>,
    /// The maximum number of failures that are shown whole; `None` shows some of engines whose causes are not known.
    pub failures: Option<usize>,
}

/// Writes the summary of a run.
///
/// # Errors
/// Returns the error of writing to `out`.
pub fn write(out: &mut dyn Write, overview: &Overview, around: Surroundings<'_>) -> io::Result<()> {
    write_failures(out, overview, around)?;
    causes::write(out, overview)?;
    claims::write(out, overview)?;
    totals::write(out, overview)?;
    write_last_line(out, overview, around)
}

fn write_failures(out: &mut dyn Write, overview: &Overview, around: Surroundings<'_>) -> io::Result<()> {
    let shown: Vec<&CaseEvent> = match around.failures {
        Some(number) => overview.failures.iter().take(number).collect(),
        None => overview.unexplained_failures().take(SHOWN_FAILURES).collect(),
    };
    for case in &shown {
        failure::write(out, case, overview.engine(case), overview.totals.len() > 1)?;
    }
    let rest = overview.failed.saturating_sub(shown.len() as u64);
    if rest > 0 && overview.causes.is_empty() {
        let place = match around.reports {
            Some(folder) => format!("all are in {folder}/events.jsonl and {folder}/junit.xml"),
            None => "with --report DIR all are written to files".to_owned(),
        };
        writeln!(
            out,
            "{BAD}... and {} more that are not as expected{BAD:#}; {place}.\n",
            grouped(rest)
        )?;
    }
    Ok(())
}

fn write_last_line(out: &mut dyn Write, overview: &Overview, around: Surroundings<'_>) -> io::Result<()> {
    let sum = overview.sum();
    if overview.observations > 0 {
        let observations = counted(overview.observations, "observation", "observations");
        writeln!(
            out,
            "{observations} recorded where no document says what must be."
        )?;
        write_disagreements(out, overview)?;
    }
    write_differences(out, sum.of(Verdict::Differs))?;
    if let Some(header) = &overview.header {
        let engines: Vec<String> = header.engines.iter().map(engine).collect();
        let label = if engines.len() == 1 { "Engine" } else { "Engines" };
        writeln!(out, "{label}: {}.", engines.join(", "))?;
    }
    if let Some(folder) = around.reports {
        // A run that was cut short leaves its log and nothing else.
        match overview.footer {
            Some(_) => {
                writeln!(
                    out,
                    "Reports: {folder}/index.html; summary.md and results.json are beside it."
                )?;
                write_discrepancies(out, overview, folder)
            }
            None => writeln!(out, "Reports: {folder}/events.jsonl, as far as the run came."),
        }?;
    }
    let broken = overview
        .header
        .as_ref()
        .map_or(0, |header| header.broken_files.len());
    if broken > 0 {
        let mistakes = counted(broken as u64, "mistake", "mistakes");
        writeln!(
            out,
            "{BAD}{mistakes} in case files: some cases were not run.{BAD:#}"
        )?;
    }
    let out_of_date = write_outdated(out, overview)?;
    let cases = counted(sum.all(), "case", "cases");
    let Some(footer) = &overview.footer else {
        return writeln!(out, "{BAD}Cut short after {cases}.{BAD:#}");
    };
    let time = duration(footer.duration_ms);
    if sum.all() > 0 && sum.of(Verdict::Unsupported) == sum.all() {
        return writeln!(
            out,
            "{BAD}{cases} in {time}: nothing was tested, since all are unsupported.{BAD:#}"
        );
    }
    match overview.failed {
        0 => {
            let style = if broken > 0 || out_of_date > 0 { BAD } else { GOOD };
            let but = match out_of_date {
                0 => String::new(),
                number => format!(", but {}", outdated_entries(number)),
            };
            writeln!(
                out,
                "{style}{cases} in {time}: all as expected{}{but}.{style:#}",
                kinds(&sum, true)
            )
        }
        failed => {
            let kinds = kinds(&sum, false);
            writeln!(
                out,
                "{BAD}{} of {cases} not as expected{kinds}{BAD:#}, in {time}.",
                grouped(failed)
            )
        }
    }
}

/// Writes the number of cases in which an engine differs from a source that does not bind it.
fn write_differences(out: &mut dyn Write, differences: u64) -> io::Result<()> {
    if differences == 0 {
        return Ok(());
    }
    let cases = counted(differences, "case differs", "cases differ");
    writeln!(
        out,
        "{cases} from Stickler's own rules or from sources about other systems, which is no failure."
    )
}

/// Writes the path of the pages that can be sent to the authors of a compiler, where there are any.
fn write_discrepancies(out: &mut dyn Write, overview: &Overview, folder: &str) -> io::Result<()> {
    let failed: u64 = overview.claims.iter().map(|claim| claim.standing.failed).sum();
    if failed == 0 {
        return Ok(());
    }
    let cases = counted(failed, "case is", "cases are");
    writeln!(
        out,
        "{cases} otherwise than documents say, with a page for each cause:\n{folder}/{NAME}"
    )
}

/// Writes the number of observations in which the engines disagree.
fn write_disagreements(out: &mut dyn Write, overview: &Overview) -> io::Result<()> {
    let disagreements = overview.observed.disagreements(&overview.engines());
    let cases: u64 = disagreements.iter().map(|disagreement| disagreement.cases).sum();
    if cases == 0 {
        return Ok(());
    }
    let ways = counted(disagreements.len() as u64, "way", "ways");
    let differing = counted(cases, "observation differs", "observations differ");
    writeln!(
        out,
        "{differing} between the engines, in {ways}; summary.md compares them."
    )
}

/// Names the entries of baselines that are out of date, and gives their number.
fn write_outdated(out: &mut dyn Write, overview: &Overview) -> io::Result<usize> {
    let number = overview.outdated().count();
    for entry in overview.outdated().take(MAX_SHOWN_OUTDATED) {
        writeln!(out, "{BAD}OUTDATED{BAD:#} {}", outdated(entry))?;
    }
    if number > MAX_SHOWN_OUTDATED {
        writeln!(out, "{BAD}... and {} more.{BAD:#}", number - MAX_SHOWN_OUTDATED)?;
    }
    Ok(number)
}

/// Formats an engine's name and version, and how it was judged where that was not by code and line.
fn engine(header: &EngineHeader) -> String {
    let named = format!("{} {}", header.name, header.version);
    format!("{}{}", visible(named.trim_end()), judged(header.strict))
}

/// Formats the counts of those verdicts beside `pass` that are as expected, or of those that are not.
fn kinds(totals: &Totals, as_expected: bool) -> String {
    let kinds: Vec<String> = Verdict::ALL
        .into_iter()
        .filter(|verdict| *verdict != Verdict::Pass && verdict.is_as_expected() == as_expected)
        .filter(|verdict| totals.of(*verdict) > 0)
        .map(|verdict| format!("{} {verdict}", totals.of(verdict)))
        .collect();
    if kinds.is_empty() {
        String::new()
    } else {
        format!(" ({})", kinds.join(", "))
    }
}

#[cfg(test)]
mod tests {
    use super::{SHOWN_FAILURES, Surroundings, write};
    use crate::overview::Overview;
    use crate::sample;
    use stickler_run::{CaseEvent, Event, Verdict};

    fn shown(events: &[Event]) -> String {
        let mut overview = Overview::default();
        events.iter().for_each(|event| overview.take(event));
        let mut bytes = Vec::new();
        write(
            &mut bytes,
            &overview,
            Surroundings {
                reports: Some("reports/latest"),
                failures: None,
            },
        )
        .expect("written");
        anstream::adapter::strip_str(&String::from_utf8(bytes).expect("text")).to_string()
    }

    #[test]
    fn a_failure_shows_all_that_is_needed_to_look_into_it_and_the_last_line_says_how_it_went() {
        assert_eq!(
            shown(&sample::run()),
            "\
FAIL widening/broken@ironplc-ed2
     SINT widens to INT
     basis    ironplc-type-conversions: Integer widening
     at       conformance-cases/widening/integer.toml:7
     expected - into = INT#-128
     got      + into = INT#128
     rerun    stickler run --filter 'widening/broken@ironplc-ed2'

Claims                      passed  failed  open
  ironplc-type-conversions       2       1     1
    Integer widening             2       1     1

Cases          widening  all
  ironplc-ed2       3/4  3/4
  n/m: n of m cases are as expected

1 observation recorded where no document says what must be.
Engine: reference 0.1.0.
Reports: reports/latest/index.html; summary.md and results.json are beside it.
1 case is otherwise than documents say, with a page for each cause:
reports/latest/discrepancies
1 of 4 cases not as expected (1 fail), in 34 ms.
"
        );
    }

    #[test]
    fn texts_of_several_lines_are_shown_as_a_diff() {
        let case = CaseEvent {
            expected: vec![sample::rendered(&["a := 1;", "b := 2;"])],
            got: vec![sample::rendered(&["a := 1;", "b := 3;"])],
            ..sample::case("x", Verdict::Fail)
        };
        let text = shown(&sample::run_of(vec![case]));
        let diff = "\
     diff     - expected + got
                a := 1;
              - b := 2;
              + b := 3;
";
        assert!(text.contains(diff), "{text}");
    }

    #[test]
    fn a_run_without_failures_says_so_and_names_no_section() {
        let text = shown(&sample::run_of(vec![
            sample::case("a", Verdict::Pass),
            sample::case("b", Verdict::Xfail),
        ]));
        assert!(
            text.ends_with("2 cases in 34 ms: all as expected (1 xfail).\n"),
            "{text}"
        );
    }

    #[test]
    fn a_difference_is_no_failure_and_is_counted_apart() {
        let text = shown(&sample::run_of(vec![
            sample::case("a", Verdict::Pass),
            sample::case("b", Verdict::Differs),
        ]));
        assert!(text.contains("passed  failed  differs  open\n"), "{text}");
        assert!(
            text.contains("1 case differs from Stickler's own rules or from sources about other systems"),
            "{text}"
        );
        assert!(
            text.ends_with("2 cases in 34 ms: all as expected (1 differs).\n"),
            "{text}"
        );
    }

    #[test]
    fn a_run_of_which_nothing_was_executed_does_not_end_as_if_all_were_well() {
        let unsupported = |id| sample::case(id, Verdict::Unsupported);
        let text = shown(&sample::run_of(vec![unsupported("a"), unsupported("b")]));
        assert!(
            text.ends_with("2 cases in 34 ms: nothing was tested, since all are unsupported.\n"),
            "{text}"
        );
        let text = shown(&sample::run_of(vec![
            sample::case("a", Verdict::Pass),
            unsupported("b"),
        ]));
        assert!(text.ends_with("all as expected (1 unsupported).\n"), "{text}");
    }

    #[test]
    fn several_engines_stand_side_by_side() {
        let on = |engine: &str, case: CaseEvent| CaseEvent {
            engine: engine.to_owned(),
            ..case
        };
        let mut rounds = on("matiec", sample::open_case("open"));
        rounds.observations[0].value = "INT#2".to_owned();
        let cases = vec![
            on("reference", sample::case("a", Verdict::Pass)),
            on("matiec", sample::case("a", Verdict::Fail)),
            on("reference", sample::open_case("open")),
            rounds,
        ];
        let text = shown(&sample::run_on(&["reference", "matiec"], cases));
        let table = "
Claims                      reference  matiec
  ironplc-type-conversions        1/1     0/1
    Integer widening              1/1     0/1
  n/m: n of m cases came out as the source says
";
        assert!(text.contains(table), "{text}");
        assert!(
            text.contains(
                "\n1 observation differs between the engines, in 1 way; summary.md compares them.\n"
            ),
            "{text}"
        );
    }

    #[test]
    fn a_claim_shows_the_kind_of_its_source() {
        let text = shown(&sample::with_sources(sample::run()));
        let table = "
Claims                      kind      passed  failed  open
  ironplc-type-conversions  document       2       1     1
    Integer widening                       2       1     1
";
        assert!(text.contains(table), "{text}");
    }

    #[test]
    fn what_a_baseline_says_stands_with_the_case_and_what_is_out_of_date_with_the_end() {
        let mut events = sample::run_with_baseline();
        let text = shown(&events);
        let note =
            "     baseline b/reference.toml:7 expects fail: rounds (https://example.org/1)\n     rerun    ";
        assert!(text.contains(note), "{text}");
        let outdated = "OUTDATED b/reference.toml:12: widening/gone* fits no case\n1 of 2 cases";
        assert!(text.contains(outdated), "{text}");
        // What is expected is not shown, and yet not all is well.
        events.remove(1);
        let text = shown(&events);
        assert!(
            text.ends_with("all as expected (1 xfail), but 1 entry of a baseline is out of date.\n"),
            "{text}"
        );
    }

    #[test]
    fn a_run_that_was_not_judged_by_code_and_line_says_so() {
        let text = shown(&sample::run_by_line());
        let engine = "Engine: reference 0.1.0 (rejections judged by line).\n";
        assert!(text.contains(engine), "{text}");
    }

    #[test]
    fn what_was_judged_by_line_is_compared_by_line() {
        let text = shown(&sample::run_by_line());
        for line in sample::BY_LINE {
            assert!(text.contains(line), "{line} in {text}");
        }
    }

    #[test]
    fn thousands_of_failures_are_counted_and_not_all_shown() {
        let cases = (0..3000)
            .map(|number| sample::case(&number.to_string(), Verdict::Crash))
            .collect();
        let text = shown(&sample::run_of(cases));
        assert_eq!(text.matches("CRASH").count(), SHOWN_FAILURES);
        let rest = 3000 - SHOWN_FAILURES;
        assert!(
            text.contains(&format!(
                "and {} more that are not as expected; all are in",
                stickler_types::grouped(rest as u64)
            )),
            "{text}"
        );
    }

    #[test]
    fn where_causes_are_known_single_failures_are_shown_only_when_asked_for() {
        let mut events = sample::run();
        let footer = events.pop().expect("a footer");
        events.extend([
            Event::Cause(sample::cause("it widens nothing", 1, Verdict::Fail)),
            footer,
        ]);
        let text = shown(&events);
        assert!(
            text.starts_with("Cases  Cause\n    1  it widens nothing\n"),
            "{text}"
        );
        assert!(!text.contains("FAIL"), "{text}");
        let mut overview = Overview::default();
        events.iter().for_each(|event| overview.take(event));
        let mut bytes = Vec::new();
        let around = Surroundings {
            reports: None,
            failures: Some(1),
        };
        write(&mut bytes, &overview, around).expect("written");
        assert!(String::from_utf8_lossy(&bytes).contains("FAIL"));
    }

    #[test]
    fn a_run_that_was_cut_short_says_so_last() {
        let events = sample::run();
        assert!(shown(&events[..3]).ends_with("Cut short after 2 cases.\n"));
    }

    #[test]
    fn a_run_of_a_broken_suite_does_not_end_as_if_all_were_well() {
        let mut events = sample::run_of(vec![sample::case("a", Verdict::Pass)]);
        if let Event::Header(header) = &mut events[0] {
            header.broken_files = vec!["a.st:1: wrong".to_owned()];
        }
        let text = shown(&events);
        assert!(
            text.contains("\n1 mistake in case files: some cases were not run.\n1 case in"),
            "{text}"
        );
    }

    #[test]
    fn no_line_of_an_ordinary_summary_is_wider_than_80_columns() {
        for line in shown(&sample::run()).lines() {
            assert!(line.chars().count() <= 80, "{line}");
        }
    }
}
