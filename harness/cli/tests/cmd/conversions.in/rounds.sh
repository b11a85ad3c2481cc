# An engine that says of every program that it gives 3, as REAL_TO_INT(2.5) does where halves are rounded away from zero.
while IFS= read -r line; do
    rest=${line#*\"id\":}
    case $line in
    *'"type":"hello"'*)
        echo '{"type":"hello","protocol":1,"name":"rounds","version":"7","dialects":["matiec","plcnext"],"abilities":["execute"]}'
        ;;
    *'"type":"run"'*) echo "{\"type\":\"executed\",\"id\":${rest%%,*},\"values\":{\"given1\":\"INT#3\"}}" ;;
    *) exit 0 ;;
    esac
done
