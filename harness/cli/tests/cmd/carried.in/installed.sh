# Runs a copy of the program outside of the clone, in an empty folder and with a home of its own.
program=$PWD/bin/stickler
export HOME="$PWD/home" XDG_CACHE_HOME="$PWD/home/.cache"
cd empty && exec "$program" "$@"
