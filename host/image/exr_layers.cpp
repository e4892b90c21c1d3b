#include "host/image/exr_layers.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <fmt/format.h>

#include <set>

#include "host/image/atomic_file.hpp"
#include "host/image/exr_stream.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

void write_exr_layers(const std::string& path, int width, int height, const std::vector<ExrLayer>& layers) {
  std::set<std::string> names;
  for (const ExrLayer& layer : layers)
    if (layer.name.empty() || !names.insert(layer.name).second)
      throw Error(ErrorKind::usage, path,
                  fmt::format("a channel named '{}'; each needs a name of its own", layer.name));
  std::vector<char> bytes;
  try {
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    const Imath::Box2i window({0, 0}, {width - 1, height - 1});
    Imf::FrameBuffer planes;
    for (const ExrLayer& layer : layers) {
      header.channels().insert(layer.name, Imf::Channel(Imf::FLOAT));
      planes.insert(layer.name, Imf::Slice::Make(Imf::FLOAT, layer.values, window));
    }
    MemoryOutput output(bytes);
    Imf::OutputFile file(output, header, 0);
    file.setFrameBuffer(planes);
    file.writePixels(height);
  } catch (const std::exception& error) {
    throw Error(ErrorKind::internal, path, error.what());
  }
  write_file_atomically(path, bytes);
}

}  // namespace morphcl
