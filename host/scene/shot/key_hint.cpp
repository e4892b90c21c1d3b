#include "host/scene/shot/key_hint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/scene/shot/nearest_name.hpp"

namespace morphcl {

namespace {

struct Synonym {
  std::string_view typed;  // in small letters, without _ and -
  std::string_view key;
};

// As ray tracers, glTF, compositors and game engines have them. One that several keys go by stands once for each: which
// of them is meant, the table that it stands in tells.
constexpr Synonym synonyms[] = {
    // camera
    {"position", "eye"},
    {"pos", "eye"},
    {"from", "eye"},
    {"lookfrom", "eye"},
    {"origin", "eye"},
    {"location", "eye"},
    {"translation", "eye"},
    {"lookat", "target"},
    {"at", "target"},
    {"to", "target"},
    {"center", "target"},
    {"centre", "target"},
    {"interest", "target"},
    {"aim", "target"},
    {"upvector", "up"},
    {"vup", "up"},
    {"fov", "fovy_degrees"},
    {"fovy", "fovy_degrees"},
    {"yfov", "fovy_degrees"},
    {"vfov", "fovy_degrees"},
    {"fovdegrees", "fovy_degrees"},
    {"fovradians", "fovy_degrees"},
    {"fieldofview", "fovy_degrees"},
    {"angle", "fovy_degrees"},
    {"fovx", "fovx_degrees"},
    {"xfov", "fovx_degrees"},
    {"hfov", "fovx_degrees"},
    {"znear", "near"},
    {"nearclip", "near"},
    {"nearplane", "near"},
    {"zfar", "far"},
    {"farclip", "far"},
    {"farplane", "far"},
    {"type", "projection"},
    {"kind", "projection"},
    // light
    {"pos", "position"},
    {"location", "position"},
    {"point", "position"},
    {"eye", "position"},
    {"dir", "direction"},
    {"strength", "intensity"},
    {"power", "intensity"},
    {"energy", "intensity"},
    {"brightness", "intensity"},
    {"rgb", "color"},
    // object
    {"basecolor", "color"},
    {"basecolorfactor", "color"},
    {"albedo", "color"},
    {"diffuse", "color"},
    {"file", "mesh"},
    {"path", "mesh"},
    {"model", "mesh"},
    {"shape", "mesh"},
    {"geometry", "mesh"},
    {"id", "name"},
    {"shader", "shading"},
    {"twosided", "double_sided"},
    {"keyframes", "track"},
    {"translation", "transform"},
    {"rotation", "transform"},
    {"scale", "transform"},
    {"morphtargets", "morph_to"},
    {"morphto", "morph_to"},
    {"childof", "parent"},
    {"attachedto", "parent"},
    {"below", "parent"},
    {"group", "parent"},
    // transform steps
    {"translation", "translate"},
    {"position", "translate"},
    {"move", "translate"},
    {"scaling", "scale"},
    {"angle", "degrees"},
    {"rotate", "rotate_about_axis"},
    {"rotation", "rotate_about_axis"},
    // tracks
    {"keyframes", "keys"},
    {"values", "keys"},
    {"property", "target"},
    {"channel", "target"},
    {"path", "target"},
    {"interp", "interpolation"},
    {"easing", "interpolation"},
    // image and frames
    {"resolution", "size"},
    {"dimensions", "size"},
    {"width", "size"},
    {"height", "size"},
    {"layers", "channels"},
    {"spp", "samples"},
    {"antialiasing", "samples"},
    {"codec", "compression"},
    {"framerate", "fps"},
    {"rate", "fps"},
    {"framespersecond", "fps"},
    {"start", "range"},
    {"first", "range"},
    {"end", "range"},
    {"last", "range"},
    {"count", "range"},
    // tables
    {"output", "image"},
    {"render", "image"},
    {"time", "frames"},
    {"animation", "frames"},
    {"mesh", "object"},
    {"model", "object"},
};

// What has another unit, or another direction, elsewhere.
struct Note {
  std::string_view key, text;
};
constexpr std::array<Note, 2> notes{{{"fovy_degrees", " (in degrees, from bottom to top; fovx_degrees is across)"},
                                     {"fovx_degrees", " (in degrees, from left to right; fovy_degrees is upwards)"}}};

// Small letters alone: "lookAt", "look_at" and "look-at" are one.
std::string plain(std::string_view key) {
  std::string text;
  for (const char c : key) {
    if (c == '_' || c == '-') continue;
    text += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return text;
}

// The known key that is meant, or "".
std::string_view meant_key(std::string_view key, const std::vector<std::string_view>& known) {
  const std::string typed = plain(key);
  const auto is_known = [&known](std::string_view name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  };
  for (const std::string_view name : known)
    if (plain(name) == typed) return name;
  for (const Synonym& synonym : synonyms)
    if (synonym.typed == typed && is_known(synonym.key)) return synonym.key;
  // A unit that is missing, or another one: rotate_x, rotate_x_radians, azimuth_deg.
  for (const std::string_view unit : {"", "radians", "radian", "rad", "degree", "deg"})
    for (const std::string_view name : known)
      if (name.ends_with("_degrees") && typed == plain(name.substr(0, name.rfind('_'))) + std::string(unit))
        return name;
  // Several where there is one name: lights, objects.
  for (const std::string_view name : known)
    if (typed == plain(name) + "s" || typed + "s" == plain(name)) return name;
  return "";
}

}  // namespace

std::string key_hint(std::string_view key, const std::vector<std::string_view>& known) {
  const std::string_view meant = meant_key(key, known);
  if (meant.empty()) return suggestion(key, known);
  const auto* const note =
      std::find_if(notes.begin(), notes.end(), [meant](const Note& one) { return one.key == meant; });
  return fmt::format("; did you mean \"{}\"?{}", meant, note == notes.end() ? "" : note->text);
}

}  // namespace morphcl
