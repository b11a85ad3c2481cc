//! The language rules of a dialect: what the sources leave to a system.
//!
//! The file of a dialect, `conformance-cases/dialects/NAME.toml` or a table of `stickler.toml`, states those in which it differs
//! from the [defaults](Dialect::DEFAULT) or from the dialect that it extends. A new choice is one entry of a list below; its
//! meaning is implemented twice, independently: by the reference and by exact arithmetic.

use crate::choice::{Choice, choices};
pub use crate::options::{FreeWords, PartialAccess, TextPositions, ThirdEditionTypes, Widening};
pub use crate::{ComparedTypes, ConstantTypes, ImplicitWarnings, OperandTypes, ResultSigns, ShiftCounts};
use crate::{
    ConversionChoices, DeclaredFeatures, DialectName, Documents, ElementaryType, MatrixWord, Rounding,
};
use std::collections::BTreeMap;
use toml::de::DeValue;

/// The kind of a dialect, which says whose cases it has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DialectKind {
    /// A documented system, which case files name.
    Documented,
    /// A documented system with compiler options on or off, which case files name; it takes over no cases.
    Variant,
    /// A dialect of `stickler.toml`, which takes over the cases of its base.
    Custom,
}

/// A statement of a dialect's file about a pair of types.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Stated {
    /// Whether the types convert.
    pub value: MatrixWord,
    /// The basis of an expectation that follows from the statement, in the form of a case file: `mine: implicit INT.BOOL
    /// (stickler.toml:9)`. `None` in the file of a documented system, whose documents are the basis.
    pub basis: Option<String>,
}

/// A pair of types: that of a value, and that of its target.
pub type Pair = (ElementaryType, ElementaryType);

/// The greatest length of a STRING that is declared without one, where a dialect says no other; the standard leaves it open.
pub const DEFAULT_TEXT_LENGTH: u32 = 254;

choices! {
    /// A dialect: the content of its file over that of the files that it extends. Each choice names a point in which the sources
    /// differ (conformance-cases/sources.toml and rules.md name the basis of each).
    ///
    /// The defaults are the rules of the third edition that most systems share, without implicit conversions. Basis: iec-61131-3: third
    /// edition, Tables 3, 5, 10, 71; rule: not-stated for what is open.
    #[derive(Clone, PartialEq, Eq, Debug)]
    Dialect {
        /// Bit string to strictly wider integer is implicit (`--allow-cross-family-widening`).
        ///
        /// Basis: ironplc-type-conversions: Cross-family widening.
        cross_family_widening: bool = false, ["flags.allow-cross-family-widening"];
        /// The treatment of `.%Xn`, `.%Bn` … As a flag: `.%Xn` selects a bit, or every form is P4033.
        ///
        /// Basis: ironplc-bit-access: Edition 3 Partial-Access Syntax.
        partial_access: PartialAccess = PartialAccess::BitsOnly,
            ["flags.allow-partial-access-syntax", "language.partial-access"];
        /// `.n` selects a bit.
        bit_access: bool = true, ["flags.bit-access"];
        /// An untyped integer literal may stand for a REAL or LREAL.
        integer_literal_as_real: bool = true, ["flags.integer-literal-as-real"];
        /// An untyped integer literal may be assigned or passed to a bit string (an initializer and an operand
        /// always take one).
        integer_literal_as_bit_string: bool = true, ["flags.integer-literal-as-bit-string"];
        /// `//` begins a comment.
        line_comments: bool = true, ["flags.line-comments"];
        /// Comments nest.
        nested_comments: bool = true, ["flags.nested-comments"];
        /// The types of the third edition that the dialect has: LTIME, LDATE, LTOD, LDT, CHAR and WCHAR. As a flag: all or none.
        third_edition_types: ThirdEditionTypes = ThirdEditionTypes::All,
            ["flags.third-edition-types", "language.third-edition-types"];
        /// ROUND, CEIL, CEILING and FLOOR are known.
        rounding_functions: bool = true, ["flags.rounding-functions"];
        /// ROUND, CEIL and FLOOR give a DINT, as TRUNC does, and all of them another number whose type their name ends with: `ROUND_UINT`,
        /// `ROUND_REAL`. Otherwise ROUND and its kin give a DINT for a REAL and a LINT for an LREAL.
        ///
        /// Basis: siemens-manual-2016: 294.
        rounds_to_dint: bool = false, ["flags.rounds-to-dint"];
        /// An untyped integer literal may stand for a value of the same bits: 200 for a SINT of -56, -1 for a WORD of 16#FFFF. Where implicit
        /// conversions are warned of, so is this.
        ///
        /// Basis: codesys-recording: recordings/codesys.run.json (`bound_…`, `cc_…`); twincat-builds: recordings/twincat.build.json (the
        /// warnings).
        literals_by_width: bool = false, ["flags.literals-by-width"];
        /// A value of an enumeration may stand where a number is expected, as an INT.
        ///
        /// Basis: twincat-builds: recordings/twincat.build.json (`cc_enum_…`).
        enumerations_as_integers: bool = false, ["flags.enumerations-as-integers"];
        /// The length of a text may stand in parentheses: `STRING(80)`.
        ///
        /// Basis: twincat-builds: recordings/twincat.build.json (`cc_string_…`); ironplc-problem-codes: P4042.
        lengths_in_parentheses: bool = false, ["flags.lengths-in-parentheses"];
        /// `&` and `**` are operators.
        ///
        /// Basis: iec-61131-3: Table 71; twincat-builds: recordings/twincat.build.json (`cc_power_operator`, `cc_fp_op_ampersand`); codesys-recording:
        /// recordings/codesys.run.json (`ampersand_operator_rejected`).
        ampersand_and_power: bool = true, ["flags.ampersand-and-power"];
        /// MOD of integers by zero gives 0, and is no fault.
        ///
        /// Basis: codesys-recording: recordings/codesys.run.json (`arithedge_…_mod_by_zero`).
        modulo_by_zero_is_zero: bool = false, ["flags.modulo-by-zero-is-zero"];
        /// `/` stops the program where a real number is divided by zero, and where a quotient of integers does not fit its type: the least DINT
        /// divided by -1.
        ///
        /// Basis: codesys-recording: recordings/codesys.run.json (`domain_divide_real_by_zero`, `arithedge_…_div_min_by_minus_one`).
        division_stops: bool = false, ["flags.division-stops"];
        /// MUX with a selector outside its inputs takes the last one, and is no fault.
        ///
        /// Basis: codesys-recording: recordings/codesys.run.json (`mux_out_of_range`).
        mux_outside_takes_last: bool = false, ["flags.mux-outside-takes-last"];
        /// MIN, MAX, ABS, SHL and SHR compute integers and bit strings as operators on promoted operands do: in the type in which they meet, and with 32
        /// bits at least. Shifts and rotations take integers, too, and SHR of one with a sign keeps the sign.
        ///
        /// Basis: codesys-recording: recordings/codesys.run.json (`max_signed_unsigned`, `meet_mixed_sign_wider_unsigned`, `abs_values`, `shift_basic`,
        /// `shift_signed_operand`, `shift_64bit`).
        functions_promote: bool = false, ["flags.functions-promote"];
        /// A minus sign may stand before a duration.
        ///
        /// Basis: rule: mixed-operands; codesys-recording: recordings/codesys.run.json (`unary_minus_on_time`, `uop_neg_ltime`), by which it may not.
        negates_durations: bool = true, ["flags.negates-durations"];
        /// `<>` holds where an operand is not a number.
        ///
        /// Basis: iec-60559: Special Quantities; omron-instructions: 135, by which it does not.
        nan_differs: bool = true, ["flags.nan-differs"];
        /// LIMIT gives its input IN where one of its inputs is an infinity or not a number, and ABS gives negative infinity for itself.
        ///
        /// Basis: plcnext-selection: LIMIT; plcnext-numeric: ABS.
        keeps_not_finite: bool = false, ["flags.keeps-not-finite"];
        /// TRUNC of an LREAL gives a LINT, as ROUND does, and no DINT.
        ///
        /// Basis: omron-instructions: 296.
        long_truncation: bool = false, ["flags.long-truncation"];
        /// ROUNDUP takes the next integer away from zero; its result is of the types of ROUND. Basis: omron-instructions: 296.
        rounds_up: bool = false, ["flags.rounds-up"];
        /// A duration times an infinity or what is not a number is the least one, and not 0. Basis: omron-instructions: 609.
        infinite_products: bool = false, ["flags.infinite-products"];
        /// An untyped integer literal in another base is a WORD, DWORD or LWORD where a function makes an integer of it: `TO_DINT(16#FFFF)`. Basis:
        /// plcnext-conversions: TO_DINT.
        based_literals_as_bits: bool = false, ["flags.based-literals-as-bits"];
        /// Names of conversion functions may have the long keywords of types: `UDINT_TO_TIME_OF_DAY`. Basis: iec-61131-3: Table 10; twincat-builds:
        /// recordings/twincat.build.json (`cc_conv_spelled_…`), by which they may not.
        long_names_convert: bool = true, ["flags.long-names-convert"];
        /// A literal of TIME may have microseconds and nanoseconds, as one of LTIME may: `T#5ns`. Basis: iec-61131-3: Table 8; twincat-builds:
        /// recordings/twincat.build.json (`cc_time_…_literal`), by which it may not.
        fine_time_literals: bool = true, ["flags.fine-time-literals"];
        /// TO_STRING and TO_WSTRING have a second input FORMAT: `'{0:D8}'`. Basis: plcnext-conversions: TO_STRING.
        format_strings: bool = false, ["flags.format-strings"];
        /// Variables with a location (`AT %MW5`) and others stand in one section. Basis: ironplc-problem-codes: P4036; ironplc-dialects: Enabling
        /// Specific Features.
        mixed_locations: bool = true, ["flags.mixed-locations"];
        /// A real literal needs no point before its exponent: `1E5`.
        ///
        /// Basis: codesys-pages: _cds_operands_constant_real; iec-61131-3: Table 5, by which it does.
        reals_without_point: bool = false, ["flags.reals-without-point"];
        /// No `;` need stand behind END_IF, END_CASE, END_FOR, END_WHILE and END_REPEAT, and behind the last END_STRUCT of TYPE.
        ///
        /// Basis: codesys-pages: _cds_exst_operator_expression, _cds_datatype_structure; strucpp-tests: libs/sources/plcopen-softmotion/opensml_sync_position.st.
        ends_without_semicolon: bool = false, ["flags.ends-without-semicolon"];
        /// Bit strings apart from BOOL are integers where one is needed: as a subscript, a bound of FOR, the number of places of a shift, the
        /// factor of a duration, and behind CASE.
        ///
        /// Basis: codesys-pages: _cds_datatype_integer, _cds_operator_mul; iec-61131-3: 7.3.3.
        bit_strings_as_integers: bool = false, ["flags.bit-strings-as-integers"];
        /// A name may be qualified by that of its library or of its list of global variables, of which the text need not tell: what it qualifies
        /// is declared in the text, or is standard.
        ///
        /// Basis: codesys-pages: _cds_rules.
        library_namespaces: bool = false, ["flags.library-namespaces"];
        /// FOR compares its limit with what the control variable holds, so that a loop to the greatest value of its type does not end.
        ///
        /// Basis: codesys-pages: _cds_st_instruction_for; codesys-recording: recordings/codesys.run.json (`for_at_type_max`, `lt_literal_for_bounds_…`);
        /// iec-61131-3: 7.3.3.4.2, by which it ends.
        loops_wrap: bool = false, ["flags.loops-wrap"];
        /// A function may have instances of function blocks, which begin anew with each call.
        ///
        /// Basis: codesys-analysis: SA0167; ironplc-problem-codes: P4054, by which it may not.
        blocks_in_functions: bool = false, ["flags.blocks-in-functions"];
        /// A value of an enumeration may be qualified by a point: `COLOR.RED`.
        ///
        /// Basis: codesys-pages: _cds_operator_namespace_enum.
        values_behind_points: bool = false, ["flags.values-behind-points"];
        /// Keywords, and names of data types, that may name something else: ON outside of a configuration.
        ///
        /// Basis: twincat-pages: Keywords.
        free_words: FreeWords = FreeWords::NONE, ["language.free-words"];
        /// Two apostrophes in a text in single quotes are one: `'it''s'`.
        ///
        /// Basis: ironplc-data-types: string; iec-61131-3: Table 7, by which an apostrophe is `$'`.
        doubled_apostrophes: bool = false, ["flags.doubled-apostrophes"];
        /// F_TRIG tells an edge in its first call, if CLK is FALSE then.
        ///
        /// Basis: iec-61131-3: Table 44; ironplc-function-blocks: f-trig, codesys-safety: sf_f_trig, by which it does not.
        first_call_falls: bool = true, ["flags.first-call-falls"];
        /// Counters count up to PV, and down to 0, and not to the limits of their type.
        ///
        /// Basis: matiec-repository: lib/counter.txt; iec-61131-3: Table 45, by which they go on.
        counters_stop_at_preset: bool = false, ["flags.counters-stop-at-preset"];
        /// The inputs of the standard counters and bistables are called RESET, LOAD, SET, SET1 and RESET1, and counters count WORD.
        ///
        /// Basis: codesys-recording: recordings/codesys.run.json (`lib_std_…`).
        set_and_reset_inputs: bool = false, ["flags.set-and-reset-inputs"];
        /// A subrange may have a single value: `INT(0..0)`.
        ///
        /// Basis: ironplc-problem-codes: P2002, by which the lower limit is "strictly less"; nobody else speaks of it.
        single_value_subranges: bool = true, ["flags.single-value-subranges"];
        /// An array may have more initial values than elements, of which the last ones are left out.
        ///
        /// Basis: iec-61131-3: 6.4.4.5.2; codesys-pages: _cds_error_c0075, by which it may not.
        excess_initial_values: bool = true, ["flags.excess-initial-values"];
        /// A label of CASE may be a number in another base: `16#FF`.
        ///
        /// Basis: ironplc-problem-codes: P4041, by which only an extension has it.
        based_case_labels: bool = true, ["flags.based-case-labels"];
        /// An untyped real literal may stand where an integer is expected; it converts as a value does.
        ///
        /// Basis: strucpp-architecture: Type System ("assignable to any numeric type"); ironplc-type-conversions: Integer and Real Types, by which it
        /// may not.
        real_literal_as_integer: bool = false, ["flags.real-literal-as-integer"];
        /// A user-defined name of an elementary type, and a subrange of one, convert implicitly as the type does.
        ///
        /// Basis: matiec: User-defined types; rule: not-stated; implicit-conversion-rules: ANY_DATE, STRING and user defined, by which they do not.
        derived_types_convert: bool = true, ["flags.derived-types-convert"];
        /// EXPT gives an LREAL, but a REAL of two REAL, and SQRT and the other functions of one real number take an integer as an LREAL.
        ///
        /// Basis: codesys-recording: recordings/codesys.run.json (`expt_types`, `expt_mixed_width`, `sqrt_precision`, `exp_log_precision`).
        integers_as_lreal: bool = false, ["flags.integers-as-lreal"];
        /// MUL_TIME and DIV_TIME give whole milliseconds, the rest of which is cut.
        ///
        /// Basis: ironplc-standard-functions: mul_time, div_time.
        scaled_to_milliseconds: bool = false, ["flags.scaled-to-milliseconds"];
        /// LEN, CONCAT and the other functions of texts take a WSTRING, too.
        ///
        /// Basis: iec-61131-3: Table 34; twincat-builds: recordings/twincat.build.json (`cc_standard_len_wstring`), by which they do not.
        wide_text_functions: bool = true, ["flags.wide-text-functions"];
        /// The greatest length of a STRING or WSTRING that is declared without one.
        ///
        /// Basis: codesys-recording: recordings/codesys.run.json (`string_default_length`); plcnext-text: MID_WSTRING.
        text_length: u32 = DEFAULT_TEXT_LENGTH, ["language.text-length"];
        /// What functions of texts do with a length or a position outside the text.
        text_positions: TextPositions = TextPositions::Clipped, ["language.text-positions"];
        /// The pairs of elementary types that convert implicitly.
        widening: Widening = Widening::None, ["language.implicit"];
        /// The implicit conversions that are accepted with a warning.
        implicit_warnings: ImplicitWarnings = ImplicitWarnings::None, ["operators.implicit-warnings"];
        /// The types in which two integers or bit strings meet.
        operands: OperandTypes = OperandTypes::OneOfTheirs, ["operators.operands"];
        /// The pairs of numbers and bit strings that a comparison takes.
        ///
        /// Basis: omron-instructions: 135; rule: mixed-operands.
        compared: ComparedTypes = ComparedTypes::Any, ["operators.compared"];
        /// The signs of what operators on bits and prefix operators give.
        ///
        /// Basis: codesys-recording: recordings/codesys.run.json (`uop_neg_…`, `not_result_width`); twincat-builds:
        /// recordings/twincat.build.json (`cc_bitwise_…`, `cc_not_…`, `cc_neg_…`).
        result_signs: ResultSigns = ResultSigns::OfOperands, ["operators.result-signs"];
        /// The types of operations on constants.
        ///
        /// Basis: twincat-builds: recordings/twincat.build.json (`cc_fp_overflow_expr`, `cc_typed_fold_…`).
        constant_types: ConstantTypes = ConstantTypes::OfOperands, ["operators.constant-types"];
        /// The bits of the count by which SHL and SHR shift.
        shift_counts: ShiftCounts = ShiftCounts::All, ["operators.shift-counts"];
    } beside {
        /// The handle of the dialect; that of its base while the dialect is not defined yet.
        name: DialectName = DialectName::IEC_ED3;
        /// The name as it is written.
        spelling: String = String::new();
        /// The name of the system, for people.
        title: String = String::new();
        /// The documented system that it is, or whose rules apply where the file states nothing.
        base: DialectName = DialectName::IEC_ED3;
        /// A description of the dialect, for people.
        about: Option<String> = None;
        /// The kind of the dialect.
        kind: DialectKind = DialectKind::Documented;
        /// The file and line of the definition, such as `stickler.toml:3`.
        place: String = String::new();
        /// What the documents of the system say, in the words by which exact arithmetic and the generator know them.
        documents: Documents = Documents::DEFAULT;
        /// What the system says of the features of the language.
        features: DeclaredFeatures = DeclaredFeatures::NONE;
        /// The system beside which it is asked only where the two differ, and a sample of the rest: another edition of one compiler.
        asked_beside: Option<String> = None;
        /// The pairs of types for which the file states whether they convert implicitly, whatever `widening` says.
        cells: BTreeMap<Pair, Stated> = BTreeMap::new();
        /// The names that the system has for types and functions of the standard, in capital letters.
        names: BTreeMap<String, String> = BTreeMap::new();
        /// The types that TO_INT and its kin take, by the type that they give, where they do not take all that have a meaning.
        inputs: BTreeMap<ElementaryType, &'static [ElementaryType]> = BTreeMap::new();
        /// The bases of the statements that are made beside the documents, by their keys: `mine: rounding (stickler.toml:9)`.
        stated: BTreeMap<&'static str, String> = BTreeMap::new();
        /// The choices of conversion functions, and of implicit conversions, where systems differ.
        conversions: ConversionChoices = ConversionChoices::DEFAULT;
    }
}

/// The conversion choices that most documented systems share: the defaults, and truncation.
pub const COMMON_CHOICES: ConversionChoices = ConversionChoices::DEFAULT.with_rounding(Rounding::Truncate);

/// The tables of choices, in the order in which reports list what a dialect overrides.
pub(crate) const TABLES: [&str; 4] = ["flags", "language", "conversions", "operators"];

/// The key of the flag that stands for cells of the matrix of implicit conversions.
const CROSS_FAMILY: &str = "flags.allow-cross-family-widening";

impl Dialect {
    /// Returns the rules of a dialect.
    #[must_use]
    pub fn of(name: DialectName) -> &'static Dialect {
        name.rules()
    }

    /// Returns a custom dialect that overrides nothing of another one.
    #[must_use]
    pub fn custom(spelling: &str, base: DialectName, place: &str) -> Dialect {
        Dialect::of(base).extended(spelling, place)
    }

    /// Returns a custom dialect of this name that extends this one; what this one states is stated by the other.
    pub(crate) fn extended(&self, spelling: &str, place: &str) -> Dialect {
        let renamed = |basis: &String| {
            let rest = basis.split_once(':').map_or("", |(_, rest)| rest);
            format!("{spelling}:{rest}")
        };
        let cell = |(pair, stated): (&Pair, &Stated)| {
            let basis = stated.basis.as_ref().map(renamed);
            (*pair, Stated { basis, ..*stated })
        };
        let stated = |(key, basis): (&&'static str, &String)| (*key, renamed(basis));
        Dialect {
            spelling: spelling.to_owned(),
            about: None,
            kind: DialectKind::Custom,
            asked_beside: None,
            place: place.to_owned(),
            cells: self.cells.iter().map(cell).collect(),
            stated: self.stated.iter().map(stated).collect(),
            ..self.clone()
        }
    }

    /// Returns the dialect with another choice, which the source `basis` states beside the documents; `value` is written as in the
    /// file: `true`, `"truncate"`. `None` where there is no such key or value.
    #[must_use]
    pub fn stating(mut self, key: &str, value: &str, basis: &str) -> Option<Dialect> {
        let value = DeValue::parse(value).ok()?;
        self.state(key, value.get_ref(), Some(basis.to_owned()))?.ok()?;
        Some(self)
    }

    /// Returns the dialect with a statement about a pair of types.
    #[must_use]
    pub fn stating_cell(mut self, pair: Pair, value: MatrixWord, basis: &str) -> Dialect {
        let basis = Some(basis.to_owned());
        self.cells.insert(pair, Stated { value, basis });
        self
    }

    /// Makes the choice of a key such as `flags.bit-access`, and keeps its basis. The error is a message without the key. `None` where
    /// there is no such key.
    pub(crate) fn state(
        &mut self,
        key: &str,
        value: &DeValue<'_>,
        basis: Option<String>,
    ) -> Option<Result<(), String>> {
        let known = Dialect::keys().find(|known| *known == key)?;
        if let Err(message) = self.choice_mut(key)?.state(key, value) {
            return Some(Err(message));
        }
        if key == CROSS_FAMILY && self.kind == DialectKind::Custom {
            self.state_cross_family(basis.as_ref());
        }
        if let Some(basis) = basis {
            self.stated.insert(known, basis);
        }
        if key == "conversions.out-of-range"
            && !self.stated.contains_key("conversions.truncation-out-of-range")
        {
            self.conversions.truncation_out_of_range = self.conversions.out_of_range;
        }
        let has = |ty: &ElementaryType| !ty.is_third_edition();
        if self.third_edition_types == ThirdEditionTypes::None {
            self.cells.retain(|(from, to), _| has(from) && has(to));
        }
        Some(Ok(()))
    }

    /// States the cells that cross-family widening decides: a custom dialect may extend one whose documents do not know it.
    ///
    /// Basis: ironplc-type-conversions: Cross-family widening ("an integer type of strictly greater bit width").
    fn state_cross_family(&mut self, basis: Option<&String>) {
        let value = if self.cross_family_widening {
            MatrixWord::Yes
        } else {
            MatrixWord::No
        };
        for from in ElementaryType::ALL.into_iter().filter(|ty| ty.is_bit_string()) {
            let wider = |to: &ElementaryType| to.is_integer() && from.bits() < to.bits();
            for to in ElementaryType::ALL.into_iter().filter(wider) {
                let basis = basis.cloned();
                self.cells.insert((from, to), Stated { value, basis });
            }
        }
    }

    fn choice(&self, key: &str) -> Option<&dyn Choice> {
        match key.split_once('.') {
            Some(("conversions", _)) => self.conversions.own_choice(key),
            Some(("documents", _)) => self.documents.own_choice(key),
            _ => self.own_choice(key),
        }
    }

    fn choice_mut(&mut self, key: &str) -> Option<&mut dyn Choice> {
        match key.split_once('.') {
            Some(("conversions", _)) => self.conversions.own_choice_mut(key),
            Some(("documents", _)) => self.documents.own_choice_mut(key),
            _ => self.own_choice_mut(key),
        }
    }

    /// Returns the keys of all choices.
    fn keys() -> impl Iterator<Item = &'static str> {
        let all = [Dialect::KEYS, ConversionChoices::KEYS, Documents::KEYS];
        all.into_iter().flatten().copied()
    }

    /// Returns the keys of a table, without its name.
    pub(crate) fn keys_of(table: &str) -> impl Iterator<Item = &'static str> {
        Dialect::keys().filter_map(move |key| key.strip_prefix(table)?.strip_prefix('.'))
    }

    /// Returns the statements that are made beside the documents of the base, each with its value: `flags.bit-access`, `true`.
    pub fn statements(&self) -> impl Iterator<Item = (&'static str, String)> {
        let keys = TABLES.into_iter().flat_map(|table| {
            let is_of_table = move |key: &&str| key.split_once('.').is_some_and(|(own, _)| own == table);
            Dialect::keys().filter(is_of_table)
        });
        keys.filter(|key| self.stated.contains_key(key))
            .filter_map(|key| Some((key, self.choice(key)?.written(key).into_owned())))
    }

    /// Returns every choice of the dialect in the notation of its file: `conversions.rounding`, `truncate`.
    pub fn all_choices(&self) -> impl Iterator<Item = (&'static str, String)> {
        let is_choice = |key: &&str| TABLES.iter().any(|table| key.split('.').next() == Some(table));
        let written = |key| Some((key, self.choice(key)?.written(key).into_owned()));
        Dialect::keys().filter(is_choice).filter_map(written)
    }

    /// Returns the overrides in the notation of `stickler.toml`: `implicit INT.BOOL = yes`.
    #[must_use]
    pub fn overrides(&self) -> Vec<String> {
        // The flag stands for these.
        let cross_family = self.stated.get(CROSS_FAMILY);
        let cells = self
            .cells
            .iter()
            .filter(|(_, stated)| stated.basis.as_ref() != cross_family);
        let cells =
            cells.map(|((from, to), stated)| format!("implicit {from}.{to} = {}", stated.value.as_str()));
        let choices = self.statements().map(|(key, value)| {
            let name = key.split_once('.').map_or(key, |(_, name)| name);
            format!("{name} = {value}")
        });
        cells.chain(choices).collect()
    }

    /// Returns the basis of the statement under a key, if one is made beside the documents of the base.
    #[must_use]
    pub fn basis(&self, key: &str) -> Option<&str> {
        self.stated.get(key).map(String::as_str)
    }

    /// Returns the statement about a pair of types; `None` if there is none.
    #[must_use]
    pub fn implicit(&self, from: ElementaryType, to: ElementaryType) -> Option<&Stated> {
        self.cells.get(&(from, to))
    }

    /// Returns whether the system lacks a feature of the list `conformance-cases/features.toml`, by its own words or by the choices of its
    /// file.
    #[must_use]
    pub fn lacks(&self, feature: &str) -> bool {
        use ElementaryType::{Char, Ldate, Ldt, Ltime, Ltod, Wchar};
        let by_choice = match feature {
            "ltime" | "long-duration-literal" => !self.has(Ltime),
            "ldate" | "long-date-literal" => !self.has(Ldate),
            "ltod" | "long-time-of-day-literal" => !self.has(Ltod),
            "ldt" | "long-date-and-time-literal" => !self.has(Ldt),
            "char" => !self.has(Char),
            "wchar" => !self.has(Wchar),
            "wstring" | "wide-string-literal" => !self.documents.wide_strings,
            "bit-access" => !self.bit_access,
            "partial-access-bit" => !self.partial_access.is_enabled(),
            "partial-access-byte" | "partial-access-word" | "partial-access-double-word" => {
                !self.partial_access.has_wider_parts()
            }
            "line-comment" => !self.line_comments,
            "nested-comment" => !self.nested_comments,
            "ampersand" | "power" => !self.ampersand_and_power,
            "round" | "ceil" | "ceiling" | "floor" => !self.rounding_functions,
            _ => false,
        };
        by_choice || self.features.lacks.iter().any(|lacked| lacked == feature)
    }

    /// Returns the name that the standard has for what the system calls by this one, which itself is returned otherwise.
    #[must_use]
    pub fn standard_name<'n>(&'n self, name: &'n str) -> &'n str {
        let has_names = !self.names.is_empty();
        let own = has_names.then(|| self.names.get(&name.to_ascii_uppercase()));
        own.flatten().map_or(name, String::as_str)
    }

    /// Returns the elementary type of this name, by the standard or of the system's own; it may be one that the dialect does not have.
    #[must_use]
    pub fn elementary(&self, name: &str) -> Option<ElementaryType> {
        ElementaryType::from_name(self.standard_name(name))
    }

    /// Returns whether the dialect has this elementary type.
    #[must_use]
    pub const fn has(&self, ty: ElementaryType) -> bool {
        !ty.is_third_edition() || self.third_edition_types.includes(ty)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_has_its_own_dialect() {
        for name in DialectName::ALL {
            assert_eq!(Dialect::of(name).name, name);
        }
    }

    #[test]
    fn the_second_edition_lacks_the_types_of_the_third() {
        let has = |name| Dialect::of(name).has(ElementaryType::Ltime);
        assert_eq!(
            DialectName::ALL.map(has),
            [
                false, true, true, false, true, true, true, true, true, true, true, true, true, true, false,
                true
            ]
        );
        assert!(Dialect::of(DialectName::IRONPLC_ED2).has(ElementaryType::Time));
    }

    #[test]
    fn a_dialect_that_overrides_nothing_says_nothing() {
        let mine = Dialect::custom("mine", DialectName::PLCNEXT, "stickler.toml:1");
        assert_eq!(mine.basis("flags.bit-access"), None);
        assert_eq!(mine.implicit(ElementaryType::Int, ElementaryType::Bool), None);
        assert_eq!(mine.overrides(), [""; 0]);
        assert!(
            mine.clone()
                .stating("flags.bit-acces", "true", "mine: it")
                .is_none()
        );
        assert!(mine.stating("flags.bit-access", "'yes'", "mine: it").is_none());
    }

    #[test]
    fn every_key_makes_its_choice_and_is_written_as_it_was_read() {
        let mine = Dialect::custom("mine", DialectName::CODESYS, "here");
        for key in Dialect::keys() {
            let written = mine.choice(key).expect(key).written(key);
            let values = [format!("{written}"), format!("'{written}'")];
            let found: Vec<Dialect> = values
                .iter()
                .filter_map(|value| mine.clone().stating(key, value, "mine: test"))
                .collect();
            let [stated] = &found[..] else {
                panic!("{key} = {written}")
            };
            assert_eq!(stated.choice(key).expect(key).written(key), written, "{key}");
            assert_eq!(stated.basis(key), Some("mine: test"));
        }
    }
}
