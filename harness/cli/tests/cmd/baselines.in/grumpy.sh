# An engine that rejects every program without a line, but accepts those that contain `$KNOWS`, without running them.
: "${KNOWS:=nothing of this kind}"
while IFS= read -r line; do
    rest=${line#*\"id\":}
    case $line in
    *'"type":"hello"'*)
        echo '{"type":"hello","protocol":1,"name":"grumpy","version":"1.4","dialects":["ironplc-ed2","matiec"],"abilities":["check"],"grade":"rejected"}'
        ;;
    *'"type":"bye"'*) exit 0 ;;
    *"$KNOWS"*) echo "{\"type\":\"accepted\",\"id\":${rest%%,*}}" ;;
    *) echo "{\"type\":\"rejected\",\"id\":${rest%%,*},\"diagnostics\":[{\"message\":\"no\"}]}" ;;
    esac
done
