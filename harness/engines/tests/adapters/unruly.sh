# An adapter that does what the source of a request tells it to, most of it against the protocol.
# Nothing here takes a time of its own: what hangs, hangs until it is killed.
answer() {
    printf '{"type":"accepted","id":%s}\n' "$1"
}

number() {
    rest=${1#*\"id\":}
    printf '%s' "${rest%%,*}"
}

while IFS= read -r line; do
    case $line in
    *'"type":"hello"'*)
        printf '{"type":"hello","protocol":1,"name":"unruly","version":"%s","dialects":["matiec"],"abilities":["check"]}\n' "$$"
        ;;
    *'"type":"bye"'*)
        test -z "$FAREWELL" || printf 'bye\n' >"$FAREWELL"
        exit 0
        ;;
    *'please: exit'*)
        printf 'first\nout of cheese\n' >&2
        exit 7
        ;;
    *'please: die'*) kill -KILL $$ ;;
    *'please: hang'*) tail -f /dev/null ;;
    *'please: flood'*) while :; do printf 'xxxxxxxxxxxxxxxx'; done ;;
    *'please: talk'*) printf 'compiling...\n' ;;
    *'please: binary'*) printf '\377\376\n' ;;
    *'please: begin an answer'*)
        printf '{"type":"accep'
        tail -f /dev/null
        ;;
    *'please: break off'*)
        printf '{"type":"accepted","id":'
        exit 0
        ;;
    *'please: mistake the id'*) answer 4294967295 ;;
    *'please: run ahead'*) answer "$(($(number "$line") + 1))" ;;
    *'please: ignore signals'*)
        trap '' TERM INT HUP PIPE
        while :; do tail -f /dev/null; done
        ;;
    *'please: repeat'*)
        answer "$(number "$line")"
        answer "$(number "$line")"
        ;;
    *'please: leave a child'*)
        # The child keeps the pipe open that the test reads.
        exec 9>"$WITNESS"
        tail -f /dev/null >/dev/null 2>&1 &
        exit 7
        ;;
    *'please: orphan the output'*)
        tail -f /dev/null 2>/dev/null &
        exit 7
        ;;
    *'please: complain'*)
        while :; do printf 'a complaint that goes on and on\n'; done | head -n 10000 >&2
        answer "$(number "$line")"
        ;;
    *'please: stop reading'*)
        answer "$(number "$line")"
        tail -f /dev/null
        ;;
    *) answer "$(number "$line")" ;;
    esac
done
