/* Days whose seconds do not fit in 64 bits are no date; their number is printed all the same. */
static void print_days(const char *name, long long days) {
    time_t time = days > -100000000000000LL && days < 100000000000000LL ? days * 86400LL : -1;
    struct tm *date = time == -1 ? NULL : gmtime(&time);
    char text[64] = "no date";
    if (date)
        strftime(text, sizeof text, "%Y-%m-%d", date);
    printf("%s = %s (%lld d)\n", name, text, days);
}
