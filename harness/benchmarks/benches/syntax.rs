//! Measures the speed of lexer and parser, on ten megabytes of each of three kinds of text. The aim
//! is 100 MB/s through lexer and parser on one core, for the usual text.

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use std::time::Duration;
use stickler_syntax::source::LineIndex;
use stickler_syntax::{parse, render};
use stickler_types::Dialect;
use stickler_types::DialectName;

const LENGTH: usize = 10_000_000;

/// A typical function block.
const USUAL: &str = include_str!("texts/motor.st");

/// A program without a space that could be omitted: the worst case, two tokens every three bytes; no aim is set for it.
const DENSE: &str = "PROGRAM p x:=a+b*c-d[i];y:=(x+1)*2;f(a,b);END_PROGRAM\n";

/// A text that is mostly a comment.
const COMMENTED: &str = "(* A long comment, as generators and careful people write them above a program that is
   short: who wrote it, when, by which document, and what it must never do. *)\nPROGRAM p x := 1; END_PROGRAM\n";

fn syntax(criterion: &mut Criterion) {
    let dialect = Dialect::of(DialectName::IRONPLC_ED3);
    for (name, piece) in [("usual", USUAL), ("dense", DENSE), ("commented", COMMENTED)] {
        let text = piece.repeat(LENGTH / piece.len());
        let (unit, diagnostics) = parse(&text, dialect);
        assert_eq!(diagnostics, [], "the benchmark's text is acceptable");
        let mut group = criterion.benchmark_group(name);
        group
            .throughput(Throughput::Bytes(text.len() as u64))
            .sample_size(20);
        group.measurement_time(Duration::from_secs(4));
        group.bench_function("lex and parse", |bencher| {
            // The tree is dropped outside the measurement.
            bencher.iter_batched(
                || (),
                |()| parse(black_box(&text), dialect),
                BatchSize::PerIteration,
            );
        });
        group.bench_function("render", |bencher| {
            bencher.iter(|| render(black_box(&unit), &text))
        });
        group.bench_function("line index", |bencher| {
            bencher.iter(|| LineIndex::new(black_box(&text)))
        });
        group.finish();
    }
}

criterion_group!(benches, syntax);
criterion_main!(benches);
