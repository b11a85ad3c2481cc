//! How quickly programs are made, written and evaluated: programs and bytes of text a second.

use arbitrary::Unstructured;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use stickler_generate::evaluate::evaluate;
use stickler_generate::generator::{Settings, program};
use stickler_generate::model::Program;
use stickler_generate::writer::{Style, write};

/// So many programs are made in turn, of all dialects and sizes.
const PROGRAMS: u64 = 200;

/// The bytes of a seed, by splitmix64.
fn bytes(seed: u64) -> Vec<u8> {
    let length = (seed * 7 % 3000) as usize;
    let mut state = seed;
    let mut bytes = Vec::with_capacity(length + 8);
    while bytes.len() < length {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (state ^ (state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bytes.extend((mixed ^ (mixed >> 31)).to_le_bytes());
    }
    bytes.truncate(length);
    bytes
}

fn make(bytes: &[u8]) -> Program {
    program(&mut Unstructured::new(bytes), &Settings::default())
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
