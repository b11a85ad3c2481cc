# A compiler with an error of a hundred kilobytes for every program, with bytes that are no UTF-8 and with markup.
printf '%s:1: error E1 \377\376 </script><img src=x onerror=alert(1)> <!-- & ' "$1"
head -c 100000 /dev/zero | tr '\0' x
echo
exit 1
