//! Measures how many inputs per second each fuzz target judges, without libFuzzer: `cargo bench -p stickler-benchmarks
//! --bench targets -- parse`.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use std::path::Path;
use std::{fs, io};
use stickler_generate::oracles::FuzzTarget;

fn corpora(criterion: &mut Criterion) {
    for target in FuzzTarget::ALL {
        let folder = Path::new("../../corpus").join(target.as_str());
        let inputs = inputs(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
        assert!(
            !inputs.is_empty(),
            "{}: the folder holds no input",
            folder.display()
        );
        let mut group = criterion.benchmark_group("corpus");
        group
            .throughput(Throughput::Elements(inputs.len() as u64))
            .sample_size(10);
        group.bench_function(target.as_str(), |bencher| {
            bencher.iter(|| {
                for input in &inputs {
                    let _ = black_box(target.judge(black_box(input)));
                }
            });
        });
        group.finish();
    }
}

/// Returns the contents of the files in a folder.
fn inputs(folder: &Path) -> io::Result<Vec<Vec<u8>>> {
    fs::read_dir(folder)?.map(|file| fs::read(file?.path())).collect()
}

criterion_group!(benches, corpora);
criterion_main!(benches);
