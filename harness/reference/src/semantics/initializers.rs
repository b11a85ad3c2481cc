//! Initial values: of variables, and of the types that have some of their own.
//!
//! Memory begins with zeros and empty texts, and a function clears its frame, so only what differs is set.

use super::contexts::ValueContext;
use super::locations::{Location, VariablePlace};
use super::lowering::{LoweredValue, Lowering};
use super::model::{DeclaredVariable, DefaultInitialValue};
use super::types::{DefaultValue, TypeId, TypeKind, TypeMember};
use crate::instruction::{Instruction, RoutineId};
use std::ops::Range;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{ArrayElement, Initializer, InitializerKind, Name};
use stickler_types::Code;

impl<'m> Lowering<'m> {
    /// Gives a variable its initial value.
    pub(super) fn initialize_variable(&mut self, variable: &DeclaredVariable<'m>) {
        let place = VariablePlace::of(variable);
        self.set_line(variable.name.span);
        let muted = self.reporter.mute(variable.repeated);
        self.initialize(place.location, variable.ty, variable.initializer);
        self.reporter.mute(muted);
    }

    /// Gives what lies somewhere its initial value. The location can be used more than once.
    pub(super) fn initialize(
        &mut self,
        location: Location,
        ty: TypeId,
        initializer: Option<&'m Initializer<'m>>,
    ) {
        let Some(initializer) = initializer else {
            return self.default_value(location, ty);
        };
        if ty == TypeId::ERROR {
            if !self.model.passed_over.contains(&initializer.span.start) {
                self.lower_initializer(initializer);
            }
            return;
        }
        match (&initializer.kind, self.model.types.kind(ty)) {
            (InitializerKind::Expression(id), _) => {
                let place = VariablePlace::new(location, ty);
                self.begin_store(place);
                self.coerce(*id, ty, ValueContext::Initializer);
                self.finish_store(place, initializer.span);
            }
            (InitializerKind::Array(elements), TypeKind::Array(shape)) => {
                self.default_value(location, ty);
                let dimensions = shape.dimensions.iter();
                let lengths: Vec<_> = dimensions.map(|dimension| dimension.length()).collect();
                self.elements(location, shape.element, &lengths, elements, initializer.span);
            }
            (InitializerKind::Structure(fields), TypeKind::Structure(_) | TypeKind::FunctionBlock(_)) => {
                self.default_value(location, ty);
                self.fields(location, ty, fields);
            }
            (kind, _) => {
                let form = match kind {
                    InitializerKind::Array(_) => "a list of elements",
                    _ => "a list of fields",
                };
                let message = format!("{form} is no initial value for {}", self.model.types.name(ty));
                self.report(Code::InitializerTypeMismatch, initializer.span, message);
                self.lower_initializer(initializer);
            }
        }
    }

    /// Puts a list of elements or fields on the stack, as a value of a type.
    pub(super) fn aggregate(&mut self, list: &'m Initializer<'m>, ty: TypeId) -> LoweredValue {
        let cell = self.temporary_of(ty, list.span);
        let place = VariablePlace::new(Location::Absolute(cell), ty);
        self.clear(place.location, self.model.types.extent(ty).size);
        self.initialize(place.location, ty, Some(list));
        self.load(place)
    }

    /// Gives what lies somewhere the default of its type.
    pub(super) fn default_value(&mut self, location: Location, ty: TypeId) {
        match self.model.types.extent(ty).default {
            DefaultValue::Zero => {}
            DefaultValue::Constant(raw) => {
                let place = VariablePlace::new(location, ty);
                self.begin_store(place);
                self.emit(Instruction::Push(raw));
                self.finish_store(place, Span::default());
            }
            DefaultValue::Routine(routine) => {
                self.push_address(location);
                self.emit(Instruction::CallInstance(routine));
            }
        }
    }

    /// Lowers an initial value whose type is not known, for what is wrong inside it only.
    fn lower_initializer(&mut self, initializer: &'m Initializer<'m>) {
        match &initializer.kind {
            InitializerKind::Expression(id) => {
                self.value(*id, None);
            }
            InitializerKind::Array(elements) => {
                let values = elements.iter().flat_map(|element| &element.values);
                values.for_each(|value| self.lower_initializer(value));
            }
            InitializerKind::Structure(fields) => {
                fields.iter().for_each(|(_, value)| self.lower_initializer(value));
            }
        }
    }

    /// Sets elements of an array, one behind the other. Values that find no element any more are checked and left out.
    fn elements(
        &mut self,
        location: Location,
        element: TypeId,
        lengths: &[u32],
        entries: &'m [ArrayElement<'m>],
        span: Span,
    ) {
        let total = lengths.iter().product::<u32>();
        let size = self.model.types.extent(element).size;
        let mut position = 0_u32;
        let mut too_many = false;
        for entry in entries {
            let values = entry.values.iter();
            let widths = values.map(|value| self.width(value, element, lengths));
            let width = widths.fold(0, u32::saturating_add).max(1);
            let count = self.repetition(entry);
            let whole = count.min((total - position) / width);
            too_many |= whole < count;
            if whole > 0 {
                self.in_a_row(location, element, lengths, &entry.values, position..total);
                if whole > 1 && !entry.values.is_empty() {
                    let block = self.shifted(location, position.saturating_mul(size));
                    self.replicate(block, width.saturating_mul(size), whole);
                }
                position += whole * width;
            }
            if whole < count || count == 0 {
                let muted = (whole > 0).then(|| self.reporter.mute(true));
                let room = position..if count > 0 { total } else { position };
                position = self.in_a_row(location, element, lengths, &entry.values, room);
                muted.map(|muted| self.reporter.mute(muted));
            }
        }
        if too_many && !self.model.source.dialect.excess_initial_values {
            let message = format!("more than {total} initial values for {total} elements");
            self.report(Code::InitializerTypeMismatch, span, message);
        }
    }

    /// Repeats what lies in the first `stride` cells of a location, which count as the first time.
    fn replicate(&mut self, location: Location, stride: u32, count: u32) {
        self.push_address(location);
        self.emit(Instruction::Replicate { stride, count });
    }

    /// Sets elements to values, once each, as far as there is room. Returns the position behind them. Where a list of
    /// elements stands for one of several dimensions, it is the next row.
    fn in_a_row(
        &mut self,
        location: Location,
        element: TypeId,
        lengths: &[u32],
        values: &'m [Initializer<'m>],
        room: Range<u32>,
    ) -> u32 {
        let size = self.model.types.extent(element).size;
        let mut position = room.start;
        for value in values {
            let width = self.width(value, element, lengths);
            let fits = width <= room.end - position;
            let here = self.shifted(location, if fits { position.saturating_mul(size) } else { 0 });
            let before = self.emitter.position();
            match &value.kind {
                InitializerKind::Array(row) if self.is_row(value, element, lengths) => {
                    self.elements(here, element, &lengths[1..], row, value.span);
                }
                _ => self.initialize(here, element, Some(value)),
            }
            if fits {
                position += width;
            } else {
                self.emitter.truncate(before);
            }
        }
        position
    }

    /// Returns how many elements an initial value stands for.
    fn width(&self, value: &Initializer<'_>, element: TypeId, lengths: &[u32]) -> u32 {
        if self.is_row(value, element, lengths) {
            lengths[1..].iter().product()
        } else {
            1
        }
    }

    /// Returns whether a list stands for a row of an array with several dimensions.
    fn is_row(&self, value: &Initializer<'_>, element: TypeId, lengths: &[u32]) -> bool {
        matches!(value.kind, InitializerKind::Array(_))
            && self.model.types.array(element).is_none()
            && lengths.len() > 1
    }

    /// Returns how often an element is repeated.
    fn repetition(&mut self, element: &ArrayElement<'_>) -> u32 {
        let Some(id) = element.repetition else { return 1 };
        let Some(number) = self.constant_number(id) else {
            return 0;
        };
        u32::try_from(number).unwrap_or_else(|_| {
            let message = format!("{number} is no number of repetitions");
            self.report(Code::ConstantOverflow, self.span(id), message);
            0
        })
    }

    fn fields(&mut self, location: Location, ty: TypeId, fields: &'m [(Name<'m>, Initializer<'m>)]) {
        let Some(structure) = self.model.types.structure(ty) else {
            return;
        };
        let mut given = rustc_hash::FxHashSet::default();
        for (name, value) in fields {
            let member = self.model.types.member(ty, name.text);
            let Some(member) = member.filter(|member| member.kind.is_held()) else {
                let message = format!("{} has no element `{}`", structure.name, name.text);
                self.report(Code::VariableUndefined, name.span, message);
                self.lower_initializer(value);
                continue;
            };
            if !given.insert(member.offset) {
                let message = match structure.is_union {
                    true => "the fields of a UNION share one initial value".to_owned(),
                    false => format!("`{}` is given twice", name.text),
                };
                self.report(Code::StructureDuplicatedElement, name.span, message);
            }
            self.initialize_member(VariablePlace::new(location, ty), member, Some(value));
        }
    }

    /// Gives a member of what lies at a place its initial value. One of a union that has none leaves the memory to the others.
    fn initialize_member(
        &mut self,
        whole: VariablePlace,
        member: &TypeMember,
        initializer: Option<&'m Initializer<'m>>,
    ) {
        if !self.model.types.is_union(whole.ty) {
            let here = self.shifted(whole.location, member.offset);
            return self.initialize(here, member.ty, initializer);
        }
        let extent = *self.model.types.extent(member.ty);
        if initializer.is_none() && extent.default == DefaultValue::Zero {
            return;
        }
        let span = initializer.map_or(Span::default(), |initializer| initializer.span);
        let here = Location::Absolute(self.temporary_of(member.ty, span));
        self.clear(here, extent.size);
        self.initialize(here, member.ty, initializer);
        self.entered(whole);
        self.push_address(here);
        let layout = self.layout(member.ty);
        self.emit(Instruction::Scatter(layout));
    }

    /// Makes a routine that gives a variable, which is its instance, the default of its type.
    pub(super) fn initial_value(&mut self, routine: RoutineId, value: DefaultInitialValue<'m>) {
        let model = self.model;
        let start = Location::Instance(0);
        self.emitter.begin(routine);
        match value {
            DefaultInitialValue::Structure(ty, groups) => {
                let TypeKind::Structure(structure) = model.types.kind(ty) else {
                    return;
                };
                if let Some(base) = structure.base {
                    self.default_value(start, base);
                }
                for group in groups {
                    for (index, name) in group.names.iter().enumerate() {
                        let Some(member) = structure.members.find(name.text) else {
                            continue;
                        };
                        self.set_line(name.span);
                        let muted = self.reporter.mute(index > 0);
                        let whole = VariablePlace::new(start, ty);
                        self.initialize_member(whole, member, group.initializer.as_ref());
                        self.reporter.mute(muted);
                    }
                }
            }
            DefaultInitialValue::Elements(ty) => {
                let Some(shape) = model.types.array(ty) else {
                    return;
                };
                self.default_value(start, shape.element);
                if shape.length > 1 {
                    self.replicate(start, model.types.extent(shape.element).size, shape.length);
                }
            }
            DefaultInitialValue::Declared(base, initializer) => {
                self.set_line(initializer.span);
                self.initialize(start, base, Some(initializer));
            }
        }
        self.emit(Instruction::Return);
    }
}
