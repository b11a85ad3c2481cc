//! The covering design: which combinations of places a cell or a row takes.
//!
//! Each cell takes every source and every target that its dialect and its types have, once. Its number shifts the sources against the
//! targets, so that over the cells every source meets every target, and each such pair some surroundings, so that over the pairs
//! every place meets every surrounding. What a cell takes depends on no other cell, so that a cell more changes no id.

use rustc_hash::FxHashMap;
use stickler_types::DialectName;

use super::{Places, ProgramPlace};

/// The number of surroundings in which a pair of source and target stands in the cells of a table.
const VARIANTS: usize = 3;

/// A source, a target and a surrounding, and the unit in whose body they stand, by index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Arrangement {
    pub(crate) source: usize,
    pub(crate) target: usize,
    pub(crate) surrounding: usize,
    pub(super) unit: usize,
}

/// The combinations that a probe may take.
#[derive(Clone, Debug, Default)]
pub(crate) struct Design {
    /// Whether the programs claim a rejection.
    is_rejected: bool,
    /// Whether an expression computes what a target takes, which is then of the target's type.
    is_computed: bool,
    sources: Vec<usize>,
    targets: Vec<usize>,
    arrangements: Vec<Arrangement>,
    /// The arrangements of a pair of source and target in a dialect, by index.
    of_pair: FxHashMap<(usize, usize, DialectName), [usize; VARIANTS]>,
}

/// The places that can stand in the programs of a cell or a row, by index.
struct Standing {
    sources: Vec<usize>,
    /// The sources that are literals. An initial value takes no other source.
    literals: Vec<usize>,
    direct: Vec<usize>,
    behind: Vec<usize>,
    initial: Vec<usize>,
}

impl Design {
    /// Makes the design of a probe that names these places; says whether its programs claim a rejection, and whether an expression computes
    /// what a target takes.
    pub(crate) fn new(
        places: &Places,
        sources: Vec<usize>,
        targets: Vec<usize>,
        surroundings: &[usize],
        dialects: &[DialectName],
        (is_rejected, is_computed): (bool, bool),
    ) -> Design {
        let mut design = Design {
            is_rejected,
            is_computed,
            ..Design::default()
        };
        for (at, &source) in sources.iter().enumerate() {
            for (beside, &target) in targets.iter().enumerate() {
                let first = design.arrangements.len();
                for &dialect in dialects {
                    let fitting = fitting(places, source, target, surroundings, (dialect, is_rejected));
                    if fitting.is_empty() {
                        continue;
                    }
                    let mut variant = 0;
                    let chosen = [(); VARIANTS].map(|()| {
                        let chosen = not_plain(places, &fitting, at + beside + 5 * variant);
                        variant += 1;
                        design.index_of(chosen, first)
                    });
                    design.of_pair.insert((source, target, dialect), chosen);
                }
            }
        }
        design.sources = sources;
        design.targets = targets;
        design
    }

    /// Returns the index of an arrangement, which is added if it is not among those from `first` on.
    fn index_of(&mut self, arrangement: &Arrangement, first: usize) -> usize {
        let known = self.arrangements[first..]
            .iter()
            .position(|known| known == arrangement);
        known.map_or_else(
            || {
                self.arrangements.push(arrangement.clone());
                self.arrangements.len() - 1
            },
            |known| first + known,
        )
    }

    /// Returns all arrangements; [`Design::of_cell`] answers with indices of them.
    pub(crate) fn arrangements(&self) -> &[Arrangement] {
        &self.arrangements
    }

    /// Returns the arrangements of a cell or a row in a dialect, by index; `number` tells cells apart.
    pub(crate) fn of_cell(
        &self,
        places: &Places,
        number: usize,
        dialect: DialectName,
        types: (&str, &str),
    ) -> Vec<usize> {
        self.taken(&self.standing(places, dialect, types), number, dialect)
    }

    /// Returns a number of arrangements for a row, by index, beginning with the one after those of the row before.
    pub(crate) fn share_of_row(
        &self,
        places: &Places,
        number: usize,
        combinations: usize,
        dialect: DialectName,
        types: (&str, &str),
    ) -> Vec<usize> {
        let before = number * combinations;
        let standing = self.standing(places, dialect, types);
        let whole = self.taken(&standing, 0, dialect).len().max(1);
        let mut taken = self.taken(&standing, before / whole, dialect);
        if !taken.is_empty() {
            let first = before % whole % taken.len();
            taken.rotate_left(first);
        }
        taken.truncate(combinations);
        taken
    }

    /// Returns the places that can stand in the programs of these types in a dialect.
    fn standing(&self, places: &Places, dialect: DialectName, types: (&str, &str)) -> Standing {
        let standing = |indices: &[usize], all: &[ProgramPlace], types| -> Vec<usize> {
            let stands = |&index: &usize| all[index].stands(dialect, types, self.is_rejected);
            indices.iter().copied().filter(stands).collect()
        };
        let met = if self.is_computed {
            (types.1, types.1)
        } else {
            types
        };
        let sources = standing(&self.sources, &places.sources, types);
        let literals = sources.iter().copied();
        let literals = literals
            .filter(|&source| places.sources[source].key.literal)
            .collect();
        let targets = standing(&self.targets, &places.targets, met).into_iter();
        let (initial, others): (Vec<usize>, Vec<usize>) =
            targets.partition(|&target| places.targets[target].key.literal);
        let (behind, direct) = others
            .into_iter()
            .partition(|&target| places.targets[target].is_behind_a_parameter);
        Standing {
            sources,
            literals,
            direct,
            behind,
            initial,
        }
    }

    fn taken(&self, standing: &Standing, number: usize, dialect: DialectName) -> Vec<usize> {
        let Standing {
            sources,
            literals,
            direct,
            behind,
            initial,
        } = standing;
        let mut taken = self.pairs(number, dialect, sources, direct, true);
        taken.extend(self.pairs(number, dialect, sources, behind, false));
        taken.extend(self.pairs(number, dialect, literals, initial, false));
        taken
    }

    /// Returns arrangements in which every target occurs that can, and if `all_sources` every source.
    fn pairs(
        &self,
        number: usize,
        dialect: DialectName,
        sources: &[usize],
        targets: &[usize],
        all_sources: bool,
    ) -> Vec<usize> {
        let mut taken = Vec::new();
        if sources.is_empty() || targets.is_empty() {
            return taken;
        }
        let variant = number / sources.len() % VARIANTS;
        let arrangement =
            |source: usize, target: usize| Some(self.of_pair.get(&(source, target, dialect))?[variant]);
        let mut met = vec![false; sources.len()];
        for (at, &target) in targets.iter().enumerate() {
            let next = (0..sources.len()).map(|step| (at + number + step) % sources.len());
            let mut possible =
                next.filter_map(|source| Some((source, arrangement(sources[source], target)?)));
            if let Some((source, index)) = possible.next() {
                met[source] = true;
                taken.push(index);
            }
        }
        for (at, &source) in sources
            .iter()
            .enumerate()
            .filter(|&(at, _)| all_sources && !met[at])
        {
            let next = (0..targets.len()).map(|step| targets[(at + number + step) % targets.len()]);
            taken.extend(next.filter_map(|target| arrangement(source, target)).next());
        }
        taken
    }
}

/// Returns the arrangement at a position, counted round, or the one behind it if tables ask it with programs of their own.
fn not_plain<'f>(places: &Places, fitting: &'f [Arrangement], position: usize) -> &'f Arrangement {
    let chosen = &fitting[position % fitting.len()];
    match places.is_plain(chosen) {
        true => &fitting[(position + 1) % fitting.len()],
        false => chosen,
    }
}

/// Returns the arrangements of a source and a target in the surroundings that both can stand in.
fn fitting(
    places: &Places,
    source: usize,
    target: usize,
    surroundings: &[usize],
    (dialect, is_rejected): (DialectName, bool),
) -> Vec<Arrangement> {
    let (from, to) = (&places.sources[source], &places.targets[target]);
    let promised = |place: &ProgramPlace| place.is_promised(dialect, is_rejected);
    if !promised(from) || !promised(to) || (to.key.literal && !from.key.literal) {
        return Vec::new();
    }
    let arrangement = |&surrounding: &usize| {
        let around = Some(&places.surroundings[surrounding]);
        let around = around.filter(|around| to.is_in_its_statement || around.is_a_body())?;
        let stands = |unit: &usize| [from, to, around].iter().all(|place| place.units.contains(unit));
        let unit = (0..places.units.len())
            .find(stands)
            .filter(|_| promised(around))?;
        Some(Arrangement {
            source,
            target,
            surrounding,
            unit,
        })
    };
    surroundings.iter().filter_map(arrangement).collect()
}
