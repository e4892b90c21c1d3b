// The kernel programs that the build embeds, with their headers in place, and what each of their kernels takes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace morphcl {

// As the kernel's source declares it: "global const int4* vertices" has the name "vertices" and the type "int4". OpenCL
// itself knows names and types of a program built from source only, not of one loaded from a binary.
struct KernelArgument {
  std::string name, type;
};

struct KernelSignature {
  std::string name;
  std::vector<KernelArgument> arguments;  // in the kernel's order
};

struct KernelSource {
  std::string stage;  // the file's stem
  std::string file;   // from the root of the sources
  std::string text;
  std::vector<KernelSignature> kernels;
};

// The programs of the library, sorted by stage: kernels/*.cl. (Those of the accuracy report are its own:
// lab/accuracy/kernel_sources.hpp.)
const std::vector<KernelSource>& kernel_sources();

// Error(internal) when there is no such program, or kernel.
const KernelSource& kernel_source(std::string_view stage);
const KernelSource& kernel_source(std::string_view stage, const std::vector<KernelSource>& sources);
const KernelSignature& signature_of(const KernelSource& source, std::string_view kernel);

}  // namespace morphcl
