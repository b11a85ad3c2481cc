//! The parts of the reader one by one: each makes texts of texts, which stand in tables in `tests/parts`.

use crate::condition::{Condition, Testable};
use crate::scan::scan;
use crate::template::Template;
use crate::{Dialects, QuoteResult, Sources, Suite, ToldSymptom, Wanted, files, ident, sources};
use stickler_mdtest::{Example, check_examples};
use stickler_types::{DialectName, join};

#[test]
fn golden_conditions() {
    check_examples("tests/parts/conditions.md", |example| {
        let names: Vec<Box<str>> = ["row", "column", "cell", "value"].map(Into::into).into();
        let (names, known, unnamed) = match example.wanted() {
            "without names" => (&names[..0], 0, None),
            _ => (&names[..], 3, Some(2)),
        };
        let words: Vec<&str> = example.text("condition").split_whitespace().collect();
        let texts = ["row", "column", "cell", "value"].map(|name| example.text(name));
        let condition = Condition::parse(
            &words,
            Testable {
                names,
                known,
                unnamed,
            },
        );
        let holds = condition.map(|condition| condition.holds(&texts));
        holds.map_or_else(
            |message| message,
            |holds| if holds { "yes" } else { "no" }.to_owned(),
        )
    });
}

#[test]
fn golden_templates() {
    check_examples("tests/parts/templates.md", |example| {
        let names: Vec<Box<str>> = ["row", "value"].map(Into::into).into();
        let template = match Template::parse(example.text("template"), &names) {
            Ok(template) => template,
            Err(mistake) => return format!("at {}: {}", mistake.offset, mistake.message),
        };
        let slots = template
            .placed_slots()
            .map(|(slot, at)| format!(", {} at {at}", names[slot]));
        let slots: String = slots.collect();
        let fixed = if template.fixed().is_some() { ", fixed" } else { "" };
        format!("{}{fixed}{slots}", template.fill(&mut String::new(), &["R", "é"]))
    });
}

#[test]
fn golden_scan() {
    check_examples("tests/parts/marks.md", |example| {
        let found = scan(example.text("text"));
        let marks = found
            .marks
            .iter()
            .map(|mark| format!("{}: [{}]", mark.line, mark.text));
        let hidden = found.hidden.iter().map(|line| format!("{line}: hidden"));
        let unclosed = found.unclosed.iter().map(|line| format!("{line}: not closed"));
        join(marks.chain(hidden).chain(unclosed), "\n")
    });
}

#[test]
fn golden_ids() {
    check_examples("tests/parts/ids.md", |example| {
        let mut id = String::from("x(");
        match (example.get("path"), example.get("name")) {
            (Some(path), _) => ident::of_file(path).unwrap_or_else(|message| message),
            (_, Some(name)) => ident::check(name).map_or_else(|message| message, |()| "ok".to_owned()),
            _ => {
                ident::push_cell(&mut id, example.text("cell"));
                id.split_off(2)
            }
        }
    });
}

/// Returns the sources of the files of an example, and what is wrong with them.
fn sources_of(example: &Example) -> (Sources, String) {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path().join("cases");
    std::fs::create_dir_all(root.join("recordings")).unwrap();
    for (path, text) in example
        .inputs()
        .filter(|(name, _)| name.ends_with(".toml") || name.ends_with(".md"))
    {
        std::fs::write(root.join(path), text).unwrap();
    }
    let found = sources::read(&files::Root::new(&root), &Dialects::default());
    let errors = found
        .errors
        .into_iter()
        .chain(found.remarks)
        .map(|error| error.to_string().replacen("cases/", "", 1));
    (found.sources, join(errors, "\n"))
}

/// Returns what a saved page says of a quote.
fn checked(page: &str, quote: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let source = "[page]\ntitle = 't'\npublisher = 'p'\nrelation = 'maker'\nkind = 'standard'\naddress = 'https://example.org/{section}'\n\
                  read = '1'\nsections = 'clauses'\n";
    std::fs::create_dir(folder.path().join("page")).unwrap();
    std::fs::write(folder.path().join("page/5.html"), page).unwrap();
    std::fs::write(
        folder.path().join("sources.toml"),
        format!("{source}quotes.5 = ['{quote}']\nquotes.6 = ['1']\n"),
    )
    .unwrap();
    let sources = sources::read(&files::Root::new(folder.path()), &Dialects::default()).sources;
    let quotes = sources.check_quotes(folder.path());
    assert_eq!((quotes.len(), &quotes[1].result), (2, &QuoteResult::NoPage));
    format!("{:?}", quotes[0].result)
}

#[test]
fn golden_sources() {
    check_examples("tests/parts/sources.md", |example| {
        let (sources, mistakes) = sources_of(example);
        let basis = example.text("basis");
        match example.wanted() {
            "mistakes" => mistakes,
            "checked" => checked(example.text("page"), example.text("quote")),
            "limitations" => format!(
                "{mistakes}{:?}",
                sources.get("page").map(|page| &page.limitations)
            ),
            "told" => {
                let said = example.text("said");
                let found = [
                    sources.telling(ToldSymptom::Crash, "matiec", said),
                    sources.telling(ToldSymptom::NoPlace, "matiec", said),
                    sources.telling(ToldSymptom::FaultLine, "matiec", said),
                    sources.of_code("P4035", "matiec"),
                    sources.of_code("P4035", "ironplc"),
                ];
                let found = found.iter().map(|one| one.as_deref().unwrap_or("nothing"));
                Vec::from_iter(found).join(", ")
            }
            "chosen" => {
                let dialect: DialectName = example.text("dialect").parse().unwrap();
                sources.choose(basis, dialect).unwrap_or("none").to_owned()
            }
            _ => sources.check(basis).map_or_else(
                |message| message,
                |(source, section)| {
                    let address = source.address_of(section);
                    let address = address.trim_start_matches("cases/");
                    let speaks = DialectName::ALL
                        .into_iter()
                        .filter(|dialect| source.speaks_for(section, *dialect));
                    let dialects: Vec<&str> = speaks.map(DialectName::as_str).collect();
                    let dialects = if dialects.len() == DialectName::ALL.len() {
                        "all".to_owned()
                    } else {
                        dialects.join(" ")
                    };
                    let (key, kind, read) = (&source.key, source.kind.as_str(), source.read_of(section));
                    format!("{key} ({kind}, {read}): {section}, {address}, for {dialects}")
                },
            ),
        }
    });
}

#[test]
fn a_folder_without_sources_is_told_where_they_are_described() {
    let errors = Suite::load_files(std::path::Path::new("/nowhere"), Wanted::default(), |_, _| false).errors;
    let said: Vec<String> = errors.iter().map(ToString::to_string).collect();
    let told = said
        .iter()
        .find(|said| said.contains("sources.toml:1: cannot be read"));
    assert!(told.is_some_and(|said| said.contains("README.md")), "{said:?}");
}
