# A compiler that dies of MOD, takes WORD for a word that it does not know, and accepts all else.
while IFS= read -r line; do
    rest=${line#*\"id\":}
    id=${rest%%,*}
    case $line in
    *'"type":"hello"'*)
        echo '{"type":"hello","protocol":1,"name":"dies","version":"7","dialects":["ironplc-ed3","matiec"],"abilities":["check"]}'
        ;;
    *MOD*) exit 1 ;;
    *WORD*) echo "{\"type\":\"rejected\",\"id\":$id,\"diagnostics\":[{\"code\":\"C7\",\"message\":\"what is that?\"}]}" ;;
    *'"type":"bye"'*) exit 0 ;;
    *) echo "{\"type\":\"accepted\",\"id\":$id}" ;;
    esac
done
