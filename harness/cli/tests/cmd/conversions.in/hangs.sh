# An engine that never answers. What it is asked first, it tells the witness by opening the pipe of that name.
read -r hello
echo '{"type":"hello","protocol":1,"name":"hangs","version":"1","dialects":["matiec"],"abilities":["execute"]}'
read -r request
exec 9>"$WITNESS"
# With its output closed it does not notice that nobody listens any more.
tail -f /dev/null >/dev/null 2>&1
