//! The saboteurs that there must be: every rule in every place of `places.toml` in which it can apply.

use super::claim::{
    BitClaim, ClaimBreach, ConversionClaim, Direction, LiteralPair, PairKind, PartForm, Rule,
};
use super::saboteur::{BrokenPlace, Saboteur};
use std::collections::BTreeSet;
use stickler_reference::conversion::{conversion_function_name, implicit};
use stickler_suite::{ProgramPlace, Role, Suite};
use stickler_types::{Dialect, DialectName, ElementaryType};

/// A value that goes from one type to another in a dialect.
type ValueFlow = (DialectName, ElementaryType, ElementaryType);

/// Returns every rule in every place in which one of the dialects has it.
pub fn required(suite: &Suite, dialects: &[DialectName]) -> BTreeSet<Saboteur> {
    let dialects: Vec<_> = dialects.iter().map(|name| (*name, Dialect::of(*name))).collect();
    let mut required = BTreeSet::new();
    for rule in Rule::all() {
        let flows = flows(rule, &dialects);
        for role in [Role::Source, Role::Target, Role::Surrounding] {
            // A place that stands only where a probe names it has the rules of these probes.
            let places = suite
                .places
                .of(role)
                .iter()
                .filter(|place| !place.is_only_named());
            for place in places.filter(|place| fits(rule, role, place)) {
                let rejected = rule.fault == ClaimBreach::Admitted;
                let stands = |&(dialect, from, to): &ValueFlow| {
                    place.stands(dialect, (from.name(), to.name()), rejected)
                };
                if flows.iter().any(stands) {
                    let place = broken(role, place);
                    required.insert(Saboteur { rule, place });
                }
            }
        }
    }
    required
}

fn broken(role: Role, place: &ProgramPlace) -> BrokenPlace {
    // There are some dozens of places, and the program is about to end when they are no longer needed.
    let name: &'static str = place.name().to_owned().leak();
    match role {
        Role::Source => BrokenPlace::Source(name),
        Role::Target => BrokenPlace::Target(name),
        Role::Surrounding => BrokenPlace::Surrounding(name),
    }
}

/// Returns the values that a rule speaks of.
fn flows(rule: Rule, dialects: &[(DialectName, &Dialect)]) -> Vec<ValueFlow> {
    let mut flows = Vec::new();
    for (name, dialect) in dialects {
        for from in ElementaryType::ALL {
            for to in ElementaryType::ALL {
                if speaks_of(rule, dialect, from, to) {
                    flows.push((*name, from, to));
                }
            }
        }
    }
    flows
}

fn speaks_of(rule: Rule, dialect: &Dialect, from: ElementaryType, to: ElementaryType) -> bool {
    let converts = || implicit(from, to, dialect).is_some();
    match rule.claim {
        ConversionClaim::Implicit(kind) => {
            PairKind::of(from, to) == Some(kind) && converts() == (rule.fault != ClaimBreach::Admitted)
        }
        ConversionClaim::Operand(kind) => {
            PairKind::of(from, to) == Some(kind) && converts() && has_operators(to)
        }
        ConversionClaim::Function(kind) => {
            PairKind::of(from, to) == Some(kind) && conversion_function_name(from, to, dialect).is_some()
        }
        // A literal has no type of its own.
        ConversionClaim::Literal(pair) => from == to && meets(pair, to),
        ConversionClaim::Bit(claim, direction, form) => {
            let (base, other) = match direction {
                Direction::Read => (from, to),
                Direction::Written => (to, from),
            };
            let has_bits = base.is_integer() || base.is_bit_string();
            let form_exists = match form {
                PartForm::Short => dialect.bit_access,
                PartForm::PartialAccess => dialect.partial_access.is_enabled(),
                PartForm::Wider => dialect.partial_access.has_wider_parts(),
            };
            match claim {
                BitClaim::Selected | BitClaim::Outside | BitClaim::Rendered => {
                    has_bits && form_exists && other == ElementaryType::Bool
                }
                BitClaim::NoBits => !has_bits && form_exists && other == ElementaryType::Bool,
                BitClaim::NoSuchForm => {
                    let part = match form {
                        PartForm::Wider => other.is_bit_string(),
                        _ => other == ElementaryType::Bool,
                    };
                    has_bits && dialect.bit_access && !form_exists && part
                }
            }
        }
    }
}

fn has_operators(ty: ElementaryType) -> bool {
    ty.is_integer() || ty.is_real() || ty.is_bit_string() || ty.is_duration()
}

fn meets(pair: LiteralPair, to: ElementaryType) -> bool {
    match pair {
        LiteralPair::IntegerAsInteger => to.is_integer(),
        LiteralPair::IntegerAsReal | LiteralPair::RealAsReal => to.is_real(),
        LiteralPair::IntegerAsBitString => to.is_bit_string(),
        LiteralPair::TextAsText => to.is_text(),
        LiteralPair::IntegerAsOther | LiteralPair::RealAsOther | LiteralPair::TextAsOther => to.is_moment(),
    }
}

/// Returns whether a rule can apply in a place at all. What selects a bit, calls or computes is no literal; behind a parameter it is
/// a variable again; and only a variable has bits.
fn fits(rule: Rule, role: Role, place: &ProgramPlace) -> bool {
    match (rule.claim, role) {
        (_, Role::Surrounding) => true,
        (ConversionClaim::Implicit(_), Role::Source) => true,
        (ConversionClaim::Implicit(_) | ConversionClaim::Literal(_), Role::Target) => !place.is_in("operand"),
        // It is a source of its own.
        (ConversionClaim::Literal(_), Role::Source) => false,
        (ConversionClaim::Operand(_) | ConversionClaim::Function(_), Role::Source) => true,
        // An operand meets the other one and no target.
        (ConversionClaim::Operand(_), Role::Target) => place.is_in("operand"),
        (ConversionClaim::Function(_), Role::Target) => !place.is_literal() && !place.is_behind_a_parameter(),
        (ConversionClaim::Bit(_, Direction::Read, _), Role::Source) => place.is_in("variable"),
        (ConversionClaim::Bit(_, Direction::Read, _), Role::Target) => {
            !place.is_literal() && !place.is_behind_a_parameter()
        }
        (ConversionClaim::Bit(_, Direction::Written, _), Role::Source) => true,
        (ConversionClaim::Bit(_, Direction::Written, _), Role::Target) => place.is_in("variable"),
    }
}
