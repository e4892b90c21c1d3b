#include "tests/demos/virtual_display.hpp"

#include <fmt/format.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include "tests/support/temporary_folder.hpp"

namespace morphcl::viewer_test {
namespace {

constexpr std::chrono::seconds kStartLimit{30};

// Words of the header of an XWD file, big-endian (X11/XWDFile.h).
enum XwdWord {
  header_size = 0,
  version = 1,
  width = 4,
  height = 5,
  byte_order = 7,
  pixel_bits = 11,
  row_bytes = 12,
  colors = 19
};

std::uint32_t word(const std::string& data, std::size_t index) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(data.at(4 * index + i));
  return value;
}

}  // namespace

VirtualDisplay::VirtualDisplay(const std::filesystem::path& folder)
    : folder_(folder),
      server_({MORPHCL_TEST_XVFB, "-displayfd", "1", "-screen", "0", "1024x768x24", "-fbdir", folder.string(),
               "-noreset", "-nolisten", "tcp"},
              {.folder = folder}) {
  const auto end = std::chrono::steady_clock::now() + kStartLimit;
  while (server_.runs() && std::chrono::steady_clock::now() < end) {
    const std::string printed = server_.out();  // the number, once the server is ready
    if (const std::size_t line_end = printed.find('\n'); line_end != std::string::npos) {
      name_ = fmt::format(":{}", printed.substr(0, line_end));
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  throw std::runtime_error("Xvfb does not start: " + server_.err());
}

RgbImage VirtualDisplay::screenshot() const {
  const std::string data = test_support::text_of(folder_ / "Xvfb_screen0");
  if (word(data, version) != 7 || word(data, pixel_bits) != 32 || word(data, byte_order) != 0) {
    throw std::runtime_error("Xvfb's frame buffer is not XWD 7 of 32-bit little-endian pixels");
  }
  constexpr std::size_t color_bytes = 12;
  const std::size_t start = word(data, header_size) + color_bytes * word(data, colors);
  RgbImage image(static_cast<int>(word(data, width)), static_cast<int>(word(data, height)), Rgb{});
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::size_t at = start + std::size_t{word(data, row_bytes)} * y + 4 * static_cast<std::size_t>(x);
      const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(data.at(at + i)); };
      image.at(x, y) = {byte(2), byte(1), byte(0)};
    }
  }
  return image;
}

std::string VirtualDisplay::xdotool(const std::vector<std::string>& arguments) const {
  std::vector<std::string> command = {MORPHCL_TEST_XDOTOOL};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const test_support::ProcessResult result = test_support::run_process(
      command, {.environment = {{"DISPLAY", name_}}, .folder = folder_, .limit = kStartLimit});
  if (result.code != 0) return "";
  std::string printed = result.out;
  if (printed.ends_with('\n')) printed.pop_back();
  return printed;
}

}  // namespace morphcl::viewer_test
