template<class T> static void print_bits(int number, T value) {
    unsigned long long bits = 0;
    static_assert(sizeof value <= sizeof bits);
    std::memcpy(&bits, &value, sizeof value);
    std::printf("%d %llx\n", number, bits);
}
template<class T> static void print_text(int number, const T &value) {
    std::printf("%d '", number);
    for (std::size_t at = 0; at < value.length(); at++) {
        unsigned unit = static_cast<unsigned>(value[at]);
        std::printf("%04x", sizeof value[0] == 1 ? unit & 0xffu : unit & 0xffffu);
    }
    std::printf("\n");
}
