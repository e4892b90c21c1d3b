// The camera of a view: the shot's own, moved and projected as the keys asked for.
#pragma once

#include <cstdint>
#include <optional>

#include "demos/viewer/demo_settings.hpp"
#include "demos/viewer/demo_state.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl::viewer {

// Orthographic for a parallel projection, frustum for the others.
ProjectionKind kind_of(const Projection& projection);

// The kind of the shot's camera at `frame`: the view that a demo starts with.
ProjectionKind shot_projection(const Timeline& timeline, std::int64_t frame);

// The camera for `view` of the shot at `frame`; `aspect` is width / height of the image. A view that changes nothing
// gives the shot's camera itself, so that its frames are the frames that `morphcl render` writes. Else the camera is
// fixed at what it is at `frame`:
// - eye_steps moves the eye along the up vector by fortieths of its distance to the target;
// - the orbit then turns eye and up vector about the target, so that there is no pole to get stuck at;
// - zooming brings the eye nearer to the target, or of a parallel projection makes the window smaller;
// - a scene that turns (DemoSettings::turning) looks as from an eye that circles the other way.
// Error(bad_input) when the shot has no camera at this frame (morphcl/timeline.hpp).
std::optional<Camera> view_camera(const Timeline& timeline, std::int64_t frame, const View& view,
                                  const DemoSettings& settings, double aspect);

}  // namespace morphcl::viewer
