// What a Transform holds, and which choices fit it.
#include "host/batch/transform.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "morphcl/batch.hpp"
#include "morphcl/error.hpp"
#include "tests/batch/expect_usage_error.hpp"
#include "tests/batch/test_batch.hpp"

namespace morphcl {
namespace {

using testing::Batch;
using testing::expect_usage_error;
using testing::general_matrix;
using testing::make_blend;
using testing::make_palette;

Transform<float> palette_of(std::size_t count) {
  return Transform<float>::points(std::span<const AffineRows<float>>(make_palette<float>(count)));
}

TEST(Transform, HoldsThreeRowsAMatrixAndFourOfProjections) {
  EXPECT_EQ(palette_of(5).rows().size(), 15u);
  EXPECT_EQ(palette_of(5).matrix_count(), 5u);
  const auto projection = Transform<double>::project(testing::perspective_matrix<double>());
  EXPECT_EQ(projection.rows().size(), 4u);
  EXPECT_EQ(projection.matrix_count(), 1u);
}

TEST(Transform, RefusesAnEmptyPalette) {
  expect_usage_error([] { Transform<float>::points(std::span<const AffineRows<float>>()); }, "0 matrices");
}

TEST(Transform, RefusesNormalsOfInfiniteMatrices) {
  AffineRows<double> rows;
  rows.y[1] = INFINITY;
  expect_usage_error([&] { Transform<double>::normals(rows); }, "finite");
}

// The identity keeps even -0, which a translation of +0 would turn into +0.
TEST(Transform, VectorsAreNotTranslatedAndKeepTheSignOfZero) {
  const AffineRows<float> rows{{1, 0, 0, 7}, {0, 1, 0, 8}, {0, 0, 1, 9}};
  Batch<float> in(VertexLayout::xyz, 1), out(VertexLayout::xyz, 1);
  in.arrays[0] = {-0.0f, -0.0f, -0.0f};
  transform_reference(Transform<float>::vectors(rows), in.vertices(), out.vertices());
  for (const float coordinate : out.arrays[0]) EXPECT_TRUE(coordinate == 0 && std::signbit(coordinate)) << coordinate;
  transform_reference(Transform<float>::points(rows), in.vertices(), out.vertices());
  EXPECT_EQ(out.arrays[0], (std::vector<float>{7, 8, 9}));
}

TEST(MatrixChoice, OneIsNeededAmongSeveralMatrices) {
  expect_usage_error([] { check_choice<float>(palette_of(2), {}, 10); }, "2 matrices and no choice");
  check_choice<float>(palette_of(1), {}, 10);
}

TEST(MatrixChoice, HasOneEntryAVertex) {
  const std::vector<std::uint32_t> indices(9);
  expect_usage_error([&] { check_choice<float>(palette_of(2), MatrixIndices(indices), 10); },
                     "9 matrix indices for 10 vertices");
  auto blend = make_blend<float>(10, 2);
  check_choice<float>(palette_of(2), MatrixBlend<float>(blend), 10);
  blend.weights.pop_back();
  expect_usage_error([&] { check_choice<float>(palette_of(2), MatrixBlend<float>(blend), 10); },
                     "10 quadruples of matrices and 9 of weights for 10 vertices");
}

TEST(MatrixChoice, NormalsAreNotBlended) {
  const auto blend = make_blend<float>(10, 1);
  expect_usage_error(
      [&] { check_choice<float>(Transform<float>::normals(general_matrix<float>()), MatrixBlend<float>(blend), 10); },
      "normals cannot be blended");
}

TEST(MatrixChoice, TheFirstMatrixThatIsMissingIsNamed) {
  std::vector<std::uint32_t> indices = {0, 1, 2, 3, 0xffffffff};
  expect_usage_error([&] { check_indices<float>(palette_of(3), MatrixIndices(indices)); },
                     "vertex 3 asks for matrix 3, but there are 3");
  check_indices<float>(palette_of(4), MatrixIndices(std::span(indices).first(4)));
  auto blend = make_blend<float>(10, 3);
  check_indices<float>(palette_of(3), MatrixBlend<float>(blend));
  blend.matrices[8][3] = 65535;
  expect_usage_error([&] { check_indices<float>(palette_of(3), MatrixBlend<float>(blend)); },
                     "vertex 8 asks for matrix 65535");
}

TEST(MatrixChoice, PartsStartWhereTheyAreToldTo) {
  const std::vector<std::uint32_t> indices = {5, 6, 7, 8};
  const auto middle = std::get<MatrixIndices>(part<float>(MatrixIndices(indices), 1, 2));
  EXPECT_EQ(std::vector(middle.begin(), middle.end()), (std::vector<std::uint32_t>{6, 7}));
  const auto blend = make_blend<float>(4, 3);
  const auto last = std::get<MatrixBlend<float>>(part<float>(MatrixBlend<float>(blend), 3, 1));
  EXPECT_EQ(last.matrices[0], blend.matrices[3]);
  EXPECT_EQ(last.weights[0], blend.weights[3]);
}

}  // namespace
}  // namespace morphcl
