#include "morphcl/visibility.hpp"

namespace morphcl {

namespace {
constexpr std::array<std::string_view, 5> method_names = {"z-buffer", "painter", "bsp", "warnock", "watkins"};
}

std::string_view name_of(VisibilityMethod method) { return method_names[static_cast<std::size_t>(method)]; }

std::optional<VisibilityMethod> visibility_method_named(std::string_view name) {
  for (const VisibilityMethod method : visibility_methods)
    if (name_of(method) == name) return method;
  return std::nullopt;
}

}  // namespace morphcl
