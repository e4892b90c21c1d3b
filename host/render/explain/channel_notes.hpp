// What a plan says about its channels beside RGBA and Z.
#pragma once

#include <string>
#include <vector>

#include "host/render/explain/cost_model.hpp"
#include "morphcl/explain.hpp"

namespace morphcl {

// Of a channel that is asked for, what it shows of how many objects: "4 of 5 objects move", or "".
std::string channel_detail(Channel channel, const FramePlan& plan);

// The steps that only channels beside RGBA and Z need, where there are such channels.
std::vector<PlanNote> channel_steps(const FramePlan& plan, const FrameCosts& costs);

}  // namespace morphcl
