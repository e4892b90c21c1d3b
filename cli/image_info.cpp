#include <fmt/core.h>

#include "cli/console.hpp"
#include "cli/info_command.hpp"
#include "cli/json_line.hpp"
#include "cli/table.hpp"
#include "morphcl/error.hpp"
#include "morphcl/exr.hpp"

namespace morphcl::cli {

namespace {
std::string window_text(const ExrWindow& window) {
  return fmt::format("({}, {}) to ({}, {})", window.min.x, window.min.y, window.max.x, window.max.y);
}

void print_table(const ExrDescription& header, const ExrFrame& image) {
  std::vector<std::vector<std::string>> rows = {{"parts", std::to_string(header.parts)},
                                                {"data window", window_text(header.data_window)},
                                                {"display window", window_text(header.display_window)},
                                                {"compression", header.compression}};
  for (const ExrChannel& channel : header.channels)
    rows.push_back({"channel", printable(channel.name + " " + channel.type)});
  for (const ExrAttribute& attribute : header.attributes)
    rows.push_back(
        {printable(attribute.name), printable(attribute.value.empty() ? "(" + attribute.type + ")" : attribute.value)});
  rows.push_back({"hash of pixels", image.hash});
  for (const std::string& line : aligned(rows)) print_result(line);
}

void print_json(const std::string& path, const ExrDescription& header, const ExrFrame& image) {
  JsonLine line("image");
  line.add("path", path).add("parts", header.parts).add("compression", header.compression);
  line.add("data_window", window_text(header.data_window)).add("display_window", window_text(header.display_window));
  line.add("stored_hash", image.stored_hash).add("hash", image.hash).add("frame", image.attributes.frame);
  print_result(line.add("fingerprint", image.attributes.fingerprint).str());
  for (const ExrChannel& channel : header.channels)
    print_result(JsonLine("channel").add("name", channel.name).add("pixels", channel.type).str());
  for (const ExrAttribute& attribute : header.attributes)
    print_result(JsonLine("attribute")
                     .add("name", attribute.name)
                     .add("of", attribute.type)
                     .add("value", attribute.value)
                     .str());
}
}  // namespace

void print_image_info(const std::string& path, bool json) {
  const ExrDescription header = describe_exr(path);
  const ExrFrame image = read_exr(path);
  if (json)
    print_json(path, header, image);
  else
    print_table(header, image);
  if (!image.stored_hash.empty() && image.stored_hash != image.hash)
    throw Error(ErrorKind::bad_input, path,
                fmt::format("the pixels were changed: their hash is {}, the file was written with {}", image.hash,
                            image.stored_hash));
}

}  // namespace morphcl::cli
