template<class T> static auto number_of(T &&value, int) -> decltype(value.to_int()) { return value.to_int(); }
template<class T> static T number_of(T &&value, long) { return static_cast<T &&>(value); }
template<class T> static auto value_of(const T &variable, int) -> decltype(number_of(variable.get(), 0)) {
    return number_of(variable.get(), 0);
}
template<class T> static T value_of(const T &variable, long) { return variable; }
