//! The open constructs of the parser: blocks that wait for their ends, and operators that wait for operands.

use crate::token::TokenKind;
use crate::tree::{BinaryOperator, ExpressionId};

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
