//! Reads and writes of variables and their parts.

use super::builder::ProgramBuilder;
use super::scope::{VisiblePlace, contains_text};
use crate::model::{
    Expression, LiteralForm, PathStep, Place, PlaceSelector, StandardFunction, Type, VariableId, integer,
    whole,
};
use stickler_types::ElementaryType;

impl ProgramBuilder<'_, '_> {
    /// Generates a read of a place of exactly this type; `None` if there is none. With `varying`, only places whose value no
    /// compiler can know.
    pub fn read(&mut self, ty: &Type, varying: bool) -> Option<Expression> {
        let is_bound = contains_text(ty, &self.program);
        let bound = self.text_bound;
        let suits = |seen: &VisiblePlace| {
            seen.ty == *ty && !(varying && seen.constant) && !(is_bound && seen.variable >= bound)
        };
        let chosen = self.choose(suits)?;
        Some(Expression::read(self.place(&chosen, false)))
    }

    /// Picks a place that satisfies a predicate.
    pub fn choose(&mut self, suits: impl Fn(&VisiblePlace) -> bool) -> Option<VisiblePlace> {
        self.random.pick_where(&self.pou.places, suits).cloned()
    }

    /// Generates the subscripts of a place; `fixed` ones depend on no variable.
    pub fn place(&mut self, seen: &VisiblePlace, fixed: bool) -> Place {
        let path = seen.path.iter().map(|step| match step {
            PathStep::Field(field) => PlaceSelector::Field(*field),
            PathStep::Output(output) => PlaceSelector::Output(*output),
            PathStep::Followed => PlaceSelector::Followed,
            PathStep::Index(limits) => {
                let subscripts = limits.iter().map(|&(low, high)| self.subscript(low, high, fixed));
                PlaceSelector::Index(subscripts.collect())
            }
        });
        Place {
            path: path.collect(),
            variable: seen.variable,
            ty: seen.ty.clone(),
        }
    }

    /// Generates a subscript between two limits, both inclusive.
    fn subscript(&mut self, low: i64, high: i64, fixed: bool) -> Expression {
        let loops = self.pou.loops.iter();
        let inside = loops.filter(|&&(_, _, least, greatest)| low <= least && greatest <= high);
        let inside: Vec<(VariableId, ElementaryType)> =
            inside.map(|&(variable, ty, ..)| (variable, ty)).collect();
        if fixed {
            return self.number(low, high);
        }
        if !inside.is_empty() && self.random.chance(3, 4) {
            let (variable, ty) = inside[self.random.below(inside.len())];
            return whole(variable, ty);
        }
        if self.random.chance(1, 3) {
            let ty = self.integer_type(low, high);
            if let Some(limited) = self.limited(ty, low, high) {
                return limited;
            }
        }
        self.number(low, high)
    }

    /// Picks an integer type of the program that holds both numbers; INT if there is none.
    fn integer_type(&mut self, low: i64, high: i64) -> ElementaryType {
        let holds = |ty: &ElementaryType| {
            let range = ty.integer_range().filter(|_| ty.is_integer());
            range.is_some_and(|(least, greatest)| least <= i128::from(low) && i128::from(high) <= greatest)
        };
        let found = self.random.pick_where(&self.palette, holds);
        found.copied().unwrap_or(ElementaryType::Int)
    }

    fn number(&mut self, low: i64, high: i64) -> Expression {
        integer(
            ElementaryType::Int,
            self.random.between(low, high),
            LiteralForm::Untyped,
        )
    }

    /// Generates `LIMIT(low, variable, high)`; `None` if there is no variable of this integer type.
    pub fn limited(&mut self, ty: ElementaryType, low: i64, high: i64) -> Option<Expression> {
        // No compiler knows its value.
        let variable = self.whole_variable(ty, |seen| !seen.constant)?;
        let typed = |number| integer(ty, number, LiteralForm::Typed);
        let arguments = vec![typed(low), whole(variable, ty), typed(high)];
        Some(Expression::standard(StandardFunction::Limit, arguments, ty))
    }

    /// Picks a whole variable of a type that satisfies a predicate.
    pub fn whole_variable(
        &mut self,
        ty: ElementaryType,
        suits: fn(&VisiblePlace) -> bool,
    ) -> Option<VariableId> {
        let wanted = Type::Elementary(ty);
        let chosen = self.choose(|seen| seen.path.is_empty() && suits(seen) && seen.ty == wanted)?;
        Some(chosen.variable)
    }

    /// Picks a writable place of exactly this type, outside the variables `besides`; its subscripts are fixed.
    pub fn writable_part(&mut self, ty: &Type, besides: &[VariableId]) -> Option<Place> {
        let pou = &self.pou;
        let suits = |seen: &VisiblePlace| {
            seen.ty == *ty && pou.may_write(seen) && !seen.is_followed() && !besides.contains(&seen.variable)
        };
        let seen = self.random.pick_where(&pou.places, suits)?.clone();
        Some(self.place(&seen, true))
    }

    /// Picks a writable place that satisfies a predicate.
    pub fn target(&mut self, suits: impl Fn(&VisiblePlace) -> bool) -> Option<Place> {
        let pou = &self.pou;
        let suits = |seen: &VisiblePlace| pou.may_write(seen) && suits(seen);
        let seen = self.random.pick_where(&pou.places, suits)?.clone();
        Some(self.place(&seen, false))
    }
}
