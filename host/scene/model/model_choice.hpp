// Which animation, camera and scene of a model file are meant: by name, else by the file's index from 0.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morphcl {

struct ModelChoice {
  std::optional<std::string> animation = {}, camera = {}, scene = {};  // nothing: the file's own, else the first
};

// The index of the first of `names` that is `wanted`, or that `wanted` writes as a whole number. Error(usage) at `file`
// when there is none, saying which `what` ("animation") there are.
std::size_t choose(const std::vector<std::string>& names, const std::string& wanted, std::string_view what,
                   const std::string& file);

// "0 'Walk', 1 'Run'", some of them when there are many.
std::string numbered(const std::vector<std::string>& names);

}  // namespace morphcl
