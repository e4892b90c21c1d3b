// The files of a comparison: planes, picture, table.
#include "lab/frame_error/difference_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace morphcl::accuracy {
namespace {

FrameDifference small_difference() {
  FrameDifference d;
  d.frame = 7;
  d.width = 8;
  d.height = 4;
  d.has_color = true;
  for (std::vector<float>* plane : {&d.red, &d.green, &d.blue, &d.alpha, &d.depth, &d.mask}) plane->resize(32);
  d.shown.assign(32, 1);
  return d;
}

TEST(DifferencePicture, BrightnessGrowsWithTheErrorAndMarksStandOut) {
  FrameDifference d = small_difference();
  d.red[0] = 0x1p-20f;
  d.red[1] = 0x1p-10f;
  d.red[2] = std::numeric_limits<float>::infinity();
  d.mask[31] = static_cast<float>(PixelDifference::order);
  d.shown[8] = 0;
  const RgbImage image = difference_picture(d);
  EXPECT_EQ(image.at(3, 0).red, 0);
  EXPECT_GT(image.at(0, 0).red, 40);
  EXPECT_GT(image.at(1, 0).red, image.at(0, 0).red + 40);
  EXPECT_EQ(image.at(2, 0).red, 255);
  EXPECT_NE(image.at(0, 1).blue, 0) << "nothing is shown there";
  EXPECT_EQ(image.at(6, 2).green, 0);
  EXPECT_EQ(image.at(6, 2).red, 255) << "marks are a pixel wider on each side";
  EXPECT_EQ(image.at(5, 2).red, 0);
}

TEST(DifferenceCsv, HasOneFieldAColumnAndQuotesNames) {
  FrameDifference d = small_difference();
  d.objects.emplace_back().name = "a \"b\", c";
  const std::string header = csv_header(), lines = csv_lines(d);
  const std::size_t columns = static_cast<std::size_t>(std::count(header.begin(), header.end(), ','));
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 2);
  EXPECT_NE(lines.find("7,grid,\"a \"\"b\"\", c\",0,"), std::string::npos) << lines;
  EXPECT_EQ(static_cast<std::size_t>(std::count(lines.begin(), lines.end(), ',')), 2 * columns + 1);
}

}  // namespace
}  // namespace morphcl::accuracy
