//! Links methods and properties with those of bases and interfaces that they stand for, checks that they fit, and gives those that the
//! running program chooses among a frame in which all of them are called.
//!
//! Basis: iec-61131-3: third edition, 6.6.5 to 6.6.8; codesys-pages: _cds_implementing_interface.

use super::declare::Declarer;
use super::model::{Dispatch, Member};
use super::types::TypeId;
use stickler_syntax::source::{Span, saturating_u32};
use stickler_syntax::tree::{Access, CaseFolded, PouKind, VariableKind};
use stickler_types::Code;

/// The most members of interfaces and of ABSTRACT blocks that are looked for in all blocks of a text together.
const MAX_PROMISES: usize = 1 << 20;

/// The members of a text in groups, each of which is called through one frame.
struct Groups {
    /// Another member of the group, itself for the one that stands for all.
    leaders: Vec<u32>,
    promises: usize,
}

impl Groups {
    fn leader(&mut self, mut member: u32) -> u32 {
        while self.leaders[member as usize] != member {
            let next = self.leaders[self.leaders[member as usize] as usize];
            self.leaders[member as usize] = next;
            member = next;
        }
        member
    }
}

impl<'u> Declarer<'u, '_> {
    /// Links all members with those that they override or implement.
    pub(super) fn link_members(&mut self) {
        if !self.model.has_members {
            return;
        }
        let count = self.model.pous.len();
        let mut groups = Groups {
            leaders: (0..saturating_u32(count)).collect(),
            promises: 0,
        };
        for index in 0..count {
            if self.model.pous[index].owner.is_some() {
                self.link_with_base(saturating_u32(index), &mut groups);
            }
        }
        for index in 0..count {
            let kind = self.model.pous[index].pou.kind;
            if matches!(kind, PouKind::FunctionBlock | PouKind::Class) {
                self.check_promises(saturating_u32(index), &mut groups);
            }
        }
        self.make_frames(count, &mut groups);
    }

    /// Links a member with the one of the base that it overrides.
    fn link_with_base(&mut self, index: u32, groups: &mut Groups) {
        let entry = &self.model.pous[index as usize];
        let (pou, owner) = (entry.pou, entry.owner.unwrap_or_default());
        let name = pou.name;
        let around = &self.model.pous[owner as usize];
        let (outer, base) = (around.pou, around.base);
        if around.scope.contains_key(&CaseFolded(name.text)) || self.is_inherited(owner as usize, name) {
            let message = format!("`{}` is a variable of `{}`", name.text, outer.name.text);
            self.report(Code::SymbolDeclDuplicated, name.span, message);
        }
        if pou.modifiers.is_abstract && !outer.modifiers.is_abstract && outer.kind != PouKind::Interface {
            let message = "only an ABSTRACT function block or class has ABSTRACT members";
            self.report(Code::MemberQualifierInvalid, name.span, message);
        }
        let inherited = base.and_then(|base| self.model.member(base, name.text));
        let is_private =
            |part: u32| self.model.pous[part as usize].pou.modifiers.access == Some(Access::Private);
        let parts = inherited.map(Member::parts).unwrap_or_default();
        if parts.iter().flatten().all(|&part| is_private(part)) {
            // Of a base that is not known nothing is said.
            if pou.modifiers.is_override && (base.is_some() || outer.extends.is_empty()) {
                let message = format!("`{}` overrides nothing", name.text);
                self.report(Code::InheritanceInvalid, name.span, message);
            }
            return;
        }
        let [method, getter, setter] = parts;
        let same = match pou.kind {
            PouKind::Getter => getter.or(setter),
            PouKind::Setter => setter.or(getter),
            _ => method,
        };
        let Some(other) = same else {
            let message = format!("`{}` overrides a member of another kind", name.text);
            return self.report(Code::InheritanceInvalid, name.span, message);
        };
        let overridden = &mut self.model.pous[other as usize];
        if overridden.pou.kind != pou.kind {
            return;
        }
        overridden.is_overridden = true;
        if overridden.pou.modifiers.is_final {
            let message = format!("`{}` is FINAL in what is extended", name.text);
            self.report(Code::InheritanceInvalid, name.span, message);
        }
        self.link(index, other, name.span, groups);
    }

    /// Puts two members into one group, and reports a difference of their parameters and results.
    fn link(&mut self, member: u32, other: u32, place: Span, groups: &mut Groups) {
        let (one, two) = (groups.leader(member), groups.leader(other));
        let is_prototype = |index: u32| {
            let owner = self.model.pous[index as usize].owner;
            owner.is_some_and(|owner| self.model.pous[owner as usize].pou.kind == PouKind::Interface)
        };
        let (leader, led) = if is_prototype(one) { (one, two) } else { (two, one) };
        groups.leaders[led as usize] = leader;
        let [own, others] = [member, other].map(|index| self.signature(index));
        let difference = own
            .zip(others)
            .and_then(|(own, others)| difference(&own, &others));
        if let Some(difference) = difference {
            let entry = &self.model.pous[other as usize];
            let owner = self.model.pous[entry.owner.unwrap_or(other) as usize].pou;
            let (name, owner) = (entry.pou.name.text, owner.name.text);
            let message = format!("`{name}` has not the {difference} that it has in `{owner}`");
            self.report(Code::InheritanceInvalid, place, message);
        }
    }

    /// Returns the parameters and the result of a member, `None` where a type of theirs is not known.
    fn signature(&self, index: u32) -> Option<Signature<'u>> {
        let entry = &self.model.pous[index as usize];
        let variables = entry.variables.clone().map(|index| self.model.variable(index));
        let parameters = variables.filter(|variable| {
            let kind = variable.kind;
            matches!(
                kind,
                VariableKind::Input | VariableKind::Output | VariableKind::InOut
            )
        });
        let typed = parameters.map(|variable| {
            let ty = self.model.types.root(variable.ty);
            (ty != TypeId::ERROR).then_some((CaseFolded(variable.name.text), variable.section, ty))
        });
        typed.collect()
    }

    /// Reports the first method or property that a block must have and does not, and links the others.
    fn check_promises(&mut self, index: u32, groups: &mut Groups) {
        let entry = &self.model.pous[index as usize];
        let is_abstract = entry.pou.modifiers.is_abstract;
        let mut waiting = entry.interfaces.clone();
        let mut base = entry.base;
        // What the base has not done yet because it is ABSTRACT is left to this block.
        while let Some(next) = base {
            let above = &self.model.pous[next as usize];
            if !above.pou.modifiers.is_abstract {
                break;
            }
            waiting.push(next);
            waiting.extend(&above.interfaces);
            base = above.base;
        }
        while let Some(promising) = waiting.pop() {
            let above = &self.model.pous[promising as usize];
            if above.pou.kind == PouKind::Interface {
                waiting.extend(&above.interfaces);
            }
            let members: Vec<Member> = above
                .pou
                .members
                .iter()
                .filter_map(|part| above.members.get(&CaseFolded(part.name.text)).copied())
                .collect();
            for promised in members {
                groups.promises += 1;
                if groups.promises == MAX_PROMISES {
                    let place = self.model.pous[index as usize].pou.name.span;
                    let message = "too many methods are demanded of blocks to look for all of them";
                    self.report(Code::LimitExceeded, place, message);
                }
                if groups.promises >= MAX_PROMISES {
                    return;
                }
                if !self.keeps(index, promised, groups) && !is_abstract {
                    return self.report_missing(index, promising, promised);
                }
            }
        }
    }

    /// Links the parts of a member with those that a block has; says whether it has them all, with bodies.
    fn keeps(&mut self, block: u32, promised: Member, groups: &mut Groups) -> bool {
        let mut keeps = true;
        for (part, number) in promised.parts().into_iter().zip(0..) {
            let Some(part) = part.filter(|&part| !self.model.pous[part as usize].has_body(&self.model))
            else {
                continue;
            };
            let name = self.model.pous[part as usize].pou.name.text;
            let found = self
                .model
                .member(block, name)
                .and_then(|member| member.parts()[number]);
            match found.filter(|&found| self.model.pous[found as usize].has_body(&self.model)) {
                Some(found) if groups.leader(found) != groups.leader(part) => {
                    let place = self.model.pous[found as usize].pou.name.span;
                    self.link(found, part, place, groups);
                }
                Some(_) => {}
                None => keeps = false,
            }
        }
        keeps
    }

    fn report_missing(&mut self, block: u32, promising: u32, promised: Member) {
        let part = promised.parts().into_iter().flatten().next().unwrap_or_default();
        let name = self.model.pous[part as usize].pou.name.text;
        let [block, above] = [block, promising].map(|index| self.model.pous[index as usize].pou);
        let what = promised.method.map_or("property", |_| "method");
        let (own, above) = (block.name.text, above.name.text);
        let message = format!("`{own}` has not the {what} `{name}` that `{above}` demands");
        self.report(Code::InterfaceMemberMissing, block.name.span, message);
    }

    /// Gives each group of members, and each member of an interface, the frame through which it is called.
    fn make_frames(&mut self, count: usize, groups: &mut Groups) {
        let mut frames = vec![None; count];
        let muted = self.reporter.mute(true);
        for index in 0..saturating_u32(count) {
            let entry = &self.model.pous[index as usize];
            let leader = groups.leader(index);
            let is_alone = leader == index && entry.has_body(&self.model) && !entry.is_overridden;
            if entry.owner.is_none() || is_alone {
                continue;
            }
            let frame = match frames[leader as usize] {
                Some(frame) => frame,
                None => {
                    let of = &self.model.pous[leader as usize];
                    let frame = self.add_pou(of.pou, None, of.owner);
                    self.model.pous[frame as usize].is_frame = true;
                    self.declare_variables(frame as usize);
                    frame
                }
            };
            frames[leader as usize] = Some(frame);
            let routine = self.routine();
            self.model.pous[index as usize].dispatch = Some(Dispatch { frame, routine });
        }
        self.resolve_deferred();
        self.reporter.mute(muted);
    }
}

/// The parameters of a member in order, its result among the outputs.
type Signature<'u> = Vec<(CaseFolded<'u>, VariableKind, TypeId)>;

/// Returns the first point in which two signatures differ.
fn difference(own: &Signature<'_>, other: &Signature<'_>) -> Option<&'static str> {
    let differ = |outputs| {
        let of_kind = |one: &&(_, VariableKind, _)| (one.1 == VariableKind::Output) == outputs;
        !own.iter().filter(of_kind).eq(other.iter().filter(of_kind))
    };
    let parts = [(false, "parameters"), (true, "result and outputs")];
    let differing = parts.into_iter().find(|(outputs, _)| differ(*outputs));
    differing.map(|(_, part)| part)
}
