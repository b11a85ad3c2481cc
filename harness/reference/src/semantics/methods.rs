//! Calls of methods, reads and writes of properties, THIS and SUPER.
//!
//! A method lies in a frame of its own, as a function does, and its instance is `this`. Where only the running program knows which
//! method is meant, arguments and results pass through the frame that all of them share; a routine of each method brings them to its
//! own frame and back.
//!
//! Basis: iec-61131-3: third edition, 6.6.5 to 6.6.8; codesys-pages: _cds_method_call.

use super::calls::Callee;
use super::contexts::ValueContext;
use super::inferred::Inferred;
use super::locations::{Location, VariablePlace};
use super::lowering::{LoweredValue, Lowering};
use super::model::{DeclaredVariable, Member, PouEntry};
use super::types::TypeId;
use crate::instruction::{Instruction, MachineProgram};
use stickler_syntax::source::Span;
use stickler_syntax::tree::{
    Access, ExpressionId, ExpressionKind, Name, PouKind, VariableKind, own_instance,
};
use stickler_types::Code;

/// The instance whose code is running, by THIS or SUPER.
#[derive(Clone, Copy, Debug)]
pub(super) struct OwnInstance {
    /// The block as which it is seen.
    pub(super) pou: u32,
    is_super: bool,
}

/// The instance of which a method or a property is meant.
#[derive(Clone, Copy, Debug)]
pub(super) enum Receiver {
    /// The one whose code is running.
    This,
    /// The one whose code is running, seen as the block that it extends.
    Super,
    /// The one that an expression names.
    Instance(ExpressionId),
}

/// A member where it is used.
#[derive(Clone, Copy, Debug)]
pub(super) struct UsedMember {
    pub(super) receiver: Receiver,
    pub(super) member: Member,
}

/// The way in which a call finds the routine that it runs.
#[derive(Clone, Copy, Debug)]
pub(super) enum Entrance {
    /// A call of a function, which has no instance.
    Function,
    /// A call of a method that is known beforehand; holds the place of the instance.
    Method(Location),
    /// A call of the method that the type of the running program's instance has; holds the place of the instance.
    Dispatched(Location),
}

impl<'m> Lowering<'m> {
    /// The block or program of which code is being made, the owner of a method.
    fn own_pou(&self) -> Option<u32> {
        let entry = self.entry()?;
        let is_block = matches!(entry.pou.kind, PouKind::FunctionBlock | PouKind::Program);
        entry.owner.or(self.pou.filter(|_| is_block))
    }

    /// Returns the instance that an expression names by THIS or SUPER; a variable of that name hides it.
    pub(super) fn own_instance_of(&self, id: ExpressionId) -> Option<OwnInstance> {
        let ExpressionKind::Name(name) = self.expression(self.model.source.bare(id)).kind else {
            return None;
        };
        let word = own_instance(name.text).filter(|_| self.variable(name.text).is_none())?;
        let is_super = word == "SUPER";
        let feature = if is_super { "super" } else { "this" };
        // A method and `^` have been refused before where the dialect lacks them.
        let is_first = self.entry()?.owner.is_none() && !name.text.ends_with('^');
        let own = self.own_pou()?;
        if is_first && self.model.source.dialect.lacks(feature) {
            return None;
        }
        let base = self.model.pous[own as usize].base;
        let pou = if is_super { base? } else { own };
        Some(OwnInstance { pou, is_super })
    }

    /// Returns the VAR_IN_OUT that `THIS^.name` or `SUPER^.name` names.
    pub(super) fn own_in_out(&self, base: ExpressionId, field: Name<'_>) -> Option<&'m DeclaredVariable<'m>> {
        let own = self.own_instance_of(base)?;
        let index = self.local(&self.model.pous[own.pou as usize], field.text)?;
        Some(self.model.variable(index)).filter(|variable| variable.kind == VariableKind::InOut)
    }

    /// Finds the method or property that an expression names.
    pub(super) fn used_member(&mut self, id: ExpressionId) -> Option<UsedMember> {
        if !self.model.has_members {
            return None;
        }
        match self.expression(id).kind {
            ExpressionKind::Name(name) => {
                let pou = self.own_pou().filter(|_| self.variable(name.text).is_none())?;
                let member = self.model.member(pou, name.text)?;
                let receiver = Receiver::This;
                Some(UsedMember { receiver, member })
            }
            ExpressionKind::Field { base, field } => {
                if let Some(own) = self.own_instance_of(base) {
                    let receivers = [Receiver::This, Receiver::Super];
                    let receiver = receivers[usize::from(own.is_super)];
                    let member = self.model.member(own.pou, field.text)?;
                    return Some(UsedMember { receiver, member });
                }
                let ty = self.known_type(base)?;
                let types = &self.model.types;
                // The type of a program is a structure.
                let owner = types.object(ty).or_else(|| types.structure(ty));
                let pou = owner.map(|owner| owner.pou).filter(|&pou| pou != u32::MAX)?;
                let member = self.model.member(pou, field.text)?;
                let receiver = Receiver::Instance(base);
                let hides = self.model.types.element(ty, field.text).is_some();
                (!hides).then_some(UsedMember { receiver, member })
            }
            _ => None,
        }
    }

    /// Finds the property that an expression names.
    pub(super) fn property(&mut self, id: ExpressionId) -> Option<UsedMember> {
        self.used_member(id).filter(|used| used.member.method.is_none())
    }

    /// Infers the type of what is perhaps a property.
    pub(super) fn infer_property(&mut self, id: ExpressionId) -> Inferred {
        let getter = self.property(id).and_then(|used| used.member.getter);
        match getter.and_then(|getter| self.result_type(getter)) {
            Some(ty) => self.inferred_of(ty),
            None => Inferred::Error,
        }
    }

    /// Puts the value of a property on the stack.
    pub(super) fn read_property(&mut self, id: ExpressionId, property: UsedMember) -> LoweredValue {
        let span = self.span(id);
        let Some(getter) = property.member.getter else {
            let message = format!("the property `{}` has no GET", self.model.source.text_of(id));
            self.report(Code::MethodNotFound, span, message);
            return LoweredValue::ERROR;
        };
        self.call_member(span, property.receiver, getter, &[], true)
    }

    /// The place of what a property gives, where it is an array or a structure; else a property is no variable.
    pub(super) fn property_place(&mut self, id: ExpressionId) -> Option<VariablePlace> {
        let property = self.property(id)?;
        let value = self.read_property(id, property);
        if value.ty == TypeId::ERROR {
            return None;
        }
        if !self.is_aggregate(value.ty) {
            let message = "a variable is needed here, and a property is none";
            self.report(Code::SyntaxError, self.span(id), message);
            return None;
        }
        Some(VariablePlace {
            constant: true,
            ..VariablePlace::new(Location::Stack, value.ty)
        })
    }

    /// Lowers an assignment to a property.
    pub(super) fn write_property(&mut self, target: ExpressionId, property: UsedMember, value: ExpressionId) {
        let span = self.span(target);
        let Some(setter) = property.member.setter else {
            let message = format!("the property `{}` has no SET", self.model.source.text_of(target));
            self.report(Code::AssignmentToConstant, span, message);
            self.value(value, None);
            return;
        };
        let Some((callee, entrance)) = self.enter(span, property.receiver, setter) else {
            self.value(value, None);
            return;
        };
        let entry = &self.model.pous[callee as usize];
        let Some(&parameter) = entry.parameters.last() else {
            return;
        };
        let parameter = &self.model.variables[parameter as usize];
        let place = VariablePlace::of(parameter);
        self.begin_store(place);
        self.coerce(value, parameter.ty, ValueContext::Assignment);
        self.finish_store(place, span);
        self.emit_entrance(span, callee, entrance);
    }

    /// Calls a method, or GET of a property.
    pub(super) fn call_member(
        &mut self,
        span: Span,
        receiver: Receiver,
        member: u32,
        arguments: &[stickler_syntax::tree::Argument<'m>],
        used: bool,
    ) -> LoweredValue {
        let Some((callee, entrance)) = self.enter(span, receiver, member) else {
            self.lower_arguments(arguments);
            return LoweredValue::ERROR;
        };
        let entry = &self.model.pous[member as usize];
        if used && entry.result.is_none() {
            let message = format!("the method `{}` gives no value", entry.pou.name.text);
            self.report(Code::MethodCallWithoutReturnValue, span, message);
        }
        self.call_entered(span, callee, entrance, arguments, used)
    }

    /// Finds the instance of a member, and gives the member whose frame takes the arguments, and how its code is reached.
    fn enter(&mut self, span: Span, receiver: Receiver, member: u32) -> Option<(u32, Entrance)> {
        let entry = &self.model.pous[member as usize];
        self.check_access(span, entry);
        let owner = entry.owner.map(|owner| self.model.pous[owner as usize].pou.kind);
        let is_promise = !entry.has_body(self.model);
        let may_differ = is_promise || entry.is_overridden && !self.is_exact(receiver);
        let location = match receiver {
            Receiver::This | Receiver::Super => Location::Instance(0),
            Receiver::Instance(id) if owner == Some(PouKind::Interface) => {
                let value = self.value(id, None);
                if value.ty == TypeId::ERROR {
                    return None;
                }
                self.pinned(VariablePlace::new(Location::Stack, value.ty), span)
            }
            Receiver::Instance(id) => {
                let place = self.place(id)?;
                self.pinned(place, span)
            }
        };
        match (receiver, entry.dispatch) {
            (Receiver::Super, _) if is_promise => {
                let message = format!("`{}` is ABSTRACT in what is extended", entry.pou.name.text);
                self.report(Code::InheritanceInvalid, span, message);
                None
            }
            (_, Some(dispatch)) if may_differ => Some((dispatch.frame, Entrance::Dispatched(location))),
            _ => {
                self.note_call(member, span);
                Some((member, Entrance::Method(location)))
            }
        }
    }

    /// Returns whether the members of an instance are those of its declared type, and of none that is derived from it.
    fn is_exact(&self, receiver: Receiver) -> bool {
        let Receiver::Instance(id) = receiver else {
            return matches!(receiver, Receiver::Super);
        };
        match self.expression(self.model.source.bare(id)).kind {
            ExpressionKind::Name(name) => {
                let variable = self.variable(name.text);
                variable.is_some_and(|(_, variable)| variable.kind != VariableKind::InOut)
            }
            ExpressionKind::Field { .. } | ExpressionKind::Index { .. } => true,
            _ => false,
        }
    }

    /// Adds the call itself, the arguments having been passed.
    pub(super) fn emit_entrance(&mut self, span: Span, callee: u32, entrance: Entrance) {
        let body = self.model.pous[callee as usize].body;
        match entrance {
            Entrance::Function => self.emit(Instruction::Call(body)),
            Entrance::Method(location) => {
                self.push_address(location);
                self.emit(Instruction::CallInstance(body));
            }
            Entrance::Dispatched(location) => {
                self.push_address(location);
                self.emit_at(span, Instruction::CallMethod(callee));
            }
        }
    }

    /// Reports a member that may not be used here.
    fn check_access(&mut self, span: Span, entry: &PouEntry<'_>) {
        let (Some(owner), own) = (entry.owner, self.own_pou()) else {
            return;
        };
        let (may, word) = match entry.pou.modifiers.access {
            Some(Access::Private) => (own == Some(owner), "PRIVATE"),
            Some(Access::Protected) => (own.is_some_and(|own| self.model.extends(own, owner)), "PROTECTED"),
            _ => (true, ""),
        };
        if !may {
            let block = self.model.pous[owner as usize].pou.name.text;
            let message = format!("`{}` is {word} in `{block}`", entry.pou.name.text);
            self.report(Code::MemberNotAccessible, span, message);
        }
    }

    /// Makes the routine that takes arguments out of the frame that several methods share, calls one of them, and takes results back.
    pub(super) fn dispatch_routine(&mut self, entry: &'m PouEntry<'m>, program: &mut MachineProgram) {
        let (Some(dispatch), Some(owner)) = (entry.dispatch, entry.owner) else {
            return;
        };
        let model = self.model;
        let shared = &model.pous[dispatch.frame as usize];
        let outputs = |entry: &PouEntry<'_>| {
            let range = entry.variables.clone();
            range.filter(|&index| model.variable(index).kind == VariableKind::Output)
        };
        self.emitter.begin(dispatch.routine);
        self.emitter.set_line(0);
        for (&from, &to) in shared.parameters.iter().zip(&entry.parameters) {
            self.copy_variable(from, to);
        }
        self.emit(Instruction::InstanceAddress(0));
        self.emit(Instruction::CallInstance(entry.body));
        for (from, to) in outputs(entry).zip(outputs(shared)) {
            self.copy_variable(from, to);
        }
        self.emit(Instruction::Return);
        let key = (owner + 1, dispatch.frame);
        program.methods.insert(key, dispatch.routine);
    }

    /// Copies a variable of one frame to another; of a VAR_IN_OUT, the address, and of an ARRAY[*] the limits.
    fn copy_variable(&mut self, from: u32, to: u32) {
        let model = self.model;
        let limits = model.variable(from).limits;
        let [from, to] = [from, to].map(|index| self.outside(&model.variables[index as usize], None));
        for cell in 0..=limits {
            let [from, to] = [from, to].map(|place| VariablePlace {
                location: self.shifted(place.location, cell),
                ..place
            });
            self.begin_store(to);
            self.load(from);
            self.finish_store(to, Span::default());
        }
    }

    /// Returns the method that an expression calls.
    pub(super) fn called_method(&mut self, id: ExpressionId) -> Option<Callee> {
        let used = self.used_member(id)?;
        let method = used.member.method?;
        Some(Callee::Method(used.receiver, method))
    }
}
