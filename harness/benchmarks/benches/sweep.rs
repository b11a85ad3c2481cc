//! Measures how quickly inputs are swept, one function for each family of rules, on one thread. The aim
//! is 2^32 inputs of an integer source in 10 s on two cores, including the comparison: 4.6 ns for each on one.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use stickler_conversions::sweep::{Converter, Sampling, SweepMethod, agenda};
use stickler_exact::Bulk;
use stickler_types::DialectName;

/// One function of each family.
const FUNCTIONS: [(&str, &str); 13] = [
    ("integer to integer", "DINT_TO_INT"),
    ("integer to bit string", "DINT_TO_WORD"),
    ("bit string to integer", "DWORD_TO_INT"),
    ("integer to BOOL", "DINT_TO_BOOL"),
    ("integer to REAL", "DINT_TO_REAL"),
    ("integer to LREAL", "UDINT_TO_LREAL"),
    ("integer to TIME", "DINT_TO_TIME"),
    ("from BCD", "DWORD_BCD_TO_UDINT"),
    ("to BCD", "UDINT_TO_BCD_DWORD"),
    ("REAL to integer", "REAL_TO_INT"),
    ("REAL to LREAL", "REAL_TO_LREAL"),
    ("REAL to TIME", "REAL_TO_TIME"),
    ("REAL to BOOL", "REAL_TO_BOOL"),
];

/// The number of inputs that a sweep converts before it compares.
const BLOCK: usize = 1024;

/// The number of blocks, spread over all 32 bits.
const BLOCKS: u64 = 1024;

fn families(criterion: &mut Criterion) {
    let dialect = DialectName::MATIEC;
    let mut group = criterion.benchmark_group("sweep");
    group
        .throughput(Throughput::Elements(BLOCKS * BLOCK as u64))
        .sample_size(10);
    for (family, function) in FUNCTIONS {
        let sweeps = agenda(function, &[dialect], Sampling::default(), SweepMethod::Conversion);
        let sweep = sweeps.expect("the dialect has it").remove(0);
        let bulk = Bulk::new(&sweep.signature, &sweep.choices).expect("it has a quick form");
        let (mut operands, mut results, mut expected) = (vec![0; BLOCK], vec![0; BLOCK], vec![0; BLOCK]);
        group.bench_function(format!("{family}, {function}"), |bencher| {
            bencher.iter(|| {
                let mut equal = true;
                for block in 0..BLOCKS {
                    let start = block << 22;
                    sweep
                        .domain
                        .fill(black_box(start..start + BLOCK as u64), &mut operands);
                    sweep.reference.convert_all(&operands, &mut results);
                    bulk.fill(&operands, &mut expected);
                    equal &= black_box(&results) == &expected;
                }
                equal
            });
        });
    }
    group.finish();
}

criterion_group!(benches, families);
criterion_main!(benches);
