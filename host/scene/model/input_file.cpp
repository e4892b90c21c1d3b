#include "host/scene/model/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "morphcl/error.hpp"

namespace morphcl {

namespace fs = std::filesystem;

namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void outside(std::string_view place, std::string_view reference, std::string_view why) {
  throw Error(ErrorKind::bad_input, place,
              fmt::format("'{}' {}; files must lie in the folder of the file that names them, or be allowed with "
                          "--allow-outside",
                          reference.substr(0, 200), why));
}

bool has_scheme(std::string_view reference) {
  const std::size_t colon = reference.find(':');
  return colon != std::string_view::npos && colon < reference.find('/');
}

}  // namespace

std::string read_input_file(const std::string& path, std::uint64_t max_bytes) {
  const auto cannot = [&](std::string_view why) { return Error(ErrorKind::cannot_read, path, why); };
  if (path.find('\0') != std::string::npos) throw cannot("the name holds a zero byte");
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (!fs::exists(status)) throw cannot(code ? code.message() : "no such file");
  if (!fs::is_regular_file(status)) throw cannot("not a regular file");
  const std::uintmax_t size = fs::file_size(path, code);
  if (code) throw cannot(code.message());
  if (size > max_bytes)
    throw Error(ErrorKind::bad_input, path, fmt::format("holds {} bytes; at most {} are read", size, max_bytes));
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (!file) throw cannot(std::strerror(errno));
  std::string bytes(static_cast<std::size_t>(size), '\0');
  const std::size_t got = std::fread(bytes.data(), 1, bytes.size(), file.get());
  if (std::ferror(file.get())) throw cannot(std::strerror(errno));
  bytes.resize(got);  // a file that shrank while it was read
  return bytes;
}

void require_utf8(std::string_view text, const std::string& file) {
  using namespace std::string_view_literals;
  const auto zero_at = [text](std::size_t i) { return i < text.size() && text[i] == '\0'; };
  const char* encoding = nullptr;
  if (text.starts_with("\xff\xfe\0\0"sv) || text.starts_with("\0\0\xfe\xff"sv))
    encoding = "UTF-32";
  else if (text.starts_with("\xff\xfe"sv) || text.starts_with("\xfe\xff"sv))
    encoding = "UTF-16";
  else if (text.size() >= 4 && zero_at(0) == zero_at(2) && zero_at(1) == zero_at(3) && zero_at(0) != zero_at(1))
    encoding = "UTF-16";  // ASCII without a mark: every second byte is zero
  if (encoding)
    throw Error(ErrorKind::bad_input, file, fmt::format("is text in {}; save it as UTF-8, which is read", encoding));
}

std::string confined_path(const std::string& owner, std::string_view reference, bool allow_outside,
                          std::string_view place) {
  if (reference.empty() || reference.find('\0') != std::string_view::npos)
    throw Error(ErrorKind::bad_input, place, "the file name is empty or holds a zero byte");
  const fs::path relative{std::string(reference)};
  const fs::path folder = fs::path(owner).parent_path();
  const fs::path joined = folder / relative;
  if (allow_outside) return joined.string();
  if (relative.is_absolute()) outside(place, reference, "is an absolute path");
  if (has_scheme(reference)) outside(place, reference, "has a scheme or a drive");
  std::error_code code;
  // Made absolute first: weakly_canonical leaves the name of a missing file in the working folder relative.
  const fs::path here = fs::current_path(code);
  if (code) throw Error(ErrorKind::cannot_read, place, code.message());
  const fs::path root = fs::weakly_canonical(here / folder, code);
  if (code) throw Error(ErrorKind::cannot_read, place, code.message());
  const fs::path target = fs::weakly_canonical(here / joined, code);
  if (code)
    throw Error(ErrorKind::cannot_read, place, fmt::format("'{}': {}", reference.substr(0, 200), code.message()));
  if (std::mismatch(root.begin(), root.end(), target.begin(), target.end()).first != root.end())
    outside(place, reference, "leaves the folder");
  return target.string();
}

}  // namespace morphcl
