// An elastic object in steps of TR-BDF2.
//
// Steps lie on a fixed grid of sixteenths of a frame that begins with the frame at or before the first key, so a
// frame's state does not depend on which frames were asked for. States are kept at every stride-th frame; when they
// take more than a fixed memory, every second one is dropped. After the last key stepping ends once a frame in which
// the targets stay leaves every bit as it was.
#pragma once

#include <map>
#include <optional>

#include "anim/elastic_body.hpp"
#include "anim/tr_bdf2.hpp"

namespace morphcl {

class SteppedBody : public ElasticBody {
 public:
  static constexpr int steps_per_frame = 16;
  static constexpr std::size_t max_kept_bytes = std::size_t{64} << 20;

  SteppedBody(SpringNet net, EdgeRest rest, MorphDrive drive, const TimeBase& time,
              std::size_t kept_bytes = max_kept_bytes);
  void displacements_at(std::int64_t frame, Displacements& out) override;
  ElasticMethod method() const override { return ElasticMethod::tr_bdf2; }

 private:
  void rest_at(std::int64_t tick, Displacements& out) const;
  void go_on_one_frame();
  void keep();

  const SpringNet net_;
  const EdgeRest rest_;
  const MorphDrive drive_;
  const bool on_springs_;
  const TimeBase time_;
  const std::size_t max_kept_;
  const TrBdf2 stepper_;
  std::int64_t first_frame_ = 0, end_frame_ = 0;  // nothing moves before; no key comes after
  NetState state_;
  std::int64_t frame_ = 0;                  // of state_
  std::optional<std::int64_t> still_from_;  // the frame that no later one differs from
  std::int64_t stride_ = 1;
  std::map<std::int64_t, NetState> kept_;
};

}  // namespace morphcl
