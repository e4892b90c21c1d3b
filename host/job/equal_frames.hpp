// Which pictures a job has written, or is about to write, so that a frame with the same picture is copied.
#pragma once

#include <cstdint>
#include <deque>
#include <future>
#include <string>
#include <unordered_map>
#include <variant>

#include "host/render/frame/plan_digest.hpp"

namespace morphcl {

// A frame's file as it was written.
struct WrittenFrame {
  std::int64_t frame = 0;
  std::uint64_t file_bytes = 0;
  std::string file_hash;  // text_hash() of all its bytes; empty: the frame failed
};
using WrittenFrameFuture = std::shared_future<WrittenFrame>;
using WrittenFramePromise = std::promise<WrittenFrame>;

// For one thread; the promises and futures may go to others.
class EqualFrames {
 public:
  // Either the frame that has this picture, or what to fulfil once the caller has drawn and written it. A picture whose
  // frame failed counts as not drawn. The oldest of more than `most` pictures is forgotten.
  std::variant<WrittenFrameFuture, WrittenFramePromise> find_or_claim(const PlanDigest& picture);
  // For a frame whose file has gone since: the next frame with its picture is drawn.
  void forget(const PlanDigest& picture);

  static constexpr std::size_t max_frames = 65536;

 private:
  std::unordered_map<PlanDigest, WrittenFrameFuture> frames_;
  std::deque<PlanDigest> order_;  // of frames_, the oldest first; may name some that were forgotten
};

}  // namespace morphcl
