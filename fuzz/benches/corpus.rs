//! How many inputs a second each target judges, without libFuzzer: `cargo bench -p stickler-fuzz -- parse`.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use std::path::Path;
use stickler_fuzz::Target;

fn corpora(criterion: &mut Criterion) {
    for target in Target::ALL {
        let folder = Path::new("../corpus").join(target.name());
        let files = std::fs::read_dir(&folder).into_iter().flatten().flatten();
        let inputs: Vec<Vec<u8>> = files.filter_map(|file| std::fs::read(file.path()).ok()).collect();
        let mut group = criterion.benchmark_group("corpus");
        group
            .throughput(Throughput::Elements(inputs.len() as u64))
            .sample_size(10);
        group.bench_function(target.name(), |bencher| {
            bencher.iter(|| {
                for input in &inputs {
                    let _ = black_box(target.judge(black_box(input)));
                }
            });
        });
        group.finish();
    }
}

criterion_group!(benches, corpora);
criterion_main!(benches);
