#include "tests/scene/gltf_evaluator.hpp"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "tests/support/temporary_folder.hpp"

namespace morphcl::test {

namespace {

std::vector<Real> json_numbers(const nlohmann::json& object, const char* key, std::vector<Real> otherwise) {
  if (!object.contains(key)) return otherwise;
  std::vector<Real> values;
  for (const auto& number : object[key]) values.push_back(number.get<double>());
  return values;
}

void normalize(std::vector<Real>& q) {
  const Real length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (Real& c : q) c /= length;
}

// The keys stand for unit quaternions, and were rounded to fp32 in the file.
std::vector<Real> unit(std::vector<Real> q) {
  normalize(q);
  return q;
}

std::vector<Real> slerp(const std::vector<Real>& a, const std::vector<Real>& b, Real t) {
  Real dot = 0;
  for (int c = 0; c < 4; ++c) dot += a[c] * b[c];
  const Real sign = dot < 0 ? -1 : 1;
  const Real angle = std::acos(std::min<Real>(std::abs(dot), 1));
  std::vector<Real> q(4);
  // Below this angle the linear form is off by less than angle^2 / 8 relative, far below what is compared.
  const bool linear = angle < 1e-9L;
  const Real wa = linear ? 1 - t : std::sin(angle * (1 - t)) / std::sin(angle);
  const Real wb = linear ? t : std::sin(angle * t) / std::sin(angle);
  for (int c = 0; c < 4; ++c) q[c] = wa * a[c] + sign * wb * b[c];
  normalize(q);
  return q;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

Matrix compose(const std::vector<Real>& t, std::vector<Real> q, const std::vector<Real>& s) {
  normalize(q);
  const Real x = q[0], y = q[1], z = q[2], w = q[3];
  const Real r[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                        {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                        {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
  Matrix m{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[i][j] = r[i][j] * s[j];
    m[i][3] = t[i];
  }
  m[3][3] = 1;
  return m;
}

}  // namespace

GltfEvaluator::GltfEvaluator(const std::string& path, std::int64_t frames_per_second, std::int64_t ticks_per_frame)
    : json_(nlohmann::json::parse(test_support::text_of(path))),
      frames_per_second_(frames_per_second),
      ticks_per_frame_(ticks_per_frame),
      ticks_per_second_(frames_per_second * ticks_per_frame) {
  for (const auto& buffer : json_["buffers"])
    buffers_.push_back(
        test_support::text_of(std::filesystem::path(path).parent_path() / buffer["uri"].get<std::string>()));
}

std::int64_t GltfEvaluator::tick_of(Real seconds) const {
  const Real rate = static_cast<Real>(frames_per_second_), frame = std::nearbyint(seconds * rate);
  if (static_cast<float>(frame / rate) == static_cast<float>(seconds)) return std::llrint(frame) * ticks_per_frame_;
  return std::llrint(seconds * static_cast<Real>(ticks_per_second_));
}

std::vector<Real> GltfEvaluator::floats(std::size_t index) const {
  const auto& accessor = json_["accessors"][index];
  const auto& view = json_["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  if (accessor["componentType"] != 5126 || view.contains("byteStride") || accessor.contains("sparse"))
    throw std::runtime_error("the evaluator reads plain floats only");
  const std::string type = accessor["type"];
  const std::size_t width = type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4;
  const std::size_t start = view.value("byteOffset", 0) + accessor.value("byteOffset", 0);
  std::vector<Real> values(accessor["count"].get<std::size_t>() * width);
  for (std::size_t i = 0; i < values.size(); ++i) {
    float value = 0;
    std::memcpy(&value, buffers_.at(view["buffer"]).data() + start + 4 * i, 4);
    values[i] = value;
  }
  return values;
}

std::vector<Real> GltfEvaluator::sample(const nlohmann::json& sampler, bool rotation, std::int64_t tick) const {
  const std::vector<Real> times = floats(sampler["input"]), output = floats(sampler["output"]);
  const std::string rule = sampler.value("interpolation", "LINEAR");
  const std::size_t parts = rule == "CUBICSPLINE" ? 3 : 1, width = output.size() / times.size() / parts;
  std::vector<std::int64_t> ticks;
  for (const Real time : times) ticks.push_back(tick_of(time));
  const auto part = [&](std::size_t key, std::size_t which) {
    const auto first = output.begin() + static_cast<std::ptrdiff_t>((key * parts + which) * width);
    return std::vector<Real>(first, first + static_cast<std::ptrdiff_t>(width));
  };
  const std::size_t value = parts == 3 ? 1 : 0;
  if (tick <= ticks.front()) return part(0, value);
  if (tick >= ticks.back()) return part(times.size() - 1, value);
  std::size_t k = 0;
  while (ticks[k + 1] <= tick) ++k;
  const std::vector<Real> a = part(k, value), b = part(k + 1, value);
  if (rule == "STEP" || tick == ticks[k]) return a;
  const Real span = static_cast<Real>(ticks[k + 1] - ticks[k]) / static_cast<Real>(ticks_per_second_);
  const Real t = static_cast<Real>(tick - ticks[k]) / static_cast<Real>(ticks[k + 1] - ticks[k]);
  if (rule == "LINEAR" && rotation) return slerp(unit(a), unit(b), t);
  std::vector<Real> result(width);
  const std::vector<Real> out = parts == 3 ? part(k, 2) : a, in = parts == 3 ? part(k + 1, 0) : b;
  const Real t2 = t * t, t3 = t2 * t;
  for (std::size_t c = 0; c < width; ++c)
    result[c] = parts == 1 ? (1 - t) * a[c] + t * b[c]
                           : (2 * t3 - 3 * t2 + 1) * a[c] + span * (t3 - 2 * t2 + t) * out[c] +
                                 (-2 * t3 + 3 * t2) * b[c] + span * (t3 - t2) * in[c];
  if (rotation) normalize(result);
  return result;
}

std::vector<Real> GltfEvaluator::animated(std::size_t node, const std::string& path, std::int64_t tick) const {
  if (json_.contains("animations"))
    for (const auto& animation : json_["animations"])
      for (const auto& channel : animation["channels"])
        if (channel["target"].value("node", -1) == static_cast<int>(node) && channel["target"]["path"] == path)
          return sample(animation["samplers"][channel["sampler"].get<std::size_t>()], path == "rotation", tick);
  return {};
}

Matrix GltfEvaluator::node_to_world(std::size_t node, std::int64_t tick) const {
  const auto& json = json_["nodes"][node];
  Matrix local{};
  if (json.contains("matrix")) {
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) local[i][j] = json["matrix"][static_cast<std::size_t>(4 * j + i)].get<double>();
  } else {
    const auto value = [&](const char* path, std::vector<Real> rest) {
      const std::vector<Real> moved = animated(node, path, tick);
      return moved.empty() ? json_numbers(json, path, std::move(rest)) : moved;
    };
    local = compose(value("translation", {0, 0, 0}), value("rotation", {0, 0, 0, 1}), value("scale", {1, 1, 1}));
  }
  for (std::size_t parent = 0; parent < node_count(); ++parent)
    for (const auto& child : json_["nodes"][parent].value("children", nlohmann::json::array()))
      if (child == node) return product(node_to_world(parent, tick), local);
  return local;
}

std::vector<Real> GltfEvaluator::weights(std::size_t node, std::int64_t tick) const {
  const std::vector<Real> moved = animated(node, "weights", tick);
  if (!moved.empty()) return moved;
  const auto& json = json_["nodes"][node];
  const auto& mesh = json_["meshes"][json["mesh"].get<std::size_t>()];
  const std::size_t targets = mesh["primitives"][0].value("targets", nlohmann::json::array()).size();
  return json_numbers(json, "weights", json_numbers(mesh, "weights", std::vector<Real>(targets, 0)));
}

std::int64_t GltfEvaluator::last_tick() const {
  Real last = 0;
  if (json_.contains("animations"))
    for (const auto& animation : json_["animations"])
      for (const auto& sampler : animation["samplers"]) last = std::max(last, floats(sampler["input"]).back());
  return tick_of(last);
}

}  // namespace morphcl::test
