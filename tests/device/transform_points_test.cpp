// Parity: the device computes the bits of the reference, and touches nothing but what it was given.
#include "host/device/transform_points.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <limits>
#include <memory>

#include "host/device/transform_points_reference.hpp"
#include "host/error.hpp"
#include "tests/device/shared_session.hpp"
#include "tests/device/test_points.hpp"

namespace morphcl {
namespace {

using testing::Family;
using testing::general_matrix;
using testing::make_points;
using testing::perspective_matrix;
using testing::Points;
using testing::shared_session;

struct Operation {
  const char* name;
  std::function<void(const ConstPointArrays&, const PointArrays&)> device, reference;
};

std::vector<Operation> operations(const AffineRows& rows) {
  const ProjectiveRows projection = perspective_matrix();
  Session& session = shared_session();
  return {
      {"transform_points", [&, rows](const auto& in, const auto& out) { transform_points(session, rows, in, out); },
       [rows](const auto& in, const auto& out) { transform_points_reference(rows, in, out); }},
      {"project_points",
       [&, projection](const auto& in, const auto& out) { project_points(session, projection, in, out); },
       [projection](const auto& in, const auto& out) { project_points_reference(projection, in, out); }},
      {"transform_vectors", [&, rows](const auto& in, const auto& out) { transform_vectors(session, rows, in, out); },
       [rows](const auto& in, const auto& out) { transform_vectors_reference(rows, in, out); }},
      {"transform_normals", [&, rows](const auto& in, const auto& out) { transform_normals(session, rows, in, out); },
       [rows](const auto& in, const auto& out) { transform_normals_reference(rows, in, out); }}};
}

void expect_same_bits(std::span<const float> actual, std::span<const float> expected, const std::string& what) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i)
    ASSERT_EQ(std::bit_cast<std::uint32_t>(actual[i]), std::bit_cast<std::uint32_t>(expected[i]))
        << what << ", element " << i << " of " << actual.size() << ": device " << actual[i] << ", reference "
        << expected[i];
}

void expect_same_points(const Points& actual, const Points& expected, const std::string& what) {
  expect_same_bits(actual.x, expected.x, what + " x");
  expect_same_bits(actual.y, expected.y, what + " y");
  expect_same_bits(actual.z, expected.z, what + " z");
}

void expect_parity(const Points& in, const AffineRows& rows, const std::string& what) {
  for (const Operation& operation : operations(rows)) {
    Points device(in.x.size()), reference(in.x.size());
    operation.device(in.arrays(), device.arrays());
    operation.reference(in.arrays(), reference.arrays());
    expect_same_points(device, reference, fmt::format("{}, {}", operation.name, what));
  }
}

TEST(TransformPoints, EverySizeUpToFourBlocks) {
  for (std::size_t count = 0; count <= 65; ++count)
    expect_parity(make_points(count, Family::benign, count), general_matrix(), fmt::format("{} points", count));
}

TEST(TransformPoints, SizesAroundOneAndSeveralWorkItems) {
  for (const std::size_t count : {4095, 4096, 4097, 8191, 12305, 100003})
    expect_parity(make_points(count, Family::wide, count), general_matrix(), fmt::format("{} points", count));
}

TEST(TransformPoints, CancellingRows) {
  expect_parity(make_points(5000, Family::cancelling, 1), testing::cancelling_matrix(), "cancelling");
}

TEST(TransformPoints, ZerosDenormalsAndTheLargestFloats) {
  const std::vector<float> values = {0.0f,   -0.0f, 0x1p-149f, -0x1p-149f, 0x1.fffffcp-127f, 0x1p-126f, -0x1.8p-100f,
                                     1e-23f, 1.0f,  -1.0f,     1e20f,      -1e20f,           0x1p100f,  -0x1p125f};
  Points in(0);
  for (const float x : values)
    for (const float y : values)
      for (const float z : values) in.x.push_back(x), in.y.push_back(y), in.z.push_back(z);
  // Entries of at most 1/2, so that no sum overflows and no bits are promised for infinities.
  expect_parity(in, {{0.5f, -0.25f, 0.125f, 0}, {0.1f, 0.3f, -0.5f, 0x1p-149f}, {-0.5f, 0.01f, 0.2f, 1.0f}},
                "extremes");
}

TEST(TransformPoints, InPlace) {
  for (const Operation& operation : operations(general_matrix())) {
    const Points in = make_points(10007, Family::benign, 5);
    Points both = in, reference(in.x.size());
    operation.device(both.arrays(), both.arrays());
    operation.reference(in.arrays(), reference.arrays());
    expect_same_points(both, reference, operation.name);
  }
}

TEST(TransformPoints, InPlaceWithAxesExchanged) {
  const Points in = make_points(4111, Family::benign, 6);
  for (const Operation& operation : operations(general_matrix())) {
    Points both = in, reference(in.x.size());
    operation.device(ConstPointArrays{both.y, both.z, both.x}, both.arrays());
    operation.reference(ConstPointArrays{in.y, in.z, in.x}, reference.arrays());
    expect_same_points(both, reference, operation.name);
  }
}

// Arrays at every offset from a cache line, with guards before and behind that must keep their value.
TEST(TransformPoints, UnalignedArraysAndNothingBesideThem) {
  constexpr float guard = 12345.0f;
  constexpr std::size_t count = 1003;
  const Points in = make_points(count, Family::benign, 7);
  for (const Operation& operation : operations(general_matrix()))
    for (std::size_t offset = 1; offset <= 16; ++offset) {
      Points padded(offset + count + 16, guard);
      const auto part = [&](std::vector<float>& values) { return std::span(values).subspan(offset, count); };
      operation.device(in.arrays(), {part(padded.x), part(padded.y), part(padded.z)});
      Points expected(offset + count + 16, guard);
      operation.reference(in.arrays(), {part(expected.x), part(expected.y), part(expected.z)});
      expect_same_points(padded, expected, fmt::format("{} at offset {}", operation.name, offset));
    }
}

struct Free {
  void operator()(float* values) const { std::free(values); }
};
using AlignedArray = std::unique_ptr<float[], Free>;

AlignedArray make_aligned(std::size_t count) {
  return AlignedArray(static_cast<float*>(std::aligned_alloc(64, (count * sizeof(float) + 63) / 64 * 64)));
}

// Large aligned batches are stored past the cache; they end in a partial block, too.
TEST(TransformPoints, LargeAlignedBatches) {
  constexpr std::size_t count = 400013;  // 9.6 MB in and out
  const Points in = make_points(count, Family::wide, 8);
  const AlignedArray x = make_aligned(count), y = make_aligned(count), z = make_aligned(count);
  for (const Operation& operation : operations(general_matrix())) {
    operation.device(in.arrays(), {{x.get(), count}, {y.get(), count}, {z.get(), count}});
    Points reference(count);
    operation.reference(in.arrays(), reference.arrays());
    expect_same_bits({x.get(), count}, reference.x, operation.name);
    expect_same_bits({y.get(), count}, reference.y, operation.name);
    expect_same_bits({z.get(), count}, reference.z, operation.name);
  }
}

TEST(ProjectPoints, PointsAtOrBehindTheEyeHaveNoImage) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const ProjectiveRows projection{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, -1, 0}};  // w = -z
  Points in(4), out(4);
  in.x = {6, 6, 6, 6};
  in.y = {2, 2, 2, 2};
  in.z = {-2, 0, -0.0f, 2};
  project_points(shared_session(), projection, in.arrays(), out.arrays());
  EXPECT_EQ(out.x, (std::vector<float>{3, infinity, infinity, infinity}));
  EXPECT_EQ(out.y, (std::vector<float>{1, infinity, infinity, infinity}));
  EXPECT_EQ(out.z, (std::vector<float>{-1, infinity, infinity, infinity}));
}

TEST(TransformNormals, LengthsFromDenormalToNearOverflowAndZero) {
  const std::vector<float> scales = {0x1p-149f, 1e-40f, 1e-23f, 1.0f, 1e20f, 0x1p126f};
  Points in(0);
  for (const float scale : scales) {
    in.x.push_back(0);
    in.y.push_back(-scale);
    in.z.push_back(0);
  }
  in.x.push_back(0), in.y.push_back(0), in.z.push_back(0);
  Points out(in.x.size(), -7.0f);
  transform_normals(shared_session(), {{2, 0, 0, 5}, {0, 1e-12f, 0, 5}, {0, 0, 3, 5}}, in.arrays(), out.arrays());
  for (std::size_t i = 0; i < scales.size(); ++i) {
    EXPECT_EQ(out.x[i], 0) << "length " << scales[i];
    EXPECT_EQ(out.y[i], -1) << "length " << scales[i];
    EXPECT_EQ(out.z[i], 0) << "length " << scales[i];
  }
  EXPECT_EQ(out.x.back(), 0);
  EXPECT_EQ(out.y.back(), 0);
  EXPECT_EQ(out.z.back(), 0);
}

void expect_usage_error(const ConstPointArrays& in, const PointArrays& out, const char* what) {
  try {
    transform_points(shared_session(), general_matrix(), in, out);
    ADD_FAILURE() << what << " was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage) << error.what();
  }
}

TEST(TransformPoints, RefusesSizesThatDifferAndArraysThatOverlap) {
  Points in(32), out(32), shorter(31);
  expect_usage_error({in.x, in.y, shorter.z}, out.arrays(), "a shorter input");
  expect_usage_error(in.arrays(), {out.x, shorter.y, out.z}, "a shorter output");
  expect_usage_error(in.arrays(), {out.x, out.x, out.z}, "one output twice");
  const auto part = [](std::vector<float>& values, std::size_t first) { return std::span(values).subspan(first, 16); };
  expect_usage_error({part(in.x, 0), part(in.y, 0), part(in.z, 0)}, {part(out.x, 0), part(out.x, 8), part(out.z, 0)},
                     "outputs that overlap");
  expect_usage_error({part(in.x, 0), part(in.y, 0), part(in.z, 0)}, {part(in.x, 1), part(out.y, 0), part(out.z, 0)},
                     "an output that begins inside an input");
}

}  // namespace
}  // namespace morphcl
