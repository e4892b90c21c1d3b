#include "tests/accuracy/naive_forms.hpp"

#include <cmath>
#include <cstddef>

#include "morphcl/numerics.hpp"

namespace morphcl::naive {

namespace {

constexpr float pi = 3.14159274f;

glm::mat3 about_y(float cosine, float sine) { return {cosine, 0, -sine, 0, 1, 0, sine, 0, cosine}; }
glm::mat3 about_z(float cosine, float sine) { return {cosine, sine, 0, -sine, cosine, 0, 0, 0, 1}; }
glm::mat3 about_x(float cosine, float sine) { return {1, 0, 0, 0, cosine, sine, 0, -sine, cosine}; }

}  // namespace

glm::mat3 rotation_in_steps(const glm::vec3& axis, float radians) {
  const float d = std::sqrt(axis.y * axis.y + axis.z * axis.z);
  const float l = std::sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
  const glm::mat3 to_plane = about_x(axis.z / d, axis.y / d);
  const glm::mat3 to_axis = about_y(d / l, -axis.x / l);
  const glm::mat3 turn = about_z(std::cos(radians), std::sin(radians));
  return glm::transpose(to_plane) * glm::transpose(to_axis) * turn * to_axis * to_plane;
}

glm::mat4 rotation_about_pivot(const glm::vec3& pivot, float radians) {
  glm::mat4 to(1.0f), back(1.0f);
  to[3] = glm::vec4(-pivot, 1);
  back[3] = glm::vec4(pivot, 1);
  return back * glm::mat4(about_z(std::cos(radians), std::sin(radians))) * to;
}

float one_minus_cosine(float radians) { return 1 - std::cos(radians); }

glm::mat3 right_angle_rotation(int quarter_turns) {
  const float radians = static_cast<float>(quarter_turns) * (pi / 2);
  return about_z(std::cos(radians), std::sin(radians));
}

float sine_of_huge(float radians) { return std::sin(std::fmod(radians, 2 * pi)); }

float scaled_about(float x, float pivot, float factor) { return factor * x + (1 - factor) * pivot; }

glm::vec3 across(const glm::vec3& up, const glm::vec3& backward) { return glm::normalize(glm::cross(up, backward)); }

glm::mat3 frisvad_basis(const glm::vec3& normal) {
  const float a = 1 / (1 + normal.z), b = -normal.x * normal.y * a;
  return {glm::vec3(1 - normal.x * normal.x * a, b, -normal.x), glm::vec3(b, 1 - normal.y * normal.y * a, -normal.y),
          normal};
}

float depth_of(float z, float near, float far) {
  const float scale = -(far + near) / (far - near), offset = -2 * far * near / (far - near);
  return (scale * z + offset) / -z;
}

glm::vec2 project(const glm::vec4& clip) { return {clip.x / clip.w, clip.y / clip.w}; }

glm::vec4 cut(const glm::vec4& from, const glm::vec4& to, float near_w) {
  const float t = (near_w - from.w) / (to.w - from.w);
  return from + t * (to - from);
}

int snap(float v, float w, float scale, float offset) {
  return static_cast<int>(std::nearbyint(std::fma(v / w, scale, offset)));
}

float oblique_shift(float z, float beta_degrees) { return z / std::tan(beta_degrees * (pi / 180)); }

std::array<int, 2> edge_signs(const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& p) {
  const auto f = [](int i) { return static_cast<float>(i); };
  const float products = (f(b.x) - f(a.x)) * (f(p.y) - f(a.y)) - (f(b.y) - f(a.y)) * (f(p.x) - f(a.x));
  const float coefficients = f(a.y - b.y) * f(p.x) + f(b.x - a.x) * f(p.y) + (f(a.x) * f(b.y) - f(b.x) * f(a.y));
  const auto sign = [](float v) { return v > 0 ? 1 : v < 0 ? -1 : 0; };
  return {sign(products), sign(coefficients)};
}

float perspective_lerp(float a1, float w1, float a2, float w2, float t) {
  const float p = 1 / w1, q = 1 / w2;
  const float attribute = a1 * p + t * (a2 * q - a1 * p);
  return attribute / (p + t * (q - p));
}

float attribute_at(const glm::vec3& area, const glm::vec3& inverse_w, const glm::vec3& attribute) {
  const float total = area[0] + area[1] + area[2], s = area[1] / total, t = area[2] / total;
  const auto plane = [&](const glm::vec3& at) { return at[0] + s * (at[1] - at[0]) + t * (at[2] - at[0]); };
  return plane(attribute * inverse_w) / plane(inverse_w);
}

float angle_between(const glm::quat& a, const glm::quat& b) {
  return std::acos(a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w);
}

glm::quat slerp(const glm::quat& a, const glm::quat& b, float t) {
  const float angle = angle_between(a, b), sine = std::sin(angle);
  return a * (std::sin((1 - t) * angle) / sine) + b * (std::sin(t * angle) / sine);
}

glm::dquat nlerp(const glm::dquat& a, const glm::dquat& b, double t) { return glm::normalize(a * (1 - t) + b * t); }

glm::vec3 morphed_normal(const glm::vec3& a, const glm::vec3& b, float t) {
  return glm::normalize((1 - t) * a + t * b);
}

float length(const glm::vec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

double hermite_by_differences(const std::vector<double>& times, const std::vector<double>& values, double time) {
  std::size_t key = 0;
  while (key + 2 < times.size() && times[key + 1] <= time) ++key;
  const auto slope = [&](std::size_t i) {
    // The mean of the slopes before and after, as if the keys were evenly spaced.
    const auto difference = [&](std::size_t k) { return (values[k + 1] - values[k]) / (times[k + 1] - times[k]); };
    if (i == 0) return difference(0);
    if (i + 1 == times.size()) return difference(i - 1);
    return 0.5 * (difference(i - 1) + difference(i));
  };
  const double h = times[key + 1] - times[key], u = (time - times[key]) / h, v = 1 - u;
  return v * v * (1 + 2 * u) * values[key] + u * u * (1 + 2 * v) * values[key + 1] + u * v * v * h * slope(key) -
         u * u * v * h * slope(key + 1);
}

float by_adding(float start, float step, int steps) {
  for (int i = 0; i < steps; ++i) start += step;
  return start;
}

float lerp(float a, float b, float t) { return a + t * (b - a); }

bool inside_by_angles(const std::vector<glm::vec2>& polygon, const glm::vec2& point) {
  float sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::vec2 a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
    const float angle = std::acos(glm::dot(a, b) / (glm::length(a) * glm::length(b)));
    sum += a.x * b.y - a.y * b.x < 0 ? -angle : angle;
  }
  return std::abs(sum) > pi;
}

float difference_of_products(float a, float b, float c, float d) { return a * b - c * d; }

bool keeps_clip_point(float x, float w) { return !(x < -w) && !(x > w); }

float half_by_way_of_float(double value) {
  return static_cast<float>(from_half(to_half(static_cast<double>(static_cast<float>(value)))));
}

}  // namespace morphcl::naive
