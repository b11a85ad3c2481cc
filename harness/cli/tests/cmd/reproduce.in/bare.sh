# Runs `stickler` where no compiler can be found.
exec env -i NO_COLOR=1 CARGO_MANIFEST_DIR= PATH= "$STICKLER" "$@"
