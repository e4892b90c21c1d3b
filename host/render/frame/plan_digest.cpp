#include "host/render/frame/plan_digest.hpp"

#include <xxhash.h>

#include <memory>
#include <new>
#include <type_traits>

namespace morphcl {

namespace {

class Digester {
 public:
  Digester() : state_(XXH3_createState()) {
    if (!state_) throw std::bad_alloc();
    XXH3_128bits_reset(state_.get());
  }

  // A value without padding, so that equal ones have equal bytes. -0 and 0 count as different: pixels may differ by
  // them.
  template <class Value>
  void add(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    XXH3_128bits_update(state_.get(), &value, sizeof value);
  }

  PlanDigest digest() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
    return {hash.low64, hash.high64};
  }

 private:
  struct Free {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };
  std::unique_ptr<XXH3_state_t, Free> state_;
};

// Bytes in a row, in which nothing is left between the fields.
struct FrameKey {
  std::int32_t width, height;
  std::uint32_t color, depth, depth_format;
  CameraConstants camera;
  std::array<float, 3> ambient;
  std::uint32_t light_count, draw_count;
};
static_assert(sizeof(FrameKey) == 10 * 4 + sizeof(CameraConstants));

struct LightKey {
  std::uint32_t kind, falloff;
  std::array<float, 3> vector, color;
};
static_assert(sizeof(LightKey) == 8 * 4);

struct DrawKey {
  const Mesh* mesh;
  std::uint32_t shading, double_sided, mirrored, vertex_colors_and_displaced;
  std::array<float, 4> base_color;
  std::array<Row, 4> object_to_clip;
  std::array<Row, 3> object_to_eye;
  std::array<std::array<float, 3>, 3> normal_to_eye;
  std::uint32_t target_count;
};
static_assert(sizeof(DrawKey) == sizeof(const Mesh*) + 46 * 4);

}  // namespace

PlanDigest pixel_digest(const FramePlan& plan) {
  const auto count = [](std::size_t size) { return static_cast<std::uint32_t>(size); };
  Digester digester;
  digester.add(FrameKey{plan.width, plan.height, plan.color, plan.depth, static_cast<std::uint32_t>(plan.depth_format),
                        plan.camera, plan.ambient, count(plan.lights.size()), count(plan.draws.size())});
  for (const EyeLight& light : plan.lights)
    digester.add(LightKey{static_cast<std::uint32_t>(light.kind), light.falloff, light.vector, light.color});
  const VertexAccuracy plain;
  for (const Draw& draw : plan.draws) {
    digester.add(DrawKey{draw.mesh, static_cast<std::uint32_t>(draw.shading), draw.double_sided, draw.mirrored,
                         draw.vertex_colors | (draw.displaced ? 2u : 0u), draw.base_color, draw.object_to_clip,
                         draw.object_to_eye, draw.normal_to_eye, count(draw.targets.size())});
    for (const ActiveTarget& target : draw.targets) digester.add(target);
    if (draw.displaced) digester.add(draw.displaced->hash);
    const VertexAccuracy& accuracy = draw.accuracy ? *draw.accuracy : plain;
    digester.add(accuracy.form);
    if (accuracy.form == VertexForm::pivot) digester.add(accuracy.pivot);
    if (accuracy.form == VertexForm::two_float) digester.add(accuracy.clip_rest);
  }
  return digester.digest();
}

}  // namespace morphcl
