#include "host/scene/obj/obj_colors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "morphcl/error.hpp"
#include "morphcl/scene.hpp"

namespace morphcl {

namespace {

glm::vec3 color_of(const std::array<float, ObjColors::max_numbers>& numbers, bool red_first) {
  return red_first ? glm::vec3(numbers[0], numbers[1], numbers[2]) : glm::vec3(numbers[1], numbers[2], numbers[3]);
}

bool is_number(const glm::vec3& color) { return !std::isnan(color.r) && !std::isnan(color.g) && !std::isnan(color.b); }

// Whether these are bytes: whole numbers from 0 to 255, of which one exceeds 1.
bool are_bytes(std::span<const glm::vec3> colors) {
  float largest = 0;
  for (const glm::vec3& color : colors)
    for (int c = 0; c < 3; ++c) {
      if (!(color[c] >= 0 && color[c] <= 255) || color[c] != std::floor(color[c])) return false;
      largest = std::max(largest, color[c]);
    }
  return largest > 1;
}

}  // namespace

void ObjColors::add(std::size_t vertex, std::span<const float> numbers) {
  Entry entry{{1, 0, 0, 0}, static_cast<std::uint32_t>(vertex), numbers.size() == max_numbers};
  std::copy(numbers.begin(), numbers.end(), entry.numbers.end() - static_cast<std::ptrdiff_t>(numbers.size()));
  entries_.push_back(entry);
}

bool ObjColors::red_comes_first(const std::string& path, std::vector<std::string>& warnings) const {
  const auto is_weighted = [](const Entry& entry) { return entry.weighted; };
  const auto ends_in_one = [](const Entry& entry) { return entry.numbers[3] == 1; };
  const auto begins_alike = [&](const Entry& entry) { return entry.numbers[0] == entries_[0].numbers[0]; };
  if (!std::all_of(entries_.begin(), entries_.end(), is_weighted) ||
      !std::all_of(entries_.begin(), entries_.end(), ends_in_one))
    return false;
  const bool red_first = !std::all_of(entries_.begin(), entries_.end(), begins_alike);
  warnings.push_back(fmt::format("{}: the seventh number of every vertex is 1; the fourth is taken for {}",
                                 printable(path),
                                 red_first ? "red and the seventh for alpha" : "a weight, not for red"));
  return red_first;
}

std::vector<glm::vec3> ObjColors::finish(std::size_t vertex_count, const std::string& path,
                                         std::vector<std::string>& warnings) {
  if (entries_.empty()) return {};
  const bool red_first = red_comes_first(path, warnings);
  std::vector<glm::vec3> given;
  given.reserve(entries_.size());
  for (const Entry& entry : entries_) given.push_back(color_of(entry.numbers, red_first));

  std::size_t clamped = 0, unknown = vertex_count - entries_.size();
  const bool bytes = are_bytes(given);
  if (bytes) warnings.push_back(fmt::format("{}: vertex colours are taken as 0 to 255", printable(path)));
  std::vector<glm::vec3> colors(vertex_count, glm::vec3(Material{}.base_color));
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!is_number(given[i])) {
      ++unknown;
      continue;
    }
    const glm::vec3 color = bytes ? given[i] / 255.0f : given[i];
    const glm::vec3 inside = glm::clamp(color, 0.0f, 1.0f);
    clamped += inside != color;
    colors[entries_[i].vertex] = inside;
  }
  if (clamped > 0)
    warnings.push_back(fmt::format("{}: the colours of {} of {} vertices are not from 0 to 1 and are clamped",
                                   printable(path), clamped, vertex_count));
  if (unknown == vertex_count) {
    warnings.push_back(fmt::format("{}: vertex colours are no numbers; the default colour is used", printable(path)));
    return {};
  }
  if (unknown > 0)
    warnings.push_back(
        fmt::format("{}: {} of {} vertices have no colour, or one that is no number, and are drawn in the "
                    "default colour",
                    printable(path), unknown, vertex_count));
  return colors;
}

}  // namespace morphcl
