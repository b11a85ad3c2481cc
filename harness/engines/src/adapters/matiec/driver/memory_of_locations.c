#define __LOCATED_VAR(type, name, ...) static long long located##name[8192];
#undef __INIT_LOCATED
#define __INIT_LOCATED(type, location, name, retained) \
    { name.value = (type *)located##location; __INIT_RETAIN(name, retained) }
#undef __INIT_GLOBAL_LOCATED
#define __INIT_GLOBAL_LOCATED(domain, name, location, retained) \
    domain##__##name.value = (void *)located##location; __INIT_RETAIN(domain##__##name, retained)
