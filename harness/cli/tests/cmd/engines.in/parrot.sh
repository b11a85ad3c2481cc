# An adapter whose arguments are its replies to the requests after `hello`, in their order; then it ends.
read -r line
printf '%s\n' '{"type":"hello","protocol":1,"name":"parrot","version":"1","dialects":["matiec"],"abilities":["check"]}'
for reply in "$@"; do
    read -r line || exit 0
    printf '%s\n' "$reply"
done
read -r line
