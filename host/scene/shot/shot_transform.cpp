#include "host/scene/shot/shot_transform.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include "morphcl/convention.hpp"
#include "morphcl/transform.hpp"

namespace morphcl {

namespace {

// Puts the values of a step's table in their place, one after the other.
class ParameterReader {
 public:
  ParameterReader(TrackReader& tracks, AnimatedStep& step) : tracks_(tracks), step_(step) {}

  void number(const ShotValue& value) {
    if (take_keys(value, KeyValue::number, 1)) return;
    step_.parameters[next_++] = value.number();
  }
  void point(const ShotValue& value) {
    if (!take_keys(value, KeyValue::point, 3)) put(value.point());
  }
  void factor(const ShotValue& value) {
    if (!take_keys(value, KeyValue::factor, 3)) put(value.factor());
  }
  void put(const glm::dvec3& value) {
    for (int i = 0; i < 3; ++i) step_.parameters[next_++] = value[i];
  }

 private:
  bool take_keys(const ShotValue& value, KeyValue kind, std::size_t width) {
    if (!TrackReader::are_keys(value)) return false;
    step_.tracks.push_back({static_cast<int>(next_), tracks_.read_keys(value, kind)});
    next_ += width;
    return true;
  }

  TrackReader& tracks_;
  AnimatedStep& step_;
  std::size_t next_ = 0;
};

void read_scale_about(const ShotValue& value, ParameterReader& parameters) {
  const ShotTable table = value.table({"point", "factor"});
  parameters.point(table.need("point"));
  parameters.factor(table.need("factor"));
}

void read_axis_and_angle(const ShotTable& table, ParameterReader& parameters) {
  parameters.point(table.need("from"));
  parameters.point(table.need("to"));
  parameters.number(table.need("degrees"));
}

// The first `steps` of the seven, all of them where it is not given.
double read_step_count(const ShotTable& table) {
  const auto steps = table.find("steps");
  if (!steps) return 7;
  const std::int64_t count = steps->integer();
  if (count < 0 || count > 7) steps->fail(fmt::format("steps is {}; 0 to 7 are possible", count));
  return static_cast<double>(count);
}

constexpr std::array<const char*, 6> shear_keys = {"xy", "xz", "yx", "yz", "zx", "zy"};

void read_shear(const ShotValue& value, TrackReader& tracks, AnimatedStep& step) {
  const ShotTable table = value.table({"xy", "xz", "yx", "yz", "zx", "zy"});
  for (std::size_t i = 0; i < shear_keys.size(); ++i) {
    const auto factor = table.find(shear_keys[i]);
    if (!factor) continue;
    if (TrackReader::are_keys(*factor))
      step.tracks.push_back({static_cast<int>(i), tracks.read_keys(*factor, KeyValue::number)});
    else
      step.parameters[i] = factor->number();
  }
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
glm::dmat4 read_matrix(const ShotValue& value) {
  if (value.has("keys")) value.fail("a matrix has no keys; give them to the steps that it is made of");
  if (!value.is_table()) return read_rows(value);
  const ShotTable table = value.table({"rows", "vectors", "handedness"});
  Convention convention;
  if (const auto vectors = table.find("vectors"))
    convention.vectors = vectors->choose("column", "row") ? VectorForm::row : VectorForm::column;
  if (const auto handedness = table.find("handedness"))
    convention.handedness = handedness->choose("right", "left") ? Handedness::left : Handedness::right;
  return transform_from(convention, read_rows(table.need("rows")));
}

struct StepKey {
  std::string_view key;
  StepKind kind;
};
constexpr std::array<StepKey, 10> step_keys = {{{"translate", StepKind::translate},
                                                {"scale", StepKind::fixed},
                                                {"scale_about", StepKind::scale_about},
                                                {"rotate_x_degrees", StepKind::rotate_x_degrees},
                                                {"rotate_y_degrees", StepKind::rotate_y_degrees},
                                                {"rotate_z_degrees", StepKind::rotate_z_degrees},
                                                {"rotate_about_axis", StepKind::rotate_about_axis},
                                                {"rotate_in_seven_steps", StepKind::rotate_in_seven_steps},
                                                {"shear", StepKind::shear},
                                                {"matrix", StepKind::fixed}}};

// scale that moves is a scale_about the origin.
void read_scale(const ShotValue& value, ParameterReader& parameters, AnimatedStep& step) {
  if (!TrackReader::are_keys(value)) {
    step.constant.scale(value.factor());
    return;
  }
  step.kind = StepKind::scale_about;
  parameters.put(glm::dvec3(0.0));
  parameters.factor(value);
}

AnimatedStep read_step(StepKey key, const ShotValue& value, TrackReader& tracks) {
  AnimatedStep step;
  step.kind = key.kind;
  ParameterReader parameters(tracks, step);
  switch (key.kind) {
    case StepKind::translate:
      parameters.point(value);
      break;
    case StepKind::scale_about:
      read_scale_about(value, parameters);
      break;
    case StepKind::rotate_x_degrees:
    case StepKind::rotate_y_degrees:
    case StepKind::rotate_z_degrees:
      parameters.number(value);
      break;
    case StepKind::rotate_about_axis:
      read_axis_and_angle(value.table({"from", "to", "degrees"}), parameters);
      break;
    case StepKind::rotate_in_seven_steps: {
      const ShotTable table = value.table({"from", "to", "degrees", "steps"});
      read_axis_and_angle(table, parameters);
      step.parameters.back() = read_step_count(table);
      break;
    }
    case StepKind::shear:
      read_shear(value, tracks, step);
      break;
    case StepKind::fixed:
      if (key.key == "matrix")
        step.constant.matrix_step(read_matrix(value));
      else
        read_scale(value, parameters, step);
      break;
  }
  return step;
}

// At the first key of each of its tracks, so that what never works is said here.
void try_step(const AnimatedStep& step) {
  AnimatedTransform alone;
  alone.add_step(step);
  if (step.tracks.empty()) alone.at(0);
  for (const DrivenParameters& driven : step.tracks) alone.at(driven.track.first_tick());
}

}  // namespace

void read_transform_step(const ShotValue& value, TrackReader& tracks, AnimatedTransform& transform) {
  const ShotTable table =
      value.table({"translate", "scale", "scale_about", "rotate_x_degrees", "rotate_y_degrees", "rotate_z_degrees",
                   "rotate_about_axis", "rotate_in_seven_steps", "shear", "matrix", "of"});
  const auto of = table.find("of");
  const std::size_t steps = table.entries().size() - (of ? 1 : 0);
  if (steps != 1) value.fail(fmt::format("a transform step has exactly one key; this one has {}", steps));
  for (const StepKey& key : step_keys) {
    const auto parameters = table.find(key.key);
    if (!parameters) continue;
    placed_at(*parameters, [&] {
      AnimatedStep step = read_step(key, *parameters, tracks);
      step.of_axes = of && of->choose("object", "axes");
      try_step(step);
      transform.add_step(std::move(step));
    });
  }
}

}  // namespace morphcl
