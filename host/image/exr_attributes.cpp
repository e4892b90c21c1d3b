#include "host/image/exr_attributes.hpp"

#include <ImfDoubleAttribute.h>
#include <ImfIntAttribute.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <limits>
#include <optional>

#include "host/image/cryptomatte_attributes.hpp"
#include "host/image/exr_planes.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// Imath's matrices act on row vectors: what is a column there is a row here.
Imath::M44f to_imath(const glm::dmat4& m) {
  Imath::M44f out;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) out[i][j] = static_cast<float>(m[i][j]);
  return out;
}

glm::dmat4 from_imath(const Imath::M44f& m) {
  glm::dmat4 out;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) out[i][j] = m[i][j];
  return out;
}

// The eye looks down -z; OpenEXR's camera along +z. Its own inverse.
glm::dmat4 flip_viewing_axis(glm::dmat4 m) { return glm::row(m, 2, 0.0 - glm::row(m, 2)); }

glm::dmat4 unit_square_from_ndc(const glm::dmat4& m) {
  glm::dmat4 out = glm::row(m, 0, (glm::row(m, 3) + glm::row(m, 0)) * 0.5);
  return glm::row(out, 1, (glm::row(m, 3) - glm::row(m, 1)) * 0.5);
}

glm::dmat4 ndc_from_unit_square(const glm::dmat4& m) {
  glm::dmat4 out = glm::row(m, 0, 2.0 * glm::row(m, 0) - glm::row(m, 3));
  return glm::row(out, 1, glm::row(m, 3) - 2.0 * glm::row(m, 1));
}

struct ScreenWindow {
  Imath::V2f center{0, 0};
  float width = 1;
};

// The part of the plane at unit distance that a perspective image shows; for anything else OpenEXR asks for the
// default.
ScreenWindow screen_window(const FrameAttributes& attributes) {
  const glm::dmat4 eye_to_ndc = attributes.world_to_ndc * glm::inverse(attributes.world_to_eye);
  const glm::dvec4 x = glm::row(eye_to_ndc, 0), y = glm::row(eye_to_ndc, 1), w = glm::row(eye_to_ndc, 3);
  // w = -z in a perspective projection, apart from the rounding of the inverse.
  const double rounding = 1e-9 * std::abs(w.z);
  const bool perspective =
      w.z < 0 && std::abs(w.x) <= rounding && std::abs(w.y) <= rounding && std::abs(w.w) <= rounding;
  ScreenWindow window;
  if (!perspective || !(x.x > 0) || !(y.y > 0)) return window;
  // The planes come out of a product of matrices: what is left of a centred one is rounding.
  const auto offset = [](double ratio) { return std::abs(ratio) < 1e-12 ? 0.0f : static_cast<float>(ratio); };
  window.center = {offset(x.z / x.x), offset(y.z / y.y)};
  window.width = static_cast<float>(-2.0 * w.z / x.x);
  return window;
}

std::optional<Imf::TimeCode> time_code(const FrameAttributes& attributes) {
  const std::int64_t rate =
      (2 * attributes.fps_numerator + attributes.fps_denominator) / (2 * attributes.fps_denominator);
  if (rate < 1 || rate > 30) return std::nullopt;
  const std::int64_t frames_a_day = rate * 24 * 60 * 60;
  const std::int64_t frame = ((attributes.frame % frames_a_day) + frames_a_day) % frames_a_day;
  const std::int64_t seconds = frame / rate;
  return Imf::TimeCode(static_cast<int>(seconds / 3600), static_cast<int>(seconds / 60 % 60),
                       static_cast<int>(seconds % 60), static_cast<int>(frame % rate));
}

template <class T>
const T* find(const Imf::Header& header, const char* name) {
  const auto* attribute = header.findTypedAttribute<Imf::TypedAttribute<T>>(name);
  return attribute ? &attribute->value() : nullptr;
}

}  // namespace

void add_attributes(Imf::Header& header, const FrameAttributes& attributes, const std::string& pixel_hash) {
  constexpr std::int64_t largest = std::numeric_limits<int>::max();
  const std::int64_t n = attributes.fps_numerator, d = attributes.fps_denominator;
  if (n < 0 || n > largest || d < 1 || d > largest)
    throw Error(ErrorKind::usage, "", fmt::format("{}/{} frames a second; 0/1 to {}/1 can be stored", n, d, largest));
  if (std::abs(attributes.frame) > largest)
    throw Error(ErrorKind::usage, "",
                fmt::format("frame {}; {} is the last that can be stored", attributes.frame, largest));

  Imf::addFramesPerSecond(header, Imf::Rational(static_cast<int>(n), static_cast<unsigned>(d)));
  header.insert("imageCounter", Imf::IntAttribute(static_cast<int>(attributes.frame)));
  if (const auto code = time_code(attributes)) Imf::addTimeCode(header, *code);
  Imf::addWorldToCamera(header, to_imath(flip_viewing_axis(attributes.world_to_eye)));
  Imf::addWorldToNDC(header, to_imath(unit_square_from_ndc(attributes.world_to_ndc)));
  const ScreenWindow window = screen_window(attributes);
  header.screenWindowCenter() = window.center;
  header.screenWindowWidth() = window.width;
  if (!(channels_of(planes_in(header.channels())) & ChannelSet{Channel::color, Channel::albedo}).empty()) {
    Imf::addChromaticities(header, Imf::Chromaticities());
    header.insert("colorInteropID", Imf::StringAttribute("lin_rec709_scene"));
  }
  add_cryptomatte(header, attributes);
  header.insert(fingerprint_attribute, Imf::StringAttribute(attributes.fingerprint));
  if (!attributes.deviation.empty()) header.insert(deviation_attribute, Imf::StringAttribute(attributes.deviation));
  const auto add_error = [&header](const char* name, double error) {
    if (error != 0) header.insert(name, Imf::DoubleAttribute(error));
  };
  add_error(z_error_attribute, attributes.z_error);
  add_error(p_error_attribute, attributes.p_error);
  add_error(n_error_attribute, attributes.n_error);
  header.insert(pixel_hash_attribute, Imf::StringAttribute(pixel_hash));
}

FrameAttributes attributes_of(const Imf::Header& header) {
  FrameAttributes attributes;
  if (const int* counter = find<int>(header, "imageCounter")) attributes.frame = *counter;
  if (const auto* fps = find<Imf::Rational>(header, "framesPerSecond")) {
    attributes.fps_numerator = fps->n;
    attributes.fps_denominator = fps->d;
  }
  if (const auto* m = find<Imath::M44f>(header, "worldToCamera"))
    attributes.world_to_eye = flip_viewing_axis(from_imath(*m));
  if (const auto* m = find<Imath::M44f>(header, "worldToNDC"))
    attributes.world_to_ndc = ndc_from_unit_square(from_imath(*m));
  if (const double* error = find<double>(header, z_error_attribute)) attributes.z_error = *error;
  if (const double* error = find<double>(header, p_error_attribute)) attributes.p_error = *error;
  if (const double* error = find<double>(header, n_error_attribute)) attributes.n_error = *error;
  attributes.deviation = text_attribute(header, deviation_attribute);
  attributes.fingerprint = text_attribute(header, fingerprint_attribute);
  return attributes;
}

std::string text_attribute(const Imf::Header& header, const char* name) {
  const std::string* text = find<std::string>(header, name);
  return text ? *text : std::string();
}

}  // namespace morphcl
