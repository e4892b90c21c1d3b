#include "host/render/device/frame_memory.hpp"

#include <algorithm>
#include <utility>

#include "host/device/session_access.hpp"
#include "host/render/device/kept_vertices.hpp"

namespace morphcl {

namespace {

using layout::uint;

enum DrawTable { draw_constants, of_vertex_groups, of_primitive_groups, in_order };

std::vector<std::array<uint, 3>> places_of(const std::vector<layout::DrawConstants>& draws) {
  std::vector<std::array<uint, 3>> places;
  places.reserve(draws.size());
  for (const layout::DrawConstants& draw : draws)
    places.push_back({draw.vertex_group_count, draw.primitive_group_count, draw.first_in_order});
  return places;
}

}  // namespace

FrameMemory::FrameMemory(std::shared_ptr<Session> session)
    : session_(std::move(session)), meshes_(session_), draws_(context_of(*session_)), targets_(context_of(*session_)) {}

void FrameMemory::forget(Lost what) {
  before_is_known_ = false;
  if (what == Lost::vertices) return;
  now_.origin = {};
  before_.origin = {};
  uploaded_origin_ = {};
}

void FrameMemory::start(const FramePlan& plan, const DevicePicture& picture) {
  if (meshes_.require(plan)) forget(Lost::meshes);
  if (!plan.keeps_vertices) forget(Lost::vertices);
  make_frame_tables(plan, meshes_, picture, now_);
  targets_.make_room({now_.targets.size() * sizeof(layout::TargetConstants)});
  targets_.update(queue_of(*session_), 0, now_.targets);
  if (now_.origin.version != 0 && now_.origin == uploaded_origin_) return;
  uploaded_origin_ = {};
  upload_draws();
  uploaded_origin_ = now_.origin;
}

void FrameMemory::upload_draws() {
  const cl::CommandQueue& queue = queue_of(*session_);
  const layout::FrameConstants& frame = now_.frame;
  const std::size_t primitive_table = frame.primitive_group_count * sizeof(uint);
  const bool moved = draws_.make_room({now_.draws.size() * sizeof(layout::DrawConstants),
                                       frame.vertex_group_count * sizeof(uint), primitive_table, primitive_table});
  draws_.update(queue, draw_constants, now_.draws);
  std::vector<std::array<uint, 3>> places = places_of(now_.draws);
  if (!moved && places == uploaded_places_) return;
  uploaded_places_.clear();
  draws_.update(queue, of_vertex_groups, draw_of_vertex_groups(now_.draws));
  draws_.update(queue, of_primitive_groups, draw_of_primitive_groups(now_.draws));
  draws_.update(queue, in_order, draw_in_order(now_.draws));
  uploaded_places_ = std::move(places);
}

void FrameMemory::set_offsets(layout::FrameConstants& constants) const {
  constants.draw_of_vertex_group = draws_.offset(of_vertex_groups);
  constants.draw_of_primitive_group = draws_.offset(of_primitive_groups);
  constants.draw_in_order = draws_.offset(in_order);
}

FrameMemory::Changes FrameMemory::changes() const {
  const FrameTables* before = before_is_known_ ? &before_ : nullptr;
  return {changed_vertex_chunks(now_, before), now_.any_flat && faces_changed(now_, before)};
}

void FrameMemory::drawn() {
  std::swap(before_, now_);
  before_is_known_ = true;
}

}  // namespace morphcl
