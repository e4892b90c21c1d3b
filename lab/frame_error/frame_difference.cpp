#include "lab/frame_error/frame_difference.hpp"

#include <Imath/half.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/frame_error/precise_frame.hpp"
#include "lab/frame_error/stored_number.hpp"
#include "morphcl/error.hpp"

namespace morphcl::accuracy {

namespace {

using reference::ShownPixel;

// `stored`: what the file holds, `computed`: what fp32 gave before that, `nearest`: the exact value stored.
struct Value {
  double exact, nearest, computed, stored;
};

double error(double value, double exact) { return value == exact ? 0.0 : value - exact; }  // also of equal infinities

void add(ErrorByCause& tally, const Value& v, double unit) {
  tally.all.add(error(v.stored, v.exact) / unit);
  tally.storage.add(error(v.nearest, v.exact) / unit);
  tally.arithmetic.add(error(v.computed, v.exact) / unit);
}

// Simulated once, for both renders.
ElasticShapesOfFrame elastic_shapes(const FramePlan& plan) {
  ElasticShapesOfFrame shapes;
  for (const Draw& draw : plan.draws)
    if (draw.displaced) shapes[draw.object] = &draw.displaced->positions;
  return shapes;
}

template <class Geometry>
class Comparison {
 public:
  Comparison(const Scene& scene, const FramePlan& plan, const FrameBuffer& pixels, const std::vector<ShownPixel>& shown,
             FrameDifference& result)
      : truth_(scene, plan.frame, elastic_shapes(plan)), plan_(plan), pixels_(pixels), shown_(shown), result_(result) {
    for (const Object& object : scene.objects) result_.objects.emplace_back().name = object.name;
  }

  void run() {
    const std::vector<Visible<double>> visible = truth_.find_visible();
    for (int y = 0; y < plan_.height; ++y)
      for (int x = 0; x < plan_.width; ++x) {
        const std::size_t at = static_cast<std::size_t>(y) * plan_.width + x;
        compare(x, y, at, visible[at], shown_[at]);
      }
  }

 private:
  void compare(int x, int y, std::size_t at, const Visible<double>& exact, const ShownPixel& shown) {
    const bool exact_shows = exact.object != no_object, shown_shows = shown.object != reference::nothing_shown;
    if (!exact_shows && !shown_shows) return;
    result_.shown[at] = 1;
    Differences& object = result_.objects[exact_shows ? exact.object : shown.object];
    PixelDifference kind = PixelDifference::none;
    if (exact_shows != shown_shows) {
      kind = PixelDifference::outline;
    } else if (exact.object != shown.object || exact.primitive != shown.primitive) {
      const std::optional<double> gap = gap_of_order(x, y, exact, shown);
      kind = gap ? PixelDifference::order : PixelDifference::edge;
      for (Differences* d : {&object, &result_.total}) d->widest_gap = std::max(d->widest_gap, gap.value_or(0));
    }
    for (Differences* d : {&object, &result_.total}) {
      ++d->pixels;
      d->outline += kind == PixelDifference::outline;
      d->edge += kind == PixelDifference::edge;
      d->order += kind == PixelDifference::order;
    }
    result_.mask[at] = static_cast<float>(kind);
    const bool same = kind == PixelDifference::none;
    if (plan_.has_color()) compare_color(x, y, at, exact, shown, same ? &object : nullptr);
    if (plan_.has_depth()) compare_depth(x, y, at, exact, shown, same ? &object : nullptr);
  }

  // How much farther, relative, what is shown lies than what is nearest in truth; nothing where it is not depth that
  // made the difference: where the primitive shown does not cover the pixel in truth, or where the nearest one only
  // just does and lies clearly in front.
  std::optional<double> gap_of_order(int x, int y, const Visible<double>& exact, const ShownPixel& shown) const {
    constexpr int max_shift = 2;               // sub-pixels that rounding and the grid move a vertex
    constexpr double largest_error = 0x1p-16;  // relative, of a depth
    const std::optional<Hit<double>> hit = truth_.hit(shown.object, shown.primitive, x, y);
    if (!hit) return std::nullopt;
    const double gap = std::abs(hit->distance / exact.distance - 1);
    if (gap <= largest_error || truth_.covers_around(exact.object, exact.primitive, x, y, max_shift)) return gap;
    return std::nullopt;
  }

  // `object` takes the errors; null where other things are shown, whose difference only the planes hold.
  void compare_color(int x, int y, std::size_t at, const Visible<double>& exact, const ShownPixel& shown,
                     Differences* object) {
    Vector3<double> color;
    if (exact.object == no_object && plan_.background) {
      const BackgroundRow& row = (*plan_.background)[static_cast<std::size_t>(y)];
      color = {imath_half_to_float(row[0]), imath_half_to_float(row[1]), imath_half_to_float(row[2])};
    } else if (exact.object != no_object)
      color = truth_.color(exact.object, exact.primitive, *truth_.hit(exact.object, exact.primitive, x, y), x, y);
    const double channels[4] = {color.x, color.y, color.z, exact.object != no_object || plan_.background ? 1.0 : 0.0};
    std::vector<float>* const planes[4] = {&result_.red, &result_.green, &result_.blue, &result_.alpha};
    bool other = false;
    for (int c = 0; c < 4; ++c) {
      const double stored = imath_half_to_float(pixels_.color_row(c, y)[x]);
      (*planes[c])[at] = static_cast<float>(std::abs(error(stored, channels[c])));
      if (c == 3 || !object) continue;
      const Value value{channels[c], nearest_half(channels[c]), shown.color[c], stored};
      other |= value.stored != value.nearest;
      for (Differences* d : {object, &result_.total}) {
        add(d->color, value, 1);
        add(d->color_spacing, value, half_spacing(value.exact));
      }
    }
    if (object && other) {
      ++object->other_color;
      ++result_.total.other_color;
    }
  }

  void compare_depth(int x, int y, std::size_t at, const Visible<double>& exact, const ShownPixel& shown,
                     Differences* object) {
    const double stored = pixels_.depth_row(y)[x];
    const double distance = exact.object != no_object ? exact.distance : background_depth;
    const double unit = distance == 0 ? 1 : std::abs(distance);
    result_.depth[at] = result_.mask[at] == static_cast<float>(PixelDifference::outline)
                            ? 1.0f
                            : static_cast<float>(std::abs(error(stored, distance)) / unit);
    if (!object) return;
    const Value value{distance, nearest_float(distance), shown.distance, stored};
    for (Differences* d : {object, &result_.total}) {
      add(d->depth, value, unit);
      add(d->depth_spacing, value, float_spacing(distance));
      d->other_depth += value.stored != value.nearest;
    }
  }

  const PreciseFrame<Geometry> truth_;
  const FramePlan& plan_;
  const FrameBuffer& pixels_;
  const std::vector<ShownPixel>& shown_;
  FrameDifference& result_;
};

}  // namespace

void Tally::add(double error) {
  ++count;
  if (!std::isfinite(error)) {
    ++not_finite;
    return;
  }
  largest = std::max(largest, std::abs(error));
  squares += error * error;
}

double Tally::rms() const {
  const std::size_t finite = count - not_finite;
  return finite == 0 ? 0 : std::sqrt(squares / static_cast<double>(finite));
}

void check_comparable(const FramePlan& plan) {
  constexpr std::size_t max = std::size_t{1} << 26;
  if (static_cast<std::size_t>(plan.width) * plan.height > max)
    throw Error(ErrorKind::usage, "",
                fmt::format("an image of {} x {} pixels; at most {}, as 8192 x 8192 has, are compared", plan.width,
                            plan.height, max));
  if (plan.blends)
    throw Error(ErrorKind::usage, "", "some surface is transparent; surfaces are compared with AlphaMode::opaque");
}

FrameDifference compare_with_fp64(const Scene& scene, const FramePlan& plan, const FrameBuffer& pixels,
                                  const std::vector<ShownPixel>& shown, Truth truth) {
  check_comparable(plan);
  const std::size_t size = static_cast<std::size_t>(plan.width) * plan.height;
  FrameDifference result;
  result.frame = plan.frame;
  result.truth = truth;
  result.width = plan.width;
  result.height = plan.height;
  for (std::vector<float>* plane :
       {&result.red, &result.green, &result.blue, &result.alpha, &result.depth, &result.mask})
    plane->resize(size);
  result.shown.resize(size);
  result.has_color = plan.has_color();
  result.has_depth = plan.has_depth();
  if (truth == Truth::on_grid)
    Comparison<OnGrid<double>>(scene, plan, pixels, shown, result).run();
  else
    Comparison<TrueGeometry<double>>(scene, plan, pixels, shown, result).run();
  std::erase_if(result.objects, [](const Differences& d) { return d.pixels == 0; });
  return result;
}

}  // namespace morphcl::accuracy
