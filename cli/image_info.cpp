#include <fmt/core.h>

#include "cli/console.hpp"
#include "cli/info_command.hpp"
#include "cli/json_object.hpp"
#include "cli/table.hpp"
#include "morphcl/error.hpp"
#include "morphcl/exr.hpp"

namespace morphcl::cli {

namespace {
std::string window_text(const ExrWindow& window) {
  return fmt::format("({}, {}) to ({}, {})", window.min.x, window.min.y, window.max.x, window.max.y);
}

// Manifests of Cryptomatte may be long; --json has all of them.
std::string cut_value(const std::string& value) {
  constexpr std::size_t shown = 400;
  return value.size() <= shown ? value : fmt::format("{}... ({} bytes)", value.substr(0, shown), value.size());
}

void print_table(const ExrDescription& header, const ExrFrame& image) {
  std::vector<std::vector<std::string>> rows = {{"parts", std::to_string(header.parts)},
                                                {"data window", window_text(header.data_window)},
                                                {"display window", window_text(header.display_window)},
                                                {"compression", header.compression}};
  for (const ExrChannel& channel : header.channels)
    rows.push_back({"channel", printable(channel.name + " " + channel.type)});
  for (const ExrAttribute& attribute : header.attributes)
    rows.push_back({printable(attribute.name),
                    printable(attribute.value.empty() ? "(" + attribute.type + ")" : cut_value(attribute.value))});
  rows.push_back({"hash of pixels", image.hash});
  for (const std::string& line : aligned(rows)) print_result(line);
}

void print_json(const std::string& path, const ExrDescription& header, const ExrFrame& image) {
  print_result(line_of(json_object("image", {{"path", path},
                                             {"parts", header.parts},
                                             {"compression", header.compression},
                                             {"data_window", window_text(header.data_window)},
                                             {"display_window", window_text(header.display_window)},
                                             {"stored_hash", image.stored_hash},
                                             {"hash", image.hash},
                                             {"frame", image.attributes.frame},
                                             {"fingerprint", image.attributes.fingerprint}})));
  for (const ExrChannel& channel : header.channels)
    print_result(line_of(json_object("channel", {{"name", channel.name}, {"pixels", channel.type}})));
  for (const ExrAttribute& attribute : header.attributes)
    print_result(line_of(
        json_object("attribute", {{"name", attribute.name}, {"of", attribute.type}, {"value", attribute.value}})));
}
}  // namespace

void print_image_info(const std::string& path, bool json) {
  const ExrDescription header = describe_exr(path);
  const ExrFrame image = read_exr(path);
  if (json)
    print_json(path, header, image);
  else
    print_table(header, image);
  require_stored_hash(path, image.stored_hash, image.hash);
}

void require_stored_hash(const std::string& path, const std::string& stored, const std::string& hash) {
  if (!stored.empty() && stored != hash)
    throw Error(ErrorKind::bad_input, path,
                fmt::format("the pixels were changed: their hash is {}, the file was written with {}", hash, stored));
}

}  // namespace morphcl::cli
