# Copies the features, the sources and one case of the real suite, which are read faster than all of it.
mkdir -p conformance-cases/language
cp "$CASES"/*.toml "$CASES"/*.md conformance-cases
cp "$CASES"/language/comments-nested.st conformance-cases/language
cp -r "$CASES"/measurements conformance-cases
