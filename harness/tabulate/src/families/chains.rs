//! Conversions of conversions, and conversions inside expressions with implicit conversion around them.

use super::words::{DESIGN, RANGE};
use crate::call::Call;
use crate::inputs::integers::{BIT_STRINGS, INTEGERS, ascending, limits};
use crate::inputs::reals::{REALS, by_value};
use crate::operand::Operand;
use crate::sheet::owned;
use crate::table::{Probe, Table};
use stickler_types::DialectName::{self, IronplcEd3, Matiec};
use stickler_types::ElementaryType;
use stickler_types::ElementaryType::{
    Bool, Date, Dint, Dt, Int, Lint, Lreal, Real, String as Text, Time, Uint, Word,
};

/// The tables of this family.
///
/// # Errors
/// A sentence, where no table takes a chain.
pub fn tables() -> Result<Vec<Table>, String> {
    let chains = chains();
    let mut everywhere = Vec::new();
    let mut only_matiec = Vec::new();
    for chain in &chains {
        let matiec = chain.result(Matiec);
        match (matiec, chain.result(IronplcEd3)) {
            (Some(value), Some(other)) if value == other => everywhere.push(chain.row(&value)),
            (Some(value), None) => only_matiec.push(chain.row(&value)),
            (matiec, other) => return Err(format!("{chain:?} gives {matiec:?} and {other:?}")),
        }
    }
    Ok(vec![
        table(
            "chains",
            "A conversion of a conversion is done step by step",
            DESIGN,
            &["matiec", "ironplc-ed3"],
            everywhere,
        ),
        table(
            "chains-by-the-page",
            "A conversion of a conversion is done step by step by the functions that only the page lists",
            RANGE,
            &["matiec"],
            only_matiec,
        ),
    ])
}

fn table(name: &str, title: &str, basis: &str, dialects: &[&str], rows: Vec<Vec<String>>) -> Table {
    let probe = |name: &str, source: &str| Probe {
        name: name.to_owned(),
        observe: "into".to_owned(),
        expect: "{expected}".to_owned(),
        source: source.to_owned(),
        ..Probe::default()
    };
    Table {
        name: name.to_owned(),
        title: title.to_owned(),
        basis: basis.to_owned(),
        dialects: owned(dialects),
        summary: "\
Nested with a variable and with a literal inside: who leaves a step out because the types at both ends are the same, keeps more than one
step holds."
            .to_owned(),
        columns: owned(&["inner", "outer", "from", "to", "input", "typed", "expected"]),
        rows,
        probes: vec![probe("nested", NESTED), probe("constant", NESTED_CONSTANT)],
    }
}

const NESTED: &str = "\
PROGRAM main
VAR
    data : {from} := {input};
    into : {to};
END_VAR
    into := {outer}({inner}(data));
END_PROGRAM
";

const NESTED_CONSTANT: &str = "\
PROGRAM main
VAR
    into : {to};
END_VAR
    into := {outer}({inner}({typed}));
END_PROGRAM
";

/// Two functions, one of the result of the other.
#[derive(Debug)]
struct Chain {
    inner: Call,
    outer: String,
    to: ElementaryType,
}

impl Chain {
    /// What it gives, where a document of the dialect says so of both steps.
    fn result(&self, dialect: DialectName) -> Option<String> {
        let step = self.inner.expected(dialect)?;
        step.basis?;
        let outer = Call::new(&self.outer, vec![Operand::of(step.value)], self.to);
        let result = outer.expected(dialect)?;
        result.basis?;
        Some(result.value.to_string())
    }

    fn row(&self, expected: &str) -> Vec<String> {
        let operand = &self.inner.operands[0];
        owned(&[
            &self.inner.signature.function,
            &self.outer,
            self.inner.from().name(),
            self.to.name(),
            &operand.literal,
            &operand.typed,
            expected,
        ])
    }
}

/// There and back, for each pair of integers and bit strings, and some longer ways.
fn chains() -> Vec<Chain> {
    let types = || INTEGERS.into_iter().chain(BIT_STRINGS);
    let mut chains = Vec::new();
    for (ty, through) in types().flat_map(|ty| types().map(move |through| (ty, through))) {
        if ty != through {
            let (least, greatest) = limits(ty);
            let numbers = [least, greatest, limits(through).1 + 2];
            chains.extend(
                ascending(ty, numbers)
                    .into_iter()
                    .map(|operand| there_and_back(ty, through, operand)),
            );
        }
    }
    for (ty, through) in INTEGERS
        .into_iter()
        .flat_map(|ty| REALS.map(|through| (ty, through)))
    {
        let numbers = [limits(ty).0, -1, (1 << 24) + 1, (1 << 53) + 1];
        let fitting = ascending(ty, numbers).into_iter();
        chains.extend(fitting.map(|operand| there_and_back(ty, through, operand)));
    }
    for (through, ty) in INTEGERS.into_iter().flat_map(|ty| REALS.map(|real| (ty, real))) {
        let numbers = ["0.5", "1.5", "100.75"].map(str::to_owned);
        let operands = by_value(ty, &numbers).into_iter();
        chains.extend(operands.map(|operand| there_and_back(ty, through, operand)));
    }
    for ty in types() {
        let operands = ascending(ty, [0, 2, limits(ty).1]).into_iter();
        chains.extend(operands.map(|operand| there_and_back(ty, Bool, operand)));
    }
    chains.extend(
        by_value(Lreal, &["0.1", "1.0E300", "16777217.0"].map(str::to_owned))
            .into_iter()
            .map(|operand| there_and_back(Lreal, Real, operand)),
    );
    for (ty, through) in [(Dint, Time), (Lint, Time), (Uint, Time)] {
        chains.extend(
            ascending(ty, [-1500, 0, 1500])
                .into_iter()
                .map(|operand| there_and_back(ty, through, operand)),
        );
    }
    for ty in INTEGERS {
        let operands = ascending(ty, [limits(ty).0, 7, limits(ty).1]).into_iter();
        chains.extend(operands.map(|operand| there_and_back(ty, Text, operand)));
    }
    for moment in [
        "1969-12-31-23:59:59.999",
        "2000-02-29-00:00:00",
        "2024-12-31-12:00:00",
    ] {
        chains.push(there_and_back(Dt, Date, Operand::read(Dt, moment)));
    }
    for number in [0, 9, 10, 1234, 9999] {
        chains.push(Chain {
            inner: Call::new("INT_TO_BCD", vec![Operand::number(Int, number)], Word),
            outer: "BCD_TO_INT".to_owned(),
            to: Int,
        });
    }
    chains
}

fn there_and_back(ty: ElementaryType, through: ElementaryType, operand: Operand) -> Chain {
    Chain {
        inner: Call::convert(ty, through, operand),
        outer: format!("{through}_TO_{ty}"),
        to: ty,
    }
}
