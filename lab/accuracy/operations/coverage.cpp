// Which of two triangles that share an edge covers a pixel centre.
//
// Planes: the four corners a, b, c, d of two triangles (a, b, c) and (a, c, d) and a point, in sub-pixels, all
// integers.
#include <cmath>
#include <cstdint>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"

namespace morphcl::accuracy {

namespace {

using Hits = std::array<float, 2>;  // 1 where a triangle covers the point

// Edge functions in T: integers, or floating point numbers that may round. Centres on an edge belong to the triangle
// whose top or left edge it is.
template <class T>
bool inside_edge(T ax, T ay, T bx, T by, T x, T y) {
  const T dx = bx - ax, dy = by - ay;
  const T value = dx * (y - ay) - dy * (x - ax);
  const bool owns = dy < 0 || (dy == 0 && dx > 0);
  return owns ? value >= 0 : value > 0;
}

template <class T>
bool inside_triangle(T ax, T ay, T bx, T by, T cx, T cy, T x, T y) {
  return inside_edge(ax, ay, bx, by, x, y) && inside_edge(bx, by, cx, cy, x, y) && inside_edge(cx, cy, ax, ay, x, y);
}

template <class T>
Hits hits(float ax, float ay, float bx, float by, float cx, float cy, float dx, float dy, float px, float py) {
  const auto t = [](float value) { return static_cast<T>(value); };
  return {inside_triangle(t(ax), t(ay), t(bx), t(by), t(cx), t(cy), t(px), t(py)) ? 1.0f : 0.0f,
          inside_triangle(t(ax), t(ay), t(cx), t(cy), t(dx), t(dy), t(px), t(py)) ? 1.0f : 0.0f};
}

// A x + B y + C with coefficients set up once a triangle.
bool inside_plane(float ax, float ay, float bx, float by, float x, float y) {
  const float a = ay - by, b = bx - ax, c = ax * by - bx * ay;
  const float value = a * x + b * y + c;
  const bool owns = by < ay || (by == ay && bx > ax);
  return owns ? value >= 0 : value > 0;
}

bool inside_planes(float ax, float ay, float bx, float by, float cx, float cy, float x, float y) {
  return inside_plane(ax, ay, bx, by, x, y) && inside_plane(bx, by, cx, cy, x, y) && inside_plane(cx, cy, ax, ay, x, y);
}

Hits plane_hits(float ax, float ay, float bx, float by, float cx, float cy, float dx, float dy, float px, float py) {
  return {inside_planes(ax, ay, bx, by, cx, cy, px, py) ? 1.0f : 0.0f,
          inside_planes(ax, ay, cx, cy, dx, dy, px, py) ? 1.0f : 0.0f};
}

// A quad whose corners go round the middle of the image, and a point: anywhere near, or next to the shared edge.
struct Shape {
  int half_width, half_height;  // sub-pixels
  int from_edge;                // sub-pixels; 0: anywhere
};

void draw_quad(Random& r, const Shape& s, double* in) {
  const auto within = [&](int half, int low, int high) {
    return static_cast<int>(half * (r.integer(low, high) / 1000.0));
  };
  const int centre_x = s.half_width, centre_y = s.half_height;
  in[0] = centre_x - within(s.half_width, 500, 1000);
  in[1] = centre_y + within(s.half_height, -300, 300);
  in[2] = centre_x + within(s.half_width, -300, 300);
  in[3] = centre_y - within(s.half_height, 500, 1000);
  in[4] = centre_x + within(s.half_width, 500, 1000);
  in[5] = centre_y + within(s.half_height, -300, 300);
  in[6] = centre_x + within(s.half_width, -300, 300);
  in[7] = centre_y + within(s.half_height, 500, 1000);
  if (s.from_edge == 0) {
    in[8] = r.integer(0, 2 * s.half_width);
    in[9] = r.integer(0, 2 * s.half_height);
    return;
  }
  const double t = r.uniform(0, 1);
  in[8] = std::nearbyint(in[0] + t * (in[4] - in[0])) + r.integer(-s.from_edge, s.from_edge);
  in[9] = std::nearbyint(in[1] + t * (in[5] - in[1])) + r.integer(-s.from_edge, s.from_edge);
}

InputFamily coverage_family(const char* name, const char* text, Shape shape) {
  return {name, text, [=](Random& random, std::size_t count) {
            return drawn(random, 10, count, {}, [=](Random& r, double* in) { draw_quad(r, shape, in); });
          }};
}

// On the screen y points down: a triangle that runs a, b, c with positive area has its inside where all edge functions
// are positive.
template <class Number>
Number exact_edge(const Inputs& in, std::size_t i, std::size_t a, std::size_t b) {
  const Number ax = in(2 * a, i), ay = in(2 * a + 1, i), dx = in(2 * b, i) - ax, dy = in(2 * b + 1, i) - ay;
  return dx * (in(9, i) - ay) - dy * (in(8, i) - ax);
}

template <class Number>
bool exact_hit(const Inputs& in, std::size_t i, std::array<std::size_t, 3> corners) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = corners[k], b = corners[(k + 1) % 3];
    const double dx = in(2 * b, i) - in(2 * a, i), dy = in(2 * b + 1, i) - in(2 * a + 1, i);
    const Number value = exact_edge<Number>(in, i, a, b);
    if (value < 0 || (value == 0 && !(dy < 0 || (dy == 0 && dx > 0)))) return false;
  }
  return true;
}

}  // namespace

Operation coverage() {
  PlanarOperation<float> op;
  op.about = {.name = "coverage",
              .title = "which of two triangles with a shared edge covers a pixel centre",
              .results = "hits",
              .format = binary32,
              .plotted = Measure::wrong,
              .target = 0,
              .reason = "every pixel exactly once, as in exact arithmetic"};
  op.results = 2;
  op.measured = 0;
  op.families = {
      coverage_family("benign", "quads of up to 1920 x 1080 pixels, points anywhere", {960 * 256, 540 * 256, 0}),
      coverage_family("wide", "quads over the whole guard band, points within 64 sub-pixels of the shared edge",
                      {1 << 22, 1 << 22, 64}),
      coverage_family("adversarial", "quads over the whole guard band, points within 1 sub-pixel of the shared edge",
                      {1 << 22, 1 << 22, 1}),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    using Number = NumberOf<decltype(results)>;
    results[0].value = exact_hit<Number>(in, i, {0, 1, 2}) ? 1 : 0;
    results[1].value = exact_hit<Number>(in, i, {0, 2, 3}) ? 1 : 0;
  });
  op.events = {Measure::wrong, Measure::holes, Measure::double_hits};
  op.judge = [](const double* computed, const double* exact, EventCounts& events) {
    if (computed[0] != exact[0] || computed[1] != exact[1]) events.count(Measure::wrong);
    const double found = computed[0] + computed[1], there = exact[0] + exact[1];
    if (found < there) events.count(Measure::holes);
    if (found > there) events.count(Measure::double_hits);
  };
  op.variants = {
      elementwise32<10>("fp32 A x + B y + C", inlined<plane_hits>),
      elementwise32<10>("fp32 edge functions", inlined<hits<float>>),
      elementwise32<10>("fp64 edge functions", inlined<hits<double>>),
      shipped(elementwise32<10>("64-bit integers", inlined<hits<std::int64_t>>)),
  };
  op.compared = 16384;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
