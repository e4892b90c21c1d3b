#include "host/image/exr_layers.hpp"
#include "lab/frame_error/difference_files.hpp"

namespace morphcl::accuracy {

void write_difference_exr(const std::string& path, const FrameDifference& d) {
  write_exr_layers(path, d.width, d.height,
                   {{"R", d.red.data()},
                    {"G", d.green.data()},
                    {"B", d.blue.data()},
                    {"A", d.alpha.data()},
                    {"Z", d.depth.data()},
                    {"mask", d.mask.data()}});
}

}  // namespace morphcl::accuracy
