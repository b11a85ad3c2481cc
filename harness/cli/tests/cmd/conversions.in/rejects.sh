# An engine that knows no function, and dies of negative numbers.
while IFS= read -r line; do
    rest=${line#*\"id\":}
    case $line in
    *'"type":"hello"'*)
        echo '{"type":"hello","protocol":1,"name":"rejects","version":"1","dialects":["matiec"],"abilities":["execute"]}'
        ;;
    *' := REAL#-'*)
        echo 'segmentation fault' >&2
        exit 139
        ;;
    *'"type":"run"'*)
        echo "{\"type\":\"rejected\",\"id\":${rest%%,*},\"diagnostics\":[{\"message\":\"unknown function\"}]}"
        ;;
    *) exit 0 ;;
    esac
done
