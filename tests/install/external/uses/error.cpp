#include <morphcl/error.hpp>

bool use_error() {
  try {
    throw morphcl::Error(morphcl::ErrorKind::usage, "here", "nothing is wrong");
  } catch (const std::runtime_error& error) {
    return morphcl::printable(error.what()) == "here: nothing is wrong";
  }
}
