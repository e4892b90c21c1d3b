// The averaged normals of an OBJ morph target are rounded once, at the end.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "host/scene/obj/obj_import.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::test {
namespace {

using Numbers = std::array<double, 3>;

// Every step is stored, so that none is left out, joined with another or done in another order.
Numbers unit(const Numbers& v) {
  volatile double xx = v[0] * v[0], yy = v[1] * v[1], zz = v[2] * v[2];
  volatile double xy = xx + yy;
  volatile double sum = xy + zz;
  volatile double length = std::sqrt(sum);
  Numbers result;
  for (std::size_t i = 0; i < 3; ++i) {
    volatile double quotient = v[i] / length;
    result[i] = quotient;
  }
  return result;
}

// The second and the third vertex are shared by two triangles, each with a normal of its own in the target.
const std::string positions = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\n";
const std::string neutral = positions + "vn 0 0 1\nf 1//1 2//1 3//1\nf 3//1 2//1 4//1\n";

TEST(TargetNormals, AreTheSumOfUnroundedUnitsRoundedOnce) {
  const test_support::TemporaryFolder folder;
  int differ_when_rounded_before = 0;
  for (int i = 1; i <= 40; ++i) {
    const int j = 41 - i;
    const std::string target = positions + "vn " + std::to_string(i) + " 3 7\nvn -2 " + std::to_string(j) +
                               " 5\nf 1//1 2//1 3//1\nf 3//2 2//2 4//2\n";
    const ImportedModel model =
        import_obj_targets(folder.write("neutral.obj", neutral), {folder.write("target.obj", target)});
    ASSERT_EQ(model.meshes.size(), 1u);
    ASSERT_EQ(model.meshes[0].targets.size(), 1u);
    const Numbers a = unit({static_cast<double>(i), 3, 7}), b = unit({-2, static_cast<double>(j), 5});
    Numbers sum, sum_of_rounded;
    for (std::size_t c = 0; c < 3; ++c) {
      volatile double whole = a[c] + b[c];
      volatile float a_stored = static_cast<float>(a[c]), b_stored = static_cast<float>(b[c]);
      volatile double rounded = static_cast<double>(a_stored) + static_cast<double>(b_stored);
      sum[c] = whole;
      sum_of_rounded[c] = rounded;
    }
    const Numbers expected = unit(sum), twice = unit(sum_of_rounded);
    for (std::size_t c = 0; c < 3; ++c) {
      volatile float stored = static_cast<float>(expected[c]), other = static_cast<float>(twice[c]);
      // Vertices of the mesh are in the order of the positions; the second one is shared.
      EXPECT_EQ(model.meshes[0].targets[0].normals[1][static_cast<int>(c)], stored) << i << " component " << c;
      if (stored != other) ++differ_when_rounded_before;
    }
  }
  EXPECT_GT(differ_when_rounded_before, 0);
}

}  // namespace
}  // namespace morphcl::test
