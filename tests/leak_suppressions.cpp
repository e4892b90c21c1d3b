// For AddressSanitizer's leak check: what the drivers leave behind at exit is not ours.
extern "C" const char* __lsan_default_suppressions();

const char* __lsan_default_suppressions() {
  return "leak:libpocl\n"
         "leak:libLLVM\n"
         "leak:libclang\n"
         "leak:libOpenCL\n";
}
