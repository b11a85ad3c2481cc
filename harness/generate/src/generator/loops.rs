//! Loops, all of which terminate by construction.

use super::TypeContext;
use super::builder::ProgramBuilder;
use super::scope::VisiblePlace;
use crate::model::{
    BinaryOperator, Expression, ForLoop, LiteralForm, PathStep, StandardFunction, Statement, VariableId,
    assign, integer, whole,
};
use stickler_types::ElementaryType;

/// The maximum number of iterations of a loop.
const MAX_TURNS: i64 = 5;

/// The numbers that a FOR loop runs over.
struct LoopRange {
    from: i64,
    to: i64,
    by: i64,
}

impl ProgramBuilder<'_, '_> {
    /// Returns a variable of a type that is reserved for the generator.
    pub fn reserved(&mut self, ty: ElementaryType) -> VariableId {
        if let Some(place) = self.pou.idle.iter().position(|&(_, idle)| idle == ty) {
            return self.pou.idle.swap_remove(place).0;
        }
        let name = format!("i{}", self.pou.variables.len());
        self.pou.declare_reserved(name, ty)
    }

    /// Generates `variable := 0;`.
    pub fn reset(&mut self, variable: VariableId, ty: ElementaryType) -> Statement {
        let zero = integer(ty, 0, LiteralForm::Untyped);
        assign(variable, ty, zero)
    }

    /// Generates FOR, followed by an assignment to its variable, because no document states which value it holds then.
    pub fn for_loop(&mut self, depth: usize, made: &mut Vec<Statement>) {
        let ty = self.random.pick_where(&self.palette, |ty| ty.is_integer());
        let ty = ty.copied().unwrap_or(ElementaryType::Int);
        let LoopRange { from, to, by } = self.range(ty);
        let bounds = self.bounds(ty, from, to, by);
        let variable = self.reserved(ty);
        self.pou.hold(variable, &bounds.from);
        self.pou.hold(variable, &bounds.to);
        let turns = ((to - from) / by + 1).max(1) as u32;
        self.pou.loops.push((variable, ty, from.min(to), from.max(to)));
        let locked = self.pou.locked.len();
        self.pou.locked.extend(bounds.locked);
        let body = self.looped(depth, turns);
        self.pou.locked.truncate(locked);
        self.pou.loops.pop();
        made.push(Statement::For(ForLoop {
            variable,
            from: bounds.from,
            to: bounds.to,
            by: bounds.by,
            body,
        }));
        made.push(self.reset(variable, ty));
        self.pou.idle.push((variable, ty));
    }

    /// Draws a few numbers of an integer type: the subscripts of an array, or numbers near zero or near the limits of the
    /// type. The step after the last number stays within the type.
    fn range(&mut self, ty: ElementaryType) -> LoopRange {
        let range = |from, to, by| LoopRange { from, to, by };
        let (least, greatest) = limits(ty);
        if self.random.chance(1, 2)
            && let Some((low, high)) = self.dimension(least.saturating_add(1), greatest.saturating_sub(1))
        {
            return if ty.is_signed() && self.random.chance(1, 4) {
                range(high, low, -1)
            } else {
                range(low, high, 1)
            };
        }
        let turns = self.random.between(1, MAX_TURNS);
        let step = 1 + self.random.weighted(&[6, 1, 1]) as i64;
        let span = step * turns;
        let lowest = match self.random.weighted(&[6, 2, 1, 1]) {
            0 => self.random.between(0, 1),
            1 if ty.is_signed() => -self.random.between(1, 3),
            2 => least + span,
            3 => greatest - span - step,
            _ => 5,
        };
        let highest = lowest + span - step;
        if ty.is_signed() && self.random.chance(1, 4) {
            range(highest, lowest, -step)
        } else {
            range(lowest, highest, step)
        }
    }

    /// Picks the limits of a dimension of some array that lie between two numbers.
    fn dimension(&mut self, least: i64, greatest: i64) -> Option<(i64, i64)> {
        let limits = |seen: &VisiblePlace| match seen.path.last() {
            Some(PathStep::Index(limits)) => limits.last().copied(),
            _ => None,
        };
        let suits =
            |seen: &VisiblePlace| limits(seen).is_some_and(|(low, high)| least <= low && high <= greatest);
        self.random.pick_where(&self.pou.places, suits).and_then(limits)
    }

    /// Generates the expressions of a range. Sometimes a variable determines a limit, and the body then leaves it unchanged.
    fn bounds(&mut self, ty: ElementaryType, from: i64, to: i64, by: i64) -> LoopBounds {
        let mut bounds = LoopBounds {
            from: self.bound(ty, from),
            to: self.bound(ty, to),
            by: (by != 1 || self.random.chance(1, 8)).then(|| integer(ty, by, LiteralForm::Untyped)),
            locked: None,
        };
        let (low, high) = (from.min(to), from.max(to));
        if self.random.chance(1, 4)
            && let Some(limited) = self.limited(ty, low, high)
        {
            bounds.from = limited;
        }
        if self.random.chance(1, 4)
            && let Some(variable) = self.whole_variable(ty, |unreserved| unreserved.writable)
        {
            let limit = |number| integer(ty, number, LiteralForm::Typed);
            let arguments = vec![limit(low), whole(variable, ty), limit(high)];
            bounds.to = Expression::standard(StandardFunction::Limit, arguments, ty);
            bounds.locked = Some(variable);
        }
        bounds
    }

    fn bound(&mut self, ty: ElementaryType, number: i64) -> Expression {
        let form = self.form(ty, TypeContext::Assigned);
        integer(ty, number, form)
    }

    /// Generates WHILE, limited by a counter.
    pub fn while_loop(&mut self, depth: usize, made: &mut Vec<Statement>) {
        let condition = self.condition();
        let (counter, turns) = self.counter();
        let ty = ElementaryType::Int;
        let condition = limited(
            [BinaryOperator::And, BinaryOperator::Less],
            condition,
            counter,
            turns,
        );
        let mut body = vec![counted(counter)];
        body.extend(self.looped(depth, turns as u32));
        made.push(self.reset(counter, ty));
        made.push(Statement::While(condition, body));
        self.pou.idle.push((counter, ty));
    }

    /// Generates REPEAT, limited by a counter.
    pub fn repeat_loop(&mut self, depth: usize, made: &mut Vec<Statement>) {
        let (counter, turns) = self.counter();
        let ty = ElementaryType::Int;
        let mut body = vec![counted(counter)];
        body.extend(self.looped(depth, turns as u32));
        self.begin_statement();
        let condition = self.condition();
        let until = [BinaryOperator::Or, BinaryOperator::GreaterOrEqual];
        let condition = limited(until, condition, counter, turns);
        made.push(self.reset(counter, ty));
        made.push(Statement::Repeat(body, condition));
        self.pou.idle.push((counter, ty));
    }

    fn counter(&mut self) -> (VariableId, i64) {
        let counter = self.reserved(ElementaryType::Int);
        (counter, self.random.between(1, MAX_TURNS))
    }

    /// Generates the body of a loop with a number of iterations.
    fn looped(&mut self, depth: usize, turns: u32) -> Vec<Statement> {
        let before = self.pou.turns;
        self.pou.turns = before * turns;
        self.pou.loops_around += 1;
        let body = self.nested(depth + 1);
        self.pou.loops_around -= 1;
        self.pou.turns = before;
        body
    }
}

/// The limits and the step of a FOR loop.
struct LoopBounds {
    from: Expression,
    to: Expression,
    by: Option<Expression>,
    locked: Option<VariableId>,
}

/// Joins a condition, by the first operator, to the comparison of a counter with a number by the second.
fn limited(
    operators: [BinaryOperator; 2],
    condition: Expression,
    counter: VariableId,
    turns: i64,
) -> Expression {
    let [joins, compares] = operators;
    let limit = integer(ElementaryType::Int, turns, LiteralForm::Untyped);
    let compared = Expression::binary(
        compares,
        whole(counter, ElementaryType::Int),
        limit,
        ElementaryType::Bool,
    );
    Expression::binary(joins, condition, compared, ElementaryType::Bool)
}

/// Generates `counter := counter + 1;`.
fn counted(counter: VariableId) -> Statement {
    let ty = ElementaryType::Int;
    let one = integer(ty, 1, LiteralForm::Untyped);
    let next = Expression::binary(BinaryOperator::Add, whole(counter, ty), one, ty);
    assign(counter, ty, next)
}

/// Returns the limits of an integer type, as far as 64 signed bits hold them.
fn limits(ty: ElementaryType) -> (i64, i64) {
    let (least, greatest) = ty.integer_range().unwrap_or_default();
    (
        i64::try_from(least).unwrap_or(i64::MIN),
        i64::try_from(greatest).unwrap_or(i64::MAX),
    )
}
