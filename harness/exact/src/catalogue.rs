//! The catalogue of conversion functions: every name of a dialect with its signatures.
//!
//! The catalogue of a dialect is generated once, from pairs of types and a few patterns of names, and looked up afterwards.

use crate::signature::{Operation, Signature, has_meaning};
use std::collections::HashMap;
use std::sync::{LazyLock, Mutex, PoisonError};
use stickler_types::{ConversionCall, Dialect, DialectName, ElementaryType};

/// Returns every signature of a function in a dialect; none if the dialect has no conversion function of this name.
///
/// The name may be in any ASCII case, and spell the types `TOD`, `DT`, `LTOD` and `LDT` out: `TIME_OF_DAY`. The signatures are
/// in the order of their operand types, and then of their result types, as [`ElementaryType::ALL`] has them; each carries the
/// name as it was given, in upper case.
///
/// | name | takes | gives |
/// |---|---|---|
/// | `<SRC>_TO_<DST>` | SRC | DST, which is another type |
/// | `TO_<DST>` | any type that has a meaning in DST, DST among them; those that the dialect's file lists | DST |
/// | `TRUNC` | REAL, LREAL | DINT; LINT of an LREAL in `omron` |
/// | `TRUNC_<INTEGER>` | REAL, LREAL | the integer |
/// | `<REAL>_TRUNC_<INTEGER>` | REAL or LREAL | the integer |
/// | `BCD_TO_INT` | BYTE, WORD | INT, DINT |
/// | `INT_TO_BCD` | INT, DINT | BYTE, WORD |
/// | `<BITS>_BCD_TO_<UNSIGNED>`, `BCD_TO_<UNSIGNED>` | the bit string, any bit string | the integer |
/// | `<UNSIGNED>_TO_BCD_<BITS>`, `TO_BCD_<BITS>` | the integer, any unsigned integer | the bit string |
/// | `CONCAT_DATE_TOD` | DATE, TOD | DT |
/// | `CONCAT_DATE_LTOD`, `CONCAT_LDATE_LTOD` | DATE or LDATE, LTOD | LDT |
/// | `ROUND`, `CEIL`, `CEILING`, `FLOOR`, not in `matiec` | REAL, LREAL | DINT, LINT; DINT in `siemens-s7` |
/// | `ROUND_<NUMBER>` …, `TRUNC_<REAL>`, only in `siemens-s7` | REAL, LREAL | the number |
///
/// Basis: forgeiec-conversion-functions: The naming pattern, BCD encoding, TRUNC vs. ROUND; ironplc-type-conversions: Explicit
/// Conversion Functions; iec-61131-3: Table 22 (the overloaded and BCD names of the third edition).
pub fn signatures(function: &str, dialect: DialectName) -> Vec<Signature> {
    // No name is longer, and a hostile one is not worth copying.
    const MAX_NAME_LEN: usize = "LDATE_AND_TIME_TO_LTIME_OF_DAY".len();
    if function.len() > MAX_NAME_LEN {
        return Vec::new();
    }
    let name = function.to_ascii_uppercase();
    let Some(known) = Catalogue::of(dialect).by_name.get(&short_spelling(&name)) else {
        return Vec::new();
    };
    let inputs = &Dialect::of(dialect).inputs;
    let is_taken = |signature: &&Signature| {
        let listed = inputs
            .get(&signature.result)
            .filter(|_| name == format!("TO_{}", signature.result));
        listed.is_none_or(|inputs| signature.operands.iter().all(|from| inputs.contains(from)))
    };
    let renamed = known.iter().filter(is_taken).map(|signature| Signature {
        function: name.clone(),
        ..signature.clone()
    });
    renamed.collect()
}

/// Returns the signature of a call in a dialect: of the types of its operands and of the variable that takes its result.
pub fn signature_of(call: &ConversionCall, dialect: DialectName) -> Option<Signature> {
    let mut all = signatures(&call.function, dialect).into_iter();
    all.find(|signature| signature.result == call.result && signature.takes(&call.operands))
}

/// Returns the name of every conversion function of a dialect, each once, in upper case and with the short spelling of the
/// types.
///
/// The order is always the same: the pairs of types, the overloaded names, truncation, BCD, `CONCAT_…`, rounding.
pub fn functions(dialect: DialectName) -> Vec<String> {
    Catalogue::of(dialect).names.clone()
}

/// Replaces the long keywords of types in a name (`TIME_OF_DAY`) by the short ones (`TOD`).
fn short_spelling(name: &str) -> String {
    // Only here the names of types are part of a name that does not follow from them.
    if name.starts_with("CONCAT_") {
        return name.to_owned();
    }
    // `LTIME_OF_DAY` and `LDATE_AND_TIME` contain the spellings of the short types, and become `LTOD` and `LDT` with them.
    name.replace("TIME_OF_DAY", "TOD").replace("DATE_AND_TIME", "DT")
}

/// The functions of a dialect.
struct Catalogue {
    /// The types that a program of the dialect may name; a function of another one is none.
    types: Vec<ElementaryType>,
    names: Vec<String>,
    by_name: HashMap<String, Vec<Signature>>,
}

/// The catalogues that were asked for. They are kept to the end of the process, which has few dialects.
static CATALOGUES: LazyLock<Mutex<HashMap<DialectName, &'static Catalogue>>> = LazyLock::new(Mutex::default);

impl Catalogue {
    fn of(dialect: DialectName) -> &'static Catalogue {
        let mut known = CATALOGUES.lock().unwrap_or_else(PoisonError::into_inner);
        known
            .entry(dialect)
            .or_insert_with(|| Box::leak(Box::new(Catalogue::written_out(dialect.rules()))))
    }

    fn written_out(rules: &Dialect) -> Catalogue {
        let types = ElementaryType::ALL.into_iter();
        let mut catalogue = Catalogue {
            types: types.filter(|ty| rules.may_name(*ty)).collect(),
            names: Vec::new(),
            by_name: HashMap::new(),
        };
        catalogue.add_pairs();
        catalogue.add_truncations(rules.long_truncation);
        catalogue.add_bcd();
        catalogue.add_concatenations();
        if rules.rounding_functions {
            catalogue.add_roundings(rules.rounds_to_dint);
        }
        catalogue
    }

    /// Adds one signature to the function of this name.
    fn add(&mut self, name: String, from: ElementaryType, to: ElementaryType, operation: Operation) {
        self.add_signature(Signature {
            function: name,
            operands: vec![from],
            result: to,
            operation,
        });
    }

    fn add_signature(&mut self, signature: Signature) {
        let is_known = |ty: &ElementaryType| self.types.contains(ty);
        if !(signature.operands.iter().all(is_known) && is_known(&signature.result)) {
            return;
        }
        let signatures = self.by_name.entry(signature.function.clone()).or_default();
        if signatures.is_empty() {
            self.names.push(signature.function.clone());
        }
        signatures.push(signature);
    }

    /// Adds `<SRC>_TO_<DST>` and `TO_<DST>`.
    fn add_pairs(&mut self) {
        let types = self.types.clone();
        let pairs = || {
            let all = types
                .iter()
                .flat_map(|&from| types.iter().map(move |&to| (from, to)));
            all.filter(|&(from, to)| has_meaning(from, to))
        };
        for (from, to) in pairs().filter(|(from, to)| from != to) {
            self.add(format!("{from}_TO_{to}"), from, to, Operation::Convert);
        }
        for (from, to) in pairs() {
            self.add(format!("TO_{to}"), from, to, Operation::Convert);
        }
    }

    /// Adds `TRUNC`, `TRUNC_<INTEGER>` and `<REAL>_TRUNC_<INTEGER>`.
    fn add_truncations(&mut self, is_long: bool) {
        let integers = || ElementaryType::ALL.into_iter().filter(|ty| ty.is_integer());
        for from in REALS {
            let whole = match from {
                ElementaryType::Lreal if is_long => ElementaryType::Lint,
                _ => ElementaryType::Dint,
            };
            self.add("TRUNC".to_owned(), from, whole, Operation::Truncate);
            for to in integers() {
                self.add(format!("TRUNC_{to}"), from, to, Operation::Truncate);
                self.add(format!("{from}_TRUNC_{to}"), from, to, Operation::Truncate);
            }
        }
    }

    /// Adds the functions with BCD in their name.
    fn add_bcd(&mut self) {
        // What the ForgeIEC page lists for its two functions.
        let (listed_bits, integers) = (
            [ElementaryType::Byte, ElementaryType::Word],
            [ElementaryType::Int, ElementaryType::Dint],
        );
        for bits in listed_bits {
            for integer in integers {
                self.add("BCD_TO_INT".to_owned(), bits, integer, Operation::FromBcd);
            }
        }
        for integer in integers {
            for bits in listed_bits {
                self.add("INT_TO_BCD".to_owned(), integer, bits, Operation::ToBcd);
            }
        }
        let of = |is: fn(ElementaryType) -> bool| ElementaryType::ALL.into_iter().filter(move |&ty| is(ty));
        for bits in of(ElementaryType::is_bit_string) {
            for integer in of(ElementaryType::is_unsigned) {
                for name in [format!("BCD_TO_{integer}"), format!("{bits}_BCD_TO_{integer}")] {
                    self.add(name, bits, integer, Operation::FromBcd);
                }
                for name in [format!("TO_BCD_{bits}"), format!("{integer}_TO_BCD_{bits}")] {
                    self.add(name, integer, bits, Operation::ToBcd);
                }
            }
        }
    }

    /// Adds `CONCAT_…`.
    fn add_concatenations(&mut self) {
        use ElementaryType::{Date, Dt, Ldate, Ldt, Ltod, Tod};
        for (date, time, result) in [(Date, Tod, Dt), (Date, Ltod, Ldt), (Ldate, Ltod, Ldt)] {
            self.add_signature(Signature {
                function: format!("CONCAT_{date}_{time}"),
                operands: vec![date, time],
                result,
                operation: Operation::Concatenate,
            });
        }
    }

    /// Adds `ROUND`, `CEIL`, `CEILING` and `FLOOR`; where they give a DINT also `ROUND_<NUMBER>` … and `TRUNC_<REAL>`.
    fn add_roundings(&mut self, to_dint: bool) {
        let (dint, lint) = (ElementaryType::Dint, ElementaryType::Lint);
        for (name, operation) in [
            ("ROUND", Operation::Round),
            ("CEIL", Operation::Ceiling),
            ("CEILING", Operation::Ceiling),
            ("FLOOR", Operation::Floor),
            ("TRUNC", Operation::Truncate),
        ] {
            let truncates = operation == Operation::Truncate;
            for (from, to) in REALS.into_iter().zip([dint, if to_dint { dint } else { lint }]) {
                if !truncates {
                    self.add(name.to_owned(), from, to, operation);
                }
                let is_new = |ty: &ElementaryType| ty.is_real() || (ty.is_integer() && !truncates);
                for to in ElementaryType::ALL.into_iter().filter(|ty| to_dint && is_new(ty)) {
                    self.add(format!("{name}_{to}"), from, to, operation);
                }
            }
        }
    }
}

const REALS: [ElementaryType; 2] = [ElementaryType::Real, ElementaryType::Lreal];
