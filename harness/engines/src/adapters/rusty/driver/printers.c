static const unsigned long *after;
static unsigned long scan;
static void print_bits(int32_t number, const void *value, size_t size) {
    unsigned long long bits = 0;
    memcpy(&bits, value, size);
    if (after[number] == scan) printf("%d %llx\n", (int)number, bits);
}
static void print_bytes(int32_t number, const unsigned char *text) {
    if (after[number] != scan) return;
    printf("%d '", (int)number);
    for (; *text; text++) printf("%04x", *text);
    printf("\n");
}
static void print_units(int32_t number, const uint16_t *text) {
    if (after[number] != scan) return;
    printf("%d '", (int)number);
    for (; *text; text++) printf("%04x", *text);
    printf("\n");
}
