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
  std::uint32_t channels, depth_format, samples;
  CameraConstants camera;
  std::array<float, 3> ambient;
  std::uint32_t light_count, draw_count, background_rows;
};
static_assert(sizeof(FrameKey) == 11 * 4 + sizeof(CameraConstants));

struct LightKey {
  std::uint32_t kind, falloff;
  std::array<float, 3> vector, color, beam;
  float cone_scale, cone_offset;
};
static_assert(sizeof(LightKey) == 13 * 4);

struct DrawKey {
  const Mesh* mesh;
  std::uint32_t shading_line_width, double_sided, mirrored, colors_displaced_lit_moves_blended;
  float alpha_cutoff;
  std::array<float, 4> base_color;
  std::array<Row, 4> object_to_clip;
  std::array<Row, 3> object_to_eye;
  std::array<std::array<float, 3>, 3> normal_to_eye;
  std::uint32_t object_id, material_id;
  float crypto_object, crypto_material;
  std::array<float, 3> albedo;
  std::uint32_t normals, target_count;
  std::uint32_t pad = 0;
};
static_assert(sizeof(DrawKey) == sizeof(const Mesh*) + 56 * 4);

std::uint32_t count(std::size_t size) { return static_cast<std::uint32_t>(size); }

// Every member is named here, so that the build stops at one that nobody has decided about.

void add(Digester& digester, const EyeLight& light) {
  const auto& [kind, vector, color, falloff, beam, cone_scale, cone_offset] = light;
  digester.add(LightKey{static_cast<std::uint32_t>(kind), falloff, vector, color, beam, cone_scale, cone_offset});
}

void add(Digester& digester, const Draw& draw) {
  // Left out: the object's number, which shows in object_id where that is asked for.
  const auto& [mesh, object, shading, double_sided, mirrored, object_to_clip, object_to_eye, normal_to_eye, base_color,
               line_width, vertex_colors, blended, alpha_cutoff, lit_per_pixel, targets, accuracy, displaced, object_id,
               material_id, crypto_object, crypto_material, albedo, normals, moves] = draw;
  digester.add(DrawKey{
      mesh, static_cast<std::uint32_t>(shading) | line_width << 8, double_sided, mirrored,
      vertex_colors | (displaced ? 2u : 0u) | (lit_per_pixel ? 4u : 0u) | (moves ? 8u : 0u) | (blended ? 16u : 0u),
      alpha_cutoff, base_color, object_to_clip, object_to_eye, normal_to_eye, object_id, material_id, crypto_object,
      crypto_material, albedo, static_cast<std::uint32_t>(normals), count(targets.size())});
  for (const ActiveTarget& target : targets) digester.add(target);
  if (displaced) digester.add(displaced->hash);
  const VertexAccuracy plain;
  const auto& [form, pivot, clip_rest, bounds, suffices] = accuracy ? *accuracy : plain;
  digester.add(form);
  if (form == VertexForm::pivot) digester.add(pivot);
  if (form == VertexForm::two_float) digester.add(clip_rest);
}

}  // namespace

PlanDigest pixel_digest(const FramePlan& plan) {
  // Left out: whose plan it is, when, what it spares the renderer, and how hidden surfaces are found. No pixel depends
  // on these.
  const auto& [planner, alone, frame, fps_numerator, fps_denominator, width, height, channels, samples, draws,
               next_draws, draws_version, lights, ambient, camera, depth_format, visibility, clips, divides,
               tests_depth, blends, keeps_vertices, keeps_blank_tiles, background, eye_to_world, world_to_eye,
               world_to_ndc, channel_names, manifests] = plan;
  Digester digester;
  digester.add(FrameKey{width, height, channels.bits(), static_cast<std::uint32_t>(depth_format),
                        static_cast<std::uint32_t>(samples), camera, ambient, count(lights.size()), count(draws.size()),
                        background ? count(background->size()) : 0});
  if (background)
    for (const BackgroundRow& row : *background) digester.add(row);
  for (const EyeLight& light : lights) add(digester, light);
  for (const Draw& draw : draws) add(digester, draw);
  for (const Draw& draw : next_draws) add(digester, draw);
  if (plan.has(Channel::normal) || plan.has(Channel::position)) digester.add(eye_to_world);
  return digester.digest();
}

}  // namespace morphcl
