#include "host/scene/shot/shot_transform.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "morphcl/convention.hpp"
#include "morphcl/transform.hpp"

namespace morphcl {

namespace {

void read_scale_about(const ShotValue& value, CompositeTransform& transform) {
  const ShotTable table = value.table({"point", "factor"});
  transform.scale_about(table.need("point").vector(), table.need("factor").vector());
}

void read_rotate_about_axis(const ShotValue& value, CompositeTransform& transform) {
  const ShotTable table = value.table({"from", "to", "degrees"});
  transform.rotate_about_axis(table.need("from").vector(), table.need("to").vector(), table.need("degrees").number());
}

// The first `steps` of the seven, all of them where it is not given.
void read_rotate_in_seven_steps(const ShotValue& value, CompositeTransform& transform) {
  const ShotTable table = value.table({"from", "to", "degrees", "steps"});
  const CompositeTransform all =
      rotation_in_seven_steps(table.need("from").vector(), table.need("to").vector(), table.need("degrees").number());
  std::int64_t count = 7;
  if (const auto steps = table.find("steps")) {
    count = steps->integer();
    if (count < 0 || count > 7) steps->fail(fmt::format("steps is {}; 0 to 7 are possible", count));
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) transform.add_step(all.steps()[i]);
}

void read_shear(const ShotValue& value, CompositeTransform& transform) {
  const ShotTable table = value.table({"xy", "xz", "yx", "yz", "zx", "zy"});
  const auto factor = [&](const char* key) {
    const auto found = table.find(key);
    return found ? found->number() : 0.0;
  };
  transform.shear(factor("xy"), factor("xz"), factor("yx"), factor("yz"), factor("zx"), factor("zy"));
}

glm::dmat4 read_rows(const ShotValue& value) {
  const char* form = "matrix must be four rows of four numbers; the last is [0, 0, 0, 1]";
  if (!value.is_array() || value.size() != 4) value.fail(form);
  glm::dmat4 matrix;
  for (int row = 0; row < 4; ++row) {
    const ShotValue numbers = value[static_cast<std::size_t>(row)];
    if (!numbers.is_array() || numbers.size() != 4) numbers.fail(form);
    for (int column = 0; column < 4; ++column) matrix[column][row] = numbers[static_cast<std::size_t>(column)].number();
  }
  return matrix;
}

// Four rows, or a table of rows and the convention that they are written in.
void read_matrix(const ShotValue& value, CompositeTransform& transform) {
  if (!value.is_table()) {
    transform.matrix_step(read_rows(value));
    return;
  }
  const ShotTable table = value.table({"rows", "vectors", "handedness"});
  Convention convention;
  if (const auto vectors = table.find("vectors"))
    convention.vectors = vectors->choose("column", "row") ? VectorForm::row : VectorForm::column;
  if (const auto handedness = table.find("handedness"))
    convention.handedness = handedness->choose("right", "left") ? Handedness::left : Handedness::right;
  transform.matrix_step(transform_from(convention, read_rows(table.need("rows"))));
}

}  // namespace

void read_transform_step(const ShotValue& step, CompositeTransform& transform) {
  const ShotTable table =
      step.table({"translate", "scale", "scale_about", "rotate_x_degrees", "rotate_y_degrees", "rotate_z_degrees",
                  "rotate_about_axis", "rotate_in_seven_steps", "shear", "matrix"});
  if (table.entries().size() != 1)
    step.fail(fmt::format("a transform step has exactly one key; this one has {}", table.entries().size()));
  const std::string& key = table.entries().front().key;
  const ShotValue value = table.need(key);
  placed_at(value, [&] {
    if (key == "translate") transform.translate(value.vector());
    if (key == "scale") transform.scale(value.vector());
    if (key == "scale_about") read_scale_about(value, transform);
    if (key == "rotate_x_degrees") transform.rotate_x_degrees(value.number());
    if (key == "rotate_y_degrees") transform.rotate_y_degrees(value.number());
    if (key == "rotate_z_degrees") transform.rotate_z_degrees(value.number());
    if (key == "rotate_about_axis") read_rotate_about_axis(value, transform);
    if (key == "rotate_in_seven_steps") read_rotate_in_seven_steps(value, transform);
    if (key == "shear") read_shear(value, transform);
    if (key == "matrix") read_matrix(value, transform);
  });
}

}  // namespace morphcl
