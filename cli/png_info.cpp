#include <fmt/core.h>

#include "cli/console.hpp"
#include "cli/info_command.hpp"
#include "cli/json_object.hpp"
#include "cli/table.hpp"
#include "morphcl/error.hpp"
#include "morphcl/png.hpp"

namespace morphcl::cli {

namespace {
// Files of other tools may hold long texts; --json has them whole.
std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 200;
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

void print_png_table(const PngDescription& picture) {
  std::vector<std::vector<std::string>> rows = {
      {"size", fmt::format("{} x {}", picture.width, picture.height)},
      {"colour", fmt::format("{}, {} bits{}", picture.color, picture.bits, picture.interlaced ? ", interlaced" : "")}};
  for (const PngText& text : picture.texts) rows.push_back({printable(text.key), printable(shortened(text.value))});
  if (!picture.hash.empty()) rows.push_back({"hash of pixels", picture.hash});
  for (const std::string& line : aligned(rows)) print_result(line);
}

void print_png_json(const std::string& path, const PngDescription& picture) {
  print_result(line_of(json_object("image", {{"path", path},
                                             {"width", picture.width},
                                             {"height", picture.height},
                                             {"color", picture.color},
                                             {"bits", picture.bits},
                                             {"interlaced", picture.interlaced},
                                             {"stored_hash", picture.stored_hash},
                                             {"hash", picture.hash},
                                             {"frame", picture.attributes.frame},
                                             {"fingerprint", picture.attributes.fingerprint}})));
  for (const PngText& text : picture.texts)
    print_result(line_of(json_object("text", {{"key", text.key}, {"value", text.value}})));
}
}  // namespace

void print_png_info(const std::string& path, bool json) {
  const PngDescription picture = describe_png(path);
  if (json)
    print_png_json(path, picture);
  else
    print_png_table(picture);
  require_stored_hash(path, picture.stored_hash, picture.hash.empty() ? "none of " + picture.color : picture.hash);
}

}  // namespace morphcl::cli
