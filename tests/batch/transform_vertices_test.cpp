// Batch transforms in the host's memory: the bits of the reference, and nothing touched but what was given.
#include "morphcl/batch.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "morphcl/error.hpp"
#include "tests/batch/test_batch.hpp"
#include "tests/device/shared_session.hpp"

namespace morphcl {
namespace {

using testing::all_layouts;
using testing::Batch;
using testing::expect_same_bits;
using testing::Family;
using testing::general_matrix;
using ::testing::HasSubstr;
using testing::make_batch;
using testing::shared_session;

constexpr std::size_t many = 100003;  // the device does these
constexpr std::size_t past_the_cache = 400013;

template <class Real>
std::vector<std::pair<const char*, Transform<Real>>> all_kinds() {
  const auto rows = general_matrix<Real>();
  return {{"points", Transform<Real>::points(rows)},
          {"vectors", Transform<Real>::vectors(rows)},
          {"normals", Transform<Real>::normals(rows)},
          {"project", Transform<Real>::project(testing::perspective_matrix<Real>())}};
}

template <class Real>
class TransformVertices : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(TransformVertices, Precisions);

TYPED_TEST(TransformVertices, FromNoneToManyVertices) {
  for (const VertexLayout layout : all_layouts)
    for (const auto& [name, transform] : all_kinds<TypeParam>())
      for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{17}, std::size_t{1000}, many}) {
        const auto in = make_batch<TypeParam>(layout, count, Family::wide, count);
        Batch<TypeParam> out(layout, count), expected(layout, count);
        transform_vertices(shared_session(), transform, in.vertices(), out.vertices());
        transform_reference(transform, in.vertices(), expected.vertices());
        expect_same_bits(out, expected, fmt::format("{}, {}, {} vertices", name, name_of(layout), count));
      }
}

TYPED_TEST(TransformVertices, InPlace) {
  for (const VertexLayout layout : all_layouts)
    for (const auto& [name, transform] : all_kinds<TypeParam>()) {
      const auto in = make_batch<TypeParam>(layout, past_the_cache, Family::benign, 5);
      Batch<TypeParam> both = in, expected(layout, past_the_cache);
      transform_vertices(shared_session(), transform, both.vertices(), both.vertices());
      transform_reference(transform, in.vertices(), expected.vertices());
      expect_same_bits(both, expected, fmt::format("{}, {}", name, name_of(layout)));
    }
}

TYPED_TEST(TransformVertices, InPlaceWithAxesExchanged) {
  const auto in = make_batch<TypeParam>(VertexLayout::separate, many, Family::benign, 6);
  const auto exchanged = [](auto& batch) {
    using Real = std::remove_reference_t<decltype(batch.arrays[0][0])>;
    return Vertices<Real>::separate(batch.arrays[1], batch.arrays[2], batch.arrays[0]);
  };
  for (const auto& [name, transform] : all_kinds<TypeParam>()) {
    Batch<TypeParam> both = in, expected(VertexLayout::separate, many);
    transform_vertices(shared_session(), transform, exchanged(both), both.vertices());
    transform_reference(transform, exchanged(in), expected.vertices());
    expect_same_bits(both, expected, name);
  }
}

// Results at every offset from a cache line, with guards before and behind that must keep their value; with and without
// the parts that lie in front of the first line.
TYPED_TEST(TransformVertices, UnalignedArraysAndNothingBesideThem) {
  constexpr TypeParam guard = 12345;
  for (const VertexLayout layout : all_layouts)
    for (const std::size_t count : {std::size_t{9001}, past_the_cache})
      for (std::size_t offset = 0; offset < 16; offset += count == past_the_cache ? 3 : 1) {
        const auto in = make_batch<TypeParam>(layout, count, Family::benign, 7);
        const std::size_t reals = count * reals_per_vertex(layout);
        const auto run = [&](auto transform_into) {
          Batch<TypeParam> padded(layout, 0);
          for (std::size_t i = 0; i < array_count(layout); ++i) padded.arrays[i].assign(offset + reals + 16, guard);
          const auto span = [&](std::size_t i) { return std::span(padded.arrays[i]).subspan(offset, reals); };
          if (layout == VertexLayout::separate)
            transform_into(Vertices<TypeParam>::separate(span(0), span(1), span(2)));
          else
            transform_into(layout == VertexLayout::xyz ? Vertices<TypeParam>::xyz(span(0))
                                                       : Vertices<TypeParam>::xyzw(span(0)));
          return padded;
        };
        const auto transform = Transform<TypeParam>::points(general_matrix<TypeParam>());
        const auto padded =
            run([&](const auto& out) { transform_vertices(shared_session(), transform, in.vertices(), out); });
        const auto expected = run([&](const auto& out) { transform_reference(transform, in.vertices(), out); });
        expect_same_bits(padded, expected, fmt::format("{} at offset {}", name_of(layout), offset));
      }
}

TYPED_TEST(TransformVertices, PalettesAndBlends) {
  const auto affine = testing::make_palette<TypeParam>(7);
  const auto transform = Transform<TypeParam>::points(std::span<const AffineRows<TypeParam>>(affine));
  for (const VertexLayout layout : all_layouts)
    for (const std::size_t count : {std::size_t{100}, past_the_cache}) {
      const auto in = make_batch<TypeParam>(layout, count, Family::benign, 7);
      const auto indices = testing::make_indices(count, 7);
      const auto blend = testing::make_blend<TypeParam>(count, 7);
      for (const MatrixChoice<TypeParam>& choice :
           {MatrixChoice<TypeParam>(MatrixIndices(indices)), MatrixChoice<TypeParam>(MatrixBlend<TypeParam>(blend))}) {
        Batch<TypeParam> out(layout, count), expected(layout, count);
        transform_vertices(shared_session(), transform, in.vertices(), out.vertices(), choice);
        transform_reference(transform, in.vertices(), expected.vertices(), choice);
        expect_same_bits(out, expected, fmt::format("{}, {} vertices", name_of(layout), count));
      }
    }
}

TYPED_TEST(TransformVertices, AMissingMatrixIsNamedAndItsVertexIsNaN) {
  const auto palette = testing::make_palette<TypeParam>(3);
  const auto transform = Transform<TypeParam>::points(std::span<const AffineRows<TypeParam>>(palette));
  // Done by the host, in front of the first cache line, and by the device.
  for (const auto& [count, bad] : {std::pair{std::size_t{100}, std::size_t{99}}, {many, 0}, {many, many - 2}}) {
    auto indices = testing::make_indices(count, 3);
    indices[bad] = 3;
    const auto in = make_batch<TypeParam>(VertexLayout::xyzw, count, Family::benign, 7);
    Batch<TypeParam> out(VertexLayout::xyzw, count), expected(VertexLayout::xyzw, count);
    transform_reference(transform, in.vertices(), expected.vertices(), MatrixIndices(indices));
    try {
      transform_vertices(shared_session(), transform, in.vertices(), out.vertices(), MatrixIndices(indices));
      ADD_FAILURE() << "a missing matrix was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_THAT(error.what(), HasSubstr(fmt::format("vertex {} asks for matrix 3, but there are 3", bad)));
    }
    EXPECT_TRUE(std::isnan(out.at(bad, 0)));
    expect_same_bits(out, expected, fmt::format("{} vertices", count));
  }
}

TEST(TransformVerticesErrors, SizesLayoutsAndOverlapAreChecked) {
  const auto transform = Transform<float>::points(general_matrix<float>());
  Batch<float> in(VertexLayout::xyz, 32), shorter(VertexLayout::xyz, 31), other(VertexLayout::xyzw, 32);
  const auto refused = [&](const Vertices<const float>& from, const Vertices<float>& to, const char* what) {
    EXPECT_THROW(transform_vertices(shared_session(), transform, from, to), Error) << what;
    EXPECT_THROW(transform_reference(transform, from, to), Error) << what;
  };
  refused(in.vertices(), shorter.vertices(), "a shorter output");
  refused(in.vertices(), other.vertices(), "another layout");
  refused(in.vertices().part(0, 16), in.vertices().part(8, 16), "an output that begins inside the input");
}

TEST(ProjectPoints, PointsAtOrBehindTheEyeHaveNoImage) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const ProjectiveRows<float> projection{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, -1, 0}};  // w = -z
  Batch<float> in(VertexLayout::xyz, 5), out(VertexLayout::xyz, 5);
  in.arrays[0] = {6, 2, -2, 6, 2, 0, 6, 2, -0.0f, 6, 2, 2, 6, 2, std::nanf("")};
  transform_vertices(shared_session(), Transform<float>::project(projection), in.vertices(), out.vertices());
  std::vector<float> expected(15, infinity);
  expected[0] = 3;
  expected[1] = 1;
  expected[2] = -1;
  EXPECT_EQ(out.arrays[0], expected);
}

TEST(TransformNormals, LengthsFromDenormalToNearOverflowAndZero) {
  const std::vector<float> scales = {0x1p-149f, 1e-40f, 1e-23f, 1.0f, 1e20f, 0x1p126f, 0};
  Batch<float> in(VertexLayout::xyz, scales.size()), out(VertexLayout::xyz, scales.size(), -7);
  for (std::size_t i = 0; i < scales.size(); ++i) in.at(i, 1) = -scales[i];
  const AffineRows<float> rows{{2, 0, 0, 5}, {0, 1e-12f, 0, 5}, {0, 0, 3, 5}};
  transform_vertices(shared_session(), Transform<float>::normals(rows), in.vertices(), out.vertices());
  for (std::size_t i = 0; i < scales.size(); ++i) {
    EXPECT_EQ(out.at(i, 0), 0) << "length " << scales[i];
    EXPECT_EQ(out.at(i, 1), scales[i] > 0 ? -1 : 0) << "length " << scales[i];
    EXPECT_EQ(out.at(i, 2), 0) << "length " << scales[i];
  }
}

}  // namespace
}  // namespace morphcl
