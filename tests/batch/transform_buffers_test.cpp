// Parity: the device computes the bits of the reference, for every kind, layout, choice of matrices and precision.
#include "morphcl/opencl_interop.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "host/device/session_access.hpp"
#include "morphcl/batch.hpp"
#include "morphcl/error.hpp"
#include "tests/batch/device_run.hpp"
#include "tests/device/shared_session.hpp"

namespace morphcl {
namespace {

using testing::all_layouts;
using testing::Batch;
using testing::buffer_of;
using testing::buffers_of;
using testing::expect_same_bits;
using testing::Family;
using testing::general_matrix;
using ::testing::HasSubstr;
using testing::make_batch;
using testing::run_on_device;
using testing::shared_session;

template <class Real>
struct Kind {
  const char* name;
  Transform<Real> single, palette;
};

template <class Real>
std::vector<Kind<Real>> all_kinds(const AffineRows<Real>& rows) {
  static const auto affine = testing::make_palette<Real>(5);
  static const auto projective = testing::make_projective_palette<Real>(5);
  using T = Transform<Real>;
  const std::span<const AffineRows<Real>> palette(affine);
  return {{"points", T::points(rows), T::points(palette)},
          {"vectors", T::vectors(rows), T::vectors(palette)},
          {"normals", T::normals(rows), T::normals(palette)},
          {"project", T::project(testing::perspective_matrix<Real>()),
           T::project(std::span<const ProjectiveRows<Real>>(projective))}};
}

template <class Real>
void expect_parity(const Batch<Real>& in, const Kind<Real>& kind, const std::string& what) {
  const std::size_t count = in.size();
  const std::string name = fmt::format("{}, {}, {} vertices, {}", kind.name, name_of(in.layout), count, what);
  const auto indices = testing::make_indices(count, 5);
  const auto blend = testing::make_blend<Real>(count, 5);
  Batch<Real> expected(in.layout, count);
  transform_reference(kind.single, in.vertices(), expected.vertices());
  expect_same_bits(run_on_device(shared_session(), kind.single, in), expected, name);
  transform_reference(kind.palette, in.vertices(), expected.vertices(), MatrixIndices(indices));
  expect_same_bits(run_on_device(shared_session(), kind.palette, in, indices), expected, name + ", by index");
  if (kind.palette.kind() == TransformKind::normals) return;
  transform_reference(kind.palette, in.vertices(), expected.vertices(), MatrixBlend<Real>(blend));
  expect_same_bits(run_on_device(shared_session(), kind.palette, in, blend), expected, name + ", blended");
}

template <class Real>
class TransformParity : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(TransformParity, Precisions);

TYPED_TEST(TransformParity, EverySizeUpToThreeBlocks) {
  for (const VertexLayout layout : all_layouts)
    for (const auto& kind : all_kinds(general_matrix<TypeParam>()))
      for (std::size_t count = 0; count <= 49; ++count)
        expect_parity(make_batch<TypeParam>(layout, count, Family::benign, count), kind, "benign");
}

TYPED_TEST(TransformParity, SizesAroundOneAndSeveralWorkItems) {
  for (const VertexLayout layout : all_layouts)
    for (const auto& kind : all_kinds(general_matrix<TypeParam>()))
      for (const std::size_t count : {4095, 4096, 4097, 12305})
        expect_parity(make_batch<TypeParam>(layout, count, Family::wide, count), kind, "wide");
}

TYPED_TEST(TransformParity, CancellingRows) {
  for (const auto& kind : all_kinds(testing::cancelling_matrix<TypeParam>()))
    expect_parity(make_batch<TypeParam>(VertexLayout::xyz, 5000, Family::cancelling, 1), kind, "cancelling");
}

// Sums overflow, underflow and are NaN here.
TYPED_TEST(TransformParity, ZerosDenormalsTheLargestInfinitiesAndNaN) {
  using Limits = std::numeric_limits<TypeParam>;
  const TypeParam small = Limits::min(), large = Limits::max(), root = std::sqrt(Limits::max());
  const std::vector<TypeParam> values = {0,
                                         -TypeParam{0},
                                         Limits::denorm_min(),
                                         -Limits::denorm_min(),
                                         small / 2,
                                         small,
                                         -small * 1000,
                                         1 / root,
                                         1,
                                         -1,
                                         root,
                                         -root,
                                         large / 8,
                                         -large,
                                         large,
                                         Limits::infinity(),
                                         -Limits::infinity(),
                                         Limits::quiet_NaN()};
  const AffineRows<TypeParam> matrices[] = {
      {{TypeParam(0.5), TypeParam(-0.25), TypeParam(0.125), 0},
       {TypeParam(0.1), TypeParam(0.3), TypeParam(-0.5), Limits::denorm_min()},
       {TypeParam(-0.5), TypeParam(0.01), TypeParam(0.2), 1}},
      {{TypeParam(1e30), 0, TypeParam(-1e30), 1}, {0, TypeParam(1e-30), 0, 0}, {TypeParam(1e30), 1, 1, large}}};
  for (const VertexLayout layout : all_layouts) {
    Batch<TypeParam> in(layout, values.size() * values.size() * values.size());
    std::size_t vertex = 0;
    for (const TypeParam x : values)
      for (const TypeParam y : values)
        for (const TypeParam z : values) {
          in.at(vertex, 0) = x;
          in.at(vertex, 1) = y;
          in.at(vertex, 2) = z;
          ++vertex;
        }
    for (const auto& rows : matrices)
      for (const auto& kind : all_kinds(rows)) expect_parity(in, kind, "extremes");
  }
}

// Large batches bypass the cache; they end in a partial block, too.
TYPED_TEST(TransformParity, LargeBatchesInPlace) {
  constexpr std::size_t count = 400013;
  const auto transform = Transform<TypeParam>::points(general_matrix<TypeParam>());
  for (const VertexLayout layout : all_layouts) {
    const auto in = make_batch<TypeParam>(layout, count, Family::wide, 8);
    Batch<TypeParam> expected(layout, count);
    transform_reference(transform, in.vertices(), expected.vertices());
    const VertexBuffers both = buffers_of(shared_session(), in);
    enqueue_transform(shared_session(), transform, both, both, count);
    expect_same_bits(testing::read_back<TypeParam>(shared_session(), both, count), expected, name_of(layout));
  }
}

TYPED_TEST(TransformParity, AMissingMatrixMakesNaNOfItsVertexAloneAndIsReported) {
  constexpr std::size_t count = 40;
  const auto palette = testing::make_palette<TypeParam>(3);
  const auto transform = Transform<TypeParam>::points(std::span<const AffineRows<TypeParam>>(palette));
  auto indices = testing::make_indices(count, 3);
  auto blend = testing::make_blend<TypeParam>(count, 3);
  indices[17] = 3;
  indices[39] = 0xffffffff;
  blend.matrices[0][2] = 3;
  for (const VertexLayout layout : all_layouts) {
    const auto in = make_batch<TypeParam>(layout, count, Family::benign, 9);
    const auto check = [&](const auto& choice, std::vector<std::size_t> bad, const MatrixChoice<TypeParam>& same) {
      const VertexBuffers both = buffers_of(shared_session(), in);
      const cl::Buffer bad_index = buffer_of(shared_session(), std::vector<cl_uint>{0});
      enqueue_transform(shared_session(), transform, both, both, count,
                        testing::choice_buffers(shared_session(), choice), bad_index);
      const auto results = testing::read_back<TypeParam>(shared_session(), both, count);
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
          EXPECT_EQ(std::isnan(results.at(i, axis)), std::count(bad.begin(), bad.end(), i) > 0) << i;
      cl_uint found = 0;
      queue_of(shared_session()).enqueueReadBuffer(bad_index, CL_TRUE, 0, sizeof found, &found);
      EXPECT_EQ(found, 1u);
      Batch<TypeParam> expected(layout, count);
      transform_reference(transform, in.vertices(), expected.vertices(), same);
      expect_same_bits(results, expected, name_of(layout));
    };
    check(indices, {17, 39}, MatrixIndices(indices));
    check(blend, {0}, MatrixBlend<TypeParam>(blend));
  }
}

void expect_error(ErrorKind kind, const std::function<void()>& call, const std::string& text) {
  try {
    call();
    ADD_FAILURE() << "accepted; expected: " << text;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind);
    EXPECT_THAT(error.what(), HasSubstr(text));
  }
}

TEST(TransformBuffers, RefusesBuffersThatAreTooSmall) {
  Session& session = shared_session();
  const auto palette = testing::make_palette<float>(2);
  const auto transform = Transform<float>::points(std::span<const AffineRows<float>>(palette));
  const VertexBuffers ten = buffers_of(session, Batch<float>(VertexLayout::xyz, 10));
  const VertexBuffers nine = buffers_of(session, Batch<float>(VertexLayout::xyz, 9));
  const ChoiceBuffers indices = IndexBuffer{buffer_of(session, std::vector<std::uint32_t>(10))};
  const auto refused = [&](const VertexBuffers& in, const VertexBuffers& out, const ChoiceBuffers& choice,
                           const std::string& text) {
    expect_error(ErrorKind::usage, [&] { enqueue_transform(session, transform, in, out, 10, choice); }, text);
  };
  refused(nine, ten, indices, "108 bytes for the vertices; at least 120");
  refused(ten, nine, indices, "108 bytes for the results; at least 120");
  refused(ten, {VertexLayout::xyz, {}}, indices, "0 bytes for the results");
  refused(ten, ten, IndexBuffer{buffer_of(session, std::vector<std::uint32_t>(9))}, "36 bytes for the matrix indices");
  refused(ten, ten, {}, "no choice among them");
  refused(ten, buffers_of(session, Batch<float>(VertexLayout::separate, 10)), indices,
          "the input is xyz and the output separate");
  enqueue_transform(session, transform, ten, ten, 10, indices);
  queue_of(session).finish();
}

TEST(TransformBuffers, NormalsAreNotBlended) {
  Session& session = shared_session();
  const VertexBuffers both = buffers_of(session, Batch<float>(VertexLayout::xyz, 10));
  const auto blend = testing::choice_buffers(session, testing::make_blend<float>(10, 1));
  expect_error(
      ErrorKind::usage,
      [&] { enqueue_transform(session, Transform<float>::normals(general_matrix<float>()), both, both, 10, blend); },
      "normals cannot be blended");
}

TEST(TransformBuffers, DoublesNeedADeviceThatHasThem) {
  DeviceInfo device;
  device.name = "small one";
  expect_error(
      ErrorKind::no_device, [&] { check_precision<double>(device); },
      "device \"small one\" does not compute in double precision");
  check_precision<float>(device);
  device.fp64 = true;
  check_precision<double>(device);
}

}  // namespace
}  // namespace morphcl
