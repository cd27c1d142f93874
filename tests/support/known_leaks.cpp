// What the leak sanitizer may forget: Mesa's software drivers keep a few hundred bytes a context (480 bytes in five
// allocations with OSMesa 22.3.6).
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa.so\nleak:swrast_dri.so\nleak:libLLVM\n"; }
// Without a list of them at the end of every run: tests read what the program writes.
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
