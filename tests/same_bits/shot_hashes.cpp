// shot_hashes RENDERER WIDTHxHEIGHT FRAMES SHOT...: one line a frame, "SHOT FRAME HASH", of some frames of each shot:
// the first, the last, and the others evenly between them. RENDERER is "reference", "device", or "device=NAME", part of
// a device's name or platform. Written for itself: "none" and exit code 3 where there is no such device.
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <morphcl/morphcl.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace morphcl;

constexpr int no_such_device = 3;

std::vector<std::int64_t> chosen(const std::vector<std::int64_t>& frames, std::size_t count) {
  std::set<std::size_t> places;
  for (std::size_t i = 0; i < count; ++i)
    places.insert(count == 1 ? 0 : i * (frames.size() - 1) / std::max<std::size_t>(count - 1, 1));
  std::vector<std::int64_t> result;
  for (const std::size_t place : places) result.push_back(frames[place]);
  return result;
}

std::optional<int> whole(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 1) return std::nullopt;
  return value;
}

// The device whose name or platform has this text.
std::optional<std::string> device_with(const std::string& text) {
  prepare_process(0);
  for (const DeviceInfo& device : list_devices())
    if (device.is_cpu && (device.name + "\n" + device.platform).find(text) != std::string::npos)
      return std::to_string(device.index);
  return std::nullopt;
}

void print_hashes(const std::string& shot, int width, int height, std::size_t frames, Renderer& renderer) {
  LoadOptions options;
  options.width = width;
  options.height = height;
  const Scene scene = load_scene(shot, options);
  FrameBuffer pixels(width, height, scene.image.channels);
  for (const std::int64_t frame : chosen(frame_numbers(scene.frames), frames)) {
    renderer.render(plan_frame(scene, frame), pixels);
    fmt::print("{} {} {}\n", std::filesystem::path(shot).stem().string(), frame, pixel_hash(pixels));
  }
}

}  // namespace

int main(int count, char** values) {
  const std::vector<std::string> arguments(values + std::min(count, 1), values + count);
  if (arguments.size() < 4) return 2;
  const std::size_t cross = arguments[1].find('x');
  const auto width = whole(arguments[1].substr(0, cross)), frames = whole(arguments[2]);
  const auto height = whole(cross == std::string::npos ? "" : arguments[1].substr(cross + 1));
  if (!width || !height || !frames) return 2;
  try {
    std::shared_ptr<Session> session;
    std::shared_ptr<Renderer> renderer;
    if (arguments[0] == "reference") {
      renderer = make_reference_renderer();
    } else {
      SessionOptions options;
      if (const std::size_t equals = arguments[0].find('='); equals != std::string::npos) {
        const auto device = device_with(arguments[0].substr(equals + 1));
        if (!device) {
          fmt::print("none\n");
          return no_such_device;
        }
        options.device = *device;
      }
      session = Session::open(options);
      renderer = make_device_renderer(session);
    }
    for (std::size_t i = 3; i < arguments.size(); ++i)
      print_hashes(arguments[i], *width, *height, static_cast<std::size_t>(*frames), *renderer);
    if (session) session->store_programs();
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return error.exit_code();
  }
  return 0;
}
