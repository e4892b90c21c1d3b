// The forms that textbooks print and that fail at the extremes: what the rows of the catalogue are shown to catch. In
// fp32 unless the type says otherwise, as they are met in shaders and small programs.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <vector>

namespace morphcl::naive {

// Rotation about an axis in seven steps: to the xz plane, to the x axis, about it, and back. Column vectors.
glm::mat3 rotation_in_steps(const glm::vec3& axis, float radians);
// T R T' with every factor rounded to fp32 and multiplied in fp32; R about z.
glm::mat4 rotation_about_pivot(const glm::vec3& pivot, float radians);
float one_minus_cosine(float radians);
glm::mat3 right_angle_rotation(int quarter_turns);
float sine_of_huge(float radians);                       // reduced by fmod with 2 pi rounded to fp32
float by_adding(float start, float step, int steps);     // an angle, a time, a position on an edge
float scaled_about(float x, float pivot, float factor);  // S x + (1 - S) X
glm::vec3 across(const glm::vec3& up, const glm::vec3& backward);
glm::mat3 frisvad_basis(const glm::vec3& normal);

// Depth of eye-space z by -(f + n) / (f - n) and -2 f n / (f - n).
float depth_of(float z, float near, float far);
glm::vec2 project(const glm::vec4& clip);
glm::vec4 cut(const glm::vec4& from, const glm::vec4& to, float near_w);
int snap(float v, float w, float scale, float offset);
float oblique_shift(float z, float beta_degrees);
std::array<int, 2> edge_signs(const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& p);

float perspective_lerp(float a1, float w1, float a2, float w2, float t);  // p + t (q - p)
// Attribute / w and 1 / w as planes p + s (q - p) + t (r - p) over the triangle, from the doubled areas of its parts.
float attribute_at(const glm::vec3& area, const glm::vec3& inverse_w, const glm::vec3& attribute);
float angle_between(const glm::quat& a, const glm::quat& b);       // acos of the dot product
glm::quat slerp(const glm::quat& a, const glm::quat& b, float t);  // by sines of the angle, whatever it is
glm::dquat nlerp(const glm::dquat& a, const glm::dquat& b, double t);
glm::vec3 morphed_normal(const glm::vec3& a, const glm::vec3& b, float t);
float length(const glm::vec3& v);
double hermite_by_differences(const std::vector<double>& times, const std::vector<double>& values, double time);
float lerp(float a, float b, float t);  // a + t (b - a)
bool inside_by_angles(const std::vector<glm::vec2>& polygon, const glm::vec2& point);
float difference_of_products(float a, float b, float c, float d);

bool keeps_clip_point(float x, float w);   // !(x < -w) && !(x > w)
float half_by_way_of_float(double value);  // fp64 -> fp32 -> fp16

}  // namespace morphcl::naive
