// A kernel with the names of its arguments, by which launches bind them.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "host/device/kernel_source.hpp"
#include "host/device/opencl.hpp"

namespace morphcl {

// A copy is the same kernel object, whose arguments are its state: not for two threads at a time.
class Kernel {
 public:
  Kernel() = default;
  Kernel(cl::Kernel object, KernelSignature signature)
      : object_(std::move(object)), signature_(std::make_shared<const KernelSignature>(std::move(signature))) {}

  explicit operator bool() const { return signature_ != nullptr; }
  const cl::Kernel& object() const { return object_; }
  const std::string& name() const { return signature_->name; }
  const std::vector<KernelArgument>& arguments() const { return signature_->arguments; }

 private:
  cl::Kernel object_;
  std::shared_ptr<const KernelSignature> signature_;
};

}  // namespace morphcl
