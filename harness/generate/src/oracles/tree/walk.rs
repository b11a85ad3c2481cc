//! One way through a syntax tree: everything that a text can say, node after node, to whoever wants to know it.
//!
//! The structures are taken apart by all their fields, so that a new field cannot be forgotten here.

use super::declarations::declaration;
use super::expressions::expression;
use super::visitor::{Visitor, list};
use stickler_reference::syntax::tree::SourceUnit;

/// Tells everything in `unit`: first its expressions in the order of the arena, then its declarations.
pub(super) fn walk(unit: &SourceUnit<'_>, visitor: &mut impl Visitor) {
    let SourceUnit {
        declarations,
        expressions,
    } = unit;
    list(expressions, visitor, expression);
    list(declarations, visitor, declaration);
}
