// What the leak sanitizer may forget, and when it may not look at all.
#include <dlfcn.h>

#include <initializer_list>

// Mesa's software drivers keep a few hundred bytes a context (480 bytes in five allocations with OSMesa 22.3.6).
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa.so\nleak:swrast_dri.so\nleak:libLLVM\n"; }
// Without a list of them at the end of every run: tests read what the program writes.
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
// With OSMesa loaded its search for leaks may die by itself ("Tracer caught signal 11"), which ends a run that was
// sound; the same work through EGL is searched.
extern "C" int __lsan_is_turned_off() {
  for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"})
    if (dlopen(name, RTLD_NOLOAD | RTLD_LAZY)) return 1;
  return 0;
}
