// Shots and models that a test writes, in a fresh folder.
#pragma once

#include <string>
#include <string_view>

#include "morphcl/scene.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::test {

class ShotFolder {
 public:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  void write(const std::string& name, std::string_view text) const { folder_.write(name, text); }
  Scene load(std::string_view shot, const LoadOptions& options = {}) const;  // as shot.toml

  // The whole line of the Error that loading `shot` throws, with this folder's path left out; "" when there is none.
  std::string refusal(std::string_view shot, const LoadOptions& options = {}) const;

 private:
  test_support::TemporaryFolder folder_;
};

// A shot with nothing but a cube.
inline constexpr std::string_view cube_object = "[[object]]\nmesh = \"cube\"\n";

}  // namespace morphcl::test
