//! A probe: a template of programs, read once for all cells or rows.

use std::sync::Arc;

use stickler_types::{Code, DialectName, Question, UnknownQuestion};
use toml::Spanned;

use crate::condition::Condition;
use crate::error::Mistake;
use crate::frame::{self, ProbeFrame};
use crate::ident;
use crate::mark::{Known, MarkClaim};
use crate::mark_reader::MarkReader;
use crate::place::TextPlace;
use crate::places::Placement;
use crate::program::ProgramTemplate;
use crate::single;
use crate::table::keys::{KeyReader, ProbeKey, TableFile};
use crate::template::{BasisTemplate, Template};

/// A probe, ready to be expanded.
#[derive(Debug)]
pub(crate) struct Probe<'a> {
    pub(crate) name: Arc<str>,
    pub(crate) key: &'a ProbeKey,
    /// The line of the case file on which the probe's name stands.
    pub(crate) line: u32,
    pub(crate) program: ProgramTemplate,
    pub(crate) observe: Vec<Target>,
    pub(crate) only: Condition,
    /// The dialects to which the probe restricts its cases; all of them for `None`.
    pub(crate) dialects: Option<Vec<DialectName>>,
    pub(crate) title: Option<Template>,
    pub(crate) basis: Option<BasisTemplate>,
    pub(crate) expect: Option<Template>,
    /// The text of the question that the program asks.
    pub(crate) asks: Option<Template>,
    pub(crate) frame: ProbeFrame,
    /// Whether each mark, by index, applied in some case.
    pub(crate) applied: Vec<bool>,
    /// The places of which the program was put together, if it was.
    pub(crate) placement: Option<Arc<Placement>>,
}

/// A variable whose value is observed.
#[derive(Debug)]
pub(crate) struct Target {
    pub(crate) name: Template,
    /// The type that the probe gives the variable.
    pub(crate) ty: Option<Template>,
}

impl<'a> KeyReader<'a, '_> {
    /// Reads a probe whose program is written out.
    pub(super) fn written_out(
        &mut self,
        file: &TableFile,
        key: &'a ProbeKey,
        source: &Spanned<String>,
    ) -> Option<Probe<'a>> {
        let observe = key.observe.iter().flat_map(|observe| &observe.0);
        let observe = observe.filter_map(|target| self.target(target)).collect();
        let place = TextPlace::of_toml_string(self.context.text, &self.context.lines, source.span().start);
        let program = self.program(source.get_ref(), place, "probe.source")?;
        self.with_program(file, key, program, observe)
    }

    /// Reads the keys of a probe beside its program and what is observed.
    pub(super) fn with_program<'k>(
        &mut self,
        file: &TableFile,
        key: &'k ProbeKey,
        program: ProgramTemplate,
        observe: Vec<Target>,
    ) -> Option<Probe<'k>> {
        let lines = &self.context.lines;
        if let Err(message) = ident::check(key.name.get_ref()).and_then(|()| no_slash(key.name.get_ref())) {
            self.wrong(&key.name, "probe.name", message);
        }
        let scans = key.scans.as_ref().or(file.scans.as_ref());
        let frame = ProbeFrame {
            summary: key.summary.as_deref().or(file.summary.as_deref()).map(Arc::from),
            tags: single::tags(file.tags.iter().chain(&key.tags)),
            scans: frame::scans(scans, lines, &mut self.mistakes),
        };
        Some(Probe {
            name: key.name.get_ref().as_str().into(),
            key,
            line: lines.of(&key.name),
            applied: vec![false; program.marks.len()],
            program,
            observe,
            only: self.condition(key.only.as_ref(), "probe.only")?,
            dialects: self.dialects(key.dialects.as_ref(), "probe.dialects"),
            title: self.template(key.title.as_ref(), "probe.title"),
            basis: self.basis(key.basis.as_ref(), "probe.basis"),
            expect: self.template(key.expect.as_ref().or(file.expect.as_ref()), "expect"),
            asks: self.template(key.asks.as_ref().or(file.asks.as_ref()), "asks"),
            frame,
            placement: None,
        })
    }

    /// Reads the program of a probe, which stands at `place` of the file under a key.
    pub(super) fn program(&mut self, source: &str, place: TextPlace, key: &str) -> Option<ProgramTemplate> {
        let reader = MarkReader {
            dialects: self.context.dialects,
            testable: self.testable,
            is_template: true,
        };
        let program = ProgramTemplate::read(source, 0, place, &reader, &mut self.remarks);
        let keyed = |mistake: Mistake| mistake.key(key);
        program
            .map_err(|mistakes| self.mistakes.extend(mistakes.into_iter().map(keyed)))
            .ok()
    }

    /// Reads `name` or `name : TYPE`.
    fn target(&mut self, target: &Spanned<String>) -> Option<Target> {
        let (name, ty) = match target.get_ref().split_once(':') {
            Some((name, ty)) => (name.trim(), Some(ty.trim())),
            None => (target.get_ref().trim(), None),
        };
        Some(Target {
            name: self.text(target, name, "probe.observe")?,
            ty: ty.and_then(|ty| self.text(target, ty, "probe.observe")),
        })
    }
}

fn no_slash(name: &str) -> Result<(), String> {
    if name.contains('/') {
        Err("a probe's name has no `/`".to_owned())
    } else {
        Ok(())
    }
}

impl<'a> Probe<'a> {
    /// Returns a probe that has everything of this one but its program, which was put together of places.
    pub(super) fn placed(&self, program: ProgramTemplate, observe: Target, placement: Placement) -> Self {
        Probe {
            name: Arc::clone(&self.name),
            key: self.key,
            line: self.line,
            applied: vec![false; program.marks.len()],
            program,
            observe: vec![observe],
            only: self.only.clone(),
            dialects: self.dialects.clone(),
            title: self.title.clone(),
            basis: self.basis.clone(),
            expect: self.expect.clone(),
            // The program asks about a place as well.
            asks: None,
            frame: self.frame.clone(),
            placement: Some(Arc::new(placement)),
        }
    }

    /// Returns the dialects of `all` in which the probe has cases.
    pub(crate) fn narrowed(&self, all: &[DialectName]) -> Vec<DialectName> {
        let narrows = |dialect: &DialectName| self.dialects.as_ref().is_none_or(|own| own.contains(dialect));
        all.iter().copied().filter(narrows).collect()
    }

    /// Returns whether the probe is about implicit conversion alone, so that a word for a pair of types decides the whole
    /// expectation: a rejection means that the value does not convert to the type of its context, and otherwise the probe
    /// shows the converted value. The probe's own `values` apply only to the pairs of its matrix.
    ///
    /// Basis: rule: code-of-the-context.
    pub(crate) fn is_implicit_conversion(&self) -> bool {
        let is_code = |code: &Known<Code>| {
            let codes = ["P4022", "P4026", "P4027", "P4035"];
            matches!(code, Known::Now(code) if codes.contains(&code.as_str()))
        };
        let mut shows = !self.observe.is_empty();
        for mark in &self.program.marks {
            match &mark.claim {
                MarkClaim::Values { .. } => return false,
                MarkClaim::Error(codes) if !codes.iter().all(is_code) => return false,
                MarkClaim::Error(_) => shows = true,
                _ => {}
            }
        }
        shows
    }

    /// Returns the question of a program.
    ///
    /// # Errors
    /// A mistake on `line`, if the text of the probe is none with these texts.
    pub(crate) fn question(
        &self,
        scratch: &mut String,
        texts: &[&str],
        line: u32,
    ) -> Result<Option<Arc<Question>>, Mistake> {
        let Some(asks) = &self.asks else { return Ok(None) };
        let question = asks.fill(scratch, texts).parse();
        let wrong = |error: UnknownQuestion| Mistake::new(line, error.to_string()).key("asks");
        question.map(|question| Some(Arc::new(question))).map_err(wrong)
    }

    /// Records that the marks with these indices applied in a case.
    pub(crate) fn note_applied(&mut self, active: &[usize]) {
        for &index in active {
            self.applied[index] = true;
        }
    }

    /// Adds a warning for each mark that applied in no case.
    pub(super) fn note_idle_marks(&self, remarks: &mut Vec<Mistake>) {
        let marks = self.program.marks.iter().zip(&self.applied);
        for (mark, _) in marks.filter(|(_, applied)| !**applied) {
            let line = self.program.place.line(mark.line);
            remarks.push(Mistake::new(line, "the mark applies in no case").key("probe.source"));
        }
    }

    /// Returns whether any part of the probe uses a placeholder.
    pub(crate) fn mentions(&self, slot: usize) -> bool {
        let in_template = |template: &Template| template.slots().any(|used| used == slot);
        let basis = self.basis.as_ref().map(|basis| &basis.template);
        let templates = [
            self.title.as_ref(),
            basis,
            self.expect.as_ref(),
            self.asks.as_ref(),
        ];
        self.program.uses(slot)
            || templates.into_iter().flatten().any(in_template)
            || self
                .observe
                .iter()
                .any(|target| in_template(&target.name) || target.ty.as_ref().is_some_and(in_template))
            || self.only.slots().any(|used| used == slot)
            || self
                .program
                .marks
                .iter()
                .any(|mark| mark.condition.slots().any(|used| used == slot))
    }
}
