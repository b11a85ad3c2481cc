# A compiler that rejects what divides with remainder; after a few answers it says so by the file `under-way`, and becomes slow.
count=0
while IFS= read -r line; do
    rest=${line#*\"id\":}
    case $line in
    *'"type":"hello"'*)
        echo '{"type":"hello","protocol":1,"name":"slow","version":"7","dialects":["matiec"],"abilities":["check"]}'
        continue
        ;;
    *'"type":"bye"'*) exit 0 ;;
    esac
    count=$((count + 1))
    if [ $count -gt 4 ]; then
        : >under-way
        sleep 0.3
    fi
    case $line in
    *MOD*) echo "{\"type\":\"rejected\",\"id\":${rest%%,*},\"diagnostics\":[{\"code\":\"C7\",\"message\":\"no\"}]}" ;;
    *) echo "{\"type\":\"accepted\",\"id\":${rest%%,*}}" ;;
    esac
done
