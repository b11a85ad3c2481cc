//! Statements.

use super::writer::Writer;
use crate::tree::{CaseBranch, CaseLabel, ExpressionId, Statement, StatementKind};

impl<'u, 's> Writer<'u, 's> {
    /// Statements, one a line, at the present indent.
    pub(super) fn statements(&mut self, statements: &'u [Statement]) {
        for statement in statements {
            self.begin();
            self.statement(&statement.kind);
            self.put(";");
            self.end();
        }
    }

    fn block(&mut self, body: &'u [Statement]) {
        self.indented(|writer| writer.statements(body));
    }

    /// The first line has its indent already, and the last one gets its end from the caller.
    fn statement(&mut self, kind: &'u StatementKind) {
        match kind {
            StatementKind::Assignment { target, value } => {
                self.expression(*target);
                self.put(" := ");
                self.expression(*value);
            }
            StatementKind::Binding { target, value } => {
                self.expression(*target);
                self.put(" REF= ");
                self.expression(*value);
            }
            StatementKind::Call(call) => {
                self.expression(*call);
            }
            StatementKind::If { branches, otherwise } => self.if_statement(branches, otherwise.as_deref()),
            StatementKind::Case {
                selector,
                branches,
                otherwise,
            } => {
                self.header("CASE ", *selector, " OF");
                self.indented(|writer| branches.iter().for_each(|branch| writer.case_branch(branch)));
                self.else_branch(otherwise.as_deref());
                self.closing("END_CASE");
            }
            StatementKind::For {
                control,
                from,
                to,
                by,
                body,
            } => {
                self.put("FOR ");
                self.expression(*control);
                self.put(" := ");
                self.expression(*from);
                self.put(" TO ");
                self.expression(*to);
                if let Some(by) = by {
                    self.put(" BY ");
                    self.expression(*by);
                }
                self.put(" DO");
                self.end();
                self.block(body);
                self.closing("END_FOR");
            }
            StatementKind::While { condition, body } => {
                self.header("WHILE ", *condition, " DO");
                self.block(body);
                self.closing("END_WHILE");
            }
            StatementKind::Repeat { body, until } => {
                self.put("REPEAT");
                self.end();
                self.block(body);
                self.begin();
                self.header("UNTIL ", *until, "");
                self.closing("END_REPEAT");
            }
            StatementKind::Exit => self.put("EXIT"),
            StatementKind::Continue => self.put("CONTINUE"),
            StatementKind::Return => self.put("RETURN"),
            StatementKind::Jump(label) => {
                self.put("JMP ");
                self.expression(*label);
            }
            StatementKind::Label(label) => {
                self.expression(*label);
                self.put(":");
            }
            StatementKind::Empty => {}
        }
    }

    /// A line with an expression between two words.
    fn header(&mut self, before: &str, expression: ExpressionId, after: &str) {
        self.put(before);
        self.expression(expression);
        self.put(after);
        self.end();
    }

    fn closing(&mut self, keyword: &str) {
        self.begin();
        self.put(keyword);
    }

    fn if_statement(
        &mut self,
        branches: &'u [(ExpressionId, Vec<Statement>)],
        otherwise: Option<&'u [Statement]>,
    ) {
        for (index, (condition, body)) in branches.iter().enumerate() {
            if index > 0 {
                self.begin();
            }
            self.header(if index > 0 { "ELSIF " } else { "IF " }, *condition, " THEN");
            self.block(body);
        }
        self.else_branch(otherwise);
        self.closing("END_IF");
    }

    fn else_branch(&mut self, body: Option<&'u [Statement]>) {
        if let Some(body) = body {
            self.line("ELSE");
            self.block(body);
        }
    }

    fn case_branch(&mut self, branch: &'u CaseBranch) {
        self.begin();
        self.list(&branch.labels, |writer, label| match label {
            CaseLabel::Value(value) => {
                writer.expression(*value);
            }
            CaseLabel::Range(low, high) => writer.range((*low, *high)),
        });
        self.put(":");
        self.end();
        self.block(&branch.body);
    }

    /// `low..high`.
    pub(super) fn range(&mut self, (low, high): (ExpressionId, ExpressionId)) {
        self.expression(low);
        self.put("..");
        self.expression(high);
    }
}
