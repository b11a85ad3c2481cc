//! Names behind those of namespaces, of libraries, of lists of global variables and of enumerations: `OSCAT_BASIC.DAY_OF_WEEK`, `COLOR.RED`.
//!
//! Basis: iec-61131-3: third edition, 6.9; codesys-pages: _cds_rules, _cds_operator_namespace_enum.

use crate::names::{DeclaredKind, DeclaredName, declared};
use crate::namespaces::Namespaces;
use crate::tree::{CaseFolded, Declaration, ExpressionId, ExpressionKind, Name, SourceUnit};
use crate::tree::{Prefixed, TypeSpecificationKind, VariableKind, own_instance};
use rustc_hash::{FxHashMap, FxHashSet};
use stickler_types::Dialect;

/// Takes qualified names in the expressions of a text for what they name: a namespace and what stands in it become one name; where the
/// dialect has such names, those of enumerations become enumerated values, and a name that the text declares nowhere is that of a library
/// or of a list of global variables. It qualifies what the text declares for all of it, and what `is_standard`; any other is left as it is.
pub fn resolve_qualifiers<'s>(
    unit: &mut SourceUnit<'s>,
    text: &'s str,
    dialect: &Dialect,
    is_standard: impl Fn(&str) -> bool,
) {
    let is_field = |id: &u32| matches!(unit.expressions[*id as usize].kind, ExpressionKind::Field { .. });
    // A text has fewer expressions than 32 bits count.
    let fields: Vec<u32> = (0..unit.expressions.len() as u32).filter(is_field).collect();
    let has_points = dialect.library_namespaces || dialect.values_behind_points;
    let is_namespace = |one: &Declaration<'_>| matches!(one, Declaration::Namespace(_));
    if fields.is_empty() || !has_points && !unit.declarations.iter().any(is_namespace) {
        return;
    }
    let known = Known::new(unit);
    let namespaces = Namespaces::new(unit, dialect.library_namespaces);
    // What stands inside of an expression comes before it, so that the name of a library is gone where that of its enumeration comes.
    for id in fields {
        let Some((qualifier, name)) = qualified(unit, id) else {
            continue;
        };
        let span = qualifier.span.to(name.span);
        let is_joined = qualifier.span.end + 1 == name.span.start;
        let is_enumeration = known
            .enumerations
            .contains(&CaseFolded(qualifier.unqualified().text));
        let mut meant = known.all(name);
        // A variable may be called as its type is.
        let is_value =
            is_enumeration && meant.any(|declared| matches!(declared.kind, DeclaredKind::EnumeratedValue));
        let kind = if known.is_variable(qualifier) && !is_value || own_instance(qualifier.text).is_some() {
            None
        } else if namespaces.named(qualifier).is_some() {
            let text = span.text(text);
            is_joined.then_some(ExpressionKind::Name(Name { text, span }))
        } else if is_enumeration {
            let value = Prefixed::new(span.text(text), span.start);
            (is_joined && dialect.values_behind_points).then_some(ExpressionKind::EnumeratedValue(value))
        } else {
            let is_library = dialect.library_namespaces && !known.is_global(qualifier);
            let is_known = is_standard(name.text) || known.is_global(name);
            (is_library && is_known).then_some(ExpressionKind::Name(name))
        };
        if let Some(kind) = kind {
            unit.expressions[id as usize].kind = kind;
        }
    }
}

/// Returns the name of a field, and the first of the names before it, where nothing but names stands there.
fn qualified<'s>(unit: &SourceUnit<'s>, id: u32) -> Option<(Name<'s>, Name<'s>)> {
    let ExpressionKind::Field { mut base, field } = unit.expression(ExpressionId(id))?.kind else {
        return None;
    };
    loop {
        match unit.expression(base)?.kind {
            ExpressionKind::Name(qualifier) => return Some((qualifier, field)),
            ExpressionKind::Field { base: outer, .. } => base = outer,
            _ => return None,
        }
    }
}

/// The declarations of a text, by name.
struct Known<'s> {
    /// The declarations of each name.
    names: FxHashMap<CaseFolded<'s>, Vec<Declared>>,
    /// The names of the enumerations.
    enumerations: FxHashSet<CaseFolded<'s>>,
}

/// A declaration of a name.
struct Declared {
    kind: DeclaredKind,
    /// The first and the last byte of the program organization unit that alone knows the name.
    within: Option<(u32, u32)>,
}

impl<'s> Known<'s> {
    fn new(unit: &SourceUnit<'s>) -> Known<'s> {
        let mut names: FxHashMap<CaseFolded<'s>, Vec<Declared>> = FxHashMap::default();
        for DeclaredName {
            name, kind, inside, ..
        } in declared(unit)
        {
            let within = inside.map(|pou| (pou.span.start, pou.span.end));
            names
                .entry(CaseFolded(name.text))
                .or_default()
                .push(Declared { kind, within });
        }
        let enumerations = unit.types().filter_map(|declared| {
            let kind = &declared.specification.kind;
            matches!(kind, TypeSpecificationKind::Enumeration { .. })
                .then_some(CaseFolded(declared.name.text))
        });
        Known {
            names,
            enumerations: enumerations.collect(),
        }
    }

    fn all(&self, name: Name<'s>) -> impl Iterator<Item = &Declared> {
        self.names.get(&CaseFolded(name.text)).into_iter().flatten()
    }

    /// Returns whether a name is that of a variable where it stands.
    fn is_variable(&self, name: Name<'s>) -> bool {
        self.all(name).any(|declared| {
            let is_here = |(start, end)| (start..end).contains(&name.span.start);
            matches!(declared.kind, DeclaredKind::Variable(_)) && declared.within.is_none_or(is_here)
        })
    }

    /// Returns whether the whole text knows a name.
    fn is_global(&self, name: Name<'s>) -> bool {
        use DeclaredKind::{EnumeratedValue, Pou, Type, Variable};
        let is_global = |kind| {
            matches!(
                kind,
                Pou(_) | Type | EnumeratedValue | Variable(VariableKind::Global)
            )
        };
        self.all(name).any(|declared| is_global(declared.kind))
    }
}
