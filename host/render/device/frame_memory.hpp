// All that stays on the device from frame to frame: meshes, the tables of the draws, projected vertices. One object
// owns it and knows which of it holds for the next frame, so that nothing else has to be kept in step.
//
// A frame: start(), then changes() and its uploads, drawn() once its pixels are there. What a frame that fails leaves
// behind is not trusted.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "host/render/device/buffers.hpp"
#include "host/render/device/device_picture.hpp"
#include "host/render/device/frame_tables.hpp"
#include "host/render/device/mesh_store.hpp"
#include "host/render/device/table_buffer.hpp"

namespace morphcl {

class FrameMemory {
 public:
  explicit FrameMemory(std::shared_ptr<Session> session);

  // What may no longer be relied on. `meshes`: they are stored elsewhere, and with them goes all that points to them:
  // tables and vertices. `vertices`: these alone, with their attributes, colours and the light of faces.
  enum class Lost { vertices, meshes };
  void forget(Lost what);

  // Brings the plan's meshes and tables to the device, of which what is as in the frame before stays. Uploads are
  // queued: the queue has to have finished before the next frame starts.
  void start(const FramePlan& plan, const DevicePicture& picture);
  const FrameTables& tables() const { return now_; }
  // Where start() put the tables.
  void set_offsets(layout::FrameConstants& constants) const;

  // What of the vertices and faces is not as this frame needs it.
  struct Changes {
    std::vector<layout::uint> vertex_chunks;
    bool faces = false;
  };
  Changes changes() const;

  // The frame's vertices and faces are on the device now.
  void drawn();

  const TableBuffer<buffers::Draws, 4>& draws() const { return draws_; }
  const TableBuffer<buffers::Targets, 1>& targets() const { return targets_; }
  const MeshStore& meshes() const { return meshes_; }

 private:
  void upload_draws();

  std::shared_ptr<Session> session_;
  MeshStore meshes_;
  FrameTables now_, before_;
  bool before_is_known_ = false;  // what the tables before say of vertices and faces is on the device

  // constants, draw of each vertex group, of each primitive group, and in the order of binning
  TableBuffer<buffers::Draws, 4> draws_;
  TableBuffer<buffers::Targets, 1> targets_;
  DrawsOrigin uploaded_origin_;
  std::vector<std::array<layout::uint, 3>> uploaded_places_;  // of each draw, as the three tables have them
};

}  // namespace morphcl
