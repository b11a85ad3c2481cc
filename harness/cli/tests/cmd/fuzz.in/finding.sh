# Prints the folder of the finding in the folder $1 whose rule is MOD alone.
dirname "$(grep -lzE '"rule": \[\s*"mod"\s*\]' "$1"/*/finding.json | head -n 1)"
