static void print_date(const char *name, const char *format, long long seconds, long long nanoseconds) {
    time_t time = seconds;
    struct tm *date = gmtime(&time);
    char text[64] = "no date";
    if (date)
        strftime(text, sizeof text, format, date);
    printf("%s = %s (%lld s + %lld ns)\n", name, text, seconds, nanoseconds);
}
