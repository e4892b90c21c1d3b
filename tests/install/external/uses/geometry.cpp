#include <morphcl/geometry.hpp>

#include <array>

bool use_geometry() {
  const std::array<glm::dvec3, 2> ends = {glm::dvec3(-1, 0, 0), glm::dvec3(1, 0, 0)};
  const morphcl::Sphere sphere = morphcl::enclosing_sphere(ends).sphere;
  return morphcl::contact(morphcl::box_of(ends), morphcl::Box{}) == morphcl::Contact::apart &&
         morphcl::place_in_sphere(sphere, ends[0]) != morphcl::PointPlace::outside &&
         morphcl::intersect_line({{0, 0, -1}, {0, 0, 1}}, sphere).contact == morphcl::Contact::crossing;
}
