# An engine whose dialects nobody here knows, and whose name would turn a terminal red.
echo '{"type":"hello","protocol":1,"name":"\u001b[31mfar","version":"1","dialects":["melsec"],"abilities":["execute"]}'
