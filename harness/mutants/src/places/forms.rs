//! The forms of expressions: the source and the target of `places.toml` that each is by itself.

use super::names::{DerivedForm, SectionVariable, SourceNames, Variables};
use stickler_syntax::tree::{ExpressionId, ExpressionKind, SourceUnit, UnaryOperator, VariableKind};

/// The forms of the expressions of a program organization unit.
pub(super) struct Forms<'w, 'u> {
    pub(super) unit: &'u SourceUnit<'u>,
    pub(super) names: &'w SourceNames<'u>,
    /// The variables of the unit around; none outside of all units.
    pub(super) variables: Variables<'u>,
}

impl Forms<'_, '_> {
    /// Returns whether an expression names an instance of a function block.
    pub(super) fn is_instance(&self, id: ExpressionId) -> bool {
        match &self.unit.expressions[id.0 as usize].kind {
            ExpressionKind::Name(name) => self
                .names
                .variable(&self.variables, name.text)
                .is_some_and(|variable| self.names.is_instance(variable)),
            _ => false,
        }
    }

    /// Returns what a bit is selected of; `None` where an expression selects none.
    fn selected_of(&self, id: ExpressionId) -> Option<ExpressionId> {
        match &self.unit.expressions[id.0 as usize].kind {
            ExpressionKind::Bit { base, .. } => Some(*base),
            // A form that the dialect does not have leaves its base before it.
            ExpressionKind::Error => refused_base(self.unit, id),
            _ => None,
        }
    }

    pub(super) fn base(&self, id: ExpressionId) -> Option<&'static str> {
        self.source(self.selected_of(id)?)
    }

    /// Returns the source that an expression is.
    pub(super) fn source(&self, id: ExpressionId) -> Option<&'static str> {
        Some(match &self.unit.expressions[id.0 as usize].kind {
            ExpressionKind::Parenthesized(_) => "parentheses",
            ExpressionKind::Binary { .. } => "sum",
            ExpressionKind::Unary { operator, .. } => match operator {
                UnaryOperator::Negate => "negation",
                UnaryOperator::Not => "complement",
                UnaryOperator::Plus => "plus",
            },
            ExpressionKind::Literal(literal) => match literal.prefix() {
                Some(_) => "typed-literal",
                None => "literal",
            },
            ExpressionKind::Call { callee, .. } => match &self.unit.expressions[callee.0 as usize].kind {
                ExpressionKind::Name(name) if self.names.pou(name.text).is_some() => "function-result",
                _ => "standard-function-result",
            },
            ExpressionKind::Bit { .. } => "bit",
            ExpressionKind::Name(name) => {
                let variable = self.names.variable(&self.variables, name.text)?;
                section(variable.kind).unwrap_or(match variable {
                    SectionVariable { located: true, .. } => "located",
                    SectionVariable { constant: true, .. } => "constant",
                    SectionVariable { retained: true, .. } => "retained",
                    _ => self.derived(variable).unwrap_or("variable"),
                })
            }
            ExpressionKind::Field { base, .. } if self.is_instance(*base) => "block-output",
            _ => self.part(id)?,
        })
    }

    /// Returns the target that an expression is.
    pub(super) fn target(&self, id: ExpressionId) -> Option<&'static str> {
        let id = self.selected_of(id).unwrap_or(id);
        Some(match &self.unit.expressions[id.0 as usize].kind {
            ExpressionKind::Name(name) if self.variables.is_result(name.text) => "result",
            ExpressionKind::Name(name) => {
                let variable = self.names.variable(&self.variables, name.text)?;
                section(variable.kind).unwrap_or(match variable.located {
                    true => "located",
                    false => self.derived(variable).unwrap_or("assignment"),
                })
            }
            ExpressionKind::Field { base, .. } if self.is_instance(*base) => "block-input-assigned",
            _ => self.part(id)?,
        })
    }

    /// Returns the place of an element of an array or a structure.
    fn part(&self, id: ExpressionId) -> Option<&'static str> {
        let (base, place) = match &self.unit.expressions[id.0 as usize].kind {
            ExpressionKind::Field { base, .. } => (*base, "field"),
            ExpressionKind::Index { base, subscripts } => {
                let constant = |id: &ExpressionId| {
                    let kind = &self.unit.expressions[id.0 as usize].kind;
                    matches!(kind, ExpressionKind::Literal(_) | ExpressionKind::Unary { .. })
                };
                match subscripts.iter().all(constant) {
                    true => (*base, "array-element"),
                    false => (*base, "array-element-by-variable"),
                }
            }
            _ => return None,
        };
        match &self.unit.expressions[base.0 as usize].kind {
            ExpressionKind::Name(name) => {
                let variable = self.names.variable(&self.variables, name.text);
                let derived = variable.is_some_and(|variable| self.names.has_derived_elements(variable));
                let in_out = variable.is_some_and(|variable| variable.kind == VariableKind::InOut);
                Some(match place {
                    _ if derived => "alias-element",
                    "field" if in_out => "field-of-in-out",
                    _ => place,
                })
            }
            ExpressionKind::Index { base, .. } if place == "field" && self.is_name(*base) => {
                Some("field-of-array-element")
            }
            _ => Some("path"),
        }
    }

    fn is_name(&self, id: ExpressionId) -> bool {
        matches!(self.unit.expressions[id.0 as usize].kind, ExpressionKind::Name(_))
    }

    /// Returns the place of a variable of a user-defined type, which is both a source and a target; `None` for other variables.
    fn derived(&self, variable: SectionVariable<'_>) -> Option<&'static str> {
        self.names.form_of(variable).map(|form| match form {
            DerivedForm::Alias => "alias",
            DerivedForm::Subrange => "subrange",
        })
    }
}

/// Returns what a form of partial access was applied to that the dialect does not have.
pub fn refused_base(unit: &SourceUnit<'_>, id: ExpressionId) -> Option<ExpressionId> {
    let before = ExpressionId(id.0.checked_sub(1)?);
    let span = |id: ExpressionId| unit.expressions.get(id.0 as usize).map(|found| found.span);
    let (base, whole) = (span(before)?, span(id)?);
    (base.start == whole.start && base.end < whole.end).then_some(before)
}

/// Returns the place of the variables of a section, which is both a source and a target; `None` for the variables of VAR.
const fn section(kind: VariableKind) -> Option<&'static str> {
    match kind {
        VariableKind::Local | VariableKind::Instance | VariableKind::Static | VariableKind::Configured => {
            None
        }
        VariableKind::Temporary => Some("temporary"),
        VariableKind::Input => Some("input"),
        VariableKind::Output => Some("output"),
        VariableKind::InOut => Some("in-out"),
        VariableKind::External => Some("external"),
        VariableKind::Global => Some("global"),
    }
}
