# A later version of the reference: of the small suite one case is fixed, one breaks, one crashes, and one gives another result where
# nothing is asserted.
sed -u -e 's/sum := 2 + 2;/sum := 2 + 3;/' -e '/ironplc-ed2/s/from : INT := -128;/from : INT := 128;/' \
    -e 's/REAL_TO_INT(2.5)/20/' |
    while IFS= read -r line; do
        case $line in
        *'"matiec"'*'from : SINT := -128;'*) kill -s SEGV $$ && exit ;;
        esac
        printf '%s\n' "$line"
    done | stickler engine | sed -u 's/"version":"0.1.0"/"version":"0.2.0"/'
