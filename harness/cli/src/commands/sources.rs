//! `stickler sources`: lists the sources of the claims, or holds the figures that they quote against saved copies of their pages.

use super::list::sources;
use crate::arguments::SourcesArguments;
use crate::case_folder::{self, CaseFolder};
use crate::exit::Exit;
use crate::output::{BAD, DIM, json_line};
use anyhow::bail;
use std::collections::BTreeSet;
use std::io::{self, Write};
use std::path::Path;
use stickler_suite::{CheckedQuote, QuoteResult};
use stickler_types::counted;

/// Lists sources, or checks what they quote.
///
/// # Errors
/// No folder of cases or of copies; no source of that name.
pub fn execute(arguments: &SourcesArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let suite = CaseFolder::locate(arguments.cases.as_deref())?.load_with([]);
    let names = &arguments.sources;
    if let Some(unknown) = names.iter().find(|name| suite.sources.get(name).is_none()) {
        bail!("there is no source `{unknown}`; `stickler sources` lists all");
    }
    let mut exit = case_folder::exit_of(&suite);
    let Some(folder) = &arguments.check else {
        let cases: Vec<_> = suite.cases.iter().collect();
        sources::write(out, &suite.sources, names, &cases, arguments.json)?;
        return Ok(exit);
    };
    if !folder.is_dir() {
        bail!("there is no folder {}", folder.display());
    }
    let mut quotes = suite.sources.check_quotes(folder);
    quotes.retain(|quote| names.is_empty() || names.iter().any(|name| name == quote.source));
    match arguments.json {
        true => quotes.iter().try_for_each(|quote| json_line(out, quote))?,
        false => write(&quotes, folder, out)?,
    }
    if quotes.is_empty() {
        exit = exit.max(Exit::NothingTested);
    }
    let exits = quotes.iter().map(|quote| match quote.result {
        QuoteResult::Found => Exit::AsExpected,
        QuoteResult::NotInPage => Exit::Failures,
        QuoteResult::NoPage => Exit::Usage,
    });
    Ok(exits.fold(exit, Exit::max))
}

fn write(quotes: &[CheckedQuote<'_>], folder: &Path, out: &mut dyn Write) -> io::Result<()> {
    let mut pages = BTreeSet::new();
    for CheckedQuote {
        source,
        section,
        quote,
        page,
        address,
        result,
    } in quotes
    {
        let is_first = pages.insert(page);
        let path = folder.join(page);
        let path = path.display();
        match result {
            QuoteResult::NotInPage => {
                writeln!(out, "{BAD}not in its page{BAD:#}  {source}: {section}: `{quote}`")?;
            }
            QuoteResult::NoPage if is_first => writeln!(out, "{BAD}no copy{BAD:#}  {path}.html")?,
            _ => continue,
        }
        writeln!(out, "    {DIM}{address}{DIM:#}")?;
    }
    let number = |is: fn(&QuoteResult) -> bool| quotes.iter().filter(|quote| is(&quote.result)).count();
    let found = number(|result| *result == QuoteResult::Found);
    let missing = number(|result| *result == QuoteResult::NotInPage);
    let figures = counted(quotes.len() as u64, "figure", "figures");
    let pages = counted(pages.len() as u64, "page", "pages");
    let rest = quotes.len() - found - missing;
    writeln!(
        out,
        "{figures} of {pages}: {found} found, {missing} not in their page, {rest} without a copy of their page"
    )
}
