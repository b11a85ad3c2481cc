# Copies a few files of the real suite, named below it, with what describes the suite: a small suite of the dialects that it has.
for file in suite.toml dialects.toml sources.toml rules.md "$@"; do
    mkdir -p "$(dirname "conformance-cases/$file")"
    cp "$CASES/$file" "conformance-cases/$file"
done
