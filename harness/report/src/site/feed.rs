//! `feed.xml`: what each new version of an engine fixed and broke, as an Atom feed. Basis: RFC 4287.

use super::history::{History, VersionStep};
use crate::text::percent_encoded;
use jiff::Timestamp;
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesText, Event};
use std::io;

/// The name of the feed in the folder of the site.
pub(super) const NAME: &str = "feed.xml";

/// The title of the feed.
pub(super) const TITLE: &str = "Stickler: what new versions fixed and broke";

/// Returns the feed, with the newest entry first. An entry keeps its id, which is made of engine and versions alone.
///
/// # Errors
/// Returns the error of writing XML.
pub(super) fn feed(histories: &[History<'_>]) -> io::Result<Vec<u8>> {
    let steps = History::newest_steps(histories);
    let runs = histories.iter().flat_map(|history| &history.runs);
    let updated = runs
        .map(|run| run.run.started)
        .max()
        .unwrap_or(Timestamp::UNIX_EPOCH);
    let mut xml = Writer::new(Vec::new());
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("utf-8"), None)))?;
    let root = xml
        .create_element("feed")
        .with_attribute(("xmlns", "http://www.w3.org/2005/Atom"));
    root.write_inner_content(|xml| {
        text(xml, "id", "urn:x-stickler:changes")?;
        text(xml, "title", TITLE)?;
        text(xml, "updated", &updated.to_string())?;
        xml.create_element("author")
            .write_inner_content(|xml| text(xml, "name", "Stickler"))?;
        link(xml, "self", NAME)?;
        link(xml, "alternate", "index.html")?;
        steps
            .iter()
            .try_for_each(|(history, step)| entry(xml, history, step))
    })?;
    Ok(xml.into_inner())
}

fn entry(xml: &mut Writer<Vec<u8>>, history: &History<'_>, step: &VersionStep<'_>) -> io::Result<()> {
    let [engine, old, new] = [history.name, step.old.version, step.new.version];
    let id = [engine, old, new].map(|text| percent_encoded(text, "")).join(":");
    xml.create_element("entry").write_inner_content(|xml| {
        text(xml, "id", &format!("urn:x-stickler:change:{id}"))?;
        text(xml, "title", &format!("{engine} {new}: {}", step.numbers()))?;
        text(xml, "updated", &step.new.run.started.to_string())?;
        link(xml, "alternate", &format!("engines/{}", history.file))?;
        let summary = format!("From {old} to {new}: {}.", step.numbers());
        text(xml, "summary", &summary)
    })?;
    Ok(())
}

fn link(xml: &mut Writer<Vec<u8>>, relation: &str, address: &str) -> io::Result<()> {
    let element = xml.create_element("link").with_attribute(("rel", relation));
    element.with_attribute(("href", address)).write_empty().map(drop)
}

/// Writes an element around a text, without the characters that XML cannot hold.
fn text(xml: &mut Writer<Vec<u8>>, name: &str, text: &str) -> io::Result<()> {
    let shown = crate::text::visible(text).replace(['\u{FFFE}', '\u{FFFF}'], "\u{FFFD}");
    let element = xml.create_element(name);
    element.write_text_content(BytesText::new(&shown)).map(drop)
}
