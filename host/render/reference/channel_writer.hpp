// Where a frame's channels beside colour and distance are, for the threads that draw it.
#pragma once

#include "host/render/reference/channels.hpp"
#include "morphcl/frame.hpp"

namespace morphcl::reference {

class ChannelWriter {
 public:
  explicit ChannelWriter(FrameBuffer& frame)
      : channels_(frame.channels()), frame_(frame), memory_(frame.data()), row_bytes_(frame.row_bytes()) {}

  // Stores those of the frame's channels that a pixel's centre, or its samples, say. For threads with a row each.
  void write(const Centre& centre, int x, int y) const;
  void write_shares(const FramePlan& plan, std::span<const Sample> samples, float coverage, int x, int y) const;

 private:
  void write(Channel channel, std::initializer_list<float> values, int x, int y) const;
  void write(Channel channel, std::uint32_t value, int x, int y) const;
  template <class T>
  T& element(Channel channel, int plane, int x, int y) const {
    std::byte* const row = memory_ + static_cast<std::size_t>(y) * row_bytes_ + frame_.plane_offset(channel, plane);
    return reinterpret_cast<T*>(row)[x];
  }

  ChannelSet channels_;
  const FrameBuffer& frame_;
  std::byte* memory_;
  std::size_t row_bytes_;
};

}  // namespace morphcl::reference
