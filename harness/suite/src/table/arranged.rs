//! Probes whose programs are put together of places: the key `places`.
//!
//! Basis: conformance-cases/README.md (places).

use std::collections::BTreeMap;

use stickler_types::{DialectName, sorted};
use toml::Spanned;

use crate::condition::Testable;
use crate::frame::{FileContext, Harvest};
use crate::place::TextPlace;
use crate::places::{Arrangement, Design, Places, Role, Wording, compose};
use crate::program::ProgramTemplate;
use crate::table::keys::{KeyReader, PlacesKey, ProbeKey, TableFile};
use crate::table::probe::{Probe, Target};
use crate::template::Template;

const KEY: &str = "probe.places";

/// The probes of the single combinations of places, and the design that chooses among them.
#[derive(Debug)]
pub(crate) struct Arranged<'a> {
    design: Design,
    /// The types of the source and of the target.
    from: Template,
    to: Template,
    /// The number of combinations that a cell or a row takes; `None` for all of its sources and targets.
    combinations: Option<usize>,
    composer: Composer<'a>,
    /// The probe of each arrangement of the design, as soon as a cell or a row takes it. Most are never taken.
    probes: Vec<Option<Probe<'a>>>,
}

impl<'a> Arranged<'a> {
    /// Returns the combinations that a cell or a row takes in these dialects: indices of the probes, each with its dialects.
    /// `number` tells the cell from others.
    pub(crate) fn chosen(
        &self,
        places: &Places,
        number: usize,
        dialects: &[DialectName],
        texts: &[&str],
    ) -> BTreeMap<usize, Vec<DialectName>> {
        let mut scratch = String::new();
        let from = self.from.fill(&mut scratch, texts);
        let to = self.to.fill(&mut scratch, texts);
        let mut chosen: BTreeMap<usize, Vec<DialectName>> = BTreeMap::new();
        for &dialect in dialects {
            let types: (&str, &str) = (&from, &to);
            let taken = match self.combinations {
                Some(combinations) => self
                    .design
                    .share_of_row(places, number, combinations, dialect, types),
                None => self.design.of_cell(places, number, dialect, types),
            };
            for index in taken {
                chosen.entry(index).or_default().push(dialect);
            }
        }
        chosen
    }

    /// Returns the probe of a combination, or nothing if its program has a mistake, which is reported once. All else is as in `like`.
    pub(crate) fn probe(
        &mut self,
        like: &Probe<'a>,
        index: usize,
        context: &FileContext<'_>,
        harvest: &mut Harvest,
    ) -> Option<&mut Probe<'a>> {
        let slot = &mut self.probes[index];
        if slot.is_none() {
            let mut reader = KeyReader::new(context, self.composer.testable);
            let arrangement = &self.design.arrangements()[index];
            let composed = self.composer.compose(&mut reader, arrangement);
            let placement = context.places.placement(arrangement);
            *slot = composed.map(|(program, observe)| like.placed(program, observe, placement));
            harvest.remarks.append(&mut reader.remarks);
            // The mistakes of different combinations are mostly the same one.
            reader
                .mistakes
                .retain(|mistake| !harvest.mistakes.contains(mistake));
            harvest.mistakes.append(&mut reader.mistakes);
        }
        slot.as_mut()
    }

    /// Returns whether the probes have marks none of which applied in any case.
    pub(crate) fn is_idle(&self) -> bool {
        let probes = self.probes.iter().flatten();
        let mut applied = probes.flat_map(|probe| &probe.applied);
        applied.clone().next().is_some() && !applied.any(|&applied| applied)
    }

    /// Returns whether any part of a probe uses a placeholder.
    pub(crate) fn mentions(&self, slot: usize) -> bool {
        let types = [&self.from, &self.to];
        types
            .into_iter()
            .flat_map(Template::slots)
            .any(|used| used == slot)
            || self.probes.iter().flatten().any(|probe| probe.mentions(slot))
    }
}

/// Reads a probe with `places`. The probe that is returned beside the design has the program of its first combination.
pub(super) fn read<'k>(
    reader: &mut KeyReader<'k, '_>,
    file: &'k TableFile,
    key: &'k ProbeKey,
    places: &'k Spanned<PlacesKey>,
) -> Option<(Probe<'k>, Arranged<'k>)> {
    if let Some(target) = key.observe.iter().flat_map(|observe| &observe.0).next() {
        let message = "`observe` belongs to a probe with `source`; a target says where its value is";
        reader.wrong(target, "probe.observe", message);
    }
    let design = design(reader, places)?;
    let composer = Composer {
        is_matrix: file.matrix.is_some(),
        places,
        testable: reader.testable,
        wording: wording(places.get_ref(), file.matrix.is_some()),
    };
    let (program, observe) = composer.compose(reader, design.arrangements().first()?)?;
    let probe = reader.with_program(file, key, program, vec![observe])?;
    let arranged = Arranged {
        from: reader.text(places, composer.wording.from, KEY)?,
        to: reader.text(places, composer.wording.to, KEY)?,
        combinations: places.get_ref().combinations,
        probes: design.arrangements().iter().map(|_| None).collect(),
        composer,
        design,
    };
    Some((probe, arranged))
}

/// Returns the design of the places that a probe names; all of a role where it names none.
fn design(reader: &mut KeyReader<'_, '_>, key: &Spanned<PlacesKey>) -> Option<Design> {
    let places = reader.context.places;
    let named = [
        (Role::Source, &key.get_ref().sources),
        (Role::Target, &key.get_ref().targets),
        (Role::Surrounding, &key.get_ref().surroundings),
    ];
    let [sources, mut targets, surroundings] = named.map(|(role, names)| {
        let Some(names) = names else {
            return places.unnamed(role);
        };
        let mut indices = Vec::new();
        for name in names {
            match places.find(role, name.get_ref()) {
                Ok(found) => indices.extend(found),
                Err(message) => reader.wrong(name, KEY, message),
            }
        }
        sorted(indices)
    });
    if key.get_ref().expression.is_some() {
        places.retain_statements(&mut targets);
    }
    let dialects = reader.context.dialects.all();
    let kind = (key.get_ref().error.is_some(), key.get_ref().expression.is_some());
    let design = Design::new(places, sources, targets, &surroundings, &dialects, kind);
    if design.arrangements().is_empty() && reader.mistakes.is_empty() {
        let message = "no source and no target of these can stand together in a surrounding";
        reader.wrong(key, KEY, message);
    }
    Some(design).filter(|_| reader.mistakes.is_empty())
}

/// Returns the words of a table: those that the probe says, or the usual ones of its kind of table.
fn wording(key: &PlacesKey, is_matrix: bool) -> Wording<'_> {
    let [from, to] = match is_matrix {
        true => ["{row}", "{column}"],
        false => ["{from}", "{to}"],
    };
    let value = key.value.as_deref().unwrap_or("{value}");
    Wording {
        from: key.from.as_deref().unwrap_or(from),
        to: key.to.as_deref().unwrap_or(to),
        value,
        typed: key.typed.as_deref().unwrap_or("{typed}"),
        arriving: match is_matrix || key.error.is_some() {
            true => value,
            false => "{arriving}",
        },
        beside: match !is_matrix && key.error.is_some() {
            true => [value; 2],
            false => ["{below}", "{above}"],
        },
        expression: key.expression.as_deref().unwrap_or("{source}"),
        variable: key.variable.as_deref().unwrap_or("{target}"),
        declarations: key.declarations.as_deref().unwrap_or_default(),
        before: key.before.as_deref().unwrap_or_default(),
        error: key.error.as_deref(),
        code: key.code.as_deref(),
    }
}

/// Makes the programs of a design.
#[derive(Debug)]
struct Composer<'a> {
    is_matrix: bool,
    places: &'a Spanned<PlacesKey>,
    testable: Testable<'a>,
    wording: Wording<'a>,
}

impl Composer<'_> {
    /// Returns the program of an arrangement, and the variable in which its value arrives.
    fn compose(
        &self,
        reader: &mut KeyReader<'_, '_>,
        arrangement: &Arrangement,
    ) -> Option<(ProgramTemplate, Target)> {
        let context = reader.context;
        let composed = compose(context.places, arrangement, &self.wording);
        let at = TextPlace {
            first: context.lines.of(self.places),
            line_by_line: false,
        };
        let program = reader.program(&composed.source, at, KEY)?;
        let ty = match self.is_matrix {
            true => None,
            false => Some(reader.text(self.places, self.wording.to, KEY)?),
        };
        let observe = Target {
            name: reader.text(self.places, &composed.observe, KEY)?,
            ty,
        };
        Some((program, observe))
    }
}
