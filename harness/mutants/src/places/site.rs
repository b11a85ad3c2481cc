//! The places of a program at which a rule applies, and the change that breaks it there.

use super::analysis::Analysis;
use super::claim::{
    BitClaim, ClaimBreach, ConversionClaim, Direction, LiteralPair, PairKind, PartForm, Rule,
};
use super::forms::refused_base;
use super::saboteur::SourceChange;
use super::standing::PlaceOfExpression;
use super::wrong_code::wrong_code;
use rustc_hash::FxHashMap;
use stickler_reference::instruction::{Instruction, Label, Part};
use stickler_reference::semantics::{TracedUse, UseKind};
use stickler_syntax::source::Span;
use stickler_syntax::tree::{ExpressionId, ExpressionKind, LiteralKind, UnaryOperator};
use stickler_types::{Code, ElementaryType};

/// A place of a program at which a rule can be broken.
#[derive(Clone, PartialEq, Debug)]
pub struct Site {
    /// The rule.
    pub rule: Rule,
    /// The places of `places.toml`.
    pub standing: PlaceOfExpression,
    /// The types between which a value converts.
    pub pair: Option<(ElementaryType, ElementaryType)>,
    /// The type of which a bit is selected, and the number of the bit.
    pub bit: Option<(ElementaryType, u64)>,
    /// The change that breaks the rule there.
    pub change: SourceChange,
}

/// Returns all places of a program at which rules can be broken; those of rendered texts only if the program is rendered.
pub fn sites(analysis: &Analysis<'_>, rendered: bool) -> Vec<Site> {
    let mut finder = SiteFinder {
        analysis,
        sites: Vec::new(),
        errors: errors_by_span(analysis),
    };
    for &found in &analysis.uses {
        finder.traced(found);
    }
    finder.refused_bits();
    if rendered {
        finder.rendered_bits();
    }
    finder.sites
}

/// The errors of a program by where they are.
type Errors = FxHashMap<(u32, u32), Vec<usize>>;

fn errors_by_span(analysis: &Analysis<'_>) -> Errors {
    let mut errors = Errors::default();
    for (index, diagnostic) in analysis.diagnostics.iter().enumerate() {
        let Span { start, end } = diagnostic.span;
        errors.entry((start, end)).or_default().push(index);
    }
    errors
}

struct SiteFinder<'a, 's> {
    analysis: &'a Analysis<'s>,
    sites: Vec<Site>,
    errors: Errors,
}

impl SiteFinder<'_, '_> {
    fn add(
        &mut self,
        claim: ConversionClaim,
        fault: ClaimBreach,
        standing: PlaceOfExpression,
        change: SourceChange,
    ) -> &mut Site {
        self.sites.push(Site {
            rule: Rule { claim, fault },
            standing,
            pair: None,
            bit: None,
            change,
        });
        let last = self.sites.len() - 1;
        &mut self.sites[last]
    }

    fn traced(&mut self, found: TracedUse) {
        let standing = self.analysis.standings.of(found.expression);
        match found.kind {
            UseKind::Expected {
                from: Some(from),
                to,
                fits,
            } => self.converting(ConversionClaim::Implicit, (from, to), fits, standing, found),
            UseKind::Captured { from, to, fits } => {
                let standing = PlaceOfExpression {
                    source: None,
                    ..standing
                };
                self.converting(ConversionClaim::Implicit, (from, to), fits, standing, found);
            }
            UseKind::Operand { from, to } => {
                self.converting(ConversionClaim::Operand, (from, to), true, standing, found);
            }
            UseKind::Converted { from, to } => {
                let Some(call) = standing.call else { return };
                let standing = PlaceOfExpression {
                    source: standing.source,
                    ..self.analysis.standings.of(call)
                };
                self.converting(ConversionClaim::Function, (from, to), true, standing, found);
            }
            UseKind::Expected { from: None, to, fits } => self.literal(to, fits, standing, found),
            UseKind::BitRead(of) => self.bit(Direction::Read, of, standing.of_bit(), found),
            UseKind::BitWritten(of) => self.bit(Direction::Written, of, standing.of_bit(), found),
        }
    }

    /// Breaks a conversion, whether implicit or by a call.
    fn converting(
        &mut self,
        claim: fn(PairKind) -> ConversionClaim,
        (from, to): (ElementaryType, ElementaryType),
        fits: bool,
        standing: PlaceOfExpression,
        found: TracedUse,
    ) {
        let Some(kind) = PairKind::of(from, to) else {
            return;
        };
        let claim = claim(kind);
        let pair = Some((from, to));
        if !fits {
            if let Some(change) = self.admitted(found.expression, &MISFITS) {
                self.add(claim, ClaimBreach::Admitted, standing, change).pair = pair;
            }
            return;
        }
        let refused = SourceChange::Refuse(self.analysis.expression(found.expression).span);
        self.add(claim, ClaimBreach::Refused, standing, refused).pair = pair;
        if let Some(change) = self.made_wrong(kind, (from, to), found) {
            self.add(claim, ClaimBreach::Wrong, standing, change).pair = pair;
        }
    }

    fn made_wrong(
        &self,
        kind: PairKind,
        (from, to): (ElementaryType, ElementaryType),
        found: TracedUse,
    ) -> Option<SourceChange> {
        let program = &self.analysis.program.as_ref()?.program;
        let end = found.end?;
        let performed = match program.code.get(end.checked_sub(1)? as usize) {
            Some(Instruction::Convert(conversion)) if (conversion.from, conversion.to) == (from, to) => {
                Some(*conversion)
            }
            _ => None,
        };
        let nothing = u32::try_from(program.text_constants.len()).ok()?;
        let wrong = wrong_code(kind, (from, to), performed, nothing)?;
        let removed = u32::from(wrong.replaces);
        Some(SourceChange::Code {
            at: end - removed,
            removed,
            inserted: wrong.code,
        })
    }

    fn literal(&mut self, to: ElementaryType, fits: bool, standing: PlaceOfExpression, found: TracedUse) {
        let Some((literal, kind)) = self.literal_within(found.expression) else {
            return;
        };
        let claim = ConversionClaim::Literal(literal_pair(kind, to));
        let span = self.analysis.expression(found.expression).span;
        let spans = [span, self.analysis.expression(literal).span];
        let codes: &[Code] = if fits { &OVERFLOWS } else { &MISFITS };
        match self.admitted_at(spans, codes) {
            Some(change) => _ = self.add(claim, ClaimBreach::Admitted, standing, change),
            None if fits => _ = self.add(claim, ClaimBreach::Refused, standing, SourceChange::Refuse(span)),
            None => {}
        }
    }

    /// Returns the literal without a type that an expression is, whatever its sign and its parentheses, and its kind.
    fn literal_within(&self, mut id: ExpressionId) -> Option<(ExpressionId, LiteralKind)> {
        loop {
            match &self.analysis.expression(id).kind {
                ExpressionKind::Parenthesized(inner) => id = *inner,
                ExpressionKind::Unary { operator, operand } if *operator != UnaryOperator::Not => {
                    id = *operand;
                }
                ExpressionKind::Literal(literal) => return Some((id, literal.kind)),
                _ => return None,
            }
        }
    }

    fn bit(
        &mut self,
        direction: Direction,
        of: ElementaryType,
        standing: PlaceOfExpression,
        found: TracedUse,
    ) {
        let Some(form) = self.form(found.expression) else {
            return;
        };
        let ExpressionKind::Bit { index, .. } = self.analysis.expression(found.expression).kind else {
            return;
        };
        let claim = ConversionClaim::Bit(BitClaim::Selected, direction, form);
        let bit = Some((of, index));
        let refused = SourceChange::Refuse(self.analysis.expression(found.expression).span);
        self.add(claim, ClaimBreach::Refused, standing, refused).bit = bit;
        if let Some(change) = self.other_bit(found) {
            self.add(claim, ClaimBreach::Wrong, standing, change).bit = bit;
        }
    }

    /// Selects the neighbour of a bit.
    fn other_bit(&self, found: TracedUse) -> Option<SourceChange> {
        let code = &self.analysis.program.as_ref()?.program.code;
        let is_bit = |&at: &Label| {
            let instruction = code.get(at as usize);
            matches!(
                instruction,
                Some(Instruction::Part(_) | Instruction::StorePart { .. })
            )
        };
        // Behind a bit that is written the limits of a subrange may be checked.
        let end = found.end?;
        let at = (end.saturating_sub(8)..end).rev().find(is_bit)?;
        let instruction = match *code.get(at as usize)? {
            Instruction::Part(part) => Instruction::Part(beside(part)),
            Instruction::StorePart { part, of } => Instruction::StorePart {
                part: beside(part),
                of,
            },
            _ => return None,
        };
        Some(SourceChange::Code {
            at,
            removed: 1,
            inserted: vec![instruction],
        })
    }

    /// Admits bits and forms that are refused.
    fn refused_bits(&mut self) {
        if !self.analysis.is_rejected() {
            return;
        }
        for (id, expression) in (0..).map(ExpressionId).zip(&self.analysis.unit.expressions) {
            let (claim, codes, spans): (BitClaim, &[Code], [Span; 2]) = match expression.kind {
                ExpressionKind::Bit { base, .. } => {
                    let spans = [expression.span, self.analysis.expression(base).span];
                    match self.admitted_at(spans, &[Code::BitAccessOutOfRange]).is_some() {
                        true => (BitClaim::Outside, &[Code::BitAccessOutOfRange], spans),
                        false => (BitClaim::NoBits, &[Code::BitAccessTypeInvalid], spans),
                    }
                }
                ExpressionKind::Error => {
                    let Some(base) = refused_base(&self.analysis.unit, id) else {
                        continue;
                    };
                    let suffix = Span::new(self.analysis.expression(base).span.end, expression.span.end);
                    (BitClaim::NoSuchForm, &REFUSED_FORMS, [suffix, suffix])
                }
                _ => continue,
            };
            let standing = self.analysis.standings.of(id).of_bit();
            let (Some(form), Some(change)) = (self.form(id), self.admitted_at(spans, codes)) else {
                continue;
            };
            self.add(
                ConversionClaim::Bit(claim, standing.direction(), form),
                ClaimBreach::Admitted,
                standing,
                change,
            );
        }
    }

    fn rendered_bits(&mut self) {
        for (id, expression) in (0..).map(ExpressionId).zip(&self.analysis.unit.expressions) {
            if !matches!(expression.kind, ExpressionKind::Bit { .. }) {
                continue;
            }
            let standing = self.analysis.standings.of(id).of_bit();
            if let Some(form) = self.form(id) {
                let claim = ConversionClaim::Bit(BitClaim::Rendered, standing.direction(), form);
                self.add(claim, ClaimBreach::Wrong, standing, SourceChange::Bit(id));
                let refused = SourceChange::Refuse(expression.span);
                self.add(claim, ClaimBreach::Refused, standing, refused);
            }
        }
    }

    /// Returns the form in which a bit is selected, or a part that the dialect does not have.
    fn form(&self, id: ExpressionId) -> Option<PartForm> {
        let Span { end, .. } = self.analysis.expression(id).span;
        let base = match self.analysis.expression(id).kind {
            ExpressionKind::Bit { base, .. } => base,
            _ => refused_base(&self.analysis.unit, id)?,
        };
        let start = self.analysis.expression(base).span.end;
        let suffix = self.analysis.source.get(start as usize..end as usize)?;
        let Some((_, part)) = suffix.split_once('%') else {
            return Some(PartForm::Short);
        };
        match part.as_bytes().first()?.to_ascii_uppercase() {
            b'B' | b'W' | b'D' | b'L' => Some(PartForm::Wider),
            _ => Some(PartForm::PartialAccess),
        }
    }

    fn admitted(&self, id: ExpressionId, codes: &[Code]) -> Option<SourceChange> {
        let span = self.analysis.expression(id).span;
        self.admitted_at([span, span], codes)
    }

    /// Returns the change that does not report errors with these codes at these places; `None` where there are none.
    fn admitted_at(&self, spans: [Span; 2], codes: &[Code]) -> Option<SourceChange> {
        let found = spans
            .into_iter()
            .filter_map(|Span { start, end }| self.errors.get(&(start, end)));
        let errors: Vec<usize> = found
            .flatten()
            .copied()
            .filter(|&index| codes.contains(&self.analysis.diagnostics[index].code))
            .collect();
        (!errors.is_empty()).then_some(SourceChange::Admit(errors))
    }
}

/// The codes of a value that does not fit where it stands.
const MISFITS: [Code; 5] = [
    Code::AssignmentTypeMismatch,
    Code::FunctionCallReturnTypeMismatch,
    Code::InitializerTypeMismatch,
    Code::FunctionCallArgTypeMismatch,
    Code::ConditionTypeInvalid,
];

/// The codes of an untyped literal whose number the type that it takes does not have.
const OVERFLOWS: [Code; 2] = [Code::ConstantOverflow, Code::RealLiteralOutOfRange];

/// The codes of a form of partial access that a dialect does not have.
const REFUSED_FORMS: [Code; 3] = [
    Code::PartialAccessSyntaxDisabled,
    Code::UnexpectedToken,
    Code::SyntaxError,
];

fn literal_pair(kind: LiteralKind, to: ElementaryType) -> LiteralPair {
    match kind {
        LiteralKind::Integer | LiteralKind::BasedInteger if to.is_integer() => LiteralPair::IntegerAsInteger,
        LiteralKind::Integer | LiteralKind::BasedInteger if to.is_real() => LiteralPair::IntegerAsReal,
        LiteralKind::Integer | LiteralKind::BasedInteger if to.is_bit_string() => {
            LiteralPair::IntegerAsBitString
        }
        LiteralKind::Integer | LiteralKind::BasedInteger => LiteralPair::IntegerAsOther,
        LiteralKind::Real if to.is_real() => LiteralPair::RealAsReal,
        LiteralKind::Real => LiteralPair::RealAsOther,
        _ if to.is_text() => LiteralPair::TextAsText,
        _ => LiteralPair::TextAsOther,
    }
}

/// Returns the same part one bit up or down.
fn beside(part: Part) -> Part {
    Part {
        first: part.first ^ 1,
        ..part
    }
}
