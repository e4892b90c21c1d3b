// An X server without a screen, for one test: its picture can be read, its keys pressed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/image/png_file.hpp"
#include "tests/support/child_process.hpp"

namespace morphcl::viewer_test {

class VirtualDisplay {
 public:
  // Xvfb on a display that is free, its frame buffer in a file of `folder`; it does not start anew when its last client
  // leaves. Throws when it does not start.
  explicit VirtualDisplay(const std::filesystem::path& folder);

  const std::string& name() const { return name_; }  // ":99"

  RgbImage screenshot() const;

  // Runs xdotool; returns what it printed, "" when it failed.
  std::string xdotool(const std::vector<std::string>& arguments) const;

 private:
  std::filesystem::path folder_;
  test_support::ChildProcess server_;
  std::string name_;
};

}  // namespace morphcl::viewer_test
