// The motion of an elastic object: displacements of its masses as a pure function of the frame's number.
//
// Before the first key of its weights it rests in the shape that they ask for.
#pragma once

#include <cstdint>
#include <memory>

#include "anim/elastic.hpp"
#include "anim/morph_drive.hpp"

namespace morphcl {

enum class ElasticMethod {
  modal,   // exact: each mode of the net is a spring that follows the keys (anim/modal_body.hpp)
  tr_bdf2  // steps of a sixteenth of a frame, from checkpoints (anim/stepped_body.hpp)
};

class ElasticBody {
 public:
  virtual ~ElasticBody() = default;
  // One displacement a mass. May keep what it computed to be faster next time, never to say something else: for one
  // thread at a time. Error(bad_input) when the motion overflows.
  virtual void displacements_at(std::int64_t frame, Displacements& out) = 0;
  virtual ElasticMethod method() const = 0;
};

// The modal form takes memory for every mode and mass, and for every mode and key; beyond these it is left.
constexpr std::size_t max_modal_masses = 256, max_modal_key_states = 4'000'000;

// The masses that stepping is for; more are Error(bad_input).
constexpr std::size_t max_elastic_masses = 200'000;

// Modal for small nets whose weights have plain keys, TR-BDF2 for others. Error(bad_input): too many masses.
ElasticMethod choose_method(const SpringNet& net, const MorphDrive& drive);
std::unique_ptr<ElasticBody> make_elastic_body(SpringNet net, EdgeRest rest, MorphDrive drive, const TimeBase& time);

}  // namespace morphcl
