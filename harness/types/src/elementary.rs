//! The elementary data types: names, families, widths, ranges, and the raw form in which their values are held.

/// Declares the elementary types: of each the variant, its keyword, its bits, its family and the edition that brought it.
macro_rules! elementary_types {
    ($(#[$about:meta])* ElementaryType {
        $($variant:ident = $name:literal, $bits:literal, $family:ident, $edition:ident;)*
    }) => {
        $(#[$about])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum ElementaryType {
            $(#[doc = concat!("`", $name, "`, of the family [`", stringify!($family), "`](Family::", stringify!($family), ").")] $variant,)*
        }

        impl ElementaryType {
            /// Every type, in the order of the declaration.
            pub const ALL: [ElementaryType; TABLE.len()] = [$(ElementaryType::$variant,)*];
        }

        /// The table of elementary types, in the order of the declaration.
        const TABLE: [TypeProperties; 27] = [$(TypeProperties {
            name: $name,
            bits: $bits,
            family: Family::$family,
            edition: Edition::$edition,
        },)*];
    };
}

elementary_types! {
    /// An elementary data type of either edition of the standard. `TOD`, `LTOD`, `DT` and `LDT` are also spelled `TIME_OF_DAY`, `LTIME_OF_DAY`,
    /// `DATE_AND_TIME` and `LDATE_AND_TIME`; `REAL` and `LREAL` are binary32 and binary64 of IEC 60559.
    ///
    /// # Raw form
    ///
    /// Every value except a text is held as one `u64`, its *raw form*:
    ///
    /// | types | raw form |
    /// |---|---|
    /// | `BOOL` | 0 or 1 |
    /// | `SINT` … `LINT` | two's complement, sign-extended to 64 bits |
    /// | `USINT` … `ULINT`, `BYTE` … `LWORD` | zero-extended |
    /// | `REAL`, `LREAL` | the bits of the `f32` (zero-extended) or the `f64` |
    /// | `TIME`, `LTIME` | nanoseconds, as an `i64` |
    /// | `DATE`, `LDATE`, `DT`, `LDT` | nanoseconds since 1970-01-01-00:00:00, as an `i64`; dates are whole days |
    /// | `TOD`, `LTOD` | nanoseconds since midnight |
    /// | `CHAR`, `WCHAR` | the code unit |
    ///
    /// Basis: iec-61131-3: Table 10 (elementary data types); the resolution of times and dates is the implementer's to choose, and
    /// the raw form gives the short types the resolution and range of the long ones.
    ElementaryType {
        Bool = "BOOL", 1, Boolean, Second;
        Sint = "SINT", 8, Signed, Second;
        Int = "INT", 16, Signed, Second;
        Dint = "DINT", 32, Signed, Second;
        Lint = "LINT", 64, Signed, Second;
        Usint = "USINT", 8, Unsigned, Second;
        Uint = "UINT", 16, Unsigned, Second;
        Udint = "UDINT", 32, Unsigned, Second;
        Ulint = "ULINT", 64, Unsigned, Second;
        Real = "REAL", 32, Real, Second;
        Lreal = "LREAL", 64, Real, Second;
        Byte = "BYTE", 8, BitString, Second;
        Word = "WORD", 16, BitString, Second;
        Dword = "DWORD", 32, BitString, Second;
        Lword = "LWORD", 64, BitString, Second;
        Time = "TIME", 64, Duration, Second;
        Ltime = "LTIME", 64, Duration, Third;
        Date = "DATE", 64, Date, Second;
        Ldate = "LDATE", 64, Date, Third;
        Tod = "TOD", 64, TimeOfDay, Second;
        Ltod = "LTOD", 64, TimeOfDay, Third;
        Dt = "DT", 64, DateAndTime, Second;
        Ldt = "LDT", 64, DateAndTime, Third;
        String = "STRING", 0, Text, Second;
        Wstring = "WSTRING", 0, Text, Second;
        Char = "CHAR", 8, Character, Third;
        Wchar = "WCHAR", 16, Character, Third;
    }
}

/// The kind of values that a type holds; types of one family differ only in width or range.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Family {
    /// `BOOL`.
    Boolean,
    /// `SINT` … `LINT`.
    Signed,
    /// `USINT` … `ULINT`.
    Unsigned,
    /// `BYTE` … `LWORD`.
    BitString,
    /// `REAL` and `LREAL`.
    Real,
    /// `TIME` and `LTIME`.
    Duration,
    /// `DATE` and `LDATE`.
    Date,
    /// `TOD` and `LTOD`.
    TimeOfDay,
    /// `DT` and `LDT`.
    DateAndTime,
    /// `STRING` and `WSTRING`.
    Text,
    /// `CHAR` and `WCHAR`.
    Character,
}

use ElementaryType as E;

/// A row of the table of elementary types.
struct TypeProperties {
    name: &'static str,
    bits: u32,
    family: Family,
    edition: Edition,
}

/// The edition of the standard that brought a type.
enum Edition {
    Second,
    Third,
}

impl ElementaryType {
    const fn row(self) -> &'static TypeProperties {
        &TABLE[self as usize]
    }

    /// Returns the keyword in upper case, the short one where there are two: `INT`, `TOD`, `DT`.
    pub const fn name(self) -> &'static str {
        self.row().name
    }

    /// Returns the type that a keyword names, in any case; long keywords such as `TIME_OF_DAY` are accepted too.
    ///
    /// The prefixes `T`, `LT`, `D` and `LD` are not keywords: see [`ElementaryType::from_literal_prefix`].
    pub fn from_name(name: &str) -> Option<ElementaryType> {
        // The parser asks this of every identifier: length and first letter turn nearly all others away.
        let first = name.as_bytes().first()?.to_ascii_uppercase();
        let candidates: &[(&str, E)] = match (name.len(), first) {
            (2, b'D') => &[("DT", E::Dt)],
            (3, b'I') => &[("INT", E::Int)],
            (3, b'T') => &[("TOD", E::Tod)],
            (3, b'L') => &[("LDT", E::Ldt)],
            (4, b'B') => &[("BOOL", E::Bool), ("BYTE", E::Byte)],
            (4, b'C') => &[("CHAR", E::Char)],
            (4, b'D') => &[("DINT", E::Dint), ("DATE", E::Date)],
            (4, b'L') => &[("LINT", E::Lint), ("LTOD", E::Ltod)],
            (4, b'R') => &[("REAL", E::Real)],
            (4, b'S') => &[("SINT", E::Sint)],
            (4, b'T') => &[("TIME", E::Time)],
            (4, b'U') => &[("UINT", E::Uint)],
            (4, b'W') => &[("WORD", E::Word)],
            (5, b'D') => &[("DWORD", E::Dword)],
            (5, b'L') => &[
                ("LREAL", E::Lreal),
                ("LWORD", E::Lword),
                ("LTIME", E::Ltime),
                ("LDATE", E::Ldate),
            ],
            (5, b'U') => &[("UDINT", E::Udint), ("USINT", E::Usint), ("ULINT", E::Ulint)],
            (5, b'W') => &[("WCHAR", E::Wchar)],
            (6, b'S') => &[("STRING", E::String)],
            (7, b'W') => &[("WSTRING", E::Wstring)],
            (11, b'T') => &[("TIME_OF_DAY", E::Tod)],
            (12, b'L') => &[("LTIME_OF_DAY", E::Ltod)],
            (13, b'D') => &[("DATE_AND_TIME", E::Dt)],
            (14, b'L') => &[("LDATE_AND_TIME", E::Ldt)],
            _ => return None,
        };
        candidates
            .iter()
            .find(|(keyword, _)| keyword.eq_ignore_ascii_case(name))
            .map(|&(_, ty)| ty)
    }

    /// Returns the type that a declaration names: a keyword, after which that of a text may have its length, as in `STRING[5]`.
    pub fn declared(name: &str) -> Option<ElementaryType> {
        ElementaryType::from_name(name.split_once('[').map_or(name, |(bare, _)| bare))
    }

    /// Returns the type that the prefix of a typed literal names: its keyword, or `T`, `LT`, `D`, `LD`; in any case.
    ///
    /// Basis: iec-61131-3: Tables 8 and 9 (duration, date and time of day literals).
    pub fn from_literal_prefix(prefix: &str) -> Option<ElementaryType> {
        match prefix.as_bytes() {
            b"T" | b"t" => Some(E::Time),
            b"D" | b"d" => Some(E::Date),
            [b'L' | b'l', b'T' | b't'] => Some(E::Ltime),
            [b'L' | b'l', b'D' | b'd'] => Some(E::Ldate),
            _ => ElementaryType::from_name(prefix),
        }
    }

    /// Returns the number of bits of a value: 1 for `BOOL`, 8 for `CHAR`, 64 for every duration and date, 0 for the texts.
    pub const fn bits(self) -> u32 {
        self.row().bits
    }

    /// Returns the family that the type belongs to.
    pub const fn family(self) -> Family {
        self.row().family
    }

    /// Returns whether the type is a signed or unsigned integer, `ANY_INT` of the standard.
    pub const fn is_integer(self) -> bool {
        matches!(self.family(), Family::Signed | Family::Unsigned)
    }

    /// Returns whether the type is an integer, `REAL` or `LREAL`: `ANY_NUM` of the standard.
    pub const fn is_number(self) -> bool {
        self.is_integer() || self.is_real()
    }

    /// Returns whether the type is an integer or a bit string, so that its values are whole numbers of two and more bits.
    pub const fn is_whole(self) -> bool {
        self.is_integer() || self.is_bit_string()
    }

    /// Returns whether the type is `SINT`, `INT`, `DINT` or `LINT`.
    pub const fn is_signed(self) -> bool {
        matches!(self.family(), Family::Signed)
    }

    /// Returns whether the type is `USINT`, `UINT`, `UDINT` or `ULINT`; bit strings are not integers.
    pub const fn is_unsigned(self) -> bool {
        matches!(self.family(), Family::Unsigned)
    }

    /// Returns whether the type is `BYTE`, `WORD`, `DWORD` or `LWORD`; unlike `ANY_BIT` of the standard, without `BOOL`.
    pub const fn is_bit_string(self) -> bool {
        matches!(self.family(), Family::BitString)
    }

    /// Returns whether the type is `REAL` or `LREAL`.
    pub const fn is_real(self) -> bool {
        matches!(self.family(), Family::Real)
    }

    /// Returns whether the type is `TIME` or `LTIME`.
    pub const fn is_duration(self) -> bool {
        matches!(self.family(), Family::Duration)
    }

    /// Returns whether the type is a date, a time of day, or both together, short or long: `ANY_DATE` of the standard.
    pub const fn is_date_or_time(self) -> bool {
        matches!(
            self.family(),
            Family::Date | Family::TimeOfDay | Family::DateAndTime
        )
    }

    /// Returns whether the type is a duration, a date, a time of day or both.
    pub const fn is_moment(self) -> bool {
        self.is_duration() || self.is_date_or_time()
    }

    /// Returns whether the type is `STRING` or `WSTRING`.
    pub const fn is_text(self) -> bool {
        matches!(self.family(), Family::Text)
    }

    /// Returns whether the type is `CHAR` or `WCHAR`.
    pub const fn is_character(self) -> bool {
        matches!(self.family(), Family::Character)
    }

    /// Returns whether the one type is the long form of the other: `TIME` and `LTIME`, either way.
    pub fn is_form_of(self, other: ElementaryType) -> bool {
        self.long_form() == Some(other) || other.long_form() == Some(self)
    }

    /// Returns whether only the third edition of the standard has the type.
    ///
    /// Basis: iec-61131-3: Annex B of the third edition lists the types that it added.
    pub const fn is_third_edition(self) -> bool {
        matches!(self.row().edition, Edition::Third)
    }

    /// Returns the long form of a short duration, date or time of day: `TIME` → `LTIME`, `DATE` → `LDATE` …; `None` for any
    /// other type.
    pub const fn long_form(self) -> Option<ElementaryType> {
        match self {
            E::Time => Some(E::Ltime),
            E::Date => Some(E::Ldate),
            E::Tod => Some(E::Ltod),
            E::Dt => Some(E::Ldt),
            _ => None,
        }
    }

    /// Returns the least and greatest value of an integer or bit string, and of `BOOL` (0 and 1); `None` for any other
    /// type.
    ///
    /// Basis: iec-61131-3: Table 10 and its notes.
    pub const fn integer_range(self) -> Option<(i128, i128)> {
        let bits = self.bits();
        match self.family() {
            Family::Signed => Some((-(1 << (bits - 1)), (1 << (bits - 1)) - 1)),
            Family::Unsigned | Family::BitString | Family::Boolean => Some((0, (1 << bits) - 1)),
            _ => None,
        }
    }

    /// Returns whether an integer, bit string or `BOOL` has a value of this number; `false` for other types.
    pub const fn holds(self, number: i128) -> bool {
        match self.integer_range() {
            Some((least, greatest)) => least <= number && number <= greatest,
            None => false,
        }
    }

    /// Returns the raw form of a number modulo 2^bits of an integer, bit string or `BOOL`.
    ///
    /// For `BOOL` that is the lowest bit of the number. For other types, the result has their number of low bits and no
    /// meaning.
    pub const fn wrap(self, value: i128) -> u64 {
        let spare = match self.bits() {
            0 => return 0,
            bits => 64 - bits,
        };
        let low = (value as u64) << spare;
        match self.family() {
            Family::Signed => ((low as i64) >> spare) as u64,
            _ => low >> spare,
        }
    }

    /// Returns the number that the raw form of an integer, bit string or `BOOL` represents: the inverse of
    /// [`ElementaryType::wrap`].
    ///
    /// Durations and dates give their nanoseconds, characters their code unit; for reals and texts the result has no
    /// meaning.
    pub const fn integer_value(self, raw: u64) -> i128 {
        match self.family() {
            Family::Signed | Family::Duration | Family::Date | Family::DateAndTime => raw as i64 as i128,
            _ => raw as i128,
        }
    }

    /// Returns the number that the raw form of a `REAL` or `LREAL` represents, exactly; `None` for other types.
    pub const fn real_value(self, raw: u64) -> Option<f64> {
        match self {
            ElementaryType::Real => Some(f32::from_bits(raw as u32) as f64),
            ElementaryType::Lreal => Some(f64::from_bits(raw)),
            _ => None,
        }
    }

    /// Returns the raw form of a number as a `REAL`, to which it is rounded, or else as an `LREAL`.
    pub const fn real_bits(self, number: f64) -> u64 {
        match self {
            ElementaryType::Real => (number as f32).to_bits() as u64,
            _ => number.to_bits(),
        }
    }
}

impl std::fmt::Display for ElementaryType {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(self.name())
    }
}
