//! Writing of the statements of the model as source text.

use super::source_writer::SourceWriter;
use crate::model::{
    Argument, AssignmentTarget, CaseBranch, CaseLabel, Expression, ForLoop, Place, Statement, Type, Variable,
    VariableId,
};

/// The POU whose statements are written.
#[derive(Clone, Copy)]
pub(super) struct PouText<'p> {
    pub variables: &'p [Variable],
    /// The name of the result of a function.
    pub result: &'p str,
}

impl SourceWriter<'_> {
    /// Writes statements, each on a line of its own, one step deeper; an empty statement for an empty list, because the
    /// standard demands a statement.
    pub fn statements(&mut self, statements: &[Statement], pou: PouText<'_>) {
        self.deeper();
        for statement in statements {
            self.new_line();
            self.statement(statement, pou);
        }
        if statements.is_empty() {
            self.new_line();
            self.put(";");
        }
        self.shallower();
    }

    fn statement(&mut self, statement: &Statement, pou: PouText<'_>) {
        match statement {
            Statement::Assign(target, value) => {
                self.target(target, pou);
                self.between_blanks(":=");
                self.expression(value, pou.variables);
            }
            Statement::If(branches, otherwise) => self.branches(branches, otherwise.as_deref(), pou),
            Statement::Case(selector, branches, otherwise) => {
                self.case(selector, branches, otherwise.as_deref(), pou);
            }
            Statement::For(parts) => {
                self.for_head(parts, pou);
                self.statements(&parts.body, pou);
                self.closing("END_FOR");
            }
            Statement::While(condition, body) => {
                self.word("WHILE");
                self.blank();
                self.expression(condition, pou.variables);
                self.blank();
                self.word("DO");
                self.statements(body, pou);
                self.closing("END_WHILE");
            }
            Statement::Repeat(body, condition) => {
                self.word("REPEAT");
                self.statements(body, pou);
                self.closing("UNTIL");
                self.blank();
                self.expression(condition, pou.variables);
                self.closing("END_REPEAT");
            }
            Statement::Invoke {
                instance,
                inputs,
                outputs,
            } => self.invocation(*instance, inputs, outputs, pou),
            Statement::Exit => self.word("EXIT"),
            Statement::Return => self.word("RETURN"),
            Statement::Raw(text) => return self.raw(text),
        }
        self.put(";");
    }

    fn closing(&mut self, keyword: &str) {
        self.new_line();
        self.word(keyword);
    }

    fn target(&mut self, target: &AssignmentTarget, pou: PouText<'_>) {
        match target {
            AssignmentTarget::Place(place) => self.place(place, pou.variables),
            AssignmentTarget::Bit(place, bit) => self.bit(place, *bit, pou.variables),
            AssignmentTarget::Result => self.put(pou.result),
        }
    }

    fn branches(
        &mut self,
        branches: &[(Expression, Vec<Statement>)],
        otherwise: Option<&[Statement]>,
        pou: PouText<'_>,
    ) {
        for (number, (condition, body)) in branches.iter().enumerate() {
            if number == 0 {
                self.word("IF");
            } else {
                self.closing("ELSIF");
            }
            self.blank();
            self.expression(condition, pou.variables);
            self.blank();
            self.word("THEN");
            self.statements(body, pou);
        }
        self.otherwise(otherwise, pou);
        self.closing("END_IF");
    }

    fn otherwise(&mut self, otherwise: Option<&[Statement]>, pou: PouText<'_>) {
        if let Some(body) = otherwise {
            self.closing("ELSE");
            self.statements(body, pou);
        }
    }

    fn case(
        &mut self,
        selector: &Expression,
        branches: &[CaseBranch],
        otherwise: Option<&[Statement]>,
        pou: PouText<'_>,
    ) {
        self.word("CASE");
        self.blank();
        self.expression(selector, pou.variables);
        self.blank();
        self.word("OF");
        self.deeper();
        for branch in branches {
            self.new_line();
            self.list(&branch.labels, |writer, label| writer.label(label, pou));
            self.put(":");
            self.statements(&branch.body, pou);
        }
        self.shallower();
        self.otherwise(otherwise, pou);
        self.closing("END_CASE");
    }

    /// Writes a label, whose numbers the second edition writes in decimal digits only.
    fn label(&mut self, label: &CaseLabel, pou: PouText<'_>) {
        let notation = std::mem::take(&mut self.style.notation);
        match label {
            CaseLabel::One(value) => self.expression(value, pou.variables),
            CaseLabel::Range(low, high) => {
                self.expression(low, pou.variables);
                self.put("..");
                self.expression(high, pou.variables);
            }
        }
        self.style.notation = notation;
    }

    fn for_head(&mut self, parts: &ForLoop, pou: PouText<'_>) {
        let ForLoop {
            variable,
            from,
            to,
            by,
            ..
        } = parts;
        self.word("FOR");
        self.blank();
        if let Some(variable) = pou.variables.get(variable.0) {
            self.put(&variable.name);
        }
        self.between_blanks(":=");
        self.expression(from, pou.variables);
        self.between_blanks("TO");
        self.expression(to, pou.variables);
        if let Some(by) = by {
            self.between_blanks("BY");
            self.expression(by, pou.variables);
        }
        self.blank();
        self.word("DO");
    }

    fn invocation(
        &mut self,
        instance: VariableId,
        inputs: &[Argument],
        outputs: &[(VariableId, Place)],
        pou: PouText<'_>,
    ) {
        let Some(variable) = pou.variables.get(instance.0) else {
            return;
        };
        let program = self.program;
        let parameters = match variable.ty {
            Type::Block(block) => program
                .blocks
                .get(block)
                .map_or(&[][..], |block| &block.variables),
            _ => &[],
        };
        self.put(&variable.name);
        self.put("(");
        self.list(inputs, |writer, input| {
            writer.parameter(parameters, input);
            writer.expression(&input.value, pou.variables);
        });
        for (number, (output, place)) in outputs.iter().enumerate() {
            if number > 0 || !inputs.is_empty() {
                self.comma();
            }
            if let Some(output) = parameters.get(output.0) {
                self.put(&output.name);
            }
            self.between_blanks("=>");
            self.place(place, pou.variables);
        }
        self.put(")");
    }
}
