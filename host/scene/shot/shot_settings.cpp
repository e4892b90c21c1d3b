#include "host/scene/shot/shot_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "host/scene/model/rate_hint.hpp"
#include "host/scene/shot/color_hint.hpp"
#include "host/scene/shot/nearest_name.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

constexpr std::array<std::string_view, 11> compressions = {"none",  "rle", "zips", "zip",  "zip:small", "piz",
                                                           "pxr24", "b44", "b44a", "dwaa", "dwab"};
constexpr std::array<std::string_view, 2> drawn_channels = {"RGBA", "Z"};
constexpr std::array<std::string_view, 5> later_channels = {"N", "P", "velocity", "object_id", "coverage"};
constexpr std::int64_t max_fps_part = 1'000'000;

template <typename Names, typename Name>
bool holds(const Names& names, const Name& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

int pixels(const ShotValue& value) {
  const std::int64_t size = value.integer();
  if (size < 1 || size > max_image_size)
    value.fail(fmt::format("size is {} pixels; 1 to {} are possible", size, max_image_size));
  return static_cast<int>(size);
}

// "1920x1080", as on the command line.
void refuse_size_text(const ShotValue& size) {
  if (!size.is_text()) return;
  const std::string& text = size.text();
  int width = 0, height = 0;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, width);
  if (first.ec != std::errc() || first.ptr == end || (*first.ptr != 'x' && *first.ptr != 'X')) return;
  const auto second = std::from_chars(first.ptr + 1, end, height);
  if (second.ec == std::errc() && second.ptr == end)
    size.fail(fmt::format("size is \"{}\"; in a shot it is two integers: size = [{}, {}]", text, width, height));
}

void read_channels(const ShotValue& channels, ImageSettings& image) {
  image.channels = {};
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const ShotValue channel = channels[i];
    const std::string& name = channel.text();
    if (holds(later_channels, name))
      channel.fail(fmt::format("channel \"{}\": not drawn by this version: RGBA and Z are", name));
    if (!holds(drawn_channels, name))
      channel.fail(fmt::format("unknown channel \"{}\"{}", name, suggestion(name, {"RGBA", "Z"})));
    const Channel wanted = name == "Z" ? Channel::depth : Channel::color;
    if (image.channels.contains(wanted)) channel.fail(fmt::format("channel \"{}\" is named twice", name));
    image.channels.insert(wanted);
  }
  if (channels.size() == 0) channels.fail("channels is empty; name RGBA, Z or both");
}

int read_samples(const ShotValue& samples) {
  const std::int64_t count = samples.integer();
  if (!holds(sample_counts, count)) samples.fail(fmt::format("samples is {}; 1, 2, 4, 8 or 16 are possible", count));
  return static_cast<int>(count);
}

std::string read_compression(const ShotValue& compression) {
  const std::string& name = compression.text();
  if (!holds(compressions, name))
    compression.fail(fmt::format("unknown compression \"{}\"{}", name,
                                 suggestion(name, {compressions.begin(), compressions.end()})));
  return name;
}

DepthFormat read_depth_format(const ShotValue& value) {
  const std::string& name = value.text();
  if (const auto format = depth_format_named(name)) return *format;
  std::vector<std::string_view> names;
  for (const DepthFormat format : depth_formats) names.push_back(name_of(format));
  value.fail(fmt::format("unknown depth_buffer \"{}\"{}", name, suggestion(name, names)));
}

bool is_colors(const ShotValue& value) {
  return value.is_array() && value.size() == 2 && !value[0].is_number() && !value[1].is_number();
}

glm::dvec3 background_color(const ShotValue& value) {
  refuse_color_text(value);
  refuse_codes(value);
  const glm::dvec3 color = value.color();
  if (const double largest = std::max({color.x, color.y, color.z}); largest > max_background)
    value.fail(fmt::format("background is {}; {} is the most that half holds", largest, max_background));
  return color;
}

std::optional<Background> read_background(const ShotValue& value) {
  refuse_color_text(value);  // its message says more than the one below
  if (value.is_text() && value.text() == "none") return std::nullopt;
  if (is_colors(value)) return Background{background_color(value[0]), background_color(value[1])};
  if (!value.is_array() || value.size() != 3)
    value.fail("background must be \"none\", a scene-linear colour [red, green, blue], or two of them: [top, bottom]");
  const glm::dvec3 color = background_color(value);
  return Background{color, color};
}

// The relative error that float channel `channel` may be rounded within; `asked_for`: whether the image has it.
double read_channel_error(const ShotValue& error, std::string_view channel, bool asked_for) {
  const double value = error.number_or_infinity();
  if (!(value > 0 && value <= max_relative_error))
    error.fail(fmt::format("{} is {}; a relative error above 0 and of at most {} is needed, such as 1e-6", error.name(),
                           value, max_relative_error));
  if (!asked_for)
    error.fail(fmt::format("{} is of channel {}, which is not among the channels; add \"{}\" to them, or leave it out",
                           error.name(), channel, channel));
  return value;
}

std::int64_t fps_part(const ShotValue& value) {
  const std::int64_t part = value.integer();
  if (part < 1 || part > max_fps_part) value.fail(fmt::format("fps holds {}; 1 to {} is possible", part, max_fps_part));
  return part;
}

std::string rate_text(const TimeBase& rate) {
  return rate.fps_denominator == 1 ? fmt::format("{}", rate.fps_numerator)
                                   : fmt::format("[{}, {}]", rate.fps_numerator, rate.fps_denominator);
}

// A rate that is written as a decimal, or as text.
void refuse_inexact_rate(const ShotValue& fps) {
  if (fps.integer_if_any() || !(fps.is_number() || fps.is_text())) return;
  const auto rate = fps.is_text() ? rate_in_text(fps.text()) : exact_rate(fps.number());
  if (rate)
    fps.fail(fmt::format("fps is {}; a rate is an integer or a ratio of two, exactly: fps = {}",
                         fps.is_text() ? fmt::format("\"{}\"", fps.text()) : fmt::format("{}", fps.number()),
                         rate_text(*rate)));
}

TimeBase read_fps(const ShotValue& fps) {
  refuse_inexact_rate(fps);
  if (!fps.is_array()) return {.fps_numerator = fps_part(fps), .fps_denominator = 1};
  if (fps.size() != 2) fps.fail("fps must be an integer or [numerator, denominator]");
  return {.fps_numerator = fps_part(fps[0]), .fps_denominator = fps_part(fps[1])};
}

}  // namespace

ImageSettings read_image_settings(const std::optional<ShotValue>& image) {
  ImageSettings settings;
  if (!image) return settings;
  const ShotTable table =
      image->table({"size", "channels", "samples", "compression", "depth_buffer", "background", "z_error"});
  if (const auto size = table.find("size")) {
    refuse_size_text(*size);
    if (!size->is_array() || size->size() != 2) size->fail("size must be two integers: [width, height] in pixels");
    settings.width = pixels((*size)[0]);
    settings.height = pixels((*size)[1]);
  }
  if (const auto channels = table.find("channels")) read_channels(*channels, settings);
  if (const auto samples = table.find("samples")) settings.samples = read_samples(*samples);
  if (const auto compression = table.find("compression")) settings.compression = read_compression(*compression);
  if (const auto format = table.find("depth_buffer")) settings.depth_format = read_depth_format(*format);
  if (const auto background = table.find("background")) settings.background = read_background(*background);
  if (const auto error = table.find("z_error"))
    settings.z_error = read_channel_error(*error, "Z", settings.has_depth());
  return settings;
}

double read_accuracy(const std::optional<ShotValue>& accuracy) {
  if (!accuracy) return 0;
  const auto pixels = accuracy->table({"pixels"}).find("pixels");
  if (!pixels) accuracy->fail("accuracy needs pixels: how far a vertex may be from its exact place");
  return pixels->positive();
}

FrameSettings read_frame_settings(const std::optional<ShotValue>& frames) {
  FrameSettings settings;
  if (!frames) return settings;
  const ShotTable table = frames->table({"range", "fps"});
  if (const auto fps = table.find("fps")) settings.time = read_fps(*fps);
  if (const auto range = table.find("range"))
    settings.ranges = placed_at(*range, [&] {
      auto ranges = parse_frame_range(range->text());
      frame_numbers(ranges);
      return ranges;
    });
  return settings;
}

}  // namespace morphcl
