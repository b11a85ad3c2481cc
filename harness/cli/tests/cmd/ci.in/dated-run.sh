# Runs the small suite, and makes of it the run of version $2 of the engine on a day of November.
stickler run --cases "$SUITE" --report "$1" --quiet
gzip -dc "$1/events.jsonl.gz" | sed -e "s/\"started\":\"[^\"]*\"/\"started\":\"2026-11-$3T12:00:00Z\"/" -e "s/\"version\":\"0.1.0\"/\"version\":\"$2\"/" \
    | gzip > log && mv log "$1/events.jsonl.gz"
