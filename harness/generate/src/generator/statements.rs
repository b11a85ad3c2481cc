//! Generation of statements other than loops.

use super::TypeContext;
use super::builder::ProgramBuilder;
use super::constructs::Construct;
use crate::model::{
    Argument, CaseBranch, CaseLabel, Expression, LiteralForm, Statement, Type, VariableId, VariableSection,
    integer,
};
use stickler_types::{ElementaryType, Value};

const TIME: Type = Type::Elementary(ElementaryType::Time);

/// The kinds of statements that the generator chooses from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum StatementForm {
    Assign,
    AssignBit,
    If,
    Case,
    For,
    While,
    Repeat,
    Invoke,
    Leave,
}

impl ProgramBuilder<'_, '_> {
    /// Generates the statements of a POU: at most `most`, fewer if the bytes run out.
    pub fn body(&mut self, most: usize) -> Vec<Statement> {
        let mut made = Vec::new();
        while made.is_empty()
            || (made.len() < most && self.statements_left > 0 && !self.random.is_exhausted())
        {
            self.statement(0, &mut made);
        }
        made
    }

    /// Generates the statements of a branch or a loop, at least one.
    pub fn nested(&mut self, depth: usize) -> Vec<Statement> {
        let mut made = Vec::new();
        loop {
            self.statement(depth, &mut made);
            if made.len() >= 5 || self.statements_left == 0 || !self.random.chance(1, 2) {
                return made;
            }
        }
    }

    /// Starts a statement and resets its node budget.
    pub fn begin_statement(&mut self) {
        self.nodes_left = if self.has(Construct::Deep) && self.random.chance(1, 8) {
            60
        } else {
            12
        };
        self.text_bound = VariableId(usize::MAX);
    }

    /// Generates a statement, and those that have to stand beside it.
    fn statement(&mut self, depth: usize, made: &mut Vec<Statement>) {
        self.statements_left = self.statements_left.saturating_sub(1);
        self.begin_statement();
        self.spend(1);
        let kind = match self.choice(depth) {
            StatementForm::Assign => self.assignment(),
            StatementForm::AssignBit => self.assigned_bit(),
            StatementForm::If => Some(self.branches(depth)),
            StatementForm::Case => self.case(depth),
            StatementForm::For => return self.for_loop(depth, made),
            StatementForm::While => return self.while_loop(depth, made),
            StatementForm::Repeat => return self.repeat_loop(depth, made),
            StatementForm::Invoke => self.invocation(),
            StatementForm::Leave => Some(self.leave()),
        };
        if let Some(kind) = kind.or_else(|| self.assignment()) {
            made.push(kind);
        } else {
            self.assign_reserved(made);
        }
    }

    /// Generates an assignment to a reserved variable, where nothing else can be written.
    fn assign_reserved(&mut self, made: &mut Vec<Statement>) {
        let variable = self.reserved(ElementaryType::Int);
        made.push(self.reset(variable, ElementaryType::Int));
    }

    fn choice(&mut self, depth: usize) -> StatementForm {
        use StatementForm as S;
        let deepest = if self.has(Construct::Nested) { 4 } else { 2 };
        let nests = depth < deepest && self.statements_left > 0;
        let loops = nests && self.pou.loops_around < 3 && self.affords(8);
        let weight = |offered: bool, weight: u16| if offered { weight } else { 0 };
        let instances = self
            .pou
            .variables
            .iter()
            .any(|variable| matches!(variable.ty, Type::Block(_)));
        let may_leave = (self.pou.loops_around > 0 && self.has(Construct::Exit))
            || (!self.is_main && self.has(Construct::Return));
        let bits = self.has(Construct::Bits) && self.profile.has_bits(self.open);
        let choices = [
            (S::Assign, 12),
            (S::AssignBit, weight(bits, 4)),
            (S::If, weight(nests && self.has(Construct::If), 5)),
            (S::Case, weight(nests && self.has(Construct::Case), 4)),
            (S::For, weight(loops && self.has(Construct::For), 3)),
            (S::While, weight(loops && self.has(Construct::While), 2)),
            (S::Repeat, weight(loops && self.has(Construct::Repeat), 2)),
            (S::Invoke, weight(instances, 6)),
            (S::Leave, weight(depth > 0 && may_leave, 2)),
        ];
        let weights = choices.map(|(_, weight)| weight);
        choices[self.random.weighted(&weights)].0
    }

    fn branches(&mut self, depth: usize) -> Statement {
        let mut branches = Vec::new();
        for _ in 0..=self.random.weighted(&[5, 2, 1]) {
            self.begin_statement();
            let condition = self.condition();
            branches.push((condition, self.nested(depth + 1)));
        }
        let otherwise = self.random.chance(1, 2).then(|| self.nested(depth + 1));
        Statement::If(branches, otherwise)
    }

    /// Generates CASE of an enumeration or an integer.
    fn case(&mut self, depth: usize) -> Option<Statement> {
        let selector = self.enumeration_selector();
        let (selector, labels) = match selector {
            Some((selector, count)) => {
                let labels = self.enumerated_labels(&selector.ty, count);
                (selector, labels)
            }
            None => self.integer_selector()?,
        };
        let branches = labels.into_iter().map(|labels| CaseBranch {
            labels,
            body: self.nested(depth + 1),
        });
        let branches = branches.collect();
        let otherwise = self.random.chance(1, 2).then(|| self.nested(depth + 1));
        Some(Statement::Case(selector, branches, otherwise))
    }

    fn enumeration_selector(&mut self) -> Option<(Expression, usize)> {
        if !self.has(Construct::Enumerations) || !self.random.chance(1, 2) {
            return None;
        }
        let is_enumeration = |place: &usize| {
            let ty = Type::Declared(*place);
            self.program.enumerated_values(&ty).is_some() && self.pou.places.iter().any(|seen| seen.ty == ty)
        };
        let enumerations: Vec<usize> = (0..self.program.types.len()).filter(is_enumeration).collect();
        let ty = Type::Declared(*self.random.pick(&enumerations)?);
        let count = self.program.enumerated_values(&ty)?.len();
        Some((self.read(&ty, true)?, count))
    }

    /// Spreads the names of an enumeration over branches; some are left to ELSE.
    fn enumerated_labels(&mut self, ty: &Type, count: usize) -> Vec<Vec<CaseLabel>> {
        let mut branches: Vec<Vec<CaseLabel>> = Vec::new();
        for value in 0..count {
            if !branches.is_empty() && self.random.chance(1, 4) {
                continue;
            }
            let label = CaseLabel::One(Expression::enumerated(ty, value));
            match branches.last_mut() {
                Some(last) if self.random.chance(1, 3) => last.push(label),
                _ => branches.push(vec![label]),
            }
        }
        branches
    }

    /// Generates an integer selector, and labels near its likely values, no number twice.
    fn integer_selector(&mut self) -> Option<(Expression, Vec<Vec<CaseLabel>>)> {
        let integers: Vec<ElementaryType> = self
            .palette
            .iter()
            .copied()
            .filter(|ty| ty.is_integer() && self.pou.varies(*ty))
            .collect();
        let &ty = self.random.pick(&integers)?;
        let selector = self
            .varying(ty, 2)
            .unwrap_or_else(|| self.value(ty, TypeContext::Exact, 2));
        let (least, greatest) = ty.integer_range()?;
        // Labels ascend, so that none overlaps another.
        let starts = [0, least, -3, greatest - 20];
        let mut next = starts[self.random.weighted(&[8, 1, 4, 1])].max(least);
        let mut branches: Vec<Vec<CaseLabel>> = Vec::new();
        for _ in 0..=self.random.below(4) {
            let mut labels = Vec::new();
            for _ in 0..=self.random.weighted(&[4, 2, 1]) {
                let low = next + self.random.below(3) as i128;
                let high = low + self.random.weighted(&[4, 1, 1, 1]) as i128;
                if high > greatest {
                    break;
                }
                let number = |number: i128| integer(ty, number as u64 as i64, LiteralForm::Untyped);
                labels.push(if low == high {
                    CaseLabel::One(number(low))
                } else {
                    CaseLabel::Range(number(low), number(high))
                });
                next = high + 1;
            }
            if !labels.is_empty() {
                branches.push(labels);
            }
        }
        (!branches.is_empty()).then_some((selector, branches))
    }

    /// Generates a call of a function block.
    fn invocation(&mut self) -> Option<Statement> {
        let instances: Vec<(VariableId, usize)> = self
            .pou
            .variables
            .iter()
            .enumerate()
            .filter_map(|(place, variable)| match variable.ty {
                Type::Block(block) if !self.pou.locked.contains(&VariableId(place)) => {
                    Some((VariableId(place), block))
                }
                _ => None,
            })
            .collect();
        let &(instance, block) = self.random.pick(&instances)?;
        if !self.affords(self.block_costs[block]) {
            return None;
        }
        let parameters: Vec<(VariableId, VariableSection, Type)> = self.program.blocks[block]
            .variables
            .iter()
            .enumerate()
            .map(|(place, variable)| (VariableId(place), variable.section, variable.ty.clone()))
            .collect();
        let is_standard = self.program.blocks[block].standard;
        let mut inputs = Vec::new();
        let mut outputs = Vec::new();
        // The variables that the block may write, each once.
        let mut given = Vec::new();
        for (parameter, section, ty) in parameters {
            match section {
                // No document says what a timer makes of another PT while it runs, so each instance has one.
                VariableSection::Input if ty == TIME && is_standard => {
                    let time = Value::plain(ElementaryType::Time, (1 + instance.0 as u64 % 9) * 1_000_000);
                    let value = Expression::literal(ElementaryType::Time, time, LiteralForm::Untyped);
                    inputs.push(Argument { parameter, value });
                }
                VariableSection::Input if self.random.chance(3, 4) => {
                    // Texts that come out again could grow.
                    self.text_bound = VariableId(0);
                    let value = self.argument(&ty, 2);
                    inputs.push(Argument { parameter, value });
                }
                VariableSection::InOut => {
                    let ty = self.program.unaliased(&ty).clone();
                    let place = self.writable_part(&ty, &given)?;
                    given.push(place.variable);
                    let value = Expression::read(place);
                    inputs.push(Argument { parameter, value });
                }
                VariableSection::Output if self.random.chance(1, 2) => {
                    if let Some(place) = self.writable_part(&ty, &given) {
                        given.push(place.variable);
                        outputs.push((parameter, place));
                    }
                }
                _ => {}
            }
        }
        self.spend(self.block_costs[block]);
        Some(Statement::Invoke {
            instance,
            inputs,
            outputs,
        })
    }

    /// Generates a conditional EXIT or RETURN.
    fn leave(&mut self) -> Statement {
        let may_exit = self.pou.loops_around > 0 && self.has(Construct::Exit);
        let may_return = !self.is_main && self.has(Construct::Return);
        let kind = if may_exit && !(may_return && self.random.chance(1, 4)) {
            Statement::Exit
        } else {
            Statement::Return
        };
        let condition = self.condition();
        Statement::If(vec![(condition, vec![kind])], None)
    }
}
