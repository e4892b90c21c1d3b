#include <morphcl/opencl_interop.hpp>

#include <morphcl/batch.hpp>

// Moves a point that lies in a buffer of the device.
bool use_opencl_interop() {
  const auto session = morphcl::Session::open({});
  float point[3] = {1, 2, 3};
  const cl::Buffer buffer(morphcl::context_of(*session), CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, sizeof point, point);
  const morphcl::VertexBuffers vertices{morphcl::VertexLayout::xyz, {buffer}};
  const auto moved = morphcl::Transform<float>::points(morphcl::CompositeTransform().translate({1, 1, 1}));
  morphcl::enqueue_transform(*session, moved, vertices, vertices, 1);
  morphcl::queue_of(*session).enqueueReadBuffer(buffer, CL_TRUE, 0, sizeof point, point);
  return point[0] == 2 && point[2] == 4;
}
