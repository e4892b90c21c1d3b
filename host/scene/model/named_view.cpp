#include "host/scene/model/named_view.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/math/direction.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

std::optional<ViewDirection> view_named(std::string_view name) {
  if (name == "three_quarter") return ViewDirection{unit({1, 0.8, 1.7}), {0, 1, 0}};
  if (name == "front") return view_direction(PrincipalView::front);
  if (name == "back") return view_direction(PrincipalView::back);
  if (name == "left") return view_direction(PrincipalView::left);
  if (name == "right") return view_direction(PrincipalView::right);
  if (name == "top") return view_direction(PrincipalView::top);
  if (name == "bottom") return view_direction(PrincipalView::bottom);
  return std::nullopt;
}

ViewDirection needed_view(std::string_view name) {
  if (const auto view = view_named(name)) return *view;
  throw Error(ErrorKind::usage, "", no_such_view(name));
}

std::string no_such_view(std::string_view name) {
  return fmt::format("there is no view \"{}\"; views are {}", name, fmt::join(view_names, ", "));
}

}  // namespace morphcl
