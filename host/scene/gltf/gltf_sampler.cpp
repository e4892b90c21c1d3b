#include "host/scene/gltf/gltf_sampler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "host/scene/gltf/gltf_quaternion.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

Interpolation read_interpolation(const GltfValue& json) {
  const std::string name = json.text("interpolation", "LINEAR");
  if (name == "STEP") return Interpolation::step;
  if (name == "LINEAR") return Interpolation::linear;
  if (name == "CUBICSPLINE") return Interpolation::cubic;
  json.get("interpolation").fail(fmt::format("is '{}'; STEP, LINEAR or CUBICSPLINE are rules", name));
}

std::vector<double> read_times(const GltfAccessors& accessors, int input, GltfWarnings& warnings) {
  if (accessors.type(input) != "SCALAR" || accessors.component(input) != GltfComponent::float32)
    accessors.fail(input, "must be SCALAR float (5126) to hold key times");
  std::vector<double> times = accessors.decode<double>(input);
  std::size_t equal = 0;
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] < times[i - 1])
      accessors.fail(input, fmt::format("key {} is at {} s, key {} at {} s; times must increase", i - 1, times[i - 1],
                                        i, times[i]));
    if (times[i] == times[i - 1]) ++equal;
  }
  if (times.front() < 0)
    warnings.say(fmt::format("{}: key times start at {} s; the motion is played from 0 on", accessors.place(input),
                             times.front()));
  if (equal > 0)
    warnings.say(fmt::format("{}: {} keys have the time of the one before; the last of a time is used",
                             accessors.place(input), equal));
  return times;
}

void check_output_type(const GltfAccessors& accessors, int output, const GltfSamplerUse& use) {
  const char* type = use.weights ? "SCALAR" : use.rotation ? "VEC4" : "VEC3";
  const GltfComponent component = accessors.component(output);
  const bool integer_allowed =
      (use.weights || use.rotation) && accessors.normalized(output) && component != GltfComponent::uint32;
  if (accessors.type(output) != type || !(component == GltfComponent::float32 || integer_allowed))
    accessors.fail(output, fmt::format("must be {} of float (5126){} to animate {}", type,
                                       use.weights || use.rotation ? " or normalized integers of 8 or 16 bits" : "",
                                       use.weights    ? "weights"
                                       : use.rotation ? "a rotation"
                                                      : "translation or scale"));
}

void normalize_key(double* q, const GltfAccessors& accessors, int output, std::size_t key) {
  if (!normalize_quaternion(std::span<double, 4>(q, 4)))
    accessors.fail(output, fmt::format("the rotation of key {} has no direction", key));
}

}  // namespace

GltfSampler read_sampler(const GltfValue& json, const GltfDocument& document, const GltfAccessors& accessors,
                         const TimeBase& time, const GltfSamplerUse& use, GltfWarnings& warnings) {
  Interpolation interpolation = read_interpolation(json);
  const int input = json.get("input").index(accessors.size(), "accessors");
  const int output = json.get("output").index(accessors.size(), "accessors");
  check_output_type(accessors, output, use);
  const std::vector<double> times = read_times(accessors, input, warnings);
  if (interpolation == Interpolation::cubic && times.size() < 2)
    accessors.fail(input, "holds one key; a cubic spline needs two");

  const std::size_t parts = interpolation == Interpolation::cubic ? 3 : 1;  // in-tangent, value, out-tangent
  const std::size_t elements_per_key = (use.weights ? use.width : 1) * parts;
  const std::size_t expected = times.size() * elements_per_key;
  if (accessors.count(output) != expected)
    accessors.fail(output,
                   fmt::format("has {} elements; {} keys need {}", accessors.count(output), times.size(), expected));
  std::vector<double> values = accessors.decode<double>(output);
  const std::size_t components_per_key = use.width * parts;
  if (use.rotation && parts == 1)
    for (std::size_t key = 0; key < times.size(); ++key) normalize_key(&values[4 * key], accessors, output, key);

  document.budget().charge(times.size() + values.size(), sizeof(double), json.place());
  std::vector<std::int64_t> ticks;
  std::vector<double> kept;
  ticks.reserve(times.size());
  kept.reserve(values.size());
  for (std::size_t key = 0; key < times.size(); ++key) {
    std::int64_t tick = 0;
    try {
      tick = time.float_seconds_to_ticks(static_cast<float>(times[key]));  // the file stores 32 bits
    } catch (const Error& error) {
      accessors.fail(input, fmt::format("key {}: {}", key, error.message()));
    }
    if (!ticks.empty() && ticks.back() == tick)
      kept.resize(kept.size() - components_per_key);
    else
      ticks.push_back(tick);
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(key * components_per_key);
    kept.insert(kept.end(), first, first + static_cast<std::ptrdiff_t>(components_per_key));
  }
  if (interpolation == Interpolation::cubic && ticks.size() == 1) {
    // All keys fell on one tick: what is left is a constant.
    interpolation = Interpolation::step;
    kept.assign(kept.begin() + static_cast<std::ptrdiff_t>(use.width),
                kept.begin() + static_cast<std::ptrdiff_t>(2 * use.width));
    if (use.rotation) normalize_key(kept.data(), accessors, output, times.size() - 1);
  }
  GltfSampler result;
  result.last_seconds = std::max(times.back(), 0.0);
  result.bytes = ticks.size() * sizeof(std::int64_t) + kept.size() * sizeof(double);
  try {
    result.track = Track({interpolation, static_cast<int>(use.width), use.rotation, time.ticks_per_second(),
                          std::move(ticks), std::move(kept)});
  } catch (const Error& error) {
    throw error.at(json.place());
  }
  return result;
}

}  // namespace morphcl
