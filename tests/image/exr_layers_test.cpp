#include "host/image/exr_layers.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>

#include "morphcl/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace test_support;

TEST(ExrLayers, AnotherReaderFindsEveryChannelAndValue) {
  const TemporaryFolder folder;
  constexpr int width = 7, height = 5;
  std::vector<float> red, mask;
  for (int i = 0; i < width * height; ++i) {
    red.push_back(0.1f * static_cast<float>(i));
    mask.push_back(float(i % 4));
  }
  const std::string path = folder / "layers.exr";
  write_exr_layers(path, width, height, {{"R", red.data()}, {"mask", mask.data()}});

  Imf::InputFile file(path.c_str());
  EXPECT_EQ(file.header().displayWindow(), Imath::Box2i({0, 0}, {width - 1, height - 1}));
  ASSERT_NE(file.header().channels().findChannel("R"), nullptr);
  ASSERT_NE(file.header().channels().findChannel("mask"), nullptr);
  std::vector<float> read_red(red.size()), read_mask(mask.size());
  Imf::FrameBuffer planes;
  planes.insert("R", Imf::Slice::Make(Imf::FLOAT, read_red.data(), file.header().dataWindow()));
  planes.insert("mask", Imf::Slice::Make(Imf::FLOAT, read_mask.data(), file.header().dataWindow()));
  file.setFrameBuffer(planes);
  file.readPixels(0, height - 1);
  EXPECT_EQ(read_red, red);
  EXPECT_EQ(read_mask, mask);
}

TEST(ExrLayers, NamesAreThereAndDiffer) {
  const TemporaryFolder folder;
  const float value = 1;
  EXPECT_THROW(write_exr_layers(folder / "a.exr", 1, 1, {{"R", &value}, {"R", &value}}), Error);
  EXPECT_THROW(write_exr_layers(folder / "a.exr", 1, 1, {{"", &value}}), Error);
}

}  // namespace
}  // namespace morphcl
