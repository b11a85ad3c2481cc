//! Measures how quickly programs are generated, written and evaluated: in programs and bytes of text per second.
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use stickler_generate::evaluate::evaluate;
use stickler_generate::generator::{GeneratorSettings, program};
use stickler_generate::model::Program;
use stickler_generate::writer::{Style, write};

/// The number of programs that are generated in turn, of all dialects and sizes.
const PROGRAMS: u64 = 200;

/// Returns the bytes of a seed, which yield programs of every size.
fn bytes(seed: u64) -> Vec<u8> {
    stickler_generate::random::bytes(seed, (seed * 7 % 3000) as usize)
}

fn make(bytes: &[u8]) -> Program {
    program(bytes, &GeneratorSettings::default())
}

fn generation(criterion: &mut Criterion) {
    let inputs: Vec<Vec<u8>> = (0..PROGRAMS).map(|seed| bytes(seed * 13)).collect();
    let programs: Vec<Program> = inputs.iter().map(|bytes| make(bytes)).collect();
    let texts: usize = programs
        .iter()
        .map(|program| write(program, &Style::default()).text.len())
        .sum();

    let mut group = criterion.benchmark_group("programs");
    group.throughput(Throughput::Elements(PROGRAMS));
    group.bench_function("generate", |bencher| {
        bencher.iter(|| inputs.iter().for_each(|bytes| drop(black_box(make(bytes)))));
    });
    group.bench_function("evaluate", |bencher| {
        bencher.iter(|| {
            programs
                .iter()
                .for_each(|program| drop(black_box(evaluate(program, 1))))
        });
    });
    group.finish();

    let mut group = criterion.benchmark_group("text");
    group.throughput(Throughput::Bytes(texts as u64));
    group.bench_function("write", |bencher| {
        bencher.iter(|| {
            programs
                .iter()
                .for_each(|program| drop(black_box(write(program, &Style::default()))))
        });
    });
    group.finish();
}

criterion_group!(benches, generation);
criterion_main!(benches);
