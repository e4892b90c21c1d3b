#include "host/render/device_renderer.hpp"

#include <algorithm>
#include <map>

#include "host/device/launch.hpp"
#include "host/device/shared_buffer.hpp"
#include "host/error.hpp"
#include "host/render/frame_tables.hpp"
#include "host/render/mesh_store.hpp"

namespace morphcl {

namespace {

using layout::uint;

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
  explicit DeviceRenderer(std::shared_ptr<Session> session) : session_(std::move(session)), meshes_(session_) {
    overflow_.ensure(sizeof(uint));
    overflow_.map<uint>(queue(), 1)[0] = 0;
  }

  void render(const FramePlan& plan, FrameBuffer& frame) override {
    if (frame.width() != plan.width || frame.height() != plan.height || frame.has_color() != plan.color ||
        frame.has_depth() != plan.depth)
      throw Error(ErrorKind::internal, "", "the frame buffer has another size or other channels than the plan");
    meshes_.require(plan);
    const FrameTables tables = make_frame_tables(plan, meshes_);
    layout::FrameConstants constants = make_frame_constants(plan, frame.row_pitch());
    const FinishAtExit finish_before_tables_go(queue());
    upload(tables);
    set_chunks(tables, constants);
    pools_.guess(constants);
    do {
      make_room(tables, constants);
      launch_stages(tables, constants, frame);
    } while (!finish(constants, frame));
  }

  std::string name() const override { return session_->info().name; }

 private:
  const cl::CommandQueue& queue() const { return session_->queue(); }

  cl::Kernel& kernel(const char* stage, const char* name) {
    cl::Kernel& found = kernels_[name];
    if (!found()) found = session_->kernel(stage, name);
    return found;
  }

  // Everything up to the pixels is queued without waiting: what is uploaded must stay until the queue has finished.
  class FinishAtExit {
   public:
    explicit FinishAtExit(const cl::CommandQueue& queue) : queue_(queue) {}
    ~FinishAtExit() {
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
  };

  template <class T>
  void upload(SharedBuffer& buffer, const T* values, std::size_t count) {
    buffer.ensure(std::max<std::size_t>(count, 1) * sizeof(T));
    if (count == 0) return;
    checked("uploading a frame's tables",
            [&] { queue().enqueueWriteBuffer(buffer.buffer(), CL_FALSE, 0, count * sizeof(T), values); });
  }
  template <class T>
  void upload(SharedBuffer& buffer, const std::vector<T>& values) {
    upload(buffer, values.data(), values.size());
  }

  void upload(const FrameTables& tables) {
    upload(draws_, tables.draws);
    upload(targets_, tables.targets);
    upload(lights_, tables.lights);
    upload(group_draw_, tables.group_draw);
    upload(blocks_, tables.blocks);
  }

  // Chunks are a matter of load only: enough of them for the threads to share, each big enough to be worth its bins.
  void set_chunks(const FrameTables& tables, layout::FrameConstants& constants) const {
    constants.group_count = static_cast<uint>(tables.group_draw.size());
    constants.block_count = static_cast<uint>(tables.blocks.size());
    const uint wanted = std::clamp(constants.block_count / 64, 1u, 64u);
    constants.blocks_per_chunk = std::max((constants.block_count + wanted - 1) / wanted, 1u);
    constants.chunk_count =
        std::max((constants.block_count + constants.blocks_per_chunk - 1) / constants.blocks_per_chunk, 1u);
    constants.first_clip_vertex = constants.group_count * layout::lanes;
  }

  uint vertex_chunks(const layout::FrameConstants& constants) const {
    return (constants.group_count + layout::groups_per_chunk - 1) / layout::groups_per_chunk;
  }

  void make_room(const FrameTables& tables, layout::FrameConstants& constants) {
    constants.fragment_pages = pools_.fragment_pages;
    constants.entry_pages = pools_.entry_pages;
    constants.large_capacity = pools_.large;
    constants.clip_capacity = constants.clips ? pools_.clipped : 0;
    const std::size_t chunks = constants.chunk_count,
                      tiles = static_cast<std::size_t>(constants.tiles_x) * constants.tiles_y;
    const std::size_t records =
        constants.first_clip_vertex + std::size_t{constants.clip_capacity} * layout::clip_vertices;
    vertices_.ensure(records * 16);
    attributes_.ensure(tables.any_smooth || tables.any_flat ? std::size_t{constants.first_clip_vertex} * 16 : 16);
    colors_.ensure(tables.any_colors ? std::size_t{constants.first_clip_vertex} * 16 : 16);
    face_light_.ensure(tables.any_flat ? std::size_t{constants.block_count} * layout::lanes * 16 : 16);
    vertex_status_.ensure(std::max(vertex_chunks(constants), 1u) * sizeof(uint));
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
    upload(frame_, &constants, 1);
  }

  void launch_stages(const FrameTables& tables, const layout::FrameConstants& constants, FrameBuffer& frame) {
    const cl::NDRange one(1), chunks(constants.chunk_count);
    launch(queue(), kernel("project_vertices", "project_vertices"), cl::NDRange(vertex_chunks(constants)), one,
           frame_.buffer(), draws_.buffer(), targets_.buffer(), group_draw_.buffer(), meshes_.mesh_data(),
           vertices_.buffer(), attributes_.buffer(), colors_.buffer(), vertex_status_.buffer());
    if (tables.any_flat)
      launch(queue(), kernel("light_faces", "light_faces"), chunks, one, frame_.buffer(), draws_.buffer(),
             blocks_.buffer(), meshes_.indices(), lights_.buffer(), attributes_.buffer(), face_light_.buffer());
    if (constants.clips) {
      launch(queue(), kernel("clip_primitives", "count_clipped"), chunks, one, frame_.buffer(), draws_.buffer(),
             blocks_.buffer(), meshes_.indices(), vertices_.buffer(), vertex_status_.buffer(), vertex_chunks(constants),
             status_.buffer());
      launch(queue(), kernel("clip_primitives", "clip_primitives"), chunks, one, frame_.buffer(), draws_.buffer(),
             targets_.buffer(), blocks_.buffer(), meshes_.indices(), meshes_.mesh_data(), vertices_.buffer(),
             status_.buffer(), clip_source_.buffer(), clip_count_.buffer(), clip_weights_.buffer());
    }
    launch(queue(), kernel("bin_primitives", "bin_primitives"), chunks, one, frame_.buffer(), draws_.buffer(),
           blocks_.buffer(), meshes_.indices(), vertices_.buffer(), clip_source_.buffer(), clip_count_.buffer(),
           fragment_heads_.buffer(), fragment_next_.buffer(), fragment_keys_.buffer(), fragment_places_.buffer(),
           entry_heads_.buffer(), entry_next_.buffer(), entry_triangles_.buffer(), large_.buffer(), status_.buffer(),
           overflow_.buffer());
    const std::size_t tile_bytes = std::size_t{layout::tile} * layout::tile * 4;
    launch(queue(), kernel("shade_tiles", "shade_tiles"),
           cl::NDRange(static_cast<std::size_t>(constants.tiles_x) * constants.tiles_y), one, frame_.buffer(),
           draws_.buffer(), blocks_.buffer(), meshes_.indices(), lights_.buffer(), vertices_.buffer(),
           attributes_.buffer(), colors_.buffer(), face_light_.buffer(), clip_source_.buffer(), clip_weights_.buffer(),
           status_.buffer(), fragment_heads_.buffer(), fragment_next_.buffer(), fragment_keys_.buffer(),
           fragment_places_.buffer(), entry_heads_.buffer(), entry_next_.buffer(), entry_triangles_.buffer(),
           large_.buffer(), overflow_.buffer(), color_plane(frame, 0), color_plane(frame, 1), color_plane(frame, 2),
           color_plane(frame, 3), depth_plane(frame), LocalMemory{tile_bytes}, LocalMemory{tile_bytes});
  }

  // Waits for the pixels. False when some pool was too small for this frame: they have grown, and the stages are to run
  // again.
  bool finish(const layout::FrameConstants& constants, FrameBuffer& frame) {
    uint overflow = 0;
    checked("waiting for the frame", [&] {
      queue().enqueueReadBuffer(overflow_.buffer(), CL_FALSE, 0, sizeof overflow, &overflow);
      // Mapping brings the pixels to the host on devices that keep their own copy; on a CPU it costs nothing.
      std::vector<std::pair<cl::Buffer, void*>> mapped;
      const auto map = [&](const cl::Buffer& plane, std::size_t bytes) {
        mapped.emplace_back(plane, queue().enqueueMapBuffer(plane, CL_FALSE, CL_MAP_READ, 0, bytes));
      };
      if (frame.has_color())
        for (int channel = 0; channel < 4; ++channel)
          map(color_plane(frame, channel), frame.plane_elements() * sizeof(std::uint16_t));
      if (frame.has_depth()) map(depth_plane(frame), frame.plane_elements() * sizeof(float));
      queue().finish();
      for (const auto& [plane, pointer] : mapped) queue().enqueueUnmapMemObject(plane, pointer);
    });
    if (overflow == 0) return true;
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

  // A plane of the frame as a buffer that uses the frame's own memory.
  cl::Buffer plane(void* data, std::size_t bytes) {
    constexpr std::size_t most_planes = 64;
    if (planes_.size() > most_planes) planes_.clear();
    cl::Buffer& buffer = planes_[{data, bytes}];
    if (!buffer())
      buffer = checked("wrapping a frame's plane", [&] {
        return cl::Buffer(session_->context(), CL_MEM_WRITE_ONLY | CL_MEM_USE_HOST_PTR, bytes, data);
      });
    return buffer;
  }
  cl::Buffer color_plane(FrameBuffer& frame, int channel) {
    return frame.has_color() ? plane(frame.color(channel), frame.plane_elements() * sizeof(std::uint16_t))
                             : overflow_.buffer();
  }
  cl::Buffer depth_plane(FrameBuffer& frame) {
    return frame.has_depth() ? plane(frame.depth(), frame.plane_elements() * sizeof(float)) : overflow_.buffer();
  }

  SharedBuffer buffer() const { return SharedBuffer(session_->context()); }

  std::shared_ptr<Session> session_;
  MeshStore meshes_;
  Pools pools_;
  std::map<std::string, cl::Kernel> kernels_;
  std::map<std::pair<void*, std::size_t>, cl::Buffer> planes_;
  SharedBuffer frame_ = buffer(), draws_ = buffer(), targets_ = buffer(), lights_ = buffer(), group_draw_ = buffer(),
               blocks_ = buffer();
  SharedBuffer vertices_ = buffer(), attributes_ = buffer(), colors_ = buffer(), face_light_ = buffer(),
               vertex_status_ = buffer();
  SharedBuffer clip_source_ = buffer(), clip_count_ = buffer(), clip_weights_ = buffer();
  SharedBuffer fragment_heads_ = buffer(), fragment_next_ = buffer(), fragment_keys_ = buffer(),
               fragment_places_ = buffer();
  SharedBuffer entry_heads_ = buffer(), entry_next_ = buffer(), entry_triangles_ = buffer(), large_ = buffer();
  SharedBuffer status_ = buffer(), overflow_ = buffer();
};

}  // namespace

std::unique_ptr<Renderer> make_device_renderer(std::shared_ptr<Session> session) {
  return std::make_unique<DeviceRenderer>(std::move(session));
}

}  // namespace morphcl
