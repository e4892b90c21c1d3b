#include "morphcl/projection.hpp"

#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using test_support::Random;

void expect_window(const FittedWindow& actual, const Window& expected, ChangedAxis changed) {
  EXPECT_EQ(actual.window.left, expected.left);
  EXPECT_EQ(actual.window.right, expected.right);
  EXPECT_EQ(actual.window.bottom, expected.bottom);
  EXPECT_EQ(actual.window.top, expected.top);
  EXPECT_EQ(static_cast<int>(actual.changed), static_cast<int>(changed));
}

// x reaches from -2 to 2 on 400 x 100 pixels: it is widened by 2 on either side, to 4 and not to 3.
TEST(Window, WidensXOfAWideImage) {
  expect_window(fitted({-2, 2, -1, 1}, Fit::widen, 4), {-4, 4, -1, 1}, ChangedAxis::x);
  expect_window(fitted({1, 3, -1, 1}, Fit::widen, 2), {0, 4, -1, 1}, ChangedAxis::x);
}

TEST(Window, WidensYOfATallImage) {
  expect_window(fitted({-2, 2, -1, 1}, Fit::widen, 0.5), {-2, 2, -4, 4}, ChangedAxis::y);
}

TEST(Window, CropsOnlyOnRequest) {
  expect_window(fitted({-2, 2, -1, 1}, Fit::crop, 4), {-2, 2, -0.5, 0.5}, ChangedAxis::y);
  expect_window(fitted({-2, 2, -1, 1}, Fit::crop, 1), {-1, 1, -1, 1}, ChangedAxis::x);
}

TEST(Window, AdjustsTheAxisThatIsNamedInBothDirections) {
  expect_window(fitted({-2, 2, -1, 1}, Fit::adjust_y, 4), {-2, 2, -0.5, 0.5}, ChangedAxis::y);
  expect_window(fitted({-2, 2, -1, 1}, Fit::adjust_y, 0.5), {-2, 2, -4, 4}, ChangedAxis::y);
  expect_window(fitted({-2, 2, -1, 1}, Fit::adjust_x, 4), {-4, 4, -1, 1}, ChangedAxis::x);
  expect_window(fitted({-2, 2, -1, 1}, Fit::adjust_x, 0.5), {-0.5, 0.5, -1, 1}, ChangedAxis::x);
  expect_window(fitted({-2, 2, -1, 1}, Fit::adjust_x, 2), {-2, 2, -1, 1}, ChangedAxis::none);
}

TEST(Window, StretchesAndFitsWithoutChangingABit) {
  const Window window{-0.1, 0.3, -0.7, 0.9};
  expect_window(fitted(window, Fit::stretch, 17), window, ChangedAxis::none);
  expect_window(fitted({-8, 8, -4.5, 4.5}, Fit::widen, 1280.0 / 720), {-8, 8, -4.5, 4.5}, ChangedAxis::none);
}

// Whatever the window and the image: the proportions are the image's, nothing is lost, and one axis keeps its bits.
TEST(Window, WideningKeepsAllOfTheWindow) {
  Random random(141);
  for (int i = 0; i < 2000; ++i) {
    const double aspect = std::pow(10.0, random.in(-2, 2));
    Window w{random.in(-5, 5), 0, random.in(-5, 5), 0};
    w.right = w.left + std::pow(10.0, random.in(-3, 3));
    w.top = w.bottom + std::pow(10.0, random.in(-3, 3));
    const FittedWindow f = fitted(w, Fit::widen, aspect);
    // Half an ulp of each side, of the lengths, and of the product.
    const double reach = std::max(
        {std::abs(f.window.left), std::abs(f.window.right), std::abs(f.window.bottom), std::abs(f.window.top)});
    const double width = f.window.right - f.window.left, height = f.window.top - f.window.bottom;
    const double unit = std::max(1.0, aspect);
    EXPECT_TRUE(within(width - height * aspect, 0.0, 8 * reference::u64 * unit * reach)) << i;
    EXPECT_LE(f.window.left, w.left) << i;
    EXPECT_GE(f.window.right, w.right) << i;
    EXPECT_LE(f.window.bottom, w.bottom) << i;
    EXPECT_GE(f.window.top, w.top) << i;
    if (f.changed == ChangedAxis::x) {
      EXPECT_EQ(f.window.bottom, w.bottom);
      EXPECT_EQ(f.window.top, w.top);
    } else {
      EXPECT_EQ(f.window.left, w.left);
      EXPECT_EQ(f.window.right, w.right);
    }
  }
}

TEST(Window, IsWhatAProjectionShows) {
  expect_window(fitted_window(Orthographic{-2, 2, -1, 1, 0, 1, Fit::widen}, 4), {-4, 4, -1, 1}, ChangedAxis::x);
  expect_window(fitted_window(CentralProjection{-2, 2, -1, 1, 1, 2, 5}, 4), {-4, 4, -1, 1}, ChangedAxis::x);
  expect_window(fitted_window(Perspective{90, 1, 2}, 2), {-2, 2, -1, 1}, ChangedAxis::none);
  expect_window(fitted_window(HorizontalPerspective{90, 1, 2}, 2), {-1, 1, -0.5, 0.5}, ChangedAxis::none);
}

// The matrix of a fitted window is that of the window which it is fitted to.
TEST(Window, FitsTheMatrix) {
  const glm::dmat4 fitting = projection_matrix(Frustum{-1, 1, -1, 1, 2, 9, Fit::widen}, 3),
                   plain = projection_matrix(Frustum{-3, 3, -1, 1, 2, 9, Fit::stretch}, 1);
  EXPECT_EQ(fitting, plain);
}

}  // namespace
}  // namespace morphcl
