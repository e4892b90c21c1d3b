#include "host/render/reference/light.hpp"

#include <algorithm>
#include <cmath>

#include "host/render/frame/scene_vertices.hpp"

namespace morphcl::reference {

namespace {

float dot_product(const glm::vec3& a, const glm::vec3& b) { return std::fma(a.x, b.x, std::fma(a.y, b.y, a.z * b.z)); }

float share_of_spot(const EyeLight& light, const glm::vec3& to_light, float distance) {
  const glm::vec3 beam(light.beam[0], light.beam[1], light.beam[2]);
  const float cosine = -dot_product(beam, to_light) / (distance > 0.0f ? distance : 1.0f);
  const float root = std::min(std::max(std::fma(light.cone_scale, cosine, light.cone_offset), 0.0f), 1.0f);
  return root * root;
}

}  // namespace

float difference_of_products(float a, float b, float c, float d) {
  const float product = c * d;
  return std::fma(a, b, -product) + std::fma(-c, d, product);
}

glm::vec3 lambert(const FramePlan& plan, const glm::vec3& normal, const glm::vec3& position) {
  const float length = std::sqrt(dot_product(normal, normal));
  glm::vec3 sum(plan.ambient[0], plan.ambient[1], plan.ambient[2]);
  for (const EyeLight& light : plan.lights) {
    glm::vec3 to_light(light.vector[0], light.vector[1], light.vector[2]);
    float divisor = length > 0.0f ? length : 1.0f, share = 1.0f;
    if (light.kind == LightKind::point) {
      to_light -= position;
      const float square = dot_product(to_light, to_light), distance = std::sqrt(square);
      divisor *= light.falloff ? square * distance : distance;
      if (light.cone_scale > 0) share = share_of_spot(light, to_light, distance);
    }
    const float cosine = std::max(dot_product(normal, to_light), 0.0f);
    const float lit = length > 0.0f && divisor > 0.0f ? cosine / divisor * share : 0.0f;
    for (int c = 0; c < 3; ++c) sum[c] = std::fma(light.color[c], lit, sum[c]);
  }
  return sum;
}

Face face_of(const FramePlan& plan, const Draw& draw, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 u = b - a, v = c - a;
  const glm::vec3 cross(difference_of_products(u.y, v.z, u.z, v.y), difference_of_products(u.z, v.x, u.x, v.z),
                        difference_of_products(u.x, v.y, u.y, v.x));
  glm::vec3 normal, centre;
  for (int row = 0; row < 3; ++row) normal[row] = row_times_vector(draw.normal_to_eye[row], cross);
  const float largest = std::max(std::fabs(normal.x), std::max(std::fabs(normal.y), std::fabs(normal.z)));
  const float scale = largest > 0.0f ? largest : 1.0f;
  normal = {normal.x / scale, normal.y / scale, normal.z / scale};
  const float third = 1.0f / 3.0f;
  const glm::vec3 middle = a + (u + v) * third;
  for (int row = 0; row < 3; ++row) centre[row] = row_times_point(draw.object_to_eye[row], middle);
  // Along the line of sight through the face, away from the viewer.
  const glm::vec3 away = plan.camera.parallel ? glm::vec3(plan.camera.slant[0], plan.camera.slant[1], -1.0f) : centre;
  if (draw.double_sided && dot_product(normal, away) > 0.0f) normal = -normal;
  return {normal, centre};
}

}  // namespace morphcl::reference
