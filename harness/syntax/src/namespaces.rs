//! Namespaces: the one that each place of a text belongs to, and those in which a name is looked for.
//!
//! Basis: iec-61131-3: third edition, 6.9.

use crate::source::Span;
use crate::tree::{CaseFolded, Declaration, Name, SourceUnit};
use rustc_hash::FxHashMap;

/// The most namespaces that USING makes known in one namespace, since each name may be looked for in all of them.
///
/// Basis: harness/README.md (depth, size and step limits turn hostile input into a diagnostic).
const MAX_IMPORTS: usize = 64;

/// The number of a namespace of a text; 0 is what stands outside of all.
pub type NamespaceId = u32;

/// The namespaces of a text.
#[derive(Debug)]
pub struct Namespaces<'s> {
    nodes: Vec<Namespace<'s>>,
    /// The bytes from which on declarations belong to another namespace, in the order of the text.
    changes: Vec<(u32, NamespaceId)>,
    /// The names behind USING that make nothing known, each with the reason.
    pub refused: Vec<(Name<'s>, &'static str)>,
    /// Whether a name may be qualified by that of a library, which the text does not declare.
    has_libraries: bool,
}

#[derive(Debug, Default)]
struct Namespace<'s> {
    parent: Option<NamespaceId>,
    children: FxHashMap<CaseFolded<'s>, NamespaceId>,
    /// The namespaces behind USING.
    imports: Vec<NamespaceId>,
}

/// The meaning of a name at its place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Meaning<T> {
    /// This.
    One(T),
    /// The things of several namespaces that USING makes known.
    Several,
    /// Nothing.
    None,
}

impl<T> Meaning<T> {
    /// Returns what the name means, where that is one thing.
    pub fn one(self) -> Option<T> {
        match self {
            Meaning::One(meant) => Some(meant),
            Meaning::Several | Meaning::None => None,
        }
    }
}

impl<'s> Namespaces<'s> {
    /// Collects the namespaces of a text; `has_libraries` tells whether a name that no namespace qualifies may be that of a library.
    pub fn new(unit: &SourceUnit<'s>, has_libraries: bool) -> Namespaces<'s> {
        let mut namespaces = Namespaces {
            nodes: vec![Namespace::default()],
            changes: Vec::new(),
            refused: Vec::new(),
            has_libraries,
        };
        let mut open = Vec::new();
        let mut using = Vec::new();
        for declaration in &unit.declarations {
            match declaration {
                Declaration::Namespace(name) => {
                    let here = namespaces.current();
                    open.push(here);
                    let mut at = here;
                    for part in name.text.split('.') {
                        at = namespaces.child(at, part);
                    }
                    namespaces.changes.push((name.span.start, at));
                }
                Declaration::EndNamespace(end) => {
                    namespaces.changes.push((end.span.start, open.pop().unwrap_or(0)));
                }
                Declaration::Using(name) => using.push((namespaces.current(), *name)),
                Declaration::Pou(pou) if !pou.using.is_empty() => {
                    let around = namespaces.current();
                    let inside = namespaces.add(around);
                    // USING in the head holds for its result and its bases, too.
                    namespaces.changes.push((pou.name.span.end, inside));
                    namespaces.changes.push((pou.span.end, around));
                    using.extend(pou.using.iter().map(|name| (inside, *name)));
                }
                _ => {}
            }
        }
        for (at, name) in using {
            namespaces.import(at, name);
        }
        namespaces
    }

    fn current(&self) -> NamespaceId {
        self.changes.last().map_or(0, |(_, at)| *at)
    }

    /// Returns the namespace of a name in another one, which is made where there is none.
    fn child(&mut self, parent: NamespaceId, name: &'s str) -> NamespaceId {
        if let Some(known) = self.node(parent).children.get(&CaseFolded(name)) {
            return *known;
        }
        let id = self.add(parent);
        self.node_mut(parent).children.insert(CaseFolded(name), id);
        id
    }

    /// Adds a namespace without a name.
    fn add(&mut self, parent: NamespaceId) -> NamespaceId {
        self.nodes.push(Namespace {
            parent: Some(parent),
            ..Namespace::default()
        });
        // There are fewer namespaces than bytes in a text, which 32 bits count.
        (self.nodes.len() - 1) as u32
    }

    fn import(&mut self, at: NamespaceId, name: Name<'s>) {
        let Some(used) = self.named(name) else {
            return self.refused.push((name, "is no namespace of the text"));
        };
        let known = &mut self.node_mut(at).imports;
        if known.contains(&used) {
            return;
        }
        match known.len() < MAX_IMPORTS {
            true => known.push(used),
            false => self
                .refused
                .push((name, "is one USING too many for one namespace")),
        }
    }

    fn node(&self, id: NamespaceId) -> &Namespace<'s> {
        &self.nodes[id as usize]
    }

    fn node_mut(&mut self, id: NamespaceId) -> &mut Namespace<'s> {
        &mut self.nodes[id as usize]
    }

    /// Returns whether the text has no namespaces and no USING in the head of a unit.
    pub fn is_empty(&self) -> bool {
        self.nodes.len() == 1
    }

    /// Returns whether a namespace of this name is in no other one.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.node(0).children.contains_key(&CaseFolded(name))
    }

    /// Returns the namespace that contains a position.
    pub fn at(&self, place: Span) -> NamespaceId {
        let before = self.changes.partition_point(|(start, _)| *start <= place.start);
        before.checked_sub(1).map_or(0, |last| self.changes[last].1)
    }

    /// Returns the namespaces around a place, the innermost first; the last is what stands outside of all.
    fn ancestors(&self, place: Span) -> impl Iterator<Item = NamespaceId> {
        std::iter::successors(Some(self.at(place)), |&id| self.node(id).parent)
    }

    /// Returns the namespace that a name means where it stands.
    pub fn named(&self, name: Name<'_>) -> Option<NamespaceId> {
        if self.is_empty() {
            return None;
        }
        self.ancestors(name.span).find_map(|at| self.below(at, name.text))
    }

    /// Follows a path from a namespace to one inside of it.
    fn below(&self, at: NamespaceId, path: &str) -> Option<NamespaceId> {
        let mut parts = path.split('.');
        parts.try_fold(at, |at, part| {
            self.node(at).children.get(&CaseFolded(part)).copied()
        })
    }

    /// Finds what a name means where it stands, perhaps a qualified one; `get` tells what an unqualified name means in one namespace.
    pub fn find<T>(&self, name: Name<'_>, get: impl Fn(NamespaceId, &str) -> Option<T>) -> Meaning<T> {
        let (path, last) = match name.text.rsplit_once('.') {
            Some((path, last)) => (Some(path), last),
            None => (None, name.text),
        };
        let get_below = |at| {
            let at = path.map_or(Some(at), |path| self.below(at, path))?;
            get(at, last)
        };
        for at in self.ancestors(name.span) {
            if let Some(meant) = get_below(at) {
                return Meaning::One(meant);
            }
            let mut used = self.node(at).imports.iter().filter_map(|used| get_below(*used));
            if let Some(meant) = used.next() {
                return used.next().map_or(Meaning::One(meant), |_| Meaning::Several);
            }
        }
        let is_library = path.is_some() && self.has_libraries;
        let meant = is_library.then(|| get(0, last.trim_start())).flatten();
        meant.map_or(Meaning::None, Meaning::One)
    }
}
