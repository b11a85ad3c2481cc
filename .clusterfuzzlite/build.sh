#!/usr/bin/env bash
# Builds every fuzz target, and puts it into $OUT with its seed corpus and, where its inputs are text, the dictionary.
set -euo pipefail

cargo fuzz build -O
for target in $(cargo fuzz list); do
    # The targets are built in the folder of the workspace.
    cp "target/x86_64-unknown-linux-gnu/release/$target" "$OUT/"
    if [ -d "corpus/$target" ]; then
        zip -q -j -r "$OUT/${target}_seed_corpus.zip" "corpus/$target"
    fi
    case "$target" in
        parse | literal | case_file | protocol) cp fuzz/st.dict "$OUT/$target.dict" ;;
    esac
done
