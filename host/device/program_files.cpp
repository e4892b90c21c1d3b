#include "host/device/program_files.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

namespace morphcl {

namespace fs = std::filesystem;

namespace {

// Of a path, and of the list: more than PoCL ever writes for a program.
constexpr std::uint32_t max_path_bytes = 4096, max_files = 4096;

void append_number(std::vector<unsigned char>& out, std::uint64_t value) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
  out.insert(out.end(), bytes, bytes + sizeof value);
}

void append_text(std::vector<unsigned char>& out, const std::string& text) {
  append_number(out, text.size());
  out.insert(out.end(), text.begin(), text.end());
}

// Reads what the two above wrote.
class PackReader {
 public:
  explicit PackReader(std::span<const unsigned char> bytes) : bytes_(bytes) {}

  std::optional<std::uint64_t> number() {
    std::uint64_t value = 0;
    if (bytes_.size() < sizeof value) return std::nullopt;
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_ = bytes_.subspan(sizeof value);
    return value;
  }

  std::optional<std::span<const unsigned char>> block(std::uint64_t max_bytes) {
    const auto count = number();
    if (!count || *count > max_bytes || *count > bytes_.size()) return std::nullopt;
    const auto block = bytes_.first(static_cast<std::size_t>(*count));
    bytes_ = bytes_.subspan(block.size());
    return block;
  }

  // One that leads nowhere else than below the folder it is appended to.
  std::optional<fs::path> path() {
    const auto text = block(max_path_bytes);
    if (!text) return std::nullopt;
    const fs::path path(std::string(text->begin(), text->end()));
    const bool strays = std::any_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
    if (path.empty() || path.is_absolute() || strays || std::find(text->begin(), text->end(), 0) != text->end())
      return std::nullopt;
    return path;
  }

  std::size_t left() const { return bytes_.size(); }
  bool at_end() const { return bytes_.empty(); }

 private:
  std::span<const unsigned char> bytes_;
};

std::optional<std::string> content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) return std::nullopt;
  return content;
}

bool write_file(const fs::path& file, std::span<const unsigned char> content) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(content.data()), static_cast<std::streamsize>(content.size()));
  stream.close();
  return stream.good();
}

bool unpack_into(const fs::path& folder, PackReader& reader) {
  const auto count = reader.number();
  if (!count || *count > max_files) return false;
  std::error_code failure;
  for (std::uint64_t i = 0; i < *count; ++i) {
    const auto path = reader.path();
    const auto content = path ? reader.block(reader.left()) : std::nullopt;
    if (!content) return false;
    fs::create_directories((folder / *path).parent_path(), failure);
    if (failure || !write_file(folder / *path, *content)) return false;
  }
  return reader.at_end();
}

}  // namespace

std::set<fs::path> program_folders(const fs::path& pocl_folder) {
  std::set<fs::path> programs;
  std::error_code failure;
  for (const auto& outer : fs::directory_iterator(pocl_folder, failure))
    if (outer.is_directory(failure))
      for (const auto& inner : fs::directory_iterator(outer, failure))
        if (inner.is_directory(failure)) programs.insert(outer.path().filename() / inner.path().filename());
  return programs;
}

std::optional<std::vector<unsigned char>> pack_program_files(const fs::path& pocl_folder, const fs::path& program,
                                                             const std::set<std::string>& kernels) {
  std::error_code failure;
  std::set<std::string> compiled;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(pocl_folder / program, failure)) {
    if (!entry.is_regular_file(failure) || entry.is_symlink(failure)) continue;
    files.push_back(entry.path().lexically_relative(pocl_folder / program));
    if (entry.path().extension() == ".so") compiled.insert(files.back().begin()->string());
  }
  if (failure || kernels.empty() || !std::includes(compiled.begin(), compiled.end(), kernels.begin(), kernels.end()))
    return std::nullopt;
  std::vector<unsigned char> packed;
  append_text(packed, program.string());
  append_number(packed, files.size());
  for (const fs::path& file : files) {
    const auto content = content_of(pocl_folder / program / file);
    if (!content) return std::nullopt;
    append_text(packed, file.string());
    append_text(packed, *content);
  }
  return packed;
}

std::optional<fs::path> unpack_program_files(const fs::path& pocl_folder, std::span<const unsigned char> packed) {
  PackReader reader(packed);
  const auto program = reader.path();
  if (!program) return std::nullopt;
  std::error_code failure;
  if (fs::exists(pocl_folder / *program, failure)) return program;
  std::string unfinished = (pocl_folder / "unpacking-XXXXXX").string();
  if (mkdtemp(unfinished.data()) == nullptr) return std::nullopt;
  if (unpack_into(unfinished, reader)) {
    fs::create_directories((pocl_folder / *program).parent_path(), failure);
    fs::rename(unfinished, pocl_folder / *program, failure);
  }
  fs::remove_all(unfinished, failure);
  return fs::exists(pocl_folder / *program, failure) ? program : std::nullopt;
}

}  // namespace morphcl
