// What the fuzz targets share. An input may be refused by an Error of one line; anything else that is thrown, and what
// the sanitizers report, is a finding.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <span>
#include <string>
#include <string_view>

#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/scene.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::fuzz {

inline void demand(bool holds, std::string_view what) {
  if (holds) return;
  std::cerr << "not so: " << what << '\n';
  std::abort();
}

template <class Action>
void may_refuse(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    const std::string_view line = error.what();
    demand(!line.empty() && line.find('\n') == std::string_view::npos, "an error is one line");
    demand(error.kind() != ErrorKind::internal, "an input is no internal error");
  }
}

// Loads a scene, which must then be valid, and plans its first frame.
inline void load_and_plan(const std::string& path) {
  may_refuse([&] {
    LoadOptions options;
    options.width = 40;
    options.height = 30;
    const Scene scene = load_scene(path, options);
    for (const std::string& warning : scene.warnings)
      demand(warning.find('\n') == std::string::npos, "a warning is one line");
    validate(scene);
    Planner(scene).plan(frame_numbers(scene.frames).front());
  });
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// The files of one run; each input replaces those of the one before.
inline const test_support::TemporaryFolder& folder() {
  static const test_support::TemporaryFolder made;
  return made;
}

}  // namespace morphcl::fuzz
