static void print_wide_character(unsigned unit) {
    if (unit >= ' ' && unit <= '~' && unit != '$')
        printf("%c", unit);
    else
        printf("$%04X", unit);
}
