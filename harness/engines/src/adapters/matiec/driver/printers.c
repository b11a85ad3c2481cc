static void print_bits(int number, const void *value, size_t size) {
    unsigned long long bits = 0;
    memcpy(&bits, value, size);
    printf("%d %llx\n", number, bits);
}
static void print_time(int number, TIME value) {
    printf("%d %lld %lld\n", number, (long long)value.tv_sec, (long long)value.tv_nsec);
}
static void print_text(int number, STRING value) {
    printf("%d '", number);
    for (int at = 0; at < value.len; at++)
        printf("%02x", value.body[at]);
    printf("\n");
}
