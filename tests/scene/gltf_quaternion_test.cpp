// Quaternions of glTF files are made of unit length, with bits that do not depend on the C library.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "host/scene/gltf/gltf_quaternion.hpp"

namespace morphcl::test {
namespace {

using Numbers = std::array<double, 4>;

TEST(GltfQuaternion, IsMadeOfUnitLength) {
  for (const double size : {1e-300, 1e-20, 0.99, 1.0, 3.7, 1e20, 1e300}) {
    Numbers q{0.1 * size, -0.7 * size, 0.3 * size, 0.2 * size};
    const Numbers given = q;
    const auto length = normalize_quaternion(q);
    ASSERT_TRUE(length);
    EXPECT_NEAR(*length / size, std::sqrt(0.63), 1e-15);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(q[i], given[i] / size / std::sqrt(0.63), 1e-15) << size;
  }
}

// Within an ulp of the exact ones; the same from every compiler and processor.
TEST(GltfQuaternion, HasTheseBits) {
  Numbers q{0x1.999999999999ap-4, 0x1.3333333333333p-2, 0x1.6666666666666p-1, -0x1.47ae147ae147bp-1};
  ASSERT_TRUE(normalize_quaternion(q));
  EXPECT_EQ(q, (Numbers{0x1.99ae93eb96cd2p-4, 0x1.3342eef0b119dp-2, 0x1.6678c16e23f37p-1, -0x1.47bedcbc78a42p-1}));
}

TEST(GltfQuaternion, WithoutDirectionIsLeftAlone) {
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const Numbers given : {Numbers{0, -0.0, 0, 0}, Numbers{infinity, 0, 0, 0}, Numbers{0, 0, nan, 1}}) {
    Numbers q = given;
    EXPECT_FALSE(normalize_quaternion(q));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(q[i] == given[i] || std::isnan(given[i]));
  }
}

}  // namespace
}  // namespace morphcl::test
