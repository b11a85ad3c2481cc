# Builds the fuzz targets for ClusterFuzzLite in a clone that has nothing but a folder of inputs for each of them.
chmod +x bin/*
mkdir -p out clone/fuzz clone/corpus clone/target/x86_64-unknown-linux-gnu/release
cp "$ROOT/fuzz/st.dict" clone/fuzz
for target in "$ROOT"/fuzz/fuzz_targets/*.rs; do mkdir "clone/corpus/$(basename "$target" .rs)"; done
out=$PWD/out path=$PWD/bin
cd clone && OUT=$out PATH=$path:$PATH bash "$ROOT/.clusterfuzzlite/build.sh"
