# A compiler that dies of the first program that its caller gives it, and accepts all else.
mark=${TMPDIR:-/tmp}/stickler-flaky-$PPID
while IFS= read -r line; do
    rest=${line#*\"id\":}
    case $line in
    *'"type":"hello"'*)
        echo '{"type":"hello","protocol":1,"name":"flaky","version":"7","dialects":["matiec"],"abilities":["check"]}'
        ;;
    *'"type":"bye"'*)
        rm -f "$mark"
        exit 0
        ;;
    *)
        if [ ! -e "$mark" ]; then
            : >"$mark"
            exit 1
        fi
        echo "{\"type\":\"accepted\",\"id\":${rest%%,*}}"
        ;;
    esac
done
