# An engine that rejects what nests comments, executes nothing, and accepts everything else.
while IFS= read -r line; do
    rest=${line#*\"id\":}
    id=${rest%%,*}
    case $line in
    *'"type":"hello"'*)
        echo '{"type":"hello","protocol":1,"name":"flat","version":"7","dialects":["ironplc-ed3"],"abilities":["check"],"grade":"rejected"}'
        ;;
    *'"type":"bye"'*) exit 0 ;;
    *'"type":"run"'*) echo "{\"type\":\"unsupported\",\"id\":$id,\"reason\":\"it only checks\"}" ;;
    *'(* '*'(* '*) echo "{\"type\":\"rejected\",\"id\":$id,\"diagnostics\":[{\"message\":\"no nesting | here\"}]}" ;;
    *) echo "{\"type\":\"accepted\",\"id\":$id}" ;;
    esac
done
