//! Calls sorted by what the documents say of them: a class of calls, one table.
//!
//! The tables of newer families come from here. Each is asked in the dialects that differ in their documents, one of the three
//! IronPLC dialects for all, for these have one page on conversion functions.

use crate::call::Call;
use crate::column::Column;
use crate::families::words::{CONFORMANCE, DESIGN};
use crate::sheet::{CallProbe, Sheet};
use stickler_exact::Operation;
use stickler_types::{DialectName, ElementaryType};

/// What the documents of a dialect say of a call.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Voice {
    /// This section says what it gives.
    Says(&'static str),
    /// It has the function and never stops the program; what the call gives is not said.
    Names,
    /// None says it.
    Open,
    /// The dialect does not have the function.
    Lacks,
}

impl Voice {
    /// The section that says what the call gives.
    const fn basis(self) -> Option<&'static str> {
        match self {
            Voice::Says(basis) => Some(basis),
            Voice::Names | Voice::Open | Voice::Lacks => None,
        }
    }
}

/// What the documents of each dialect say of a call.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Voices {
    /// The ForgeIEC page, for `matiec`.
    pub matiec: Voice,
    /// IronPLC's page, for `ironplc-ed3`.
    pub ironplc: Voice,
    /// PLCnext's pages, for `plcnext`.
    pub plcnext: Voice,
}

impl Voices {
    /// Nobody says what the call gives.
    pub const OPEN: Voices = Voices {
        matiec: Voice::Open,
        ironplc: Voice::Open,
        plcnext: Voice::Open,
    };

    /// The ForgeIEC page names the function, and that is all that anybody says.
    pub const NAMED: Voices = Voices {
        matiec: Voice::Names,
        ..Voices::OPEN
    };

    /// Nobody says what the call gives, and the function has types of the third edition.
    pub const THIRD_EDITION: Voices = Voices {
        matiec: Voice::Lacks,
        ..Voices::OPEN
    };

    /// All say the same.
    #[must_use]
    pub const fn all(basis: &'static str) -> Voices {
        Voices {
            matiec: Voice::Says(basis),
            ironplc: Voice::Says(basis),
            plcnext: Voice::Says(basis),
        }
    }

    /// Only the ForgeIEC page says something.
    #[must_use]
    pub const fn only_matiec(basis: &'static str) -> Voices {
        Voices {
            matiec: Voice::Says(basis),
            ..Voices::OPEN
        }
    }

    /// The ForgeIEC page and IronPLC's say something.
    #[must_use]
    pub const fn both(matiec: &'static str, ironplc: &'static str) -> Voices {
        Voices {
            matiec: Voice::Says(matiec),
            ironplc: Voice::Says(ironplc),
            plcnext: Voice::Open,
        }
    }

    /// What the documents say of a call, as the exact arithmetic knows it.
    #[must_use]
    pub fn of(call: &Call) -> Voices {
        let voice = |dialect| match call.expected(dialect) {
            None => Voice::Lacks,
            Some(expected) => expected.basis.map_or(Voice::Open, Voice::Says),
        };
        let matiec = match voice(DialectName::Matiec) {
            Voice::Open if is_named(call) => Voice::Names,
            voice => voice,
        };
        Voices {
            matiec,
            ironplc: voice(DialectName::IronplcEd3),
            plcnext: voice(DialectName::Plcnext),
        }
    }

    /// Each with its dialect.
    const fn named(self) -> [(&'static str, Voice); 3] {
        [
            ("matiec", self.matiec),
            ("ironplc-ed3", self.ironplc),
            ("plcnext", self.plcnext),
        ]
    }
}

/// A table for the calls of which the documents say the same.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Class {
    /// The file's name without its extension.
    pub name: &'static str,
    /// The claim, in one line.
    pub title: &'static str,
    /// A paragraph for a person; empty where there is none.
    pub summary: &'static str,
    /// Who says so.
    pub voices: Voices,
}

/// How the calls of a family are shown and made.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Form {
    /// The columns of a table that asserts values.
    pub columns: &'static [Column],
    /// The columns of a table that only records.
    pub open_columns: &'static [Column],
    /// The program that calls the function with a variable.
    pub variable: &'static str,
    /// The program that calls it with a literal, where the family has such cases.
    pub constant: Option<&'static str>,
    /// Whether what is open is recorded; a table that goes through many values of one rule asserts only.
    pub recorded: bool,
}

/// Whether the ForgeIEC page's table of names has the function: what it names, matiec has, and nothing that it names stops a
/// program.
///
/// Basis: forgeiec-conversion-functions: The naming pattern; matiec conformance ("implements every conversion in the table");
/// Range and precision ("silently truncate or wrap").
fn is_named(call: &Call) -> bool {
    let (from, to) = (call.from(), call.to());
    let is_number = |ty: ElementaryType| ty.is_integer() || ty.is_real();
    match &*call.signature.function {
        "TRUNC" | "TRUNC_INT" | "TRUNC_DINT" | "TRUNC_LINT" | "BCD_TO_INT" | "INT_TO_BCD" => true,
        name if name.starts_with("TO_") || call.signature.operation != Operation::Convert => false,
        _ => match (from, to) {
            (ElementaryType::Bool | ElementaryType::Time, _)
            | (_, ElementaryType::Bool | ElementaryType::Time) => true,
            (ElementaryType::String, _) => is_number(to),
            (_, ElementaryType::String) => is_number(from),
            (ElementaryType::Dt, ElementaryType::Date) => true,
            _ => false,
        },
    }
}

/// The tables of these classes, with each call in the class that it belongs to, in the order of the calls.
///
/// # Errors
/// A sentence, where a call belongs to no class, or a class has no call.
pub fn sheets(calls: &[Call], classes: &[Class], form: Form) -> Result<Vec<Sheet>, String> {
    let mut sorted: Vec<Vec<Call>> = vec![Vec::new(); classes.len()];
    for call in calls {
        let voices = Voices::of(call);
        let Some(at) = classes.iter().position(|class| class.voices == voices) else {
            let names: Vec<&str> = classes.iter().map(|class| class.name).collect();
            return Err(format!("{call} belongs to none of {names:?}: {voices:?}"));
        };
        sorted[at].push(call.clone());
    }
    let sheets = classes.iter().zip(sorted).map(|(class, calls)| {
        if calls.is_empty() {
            Err(format!("{} has no calls", class.name))
        } else {
            Ok(sheet(class, calls, form))
        }
    });
    sheets.collect()
}

fn sheet(class: &Class, calls: Vec<Call>, form: Form) -> Sheet {
    let voices = class.voices.named();
    let said = voices.iter().find_map(|(_, voice)| voice.basis());
    let silent = match class.voices.matiec {
        Voice::Names => CONFORMANCE,
        _ => DESIGN,
    };
    let present = voices.iter().filter(|(_, voice)| *voice != Voice::Lacks);
    Sheet {
        name: class.name,
        title: class.title,
        basis: said.unwrap_or(silent),
        dialects: present.map(|(name, _)| *name).collect(),
        summary: class.summary.to_owned(),
        columns: if said.is_some() {
            form.columns
        } else {
            form.open_columns
        },
        calls,
        probes: probes(class.voices, said, form),
    }
}

/// The probes of a class, `said` being the basis of its table: one for all dialects with this basis, one for each other that
/// asserts, one that never faults, one that records.
fn probes(voices: Voices, said: Option<&'static str>, form: Form) -> Vec<CallProbe> {
    let voices = voices.named();
    let with = |wanted: Voice| -> Vec<&'static str> {
        let dialects = voices.iter().filter(|(_, voice)| *voice == wanted);
        dialects.map(|(name, _)| *name).collect()
    };
    let mut probes = Vec::new();
    for (kind, source) in [("variable", Some(form.variable)), ("constant", form.constant)] {
        let (Some(said), Some(source)) = (said, source) else {
            continue;
        };
        probes.push(CallProbe::value(kind, &with(Voice::Says(said)), source));
        for (dialect, voice) in voices {
            if let Some(basis) = voice.basis().filter(|basis| *basis != said) {
                probes.push(CallProbe::value(own_probe(kind, dialect), &[dialect], source).by(basis));
            }
        }
    }
    let named = with(Voice::Names);
    if !named.is_empty() {
        probes.push(CallProbe::never_faults(&named, form.variable));
    }
    let open = with(Voice::Open);
    if form.recorded && !open.is_empty() {
        probes.push(CallProbe::recorded(&open, form.variable));
    }
    probes
}

/// The probe of a dialect whose own document says what another's says too.
fn own_probe(kind: &str, dialect: &str) -> &'static str {
    match (kind, dialect) {
        ("variable", "ironplc-ed3") => "variable-by-ironplc",
        ("constant", "ironplc-ed3") => "constant-by-ironplc",
        ("variable", _) => "variable-by-plcnext",
        _ => "constant-by-plcnext",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::families::words::{IRONPLC_NARROWING, PAIR, RANGE};
    use crate::operand::Operand;
    use crate::program::PAIR_OF_VARIABLE;
    use stickler_types::ElementaryType::{Dint, Int};

    const FORM: Form = Form {
        columns: PAIR,
        open_columns: PAIR,
        variable: PAIR_OF_VARIABLE,
        constant: None,
        recorded: true,
    };

    fn class(voices: Voices) -> Class {
        Class {
            name: "example",
            title: "An example",
            summary: "",
            voices,
        }
    }

    #[test]
    fn each_document_has_a_probe_of_its_own() {
        let calls = [Call::convert(Dint, Int, Operand::number(Dint, 1 << 16))];
        let sheets = sheets(&calls, &[class(Voices::both(RANGE, IRONPLC_NARROWING))], FORM).unwrap();
        let probes: Vec<(&str, &str, &[&str])> = sheets[0]
            .probes
            .iter()
            .map(|probe| (probe.name, probe.basis, &probe.dialects[..]))
            .collect();
        assert_eq!(
            probes,
            [
                ("variable", "", &["matiec"][..]),
                ("variable-by-ironplc", IRONPLC_NARROWING, &["ironplc-ed3"]),
                ("recorded", "", &["plcnext"]),
            ]
        );
        assert!(sheets[0].table().is_ok());
    }

    #[test]
    fn a_call_of_no_class_is_a_mistake_and_so_is_a_class_without_calls() {
        let calls = [Call::convert(Dint, Int, Operand::number(Dint, 1))];
        let error = sheets(&calls, &[class(Voices::OPEN)], FORM).unwrap_err();
        assert!(
            error.starts_with("DINT_TO_INT(DINT#1) belongs to none"),
            "{error}"
        );
        let error = sheets(&[], &[class(Voices::OPEN)], FORM).unwrap_err();
        assert_eq!(error, "example has no calls");
    }
}
