//! Who is led through a syntax tree, and what every part of the way leans on.

use stickler_reference::source::Span;
use stickler_reference::syntax::tree::{ExpressionId, Name};

/// What is told on the way.
pub(super) trait Visitor {
    /// A node begins that stands at `span`; what comes until [`Visitor::leave`] is part of it.
    fn enter(&mut self, span: Span);
    /// The node that was entered last ends.
    fn leave(&mut self);
    /// Which form the node has, how many parts follow, a flag or an operator.
    fn number(&mut self, number: u64);
    /// A name or keyword as it is written.
    fn name(&mut self, name: &Name<'_>);
    /// What is written of a literal behind its prefix; `folded` where case does not matter.
    fn written(&mut self, text: &str, folded: bool);
    /// An expression of the arena that stands here.
    fn expression(&mut self, id: ExpressionId);
}

pub(super) fn list<T, V: Visitor>(items: &[T], visitor: &mut V, each: impl Fn(&T, &mut V)) {
    visitor.number(items.len() as u64);
    items.iter().for_each(|item| each(item, visitor));
}

pub(super) fn option<T: ?Sized, V: Visitor>(item: Option<&T>, visitor: &mut V, each: impl Fn(&T, &mut V)) {
    visitor.number(u64::from(item.is_some()));
    if let Some(item) = item {
        each(item, visitor);
    }
}

pub(super) fn id<V: Visitor>(id: &ExpressionId, visitor: &mut V) {
    visitor.expression(*id);
}

pub(super) fn range<V: Visitor>((low, high): &(ExpressionId, ExpressionId), visitor: &mut V) {
    visitor.expression(*low);
    visitor.expression(*high);
}

pub(super) fn name<V: Visitor>(name: &Name<'_>, visitor: &mut V) {
    visitor.name(name);
}
