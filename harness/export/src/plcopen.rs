//! Writes the pages of an export as one project in PLCopen's XML format, which editors import at once.
//!
//! Basis: PLCopen TC6, XML formats for IEC 61131-3, version 2.01 (`http://www.plcopen.org/xml/tc6_0201`).
//!
//! The units of a page are read with the parser of the reference; declarations become elements of the format, and statements stay
//! the text that they are.

mod declarations;
mod xml;

use crate::ExportError;
use crate::encode::filled;
use crate::page::PageText;
use quick_xml::Writer;
use quick_xml::escape::escape;
use std::io;
use std::path::PathBuf;
use stickler_syntax::parse;
use stickler_syntax::source::{LineIndex, Span};
use stickler_syntax::tree::{Declaration, Pou, PouKind, SourceUnit, TypeDeclaration};
use stickler_types::{Dialect, DialectName};
use xml::{TextElement, Xml, attribute, fits, formatted, nested};

/// The choice of a project file beside the pages of an export.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ProjectPlan {
    /// The file to write.
    pub file: PathBuf,
    /// The date and time for the head of the project, as XML Schema writes them: `2026-11-23T20:00:00Z`.
    pub created: String,
}

/// A project that is filled page by page.
pub(crate) struct Project {
    dialect: &'static Dialect,
    text_element: TextElement,
    data_types: Xml,
    pous: Xml,
    /// The names of the programs that run.
    programs: Vec<String>,
}

impl Project {
    pub(crate) fn new(dialect: DialectName) -> Project {
        Project {
            dialect: Dialect::of(dialect),
            // matiec is the compiler of Beremiz.
            text_element: match dialect.base() {
                DialectName::MATIEC => TextElement::Paragraph,
                _ => TextElement::Xhtml,
            },
            data_types: Writer::new_with_indent(Vec::new(), b' ', 1),
            pous: Writer::new_with_indent(Vec::new(), b' ', 1),
            programs: Vec::new(),
        }
    }

    /// Adds a page. One that is only compiled is wrong on purpose, would keep the whole project from running, and is left out.
    ///
    /// # Errors
    /// [`ExportError::Character`] and [`ExportError::Syntax`] with the place in `file`, the file of the page.
    pub(crate) fn add(&mut self, page: &PageText<'_, '_>, file: &str) -> Result<(), ExportError> {
        if page.kind.is_compiled() {
            return Ok(());
        }
        let text = page.text();
        let lines = LineIndex::new(&text);
        let place = |byte: usize| {
            let byte = u32::try_from(byte).unwrap_or(u32::MAX);
            let line = lines.line(byte) as usize;
            let case = page
                .case_at(line)
                .map_or(String::new(), |id| format!(" (in {id})"));
            format!("{file}:{line}{case}")
        };
        if let Some((at, character)) = text.char_indices().find(|(_, character)| !fits(*character)) {
            return Err(ExportError::Character(place(at), character));
        }
        let (unit, diagnostics) = parse(&text, self.dialect);
        if let Some(first) = diagnostics.first() {
            return Err(ExportError::Syntax(
                place(first.span.start as usize),
                first.message.clone(),
            ));
        }
        let source = PageSource {
            text: &text,
            unit: &unit,
            text_element: self.text_element,
        };
        self.add_units(&source)
            .map_err(|error| ExportError::Write(PathBuf::from(file), error))
    }

    fn add_units(&mut self, source: &PageSource<'_>) -> io::Result<()> {
        let mut before = 0;
        for declaration in &source.unit.declarations {
            match declaration {
                Declaration::Pou(pou) => {
                    source.write_pou(&mut self.pous, pou, before)?;
                    before = pou.span.end;
                    if pou.kind == PouKind::Program {
                        self.programs.push(pou.name.text.to_owned());
                    }
                }
                Declaration::Types(types) => {
                    for declared in types {
                        source.write_data_type(&mut self.data_types, declared)?;
                    }
                }
                // No case with one of these is on a page.
                Declaration::Globals(_) | Declaration::Configuration(_) => {}
                Declaration::Namespace(_) | Declaration::EndNamespace(_) | Declaration::Using(_) => {}
            }
        }
        Ok(())
    }

    /// Writes the project to the file of a plan. `name` describes the export.
    ///
    /// # Errors
    /// [`ExportError::Write`].
    pub(crate) fn write(self, plan: &ProjectPlan, name: &str) -> Result<(), ExportError> {
        let run = |program: &String| {
            format!("\n      <pouInstance name=\"run_{program}\" typeName=\"{program}\"/>")
        };
        let inside = |xml: Xml| String::from_utf8_lossy(&xml.into_inner()).into_owned();
        let text = filled(
            include_str!("plcopen/project.xml"),
            &[
                ("version", &env!("CARGO_PKG_VERSION")),
                ("created", &escape(&plan.created)),
                ("name", &escape(name)),
                ("instances", &self.programs.iter().map(run).collect::<String>()),
                ("data_types", &inside(self.data_types)),
                ("pous", &inside(self.pous)),
            ],
        );
        std::fs::write(&plan.file, text).map_err(|error| ExportError::Write(plan.file.clone(), error))
    }
}

/// The text of a page and its tree.
struct PageSource<'p> {
    text: &'p str,
    unit: &'p SourceUnit<'p>,
    text_element: TextElement,
}

impl PageSource<'_> {
    /// Writes a program organization unit; the comment between the byte `before` and its first keyword documents it.
    fn write_pou(&self, xml: &mut Xml, pou: &Pou<'_>, before: u32) -> io::Result<()> {
        let kind = match pou.kind {
            PouKind::Program => "program",
            PouKind::Function => "function",
            _ => "functionBlock",
        };
        let attributes = [attribute("name", pou.name.text), attribute("pouType", kind)];
        nested(xml, "pou", attributes, |xml| {
            self.write_interface(xml, pou)?;
            nested(xml, "body", [], |xml| {
                formatted(xml, "ST", self.text_element, self.statements(pou))
            })?;
            let comment = self.between(before, pou.span.start).trim();
            let comment = comment
                .strip_prefix("(*")
                .and_then(|text| text.strip_suffix("*)"));
            comment.map_or(Ok(()), |comment| {
                formatted(xml, "documentation", self.text_element, comment.trim())
            })
        })
    }

    fn write_interface(&self, xml: &mut Xml, pou: &Pou<'_>) -> io::Result<()> {
        nested(xml, "interface", [], |xml| {
            if let Some(result) = &pou.result {
                self.write_type(xml, "returnType", result)?;
            }
            pou.blocks
                .iter()
                .try_for_each(|block| self.write_block(xml, block))
        })
    }

    /// Returns the statements of a unit, so that the first line is the first after its declarations, as in an editor's pane.
    fn statements(&self, pou: &Pou<'_>) -> &str {
        let result = pou.result.as_ref().map(|result| result.span);
        let last = pou.blocks.last().map(|block| block.span);
        let begins = last.or(result).unwrap_or(pou.name.span).end;
        let text = self.between(begins, pou.end.start);
        text.strip_prefix('\n').unwrap_or(text)
    }

    fn between(&self, start: u32, end: u32) -> &str {
        Span { start, end }.text(self.text)
    }

    fn write_data_type(&self, xml: &mut Xml, declared: &TypeDeclaration<'_>) -> io::Result<()> {
        nested(xml, "dataType", [attribute("name", declared.name.text)], |xml| {
            self.write_type(xml, "baseType", &declared.specification)?;
            self.write_initial_value(xml, declared.initializer.as_ref())
        })
    }
}
