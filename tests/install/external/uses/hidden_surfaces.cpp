#include <morphcl/hidden_surfaces.hpp>

bool use_hidden_surfaces() {
  const morphcl::FlatPolygon square = morphcl::make_flat_polygon({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}});
  return morphcl::painted_picture({square}, 4, 4).polygon == morphcl::warnock_picture({square}, 4, 4).polygon;
}
