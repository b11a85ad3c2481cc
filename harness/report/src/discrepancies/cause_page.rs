//! Writes the page of a cause, and its line in the list of an engine's pages.

use super::Discrepancy;
use super::page::{Told, block, called, expected_and_got, not_compared};
use crate::basis::Basis;
use crate::markdown::{code, inline, linked};
use crate::overview::Overview;
use crate::text::{noted, visible};
use std::cmp::Reverse;
use std::collections::BTreeMap;
use stickler_run::{
    CaseEvent, Cause, EngineHeader, ExplainedCases, Fact, Grade, PROGRAM, RepeatedOutcome, Repeats,
    Reproducer, Source, Verdict,
};
use stickler_types::{Contradiction, Relation, counted, grouped, join};

/// The maximum number of other claims that a page lists, those with the most cases first.
const MAX_CLAIMS: usize = 6;

/// The maximum number of lines in the table of cases; the others are counted.
const MAX_LISTED: usize = 40;

/// The maximum number of lines that are shown of what the commands print.
const MAX_PRINTED: usize = 40;

/// The words about causes whose pages stand in a folder of their own.
pub(super) struct ApartWords {
    /// The end of the heading behind `What COMPILER does otherwise than`.
    heading: &'static str,
    /// The paragraph below the heading.
    about: &'static str,
    /// The sentence that leads to the folder, behind the number of its pages.
    link: &'static str,
}

/// The words about causes that contradict no source that binds the engine.
pub(super) const DIFFERS: ApartWords = ApartWords {
    heading: "sources that do not speak for it",
    about: "These are no failures: the sources are Stickler's own rules, or are about other systems.",
    link: "differences from sources that do not speak for this compiler.",
};

/// The words about causes whose programs were not made as small as possible.
pub(super) const UNREDUCED: ApartWords = ApartWords {
    heading: "documents say, not made small",
    about: "The search for causes ended before the programs of these pages were as small as possible. Most of them show a cause that \
            has a page of its own already, or several of them one cause; `--cause-time` gives the search more time.",
    link: "the search ended before their programs were as small as possible, so that most of them show a cause of the list above.",
};

impl ApartWords {
    /// Returns the beginning of the list in the folder.
    pub(super) fn head(&self, name: &str, about: Option<&EngineHeader>) -> String {
        format!(
            "# What {} does otherwise than {}\n\n{}\n\n",
            called(name, about),
            self.heading,
            self.about
        )
    }

    /// Returns the sentence that leads from the list of an engine's causes to the list in the folder.
    pub(super) fn link(&self, folder: &str, causes: &[&Discrepancy]) -> String {
        let pages = counted(causes.len() as u64, "more page is", "more pages are");
        let cases: u64 = causes.iter().map(|(cause, _)| cause.number()).sum();
        let cases = counted(cases, "case", "cases");
        format!(
            "\n{pages} in [`{folder}`]({folder}/README.md), for {cases}: {}\n",
            self.link
        )
    }
}

/// The words about pages of causes, behind their number.
pub(super) const OF_CAUSES: &str = "one for each cause: what one mend would probably put right. The smallest program of each was found by asking the compiler. A \
                                    page is ready to be sent to those who write the compiler, once somebody has read it.";

/// The words about pages of clusters, behind their number.
pub(super) const OF_CLUSTERS: &str = "each about the cases of one file and claim with one symptom, so most probably with one cause. Each is ready to be sent to \
                                      those who write the compiler, once somebody has read it.";

/// Returns the beginning of the list of an engine's pages. `unexplained` is the number of failing cases that belong to none.
pub(super) fn index(
    name: &str,
    about: Option<&EngineHeader>,
    (causes, words): (usize, &str),
    unexplained: u64,
) -> String {
    let mut text = format!(
        "# What {} does otherwise than documents say\n\n",
        called(name, about)
    );
    let pages = counted(causes as u64, "page", "pages");
    text += &format!("{pages}, {words}\n\n");
    if unexplained > 0 {
        let cases = counted(unexplained, "case", "cases");
        text += &format!("No page has room for {cases} of other kinds; `events.jsonl.gz` has them.\n\n");
    }
    text
}

/// Returns the table of pages.
pub(super) fn list(causes: &[&Discrepancy]) -> String {
    if causes.is_empty() {
        return String::new();
    }
    let mut text = "| cases | page | claim |\n|--:|---|---|\n".to_owned();
    for ((cause, _), number) in causes.iter().zip(1..) {
        let (cases, title) = (cause.number(), titled(&cause.headline()));
        text += &format!(
            "| {cases} | [{title}]({}) | {} |\n",
            file(number, cause),
            inline(&cause.shown.basis)
        );
    }
    text
}

/// Returns the title or the heading of a cause, whose pieces of programs stand in backquotes.
pub(crate) fn titled(title: &str) -> String {
    let pieces = title.split('`').enumerate();
    let shown = pieces.map(|(at, piece)| match at % 2 {
        0 => inline(piece),
        _ => code(piece),
    });
    shown.collect()
}

/// Returns the name of a page, such as `03-into-data-is-accepted-not-rejected-with-P4035.md`.
pub(super) fn file(number: usize, cause: &Cause) -> String {
    let title = cause.headline();
    let words = title.split(|character: char| !character.is_ascii_alphanumeric());
    let mut name = join(words.filter(|word| !word.is_empty()), "-");
    name.truncate(60);
    format!("{number:02}-{}.md", name.trim_end_matches('-'))
}

/// Returns the page of a cause. Of a cluster, `case` is the case with the smallest program, which was not changed.
pub(crate) fn page(
    name: &str,
    about: Option<&EngineHeader>,
    (cause, case): (&Cause, Option<&CaseEvent>),
    overview: &Overview,
) -> String {
    let shown = &cause.shown;
    let mut text = format!("# {}: {}\n\n", called(name, about), titled(&cause.headline()));
    if let Some(case) = case {
        text += &format!("{}.\n\n", inline(&case.title));
    }
    match shown.program.is_empty() && !shown.case.is_empty() {
        true => {
            let command = code(&format!(
                "stickler reproduce '{}' --engine {name} DIR",
                shown.case
            ));
            text += &format!("{command} writes a program that shows it, and the commands.\n\n");
        }
        false => reproduction(&mut text, about, shown),
    }
    let by = match shown.is_derived {
        // What a compiler lacks may be promised by nobody whose word binds it.
        _ if shown.basis.is_empty() => "Expected, though no source that binds it says so:".to_owned(),
        // The claim says nothing of a program that does something else.
        true => format!("Expected (found through cases of {}):", cited(shown, overview)),
        false => format!("Expected, by {}:", cited(shown, overview)),
    };
    let told = Told {
        printed: &shown.printed,
        strict: about.map_or(Grade::Code, |about| about.strict),
    };
    expected_and_got(&mut text, &by, (&shown.basis, &shown.expected, &shown.got), &told);
    limitation(&mut text, cause, overview);
    contradiction(&mut text, cause, overview);
    rule(&mut text, shown, overview);
    let claim = Basis::of(&shown.basis);
    let source = overview.source(claim.source);
    let is_foreign = source.is_some_and(|source| !source.engines.contains(&cause.engine));
    if cause.differs() && is_foreign && !claim.is_rule() {
        text.push_str("This source does not bind the compiler, so that the difference is no failure.\n\n");
    }
    if let Some(repeats) = &cause.flaky {
        by_chance(&mut text, repeats);
    }
    if shown.expected.iter().any(|fact| fact.diagnostic().is_some()) {
        let lines = format!("Lines are those of `{PROGRAM}`. {}", not_compared(told.strict));
        text += &format!("{}\n\n", lines.trim_end());
    }
    if let Some(told) = shown.neighbours_told() {
        text += &format!("{told}\n\n");
    }
    cases(&mut text, cause);
    if let Some(note) = case.and_then(|case| case.baseline.as_ref()) {
        text += &format!("It is known: {}.\n\n", inline(&noted(note)));
    }
    let rerun = about.filter(|_| !shown.case.is_empty());
    let rerun = rerun.map(|about| about.rerun(&shown.case, &shown.dialect));
    text += &format!("Found by Stickler, in its dialect `{}`", shown.dialect);
    text.push_str(&match rerun.filter(|rerun| !rerun.is_empty()) {
        Some(rerun) => format!("; a case that shows it: {}\n", code(&without_folders(&rerun))),
        None => ".\n".to_owned(),
    });
    text
}

/// Returns a command without the folders of absolute paths, which only one machine has.
fn without_folders(command: &str) -> String {
    let ends = |sign: char| sign.is_whitespace() || matches!(sign, '\'' | '"' | '=');
    let words = command.split_inclusive(ends).map(|word| {
        let begins = word.find('/').filter(|at| *at == 0 || word[..*at].ends_with(':'));
        match begins.zip(word.rfind('/')) {
            Some((begin, end)) => format!("{}{}", &word[..begin], &word[end + 1..]),
            None => word.to_owned(),
        }
    });
    words.collect()
}

/// Adds what the makers of a compiler say themselves of what it does not implement, since that contradicts what promises it.
fn limitation(text: &mut String, cause: &Cause, overview: &Overview) {
    let reason = cause.shown.got.iter().find_map(|fact| match fact {
        Fact::NotImplemented { reason, .. } => Some(reason.as_str()),
        _ => None,
    });
    let code = reason.and_then(|reason| Some(reason.split_once(':')?.0));
    let own = |source: &&Source| source.engines.contains(&cause.engine);
    let claim = Basis::of(&cause.shown.basis);
    let mut cited = overview.sources().iter().filter(own);
    let cited = cited.find(|source| source.key == claim.source);
    if let Some(limits) = cited.and_then(|source| source.limitations.get(claim.section)) {
        *text += &format!("The source limits what it promises: {limits}.\n\n");
    }
    let said = code.and_then(|code| {
        let mut own = overview.sources().iter().filter(own);
        own.find_map(|source| Some((source, code, source.limitations.get(code)?)))
    });
    if let Some((source, code, lacks)) = said {
        let claim = linked(&format!("{}: {code}", source.key), &source.address_of(code));
        *text += &format!(
            "{claim} lists what may give this answer: {lacks}. Where a page promises one of these, the two pages contradict each \
             other.\n\n"
        );
    }
}

/// Adds what other sources of the makers of a compiler, or other parts of the source of the claim, say against it.
fn contradiction(text: &mut String, cause: &Cause, overview: &Overview) {
    let Reproducer {
        basis, case, program, ..
    } = &cause.shown;
    let dies = cause
        .shown
        .got
        .iter()
        .any(|fact| matches!(fact, Fact::Crashed { .. }));
    let claimed = Basis::of(basis).source;
    let own = |source: &&Source| source.key == claimed || source.engines.contains(&cause.engine);
    let sources = overview.sources().iter().filter(own);
    let told = sources.flat_map(|source| source.contradicts.iter().map(move |other| (source, other)));
    let version = overview
        .engine(&cause.engine)
        .map_or("", |engine| engine.version.as_str());
    let is_told =
        |other: &Contradiction| !other.claims_hold_in(version) && other.is_of(basis, (case, program));
    for (source, other) in told.filter(|(_, other)| is_told(other)) {
        let section = linked(
            &format!("{}: {}", source.key, other.section),
            &source.address_of(&other.section),
        );
        let (publisher, title, says) = (
            inline(&source.publisher),
            inline(&source.title),
            inline(&other.says),
        );
        let (says_what, binds) = match (&other.until, other.outweighed) {
            (Some(until), _) => (
                "itself says otherwise",
                format!("The claim ended with version {until}."),
            ),
            (None, true) if cause.differs() => ("on the same", String::new()),
            // No claim allows a compiler to die.
            (None, _) if dies => ("on the same", String::new()),
            (None, true) => ("on the same", "The claim binds it all the same.".to_owned()),
            (None, false) => (
                "itself says otherwise",
                "So the claim does not bind it.".to_owned(),
            ),
        };
        *text += &format!("{publisher} {says_what}: {section} ({title}) {says}. {binds}");
        text.truncate(text.trim_end().len());
        text.push_str("\n\n");
    }
}

/// Adds the rule of Stickler on which the expectation rests; that nothing is stated is none.
fn rule(text: &mut String, shown: &Reproducer, overview: &Overview) {
    let Basis { source, section } = Basis::of(&shown.basis);
    let paragraph = overview
        .source(source)
        .and_then(|source| source.paragraphs.get(section));
    if let Some(paragraph) = paragraph.filter(|_| section != "not-stated") {
        *text += &format!(
            "The rule is Stickler's own, and binds no compiler: {}\n\n",
            paragraph.trim()
        );
    }
}

/// Adds the outcomes of a program with which the compiler does not do the same each time.
fn by_chance(text: &mut String, repeats: &Repeats) {
    let Repeats { seen, of, outcomes } = repeats;
    *text += &format!("**By chance:** this came in {seen} of {of} runs of the same program.\n\n");
    for RepeatedOutcome { got, runs } in outcomes {
        let shown = visible(&Fact::text(got)).replace('\n', "; ");
        *text += &format!("- {runs} of {of}: {}\n", code(&shown));
    }
    if !outcomes.is_empty() {
        text.push('\n');
    }
}

/// Adds the program, and what has to be done to see what the compiler does with it.
fn reproduction(text: &mut String, about: Option<&EngineHeader>, shown: &Reproducer) {
    let Some(reproduction) = &shown.reproduction else {
        block(
            text,
            &format!("Save this as `{PROGRAM}`:"),
            "iecst",
            &visible(&shown.program),
        );
        match about.and_then(|about| about.commands.get(&shown.dialect)) {
            Some(command) => block(text, "and run", "sh", command),
            None => text.push_str("and give it to the compiler.\n\n"),
        }
        return;
    };
    for file in &reproduction.files {
        let language = match file.name.rsplit('.').next() {
            Some("st") => "iecst",
            Some(other) => other,
            None => "",
        };
        block(
            text,
            &format!("Save this as `{}`:", file.name),
            language,
            &visible(&file.text),
        );
    }
    block(text, "and run", "sh", &reproduction.commands_with_tools());
    if !shown.printed.is_empty() {
        block(
            text,
            "That prints, but for colours and the folders of files:",
            "",
            &visible(&first_lines(&shown.printed)),
        );
    }
}

/// Returns the first lines of a text, and how many follow.
fn first_lines(text: &str) -> String {
    let mut lines = text.lines();
    let first: Vec<&str> = lines.by_ref().take(MAX_PRINTED).collect();
    let left = lines.count() as u64;
    let more = (left > 0).then(|| format!("… {}", counted(left, "more line", "more lines")));
    let lines = first.into_iter().map(str::to_owned).chain(more);
    join(lines, "\n")
}

/// Returns the claim with the source that makes it, as a link where that has an address of the web.
fn cited(shown: &Reproducer, overview: &Overview) -> String {
    let Basis { source, section } = Basis::of(&shown.basis);
    let Some(source) = overview.source(source) else {
        return format!("*{}*", inline(&shown.basis));
    };
    let claim = linked(&shown.basis, &source.address_of(section));
    let Source {
        title,
        publisher,
        kind,
        read,
        ..
    } = source;
    let read = if read.is_empty() {
        String::new()
    } else {
        format!(", read {}", inline(read))
    };
    let publisher = inline(publisher);
    let by = match source.relation {
        Relation::Maker => publisher,
        Relation::Restatement => format!("{publisher}, in a restatement"),
        Relation::ThirdParty => format!("{publisher}, a third party"),
        Relation::Integrator if source.engines.is_empty() => {
            format!("{publisher}, an integrator and not the maker")
        }
        Relation::Integrator => format!(
            "as {publisher}, an integrator and not the maker, documents {}",
            source.engines.join(" and ")
        ),
    };
    format!(
        "{claim} ({by}: {}, {}{read})",
        inline(title),
        inline(kind.as_str())
    )
}

/// Adds the number of cases, the claims that they belong to, and their probes and dialects.
fn cases(text: &mut String, cause: &Cause) {
    let number = cause.number();
    let shows = match (cause.is_lack(), number) {
        (false, 1) => "case shows this",
        (false, _) => "cases show this",
        (true, 1) => "case uses it and is refused; it waits for it",
        (true, _) => "cases use it and are refused; they wait for it",
    };
    *text += &format!("{} {shows}", grouped(number));
    let mut claims: BTreeMap<&str, u64> = BTreeMap::new();
    for some in &cause.cases {
        *claims.entry(some.basis.as_str()).or_default() += some.cases;
    }
    claims.remove(cause.shown.basis.as_str());
    match claims.is_empty() || cause.is_lack() {
        true => text.push_str(":\n"),
        false => text
            .push_str(". It hides whether the compiler meets other claims, whose cases fail for it too:\n\n"),
    }
    let mut claims: Vec<_> = claims.into_iter().filter(|_| !cause.is_lack()).collect();
    claims.sort_by_key(|(_, cases)| Reverse(*cases));
    for (claim, cases) in claims.iter().take(MAX_CLAIMS) {
        *text += &format!("- {}: {cases}\n", inline(claim));
    }
    if let Some(others) = claims.get(MAX_CLAIMS..).filter(|others| !others.is_empty()) {
        *text += &format!("- {}\n", counted(others.len() as u64, "other", "others"));
    }
    text.push_str("\n| cases | probe | dialect |\n|--:|---|---|\n");
    let mut listed: Vec<ExplainedCases> = Vec::new();
    for some in &cause.cases {
        // The claims stand in the list above, and what came is said once.
        let (basis, verdict) = (String::new(), Verdict::default());
        let some = ExplainedCases {
            basis,
            verdict,
            ..some.clone()
        };
        ExplainedCases::add(&mut listed, some);
    }
    listed.sort_by_key(|some| Reverse(some.cases));
    for some in listed.iter().take(MAX_LISTED) {
        *text += &format!(
            "| {} | {} | {} |\n",
            some.cases,
            code(&some.probe),
            inline(&some.dialect)
        );
    }
    let rest: u64 = listed.iter().skip(MAX_LISTED).map(|some| some.cases).sum();
    if rest > 0 {
        *text += &format!("| {rest} | others | |\n");
    }
    text.push('\n');
}
