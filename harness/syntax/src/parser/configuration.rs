//! CONFIGURATION, RESOURCE, TASK and program instances.

use super::state::{ParseResult, Parser};
use crate::token::TokenKind;
use crate::tree::{Configuration, ProgramInstance, Resource, Task, VariableBlock, VariableKind};

impl<'s> Parser<'s, '_> {
    /// CONFIGURATION … END_CONFIGURATION; `None` without a name, when the contents are read all the same.
    pub(super) fn configuration(&mut self) -> Option<Configuration<'s>> {
        let start = self.bump().span;
        let name = self.name("a configuration's name").ok();
        let mut sections = Vec::new();
        let mut resources = Vec::new();
        while !self.at_end_of(TokenKind::EndConfiguration) {
            if self.kind() == TokenKind::Resource {
                resources.push(self.resource(&mut sections));
                continue;
            }
            // The programs that stand directly in the configuration share a resource without a header.
            let last: Option<&Resource<'_>> = resources.last();
            if last.is_none_or(|resource| resource.header.is_some()) {
                resources.push(Resource::default());
            }
            if let Some(resource) = resources.last_mut() {
                self.resource_item(resource, &mut sections);
            }
        }
        self.close(TokenKind::EndConfiguration);
        resources.retain(|resource| {
            resource.header.is_some() || !resource.tasks.is_empty() || !resource.programs.is_empty()
        });
        let is_configured = |section: &VariableBlock<'_>| section.kind == VariableKind::Configured;
        let (configured, globals) = sections.into_iter().partition(is_configured);
        Some(Configuration {
            name: name?,
            globals,
            resources,
            configured,
            span: start.to(self.previous_span()),
        })
    }

    /// The closing keyword, or something that makes clear that it is missing.
    fn at_end_of(&self, closer: TokenKind) -> bool {
        use TokenKind::*;
        let kind = self.kind();
        kind == closer
            || matches!(
                kind,
                End | EndConfiguration | Configuration | Function | FunctionBlock | Type
            )
    }

    /// RESOURCE … ON … END_RESOURCE. What stands in one whose header is broken is read, and kept without it.
    fn resource(&mut self, sections: &mut Vec<VariableBlock<'s>>) -> Resource<'s> {
        self.bump();
        let header = self.name("a resource's name").and_then(|name| {
            self.require(TokenKind::On)?;
            Ok((name, self.name("a resource's type")?))
        });
        let header = header.ok();
        if header.is_none() {
            self.skip_line();
        }
        let mut resource = Resource {
            header,
            ..Resource::default()
        };
        while !self.at_end_of(TokenKind::EndResource) && self.kind() != TokenKind::Resource {
            self.resource_item(&mut resource, sections);
        }
        self.close(TokenKind::EndResource);
        resource
    }

    /// A section, a task or a program instance.
    fn resource_item(&mut self, resource: &mut Resource<'s>, sections: &mut Vec<VariableBlock<'s>>) {
        let start = self.position();
        self.open = 0;
        let read = match self.kind() {
            kind if kind.opens_section() => {
                if !matches!(
                    kind,
                    TokenKind::VarGlobal | TokenKind::VarAccess | TokenKind::VarConfig
                ) {
                    self.expected("`VAR_GLOBAL`");
                }
                sections.extend(self.variable_block());
                Ok(())
            }
            TokenKind::Task => self.task().map(|task| resource.tasks.push(task)),
            TokenKind::Program => self
                .program_instance()
                .map(|program| resource.programs.push(program)),
            _ => Err(self.expected("VAR_GLOBAL, TASK, PROGRAM or the end")),
        };
        if read.is_err() {
            self.skip_declaration();
        }
        if self.position() == start {
            self.bump();
        }
    }

    /// `TASK name(INTERVAL := T#10ms, PRIORITY := 1);`
    fn task(&mut self) -> ParseResult<Task<'s>> {
        self.bump();
        let name = self.name("a task's name")?;
        let property = |parser: &mut Self| parser.named("SINGLE, INTERVAL or PRIORITY", Self::expression);
        let properties = match self.kind() {
            TokenKind::LeftParen => self.bracketed(TokenKind::RightParen, |parser| parser.list(property))?,
            _ => Vec::new(),
        };
        self.semicolon(TokenKind::Colon)?;
        Ok(Task { name, properties })
    }

    /// `PROGRAM instance WITH task : type;`. RETAIN has no effect on a run, and is not kept.
    fn program_instance(&mut self) -> ParseResult<ProgramInstance<'s>> {
        self.bump();
        if matches!(self.kind(), TokenKind::Retain | TokenKind::NonRetain) {
            self.bump();
        }
        let name = self.name("a program instance's name")?;
        let task = self.optional(TokenKind::With, |parser| parser.name("a task's name"))?;
        self.require(TokenKind::Colon)?;
        let type_name = self.name("a program's name")?;
        self.unsupported_connections();
        self.semicolon(TokenKind::Colon)?;
        Ok(ProgramInstance {
            name,
            task,
            type_name,
        })
    }
}
