# A compiler that never comes back from REPEAT, and accepts all else.
while IFS= read -r line; do
    rest=${line#*\"id\":}
    case $line in
    *'"type":"hello"'*)
        echo '{"type":"hello","protocol":1,"name":"silent","version":"7","dialects":["matiec"],"abilities":["check"]}'
        ;;
    *REPEAT*) sleep 30 ;;
    *'"type":"bye"'*) exit 0 ;;
    *) echo "{\"type\":\"accepted\",\"id\":${rest%%,*}}" ;;
    esac
done
