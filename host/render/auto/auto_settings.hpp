// The auto renderer with what tests put in place of its own: who decides, and how the device is opened.
#pragma once

#include <functional>
#include <memory>

#include "host/render/auto/choice.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/session.hpp"

namespace morphcl {

struct AutoSettings {
  AutoOptions options = {};
  std::function<Choice(const Situation&)> choose = morphcl::choose;
  std::function<std::shared_ptr<Session>(const SessionOptions&)> open = Session::open;
};

std::unique_ptr<AutoRenderer> make_auto_renderer(const AutoSettings& settings);

}  // namespace morphcl
