#include "host/render/device/device_renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "host/device/driver_needs.hpp"
#include "host/device/launch.hpp"
#include "host/device/session_access.hpp"
#include "host/render/device/buffers.hpp"
#include "host/render/device/device_picture.hpp"
#include "host/render/device/frame_memory.hpp"
#include "host/render/device/table_buffer.hpp"
#include "host/render/frame/bin_pools.hpp"
#include "host/render/frame/channel_passes.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

using layout::uint;

constexpr std::size_t no_band_limit = std::numeric_limits<std::size_t>::max();

// The private memory of a kernel that shades: depth and id of each sample of a tile, of one sample in local memory or
// small enough; and where draws are blended what kernels/layers.h keeps of a row of blocks, LayerPlanes and LayeredRow.
std::size_t stack_bytes(int samples, bool blends) {
  constexpr std::size_t tile_pixels = std::size_t{layout::tile} * layout::tile, word = sizeof(uint);
  const auto count = static_cast<std::size_t>(samples);
  const std::size_t strip = std::size_t{layout::tile} * layout::tile_block * count;
  const std::size_t planes = LAYER_PLANES(count), sums = 4;
  return (samples == 1 && !blends ? 0 : tile_pixels * count * 2 * word) +
         (blends ? strip * ((planes + 1) * 2 + sums + 2) * word : 0);
}

class DeviceRenderer : public Renderer {
 public:
  DeviceRenderer(std::shared_ptr<Session> session, std::size_t max_band, BeforeFirstUse before_first)
      : session_(std::move(session)),
        before_first_(std::move(before_first)),
        memory_(session_),
        pictures_(context_of(*session_), std::min(max_band, session_->info().max_allocation)) {}

  std::string name() const override { return session_->info().name; }

  // What PoCL's compiler takes, measured, and the bins of a frame.
  Memory memory() const override { return {.per_pixel = 1, .fixed = std::uint64_t{110} << 20}; }

  std::string deviation() const override {
    if (session_->verdict() == Verdict::identical) return "";
    const DeviceInfo& info = session_->info();
    return fmt::format("{}, {}, {}: {}", info.name, info.driver_version, info.platform, session_->verdict_detail());
  }

 private:
  void draw(const FramePlan& plan, FrameBuffer& frame) override {
    if (plan.visibility != VisibilityMethod::z_buffer)
      throw Error(
          ErrorKind::usage, "",
          fmt::format("devices draw by z-buffer; visibility {} is the reference renderer's", name_of(plan.visibility)));
    depth_format_ = plan.depth_format;
    blends_ = plan.blends;
    if (const std::size_t bytes = stack_bytes(plan.samples, plan.blends); bytes > 0) check_stack_limit(bytes);
    const DevicePicture picture = pictures_.picture(frame, max_tile_rows(plan));
    FinishAtExit finish_before_tables_go(queue());
    memory_.start(plan, picture);
    layout::FrameConstants constants = memory_.tables().frame;
    constants.keeps_blank_tiles &= picture.memory.notes_hold ? 1u : 0u;
    constants.first_clip_vertex = constants.vertex_group_count * layout::lanes;
    const ChannelSet of_centres = plan.channels & channels_of_centres, of_samples = plan.channels & channels_of_samples;
    if (plan.samples == 1) {
      draw_pass(1, of_centres | of_samples, constants, picture, pools_, true);
    } else {
      // Distances and what else is that of the pixels' centres: as of one sample a pixel, without colours.
      layout::FrameConstants colors = constants, distances = constants;
      colors.writes_depth = distances.writes_color = 0;
      colors.first_of_two = distances.second_of_two = draws_centres(plan);
      ForgetNotes notes(frame);  // until both have drawn
      draw_pass(plan.samples, of_samples, colors, picture, sample_pools_, true);
      if (draws_centres(plan)) draw_pass(1, of_centres, distances, picture, pools_, false);
      notes.hold();
    }
    finish_before_tables_go.not_needed();
    memory_.drawn();
  }

  // Draws until the bins have had room for all. The vertices of an earlier pass of the frame stay. `channels`: beside
  // colour and distance.
  void draw_pass(int samples, ChannelSet channels, layout::FrameConstants& constants, const DevicePicture& picture,
                 BinPools& pools, bool first_pass) {
    samples_ = samples;
    channels_ = channels;
    constants.writes_ids = !channels.empty();
    const std::size_t id_bytes =
        channels.empty() ? 0 : std::size_t{picture.bands.front().tiles} * ids_bytes_of_tile(samples, blends_);
    for (bool drawn = false, first = first_pass; !drawn; first = false) {
      const bool stays = make_room(pools, constants, id_bytes);
      const FrameMemory::Changes changes = first || !stays ? memory_.changes() : FrameMemory::Changes{};
      memory_.forget(FrameMemory::Lost::vertices);  // until the frame is drawn
      upload_frame(constants, changes.vertex_chunks);
      prepare(constants, changes);
      shade(constants, picture);
      drawn = finish(constants, picture, pools);
    }
  }

  // Between two passes the notes of a frame are of neither.
  class ForgetNotes {
   public:
    explicit ForgetNotes(FrameBuffer& frame) : frame_(&frame) {}
    void hold() { frame_ = nullptr; }
    ~ForgetNotes() {
      if (frame_) frame_->data();
    }
    ForgetNotes(const ForgetNotes&) = delete;
    ForgetNotes& operator=(const ForgetNotes&) = delete;

   private:
    FrameBuffer* frame_;
  };

  const cl::CommandQueue& queue() const { return queue_of(*session_); }

  struct KernelName {
    const char *stage, *name;
    bool shades = false;
  };

  const Kernel& kernel(KernelName of, int samples) {
    const bool blends = blends_ && of.shades;
    Kernel& found = kernels_[{depth_format_, samples, blends, of.name}];
    if (found) return found;
    const FrameKernel wanted{of.stage, of.name, kernel_options(depth_format_, samples, blends)};
    if (before_first_) before_first_(wanted);
    return found = kernel_of(*session_, kernel_source(of.stage), of.name, wanted.options);
  }

  // Calls start(kernel, fragments) with the kernel and the fragments of one sample a pixel, or of several.
  template <class Start>
  void with_fragments(KernelName of_one, KernelName of_several, const Start& start) {
    if (samples_ == 1)
      start(kernel(of_one, 1), fragment_keys_);
    else
      start(kernel(of_several, samples_), sample_fragments_);
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

  // False when vertices and what belongs to them had to move, and are lost.
  bool make_room(BinPools& pools, layout::FrameConstants& constants, std::size_t id_bytes) {
    const BinSizes sizes = lay_out_bins(session_->info().max_allocation, pools, constants, id_bytes);
    const FrameTables& tables = memory_.tables();
    const std::size_t records = constants.first_clip_vertex;
    const std::size_t faces = std::size_t{constants.primitive_group_count} * layout::lanes;
    bool stays = true;
    const auto ensure_kept = [&](auto& buffer, std::size_t elements) { stays &= !buffer.ensure(elements); };
    ensure_kept(vertices_, records + std::size_t{constants.clip_capacity} * layout::clip_vertices);
    ensure_kept(attributes_, tables.any_attributes ? records : 1);
    ensure_kept(colors_, tables.any_colors ? records : 1);
    ensure_kept(face_colors_, tables.any_flat ? faces : 1);
    motion_.ensure(channels_.contains(Channel::velocity) ? 2 * records : 1);
    clipped_.ensure_bytes(sizes.clipped);
    if (samples_ == 1)
      fragment_keys_.ensure_bytes(sizes.fragment_keys);
    else
      sample_fragments_.ensure_bytes(sizes.sample_fragments);
    large_.ensure_bytes(sizes.large);
    // They hold which chunks of vertices need clipping.
    if (bins_.ensure_bytes(sizes.bins)) {
      stays = false;
      bins_are_clear_ = false;
    }
    if (!bins_are_clear_) bins_.map(queue(), 1)[0] = {};
    bins_are_clear_ = true;
    if (!stays) memory_.forget(FrameMemory::Lost::vertices);
    return stays;
  }

  enum FrameTable {
    frame_constants,
    light_constants,
    changed_vertex_chunks,
    precise_constants,
    background_rows,
    channel_constants,
    channel_draws,
    next_draws,
    next_targets,
    next_precise,
    frame_tables
  };

  void upload_frame(layout::FrameConstants& constants, const std::vector<uint>& changed_chunks) {
    const FrameTables& tables = memory_.tables();
    const std::vector<BackgroundRow> none;
    const std::vector<BackgroundRow>& background = tables.background ? *tables.background : none;
    const ChannelTables& channels = tables.channels;
    frame_.make_room({sizeof constants, tables.lights.size() * sizeof(layout::LightConstants),
                      changed_chunks.size() * sizeof(uint), tables.precise.size() * sizeof(layout::PreciseConstants),
                      background.size() * sizeof(BackgroundRow), sizeof channels.constants,
                      channels.draws.size() * sizeof(layout::ChannelDraw),
                      channels.next_draws.size() * sizeof(layout::DrawConstants),
                      channels.next_targets.size() * sizeof(layout::TargetConstants),
                      channels.next_precise.size() * sizeof(layout::PreciseConstants)});
    memory_.set_offsets(constants);
    constants.lights = frame_.offset(light_constants);
    constants.changed_vertex_chunks = frame_.offset(changed_vertex_chunks);
    constants.precise = frame_.offset(precise_constants);
    constants.background = frame_.offset(background_rows);
    constants.channels = frame_.offset(channel_constants);
    frame_.update(queue(), frame_constants, &constants, 1);
    frame_.update(queue(), light_constants, tables.lights);
    frame_.update(queue(), changed_vertex_chunks, changed_chunks);
    frame_.update(queue(), precise_constants, tables.precise);
    frame_.update(queue(), background_rows, background);
    if (!channels_.empty()) upload_channels(channels);
  }

  void upload_channels(const ChannelTables& channels) {
    layout::ChannelConstants constants = channels.constants;
    constants.channels = channels_.bits();
    constants.samples = static_cast<uint>(samples_);
    constants.draws = frame_.offset(channel_draws);
    constants.next_draws = frame_.offset(next_draws);
    constants.next_targets = frame_.offset(next_targets);
    constants.next_precise = frame_.offset(next_precise);
    frame_.update(queue(), channel_constants, &constants, 1);
    frame_.update(queue(), channel_draws, channels.draws);
    frame_.update(queue(), next_draws, channels.next_draws);
    frame_.update(queue(), next_targets, channels.next_targets);
    frame_.update(queue(), next_precise, channels.next_precise);
  }

  // From the vertices to the bins, in as few launches as their order allows: each takes longer than a small frame.
  void prepare(const layout::FrameConstants& constants, const FrameMemory::Changes& changes) {
    const cl::NDRange one(1), chunks(constants.chunk_count);
    const auto& draws = memory_.draws().buffer();
    const auto& targets = memory_.targets().buffer();
    const auto& mesh_data = memory_.meshes().mesh_data();
    const auto& indices = memory_.meshes().indices();
    const auto& frame = frame_.buffer();
    if (changes.vertex_chunks.size() == 1 && vertex_chunk_count(constants) == 1 && constants.chunk_count == 1 &&
        !constants.clips) {
      with_fragments({"bin_primitives", "project_light_and_bin"}, {"bin_samples", "project_light_and_bin_samples"},
                     [&](const Kernel& all, const auto& fragments) {
                       launch(queue(), all, one, one, frame, draws, targets, mesh_data, indices, vertices_, attributes_,
                              colors_, face_colors_, fragments, bins_, large_);
                     });
      return;
    }
    // A second pass finds the vertices of the first.
    if (!constants.second_of_two || !changes.vertex_chunks.empty())
      launch(queue(), kernel({"project_vertices", "project_vertices"}, 1), cl::NDRange(changes.vertex_chunks.size()),
             one, frame, draws, targets, mesh_data, vertices_, attributes_, colors_, bins_);
    if (constants.clips) {
      launch(queue(), kernel({"clip_primitives", "count_clipped"}, 1), chunks, one, frame, draws, indices, vertices_,
             bins_);
      launch(queue(), kernel({"clip_primitives", "clip_primitives"}, 1), chunks, one, frame, draws, targets, mesh_data,
             indices, vertices_, clipped_, bins_);
    }
    if (changes.faces)
      with_fragments({"bin_primitives", "light_and_bin_primitives"}, {"bin_samples", "light_and_bin_samples"},
                     [&](const Kernel& bin, const auto& fragments) {
                       launch(queue(), bin, chunks, one, frame, draws, indices, vertices_, attributes_, face_colors_,
                              clipped_, fragments, bins_, large_);
                     });
    else
      with_fragments({"bin_primitives", "bin_primitives"}, {"bin_samples", "bin_samples"},
                     [&](const Kernel& bin, const auto& fragments) {
                       launch(queue(), bin, chunks, one, frame, draws, indices, vertices_, clipped_, fragments, bins_,
                              large_);
                     });
  }

  // From the bins to the pixels. Channels beside colour and distance follow band by band, from tables of ids that each
  // band has for itself.
  void shade(const layout::FrameConstants& constants, const DevicePicture& picture) {
    if (channels_.contains(Channel::velocity))
      launch(queue(), kernel({"project_next", "project_next"}, 1), cl::NDRange(vertex_chunk_count(constants)),
             cl::NDRange(1), frame_.buffer(), memory_.draws().buffer(), memory_.targets().buffer(),
             memory_.meshes().mesh_data(), motion_);
    for (const DevicePicture::Band& band : picture.bands) {
      with_fragments({"shade_tiles", "shade_tiles", true}, {"shade_samples", "shade_samples", true},
                     [&](const Kernel& pixels, const auto& fragments) {
                       launch(queue(), pixels, FirstItem{band.first_tile}, cl::NDRange(band.tiles), cl::NDRange(1),
                              frame_.buffer(), memory_.draws().buffer(), memory_.meshes().indices(), vertices_,
                              attributes_, colors_, face_colors_, clipped_, fragments, bins_, large_,
                              BufferAs<buffers::Picture>(band.rows));
                     });
      if (!channels_.empty())
        launch(queue(), kernel({"shade_channels", "shade_channels"}, 1), FirstItem{band.first_tile},
               cl::NDRange(band.tiles), cl::NDRange(1), frame_.buffer(), memory_.draws().buffer(),
               memory_.meshes().indices(), memory_.meshes().mesh_data(), vertices_, attributes_, colors_, motion_,
               clipped_, bins_, BufferAs<buffers::Picture>(band.rows));
    }
  }

  // Waits for the pixels. False when some pool was too small for this frame: they have grown, and the frame is to be
  // drawn again.
  bool finish(const layout::FrameConstants& constants, const DevicePicture& picture, BinPools& pools) {
    checked("waiting for the frame",
            [&] { queue().enqueueReadBuffer(bins_.buffer(), CL_FALSE, 0, sizeof overflow_, &overflow_); });
    DevicePictures::bring_to_host(queue(), picture);
    if (overflow_.overflow == 0) return true;
    bins_are_clear_ = false;
    checked("reading what the bins need", [&] {
      statuses_.resize(constants.chunk_count);
      queue().enqueueReadBuffer(bins_.buffer(), CL_TRUE, constants.bins.chunk_status,
                                statuses_.size() * sizeof(layout::ChunkStatus), statuses_.data());
    });
    uint clipped = 0;
    for (const layout::ChunkStatus& chunk : statuses_) {
      pools.grow_to(chunk);
      clipped += chunk.clipped;
    }
    if (constants.clips) pools.grow_to_clipped(clipped);
    return false;
  }

  std::shared_ptr<Session> session_;
  BeforeFirstUse before_first_;
  FrameMemory memory_;
  BinPools pools_ = pools_of(1);                            // of one sample a pixel
  BinPools sample_pools_ = pools_of(2);                     // of several
  DepthFormat depth_format_ = DepthFormat::reversed_float;  // of the frame being drawn
  bool blends_ = false;
  int samples_ = 1;      // of its pass being drawn
  ChannelSet channels_;  // that it makes beside colour and distance
  std::map<std::tuple<DepthFormat, int, bool, std::string>, Kernel> kernels_;
  DevicePictures pictures_;
  TableBuffer<buffers::Frame, frame_tables> frame_{context_of(*session_)};
  DeviceBuffer<buffers::Vertices> vertices_{context_of(*session_)};
  DeviceBuffer<buffers::Attributes> attributes_{context_of(*session_)};
  DeviceBuffer<buffers::Colors> colors_{context_of(*session_)};
  DeviceBuffer<buffers::FaceColors> face_colors_{context_of(*session_)};
  DeviceBuffer<buffers::Motion> motion_{context_of(*session_)};
  DeviceBuffer<buffers::Clipped> clipped_{context_of(*session_)};
  DeviceBuffer<buffers::FragmentKeys> fragment_keys_{context_of(*session_)};
  DeviceBuffer<buffers::SampleFragments> sample_fragments_{context_of(*session_)};
  DeviceBuffer<buffers::Large> large_{context_of(*session_)};
  DeviceBuffer<buffers::Bins> bins_{context_of(*session_)};
  bool bins_are_clear_ = false;    // their overflow flag is 0
  layout::BinsHeader overflow_{};  // read by the queue, which may finish after an error
  std::vector<layout::ChunkStatus> statuses_;
};

}  // namespace

// Kernels are compiled for one depth buffer and one pattern of samples; those for the defaults know nothing of the
// others.
std::string kernel_options(DepthFormat format, int samples, bool blends) {
  std::string options;
  if (format != DepthFormat::reversed_float) options += fmt::format(" -DDEPTH_FORMAT={}", static_cast<int>(format));
  if (samples != 1) options += fmt::format(" -DSAMPLES={}", samples);
  if (blends) options += " -DBLENDS";
  return options;
}

std::unique_ptr<Renderer> make_device_renderer(std::shared_ptr<Session> session, std::size_t max_band) {
  if (!session) throw Error(ErrorKind::usage, "", "a device renderer needs a session; Session::open() gives one");
  return std::make_unique<DeviceRenderer>(std::move(session), max_band, BeforeFirstUse());
}

std::unique_ptr<Renderer> make_device_renderer(std::shared_ptr<Session> session, BeforeFirstUse before_first) {
  return std::make_unique<DeviceRenderer>(std::move(session), no_band_limit, std::move(before_first));
}

std::unique_ptr<Renderer> make_device_renderer(std::shared_ptr<Session> session) {
  return make_device_renderer(std::move(session), no_band_limit);
}

}  // namespace morphcl
