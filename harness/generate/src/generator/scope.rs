//! The POU under construction: its variables, its readable and writable places, and the cost of an execution.

use super::literals;
use crate::model::{
    Expression, ExpressionKind, PathStep, Program, Type, Variable, VariableId, VariableSection, visit,
};
use stickler_types::{ElementaryType, Value};

/// The POU under construction.
#[derive(Default)]
pub(super) struct PouScope {
    pub variables: Vec<Variable>,
    /// Every readable variable, element and part.
    pub places: Vec<VisiblePlace>,
    /// Values that variables, or their parts, hold at some time.
    pub held: Vec<HeldValue>,
    /// The control variables of the enclosing FOR loops, with the values that they take.
    pub loops: Vec<(VariableId, ElementaryType, i64, i64)>,
    /// The control variables that no loop uses at the moment.
    pub idle: Vec<(VariableId, ElementaryType)>,
    /// Variables that must keep their values here, because a loop ends by them.
    pub locked: Vec<VariableId>,
    /// The number of enclosing loops.
    pub loops_around: usize,
    /// The maximum number of executions of the current position in one call.
    pub turns: u32,
    /// The maximum number of statements that one call executes, including those of called functions.
    pub cost: u32,
}

/// A readable place.
#[derive(Clone, Debug)]
pub(super) struct VisiblePlace {
    pub variable: VariableId,
    pub path: Vec<PathStep>,
    /// The type of the place, with aliases resolved.
    pub ty: Type,
    pub writable: bool,
    /// Whether a compiler may know the value.
    pub constant: bool,
}

impl VisiblePlace {
    /// Returns whether a reference leads to the place.
    pub fn is_followed(&self) -> bool {
        self.path.contains(&PathStep::Followed)
    }
}

/// A value that a variable, or an elementary part of it, gets from a literal: at the start, or by an assignment.
#[derive(Clone, Debug)]
pub(super) struct HeldValue {
    pub variable: VariableId,
    pub ty: ElementaryType,
    pub value: Value,
}

impl PouScope {
    /// Returns the scope of a unit without variables, at the first of whose statements each call comes once.
    pub fn new() -> PouScope {
        PouScope {
            turns: 1,
            ..PouScope::default()
        }
    }

    /// Declares a variable that statements may use; of an instance of a function block only the outputs are visible.
    pub fn declare(&mut self, variable: Variable, program: &Program) -> VariableId {
        let id = VariableId(self.variables.len());
        let writable = matches!(
            variable.section,
            VariableSection::Local | VariableSection::Output | VariableSection::InOut
        );
        let constant = variable.section == VariableSection::Constant;
        let seen = VisiblePlace {
            variable: id,
            path: Vec::new(),
            ty: variable.ty.clone(),
            writable,
            constant,
        };
        self.see(seen, program);
        self.hold_initial(id, &variable);
        self.variables.push(variable);
        id
    }

    fn hold_initial(&mut self, id: VariableId, variable: &Variable) {
        match (&variable.initial, &variable.ty) {
            (Some(initial), _) => visit::initial_values(initial)
                .into_iter()
                .for_each(|value| self.hold(id, value)),
            (None, &Type::Elementary(ty)) => {
                let zero = literals::boundaries(ty).first().cloned();
                self.held.extend(zero.map(|value| HeldValue {
                    variable: id,
                    ty,
                    value,
                }));
            }
            (None, _) => {}
        }
    }

    /// Records that a variable, or a part of it, gets the value of an expression, if that is a literal.
    pub fn hold(&mut self, variable: VariableId, value: &Expression) {
        if let (ExpressionKind::Literal(value, _), &Type::Elementary(ty)) = (&value.kind, &value.ty) {
            let value = value.clone();
            self.held.push(HeldValue { variable, ty, value });
        }
    }

    /// Declares a variable that statements may read but not write, because the generator needs it for itself.
    pub fn declare_reserved(&mut self, name: String, ty: ElementaryType) -> VariableId {
        let id = VariableId(self.variables.len());
        self.places.push(VisiblePlace {
            variable: id,
            path: Vec::new(),
            ty: Type::Elementary(ty),
            writable: false,
            constant: false,
        });
        self.variables.push(Variable {
            name,
            ty: Type::Elementary(ty),
            section: VariableSection::Local,
            initial: None,
        });
        id
    }

    /// Records a place and all its parts.
    fn see(&mut self, place: VisiblePlace, program: &Program) {
        for (step, _, ty) in program.parts(&place.ty) {
            let writable = place.writable && !matches!(step, PathStep::Output(_));
            let part = VisiblePlace {
                path: [&place.path[..], &[step]].concat(),
                ty: ty.clone(),
                writable,
                ..place.clone()
            };
            self.see(part, program);
        }
        let ty = program.unaliased(&place.ty).clone();
        // An array type without a name is a type of its own, so no other array can be assigned as a whole.
        let named = !matches!(place.ty, Type::Array(_) | Type::Block(_));
        if named {
            self.places.push(VisiblePlace { ty, ..place });
        }
    }

    /// Returns whether a place may be written here.
    pub fn may_write(&self, place: &VisiblePlace) -> bool {
        // What a reference leads to may be locked.
        let may_be_locked = self.locked.contains(&place.variable) || place.is_followed();
        place.writable && (self.locked.is_empty() || !may_be_locked)
    }

    /// Returns whether a value of a type can be read that no compiler knows.
    pub fn varies(&self, ty: ElementaryType) -> bool {
        let wanted = Type::Elementary(ty);
        self.places
            .iter()
            .any(|place| !place.constant && place.ty == wanted)
    }
}

/// Returns whether a type is a text or contains one.
pub(super) fn contains_text(ty: &Type, program: &Program) -> bool {
    match program.unaliased(ty) {
        Type::Elementary(ty) => ty.is_text(),
        Type::Block(_) => false,
        ty => {
            let parts = program.parts(ty);
            parts.iter().any(|(.., part)| contains_text(part, program))
        }
    }
}
