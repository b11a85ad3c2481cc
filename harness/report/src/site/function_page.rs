//! The page of a conversion function: a row a value; a column for the documents, for each engine and for each recorded compiler.

use super::functions::{AnswerOrigin, FunctionColumn, Functions, file};
use super::html::{escaped, page as whole};
use crate::basis::Basis;
use std::fmt::Write;
use stickler_conversions::overview::{ComparedAnswer, FunctionCall, FunctionTable, StatedResult};
use stickler_types::counted;

/// The sources that a page cites, in the order in which they are first cited; a note is their number.
#[derive(Default)]
struct CitedSources<'s> {
    bases: Vec<&'s str>,
}

/// The cell of a call of which no source states the result.
const OPEN: &str = "<td class=\"number dim\">open</td>";

/// The cell of a call that no case of a run made, and no recording.
const NOT_ASKED: &str = "<td class=\"number dim\">·</td>";

/// A column of a table: its head, and a cell for each row.
struct CallColumn {
    origin: String,
    dialects: Vec<String>,
    cells: Vec<String>,
}

/// Returns the page of a function.
pub(super) fn page(name: &str, tables: &[FunctionTable<'_>], functions: &Functions<'_>) -> String {
    let mut notes = CitedSources::default();
    let mut sections = String::new();
    for table in tables {
        sections.push_str(&section(table, functions, &mut notes));
    }
    let body = format!(
        "<p><a href=\"index.html\">All conversion functions</a> · <a href=\"../index.html\">All engines</a></p>\n{}{sections}<h2>Sources</h2>\n\
         <ol class=\"notes\">\n{}</ol>\n<p class=\"dim\">✓: as the source of its case says. ✗: otherwise. ≠ behind a value: what a page of \
         the same vendor says, where something else was recorded. open: no source says what must come. ·: not asked.</p>\n",
        contents(tables),
        notes.list(functions)
    );
    whole(name, &body)
}

fn title(table: &FunctionTable<'_>) -> String {
    format!("{}({}) : {}", table.name, table.operands.join(", "), table.result)
}

fn anchor(table: &FunctionTable<'_>) -> String {
    escaped(&format!("{}-{}", table.operands.join("-"), table.result))
}

/// Returns links to the signatures of a function that has several.
fn contents(tables: &[FunctionTable<'_>]) -> String {
    if tables.len() < 2 {
        return String::new();
    }
    let link =
        |table: &FunctionTable<'_>| format!("<a href=\"#{}\">{}</a>", anchor(table), escaped(&title(table)));
    let links: Vec<String> = tables.iter().map(link).collect();
    format!("<p>{}</p>\n", links.join(" · "))
}

fn section<'s>(table: &FunctionTable<'s>, functions: &Functions<'_>, notes: &mut CitedSources<'s>) -> String {
    let columns: Vec<&FunctionColumn<'_>> = functions
        .columns
        .iter()
        .filter(|column| table.dialects.contains(&column.dialect.as_str()))
        .collect();
    let is_shown = |call: &&FunctionCall<'_>| {
        let has_contradiction = call
            .stated
            .iter()
            .flatten()
            .any(|stated| stated.otherwise.is_some());
        call.is_boundary || has_contradiction || columns.iter().any(|column| column.departs(call))
    };
    let shown: Vec<&FunctionCall<'s>> = table.calls.iter().filter(is_shown).collect();
    let stated = (0..table.dialects.len()).map(|dialect| documents(table, dialect, &shown, notes));
    let mut all: Vec<CallColumn> = stated.collect();
    all.extend(columns.into_iter().map(|column| answers(table, column, &shown)));
    let all = folded(all);
    let title = escaped(&title(table));
    let mut html = format!(
        "<h2 id=\"{}\">{title}</h2>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{title}\"><table class=\"values\">\n\
         <thead><tr><th scope=\"col\" class=\"number\">{}</th>{}</tr></thead>\n<tbody>\n",
        anchor(table),
        escaped(&table.operands.join(", ")),
        all.iter().map(head).collect::<String>()
    );
    for (row, call) in shown.iter().enumerate() {
        let operands: Vec<&str> = call.operands.iter().map(|operand| bare(operand)).collect();
        let cells: String = all.iter().map(|column| column.cells[row].as_str()).collect();
        // Writing to a String cannot fail.
        let _ = writeln!(
            html,
            "<tr><th scope=\"row\" class=\"number\">{}</th>{cells}</tr>",
            escaped(&operands.join(", "))
        );
    }
    html.push_str("</tbody>\n</table></div>\n");
    let rest = table.calls.len() - shown.len();
    if rest > 0 {
        let _ = writeln!(
            html,
            "<p class=\"dim\">{} of the suite's cases, on which all that was asked agrees with its source, {} not listed: \
             <code>stickler conversions {}</code> tells any.</p>",
            counted(rest as u64, "further value", "further values"),
            if rest == 1 { "is" } else { "are" },
            escaped(table.name)
        );
    }
    html
}

fn head(column: &CallColumn) -> String {
    // A variant is named by its dialect and an option of the compiler: `ironplc-ed2+partial-access`.
    let is_variant = |dialect: &&String| {
        let options = column
            .dialects
            .iter()
            .filter_map(|base| dialect.strip_prefix(base.as_str()));
        options
            .into_iter()
            .any(|option| option.starts_with('+') || option.starts_with("-without-"))
    };
    let variants = column.dialects.iter().filter(is_variant).count() as u64;
    let counted = (variants > 0).then(|| counted(variants, "variant", "variants"));
    let dialects: String = column
        .dialects
        .iter()
        .filter(|dialect| !is_variant(dialect))
        .cloned()
        .chain(counted)
        .map(|dialect| format!("<div class=\"dim\">{}</div>", escaped(&dialect)))
        .collect();
    format!(
        "<th scope=\"col\" class=\"number\">{}{dialects}</th>",
        column.origin
    )
}

/// Returns the column of what sources state in a dialect.
fn documents<'s>(
    table: &FunctionTable<'s>,
    dialect: usize,
    shown: &[&FunctionCall<'s>],
    notes: &mut CitedSources<'s>,
) -> CallColumn {
    let mut cell = |call: &&FunctionCall<'s>| match &call.stated[dialect] {
        None => OPEN.to_owned(),
        Some(stated) => format!("<td class=\"number\">{}</td>", stated_value(stated, notes)),
    };
    CallColumn {
        origin: "documents".to_owned(),
        dialects: vec![table.dialects[dialect].to_owned()],
        cells: shown.iter().map(&mut cell).collect(),
    }
}

fn stated_value<'s>(stated: &StatedResult<'s>, notes: &mut CitedSources<'s>) -> String {
    let mut html = format!("{} {}", escaped(bare(stated.value)), notes.mark(stated.basis));
    if let Some((value, basis)) = stated.otherwise {
        // Writing to a String cannot fail.
        let _ = write!(
            html,
            " <span class=\"tag differs\">≠ {}</span>{}",
            escaped(bare(value)),
            notes.mark(basis)
        );
    }
    html
}

/// Returns the column of an engine's answers; one that is as stated repeats the value.
fn answers(
    table: &FunctionTable<'_>,
    column: &FunctionColumn<'_>,
    shown: &[&FunctionCall<'_>],
) -> CallColumn {
    let dialect = table
        .dialects
        .iter()
        .position(|dialect| *dialect == column.dialect);
    let cell = |call: &&FunctionCall<'_>| {
        let stated = dialect.and_then(|dialect| call.stated[dialect].as_ref());
        match column.answers.get(&call.question) {
            None => NOT_ASKED.to_owned(),
            Some(ComparedAnswer::Met) => {
                let value = stated
                    .map(|stated| escaped(bare(stated.value)))
                    .unwrap_or_default();
                format!("<td class=\"number\">{value} <span class=\"tag pass\">✓</span></td>")
            }
            Some(ComparedAnswer::Open(answer)) => {
                format!("<td class=\"number\">{}</td>", escaped(bare(answer)))
            }
            Some(ComparedAnswer::Other(answer)) => {
                format!(
                    "<td class=\"number\"><span class=\"tag fail\">✗ {}</span></td>",
                    escaped(bare(answer))
                )
            }
        }
    };
    let named = escaped(&format!("{} {}", column.name, column.version));
    let origin = match column.origin {
        AnswerOrigin::Run(run) if run.page.is_some() => {
            format!(
                "<a href=\"../runs/{}#{}\">{named}</a>",
                run.page_name(),
                escaped(table.name)
            )
        }
        AnswerOrigin::Run(_) => named,
        AnswerOrigin::Recording(date) => {
            format!("{named}<div class=\"dim\">recorded {}</div>", escaped(date))
        }
    };
    CallColumn {
        origin,
        dialects: vec![column.dialect.clone()],
        cells: shown.iter().map(cell).collect(),
    }
}

/// Joins the columns of one origin with the same cells, and leaves out those in which no source speaks or nothing was asked.
fn folded(columns: Vec<CallColumn>) -> Vec<CallColumn> {
    let mut kept: Vec<CallColumn> = Vec::new();
    let is_silent = |cell: &String| cell == OPEN || cell == NOT_ASKED;
    let speaks = |column: &CallColumn| !column.cells.iter().all(is_silent);
    for column in columns.into_iter().filter(speaks) {
        let same = |one: &&mut CallColumn| one.origin == column.origin && one.cells == column.cells;
        match kept.iter_mut().find(same) {
            Some(one) => one.dialects.extend(column.dialects),
            None => kept.push(column),
        }
    }
    kept
}

/// Returns a typed literal without its type.
fn bare(literal: &str) -> &str {
    match literal.split_once('#') {
        Some((prefix, rest))
            if !rest.is_empty()
                && prefix
                    .bytes()
                    .all(|byte| byte.is_ascii_uppercase() || byte == b'_') =>
        {
            rest
        }
        _ => literal,
    }
}

impl<'s> CitedSources<'s> {
    /// Returns the mark of a source, which leads to its place in the list.
    fn mark(&mut self, basis: &'s str) -> String {
        let known = self.bases.iter().position(|other| *other == basis);
        let number = known.unwrap_or_else(|| {
            self.bases.push(basis);
            self.bases.len() - 1
        });
        let number = number + 1;
        format!(
            "<sup><a href=\"#source-{number}\" title=\"{}\">{number}</a></sup>",
            escaped(basis)
        )
    }

    /// Returns the items of the list, with the kind of each source and its address.
    fn list(&self, functions: &Functions<'_>) -> String {
        let item = |(index, basis): (usize, &&str)| {
            let Basis { source, section } = Basis::of(basis);
            let known = functions.sources.get(source);
            let address = known.map(|source| source.address_of(section)).unwrap_or_default();
            let named = match address.starts_with("https://") || address.starts_with("http://") {
                true => format!("<a href=\"{}\">{}</a>", escaped(&address), escaped(basis)),
                false => escaped(basis),
            };
            let kind = known.map(|source| {
                format!(
                    " <span class=\"dim\">({}: {})</span>",
                    escaped(&source.kind),
                    escaped(&source.title)
                )
            });
            format!(
                "<li id=\"source-{}\">{named}{}</li>\n",
                index + 1,
                kind.unwrap_or_default()
            )
        };
        self.bases.iter().enumerate().map(item).collect()
    }
}

/// Returns the list of all functions.
pub(super) fn index(functions: &Functions<'_>) -> String {
    let engines: Vec<&str> = {
        let mut names: Vec<&str> = Vec::new();
        for column in functions.columns.iter().filter(|column| column.is_of_run()) {
            if !names.contains(&column.name) {
                names.push(column.name);
            }
        }
        names
    };
    let heads: String = engines
        .iter()
        .map(|engine| format!("<th scope=\"col\" class=\"number\">{}</th>", escaped(engine)))
        .collect();
    let departures: Vec<_> = engines
        .iter()
        .map(|engine| functions.departures(engine))
        .collect();
    let row = |(name, tables): (&&str, &Vec<FunctionTable<'_>>)| {
        let departing = departures.iter().map(|of_engine| {
            let number = of_engine
                .iter()
                .find(|(other, _)| other == name)
                .map_or(0, |(_, number)| *number);
            match number {
                0 => "<td class=\"number dim\">–</td>".to_owned(),
                _ => format!("<td class=\"number\"><span class=\"tag fail\">✗ {number}</span></td>"),
            }
        });
        let disagreeing = tables
            .iter()
            .flat_map(|table| &table.calls)
            .filter(|call| stated_differently(call))
            .count();
        let values: usize = tables.iter().map(|table| table.calls.len()).sum();
        format!(
            "<tr><th scope=\"row\"><a href=\"{}\">{}</a></th><td class=\"number\">{values}</td><td class=\"number\">{disagreeing}</td>{}</tr>\n",
            file(name),
            escaped(name),
            departing.collect::<String>()
        )
    };
    let rows: String = functions.tables.iter().map(row).collect();
    let body = format!(
        "<p><a href=\"../index.html\">All engines</a></p>\n<p>What each function gives for boundary values and for the values of the suite's cases: by \
         the documents of each dialect, on the newest run of each engine, and on recorded compilers. <em>Differ</em> counts the values for \
         which the documents of two dialects state different results; below an engine stand those for which it gives something else than \
         the source of its dialect.</p>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Conversion functions\"><table>\n<thead><tr>\
         <th scope=\"col\">Function</th><th scope=\"col\" class=\"number\">Values</th><th scope=\"col\" class=\"number\">Differ</th>{heads}</tr></thead>\n\
         <tbody>\n{rows}</tbody>\n</table></div>\n"
    );
    whole("Conversion functions", &body)
}

/// Returns whether sources state different results of a call.
fn stated_differently(call: &FunctionCall<'_>) -> bool {
    let mut values = call.stated.iter().flatten().map(|stated| stated.value);
    let first = values.next();
    values.any(|value| Some(value) != first)
}
