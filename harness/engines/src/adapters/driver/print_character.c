static void print_character(unsigned unit) {
    if (unit >= ' ' && unit <= '~' && unit != '$')
        printf("%c", unit);
    else
        printf("$%02X", unit);
}
