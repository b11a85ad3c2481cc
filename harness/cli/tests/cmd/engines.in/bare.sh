# Runs `stickler` where no compiler can be found.
here=$(cd "$(dirname "$0")" && pwd)
exec env -i NO_COLOR=1 CARGO_MANIFEST_DIR= PATH="$here/bin" "$STICKLER" "$@"
