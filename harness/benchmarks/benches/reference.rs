//! Measures the speed of the reference. Its aims: 100 MB/s through lexer and parser, 10 µs
//! for a small case end to end, 2^32 conversions of an integer source in 10 s on two cores (4.6 ns each on one).

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use std::time::Duration;
use stickler_reference::conversion::{Conversion, Parameter, function};
use stickler_reference::{Limits, check, run};
use stickler_syntax as syntax;
use stickler_types::Dialect;
use stickler_types::{DialectName, Observation, Outcome, RunRequest};

const DIALECT: DialectName = DialectName::IRONPLC_ED3;

/// Returns a case of a widening table: it runs if the one type widens to the other, and is rejected otherwise.
fn case(from: &str, into: &str) -> String {
    include_str!("texts/widening.st")
        .replace("FROM", from)
        .replace("INTO", into)
}

/// A typical function, repeated under many names.
const FUNCTION: &str = include_str!("texts/clamp.st");

fn large_source() -> String {
    (0..1_500)
        .map(|number| FUNCTION.replace('@', &number.to_string()))
        .collect()
}

/// Runs one small case end to end.
fn execute(source: &str, observe: &[Observation]) -> Outcome {
    let request = RunRequest::once(DIALECT, black_box(source), observe);
    run(&request, Limits::default()).expect("`into` is a variable")
}

fn stages(criterion: &mut Criterion) {
    let source = large_source();
    assert_eq!(
        check(&source, DIALECT),
        [],
        "the benchmark's source is acceptable"
    );
    let dialect = Dialect::of(DIALECT);
    let mut group = criterion.benchmark_group("stages");
    group
        .throughput(Throughput::Bytes(source.len() as u64))
        .measurement_time(Duration::from_secs(4));
    group.bench_function("lex and parse", |bencher| {
        // The tree is dropped outside the measurement.
        bencher.iter_batched(
            || (),
            |()| syntax::parse(black_box(&source), dialect),
            BatchSize::LargeInput,
        );
    });
    group.bench_function("check", |bencher| {
        bencher.iter(|| check(black_box(&source), DIALECT))
    });
    group.finish();
}

fn small_case(criterion: &mut Criterion) {
    let into = [Observation::last("into", "")];
    let (widens, narrows) = (case("INT", "DINT"), case("DINT", "INT"));
    assert!(matches!(execute(&widens, &into), Outcome::Executed { .. }));
    assert!(matches!(execute(&narrows, &into), Outcome::Rejected { .. }));
    let mut group = criterion.benchmark_group("small case");
    group.bench_function("executed", |bencher| bencher.iter(|| execute(&widens, &into)));
    group.bench_function("rejected", |bencher| bencher.iter(|| execute(&narrows, &into)));
    group.finish();
}

fn steps(criterion: &mut Criterion) {
    let into = [Observation::last("into", "")];
    let source = "PROGRAM main VAR i : DINT; into : DINT; END_VAR
        FOR i := 1 TO 100000 DO into := into + i MOD 7; END_FOR; END_PROGRAM";
    assert!(matches!(execute(source, &into), Outcome::Executed { .. }));
    let mut group = criterion.benchmark_group("steps");
    group.throughput(Throughput::Elements(100_000)).sample_size(20);
    group.bench_function("turns of a loop", |bencher| {
        bencher.iter(|| execute(source, &into))
    });
    group.finish();
}

/// Returns the conversion of a function that takes one type.
fn conversion(name: &str) -> Conversion {
    let function = function(name, Dialect::of(DIALECT)).expect("the catalogue has the function");
    let Parameter::Exactly(from) = function.parameter else {
        panic!("{name} is overloaded")
    };
    function.conversion(from, function.result_type(from, None))
}

fn conversions(criterion: &mut Criterion) {
    /// The number of operands that fit the nearest cache, like the blocks of a sweep.
    const OPERANDS: u64 = 1 << 10;
    let mut group = criterion.benchmark_group("conversions");
    group.throughput(Throughput::Elements(OPERANDS)).sample_size(10);
    for name in [
        "DINT_TO_INT",
        "DINT_TO_REAL",
        "UDINT_TO_LREAL",
        "DINT_TO_TIME",
        "DWORD_BCD_TO_UDINT",
        "UDINT_TO_BCD_DWORD",
        "REAL_TO_INT",
        "REAL_TO_TIME",
    ] {
        let conversion = conversion(name);
        // All 32 bits vary, and the raw form of a signed operand is sign-extended.
        let signed = conversion.from.is_signed();
        let operands: Vec<u64> = (0..OPERANDS)
            .map(|n| {
                let bits = (n * 268_435_399) as u32;
                if signed {
                    i64::from(bits.cast_signed()).cast_unsigned()
                } else {
                    bits.into()
                }
            })
            .collect();
        let mut results = vec![0; operands.len()];
        group.bench_function(name, |bencher| {
            bencher.iter(|| conversion.apply_to_slice(black_box(&operands), black_box(&mut results)));
        });
    }
    group.finish();
}

criterion_group!(benches, stages, small_case, steps, conversions);
criterion_main!(benches);
