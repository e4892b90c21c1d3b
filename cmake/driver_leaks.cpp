// Linked into every program of a sanitizer build: what OpenCL drivers and their compilers never free is not ours.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libpocl\nleak:libLLVM\nleak:libclang\nleak:libOpenCL\n";
}
