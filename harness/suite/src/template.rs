//! Texts with placeholders: `{row}`, and `{{` for a brace.

use std::sync::Arc;
use stickler_types::join;

use crate::citations::WrittenBasis;

/// A text with placeholders: the constant text, and the slots in it.
#[derive(Clone, Debug)]
pub(crate) struct Template {
    /// The text without its placeholders.
    standing: Arc<str>,
    /// The placeholders, in their order.
    slots: Arc<[Slot]>,
}

#[derive(Clone, Copy, Debug)]
struct Slot {
    index: usize,
    /// The byte offset in the text as it was read.
    offset: usize,
    /// The byte offset in the text without placeholders.
    at: usize,
}

/// A mistake in a template, with its byte offset.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct TemplateMistake {
    pub(crate) offset: usize,
    pub(crate) message: String,
}

/// A template with the line of the case file on which it is written.
#[derive(Clone, Debug)]
pub(crate) struct BasisTemplate {
    pub(crate) template: Template,
    pub(crate) line: u32,
}

impl BasisTemplate {
    /// Returns the basis that the template writes for one case.
    pub(crate) fn basis(&self, scratch: &mut String, texts: &[&str]) -> WrittenBasis {
        WrittenBasis {
            text: self.template.fill(scratch, texts),
            line: self.line,
        }
    }
}

impl Template {
    /// Returns the template of a text in which braces have no special meaning.
    pub(crate) fn plain(text: &str) -> Template {
        Template {
            standing: text.into(),
            slots: Arc::default(),
        }
    }

    /// Reads a text in which `{name}` stands for one of `names`.
    pub(crate) fn parse(text: &str, names: &[Box<str>]) -> Result<Template, TemplateMistake> {
        let mut slots = Vec::new();
        let mut standing = String::new();
        let mut at = 0;
        while let Some(found) = text[at..].find(['{', '}']) {
            let brace = at + found;
            standing.push_str(&text[at..brace]);
            let sign = &text[brace..=brace];
            if text[brace + 1..].starts_with(sign) {
                standing.push_str(sign);
                at = brace + 2;
                continue;
            }
            let (index, end) = slot(text, brace, names)?;
            slots.push(Slot {
                index,
                offset: brace,
                at: standing.len(),
            });
            at = end;
        }
        standing.push_str(&text[at..]);
        Ok(Template {
            standing: standing.into(),
            slots: slots.into(),
        })
    }

    /// Returns the text, if it has no placeholder.
    pub(crate) fn fixed(&self) -> Option<&Arc<str>> {
        Some(&self.standing).filter(|_| self.slots.is_empty())
    }

    /// Returns the indices of the placeholders, with repetitions.
    pub(crate) fn slots(&self) -> impl Iterator<Item = usize> {
        self.placed_slots().map(|(index, _)| index)
    }

    /// Returns the indices of the placeholders, each with its byte offset in the original text.
    pub(crate) fn placed_slots(&self) -> impl Iterator<Item = (usize, usize)> {
        self.slots.iter().map(|slot| (slot.index, slot.offset))
    }

    /// Appends the text, with each placeholder replaced by `values[index]`.
    pub(crate) fn fill_into(&self, out: &mut String, values: &[&str]) {
        let mut written = 0;
        for slot in &*self.slots {
            out.push_str(&self.standing[written..slot.at]);
            out.push_str(values[slot.index]);
            written = slot.at;
        }
        out.push_str(&self.standing[written..]);
    }

    /// Returns the text with each placeholder replaced by `values[index]`; `scratch` is a buffer that is reused.
    pub(crate) fn fill(&self, scratch: &mut String, values: &[&str]) -> Arc<str> {
        match self.fixed() {
            Some(fixed) => Arc::clone(fixed),
            None => {
                scratch.clear();
                self.fill_into(scratch, values);
                Arc::from(scratch.as_str())
            }
        }
    }
}

/// Reads the placeholder at `brace`; returns its index and the offset at which the text goes on.
fn slot(text: &str, brace: usize, names: &[Box<str>]) -> Result<(usize, usize), TemplateMistake> {
    let mistake = |message| {
        Err(TemplateMistake {
            offset: brace,
            message,
        })
    };
    if text.as_bytes()[brace] == b'}' {
        return mistake("`}` stands alone; a brace itself is written `}}`".to_owned());
    }
    let inside = &text[brace + 1..];
    let length = inside.find(|c: char| !c.is_ascii_alphanumeric() && !matches!(c, '_' | '-' | ' '));
    match length {
        Some(length) if inside[length..].starts_with('}') => {
            let name = &inside[..length];
            match names.iter().position(|known| **known == *name) {
                Some(index) => Ok((index, brace + 1 + length + 1)),
                None => {
                    let known = join(names.iter().map(|name| format!("`{{{name}}}`")), ", ");
                    mistake(format!("no placeholder `{{{name}}}`; there are {known}"))
                }
            }
        }
        _ => mistake("`{` opens no placeholder; a brace itself is written `{{`".to_owned()),
    }
}
