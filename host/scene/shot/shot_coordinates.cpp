#include "host/scene/shot/shot_coordinates.hpp"

#include <fmt/format.h>

#include <string>

#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

void need_numbers(const ShotValue& list, std::size_t count, const char* form) {
  if (!list.is_array() || list.size() != count)
    list.fail(fmt::format("{} must be {} numbers: {}", list.name(), count == 2 ? "two" : "three", form));
}

}  // namespace

glm::dvec3 read_coordinates(const ShotValue& value) {
  const ShotTable table = value.table({"cylindrical", "polar", "spherical"});
  if (table.entries().size() != 1)
    value.fail(fmt::format("{} has one of cylindrical, polar and spherical; this one has {}", value.name(),
                           table.entries().size()));
  const std::string& system = table.entries().front().key;
  const ShotValue list = table.need(system);
  if (system == "polar") {
    need_numbers(list, 2, "[radius, angle in degrees]");
    const SinCos angle = sin_cos_degrees(list[1].number());
    const double radius = list[0].number();
    return {radius * angle.cos, radius * angle.sin, 0};
  }
  const bool spherical = system == "spherical";
  need_numbers(list, 3,
               spherical ? "[radius, azimuth, polar angle], in degrees" : "[radius, azimuth in degrees, height]");
  const double radius = list[0].number();
  const SinCos azimuth = sin_cos_degrees(list[1].number());
  if (!spherical) return {radius * azimuth.sin, list[2].number(), radius * azimuth.cos};
  const SinCos polar = sin_cos_degrees(list[2].number());
  return {radius * polar.sin * azimuth.sin, radius * polar.cos, radius * polar.sin * azimuth.cos};
}

}  // namespace morphcl
