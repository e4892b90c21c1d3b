#include "cli/trace_command.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>

#include "cli/exit_code.hpp"
#include "cli/trace_json.hpp"
#include "cli/trace_latex.hpp"
#include "cli/trace_pixel_text.hpp"
#include "cli/trace_text.hpp"
#include "morphcl/error.hpp"
#include "morphcl/scene.hpp"
#include "morphcl/trace.hpp"

namespace morphcl::cli {

namespace {

// Numbers with commas between; nothing for anything else.
template <class Number, std::size_t count>
std::optional<std::array<Number, count>> read_numbers(const std::string& text) {
  std::array<Number, count> numbers{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 && (at == end || *at++ != ',')) return std::nullopt;
    while (at != end && *at == ' ') ++at;
    const auto [next, error] = std::from_chars(at, end, numbers[i]);
    if (error != std::errc()) return std::nullopt;
    at = next;
  }
  if (at != end) return std::nullopt;
  return numbers;
}

glm::dvec3 parse_point(const std::string& text) {
  const auto numbers = read_numbers<double, 3>(text);
  if (!numbers)
    throw Error(
        ErrorKind::usage, "--point",
        fmt::format("\"{}\" is no point; three numbers with commas between are, as in 0.5,1,-2", printable(text)));
  return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

glm::ivec2 parse_pixel(const std::string& text) {
  const auto numbers = read_numbers<int, 2>(text);
  if (!numbers)
    throw Error(
        ErrorKind::usage, "--pixel",
        fmt::format("\"{}\" is no pixel; two whole numbers with a comma between are, as in 320,180", printable(text)));
  return {(*numbers)[0], (*numbers)[1]};
}

Convention convention_of(const TraceOptions& options) {
  Convention convention;
  if (options.vectors == "row") convention.vectors = VectorForm::row;
  if (options.handedness == "left") convention.handedness = Handedness::left;
  if (options.depth == "zero_to_one") convention.depth = NdcDepth::zero_to_one;
  return convention;
}

TraceRequest request_of(const TraceOptions& options) {
  TraceRequest request{.object = options.object, .convention = convention_of(options)};
  if (options.point) request.point = parse_point(*options.point);
  if (options.vertex) {
    if (*options.vertex < 0)
      throw Error(ErrorKind::usage, "--vertex",
                  fmt::format("{} is no vertex; they are counted from 0", *options.vertex));
    request.vertex = static_cast<std::size_t>(*options.vertex);
  }
  return request;
}

}  // namespace

int trace_command(const TraceOptions& options) {
  const TraceRequest request = request_of(options);
  const std::optional<glm::ivec2> pixel = options.pixel ? std::optional(parse_pixel(*options.pixel)) : std::nullopt;
  const Scene scene = open_scene(options.scene);
  const std::int64_t frame = options.frame ? *options.frame : frame_numbers(scene.frames).front();
  if (pixel) {
    const PixelTrace back = trace_pixel(scene, frame, *pixel, request.convention);
    if (options.json)
      print_pixel_json(back);
    else if (options.latex)
      print_pixel_latex(scene.name, back);
    else
      print_pixel_text(scene.name, back);
    return exit_done;
  }
  const Trace traced = trace(scene, frame, request);
  if (options.json)
    print_trace_json(traced);
  else if (options.latex)
    print_trace_latex(scene.name, traced);
  else
    print_trace_text(scene.name, traced);
  return exit_done;
}

}  // namespace morphcl::cli
