template<class T> static auto value_of(const T &variable, int) -> decltype(variable.get()) { return variable.get(); }
template<class T> static T value_of(const T &variable, long) { return variable; }
