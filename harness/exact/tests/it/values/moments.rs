//! Values of durations, dates and times of day, computed by hand.

use super::common::check;
use stickler_exact::{choices_of, signatures, value};
use stickler_types::{DialectName, ElementaryType, Value};

#[test]
fn durations_count_in_milliseconds() {
    check(
        DialectName::MATIEC,
        &[
            ("TIME_TO_DINT", "TIME#1500ms", "DINT#1500"),
            ("TIME_TO_DINT", "TIME#-1.999ms", "DINT#-1"),
            ("TIME_TO_INT", "TIME#32768ms", "INT#-32768"),
            ("TIME_TO_UINT", "TIME#65537ms", "UINT#1"),
            ("TIME_TO_WORD", "TIME#-1ms", "WORD#16#FFFF"),
            ("TIME_TO_BOOL", "TIME#1ns", "BOOL#TRUE"),
            ("TIME_TO_BOOL", "TIME#0ms", "BOOL#FALSE"),
            ("TIME_TO_REAL", "TIME#1.5ms", "REAL#1.5"),
            ("TIME_TO_REAL", "TIME#16777217ms", "REAL#16777216.0"),
            ("TIME_TO_LREAL", "TIME#1ns", "LREAL#1.0E-6"),
            (
                "TIME_TO_LREAL",
                "TIME#-9223372036854.775808ms",
                "LREAL#-9223372036854.775",
            ),
            ("TIME_TO_LREAL", "TIME#0ms", "LREAL#0.0"),
            ("DINT_TO_TIME", "DINT#-5", "TIME#-5ms"),
            ("BOOL_TO_TIME", "BOOL#TRUE", "TIME#1ms"),
            // 2^64 - 1 milliseconds are -1 of them, modulo 2^64 nanoseconds.
            ("ULINT_TO_TIME", "ULINT#18446744073709551615", "TIME#-1ms"),
            // 9223372036855 * 10^6 - 2^64 nanoseconds.
            (
                "LINT_TO_TIME",
                "LINT#9223372036855",
                "TIME#-9223372036854.551616ms",
            ),
            ("REAL_TO_TIME", "REAL#1.5", "TIME#1.5ms"),
            ("LREAL_TO_TIME", "LREAL#-0.1", "TIME#-0.1ms"),
            ("LREAL_TO_TIME", "LREAL#NaN", "TIME#0ms"),
            ("LREAL_TO_TIME", "LREAL#Infinity", "TIME#0ms"),
            // 2^-7 ms are 7812.5 ns and 3 * 2^-7 ms are 23437.5 ns: ties.
            ("LREAL_TO_TIME", "LREAL#0.0078125", "TIME#0.007812ms"),
            ("LREAL_TO_TIME", "LREAL#0.0234375", "TIME#0.023438ms"),
            ("LREAL_TO_TIME", "LREAL#-0.0078125", "TIME#-0.007812ms"),
            ("LREAL_TO_TIME", "LREAL#1.0E300", "TIME#0ms"),
        ],
    );
}

#[test]
fn dates_count_in_seconds_and_times_of_day_in_milliseconds() {
    check(
        DialectName::PLCNEXT,
        &[
            ("DATE_TO_DINT", "DATE#1970-01-02", "DINT#86400"),
            ("LDATE_TO_LINT", "LDATE#1969-12-31", "LINT#-86400"),
            ("DT_TO_UDINT", "DT#2038-01-19-03:14:08", "UDINT#2147483648"),
            ("DT_TO_DINT", "DT#1969-12-31-23:59:59.5", "DINT#0"),
            ("DT_TO_LREAL", "DT#1969-12-31-23:59:59.5", "LREAL#-0.5"),
            ("TOD_TO_DINT", "TOD#23:59:59.9999", "DINT#86399999"),
            ("DINT_TO_DATE", "DINT#86401", "DATE#1970-01-02"),
            ("DINT_TO_DATE", "DINT#-1", "DATE#1969-12-31"),
            ("DINT_TO_DT", "DINT#-1", "DT#1969-12-31-23:59:59"),
            ("DINT_TO_TOD", "DINT#-1", "TOD#23:59:59.999"),
            ("UDINT_TO_LTOD", "UDINT#86400001", "LTOD#00:00:00.001"),
            ("LREAL_TO_LDT", "LREAL#1.5", "LDT#1970-01-01-00:00:01.5"),
            ("REAL_TO_DATE", "REAL#-0.5", "DATE#1969-12-31"),
            ("REAL_TO_TOD", "REAL#NaN", "TOD#00:00:00"),
        ],
    );
}

#[test]
fn dates_and_times_are_taken_apart_and_widened() {
    check(
        DialectName::IRONPLC_RUSTY,
        &[
            ("DATE_TO_DT", "DATE#2024-02-29", "DT#2024-02-29-00:00:00"),
            ("DATE_TO_LDATE", "DATE#2100-02-28", "LDATE#2100-02-28"),
            (
                "DT_TO_DATE",
                "DT#2000-02-29-23:59:59.999999999",
                "DATE#2000-02-29",
            ),
            (
                "DT_TO_DATE",
                "DT#1969-12-31-23:59:59.999999999",
                "DATE#1969-12-31",
            ),
            ("DT_TO_DATE", "DT#1970-01-01-00:00:00", "DATE#1970-01-01"),
            ("DT_TO_TOD", "DT#1969-12-31-23:59:59.5", "TOD#23:59:59.5"),
            (
                "LDT_TO_LTOD",
                "LDT#2262-04-11-23:47:16.854775807",
                "LTOD#23:47:16.854775807",
            ),
            (
                "LDT_TO_DATE",
                "LDT#2262-04-11-23:47:16.854775807",
                "DATE#2262-04-11",
            ),
            // The first day that 64 bits reach begins before them.
            (
                "LDT_TO_DATE",
                "LDT#1677-09-21-00:12:43.145224192",
                "DATE#1677-09-22",
            ),
            (
                "LDT_TO_LTOD",
                "LDT#1677-09-21-00:12:43.145224192",
                "LTOD#00:12:43.145224192",
            ),
            (
                "LDT_TO_DT",
                "LDT#2024-02-29-12:00:00.000000001",
                "DT#2024-02-29-12:00:00.000000001",
            ),
            ("TIME_TO_TOD", "TIME#25h", "TOD#01:00:00"),
            ("LTIME_TO_LTOD", "LTIME#-1ns", "LTOD#23:59:59.999999999"),
            ("TOD_TO_TIME", "TOD#23:59:59.999", "TIME#86399999ms"),
            ("LTIME_TO_TIME", "LTIME#-1ns", "TIME#-0.000001ms"),
            ("TO_TOD", "DT#2024-02-29-12:34:56", "TOD#12:34:56"),
        ],
    );
}

#[test]
fn a_date_and_a_time_of_day_are_joined() {
    let joined = |function, date, time| {
        let operands = [date, time].map(|literal| Value::parse(literal).unwrap());
        let found = signatures(function, DialectName::IRONPLC_ED3);
        assert_eq!(found.len(), 1, "{function}");
        let choices = choices_of(DialectName::IRONPLC_ED3);
        value(&found[0], &operands, &choices).to_string()
    };
    assert_eq!(
        joined("concat_date_tod", "DATE#2024-02-29", "TOD#12:34:56.789"),
        "DT#2024-02-29-12:34:56.789"
    );
    assert_eq!(
        joined("CONCAT_DATE_LTOD", "DATE#1969-12-31", "LTOD#23:59:59.999999999"),
        "LDT#1969-12-31-23:59:59.999999999"
    );
    // One nanosecond too late: the first moment of all.
    assert_eq!(
        joined("CONCAT_LDATE_LTOD", "LDATE#2262-04-11", "LTOD#23:47:16.854775808"),
        "LDT#1677-09-21-00:12:43.145224192"
    );
}

#[test]
fn joining_and_taking_apart_are_inverse() {
    let dialect = DialectName::IRONPLC_ED3;
    let choices = choices_of(dialect);
    let call = |function: &str, operands: &[Value]| {
        let found = signatures(function, dialect);
        value(&found[0], operands, &choices)
    };
    for step in -200..=200_i64 {
        // A prime number of nanoseconds, so that all kinds of days and times come up.
        let moment = Value::plain(
            ElementaryType::Ldt,
            (step * 45_999_999_999_999_997).cast_unsigned(),
        );
        let date = call("LDT_TO_LDATE", std::slice::from_ref(&moment));
        let time = call("LDT_TO_LTOD", std::slice::from_ref(&moment));
        assert_eq!(call("CONCAT_LDATE_LTOD", &[date, time]), moment);
    }
}
