# Exports the questions of a recording whose names contain $1 to the folder $2, lets the reference answer by the command that follows, as
# if it were the compiler behind the editor, and records what it answers.
filter=$1
pages=$2
shift 2
mkdir -p conformance-cases/recordings
stickler export --recording --dialect mine --filter "$filter" --cases-per-page 300 "$pages" > "$pages.log" || cat "$pages.log"
stickler "$@" --dialect mine "$pages/page-001.st" > "$pages.txt" 2>&1
stickler import "$pages.txt" --export "$pages" --no-report --record conformance-cases/recordings/my-plc.toml \
    --product MyPLC --product-version 2.1 --platform 'a simulation' --date 2026-11-25
