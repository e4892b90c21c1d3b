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

constexpr std::array<std::string_view, 6> lossless_compressions = {"none", "rle", "zips", "zip", "zip:small", "piz"};
constexpr std::array<std::string_view, 5> lossy_compressions = {"pxr24", "b44", "b44a", "dwaa", "dwab"};
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
    const std::optional<Channel> wanted = channel_named(name);
    if (!wanted) {
      std::vector<std::string_view> names;
      for (const Channel known : every_channel) names.push_back(name_of(known));
      channel.fail(fmt::format("unknown channel \"{}\"{}", name, suggestion(name, names)));
    }
    if (image.channels.contains(*wanted)) channel.fail(fmt::format("channel \"{}\" is named twice", name));
    image.channels.insert(*wanted);
  }
  if (channels.size() == 0) channels.fail("channels is empty; name RGBA, Z or others");
}

int read_samples(const ShotValue& samples) {
  const std::int64_t count = samples.integer();
  if (!holds(sample_counts, count)) samples.fail(fmt::format("samples is {}; 1, 2, 4, 8 or 16 are possible", count));
  return static_cast<int>(count);
}

std::string read_compression(const ShotValue& compression) {
  const std::string& name = compression.text();
  if (!holds(lossless_compressions, name) && !holds(lossy_compressions, name)) {
    std::vector<std::string_view> names(lossless_compressions.begin(), lossless_compressions.end());
    names.insert(names.end(), lossy_compressions.begin(), lossy_compressions.end());
    compression.fail(fmt::format("unknown compression \"{}\"{}", name, suggestion(name, names)));
  }
  return name;
}

// Cryptomatte's ids must come back bit for bit.
void refuse_lossy_ids(const ShotValue& compression, const ImageSettings& image) {
  if (holds(lossless_compressions, image.compression)) return;
  for (const Channel channel : image.channels& cryptomatte_channels)
    compression.fail(
        fmt::format("compression \"{}\" is lossy, and channel {} holds ids, which it would change; {} keep "
                    "every bit",
                    image.compression, name_of(channel), "none, rle, zips, zip, zip:small and piz"));
}

ChannelNames read_channel_names(const ShotValue& value) {
  const std::string& name = value.text();
  if (const auto names = channel_names_named(name)) return *names;
  value.fail(fmt::format("unknown channel_names \"{}\"{}", name,
                         suggestion(name, {channel_names_names.begin(), channel_names_names.end()})));
}

DepthFormat read_depth_format(const ShotValue& value) {
  const std::string& name = value.text();
  if (const auto format = depth_format_named(name)) return *format;
  std::vector<std::string_view> names;
  for (const DepthFormat format : depth_formats) names.push_back(name_of(format));
  value.fail(fmt::format("unknown depth_buffer \"{}\"{}", name, suggestion(name, names)));
}

VisibilityMethod read_visibility(const ShotValue& value, ImageSettings image) {
  const std::string& name = value.text();
  const auto method = visibility_method_named(name);
  if (!method) {
    std::vector<std::string_view> names;
    for (const VisibilityMethod known : visibility_methods) names.push_back(name_of(known));
    value.fail(fmt::format("unknown visibility \"{}\"{}", name, suggestion(name, names)));
  }
  image.visibility = *method;
  placed_at(value, [&] { return check_visibility(image), 0; });
  return *method;
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

// What a channel may be rounded within.
double read_channel_error(const ShotValue& error, Channel channel, const ImageSettings& image) {
  const double value = error.number_or_infinity();
  const bool absolute = channel == Channel::normal;
  const double max = absolute ? max_absolute_error : max_relative_error;
  if (!(value > 0 && value <= max))
    error.fail(fmt::format("{} is {}; {} error above 0 and of at most {} is needed, such as {}", error.name(), value,
                           absolute ? "an absolute" : "a relative", max, absolute ? "1e-3" : "1e-6"));
  if (!image.channels.contains(channel))
    error.fail(fmt::format("{} is of channel {}, which is not among the channels; add \"{}\" to them, or leave it out",
                           error.name(), name_of(channel), name_of(channel)));
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
  const ShotTable table = image->table({"size", "channels", "channel_names", "samples", "compression", "depth_buffer",
                                        "background", "z_error", "p_error", "n_error", "visibility"});
  if (const auto size = table.find("size")) {
    refuse_size_text(*size);
    if (!size->is_array() || size->size() != 2) size->fail("size must be two integers: [width, height] in pixels");
    settings.width = pixels((*size)[0]);
    settings.height = pixels((*size)[1]);
  }
  if (const auto channels = table.find("channels")) read_channels(*channels, settings);
  if (const auto names = table.find("channel_names")) settings.channel_names = read_channel_names(*names);
  if (const auto samples = table.find("samples")) settings.samples = read_samples(*samples);
  if (const auto compression = table.find("compression")) {
    settings.compression = read_compression(*compression);
    refuse_lossy_ids(*compression, settings);
  }
  if (const auto format = table.find("depth_buffer")) settings.depth_format = read_depth_format(*format);
  if (const auto background = table.find("background")) settings.background = read_background(*background);
  if (const auto error = table.find("z_error")) settings.z_error = read_channel_error(*error, Channel::depth, settings);
  if (const auto error = table.find("p_error"))
    settings.p_error = read_channel_error(*error, Channel::position, settings);
  if (const auto error = table.find("n_error"))
    settings.n_error = read_channel_error(*error, Channel::normal, settings);
  if (const auto method = table.find("visibility")) settings.visibility = read_visibility(*method, settings);
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
