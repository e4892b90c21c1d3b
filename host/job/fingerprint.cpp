#include "host/job/fingerprint.hpp"

#include <fmt/format.h>

#include "host/image/pixel_hash.hpp"
#include "host/version.hpp"

namespace morphcl {

std::string fingerprint(const Scene& scene) {
  const ImageSettings& image = scene.image;
  // The one text that comes from outside stands last, so that no two scenes give the same line.
  return text_hash(fmt::format(
      "morphcl {} size {}x{} color {} depth {} fps {}/{} depth buffer {} pixels {} content {} compression {}", version,
      image.width, image.height, image.color, image.depth, scene.timeline.time.fps_numerator,
      scene.timeline.time.fps_denominator, name_of(image.depth_format), scene.accuracy_pixels, scene.content_hash,
      image.compression));
}

}  // namespace morphcl
