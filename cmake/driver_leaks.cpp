// Linked into every program of a sanitizer build: what OpenCL drivers and their compilers never free is not ours.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libpocl\nleak:libLLVM\nleak:libclang\nleak:libOpenCL\n";
}
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }

// The records that AddressSanitizer keeps of thread-local memory in shared libraries are now and then wrong for threads
// in which LLVM has compiled, and LeakSanitizer crashes on them at exit. Without them it finds what it found with them.
//
// LLVM gives the thread that compiles a signal stack of its own, and AddressSanitizer, where it has given each thread
// one, would unmap LLVM's at the thread's end.
extern "C" const char* __asan_default_options() { return "intercept_tls_get_addr=0:use_sigaltstack=0"; }
