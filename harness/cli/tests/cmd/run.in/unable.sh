# An engine that answers `unsupported` to every request.
while read -r line; do
    id=$(printf '%s' "$line" | sed -n 's/.*"id":\([0-9]*\).*/\1/p')
    case "$line" in
    *'"hello"'*) echo '{"type":"hello","protocol":1,"name":"unable","version":"1","dialects":["ironplc-ed2","ironplc-ed3"],"abilities":["check","execute"]}' ;;
    *'"bye"'*) exit 0 ;;
    *) echo "{\"type\":\"unsupported\",\"id\":$id,\"reason\":\"not written yet\"}" ;;
    esac
done
