#include "host/render/device/device_renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "host/device/launch.hpp"
#include "host/device/shared_buffer.hpp"
#include "host/error.hpp"
#include "host/render/device/device_picture.hpp"
#include "host/render/device/device_table.hpp"
#include "host/render/device/frame_tables.hpp"
#include "host/render/device/kept_vertices.hpp"
#include "host/render/device/mesh_store.hpp"
#include "host/render/frame/require_fit.hpp"

namespace morphcl {

namespace {

using layout::uint;

// Kernels are compiled for one depth buffer; those for the default one know nothing of the others.
std::string depth_options(DepthFormat format) {
  return format == DepthFormat::reversed_float ? "" : fmt::format(" -DDEPTH_FORMAT={}", static_cast<int>(format));
}

// Room of one chunk's bins. It starts from a guess and grows to what a frame was found to need.
struct Pools {
  uint fragment_pages = 0, entry_pages = 0, large = 0, clipped = 256;

  void guess(const layout::FrameConstants& frame) {
    const uint primitives = frame.blocks_per_chunk * layout::lanes;
    fragment_pages = std::max(fragment_pages, 256 + primitives / 32);
    entry_pages = std::max(entry_pages, 64 + static_cast<uint>(frame.tiles_x * frame.tiles_y));
    large = std::max(large, 64 + primitives / 8);
  }
  void grow_to(const layout::ChunkStatus& chunk) {
    const auto with_margin = [](uint needed) { return needed + needed / 4; };
    if (chunk.fragment_pages > fragment_pages) fragment_pages = with_margin(chunk.fragment_pages);
    if (chunk.entry_pages > entry_pages) entry_pages = with_margin(chunk.entry_pages);
    if (chunk.large > large) large = with_margin(chunk.large);
  }
};

class DeviceRenderer : public Renderer {
 public:
  DeviceRenderer(std::shared_ptr<Session> session, std::size_t largest_band)
      : session_(std::move(session)), meshes_(session_), pictures_(session_->context(), largest_band) {
    overflow_.ensure(sizeof(uint));
    overflow_.map<uint>(queue(), 1)[0] = 0;
  }

  void render(const FramePlan& plan, FrameBuffer& frame) override {
    require_fit(plan, frame);
    depth_format_ = plan.depth_buffer.format;
    if (meshes_.require(plan)) {
      kept_.forget_meshes();
      tables_.origin = {};
      uploaded_origin_ = {};
    }
    const DevicePicture picture = pictures_.picture(frame);
    make_frame_tables(plan, meshes_, picture, tables_);
    layout::FrameConstants constants = tables_.frame;
    constants.keeps_blank_tiles &= picture.memory.notes_hold ? 1u : 0u;
    FinishAtExit finish_before_tables_go(queue());
    upload_tables();
    set_chunks(constants);
    pools_.guess(constants);
    if (!plan.keeps_vertices) kept_.forget();
    for (bool drawn = false, first = true; !drawn; first = false) {
      const bool stays = make_room(constants);
      const Changes changes = first || !stays ? find_changes() : Changes{};
      kept_.forget();
      prepare(constants, changes);
      shade(picture);
      drawn = finish(constants, picture);
    }
    finish_before_tables_go.not_needed();
    kept_.remember(tables_);
  }

  std::string name() const override { return session_->info().name; }

 private:
  const cl::CommandQueue& queue() const { return session_->queue(); }

  cl::Kernel& kernel(const char* stage, const char* name) {
    cl::Kernel& found = kernels_[{depth_format_, name}];
    if (!found()) found = session_->kernel(stage, name, depth_options(depth_format_));
    return found;
  }

  // Everything up to the pixels is queued without waiting: what is uploaded must stay until the queue has finished.
  class FinishAtExit {
   public:
    explicit FinishAtExit(const cl::CommandQueue& queue) : queue_(queue) {}
    void not_needed() { needed_ = false; }  // the queue has finished
    ~FinishAtExit() {
      if (!needed_) return;
      try {
        queue_.finish();
      } catch (const cl::Error&) {
        // A destructor cannot report; a device lost here fails the next frame as well.
      }
    }
    FinishAtExit(const FinishAtExit&) = delete;
    FinishAtExit& operator=(const FinishAtExit&) = delete;

   private:
    cl::CommandQueue queue_;
    bool needed_ = true;
  };

  void upload_tables() {
    targets_.update(queue(), tables_.targets);
    precise_.update(queue(), tables_.precise);
    lights_.update(queue(), tables_.lights);
    if (tables_.origin.version != 0 && tables_.origin == uploaded_origin_) return;
    uploaded_origin_ = {};
    draws_.update(queue(), tables_.draws);
    const auto place_of = [](const layout::DrawConstants& draw) {
      return std::array{draw.group_count, draw.block_count, draw.first_position};
    };
    std::vector<std::array<uint, 3>> places(tables_.draws.size());
    std::transform(tables_.draws.begin(), tables_.draws.end(), places.begin(), place_of);
    if (places != uploaded_places_) {
      uploaded_places_.clear();
      group_draw_.update(queue(), draw_of_groups(tables_.draws));
      block_draw_.update(queue(), draw_of_blocks(tables_.draws));
      position_draw_.update(queue(), draw_of_positions(tables_.draws));
      uploaded_places_ = std::move(places);
    }
    uploaded_origin_ = tables_.origin;
  }

  // Chunks are a matter of load only: enough of them for the threads to share, each big enough to be worth its bins.
  void set_chunks(layout::FrameConstants& constants) const {
    const uint wanted = std::clamp(constants.block_count / 64, 1u, 64u);
    constants.blocks_per_chunk = std::max((constants.block_count + wanted - 1) / wanted, 1u);
    constants.chunk_count =
        std::max((constants.block_count + constants.blocks_per_chunk - 1) / constants.blocks_per_chunk, 1u);
    constants.first_clip_vertex = constants.group_count * layout::lanes;
  }

  uint vertex_chunks(const layout::FrameConstants& constants) const {
    return (constants.group_count + layout::groups_per_chunk - 1) / layout::groups_per_chunk;
  }

  // False when vertices and what belongs to them had to move, and are lost.
  bool make_room(layout::FrameConstants& constants) {
    constants.fragment_pages = pools_.fragment_pages;
    constants.entry_pages = pools_.entry_pages;
    constants.large_capacity = pools_.large;
    constants.clip_capacity = constants.clips ? pools_.clipped : 0;
    const std::size_t chunks = constants.chunk_count,
                      tiles = static_cast<std::size_t>(constants.tiles_x) * constants.tiles_y;
    const std::size_t records =
        constants.first_clip_vertex + std::size_t{constants.clip_capacity} * layout::clip_vertices;
    bool stays = true;
    const auto ensure_kept = [&](SharedBuffer& buffer, std::size_t bytes) {
      stays &= bytes <= buffer.capacity();
      buffer.ensure(bytes);
    };
    ensure_kept(vertices_, records * 16);
    ensure_kept(attributes_,
                tables_.any_smooth || tables_.any_flat ? std::size_t{constants.first_clip_vertex} * 16 : 16);
    ensure_kept(colors_, tables_.any_colors ? std::size_t{constants.first_clip_vertex} * 16 : 16);
    ensure_kept(face_color_, tables_.any_flat ? std::size_t{constants.block_count} * layout::lanes * 16 : 16);
    ensure_kept(vertex_status_, std::max(vertex_chunks(constants), 1u) * sizeof(uint));
    clip_source_.ensure(std::max(constants.clip_capacity, 1u) * sizeof(uint));
    clip_count_.ensure(std::max(constants.clip_capacity, 1u) * sizeof(uint));
    clip_weights_.ensure(std::max<std::size_t>(constants.clip_capacity, 1) * layout::clip_vertices * 16);
    const std::size_t fragment_pages = chunks * pools_.fragment_pages, entry_pages = chunks * pools_.entry_pages;
    fragment_heads_.ensure(chunks * tiles * sizeof(uint));
    fragment_next_.ensure(fragment_pages * sizeof(uint));
    fragment_keys_.ensure(fragment_pages * layout::page * sizeof(cl_ulong));
    fragment_places_.ensure(fragment_pages * layout::page * sizeof(cl_ushort));
    entry_heads_.ensure(chunks * tiles * sizeof(uint));
    entry_next_.ensure(entry_pages * sizeof(uint));
    entry_triangles_.ensure(entry_pages * layout::page * sizeof(uint));
    large_.ensure(chunks * pools_.large * sizeof(layout::LargeTriangle));
    status_.ensure(chunks * sizeof(layout::ChunkStatus));
    frame_.update(queue(), &constants, 1);
    if (!stays) kept_.forget();
    return stays;
  }

  // What of the frame before is not as it is to be.
  struct Changes {
    uint vertex_chunks = 0;
    bool faces = false;
  };
  Changes find_changes() {
    const std::vector<uint> chunks = kept_.changed_chunks(tables_);
    const bool faces = tables_.any_flat && kept_.faces_changed(tables_);
    if (!chunks.empty()) changed_chunks_.update(queue(), chunks);
    return {static_cast<uint>(chunks.size()), faces};
  }

  // From the vertices to the bins, in as few launches as their order allows: each takes longer than a small frame.
  void prepare(const layout::FrameConstants& constants, Changes changes) {
    const bool at_once =
        changes.vertex_chunks == 1 && vertex_chunks(constants) == 1 && constants.chunk_count == 1 && !constants.clips;
    if (!at_once) project(changes.vertex_chunks);
    if (constants.clips) clip(constants);
    const auto launch_bins = [&](const char* name, const auto&... more) {
      launch(queue(), kernel("bin_primitives", name), cl::NDRange(constants.chunk_count), cl::NDRange(1),
             frame_.buffer(), draws_.buffer(), block_draw_.buffer(), position_draw_.buffer(), meshes_.indices(),
             vertices_.buffer(), clip_source_.buffer(), clip_count_.buffer(), fragment_heads_.buffer(),
             fragment_next_.buffer(), fragment_keys_.buffer(), fragment_places_.buffer(), entry_heads_.buffer(),
             entry_next_.buffer(), entry_triangles_.buffer(), large_.buffer(), status_.buffer(), overflow_.buffer(),
             more...);
    };
    if (at_once)
      launch_bins("project_light_and_bin", lights_.buffer(), attributes_.buffer(), face_color_.buffer(),
                  changed_chunks_.buffer(), targets_.buffer(), precise_.buffer(), group_draw_.buffer(),
                  meshes_.mesh_data(), colors_.buffer(), vertex_status_.buffer());
    else if (changes.faces)
      launch_bins("light_and_bin_primitives", lights_.buffer(), attributes_.buffer(), face_color_.buffer());
    else
      launch_bins("bin_primitives");
  }

  void project(uint changed_chunks) {
    launch(queue(), kernel("project_vertices", "project_vertices"), cl::NDRange(changed_chunks), cl::NDRange(1),
           frame_.buffer(), changed_chunks_.buffer(), draws_.buffer(), targets_.buffer(), precise_.buffer(),
           group_draw_.buffer(), meshes_.mesh_data(), vertices_.buffer(), attributes_.buffer(), colors_.buffer(),
           vertex_status_.buffer());
  }

  void clip(const layout::FrameConstants& constants) {
    const cl::NDRange one(1), chunks(constants.chunk_count);
    launch(queue(), kernel("clip_primitives", "count_clipped"), chunks, one, frame_.buffer(), draws_.buffer(),
           block_draw_.buffer(), meshes_.indices(), vertices_.buffer(), vertex_status_.buffer(),
           vertex_chunks(constants), status_.buffer());
    launch(queue(), kernel("clip_primitives", "clip_primitives"), chunks, one, frame_.buffer(), draws_.buffer(),
           targets_.buffer(), precise_.buffer(), block_draw_.buffer(), meshes_.indices(), meshes_.mesh_data(),
           vertices_.buffer(), status_.buffer(), clip_source_.buffer(), clip_count_.buffer(), clip_weights_.buffer());
  }

  // From the bins to the pixels.
  void shade(const DevicePicture& picture) {
    const std::size_t tile_bytes = std::size_t{layout::tile} * layout::tile * 4;
    for (const DevicePicture::Band& band : picture.bands)
      launch(queue(), kernel("shade_tiles", "shade_tiles"), cl::NDRange(band.tiles), cl::NDRange(1), frame_.buffer(),
             draws_.buffer(), block_draw_.buffer(), meshes_.indices(), lights_.buffer(), vertices_.buffer(),
             attributes_.buffer(), colors_.buffer(), face_color_.buffer(), clip_source_.buffer(),
             clip_weights_.buffer(), status_.buffer(), fragment_heads_.buffer(), fragment_next_.buffer(),
             fragment_keys_.buffer(), fragment_places_.buffer(), entry_heads_.buffer(), entry_next_.buffer(),
             entry_triangles_.buffer(), large_.buffer(), overflow_.buffer(), band.first_tile, band.rows,
             picture.blank_blocks, LocalMemory{tile_bytes}, LocalMemory{tile_bytes});
  }

  // Waits for the pixels. False when some pool was too small for this frame: they have grown, and the frame is to be
  // drawn again.
  bool finish(const layout::FrameConstants& constants, const DevicePicture& picture) {
    checked("waiting for the frame",
            [&] { queue().enqueueReadBuffer(overflow_.buffer(), CL_FALSE, 0, sizeof overflowed_, &overflowed_); });
    DevicePictures::bring_to_host(queue(), picture);
    if (overflowed_ == 0) return true;
    overflow_.map<uint>(queue(), 1)[0] = 0;
    const auto status = status_.map<const layout::ChunkStatus>(queue(), constants.chunk_count);
    uint clipped = 0;
    for (const layout::ChunkStatus& chunk : status.span()) {
      pools_.grow_to(chunk);
      clipped += chunk.clipped;
    }
    if (constants.clips && clipped > pools_.clipped) pools_.clipped = clipped + clipped / 4;
    return false;
  }

  SharedBuffer buffer() const { return SharedBuffer(session_->context()); }

  std::shared_ptr<Session> session_;
  MeshStore meshes_;
  Pools pools_;
  uint overflowed_ = 0;                                     // read by the queue, which may finish after an error
  DepthFormat depth_format_ = DepthFormat::reversed_float;  // of the frame being drawn
  std::map<std::pair<DepthFormat, std::string>, cl::Kernel> kernels_;
  DevicePictures pictures_;
  FrameTables tables_;
  KeptVertices kept_;
  DeviceTable<layout::FrameConstants> frame_{session_->context()};
  DeviceTable<layout::DrawConstants> draws_{session_->context()};
  DeviceTable<layout::TargetConstants> targets_{session_->context()};
  DeviceTable<layout::LightConstants> lights_{session_->context()};
  DeviceTable<layout::PreciseConstants> precise_{session_->context()};
  DeviceTable<uint> group_draw_{session_->context()}, block_draw_{session_->context()},
      position_draw_{session_->context()}, changed_chunks_{session_->context()};
  std::vector<std::array<uint, 3>> uploaded_places_;  // of each draw, as the three tables have them
  DrawsOrigin uploaded_origin_;
  SharedBuffer vertices_ = buffer(), attributes_ = buffer(), colors_ = buffer(), face_color_ = buffer(),
               vertex_status_ = buffer();
  SharedBuffer clip_source_ = buffer(), clip_count_ = buffer(), clip_weights_ = buffer();
  SharedBuffer fragment_heads_ = buffer(), fragment_next_ = buffer(), fragment_keys_ = buffer(),
               fragment_places_ = buffer();
  SharedBuffer entry_heads_ = buffer(), entry_next_ = buffer(), entry_triangles_ = buffer(), large_ = buffer();
  SharedBuffer status_ = buffer(), overflow_ = buffer();
};

}  // namespace

std::unique_ptr<Renderer> make_device_renderer(std::shared_ptr<Session> session, std::size_t largest_band) {
  return std::make_unique<DeviceRenderer>(std::move(session), largest_band);
}

}  // namespace morphcl
