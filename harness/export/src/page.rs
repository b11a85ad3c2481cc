//! Writes a page: one program that executes the programs of many cases, one in each scan, and stores their results in an array.
//!
//! ```text
//! results[0]   16#53544B31, by which an array of results is known
//! results[1]   the number of this page of this export; no other page of any export has it
//! results[2]   the page's number in its export
//! results[3]   how many observations there are
//! results[4]   the last one that was begun
//! results[5]   the last one that was ended
//! results[6]   how many values are those that documents say
//! results[7]   how many are not
//! results[8]   the first observation: the number of the page plus that of the observation; 0 before it was made
//! results[9]   1: the value equals the one that it must be; 2: it does not; 0: nothing was compared
//! results[10]  … and, where the type can be taken apart, its numbers
//! results[n]   the number of the page again, once all is done
//! ```
//!
//! Whoever deletes the statements of a case, because the compiler does not take them, leaves its elements 0: it was not run,
//! and nothing else is different.

use crate::encode::{self, filled};
use crate::encoding::pieces;
use crate::manifest::StepRecord;
use crate::page_case::{PageCase, PageKind, expected};
use std::collections::{BTreeMap, BTreeSet};
use stickler_syntax::{Renaming, words};
use stickler_types::{Dialect, ElementaryType, Fnv1a, Value, counted};

/// The first element of every array of results: `STK1` in ASCII.
pub(crate) const MAGIC: i32 = 0x5354_4B31;

/// The index of the first observation's first element.
pub(crate) const FIRST_OBSERVATION: usize = 8;

/// The factor of all page identities, so that the number of an observation can be added to an identity and separated again.
pub(crate) const PAGE_NUMBER_STEP: usize = 1000;

/// The text of a page, and the places of its cases in it.
pub(crate) struct PageText<'c, 'r> {
    /// The number of the page, from 1.
    pub(crate) number: usize,
    pub(crate) kind: PageKind,
    pub(crate) cases: &'r [PageCase<'c>],
    /// The observations of the page, in order; the first has the number 1. Empty for a page that is only compiled.
    pub(crate) steps: Vec<StepRecord>,
    /// The identity of the page, a multiple of [`PAGE_NUMBER_STEP`].
    pub(crate) identity: i32,
    /// The number of elements of the page's array; 0 where it has no array.
    pub(crate) elements: usize,
    /// The POUs and types beside the program.
    pub(crate) units: String,
    /// The program up to the end of its declarations.
    pub(crate) declarations: String,
    /// The statements of the program.
    pub(crate) statements: String,
    /// The ranges of lines of each case, from 1, through declarations and statements. For a page that is only compiled, the last
    /// two entries are no cases: its first statement and its last, which are wrong on purpose.
    pub(crate) lines: Vec<Vec<(usize, usize)>>,
}

/// Returns the number of elements that the observations of a case take.
pub(crate) fn elements_of(ready: &PageCase<'_>) -> usize {
    let observed = ready.observed.iter();
    let elements = observed.map(|(_, encoded)| 2 + encoded.map_or(0, pieces));
    elements.sum::<usize>().max(2)
}

impl<'c, 'r> PageText<'c, 'r> {
    /// Writes a page of cases. `export` is a line that names the export; `taken` contains the identities of other pages, to which
    /// the page adds its own.
    pub(crate) fn write(
        (number, pages): (usize, usize),
        cases: &'r [PageCase<'c>],
        export: &str,
        taken: &mut BTreeSet<i32>,
    ) -> PageText<'c, 'r> {
        let kind = cases[0].kind;
        let (steps, end) = steps(cases);
        let mut page = PageText {
            number,
            kind,
            cases,
            elements: end + 1,
            steps,
            identity: 0,
            units: String::new(),
            declarations: String::new(),
            statements: String::new(),
            lines: vec![Vec::new(); cases.len()],
        };
        if kind.is_compiled() {
            page.write_compiled(pages, export);
            return page;
        }
        let suffixes = page.write_units();
        // The identity of a page comes from its text, so the text is written once without it.
        for _ in 0..2 {
            page.declarations = page.head(pages, export);
            page.statements.clear();
            page.lines = vec![Vec::new(); cases.len()];
            page.write_declarations(&suffixes);
            page.write_statements(&suffixes);
            page.identity = match page.identity {
                0 => identity(&[&page.units, &page.declarations, &page.statements], taken),
                known => known,
            };
        }
        page
    }

    /// Returns the whole text of the page.
    pub(crate) fn text(&self) -> String {
        let units = if self.units.is_empty() {
            String::new()
        } else {
            format!("{}\n\n", self.units)
        };
        format!("{units}{}{}END_PROGRAM\n", self.declarations, self.statements)
    }

    /// Returns the number of lines of POUs and types before the program.
    pub(crate) fn lines_of_units(&self) -> usize {
        if self.units.is_empty() {
            0
        } else {
            self.units.matches('\n').count() + 2
        }
    }

    /// Returns the id of the case to which a line of the whole text belongs.
    pub(crate) fn case_at(&self, line: usize) -> Option<&str> {
        let line = line.checked_sub(self.lines_of_units())?;
        let holds = |ranges: &Vec<(usize, usize)>| {
            ranges
                .iter()
                .any(|(first, last)| (*first..=*last).contains(&line))
        };
        let case = self.lines.iter().position(holds)?;
        Some(&*self.cases.get(case)?.case.id)
    }

    fn head(&self, pages: usize, export: &str) -> String {
        filled(
            include_str!("page/head.st"),
            &[
                ("number", &self.number),
                ("pages", &pages),
                ("cases", &counted(self.cases.len() as u64, "case", "cases")),
                ("export", &export),
                ("steps", &self.steps.len()),
                ("last", &(self.elements - 1)),
            ],
        )
    }

    /// Writes the POUs and types of all cases, each once, and returns the suffix of the names of each case.
    fn write_units(&mut self) -> Vec<String> {
        let mut known: BTreeMap<String, usize> = BTreeMap::new();
        let mut suffixes = Vec::with_capacity(self.cases.len());
        for (number, ready) in self.cases.iter().enumerate() {
            if ready.answered {
                suffixes.push(String::new());
                continue;
            }
            let parts = &ready.parts;
            let mut key = parts.units.clone();
            if declares_in_place(ready) {
                key += &format!("\n{number}");
            }
            let next = known.len() + 1;
            let unit = *known.entry(key).or_insert(next);
            // Names differ from page to page, so that several pages fit into one project of an editor.
            let suffix = format!("_p{}u{unit}", self.number);
            if unit == next && !parts.units.is_empty() {
                let renaming = Renaming {
                    dialect: Dialect::of(ready.case.dialect),
                    units: (&parts.unit_names, suffix.clone()),
                    variables: None,
                };
                if !self.units.is_empty() {
                    self.units.push_str("\n\n");
                }
                self.units.push_str(&renaming.of(&parts.units));
            }
            suffixes.push(suffix);
        }
        suffixes
    }

    pub(crate) fn renaming(&self, case: usize, suffixes: &[String]) -> Renaming<'r> {
        let PageCase { case: of, parts, .. } = &self.cases[case];
        Renaming {
            dialect: Dialect::of(of.dialect),
            units: (&parts.unit_names, suffixes[case].clone()),
            variables: Some((&parts.variable_names, format!("_{}", case + 1))),
        }
    }

    fn write_declarations(&mut self, suffixes: &[String]) {
        let mut text = std::mem::take(&mut self.declarations);
        for ty in self.types() {
            text += &format!("    {}\n", encode::declarations(ty));
        }
        text.push_str("END_VAR\n");
        self.write_variables(&mut text, suffixes);
        self.declarations = text;
    }

    /// Writes the variables of all cases: constants first, for they may be initial values of variables.
    pub(crate) fn write_variables(&mut self, text: &mut String, suffixes: &[String]) {
        for constant in [true, false] {
            let mut section = String::new();
            let heading = if constant { "VAR CONSTANT\n" } else { "VAR\n" };
            let line = text.matches('\n').count() + 2;
            for (case, ready) in self.cases.iter().enumerate().filter(|(_, ready)| !ready.answered) {
                let renaming = self.renaming(case, suffixes);
                let parts = ready.parts.variables.iter();
                let mut parts = parts
                    .filter(|part| part.constant == constant && !part.text.trim().is_empty())
                    .peekable();
                if parts.peek().is_none() {
                    continue;
                }
                let before = section.matches('\n').count();
                section += &format!("    (* {}: {} *)\n", case + 1, shown(&ready.case.id));
                for part in parts {
                    section += &format!("{}\n", renaming.of(&part.text));
                }
                let after = section.matches('\n').count();
                self.lines[case].push((line + before, line + after - 1));
            }
            if !section.is_empty() {
                text.push_str(heading);
                text.push_str(&section);
                text.push_str("END_VAR\n");
            }
        }
    }

    fn write_statements(&mut self, suffixes: &[String]) {
        let steps = self.steps.len();
        if steps == 0 {
            self.statements = "    results[0] := 0;\n".to_owned();
            return;
        }
        let declarations = self.declarations.matches('\n').count();
        let mut text = filled(
            include_str!("page/observations.st"),
            &[
                ("steps", &steps),
                ("magic", &MAGIC),
                ("identity", &self.identity),
                ("number", &self.number),
            ],
        );
        let kinds = self.types();
        for (number, step) in self.steps.iter().enumerate() {
            let first = declarations + text.matches('\n').count() + 1;
            let renaming = self.renaming(step.case, suffixes);
            let ready = &self.cases[step.case];
            let is_first = number == 0 || self.steps[number - 1].case != step.case;
            if is_first {
                text += &format!("        (* {}: {} *)\n", step.case + 1, shown(&ready.case.id));
            }
            text += &format!("        {}:\n", number + 1);
            if is_first && !ready.parts.statements.is_empty() {
                text += &format!("    {}\n", renaming.of(&ready.parts.statements));
            }
            write_readout(&mut text, ready, step, &renaming, &kinds);
            self.lines[step.case].push((first, declarations + text.matches('\n').count()));
        }
        let kind = |(number, ty): (usize, &ElementaryType)| {
            let statements = encode::statements(*ty, "            ");
            format!("        {}: (* {ty} *)\n{statements}", number + 1)
        };
        text.push_str(&filled(
            include_str!("page/common.st"),
            &[
                ("steps", &steps),
                ("last", &(self.elements - 1)),
                ("identity", &self.identity),
                ("kinds", &kinds.iter().enumerate().map(kind).collect::<String>()),
            ],
        ));
        self.statements = text;
    }

    /// Returns the types whose values are taken apart, in their order.
    fn types(&self) -> Vec<ElementaryType> {
        let steps = self.steps.iter();
        let types = steps.filter_map(|step| step.encoded(&self.cases[step.case]));
        types.collect::<BTreeSet<_>>().into_iter().collect()
    }
}

/// Returns the observations of the cases, and the index of the element after the last of them.
fn steps(cases: &[PageCase<'_>]) -> (Vec<StepRecord>, usize) {
    let mut steps = Vec::new();
    let mut place = FIRST_OBSERVATION;
    for (case, ready) in cases.iter().enumerate().filter(|(_, ready)| !ready.answered) {
        let mut add = |observe, encoded: Option<ElementaryType>| {
            steps.push(StepRecord { case, observe, place });
            place += 2 + encoded.map_or(0, pieces);
        };
        if ready.observed.is_empty() {
            add(None, None);
        }
        for &(observe, encoded) in &ready.observed {
            add(Some(observe), encoded);
        }
    }
    (steps, place)
}

/// Writes the statements that store one variable in the array.
fn write_readout(
    text: &mut String,
    ready: &PageCase<'_>,
    step: &StepRecord,
    renaming: &Renaming<'_>,
    kinds: &[ElementaryType],
) {
    const MARGIN: &str = "            ";
    if let Some(observe) = step.observe {
        let name = renaming.of(&ready.case.observe[observe].name);
        if let Some(literal) = expected(ready.case, observe).and_then(|expected| literal(&expected.value)) {
            let literal = renaming.of(&literal);
            *text += &format!(
                "{MARGIN}IF {name} = {literal} THEN stickler_equal := 1; ELSE stickler_equal := 2; END_IF;\n"
            );
        }
        if let Some(ty) = step.encoded(ready) {
            let kind = kinds
                .iter()
                .position(|kind| *kind == ty)
                .map_or(0, |kind| kind + 1);
            *text += &format!("{MARGIN}{} := {name};\n", encode::variable(ty));
            *text += &format!("{MARGIN}stickler_kind := {kind};\n");
        }
    }
    *text += &format!("{MARGIN}stickler_place := {};\n", step.place);
}

/// Returns the literal of a value for a comparison; `None` where it has no literal.
pub(crate) fn literal(value: &Value) -> Option<String> {
    let typed = value.to_string();
    match value {
        Value::Plain { ty, .. } if ty.is_real() => {
            let finite = !typed.ends_with("NaN") && !typed.ends_with("Infinity");
            finite.then_some(typed)
        }
        Value::Plain { .. } => Some(typed),
        // Few compilers know typed literals of texts; the value of an enumeration is known by its name.
        Value::Near { .. } => None,
        Value::Text { .. } | Value::Enumerated { .. } | Value::OutOfRange { .. } => {
            Some(value.without_type())
        }
    }
}

/// Returns whether variables of a case's program declare an enumeration in place.
fn declares_in_place(ready: &PageCase<'_>) -> bool {
    let words: BTreeSet<String> = words(&ready.parts.units, Dialect::of(ready.case.dialect))
        .map(|word| word.text.to_ascii_uppercase())
        .collect();
    ready.parts.unit_names.iter().any(|name| !words.contains(name))
}

/// Returns an id for use within a comment, which it must neither end nor nest.
pub(crate) fn shown(id: &str) -> String {
    id.replace("(*", "( *").replace("*)", "* )")
}

/// Returns an identity for a page by the FNV-1a hash of its text: a multiple of [`PAGE_NUMBER_STEP`], not 0, and not taken.
fn identity(texts: &[&str], taken: &mut BTreeSet<i32>) -> i32 {
    let mut hash = Fnv1a::default();
    texts.iter().for_each(|text| hash.write(text));
    let mut hash = hash.finish();
    let room = PAGE_NUMBER_STEP as u64;
    let numbers = u64::from(i32::MAX.unsigned_abs()) / room - 1;
    loop {
        let identity = i32::try_from((hash % numbers + 1) * room).unwrap_or(i32::MAX);
        if taken.insert(identity) {
            return identity;
        }
        hash = hash.wrapping_add(1);
    }
}
