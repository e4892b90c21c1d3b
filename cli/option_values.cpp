#include "cli/option_values.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "host/scene/model/rate_hint.hpp"
#include "host/scene/shot/nearest_name.hpp"
#include "morphcl/error.hpp"
#include "morphcl/exr.hpp"
#include "morphcl/job.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl::cli {

namespace {

constexpr std::int64_t max_rate = 1'000'000;  // numerator and denominator of a frame rate

template <typename Number>
std::optional<Number> whole_number(std::string_view text, Number min, Number max) {
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < min || value > max) return std::nullopt;
  return value;
}
}  // namespace

ImageSize parse_size(const std::string& text) {
  const std::string_view view = text;
  const std::size_t x = view.find('x');
  if (x != std::string_view::npos) {
    const auto width = whole_number<int>(view.substr(0, x), 1, max_image_size);
    const auto height = whole_number<int>(view.substr(x + 1), 1, max_image_size);
    if (width && height) return {*width, *height};
  }
  throw Error(ErrorKind::usage, "--size",
              fmt::format("'{}' is no image size; WIDTHxHEIGHT in pixels, each from 1 to {}, such as 1920x1080", text,
                          max_image_size));
}

std::uint64_t parse_seed(const std::string& text) {
  constexpr std::uint64_t max_seed = std::numeric_limits<std::uint64_t>::max();
  if (const auto seed = whole_number<std::uint64_t>(text, 0, max_seed)) return *seed;
  throw Error(ErrorKind::usage, "--seed", fmt::format("'{}' is no seed; a whole number from 0 to {}", text, max_seed));
}

int parse_png_bits(const std::string& text) {
  if (text == "8") return 8;
  if (text == "16") return 16;
  throw Error(ErrorKind::usage, "--png-bits", fmt::format("'{}' bits a sample; 8 or 16 are possible", text));
}

double parse_exposure(const std::string& text) {
  double stops = 0;
  const std::size_t sign = text.starts_with('+') ? 1 : 0;
  const auto [end, error] = std::from_chars(text.data() + sign, text.data() + text.size(), stops);
  if (error == std::errc() && end == text.data() + text.size() && std::abs(stops) <= max_exposure_stops) return stops;
  throw Error(ErrorKind::usage, "--exposure",
              fmt::format("'{}' is no exposure; a number of stops from -{} to {}, such as -1.5", text,
                          max_exposure_stops, max_exposure_stops));
}

TimeBase parse_fps(const std::string& text) {
  const std::string_view view = text;
  const std::size_t slash = view.find('/');
  const auto numerator = whole_number<std::int64_t>(view.substr(0, slash), 1, max_rate);
  const auto denominator = slash == std::string_view::npos
                               ? std::optional<std::int64_t>(1)
                               : whole_number<std::int64_t>(view.substr(slash + 1), 1, max_rate);
  if (!numerator || !denominator) {
    const auto meant = rate_in_text(text);
    if (meant && slash == std::string_view::npos && meant->fps_denominator != 1)
      throw Error(ErrorKind::usage, "--fps",
                  fmt::format("'{}' is no exact frame rate; a ratio says it: {}/{}", text, meant->fps_numerator,
                              meant->fps_denominator));
    throw Error(ErrorKind::usage, "--fps",
                fmt::format("'{}' is no frame rate; a whole number such as 25, or a ratio such as 30000/1001", text));
  }
  return {*numerator, *denominator};
}

void set_channels(const std::string& list, ImageSettings& image) {
  const auto refuse = [](const std::string& message) { throw Error(ErrorKind::usage, "--channels", message); };
  image.channels = {};
  std::string_view rest = list;
  while (true) {
    const std::size_t comma = rest.find(',');
    const std::string_view name = rest.substr(0, comma);
    const std::optional<Channel> channel = channel_named(name);
    if (!channel) {
      std::vector<std::string_view> names;
      for (const Channel known : every_channel) names.push_back(name_of(known));
      refuse(fmt::format("'{}' is no channel{}", name, suggestion(name, names)));
    }
    if (image.channels.contains(*channel)) refuse(fmt::format("'{}' is named twice", name));
    image.channels.insert(*channel);
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  if (!image.has_depth()) image.z_error = 0;
  if (!image.channels.contains(Channel::position)) image.p_error = 0;
  if (!image.channels.contains(Channel::normal)) image.n_error = 0;
}

void set_channel_names(const std::string& text, ImageSettings& image) {
  const std::optional<ChannelNames> names = channel_names_named(text);
  if (!names)
    throw Error(ErrorKind::usage, "--channel-names",
                fmt::format("'{}' is no choice of names{}", text,
                            suggestion(text, {channel_names_names.begin(), channel_names_names.end()})));
  image.channel_names = *names;
}

namespace {

double channel_error(const char* option, const std::string& text, Channel channel, const ImageSettings& image) {
  const bool absolute = channel == Channel::normal;
  const double max = absolute ? max_absolute_error : max_relative_error;
  double error = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), error);
  if (failure != std::errc() || end != text.data() + text.size() || !(error > 0 && error <= max))
    throw Error(ErrorKind::usage, option,
                fmt::format("'{}' is no {} error of {}; a number above 0 and of at most {}, such as {}", text,
                            absolute ? "absolute" : "relative", name_of(channel), max, absolute ? "1e-3" : "1e-6"));
  if (!image.channels.contains(channel))
    throw Error(ErrorKind::usage, option,
                fmt::format("is of channel {}, which is not among the channels; --channels RGBA,{}", name_of(channel),
                            name_of(channel)));
  return error;
}

}  // namespace

void set_z_error(const std::string& text, ImageSettings& image) {
  image.z_error = channel_error("--z-error", text, Channel::depth, image);
}

void set_p_error(const std::string& text, ImageSettings& image) {
  image.p_error = channel_error("--p-error", text, Channel::position, image);
}

void set_n_error(const std::string& text, ImageSettings& image) {
  image.n_error = channel_error("--n-error", text, Channel::normal, image);
}

void set_compression(const std::string& name, ImageSettings& image) {
  const auto& names = compression_names();
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw Error(ErrorKind::usage, "--compression",
                fmt::format("'{}' is no compression{}", name, suggestion(name, {names.begin(), names.end()})));
  image.compression = name;
}

void set_samples(const std::string& text, ImageSettings& image) {
  const auto samples = whole_number<int>(text, 1, sample_counts.back());
  if (!samples || std::find(sample_counts.begin(), sample_counts.end(), *samples) == sample_counts.end())
    throw Error(ErrorKind::usage, "--samples",
                fmt::format("'{}' samples a pixel; 1, 2, 4, 8 or 16 are possible", text));
  image.samples = *samples;
}

void set_depth_buffer(const std::string& name, ImageSettings& image) {
  const auto format = depth_format_named(name);
  if (!format) {
    std::vector<std::string_view> names;
    for (const DepthFormat known : depth_formats) names.push_back(name_of(known));
    throw Error(ErrorKind::usage, "--depth-buffer",
                fmt::format("'{}' is no depth buffer{}", name, suggestion(name, names)));
  }
  image.depth_format = *format;
}

void set_visibility(const std::string& name, ImageSettings& image) {
  const auto method = visibility_method_named(name);
  if (!method) {
    std::vector<std::string_view> names;
    for (const VisibilityMethod known : visibility_methods) names.push_back(name_of(known));
    throw Error(ErrorKind::usage, "--visibility",
                fmt::format("'{}' is no visibility method{}", name, suggestion(name, names)));
  }
  image.visibility = *method;
}

}  // namespace morphcl::cli
