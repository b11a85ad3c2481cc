//! The forms of expressions: the source and the target of `places.toml` that each is by itself.

use super::names::SourceNames;
use stickler_syntax::names::DeclaredName;
use stickler_syntax::tree::{
    CaseFolded, ExpressionId, ExpressionKind, Pou, PouKind, SourceUnit, TypeSpecification,
    TypeSpecificationKind, UnaryOperator, VariableBlock, VariableKind,
};

/// The forms of the expressions of a program organization unit.
pub(super) struct Forms<'w, 'u> {
    pub(super) unit: &'u SourceUnit<'u>,
    pub(super) names: &'w SourceNames<'u>,
    /// The unit around; `None` outside of all units.
    pub(super) pou: Option<&'u Pou<'u>>,
}

impl<'u> Forms<'_, 'u> {
    /// Returns whether an expression names an instance of a function block.
    pub(super) fn is_instance(&self, id: ExpressionId) -> bool {
        match &self.unit.expressions[id.0 as usize].kind {
            ExpressionKind::Name(name) => {
                let declared = self.variable(name.text);
                declared.is_some_and(|(_, specification)| self.names.is_block(specification))
            }
            _ => false,
        }
    }

    /// Returns the section and the type of a variable.
    fn variable(&self, name: &str) -> Option<(&'u VariableBlock<'u>, &'u TypeSpecification<'u>)> {
        let &DeclaredName { section, group, .. } = self.names.variable(self.pou, name)?;
        Some((section?, &group?.specification))
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
            ExpressionKind::Literal(literal) => literal.prefix().map_or("literal", |_| "typed-literal"),
            ExpressionKind::Call { callee, .. } => match &self.unit.expressions[callee.0 as usize].kind {
                ExpressionKind::Name(name) if self.names.pou(name.text).is_some() => "function-result",
                _ => "standard-function-result",
            },
            ExpressionKind::Bit { .. } => "bit",
            ExpressionKind::Name(name) => {
                let (block, specification) = self.variable(name.text)?;
                section(block.kind).unwrap_or(match block.retention {
                    _ if self.is_located(name.text) => "located",
                    _ if block.constant => "constant",
                    Some(CaseFolded(word)) if word.eq_ignore_ascii_case("RETAIN") => "retained",
                    _ => self.names.derived(specification).unwrap_or("variable"),
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
            ExpressionKind::Name(name)
                if self
                    .pou
                    .is_some_and(|pou| pou.kind == PouKind::Function && pou.name.is(name.text)) =>
            {
                "result"
            }
            ExpressionKind::Name(name) => {
                let (block, specification) = self.variable(name.text)?;
                section(block.kind).unwrap_or(match self.is_located(name.text) {
                    true => "located",
                    false => self.names.derived(specification).unwrap_or("assignment"),
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
                let variable = self.variable(name.text);
                let derived = variable.is_some_and(|(_, specification)| match &specification.kind {
                    TypeSpecificationKind::Array { element, .. } => self.names.derived(element).is_some(),
                    _ => false,
                });
                let in_out = variable.is_some_and(|(block, _)| block.kind == VariableKind::InOut);
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

    /// Returns whether a variable is directly represented: `x AT %MW5 : INT;`.
    fn is_located(&self, name: &str) -> bool {
        let declared = self.names.variable(self.pou, name).and_then(|one| one.group);
        declared.is_some_and(|group| group.location.is_some())
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
