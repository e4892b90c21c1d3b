// Input for the batch transforms, from fixed sequences, and memory for their results.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host/batch/transform.hpp"
#include "host/batch/vertices.hpp"

namespace morphcl::testing {

// Vertices that own their memory: one array in records, or the first three as coordinates.
template <class Real>
struct Batch {
  VertexLayout layout;
  std::vector<Real> arrays[3];

  Batch(VertexLayout chosen, std::size_t count, Real value = 0);

  Vertices<Real> vertices();
  Vertices<const Real> vertices() const;
  Real& at(std::size_t vertex, std::size_t axis);  // axis 3: w of xyzw
  Real at(std::size_t vertex, std::size_t axis) const;
  std::size_t size() const { return arrays[0].size() / reals_per_vertex(layout); }
};

constexpr VertexLayout all_layouts[] = {VertexLayout::separate, VertexLayout::xyz, VertexLayout::xyzw};

enum class Family {
  benign,     // coordinates in [-1, 1]
  wide,       // magnitudes from 2^-20 to 2^20
  cancelling  // coordinates close to 1, for matrices whose rows nearly cancel there
};

template <class Real>
Batch<Real> make_batch(VertexLayout layout, std::size_t count, Family family, std::uint64_t seed);

// A rotation by no round angle with unequal scales, mirrored, and a translation.
template <class Real>
AffineRows<Real> general_matrix();
// Rows whose sums at (1, 1, 1) are lost but for the last places.
template <class Real>
AffineRows<Real> cancelling_matrix();
// general_matrix() with w = 1/2 - z: about half of the benign points lie behind the eye.
template <class Real>
ProjectiveRows<Real> perspective_matrix();

// `count` matrices, each unlike the others; the first is general_matrix().
template <class Real>
std::vector<AffineRows<Real>> make_palette(std::size_t count);
template <class Real>
std::vector<ProjectiveRows<Real>> make_projective_palette(std::size_t count);

// Choices for `count` vertices among `matrix_count` matrices.
std::vector<std::uint32_t> make_indices(std::size_t count, std::size_t matrix_count);
template <class Real>
struct Blend {
  std::vector<std::array<std::uint16_t, 4>> matrices;
  std::vector<std::array<Real, 4>> weights;  // some 0, some negative; sums near 1
  operator MatrixBlend<Real>() const { return {matrices, weights}; }
};
template <class Real>
Blend<Real> make_blend(std::size_t count, std::size_t matrix_count);

// Adds a test failure at the first number whose bits differ; any NaN equals any other.
template <class Real>
void expect_same_bits(const Batch<Real>& actual, const Batch<Real>& expected, std::string_view what);

}  // namespace morphcl::testing
