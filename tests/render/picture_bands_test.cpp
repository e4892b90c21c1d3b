// A picture that the device does not take as one buffer is drawn in bands of whole rows of tiles, pixel for pixel the
// same.
#include "host/render/device/device_renderer.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/shared_session.hpp"
#include "tests/support/channel_sets.hpp"

namespace morphcl::test {
namespace {

// Seven rows of tiles, the last one cut off, over all of which something is drawn: a grid of cubes and, across bands, a
// large one behind them.
constexpr int tall_width = 200, tall_height = 430;
constexpr int tile_rows = 7;

Scene tall_scene(ChannelSet channels, double shift) {
  SceneBuilder builder(tall_width, tall_height);
  builder.look({0, 0, 10});
  builder.add(make_cube(), Shading::smooth, place({shift, 0, -3}, 3));
  for (int row = -6; row <= 6; row += 2)
    builder.add(make_sphere({12, 8}), Shading::flat, place({0.6 * row + shift, 0.7 * row, 2}, 0.4));
  Scene scene = builder.scene();
  scene.image.channels = channels;
  return scene;
}

TEST(PictureBands, PixelsAreTheSameInBandsOfAnyHeight) {
  const auto reference = make_reference_renderer();
  for (const ChannelSet channels : choices_of_two) {
    const std::size_t tile_row = FrameBuffer(tall_width, tall_height, channels).row_bytes() * FrameBuffer::tile_side;
    // Two plans into one buffer: the second one leaves the blank blocks of each band as they are.
    const Scene first_scene = tall_scene(channels, 0), second_scene = tall_scene(channels, 0.3);
    const Plan first = plan_frame(first_scene, 0), second = plan_frame(second_scene, 0);
    FrameBuffer expected_first(tall_width, tall_height, channels), expected_second(tall_width, tall_height, channels);
    reference->render(first, expected_first);
    reference->render(second, expected_second);
    EXPECT_FALSE(same_pixels(expected_first, expected_second));
    for (const std::size_t bytes : {std::size_t{0}, tile_row, tile_row * 2 - 1, tile_row * 2, tile_row * 3 + 5,
                                    tile_row * (tile_rows - 1), tile_row * tile_rows}) {
      const auto device = make_device_renderer(shared_session(), bytes);
      FrameBuffer actual(tall_width, tall_height, channels);
      device->render(first, actual);
      EXPECT_TRUE(same_pixels(expected_first, actual)) << bytes << " bytes a band";
      device->render(second, actual);
      EXPECT_TRUE(same_pixels(expected_second, actual)) << bytes << " bytes a band, second frame";
      device->render(first, actual);
      EXPECT_TRUE(same_pixels(expected_first, actual)) << bytes << " bytes a band, first frame again";
    }
  }
}

// The step through a band's tiles must come to all of them: numbers of tiles that share factors with its start.
TEST(PictureBands, EveryTileIsDrawnWhateverTheirNumberInABand) {
  const auto reference = make_reference_renderer();
  for (const auto& [columns, rows, rows_a_band] :
       {std::tuple{197, 3, 2}, {1, 9, 4}, {199, 2, 1}, {2, 5, 3}, {3, 4, 4}, {1, 256, 200}, {1, 200, 197}}) {
    SceneBuilder builder(columns * 64 - 5, rows * 64 - 5);
    builder.look({0, 0, 2}).project(Orthographic{-1, 1, -1, 1, 0.5, 10, Fit::stretch});
    builder.add(make_cube(), Shading::flat, place({0, 0, 0}, 0.95));
    const Plan plan = plan_frame(builder.scene(), 0);
    FrameBuffer expected(plan->width, plan->height, {Channel::color, Channel::depth}),
        actual(plan->width, plan->height, {Channel::color, Channel::depth});
    reference->render(plan, expected);
    make_device_renderer(shared_session(), expected.row_bytes() * 64 * static_cast<std::size_t>(rows_a_band))
        ->render(plan, actual);
    EXPECT_TRUE(same_pixels(expected, actual)) << columns << " x " << rows << ", " << rows_a_band;
    EXPECT_GT(covered_pixels(expected), static_cast<std::size_t>(plan->width) * plan->height / 2);
  }
}

}  // namespace
}  // namespace morphcl::test
