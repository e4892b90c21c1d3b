// Random soups of triangles: double's areas against 113 bits, by the same way and by another one, within the bound.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/lab/exact_coverage/polygons.hpp"
#include "tests/lab/exact_coverage/slab_coverage.hpp"
#include "tests/support/random.hpp"

namespace morphcl::accuracy {
namespace {

using testing::Quad;
using testing::Share;
using testing::shares_of;
using testing::SlabCoverage;
using testing::triangle;

// Of `size` sub-pixels around pixel (0, 0); depths are floats.
std::vector<RasterPolygon> soup(test_support::Random& random, int count, int size, double depths) {
  std::vector<RasterPolygon> polygons;
  while (static_cast<int>(polygons.size()) < count) {
    std::array<SubPixelPoint, 3> corners;
    std::array<double, 3> depth;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k].x = 128 + static_cast<int>(random.integer_in(-size, size));
      corners[k].y = 128 + static_cast<int>(random.integer_in(-size, size));
      depth[k] = random.float_in(0.5 - depths, 0.5 + depths);
    }
    if (doubled_area(corners[0], corners[1], corners[2]) == 0) continue;
    polygons.push_back(triangle(corners, depth, static_cast<std::uint32_t>(polygons.size())));
  }
  return polygons;
}

struct Soup {
  int count, size;
  double depths;
};
const Soup soups[] = {{1, 200, 0.4},     {2, 300, 0.4},     {3, 500, 0.4},      {5, 300, 0.4},      {4, 100, 1e-6},
                      {4, 1 << 14, 0.4}, {4, 1 << 23, 0.4}, {3, 1 << 23, 1e-7}, {6, 2000, 0x1p-20}, {5, 3, 0.4}};

double margin(double error, double bound) { return bound > 0 ? error / bound : error > 0 ? 1e9 : 0; }

TEST(QuadCoverage, SlabsGiveTheSameAreas) {
  test_support::Random random(13);
  double worst = 0;
  for (int round = 0; round < 8; ++round)
    for (const Soup& s : soups) {
      const std::vector<RasterPolygon> polygons = soup(random, s.count, s.size, s.depths);
      double bound = 0;
      const std::vector<Share> shares = shares_of(polygons, 0, 0, 0, &bound);
      const std::vector<Quad> truth = SlabCoverage::areas(polygons, 0, 0);
      for (std::size_t i = 0; i < truth.size(); ++i) {
        const double error = std::abs(static_cast<double>(Quad(shares[i].area) - truth[i]));
        // pixels_of() rounds to double.
        ASSERT_LE(error, bound + 0x1p-53) << "surface " << i << " of " << s.count << ", size " << s.size;
        worst = std::max(worst, margin(error, bound + 0x1p-53));
      }
    }
  RecordProperty("worst_part_of_bound", std::to_string(worst));
  std::printf("worst error: %.3g of the bound\n", worst);
}

TEST(QuadCoverage, MoreDigitsGiveTheSameAreas) {
  test_support::Random random(14);
  double worst = 0;
  for (int round = 0; round < 25; ++round)
    for (const Soup& s : soups) {
      const std::vector<RasterPolygon> polygons = soup(random, 3 * s.count, s.size, s.depths);
      double bound = 0;
      const std::vector<Share> shares = shares_of(polygons, 0, 0, 0, &bound);
      const std::vector<Share> truth = shares_of<Quad>(polygons);
      for (std::size_t i = 0; i < truth.size(); ++i) {
        const double error = std::abs(shares[i].area - truth[i].area);
        ASSERT_LE(error, bound + 0x1p-52) << "surface " << i << " of " << s.count << ", size " << s.size;
        worst = std::max(worst, margin(error, bound + 0x1p-52));
      }
    }
  RecordProperty("worst_part_of_bound", std::to_string(worst));
  std::printf("worst error: %.3g of the bound\n", worst);
}

// Moved by h to both sides, an area changes by the integral of its derivative, which lies between its values as long as
// no corner comes into the pixel or leaves it: nearly always, so that the mean of the differences is small.
TEST(QuadCoverage, DerivativesAreThoseOfMovedPictures) {
  test_support::Random random(15);
  const auto moved = [](std::vector<RasterPolygon> polygons, int dx, int dy) {
    for (RasterPolygon& p : polygons) {
      for (SubPixelPoint& c : p.corner) c = {c.x + dx, c.y + dy};
      for (SubPixelPoint& c : p.plane) c = {c.x + dx, c.y + dy};
    }
    return polygons;
  };
  double x_error = 0, y_error = 0, x_size = 0, y_size = 0;
  for (int round = 0; round < 300; ++round) {
    const std::vector<RasterPolygon> polygons = soup(random, 4, 400, 0.4);
    const std::vector<Share> here = shares_of(polygons);
    const std::vector<Share> left = shares_of(moved(polygons, -1, 0)), right = shares_of(moved(polygons, 1, 0));
    const std::vector<Share> up = shares_of(moved(polygons, 0, -1)), down = shares_of(moved(polygons, 0, 1));
    for (std::size_t i = 0; i < here.size(); ++i) {
      x_error += std::abs((right[i].area - left[i].area) * 128 - here[i].with_x);
      y_error += std::abs((down[i].area - up[i].area) * 128 - here[i].with_y);
      x_size += std::abs(here[i].with_x);
      y_size += std::abs(here[i].with_y);
    }
  }
  EXPECT_GT(x_size, 100);
  EXPECT_GT(y_size, 100);
  EXPECT_LT(x_error, 0.01 * x_size);
  EXPECT_LT(y_error, 0.01 * y_size);
}

}  // namespace
}  // namespace morphcl::accuracy
