//! The state that every production uses: the tokens, the arena, the open constructs, the limits, and the one way to report an error.

use crate::diagnostic::{SpannedDiagnostic, quoted};
use crate::lexer::Lexer;
use crate::source::{MAX_LENGTH, Span};
use crate::token::{Token, TokenKind};
use crate::tree::{
    BinaryOperator, CaseFolded, Expression, ExpressionId, ExpressionKind, Pou, SourceUnit, VariableBlock,
};
use rustc_hash::FxHashSet;
use stickler_types::{Code, Dialect};

/// The greatest depth of parentheses, subscripts, calls, prefix operators, statements, types and initial values in
/// one another; anything deeper is diagnosed with S0002.
///
/// Basis: harness/README.md (depth, size and step limits turn hostile input into a diagnostic).
pub const MAX_NESTING: usize = 200;

/// The greatest depth of an expression's tree, the left operands of infix operators not counted. It is more than
/// [`MAX_NESTING`] because suffixes and right operands make a tree deeper without nesting what is written.
pub(super) const MAX_HEIGHT: u32 = MAX_NESTING as u32 * 3 / 2;

/// The error of a production that did not find what it reads; the diagnostic about it has been given.
#[derive(Debug)]
pub(super) struct Broken;

/// The result of a production.
pub(super) type ParseResult<T> = Result<T, Broken>;

/// Reads `text` by the rules of `dialect`.
///
/// Gives the tree of all that could be read, and the diagnostics about the rest in the order of the text. Never
/// fails and never panics; takes time and memory in proportion to the text. Where a diagnostic was given, the
/// tree has [`ExpressionKind::Error`] or `TypeSpecificationKind::Error`, or nothing at all.
pub fn parse<'s>(text: &'s str, dialect: &Dialect) -> (SourceUnit<'s>, Vec<SpannedDiagnostic>) {
    let mut parser = Parser::new(text, dialect);
    let declarations = parser.source_unit();
    let unit = SourceUnit {
        declarations,
        expressions: parser.expressions,
    };
    (unit, parser.lexer.diagnostics.into_list())
}

/// The parser's state.
pub(super) struct Parser<'s, 'd> {
    pub(super) text: &'s str,
    pub(super) dialect: &'d Dialect,
    pub(super) lexer: Lexer<'s, 'd>,
    /// The next token.
    pub(super) current: Token,
    /// The index of the next token among the lexer's tokens.
    pub(super) index: usize,
    /// The number of tokens that have been dropped before those.
    pub(super) dropped: usize,
    pub(super) expressions: Vec<Expression<'s>>,
    /// Operators that wait for their right operand, of all expressions that are being read.
    pub(super) pending: Vec<Pending>,
    /// The height of the expression that was read last.
    pub(super) height: u32,
    /// The number of brackets that the statement or declaration has open that is being read.
    pub(super) open: usize,
    /// The statements and POUs that are open.
    pub(super) blocks: Vec<OpenBlock>,
    /// Variable sections between statements, where they do not belong.
    pub(super) late_sections: Vec<VariableBlock<'s>>,
    /// The END_VAR of the section that is being read, where an error made it worth looking for.
    pub(super) section_end: Option<usize>,
    /// Whether names are paths to variables: those of VAR_CONFIG.
    pub(super) names_are_paths: bool,
    /// The methods and properties of the POU that is being read.
    pub(super) members: Vec<Pou<'s>>,
    /// Whether the POU that is being read is an interface.
    pub(super) in_interface: bool,
    /// Whether a feature that the dialect lacks has been reported of what is being read.
    pub(super) refused: bool,
    /// Whether something in the POU that is being read has been left out of the tree.
    pub(super) incomplete: bool,
    /// The number of names in the head of each namespace that is open.
    pub(super) namespaces: Vec<usize>,
    /// The words behind JMP in the text, once they have been looked for.
    pub(super) jump_targets: Option<FxHashSet<CaseFolded<'s>>>,
    /// The names of the types that are parameters of the function that is being read.
    pub(super) generics: FxHashSet<CaseFolded<'s>>,
    depth: usize,
    reported: Option<usize>,
    limit_reported: bool,
}

impl<'s, 'd> Parser<'s, 'd> {
    fn new(text: &'s str, dialect: &'d Dialect) -> Parser<'s, 'd> {
        let mut parser = Parser {
            text,
            dialect,
            lexer: Lexer::new(text, dialect),
            current: Token {
                kind: TokenKind::End,
                span: Span::default(),
            },
            index: 0,
            dropped: 0,
            // About as many as ordinary texts have.
            expressions: Vec::with_capacity(text.len().min(MAX_LENGTH) / 8),
            pending: Vec::new(),
            height: 0,
            open: 0,
            blocks: Vec::new(),
            late_sections: Vec::new(),
            section_end: None,
            names_are_paths: false,
            members: Vec::new(),
            in_interface: false,
            refused: false,
            incomplete: false,
            namespaces: Vec::new(),
            jump_targets: None,
            generics: FxHashSet::default(),
            depth: 0,
            reported: None,
            limit_reported: false,
        };
        parser.start();
        parser
    }

    /// Adds an expression to the arena.
    #[inline]
    pub(super) fn push(&mut self, kind: ExpressionKind<'s>, span: Span) -> ExpressionId {
        // There are no more expressions than tokens, whose number is limited.
        let id = ExpressionId(self.expressions.len() as u32);
        self.expressions.push(Expression { kind, span });
        id
    }

    /// Returns the span of an expression.
    #[inline]
    pub(super) fn span_of(&self, id: ExpressionId) -> Span {
        self.expressions
            .get(id.0 as usize)
            .map_or(Span::default(), |expression| expression.span)
    }

    /// Runs a production one level deeper, or reports that this is too deep.
    #[inline]
    pub(super) fn nested<T>(
        &mut self,
        production: impl FnOnce(&mut Self) -> ParseResult<T>,
    ) -> ParseResult<T> {
        if self.at_limit() {
            return Err(self.too_deep());
        }
        self.depth += 1;
        let result = production(self);
        self.depth -= 1;
        result
    }

    /// Returns whether the depth is reached beyond which nothing may be nested.
    pub(super) fn at_limit(&self) -> bool {
        self.depth >= MAX_NESTING
    }

    /// Reports that the text is nested too deep: once, for the reader has only one thing to change.
    #[cold]
    pub(super) fn too_deep(&mut self) -> Broken {
        if !self.limit_reported {
            self.limit_reported = true;
            let message = || format!("nested more than {MAX_NESTING} deep");
            self.lexer
                .diagnostics
                .report(Code::LimitExceeded, self.current.span, message);
        }
        self.reported = Some(self.position());
        Broken
    }

    /// Suppresses errors at the next token, whatever is expected in its place.
    pub(super) fn suppress(&mut self) {
        self.reported = Some(self.position());
    }

    /// Reports something other than a syntax error.
    #[cold]
    pub(super) fn report(&mut self, code: Code, span: Span, message: impl FnOnce() -> String) {
        self.lexer.diagnostics.report(code, span, message);
    }

    /// Reports that `what` does not stand where the next token does.
    #[cold]
    pub(super) fn expected(&mut self, what: &str) -> Broken {
        let at_end = self.kind() == TokenKind::End;
        let span = if at_end {
            self.previous_span().after()
        } else {
            self.current.span
        };
        self.expected_at(span, what)
    }

    /// Reports that something is missing that belongs to what stands before it: where the next token is on another line,
    /// the place is behind the previous one.
    #[cold]
    pub(super) fn missing(&mut self, what: &str) -> Broken {
        if self.starts_line() && !self.current.kind.is_reported() {
            self.expected_at(self.previous_span().after(), what)
        } else {
            self.expected(what)
        }
    }

    /// Reports at a place of the caller's choice that `what` does not stand where the next token does.
    #[cold]
    pub(super) fn expected_at(&mut self, span: Span, what: &str) -> Broken {
        let (kind, word) = (self.kind(), self.word());
        self.syntax_error(span, || {
            let found = match kind {
                TokenKind::End => "the end of the text".to_owned(),
                kind if kind.is_keyword() => format!("the keyword `{}`", kind.text()),
                _ => quoted(word),
            };
            ["expected ", what, ", found ", &found].concat()
        })
    }

    /// Reports a syntax error, unless the next token or the one before it has been complained about before.
    #[cold]
    pub(super) fn syntax_error(&mut self, span: Span, message: impl FnOnce() -> String) -> Broken {
        let said = self.kind().is_reported()
            || self.previous_kind().is_some_and(TokenKind::is_reported)
            || self.reported == Some(self.position())
            || self.kind() == TokenKind::End && (self.lexer.truncated || self.limit_reported);
        if !said {
            self.lexer.diagnostics.report(Code::SyntaxError, span, message);
        }
        self.reported = Some(self.position());
        Broken
    }
}

/// An open block, which waits for certain keywords.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum OpenBlock {
    Pou,
    /// A method, or a part of a property.
    Member,
    If,
    Case,
    /// The ELSE branch of an IF or a CASE.
    Else(TokenKind),
    For,
    While,
    Repeat,
}

impl OpenBlock {
    /// Returns whether a keyword ends the block, or the part of it that is being read.
    pub(super) fn awaits(self, kind: TokenKind) -> bool {
        match self {
            OpenBlock::Member => kind.closes_member(),
            OpenBlock::Pou => kind.closes_pou() || kind.opens_declaration() || kind == TokenKind::End,
            OpenBlock::If => matches!(kind, TokenKind::EndIf | TokenKind::Elsif | TokenKind::Else),
            OpenBlock::Case => matches!(kind, TokenKind::EndCase | TokenKind::Else),
            OpenBlock::Else(closer) => kind == closer,
            OpenBlock::For => kind == TokenKind::EndFor,
            OpenBlock::While => kind == TokenKind::EndWhile,
            OpenBlock::Repeat => matches!(kind, TokenKind::Until | TokenKind::EndRepeat),
        }
    }
}

/// An infix operator that waits for its right operand.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pending {
    pub(super) operator: BinaryOperator,
    pub(super) precedence: u8,
    pub(super) left: ExpressionId,
    pub(super) left_height: u32,
}
