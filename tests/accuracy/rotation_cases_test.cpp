// Catalogue of extreme cases: axes, pivots and angles.
#include <boost/math/constants/constants.hpp>
#include <functional>

#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/rotation.hpp"
#include "morphcl/track.hpp"
#include "morphcl/transform.hpp"
#include "tests/accuracy/demand.hpp"
#include "tests/accuracy/exact_value.hpp"
#include "tests/accuracy/naive_forms.hpp"
#include "tests/math/reference.hpp"
#include "tests/support/random.hpp"

namespace morphcl::accuracy {
namespace {

using test_support::Random;

const Real pi = boost::math::constants::pi<Real>();
double to_degrees(float radians) { return static_cast<double>(Real(Real(radians) * 180 / pi)); }

using RotationForm = std::function<glm::mat3(const glm::vec3& axis, double degrees)>;

Worst rotation_error(const RotationForm& form, const std::vector<glm::vec3>& axes) {
  Worst worst;
  for (const glm::vec3& axis : axes)
    for (const double degrees : {40.0, -153.75, 0.001}) {
      const glm::mat3 m = form(axis, degrees);
      const auto rows = reference::rotation_about_line({0, 0, 0}, axis, degrees);
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) worst.add(m[c][r], exact(rows[r][c]), u32);
    }
  return worst;
}

glm::mat3 stable_rotation(const glm::vec3& axis, double degrees) {
  return to_fp32(axis_rotation(axis, degrees).matrix);
}
glm::mat3 naive_rotation(const glm::vec3& axis, double degrees) {
  return naive::rotation_in_steps(axis, static_cast<float>(degrees * 0.017453292519943295));
}

TEST(ExtremeCase, AxisParallelToX) {
  std::vector<glm::vec3> axes = {{1, 0, 0}, {-1, 0, 0}, {1, 1e-24f, 1e-24f}, {1, 1e-22f, 1e-22f}, {1, 1e-20f, 1e-20f}};
  expect_demand(rotation_error(stable_rotation, axes), rotation_error(naive_rotation, axes));
}

TEST(ExtremeCase, AxisTinyOrHuge) {
  const std::vector<glm::vec3> axes = {{1e-30f, 2e-30f, -1e-30f}, {1e30f, 2e30f, 3e30f}, {1e-40f, 0, 1e-40f}};
  expect_demand(rotation_error(stable_rotation, axes), rotation_error(naive_rotation, axes));
}

TEST(ExtremeCase, AxisInAnyDirection) {
  Random random(1);
  std::vector<glm::vec3> axes;
  for (int i = 0; i < 3000; ++i)
    axes.push_back({random.float_in(-1, 1), random.float_in(-1, 1), random.float_in(-1, 1)});
  expect_demand(rotation_error(stable_rotation, axes), rotation_error(naive_rotation, axes));
}

TEST(ExtremeCase, ZeroAxisIsAnError) {
  CompositeTransform transform;
  EXPECT_THROW(transform.rotate_about_axis({1, 2, 3}, {1, 2, 3}, 30), Error);
  EXPECT_TRUE(std::isnan(naive::rotation_in_steps({0, 0, 0}, 0.5f)[0][0]));
}

// The matrix composed in fp64 and rounded once: half an ulp of each entry, and what fp64 loses at the pivot's size.
TEST(ExtremeCase, PivotFarAway) {
  Worst stable, naive_form;
  for (const double pivot : {1e3, 1e4, 1e6})
    for (const float radians : {0.7f, 2.5f, 1e-3f}) {
      const double degrees = to_degrees(radians);
      const glm::dvec3 from(pivot, -0.5 * pivot, 0), to = from + glm::dvec3(0, 0, 1);
      const auto rows = reference::rotation_about_line(from, to, degrees);
      const glm::mat4 m = to_fp32(rotation_about_line(from, {0, 0, 1}, degrees));
      const glm::mat4 n = naive::rotation_about_pivot(glm::vec3(from), radians);
      for (int r = 0; r < 2; ++r) {
        const Real shift = exact(rows[r][3]);
        const double bound = 0.5 * ulp32(shift) + 8 * u64 * pivot;
        stable.add(m[3][r], shift, bound);
        naive_form.add(n[3][r], shift, bound);
      }
    }
  expect_demand(stable, naive_form);
}

TEST(ExtremeCase, TinyAngle) {
  Worst stable, naive_form;
  for (const float radians : {1e-4f, 1e-6f, 3e-3f, 1e-2f, 1e-12f}) {
    const double degrees = to_degrees(radians);
    const Real half = sin(Real(degrees) * pi / 360), versine = 2 * half * half;
    // The entry in the plane of the turn of I - R.
    stable.add(axis_rotation({0, 0, 1}, degrees).identity_minus[0][0], versine, 2 * ulp64(versine));
    naive_form.add(naive::one_minus_cosine(radians), 1 - cos(Real(radians)), 2 * ulp32(1 - cos(Real(radians))));
  }
  expect_demand(stable, naive_form);
}

TEST(ExtremeCase, RightAngles) {
  Worst stable, naive_form;
  const int cosines[] = {1, 0, -1, 0}, sines[] = {0, 1, 0, -1};
  for (int quarter = -40; quarter <= 40; ++quarter) {
    const int turn = ((quarter % 4) + 4) % 4;
    const glm::dmat3 m = axis_rotation({0, 0, 1}, 90.0 * quarter).matrix;
    const glm::mat3 n = naive::right_angle_rotation(quarter);
    stable.add_exact(m[0][0] == cosines[turn] && m[0][1] == sines[turn] && m[1][0] == -sines[turn] &&
                     m[1][1] == cosines[turn] && m[2] == glm::dvec3(0, 0, 1));
    naive_form.add_exact(n[0][0] == static_cast<float>(cosines[turn]) && n[0][1] == static_cast<float>(sines[turn]));
  }
  for (int eighth = 1; eighth < 16; eighth += 2) {
    const SinCos diagonal = sin_cos_degrees(45.0 * eighth);
    stable.add_exact(std::abs(diagonal.sin) == std::sqrt(0.5) && std::abs(diagonal.cos) == std::sqrt(0.5));
  }
  expect_demand(stable, naive_form);
}

TEST(ExtremeCase, HugeAngle) {
  Worst stable, naive_form;
  for (const float radians : {1e4f, 1e6f, 1e8f, 123456792.f, 1e12f, 1e15f}) {
    const Real value = sin(Real(radians));
    stable.add(sine(radians), value, ulp64(value));
    naive_form.add(naive::sine_of_huge(radians), value, ulp32(value));
  }
  expect_demand(stable, naive_form);
}

// The angle of frame k is step times k, rounded once, however many frames came before.
TEST(ExtremeCase, MillionSteps) {
  constexpr int steps = 1'000'000;
  constexpr float step = 0.01f;
  const Track turning(
      {Interpolation::linear, 1, false, 25'000'000, {0, std::int64_t{steps} * 1'000'000}, {0, double{step} * steps}});
  Worst stable, naive_form;
  for (const int k : {1, 17, 99'999, 123'456, 500'000, 999'999, steps}) {
    double angle = 0;
    turning.evaluate(std::int64_t{k} * 1'000'000, &angle);
    stable.add(angle, Real(step) * k, 1.5 * ulp64(Real(step) * k));  // the quotient of ticks and the interpolation
    naive_form.add(naive::by_adding(0, step, k), Real(step) * k, 1.5 * ulp32(Real(step) * k));
  }
  expect_demand(stable, naive_form);
}

TEST(ExtremeCase, ScaleAboutAFarPoint) {
  Random random(2);
  Worst stable, naive_form;
  for (int i = 0; i < 2000; ++i) {
    const float pivot = random.float_in(0.9e8, 1.1e8), x = pivot + random.float_in(-1000, 1000);
    const float factor = random.float_in(0.1, 3);
    const glm::dmat4 m = CompositeTransform().scale_about({pivot, 0, 0}, {factor, 1, 1}).matrix();
    const double moved = (m * glm::dvec4(x, 0, 0, 1)).x;
    const Real value = Real(pivot) + Real(factor) * (Real(x) - Real(pivot));
    constexpr double half_ulp = 4;  // between 2^26 and 2^27
    stable.add(static_cast<float>(moved), value, half_ulp * (1 + 0x1p-20));
    naive_form.add(naive::scaled_about(x, pivot, factor), value, half_ulp * (1 + 0x1p-20));
  }
  expect_demand(stable, naive_form);
}

TEST(ExtremeCase, TenThousandRotations) {
  constexpr int count = 10'000;
  Random random(3);
  CompositeTransform transform;
  std::vector<glm::dmat4> factors;
  glm::mat3 product(1.0f);
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 axis = random.vector(1);
    const double degrees = random.in(-180, 180);
    transform.rotate_about_axis({0, 0, 0}, axis, degrees);
    factors.push_back(transform.steps().back().matrix);
    product = glm::mat3(glm::dmat3(factors.back())) * product;
  }
  const auto rows = reference::product(factors);
  const glm::dmat4 composed = transform.matrix();
  Worst stable, naive_form;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      stable.add(composed[c][r], exact(rows[r][c]), count * 4 * u64);
      naive_form.add(product[c][r], exact(rows[r][c]), count * 4 * u64);
    }
  expect_demand(stable, naive_form);
}

// How far from orthonormal a basis around a unit normal is, beyond what the normal's own length is off.
template <typename Basis>
void add_defect(Worst& worst, const Basis& basis, const glm::vec3& normal) {
  const glm::mat3 m = basis(normal);
  const Real length = Real(normal.x) * normal.x + Real(normal.y) * normal.y + Real(normal.z) * normal.z;
  const double given = static_cast<double>(Real(abs(Real(length - 1))));
  for (int i = 0; i < 3; ++i)
    for (int k = i; k < 3; ++k) {
      Real product = 0;
      for (int c = 0; c < 3; ++c) product += Real(m[i][c]) * Real(m[k][c]);
      worst.add(static_cast<double>(product), i == k ? 1 : 0, 4 * u32 + 4 * given);
    }
}

TEST(ExtremeCase, BasisFromANormalNearMinusZ) {
  Worst stable, naive_form;
  for (const float tilt : {0.0f, 1e-7f, 1e-5f, 1e-4f, 1e-3f, 0.1f, 1.0f}) {
    const glm::vec3 normal(glm::normalize(glm::dvec3(tilt, 0.5 * tilt, -1)));
    add_defect(stable, [](const glm::vec3& n) { return orthonormal_basis(n); }, normal);
    if (tilt > 0) add_defect(naive_form, naive::frisvad_basis, normal);
  }
  expect_demand(stable, naive_form);
}

}  // namespace
}  // namespace morphcl::accuracy
