#include "tests/batch/test_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>

#include "lab/accuracy/random.hpp"

namespace morphcl::testing {

namespace {

double draw(accuracy::Random& random, Family family, double close) {
  const double value = 2 * random.uniform(0, 1) - 1;
  if (family == Family::wide) return std::ldexp(value, static_cast<int>(40 * random.uniform(0, 1)) - 20);
  return family == Family::cancelling ? 1 + close * value : value;
}

template <class Real>
constexpr double close_to_one = std::is_same_v<Real, float> ? 0x1p-18 : 0x1p-47;

template <class Real>
AffineRows<Real> turned(std::size_t number) {
  AffineRows<Real> rows = general_matrix<Real>();
  const Real bend = static_cast<Real>(number) / Real{8};
  rows.x[0] += bend;
  rows.y[2] -= bend;
  rows.z[3] *= 1 + bend;
  return rows;
}

}  // namespace

template <class Real>
Batch<Real>::Batch(VertexLayout chosen, std::size_t count, Real value) : layout(chosen) {
  for (std::size_t array = 0; array < array_count(layout); ++array)
    arrays[array].assign(count * reals_per_vertex(layout), value);
}

template <class Real>
Vertices<Real> Batch<Real>::vertices() {
  if (layout == VertexLayout::separate) return Vertices<Real>::separate(arrays[0], arrays[1], arrays[2]);
  return layout == VertexLayout::xyz ? Vertices<Real>::xyz(arrays[0]) : Vertices<Real>::xyzw(arrays[0]);
}

template <class Real>
Vertices<const Real> Batch<Real>::vertices() const {
  return const_cast<Batch*>(this)->vertices();
}

template <class Real>
Real& Batch<Real>::at(std::size_t vertex, std::size_t axis) {
  if (layout == VertexLayout::separate) return arrays[std::min<std::size_t>(axis, 2)][vertex];
  return arrays[0][vertex * reals_per_vertex(layout) + axis];
}

template <class Real>
Real Batch<Real>::at(std::size_t vertex, std::size_t axis) const {
  return const_cast<Batch*>(this)->at(vertex, axis);
}

template <class Real>
Batch<Real> make_batch(VertexLayout layout, std::size_t count, Family family, std::uint64_t seed) {
  accuracy::Random random(seed);
  Batch<Real> batch(layout, count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      batch.at(i, axis) = static_cast<Real>(draw(random, family, close_to_one<Real>));
    if (layout == VertexLayout::xyzw) batch.at(i, 3) = static_cast<Real>(i) - Real{7};
  }
  return batch;
}

template <class Real>
AffineRows<Real> general_matrix() {
  return {{Real(-0.71), Real(0.37), Real(1.93), Real(3.3)},
          {Real(0.11), Real(-2.9), Real(0.83), Real(-7.1)},
          {Real(0.57), Real(0.61), Real(0.13), Real(100.7)}};
}

template <class Real>
AffineRows<Real> cancelling_matrix() {
  return {{Real(1.1), Real(-0.7), Real(-0.4), 0},
          {Real(3.3), Real(2.2), Real(-1.1), Real(-4.4)},
          {Real(-1e3), Real(1e3), Real(1e-3), Real(-1e-3)}};
}

template <class Real>
ProjectiveRows<Real> perspective_matrix() {
  const AffineRows<Real> rows = general_matrix<Real>();
  return {rows.x, rows.y, rows.z, {0, 0, -1, Real(0.5)}};
}

template <class Real>
std::vector<AffineRows<Real>> make_palette(std::size_t count) {
  std::vector<AffineRows<Real>> palette;
  for (std::size_t i = 0; i < count; ++i) palette.push_back(turned<Real>(i));
  return palette;
}

template <class Real>
std::vector<ProjectiveRows<Real>> make_projective_palette(std::size_t count) {
  std::vector<ProjectiveRows<Real>> palette;
  for (const AffineRows<Real>& rows : make_palette<Real>(count))
    palette.push_back({rows.x, rows.y, rows.z, {0, rows.x[0] / 8, -1, Real(0.5)}});
  return palette;
}

std::vector<std::uint32_t> make_indices(std::size_t count, std::size_t matrix_count) {
  accuracy::Random random(count);
  std::vector<std::uint32_t> indices(count);
  for (auto& index : indices) index = static_cast<std::uint32_t>(random.bits() % matrix_count);
  return indices;
}

template <class Real>
Blend<Real> make_blend(std::size_t count, std::size_t matrix_count) {
  accuracy::Random random(count + 1);
  Blend<Real> blend;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<std::uint16_t, 4> matrices;
    for (auto& matrix : matrices) matrix = static_cast<std::uint16_t>(random.bits() % matrix_count);
    const auto a = static_cast<Real>(random.uniform(0, 1)), b = static_cast<Real>(random.uniform(0, 1) - 0.5);
    blend.matrices.push_back(matrices);
    blend.weights.push_back({a, b, 1 - a - b, i % 3 == 0 ? Real{0} : Real(0.125)});
  }
  return blend;
}

template <class Real>
void expect_same_bits(const Batch<Real>& actual, const Batch<Real>& expected, std::string_view what) {
  using Bits = std::conditional_t<std::is_same_v<Real, float>, std::uint32_t, std::uint64_t>;
  for (std::size_t array = 0; array < array_count(expected.layout); ++array) {
    const auto &results = actual.arrays[array], &references = expected.arrays[array];
    ASSERT_EQ(results.size(), references.size()) << what;
    for (std::size_t i = 0; i < results.size(); ++i) {
      if (std::isnan(results[i]) && std::isnan(references[i])) continue;
      ASSERT_EQ(std::bit_cast<Bits>(results[i]), std::bit_cast<Bits>(references[i]))
          << what << ", array " << array << ", element " << i << " of " << results.size() << ": " << results[i]
          << ", expected " << references[i];
    }
  }
}

#define FOR_REAL(Real)                                                               \
  template struct Batch<Real>;                                                       \
  template Batch<Real> make_batch(VertexLayout, std::size_t, Family, std::uint64_t); \
  template AffineRows<Real> general_matrix();                                        \
  template AffineRows<Real> cancelling_matrix();                                     \
  template ProjectiveRows<Real> perspective_matrix();                                \
  template std::vector<AffineRows<Real>> make_palette(std::size_t);                  \
  template std::vector<ProjectiveRows<Real>> make_projective_palette(std::size_t);   \
  template Blend<Real> make_blend(std::size_t, std::size_t);                         \
  template void expect_same_bits(const Batch<Real>&, const Batch<Real>&, std::string_view);
FOR_REAL(float)
FOR_REAL(double)

}  // namespace morphcl::testing
