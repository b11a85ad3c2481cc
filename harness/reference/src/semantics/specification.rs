//! Resolves the types that are written in declarations.

use super::declare::Declarer;
use super::literals::missing_type;
use super::memory::MAX_CELLS;
use super::model::{DefaultInitialValue, SEVERAL_NAMESPACES, TopLevelName};
use super::scope::NamedList;
use super::suggestion::similar_declared;
use super::types::{
    ArrayShape, DefaultValue, Dimension, Extent, Structure, Subrange, TypeId, TypeKind, TypeMember,
};
use crate::library::is_not_implemented;
use stickler_syntax::Meaning;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{
    ExpressionId, Name, TypeSpecification, TypeSpecificationKind, VariableGroup, VariableKind,
};
use stickler_types::{Code, ElementaryType};

/// The greatest depth of nested types.
const MAX_DEPTH: u32 = 200;

impl<'u> Declarer<'u, '_> {
    /// The type that a declaration writes; `hint` is the name for one that has none of its own. Where it
    /// cannot be understood that is said, and it gives [`TypeId::ERROR`].
    pub(super) fn specification(
        &mut self,
        specification: &'u TypeSpecification<'u>,
        hint: &'u str,
    ) -> TypeId {
        match &specification.kind {
            TypeSpecificationKind::Named(name) => self.named(*name),
            TypeSpecificationKind::Text { name, length } => self.text(*name, *length),
            TypeSpecificationKind::Subrange { base, limits } => {
                self.subrange(*base, *limits, specification.span)
            }
            TypeSpecificationKind::Array { dimensions, element } => {
                let ty = self.specification(element, hint);
                if self.model.types.named_type(ty) != ty {
                    self.check_nested(ty, element.span);
                }
                self.array(dimensions, ty, specification.span)
            }
            TypeSpecificationKind::VariableLengthArray { element, .. } => {
                self.specification(element, hint);
                let message = "`ARRAY[*]` stands in VAR_IN_OUT of functions, methods and function blocks, by the standard \
                               also in VAR_INPUT and VAR_OUTPUT of the first two; here an array has limits";
                self.report(Code::ArrayDimensionInvalid, specification.span, message);
                TypeId::ERROR
            }
            TypeSpecificationKind::Pointer { form, target } => self.pointer_type(*form, target, hint),
            TypeSpecificationKind::Enumeration { base, values } => self.enumeration(*base, values, hint),
            TypeSpecificationKind::Structure(groups) => {
                self.structure(None, (groups, false), hint, specification.span)
            }
            TypeSpecificationKind::Union(groups) => {
                self.structure(None, (groups, true), hint, specification.span)
            }
            TypeSpecificationKind::Error => TypeId::ERROR,
        }
    }

    /// The type of a group of variables or elements. Where it needs a later edition, nothing more is said about
    /// the group, its initial value included.
    pub(super) fn group_type(&mut self, group: &'u VariableGroup<'u>, hint: &'u str) -> TypeId {
        self.later = false;
        let ty = self.specification(&group.specification, hint);
        if let (true, Some(initializer)) = (self.later, &group.initializer) {
            self.model.passed_over.insert(initializer.span.start);
        }
        ty
    }

    /// The type of a name.
    ///
    /// Basis: ironplc-problem-codes: P2008; P0010 for types of the third edition where the dialect lacks them,
    /// unless the text declares a type of that name, as it may one that the documents of the system say it lacks.
    pub(super) fn named(&mut self, name: Name<'u>) -> TypeId {
        let elementary = self.model.source.dialect.elementary(name.text);
        if let Some(ty) = elementary
            && !ty.is_third_edition()
            && self.model.source.dialect.may_name(ty)
        {
            return match ty.is_text() {
                true => self.model.types.text(ty, self.model.source.dialect.text_length),
                false => TypeId::of(ty),
            };
        }
        match self.model.meaning(name) {
            Meaning::One(TopLevelName::Type(node)) => {
                return self.nodes[node as usize].id.unwrap_or(TypeId::ERROR);
            }
            Meaning::One(TopLevelName::Pou(pou)) => {
                if let Some(node) = self.model.pous[pou as usize].node {
                    return self.nodes[node].id.unwrap_or(TypeId::ERROR);
                }
            }
            Meaning::Several => {
                let message = format!("`{}` {SEVERAL_NAMESPACES}", name.text);
                self.report(Code::UndeclaredUnknownType, name.span, message);
                return TypeId::ERROR;
            }
            Meaning::None => {}
        }
        match elementary {
            Some(ty) if self.model.source.dialect.may_name(ty) => return TypeId::of(ty),
            Some(ty) => {
                let (code, message) = missing_type(ty, self.model.source.dialect);
                self.report(code, name.span, message);
                self.later = true;
            }
            None if name.text.is_empty() => {}
            None if name.text == "STICKLER_ANY_INT" => return TypeId::ANY_INT,
            None if is_not_implemented(name.text) => {
                let message = format!("`{}` is known, and not implemented", name.text);
                self.report(Code::NotImplemented, name.span, message);
            }
            None => {
                let hint = similar_declared(&self.model, name, false, &mut self.guesses);
                let message = format!("type `{}` is not declared{hint}", name.text);
                self.report(Code::UndeclaredUnknownType, name.span, message);
            }
        }
        TypeId::ERROR
    }

    fn text(&mut self, name: Name<'u>, length: ExpressionId) -> TypeId {
        let ty = match ElementaryType::from_name(name.text) {
            Some(ty) if ty.is_text() && self.model.source.dialect.may_name(ty) => ty,
            _ => return self.named(name),
        };
        let Some(length_value) = self.constant(length) else {
            return TypeId::ERROR;
        };
        match u32::try_from(length_value) {
            Ok(capacity @ 1..=65535) => self.model.types.text(ty, capacity),
            _ => {
                let span = self.model.source.expression(length).span;
                let message = format!("the length of a text is 1 to 65535, not {length_value}");
                self.report(Code::StringLengthOutOfRange, span, message);
                TypeId::ERROR
            }
        }
    }

    fn subrange(&mut self, base: Name<'u>, limits: (ExpressionId, ExpressionId), span: Span) -> TypeId {
        let base_type = self.named(base);
        let (low, high) = (self.constant(limits.0), self.constant(limits.1));
        if base_type == TypeId::ERROR {
            return TypeId::ERROR;
        }
        let elementary = self.model.elementary(base_type).filter(|ty| ty.is_integer());
        let Some((ty, range)) = elementary.and_then(|ty| Some((ty, ty.integer_range()?))) else {
            let message = format!("`{}` is no integer type; only integers have subranges", base.text);
            self.report(Code::SubrangeBaseTypeNotNumeric, base.span, message);
            return TypeId::ERROR;
        };
        let (Some(low), Some(high)) = (low, high) else {
            return TypeId::ERROR;
        };
        let fits = |limit| (range.0..=range.1).contains(&limit);
        if !fits(low) || !fits(high) {
            let (name, (least, most)) = (ty.name(), range);
            let message = format!("{low}..{high} does not lie in {name} ({least}..{most})");
            self.report(Code::SubrangeOutOfBounds, span, message);
            return TypeId::ERROR;
        }
        if low > high || low == high && !self.model.source.dialect.single_value_subranges {
            let message = format!("the lower limit {low} is not below the upper limit {high}");
            self.report(Code::SubrangeMinStrictlyLessMax, span, message);
            return TypeId::ERROR;
        }
        self.model.types.subrange(Subrange { base: ty, low, high })
    }

    fn array(&mut self, limits: &[(ExpressionId, ExpressionId)], element: TypeId, span: Span) -> TypeId {
        let mut bounds = Vec::with_capacity(limits.len());
        for &(low, high) in limits {
            let source = self.model.source;
            let at = source.expression(low).span.to(source.expression(high).span);
            let (Some(low), Some(high)) = (self.constant(low), self.constant(high)) else {
                continue;
            };
            let (Ok(low), Ok(high)) = (i64::try_from(low), i64::try_from(high)) else {
                self.report(Code::ConstantOverflow, at, "the limits of an array must fit LINT");
                continue;
            };
            if low > high {
                let message = format!("the lower limit {low} is above the upper limit {high}");
                self.report(Code::ArrayDimensionInvalid, at, message);
                continue;
            }
            bounds.push((low, high));
        }
        if bounds.len() < limits.len() || element == TypeId::ERROR {
            return TypeId::ERROR;
        }
        self.array_of(element, &bounds, span)
    }

    /// The type of a parameter, which may be an ARRAY[*].
    pub(super) fn parameter_type(
        &mut self,
        specification: &'u TypeSpecification<'u>,
        hint: &'u str,
    ) -> TypeId {
        let TypeSpecificationKind::VariableLengthArray { dimensions, element } = &specification.kind else {
            return self.specification(specification, hint);
        };
        let element = self.specification(element, hint);
        let extent = Extent {
            depth: self.model.types.extent(element).depth + 1,
            ..Extent::PLAIN
        };
        if element == TypeId::ERROR || self.too_deep(extent.depth, specification.span) {
            return TypeId::ERROR;
        }
        let dimensions: Box<[_]> = vec![Dimension::VARIABLE; *dimensions as usize].into();
        let known = self.model.types.known_array(element, &dimensions);
        known.unwrap_or_else(|| {
            let length = 0;
            let shape = ArrayShape {
                element,
                dimensions,
                length,
            };
            self.model.types.add_array(shape, extent)
        })
    }

    fn array_of(&mut self, element: TypeId, bounds: &[(i64, i64)], span: Span) -> TypeId {
        let inner = *self.model.types.extent(element);
        let mut dimensions = Vec::with_capacity(bounds.len());
        let mut length = 1_u64;
        for &(low, high) in bounds.iter().rev() {
            let stride = u32::try_from(length.saturating_mul(inner.size.into())).unwrap_or(u32::MAX);
            dimensions.push(Dimension { low, high, stride });
            length = length.saturating_mul(high.abs_diff(low).saturating_add(1));
        }
        dimensions.reverse();
        let cells = length.saturating_mul(inner.size.into());
        let (Ok(size), true) = (u32::try_from(cells), cells <= MAX_CELLS) else {
            let message = format!("the array would take {cells} cells; {MAX_CELLS} are the limit");
            self.report(Code::ArraySizeOverflow, span, message);
            return TypeId::ERROR;
        };
        if let Some(known) = self.model.types.known_array(element, &dimensions) {
            return known;
        }
        if self.too_deep(inner.depth, span) {
            return TypeId::ERROR;
        }
        let default = match inner.default {
            DefaultValue::Zero => DefaultValue::Zero,
            _ => DefaultValue::Routine(self.routine()),
        };
        let extent = Extent {
            size,
            text_units: inner.text_units.saturating_mul(length),
            depth: inner.depth + 1,
            has_block: inner.has_block,
            has_interface: inner.has_interface,
            default,
        };
        let length = u32::try_from(length).unwrap_or(u32::MAX);
        let dimensions = dimensions.into();
        let shape = ArrayShape {
            element,
            dimensions,
            length,
        };
        let id = self.model.types.add_array(shape, extent);
        if let DefaultValue::Routine(routine) = default {
            self.define_routine(routine, DefaultInitialValue::Elements(id));
        }
        id
    }

    /// A structure with the elements of another before its own.
    ///
    /// Basis: codesys-pages: _cds_datatype_structure.
    pub(super) fn derived_structure(
        &mut self,
        base: Name<'u>,
        groups: &'u [VariableGroup<'u>],
        name: &str,
        span: Span,
    ) -> TypeId {
        let ty = self.named(base);
        match self.model.types.kind(ty) {
            TypeKind::Structure(structure) if !structure.is_union => {
                let base = self.model.types.root(ty);
                self.structure(Some(base), (groups, false), name, span)
            }
            TypeKind::Error => TypeId::ERROR,
            _ => {
                let message = format!("`{}` is no structure, and cannot be extended here", base.text);
                self.report(Code::InheritanceInvalid, base.span, message);
                TypeId::ERROR
            }
        }
    }

    fn structure(
        &mut self,
        base: Option<TypeId>,
        (groups, is_union): (&'u [VariableGroup<'u>], bool),
        name: &str,
        span: Span,
    ) -> TypeId {
        let mut members = NamedList::new();
        let inherited = base.map(|base| *self.model.types.extent(base));
        let mut extent = inherited.unwrap_or(Extent {
            size: 0,
            ..Extent::PLAIN
        });
        let mut size = u64::from(extent.size);
        let mut zero = extent.default == DefaultValue::Zero;
        let mut align = 1;
        for group in groups {
            let hint = group.names.first().map_or("", |name| name.text);
            let ty = self.group_type(group, hint);
            let inner = *self.model.types.extent(ty);
            self.refuse_abstract(ty, group.specification.span);
            zero &= group.initializer.is_none() && inner.default == DefaultValue::Zero;
            extent.depth = extent.depth.max(inner.depth);
            extent.has_block |= inner.has_block;
            extent.has_interface |= inner.has_interface;
            if is_union {
                let units = self.model.source.dialect.conversions.moment_units;
                let (bytes, of_field) = self.layouts.size(&self.model.types, units, ty);
                (size, align) = (size.max(bytes.into()), of_field.max(align));
            }
            if is_union && (inner.has_block || inner.has_interface) {
                let message =
                    "function blocks and interfaces in a UNION are not implemented: they are no bytes";
                self.report(Code::NotImplemented, group.specification.span, message);
            }
            for name in &group.names {
                let offset = [u32::try_from(size).unwrap_or(u32::MAX), 0][usize::from(is_union)];
                let member = TypeMember {
                    ty,
                    offset,
                    kind: VariableKind::Local,
                    constant: false,
                    is_public: true,
                };
                let is_inherited =
                    base.is_some_and(|base| self.model.types.member(base, name.text).is_some());
                if is_inherited || !members.push(name.text, member) {
                    let message = format!("element `{}` is already declared", name.text);
                    self.report(Code::StructureDuplicatedElement, name.span, message);
                }
                if !is_union {
                    size += u64::from(inner.size);
                    extent.text_units = extent.text_units.saturating_add(inner.text_units);
                }
            }
        }
        size = size.next_multiple_of(align.into());
        if self.too_deep(extent.depth, span) || self.too_large(size, span) {
            return TypeId::ERROR;
        }
        extent.depth += 1;
        extent.default = DefaultValue::Zero;
        // An empty structure takes a cell too, lest an array of them have no length in memory.
        extent.size = u32::try_from(size.max(1)).unwrap_or(u32::MAX);
        if !zero {
            extent.default = DefaultValue::Routine(self.routine());
        }
        let structure = Structure {
            name: name.into(),
            pou: u32::MAX,
            base,
            is_union,
            members,
        };
        let kind = TypeKind::Structure(Box::new(structure));
        let id = self.model.types.add(kind, extent);
        if let DefaultValue::Routine(routine) = extent.default {
            self.define_routine(routine, DefaultInitialValue::Structure(id, groups));
        }
        id
    }

    /// Says so where types nest deeper than the limit.
    pub(super) fn too_deep(&mut self, depth: u32, span: Span) -> bool {
        if depth >= MAX_DEPTH {
            let message = format!("types nest deeper than {MAX_DEPTH} levels here");
            self.report(Code::LimitExceeded, span, message);
        }
        depth >= MAX_DEPTH
    }

    /// Says so where a type takes more memory than a program may have.
    pub(super) fn too_large(&mut self, cells: u64, span: Span) -> bool {
        if cells > MAX_CELLS {
            let message = format!("this would take {cells} cells of memory; {MAX_CELLS} are the limit");
            self.report(Code::LimitExceeded, span, message);
        }
        cells > MAX_CELLS
    }
}
