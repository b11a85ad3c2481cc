//! The compliance statement that the standard demands of a system: the tables of features by number, the effects of conversions, and
//! the parameters that are left to the implementer.
//!
//! The features that a system declares come from the file of its dialect; the measured ones from programs and cases that an engine is
//! [asked](measure).
//! Basis: iec-61131-3-2003: 1.5.1.

mod measure;

use crate::data::declared_by;
use measure::MeasuredFeatures;
use serde::Serialize;
use std::collections::BTreeMap;
use stickler_conversions::overview::{StatedFunction, StatementsBuilder, rules};
use stickler_conversions::{FunctionSession, Refusal};
use stickler_engines::{Engine, Identity};
use stickler_exact::Signature;
use stickler_report::{html_page, html_text, markdown_text};
use stickler_run::RunError;
use stickler_suite::{Feature, SourceKind, Suite};
use stickler_types::{DialectName, ElementaryType, join};
use stickler_workers::WorkerPool;

/// The system, the tables and the engine that a compliance statement is about.
pub struct CompliancePlan<'a> {
    /// The sources and features, and the cases that an engine may be asked.
    pub suite: &'a Suite,
    /// The statements of documents about the conversions of this dialect, and of no other.
    pub statements: &'a StatementsBuilder,
    /// The system.
    pub dialect: DialectName,
    /// The edition of the standard whose tables are listed. No table of the fourth is public: its statement has those of the third, and what public
    /// summaries say of the changes.
    pub edition: u8,
    /// The numbers of the only tables that are wanted, without conversions and parameters; all where there is none.
    pub tables: &'a [String],
    /// The engine that is measured; `None` states what is declared.
    pub engine: Option<&'a dyn Engine>,
}

/// A compliance statement.
#[derive(Serialize)]
pub struct ComplianceStatement {
    title: String,
    /// The claim of compliance, in the words that the standard prescribes.
    claim: String,
    sections: Vec<Section>,
    /// Whether something that was measured is not as it is declared or stated.
    pub differs: bool,
}

/// A section of a statement: a table of the standard, or another one.
#[derive(Serialize)]
struct Section {
    title: String,
    text: &'static str,
    head: &'static [&'static str],
    rows: Vec<Vec<String>>,
}

/// The titles of tables, by edition and number.
type TableTitles = BTreeMap<String, BTreeMap<String, String>>;

/// The place of a feature: the table and its number in it, each a number with the letters behind it.
type Place<'a> = ((u32, &'a str), (u32, &'a str));

impl ComplianceStatement {
    /// Makes the statement, and asks the engine where there is one. `None` where the edition has none of the tables.
    ///
    /// # Errors
    /// An engine or a thread that cannot be started, and an engine that takes no program at all.
    pub fn gather(plan: &CompliancePlan<'_>) -> Result<Option<ComplianceStatement>, RunError> {
        let (dialect, version) = (plan.dialect, &plan.suite.version);
        // The words of the standard are those of a maker about what was measured.
        let claim = match plan.engine.map(Engine::identity) {
            Some(Identity {
                name, version: of, ..
            }) => format!(
                "This system complies with the requirements of IEC 61131-3, edition {}, for the following language features: those that it \
                 has (measured on {name} {of}; dialect {dialect}, suite {version}).",
                plan.edition
            ),
            None => format!(
                "What documents and recordings say of this system, in the form of the statement that IEC 61131-3, edition {}, asks of its maker \
                 (not measured; dialect {dialect}, suite {version}). A feature of its edition is one of which no source says otherwise; of an \
                 open one none says anything.",
                plan.edition
            ),
        };
        let mut statement = ComplianceStatement {
            title: format!("Compliance statement: {}", plan.dialect.rules().title),
            claim,
            sections: Vec::new(),
            differs: false,
        };
        if plan.edition == SUMMARIZED {
            statement.claim += " No table of the fourth edition is public: the tables are those of the third, and what the fourth changes is second-hand.";
        }
        let titles: TableTitles = toml::from_str(include_str!("compliance/tables.toml")).unwrap_or_default();
        statement.add_features(plan, &titles)?;
        if statement.sections.is_empty() {
            return Ok(None);
        }
        if plan.tables.is_empty() {
            statement.add_other_rows(plan, &titles);
            statement.add_conversions(plan)?;
            statement.sections.push(Section {
                title: "Parameters that are left to the implementer".to_owned(),
                text: "",
                head: &["parameter", "value"],
                rows: measure::parameters(plan)?,
            });
        }
        Ok(Some(statement))
    }

    /// Adds the tables of features.
    ///
    /// # Errors
    /// As [`ComplianceStatement::gather`].
    fn add_features(&mut self, plan: &CompliancePlan<'_>, titles: &TableTitles) -> Result<(), RunError> {
        let rows = plan.rows();
        let features: Vec<&Feature> = rows.values().flatten().copied().collect();
        let mut measured = MeasuredFeatures::ask(plan, &features)?;
        let mut last = None;
        let head: &'static [&'static str] = &["No.", "feature", "declared", "source", "measured", "example"];
        let head = if plan.engine.is_some() { head } else { &head[..4] };
        for ((table, number), features) in rows {
            if last.replace(table) != Some(table) {
                let title = titles
                    .get(&plan.tables_of().to_string())
                    .and_then(|of| of.get(&numbered(table)));
                self.sections.push(Section {
                    title: format!("Table {}: {}", numbered(table), title.map_or("", |title| title)),
                    text: "",
                    head,
                    rows: Vec::new(),
                });
            }
            for feature in features {
                let declared = feature.support(plan.dialect).as_str();
                let (word, example) = measured.take(&feature.key);
                self.differs |= word == "differs" || declared == "has" && word == "lacks";
                let source = declared_by(feature, plan.dialect, plan.suite).unwrap_or_default();
                let is_standard = plan
                    .suite
                    .sources
                    .of(&source)
                    .is_some_and(|(source, _)| source.kind == SourceKind::Standard);
                let declared = match declared == "has" && is_standard {
                    true => "has, as a feature of its edition",
                    false => declared,
                };
                let [mut title, declared, word] = [&feature.title, declared, word].map(str::to_owned);
                let is_summarized =
                    |edition: &(&u8, &String)| *edition.0 == plan.edition && plan.edition == SUMMARIZED;
                for (_, change) in feature.tables.iter().filter(is_summarized) {
                    title = format!("{title} (fourth edition: {change})");
                }
                let mut row = vec![numbered(number), title, declared, source, word, example];
                row.truncate(head.len());
                if let Some(section) = self.sections.last_mut() {
                    section.rows.push(row);
                }
            }
        }
        Ok(())
    }

    /// Adds the rows that are about no feature of Stickler's list, and what public summaries say of the fourth edition.
    fn add_other_rows(&mut self, plan: &CompliancePlan<'_>, titles: &TableTitles) {
        let others = "Nothing is declared or measured of these, of which the last are of other languages than Structured Text.";
        let changes =
            "By public summaries, which the last row names; nothing of them is declared or measured.";
        for (key, title, text) in [
            (
                format!("{}-others", plan.tables_of()),
                "Rows that are not of Stickler's list",
                others,
            ),
            (
                format!("{}-changes", plan.edition),
                "Changes of this edition, second-hand",
                changes,
            ),
        ] {
            let Some(rows) = titles.get(&key) else { continue };
            let mut rows: Vec<_> = rows.iter().collect();
            rows.sort_by_key(|(place, _)| in_order(place));
            let rows = rows
                .into_iter()
                .map(|(place, what)| vec![place.clone(), what.clone()]);
            self.sections.push(Section {
                title: title.to_owned(),
                text,
                head: &["about", "is"],
                rows: rows.collect(),
            });
        }
    }

    /// Adds the conversion functions of the dialect, and compares what the engine gives for boundary values with what sources state.
    ///
    /// # Errors
    /// As [`ComplianceStatement::gather`].
    fn add_conversions(&mut self, plan: &CompliancePlan<'_>) -> Result<(), RunError> {
        let open = || Ok::<_, RunError>(plan.engine.map(FunctionSession::open).transpose()?);
        let lacks = |ty: &ElementaryType| plan.dialect.rules().lacks(&ty.name().to_ascii_lowercase());
        let functions = plan.statements.functions().iter().filter(|function| {
            let Signature { operands, result, .. } = &function.signature;
            !operands.iter().chain([result]).any(lacks)
        });
        let functions: Vec<&StatedFunction> = functions.collect();
        let mut rows = WorkerPool::new(0).map(functions.into_iter(), open, |session, function| {
            Ok(conversion(session.as_mut(), function, plan.dialect))
        })?;
        rows.sort();
        self.differs |= rows
            .iter()
            .any(|row| row.last().is_some_and(|example| !example.is_empty()));
        let head: &'static [&'static str] = &["function", "effects", "stated", "measured", "example"];
        let head = if plan.engine.is_some() { head } else { &head[..3] };
        rows.iter_mut().for_each(|row| row.truncate(head.len()));
        self.sections.push(Section {
            title: "Effects of conversions".to_owned(),
            text: "A function without an effect keeps the value, or has no rule in which systems differ. Stated: the boundary values whose \
                   results a source states; the others follow the effects, which are then Stickler's choice. Measured: the boundary values that \
                   the engine gives so.",
            head,
            rows,
        });
        Ok(())
    }
}

/// The edition of which only summaries are public.
const SUMMARIZED: u8 = 4;

impl CompliancePlan<'_> {
    /// Returns the edition whose tables are listed.
    fn tables_of(&self) -> u8 {
        self.edition.min(SUMMARIZED - 1)
    }

    /// Returns the features of the wanted tables, by their places. A feature without a row of a table is not of the statement.
    fn rows(&self) -> BTreeMap<Place<'_>, Vec<&Feature>> {
        let mut rows: BTreeMap<_, Vec<&Feature>> = BTreeMap::new();
        for feature in self.suite.features.iter() {
            let place = feature
                .tables
                .get(&self.tables_of())
                .and_then(|place| place.strip_prefix("Table "));
            let Some(place) = place else { continue };
            let (table, number) = place.split_once(", ").unwrap_or((place, ""));
            if self.tables.is_empty() || self.tables.iter().any(|wanted| wanted == table) {
                rows.entry((in_order(table), in_order(number)))
                    .or_default()
                    .push(feature);
            }
        }
        rows
    }
}

/// Divides a number from the letters behind it, so that it is in the order of numbers; 0 where there is none.
fn in_order(number: &str) -> (u32, &str) {
    let end = number
        .find(|letter: char| !letter.is_ascii_digit())
        .unwrap_or(number.len());
    (number[..end].parse().unwrap_or(0), &number[end..])
}

fn numbered((number, letters): (u32, &str)) -> String {
    match number {
        0 => letters.to_owned(),
        number => format!("{number}{letters}"),
    }
}

/// The words for the source of a value that no source states.
const CHOSEN: &str = "these effects, which no source states";

/// Returns the row of a conversion function.
fn conversion(
    session: Option<&mut FunctionSession<'_>>,
    function: &StatedFunction,
    dialect: DialectName,
) -> Vec<String> {
    let signature = &function.signature;
    let calls = &function.calls[..function.boundaries];
    let expected = function.expected(0, dialect);
    let rules = rules(signature, &[dialect]).into_iter();
    let effects: Vec<String> = rules.map(|(about, rule, _)| format!("{about}: {rule}")).collect();
    let (mut measured, mut example) = ("not asked".to_owned(), String::new());
    if let Some(session) = session {
        let got = session.results(dialect, signature, calls);
        let asked = got.iter().zip(&expected).zip(calls);
        let (right, mut wrong): (Vec<_>, Vec<_>) =
            asked.partition(|((got, expected), _)| got.as_ref() == Ok(&expected.value));
        measured = format!("{} of {}", right.len(), calls.len());
        wrong.sort_by_key(|((_, expected), _)| expected.basis.is_none());
        if let Some(((got, expected), call)) = wrong.first() {
            let operands: Vec<String> = call.iter().map(ToString::to_string).collect();
            let refused = |refusal: &Refusal| refusal.kind.as_str().to_owned();
            let gave = got.as_ref().map_or_else(refused, ToString::to_string);
            let basis = expected.basis.as_deref().unwrap_or(CHOSEN);
            example = format!(
                "{}: {gave}, and {} by {basis}",
                operands.join(", "),
                expected.value
            );
        }
    }
    let stated = expected[..calls.len()].iter();
    let stated = stated.filter(|expected| expected.basis.is_some()).count();
    let stated = format!("{stated} of {}", calls.len());
    let name = signature.to_string();
    vec![name, effects.join("; "), stated, measured, example]
}

/// The form of a statement.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ComplianceForm {
    /// Markdown.
    Markdown,
    /// A page for browsers.
    Html,
    /// JSON.
    Json,
}

impl ComplianceStatement {
    /// Returns the statement in a form.
    ///
    /// # Errors
    /// Returns the error of serde_json.
    pub fn text(&self, form: ComplianceForm) -> serde_json::Result<String> {
        if form == ComplianceForm::Json {
            return Ok(serde_json::to_string_pretty(self)? + "\n");
        }
        let is_page = form == ComplianceForm::Html;
        let mut text = match is_page {
            true => format!("<p>{}</p>\n", html_text(&self.claim)),
            false => format!("# {}\n\n{}\n", markdown_text(&self.title), self.claim),
        };
        for section in &self.sections {
            let written = if is_page {
                section.html()
            } else {
                section.markdown()
            };
            text.push_str(&written);
        }
        Ok(if is_page {
            html_page(&self.title, &text)
        } else {
            text
        })
    }
}

/// Writes a text, and the pieces of programs between its backquotes, each in its way.
fn with_code(text: &str, plain: impl Fn(&str) -> String, code: impl Fn(&str) -> String) -> String {
    let pieces = text.split('`').enumerate();
    let written = pieces.map(|(at, piece)| if at % 2 == 0 { plain(piece) } else { code(piece) });
    written.collect()
}

impl Section {
    fn markdown(&self) -> String {
        let mut text = format!("\n## {}\n\n", markdown_text(self.title.trim_end_matches(": ")));
        if !self.text.is_empty() {
            text += &format!("{}\n\n", self.text);
        }
        text += &format!(
            "| {} |\n|{}\n",
            self.head.join(" | "),
            "---|".repeat(self.head.len())
        );
        for row in &self.rows {
            let code = |piece: &str| format!("`{}`", piece.replace('|', "\\|"));
            let cells = row.iter().map(|cell| with_code(cell, markdown_text, code));
            text += &format!("| {} |\n", join(cells, " | "));
        }
        text
    }

    fn html(&self) -> String {
        let cells = |cells: &mut dyn Iterator<Item = &str>, tag: &str| {
            let code = |piece: &str| format!("<code>{}</code>", html_text(piece));
            let cells = cells.map(|cell| format!("<{tag}>{}</{tag}>", with_code(cell, html_text, code)));
            format!("<tr>{}</tr>\n", cells.collect::<String>())
        };
        let rows = self
            .rows
            .iter()
            .map(|row| cells(&mut row.iter().map(String::as_str), "td"));
        format!(
            "<h2>{}</h2>\n<p>{}</p>\n<table>\n{}{}</table>\n",
            html_text(self.title.trim_end_matches(": ")),
            self.text,
            cells(&mut self.head.iter().copied(), "th"),
            rows.collect::<String>()
        )
    }
}
