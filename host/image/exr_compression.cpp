#include "host/image/exr_compression.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "morphcl/error.hpp"
#include "morphcl/exr.hpp"

namespace morphcl {

namespace {

struct Entry {
  std::string_view name;
  Imf::Compression compression;
  bool lossless;
  int lines;
};

constexpr std::array<Entry, 11> compression_table{{
    {"none", Imf::NO_COMPRESSION, true, 1},
    {"rle", Imf::RLE_COMPRESSION, true, 1},
    {"zips", Imf::ZIPS_COMPRESSION, true, 1},
    {"zip", Imf::ZIP_COMPRESSION, true, 16},
    {"zip:small", Imf::ZIP_COMPRESSION, true, 16},
    {"piz", Imf::PIZ_COMPRESSION, true, 32},
    {"pxr24", Imf::PXR24_COMPRESSION, false, 16},
    {"b44", Imf::B44_COMPRESSION, false, 32},
    {"b44a", Imf::B44A_COMPRESSION, false, 32},
    {"dwaa", Imf::DWAA_COMPRESSION, false, 32},
    {"dwab", Imf::DWAB_COMPRESSION, false, 256},
}};

const Entry* find(Imf::Compression compression) {
  for (const Entry& entry : compression_table)
    if (entry.compression == compression) return &entry;
  return nullptr;
}

}  // namespace

const std::vector<std::string>& compression_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Entry& entry : compression_table) list.emplace_back(entry.name);
    return list;
  }();
  return names;
}

void check_compression(const std::string& name) { exr_compression(name); }

void check_compression(const std::string& name, ChannelSet channels) {
  const bool lossless = is_lossless(exr_compression(name));
  for (const Channel channel : channels& cryptomatte_channels)
    if (!lossless)
      throw Error(ErrorKind::usage, "",
                  fmt::format("the compression {} is lossy, and {} holds ids, which it would change; none, rle, zips, "
                              "zip, zip:small and piz keep every bit",
                              name, name_of(channel)));
}

Imf::Compression exr_compression(const std::string& name) {
  for (const Entry& entry : compression_table)
    if (entry.name == name) return entry.compression;
  throw Error(ErrorKind::usage, "",
              fmt::format("no compression '{}'; there are {}", name, fmt::join(compression_names(), ", ")));
}

ZlibEffort zip_effort(const std::string& name) { return name == "zip:small" ? ZlibEffort::small : ZlibEffort::fast; }

std::string_view compression_name(Imf::Compression compression) {
  const Entry* entry = find(compression);
  return entry ? entry->name : "unknown";
}

bool is_lossless(Imf::Compression compression) {
  const Entry* entry = find(compression);
  return entry && entry->lossless;
}

int lines_per_chunk(int compression) {
  for (const Entry& entry : compression_table)
    if (static_cast<int>(entry.compression) == compression) return entry.lines;
  return 0;
}

}  // namespace morphcl
