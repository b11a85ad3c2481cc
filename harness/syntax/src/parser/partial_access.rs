//! `.n`, `.%Xn` and its kin, and what the dialect makes of them: the one place that decides it.

use super::state::Parser;
use crate::token::{Token, TokenKind};
use crate::tree::{ExpressionId, ExpressionKind};
use stickler_types::dialect::PartialAccess;
use stickler_types::{Code, ElementaryType};

/// The forms of partial access.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum AccessForm {
    /// `.n`.
    Short,
    /// `.%Xn`.
    Bit,
    /// `.%Bn`, `.%Wn`, `.%Dn` or `.%Ln`: a part of this type.
    Wider(ElementaryType),
}

impl Parser<'_, '_> {
    /// The suffix behind `dot`, which stands behind `base`. Where the dialect does not have it, the suffix is
    /// diagnosed, and nothing else is said about the construct.
    ///
    /// Basis: ironplc-bit-access: Syntax, Edition 3 Partial-Access Syntax, Byte / Word / Dword / Lword Partial
    /// Access; rusty-direct-variables: Constant based Direct Access; matiec, measured: no bit access at all.
    pub(super) fn partial_access(&mut self, base: ExpressionId, dot: Token) -> ExpressionId {
        let (form, index) = form_and_index(self.kind(), self.word());
        let suffix = dot.span.to(self.bump().span);
        let kind = match self.refusal(form) {
            Some((code, message)) => {
                self.report(code, suffix, || message);
                ExpressionKind::Error
            }
            None => match form {
                AccessForm::Wider(part) => ExpressionKind::Part { base, part, index },
                AccessForm::Short | AccessForm::Bit => ExpressionKind::Bit { base, index },
            },
        };
        let span = self.span_of(base).to(suffix);
        self.push(kind, span)
    }

    /// Why the dialect does not have the form; `None` where it has it.
    fn refusal(&self, form: AccessForm) -> Option<(Code, String)> {
        let dialect = self.dialect.name;
        match (form, self.dialect.partial_access) {
            (AccessForm::Short, _) if self.dialect.bit_access => None,
            (AccessForm::Short, _) => Some((
                Code::SyntaxError,
                format!("the dialect {dialect} has no bit access: expected a field's name"),
            )),
            (AccessForm::Bit, enabled) if enabled.is_enabled() => None,
            (AccessForm::Wider(_), PartialAccess::UpToLongWords) => None,
            (AccessForm::Wider(part), PartialAccess::UpToDoubleWords) if part != ElementaryType::Lword => {
                None
            }
            (_, PartialAccess::UpToDoubleWords | PartialAccess::UpToLongWords) => Some((
                Code::UnexpectedToken,
                format!("the dialect {dialect} has partial access up to double words (`.%D`) only"),
            )),
            (_, PartialAccess::BitsOnly) => Some((
                Code::UnexpectedToken,
                format!("the dialect {dialect} has partial access to bits (`.%X`) only"),
            )),
            (_, PartialAccess::Disabled) => Some((
                Code::PartialAccessSyntaxDisabled,
                format!(
                    "partial-access syntax is not enabled in the dialect {dialect}; for a bit write `.n`"
                ),
            )),
            (_, PartialAccess::SyntaxError) => Some((
                Code::SyntaxError,
                format!("the dialect {dialect} has no partial access: expected a field's name"),
            )),
        }
    }
}

/// Returns the form that `text` has, and the number in it; `u64::MAX` for one that is larger.
fn form_and_index(kind: TokenKind, text: &str) -> (AccessForm, u64) {
    let form = match text.as_bytes().get(1).map(u8::to_ascii_uppercase) {
        _ if kind == TokenKind::Integer => AccessForm::Short,
        Some(b'B') => AccessForm::Wider(ElementaryType::Byte),
        Some(b'W') => AccessForm::Wider(ElementaryType::Word),
        Some(b'D') => AccessForm::Wider(ElementaryType::Dword),
        Some(b'L') => AccessForm::Wider(ElementaryType::Lword),
        _ => AccessForm::Bit,
    };
    let digits = text.bytes().filter(u8::is_ascii_digit);
    let index = digits.fold(0_u64, |index, digit| {
        index.saturating_mul(10).saturating_add(u64::from(digit - b'0'))
    });
    (form, index)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_index_is_read_whatever_its_length() {
        assert_eq!(form_and_index(TokenKind::Integer, "1_0"), (AccessForm::Short, 10));
        assert_eq!(form_and_index(TokenKind::Partial, "%x63"), (AccessForm::Bit, 63));
        let nines = "9".repeat(1000);
        assert_eq!(
            form_and_index(TokenKind::Integer, &nines),
            (AccessForm::Short, u64::MAX)
        );
    }
}
