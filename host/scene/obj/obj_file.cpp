#include "host/scene/obj/obj_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "host/scene/obj/obj_colors.hpp"
#include "host/scene/obj/obj_text.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// Read without effect: names, smoothing and display settings.
constexpr std::array<std::string_view, 11> ignored = {"g",        "o",        "s",          "mg",        "bevel", "lod",
                                                      "c_interp", "d_interp", "shadow_obj", "trace_obj", "maplib"};

constexpr std::int32_t no_such_element = std::numeric_limits<std::int32_t>::max();

bool has_direction(const glm::vec3& normal) {
  const double length = glm::length(glm::dvec3(normal));
  return length > 0 && std::isfinite(length);
}

class ObjParser {
 public:
  ObjParser(std::string_view text, const std::string& path, const ImportLimits& limits, ImportBudget& budget)
      : statements_(text), limits_(limits), budget_(budget) {
    file_.path = path;
  }

  ObjFile parse() {
    while (statements_.next()) read_statement();
    if (file_.positions.empty())
      throw Error(ErrorKind::bad_input, file_.path, "holds no faces; a Wavefront .obj file with 'f' lines is needed");
    check_indices();
    check_normals();
    check_uvs();
    file_.colors = colors_.finish(file_.positions.size(), file_.path, file_.warnings);
    if (file_.small_faces > 0)
      warn(fmt::format("{} faces of fewer than 3 corners are not drawn, the first at line {}", file_.small_faces,
                       first_small_face_));
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail(std::size_t line, std::string_view what) const {
    throw Error(ErrorKind::bad_input, fmt::format("{}:{}", file_.path, line), what);
  }
  [[noreturn]] void fail(std::string_view what) const { fail(statements_.line(), what); }
  void warn(std::string_view what) { file_.warnings.push_back(fmt::format("{}: {}", printable(file_.path), what)); }

  void read_statement() {
    budget_.go_on(file_.path);
    const std::string_view keyword = statements_.keyword();
    if (keyword == "v")
      read_position();
    else if (keyword == "vn")
      read_normal();
    else if (keyword == "vt")
      read_uv();
    else if (keyword == "f" || keyword == "fo")  // fo: the old name
      read_face();
    else if (keyword == "usemtl")
      material_ = material_index(std::string(statements_.remainder()));
    else if (keyword == "mtllib")
      file_.material_libraries.emplace_back(statements_.remainder());
    else if (keyword == "l")
      not_drawn("lines");
    else if (keyword == "p")
      not_drawn("points");
    else if (std::find(ignored.begin(), ignored.end(), keyword) == ignored.end())
      not_drawn("statement " + printable(keyword.substr(0, 20)));
  }

  void not_drawn(const std::string& what) {
    constexpr std::size_t told = 12;
    auto& all = file_.not_drawn;
    if (all.size() < told && std::find(all.begin(), all.end(), what) == all.end()) all.push_back(what);
  }

  float number(std::string_view word) const {
    const std::optional<float> value = parse_float(word);
    if (!value) fail(fmt::format("'{}' is not a number that is finite in 32-bit floating point", word.substr(0, 60)));
    return *value;
  }

  // x y z, then nothing, a weight w, or a colour.
  void read_position() {
    glm::vec3 position;
    std::array<float, ObjColors::max_numbers> more{};
    std::size_t count = 0;
    for (std::string_view word = statements_.word(); !word.empty(); word = statements_.word(), ++count) {
      if (count == 3 + more.size()) fail("a vertex has at most 7 numbers");
      if (count < 3)
        position[static_cast<int>(count)] = number(word);
      else
        more[count - 3] = parse_float(word).value_or(std::numeric_limits<float>::quiet_NaN());
    }
    if (count < 3 || count == 5) fail(fmt::format("a vertex has 3, 4, 6 or 7 numbers, not {}", count));
    if (count == 4 && std::isnan(more[0])) fail("the fourth of 4 numbers, the weight, is not a number");
    if (file_.positions.size() >=
        std::min<std::uint64_t>(limits_.max_vertices, std::numeric_limits<std::int32_t>::max()))
      fail(fmt::format("more than {} vertices", limits_.max_vertices));
    budget_.charge(1, sizeof(glm::vec3), file_.path);
    if (count >= 6) {
      budget_.charge(1, ObjColors::bytes_each, file_.path);
      colors_.add(file_.positions.size(), std::span(more).first(count - 3));
    }
    file_.positions.push_back(position);
  }

  // What is no normal keeps its place in the numbering.
  void read_normal() {
    glm::vec3 normal;
    for (int axis = 0; axis < 3; ++axis)
      normal[axis] = parse_float(statements_.word()).value_or(std::numeric_limits<float>::quiet_NaN());
    if (file_.normals.size() >= limits_.max_vertices) fail(fmt::format("more than {} normals", limits_.max_vertices));
    budget_.charge(1, sizeof(glm::vec3), file_.path);
    file_.normals.push_back(normal);
  }

  // u and v, 0 where it is not given; what is no number keeps its place in the numbering.
  void read_uv() {
    glm::vec2 uv;
    for (int c = 0; c < 2; ++c) {
      const std::string_view word = statements_.word();
      uv[c] = word.empty() && c == 1 ? 0.0f : parse_float(word).value_or(std::numeric_limits<float>::quiet_NaN());
    }
    if (file_.uvs.size() >= limits_.max_vertices)
      fail(fmt::format("more than {} texture coordinates", limits_.max_vertices));
    budget_.charge(1, sizeof(glm::vec2) + 2 * sizeof(std::int32_t), file_.path);
    file_.uvs.push_back(uv);
  }

  // An index from 1, or counted back from the last element read; those ahead of the face are checked at the end.
  std::int32_t index(std::string_view word, std::size_t count, std::string_view what) const {
    const std::optional<std::int64_t> value = parse_integer(word);
    if (!value) fail(fmt::format("'{}' is not the index of a {}", word.substr(0, 60), what));
    const std::int64_t from_zero = *value > 0 ? *value - 1 : static_cast<std::int64_t>(count) + *value;
    if (*value == 0 || from_zero < 0 || from_zero >= std::numeric_limits<std::int32_t>::max())
      fail(fmt::format("{} {} does not exist; indices start at 1, or at -1 for the last one read", what, *value));
    return static_cast<std::int32_t>(from_zero);
  }

  // Of `count` normals or texture coordinates so far. One that does not exist is found when all are read.
  std::int32_t looks_index(std::string_view word, std::size_t count, std::string_view corner) const {
    const std::optional<std::int64_t> value = parse_integer(word);
    if (!value) fail(fmt::format("'{}' is not a face corner: v, v/vt, v//vn or v/vt/vn", corner.substr(0, 60)));
    const std::int64_t from_zero = *value > 0   ? *value - 1
                                   : *value < 0 ? static_cast<std::int64_t>(count) + *value
                                                : -1;
    return from_zero < 0 || from_zero >= no_such_element ? no_such_element : static_cast<std::int32_t>(from_zero);
  }

  // v, v/vt, v//vn or v/vt/vn; what is empty is absent.
  ObjCorner corner(std::string_view word) const {
    const std::size_t first = word.find('/');
    ObjCorner result;
    result.position = static_cast<std::uint32_t>(index(word.substr(0, first), file_.positions.size(), "vertex"));
    if (first == std::string_view::npos) return result;
    const std::string_view rest = word.substr(first + 1);
    const std::size_t second = rest.find('/');
    const std::string_view texture = rest.substr(0, second);
    if (!texture.empty()) result.uv = looks_index(texture, file_.uvs.size(), word);
    if (second != std::string_view::npos && second + 1 < rest.size())
      result.normal = looks_index(rest.substr(second + 1), file_.normals.size(), word);
    return result;
  }

  void read_face() {
    ObjFace face;
    face.first = static_cast<std::uint32_t>(file_.corners.size());
    face.line = static_cast<std::uint32_t>(statements_.line());
    face.material = material_;
    for (std::string_view word = statements_.word(); !word.empty(); word = statements_.word()) {
      if (file_.corners.size() >= std::numeric_limits<std::uint32_t>::max())
        fail("more face corners than 32 bits count");
      // A corner, its vertex key, its share of a triangle and its side.
      budget_.charge(1, sizeof(ObjCorner) + 2 * sizeof(std::uint64_t) + sizeof(glm::uvec3) + 4 * sizeof(glm::uvec2),
                     file_.path);
      file_.corners.push_back(corner(word));
    }
    face.count = static_cast<std::uint32_t>(file_.corners.size()) - face.first;
    if (face.count < 3) {
      if (file_.small_faces == 0) first_small_face_ = statements_.line();
      ++file_.small_faces;
      file_.corners.resize(face.first);
      return;
    }
    budget_.charge(1, sizeof(ObjFace), file_.path);
    file_.faces.push_back(face);
  }

  std::int32_t material_index(std::string name) {
    const auto [found, is_new] = material_indices_.try_emplace(name, static_cast<std::int32_t>(file_.materials.size()));
    if (is_new) {
      budget_.charge(1, 2 * (sizeof(std::string) + name.size()), file_.path);
      file_.materials.push_back(std::move(name));
    }
    return found->second;
  }

  void check_indices() const {
    for (const ObjFace& face : file_.faces)
      for (std::uint32_t c = face.first; c < face.first + face.count; ++c) {
        const ObjCorner& corner = file_.corners[c];
        if (corner.position >= file_.positions.size())
          fail(face.line, fmt::format("vertex {} does not exist; the file has {}", corner.position + std::uint64_t{1},
                                      file_.positions.size()));
      }
  }

  // They decide how the faces are lit and no more: unless every corner has a direction, all go.
  void check_normals() {
    std::size_t absent = 0, wrong = 0;
    for (const ObjCorner& corner : file_.corners) {
      if (corner.normal < 0)
        ++absent;
      else if (static_cast<std::size_t>(corner.normal) >= file_.normals.size() ||
               !has_direction(file_.normals[static_cast<std::size_t>(corner.normal)]))
        ++wrong;
    }
    if (absent == 0 && wrong == 0) return;
    if (wrong > 0)
      warn(
          fmt::format("the normals of {} of {} face corners are missing, zero or no numbers, so the faces are lit flat",
                      wrong, file_.corners.size()));
    else if (absent < file_.corners.size())
      warn("some face corners have no normal, so the faces are lit flat");
    file_.normals.clear();
    for (ObjCorner& corner : file_.corners) corner.normal = -1;
  }

  // They are seen in the channel uv alone. Equal ones become one, as exporters number them anew for each corner.
  void check_uvs() {
    std::size_t present = 0, wrong = 0;
    for (ObjCorner& corner : file_.corners) {
      if (corner.uv < 0) continue;
      const auto at = static_cast<std::size_t>(corner.uv);
      const bool usable = at < file_.uvs.size() && std::isfinite(file_.uvs[at].x) && std::isfinite(file_.uvs[at].y);
      present += usable;
      wrong += !usable;
      if (!usable) corner.uv = -1;
    }
    if (wrong > 0)
      warn(fmt::format("the texture coordinates of {} of {} face corners are missing or no numbers; 0 is used", wrong,
                       file_.corners.size()));
    if (present == 0) {
      file_.uvs.clear();
      return;
    }
    const std::vector<std::int32_t> first = first_of_equal_uvs();
    for (ObjCorner& corner : file_.corners)
      if (corner.uv >= 0) corner.uv = first[static_cast<std::size_t>(corner.uv)];
  }

  // For each of the texture coordinates the first one that equals it.
  std::vector<std::int32_t> first_of_equal_uvs() const {
    const std::vector<glm::vec2>& uvs = file_.uvs;
    std::vector<std::int32_t> order(uvs.size()), first(uvs.size());
    std::iota(order.begin(), order.end(), 0);
    const auto bits = [&uvs](std::int32_t i) {  // any order does, but NaN has to have its place
      const glm::vec2& uv = uvs[static_cast<std::size_t>(i)];
      return std::pair{std::bit_cast<std::uint32_t>(uv.x), std::bit_cast<std::uint32_t>(uv.y)};
    };
    std::sort(order.begin(), order.end(),
              [&bits](std::int32_t a, std::int32_t b) { return std::pair{bits(a), a} < std::pair{bits(b), b}; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool again = i > 0 && bits(order[i]) == bits(order[i - 1]);
      first[static_cast<std::size_t>(order[i])] = again ? first[static_cast<std::size_t>(order[i - 1])] : order[i];
    }
    return first;
  }

  ObjStatements statements_;
  const ImportLimits& limits_;
  ImportBudget& budget_;
  ObjFile file_;
  std::int32_t material_ = -1;
  std::map<std::string, std::int32_t> material_indices_;
  ObjColors colors_;
  std::size_t first_small_face_ = 0;
};

}  // namespace

ObjFile parse_obj(std::string_view text, const std::string& path, const ImportLimits& limits, ImportBudget& budget) {
  return ObjParser(text, path, limits, budget).parse();
}

}  // namespace morphcl
