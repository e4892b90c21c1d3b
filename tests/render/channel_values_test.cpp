// What channels say, against what is known of small pictures: ids, coverage, Cryptomatte, albedo, velocity.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "host/cryptomatte_id.hpp"
#include "host/render/frame/channel_passes.hpp"
#include "host/render/frame/sample_pattern.hpp"
#include "host/render/reference/shown_pixels.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/channel_scenes.hpp"
#include "tests/render/parity.hpp"

namespace morphcl::test {
namespace {

float value(const FrameBuffer& frame, Channel channel, int plane, int x, int y) {
  const auto at = static_cast<std::size_t>(x);
  if (plane_type(channel) == PixelType::half)
    return static_cast<float>(from_half(frame.half_row(channel, plane, y)[at]));
  return frame.float_row(channel, plane, y)[at];
}
std::uint32_t id(const FrameBuffer& frame, Channel channel, int x, int y) {
  return frame.uint_row(channel, 0, y)[static_cast<std::size_t>(x)];
}

class ChannelValues : public ::testing::Test {
 protected:
  FrameBuffer by_reference(const Scene& scene, std::int64_t frame = 0) const {
    return drawn(*reference_, scene, frame);
  }
  const std::unique_ptr<Renderer> reference_ = make_reference_renderer(2);
};

template <class Visit>
void for_each_pixel(const FrameBuffer& frame, const Visit& visit) {
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x) visit(x, y);
}

// ---- centres --------------------------------------------------------------------------------------------------------

TEST_F(ChannelValues, IdsAreThoseOfWhatIsSeen) {
  for (TestScene& test : test_scenes(120, 80, 300)) {
    if (test.name != "many objects" && test.name != "lines") continue;
    const Scene scene = with_channels(test.scene, {Channel::object_id, Channel::material_id});
    const FrameBuffer frame = by_reference(scene);
    const std::vector<reference::ShownPixel> shown = reference::shown_pixels(*plan_frame(scene, 0));
    std::map<std::string, std::uint32_t> materials;  // in the order in which objects first use them
    for (const Object& object : scene.objects)
      materials.emplace(object.material.name.empty() ? object.name : object.material.name,
                        static_cast<std::uint32_t>(materials.size() + 1));
    for_each_pixel(frame, [&](int x, int y) {
      const reference::ShownPixel& pixel = shown[static_cast<std::size_t>(y * frame.width() + x)];
      const bool nothing = pixel.object == reference::nothing_shown;
      EXPECT_EQ(id(frame, Channel::object_id, x, y), nothing ? 0 : pixel.object + 1);
      if (nothing) {
        EXPECT_EQ(id(frame, Channel::material_id, x, y), 0u);
        return;
      }
      const Object& object = scene.objects[pixel.object];
      const std::string& name = object.material.name.empty() ? object.name : object.material.name;
      EXPECT_EQ(id(frame, Channel::material_id, x, y), materials.at(name));
    });
  }
}

TEST_F(ChannelValues, CentresAreThoseOfOneSampleAPixel) {
  const ChannelSet centres = channels_of_centres | ChannelSet{Channel::depth};
  for (TestScene& test : test_scenes(90, 60, 300)) {
    SCOPED_TRACE(test.name);
    const FrameBuffer one = by_reference(with_channels(test.scene, every_channel), test.frames.back());
    for (const int samples : {2, 16}) {
      const FrameBuffer several = by_reference(with_channels(test.scene, every_channel, samples), test.frames.back());
      EXPECT_TRUE(same_pixels(one, several, centres)) << samples;
    }
  }
}

TEST_F(ChannelValues, AlbedoIsTheBaseColorWithoutLight) {
  SceneBuilder b(60, 40);
  b.add(make_cube(), Shading::smooth, place({0, 0, 0}), {0.7, 0.25, 0.125, 1});
  b.scene().timeline.ambient = glm::dvec3(0.3);
  b.no_lights();  // then the ambient light goes into the base colour
  b.scene().image.channels = {Channel::color, Channel::albedo, Channel::object_id};
  const FrameBuffer frame = by_reference(b.look({1, 2, 3}).scene());
  int seen = 0;
  for_each_pixel(frame, [&](int x, int y) {
    const bool shows = id(frame, Channel::object_id, x, y) != 0;
    seen += shows;
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(frame.half_row(Channel::albedo, c, y)[static_cast<std::size_t>(x)],
                shows ? to_half(std::array{0.7f, 0.25f, 0.125f}[static_cast<std::size_t>(c)]) : 0);
  });
  EXPECT_GT(seen, 100);
}

// Vertex colours that are a linear function of the place in a parallel view.
TEST_F(ChannelValues, AlbedoAndUvAreInterpolated) {
  constexpr int size = 32;
  SceneBuilder b = flat_picture(size, size);
  Mesh mesh = polygon({{0, 0}, {size, 0}, {size, size}, {0, size}}, size, size);
  for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
    mesh.uvs.push_back(corner);
    mesh.colors.emplace_back(corner.x, corner.y, 1, 1);
  }
  b.add(mesh, Shading::unlit, place({0, 0, 0}), {0.5, 0.5, 0.5, 1}, true);
  b.scene().image.channels = {Channel::uv, Channel::albedo};
  const FrameBuffer frame = by_reference(b.scene());
  // Shares of numbers up to 1: three roundings of areas, sums and quotients, three of the sum of products.
  constexpr float bound = 12 * 0x1p-24f;
  for_each_pixel(frame, [&](int x, int y) {
    const float u = (static_cast<float>(x) + 0.5f) / size, v = (static_cast<float>(y) + 0.5f) / size;
    EXPECT_NEAR(value(frame, Channel::uv, 0, x, y), u, bound);
    EXPECT_NEAR(value(frame, Channel::uv, 1, x, y), v, bound);
    EXPECT_NEAR(value(frame, Channel::albedo, 0, x, y), 0.5f * u, 0x1p-12f);
    EXPECT_NEAR(value(frame, Channel::albedo, 1, x, y), 0.5f * v, 0x1p-12f);
    EXPECT_EQ(value(frame, Channel::albedo, 2, x, y), 0.5f);
  });
}

// A back face of a double-sided draw turns its normal to the eye, unlit, flat or smooth, mirrored or not.
TEST_F(ChannelValues, NormalsOfDoubleSidedFacesLookAtTheEye) {
  for (const Shading shading : {Shading::unlit, Shading::flat, Shading::smooth})
    for (const bool with_normals : {false, true})
      for (const double mirror : {1.0, -1.0})
        for (const double facing : {1.0, -1.0}) {
          SceneBuilder b(20, 20);
          Mesh mesh;
          mesh.positions = {{-3, -3, 0}, {3, -3, 0}, {0, 4, 0}};
          mesh.triangles = {{0, 1, 2}};
          if (with_normals) mesh.normals.assign(3, {0, 0, 1});
          glm::dmat4 m(1.0);
          m[0][0] = mirror;
          m[2][2] = facing;
          if (facing < 0) m[0][0] = -mirror;  // turned round the y axis
          b.add(mesh, shading, m, {1, 1, 1, 1}, true);
          b.scene().image.channels = {Channel::normal};
          const FrameBuffer frame = by_reference(b.look({0, 0, 5}).scene());
          EXPECT_EQ(value(frame, Channel::normal, 0, 10, 10), 0.0f);
          EXPECT_EQ(value(frame, Channel::normal, 1, 10, 10), 0.0f);
          EXPECT_EQ(value(frame, Channel::normal, 2, 10, 10), 1.0f) << with_normals << mirror << facing;
        }
}

// ---- shares of samples ----------------------------------------------------------------------------------------------

// Up to five objects of some triangles each, over each other.
Scene shared_pixels(unsigned seed, int width, int height, int objects) {
  test_support::Random random(seed);
  SceneBuilder b = flat_picture(width, height);
  for (int o = 0; o < objects; ++o) {
    Mesh mesh;
    for (int t = 0; t < 6; ++t)
      for (int i = 0; i < 3; ++i) {
        const glm::dvec2 p = random_point(random, {-0.5 * width, -0.5 * height}, {0.5 * width, 0.5 * height});
        mesh.positions.emplace_back(p.x, p.y, random.in(-2, 2));
        if (i == 2) mesh.triangles.push_back(glm::uvec3(3 * t) + glm::uvec3(0, 1, 2));
      }
    const int index = b.add(mesh, Shading::unlit, place({0, 0, 0}), {0.2, 0.4, 0.6, 1}, true);
    Object& object = b.scene().objects[static_cast<std::size_t>(index)];
    object.material.name = "material " + std::to_string(o / 2);
    if (o % 3 == 2) object.name = b.scene().objects[0].name;  // two objects of one name have one matte
    if (o == 3) object.material.shading = Shading::wireframe;
  }
  return b.scene();
}

float matte(const FrameBuffer& frame, Channel channel, const std::string& name, int x, int y) {
  const float wanted = cryptomatte_id(name);
  float sum = 0;
  for (int rank = 0; rank < 6; ++rank)
    if (value(frame, channel, 2 * rank, x, y) == wanted) sum += value(frame, channel, 2 * rank + 1, x, y);
  return sum;
}

TEST_F(ChannelValues, MattesAreTheSharesOfWhiteObjects) {
  for (const int samples : sample_counts) {
    Scene scene = shared_pixels(static_cast<unsigned>(samples), 30, 20, 6);
    scene.image.samples = samples;
    scene.image.channels = every_channel;
    const FrameBuffer frame = by_reference(scene);
    const auto name_of_material = [](const Object& object) { return object.material.name; };
    const auto name_of_object = [](const Object& object) { return object.name; };
    std::size_t parts = 0;
    const auto expect_mattes = [&](Channel channel, const auto& name_of_its) {
      for (const Object& chosen : scene.objects) {
        const std::string name = name_of_its(chosen);
        Scene black = scene;
        black.image.channels = {Channel::color};
        for (Object& object : black.objects)
          object.material.base_color = name_of_its(object) == name ? glm::dvec4(1) : glm::dvec4(0, 0, 0, 1);
        const FrameBuffer white = by_reference(black);
        for_each_pixel(frame, [&](int x, int y) {
          const float share = value(white, Channel::color, 0, x, y);
          EXPECT_EQ(matte(frame, channel, name, x, y), share) << name << ", samples " << samples;
          parts += share != 0 && share != 1;
        });
      }
    };
    expect_mattes(Channel::crypto_object, name_of_object);
    expect_mattes(Channel::crypto_material, name_of_material);
    EXPECT_GE(parts, samples > 1 ? 100u : 0u);
  }
}

// Coverage is alpha, all names' shares are coverage, ranks fall, and what is behind the last is 0.
TEST_F(ChannelValues, SharesAddUpToCoverage) {
  for (const int samples : sample_counts) {
    Scene scene = shared_pixels(40 + static_cast<unsigned>(samples), 40, 30, 6);
    scene.image.samples = samples;
    scene.image.channels = every_channel;
    const FrameBuffer frame = by_reference(scene);
    for_each_pixel(frame, [&](int x, int y) {
      const float coverage = value(frame, Channel::coverage, 0, x, y);
      EXPECT_EQ(coverage, value(frame, Channel::color, 3, x, y));
      for (const Channel channel : {Channel::crypto_object, Channel::crypto_material}) {
        float sum = 0, before = 2;
        for (int rank = 0; rank < 6; ++rank) {
          const float share = value(frame, channel, 2 * rank + 1, x, y);
          EXPECT_LE(share, before);
          EXPECT_EQ(share == 0, value(frame, channel, 2 * rank, x, y) == 0);
          before = share;
          sum += share;
        }
        EXPECT_EQ(sum, coverage);
        EXPECT_EQ(sum + (1 - coverage), 1);  // with the background
      }
    });
  }
}

// Behind a background, coverage is still that of surfaces.
TEST_F(ChannelValues, CoverageDoesNotCountTheBackground) {
  Scene scene = shared_pixels(3, 20, 20, 3);
  scene.image.samples = 4;
  scene.image.channels = {Channel::color, Channel::coverage};
  const FrameBuffer without = by_reference(scene);
  scene.image.background = Background{{1, 1, 1}, {1, 1, 1}};
  EXPECT_TRUE(same_pixels(without, by_reference(scene), {Channel::coverage}));
}

// Strips of a pixel, one object each: `samples` of 16 samples in each column would be fewer than six.
TEST_F(ChannelValues, TheSixLargestOfManyRemain) {
  SceneBuilder b = flat_picture(1, 1);
  constexpr int strips = 10;
  for (int i = 0; i < strips; ++i)
    b.add(polygon({{i * 0.1, 0}, {i * 0.1, 1}, {(i + 1) * 0.1, 1}, {(i + 1) * 0.1, 0}}, 1, 1), Shading::unlit,
          place({0, 0, 0}), {1, 1, 1, 1}, true);
  b.scene().image.samples = 16;
  b.scene().image.channels = {Channel::crypto_object, Channel::coverage};
  const FrameBuffer frame = by_reference(b.scene());
  EXPECT_EQ(value(frame, Channel::coverage, 0, 0, 0), 1.0f);
  // How many samples each strip has follows from the pattern: its x, on a grid of sub-pixels.
  std::vector<std::pair<int, int>> count_of;  // negative count, strip
  for (int i = 0; i < strips; ++i) count_of.emplace_back(0, i);
  for (const SampleOffset& sample : sample_pattern(16)) {
    const int x = 128 + sample.subpixels_x();
    for (int i = 0; i < strips; ++i)
      if (x >= std::nearbyint(i * 25.6) && x < std::nearbyint((i + 1) * 25.6))
        --count_of[static_cast<std::size_t>(i)].first;
  }
  std::sort(count_of.begin(), count_of.end());
  for (int rank = 0; rank < 6; ++rank) {
    const auto [negative, strip] = count_of[static_cast<std::size_t>(rank)];
    EXPECT_EQ(value(frame, Channel::crypto_object, 2 * rank + 1, 0, 0), static_cast<float>(-negative) / 16) << rank;
    EXPECT_EQ(value(frame, Channel::crypto_object, 2 * rank, 0, 0), cryptomatte_id("object " + std::to_string(strip)))
        << rank;
  }
}

// ---- velocity -------------------------------------------------------------------------------------------------------

Scene one_that_moves(const glm::dvec3& way_of_frame) {
  constexpr int size = 40;
  SceneBuilder b = flat_picture(size, size);
  b.add(polygon({{5, 5}, {5, 25}, {25, 25}, {25, 5}}, size, size), Shading::unlit, place({0, 0, 0}), {1, 1, 1, 1},
        true);
  Timeline& timeline = b.scene().timeline;
  timeline.nodes[0].translation_track = drifting(timeline.time, {0, 0, 0}, 100.0 * way_of_frame);
  b.scene().image.channels = {Channel::velocity, Channel::object_id};
  return b.scene();
}

// The example of the documentation: 3 pixels to the right and 2 up.
TEST_F(ChannelValues, VelocityPointsRightAndUp) {
  const FrameBuffer frame = by_reference(one_that_moves({3, 2, 0}), 1);
  int seen = 0;
  // Of numbers up to 1 each way, in halves of the picture: six roundings of shares and sums, one each of quotients.
  constexpr float bound = 2 * 12 * 0x1p-24f * 20;
  for_each_pixel(frame, [&](int x, int y) {
    const bool shows = id(frame, Channel::object_id, x, y) != 0;
    seen += shows;
    EXPECT_NEAR(value(frame, Channel::velocity, 0, x, y), shows ? 3 : 0, bound);
    EXPECT_NEAR(value(frame, Channel::velocity, 1, x, y), shows ? 2 : 0, bound);
  });
  EXPECT_EQ(seen, 400);
}

TEST_F(ChannelValues, VelocityOfWhatStandsStillIsZero) {
  Scene scene = one_that_moves({0, 0, 0});
  scene.timeline.nodes[0].translation_track = {};
  scene.timeline.nodes.push_back({});
  scene.timeline.nodes[1].translation_track = drifting(scene.timeline.time, {0, 0, 0}, {5, 5, 5});
  const FrameBuffer frame = by_reference(scene);
  for_each_pixel(frame, [&](int x, int y) {
    EXPECT_EQ(std::bit_cast<std::uint32_t>(value(frame, Channel::velocity, 0, x, y)), 0u);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(value(frame, Channel::velocity, 1, x, y)), 0u);
  });
}

// One half of a mesh that morphs stays: there velocity is 0 to the last bit.
TEST_F(ChannelValues, VelocityIsZeroWhereAMorphDoesNotMove) {
  SceneBuilder b(60, 40);
  Mesh mesh;
  mesh.positions = {{-2, -1, 0}, {-0.1f, -1, 0.3f}, {-1, 1, 0}, {0.1f, -1, 0}, {2, -1, 0}, {1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  MorphTarget target;
  target.name = "up";
  target.positions = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
  mesh.targets.push_back(target);
  b.add(mesh, Shading::unlit, glm::dmat4(1.0), {1, 1, 1, 1}, true);
  Scene& scene = b.look({0, 0, 5}).scene();
  const TimeBase& time = scene.timeline.time;
  scene.objects[0].morph.tracks.push_back({0, Track({Interpolation::linear,
                                                     1,
                                                     false,
                                                     time.ticks_per_second(),
                                                     {time.frame_ticks(0), time.frame_ticks(10)},
                                                     {0, 1}})});
  scene.image.channels = {Channel::velocity, Channel::object_id, Channel::position};
  const FrameBuffer frame = by_reference(scene, 3);
  int still = 0, moving = 0;
  for_each_pixel(frame, [&](int x, int y) {
    if (id(frame, Channel::object_id, x, y) == 0) return;
    const float v = value(frame, Channel::velocity, 1, x, y);
    const bool moves = x >= 30;
    EXPECT_EQ(v > 0.1f, moves) << v;
    EXPECT_EQ(v == 0.0f, !moves) << v;
    (moves ? moving : still) += 1;
  });
  EXPECT_GT(still, 50);
  EXPECT_GT(moving, 50);
}

TEST_F(ChannelValues, VelocityBehindTheNextEyeIsZero) {
  SceneBuilder b(30, 20);
  b.add(make_grid({1, 1}), Shading::unlit,
        place({0, 0, 0}, 50) * glm::dmat4{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, 0, 1}}, {1, 1, 1, 1}, true);
  Scene& scene = b.look({0, 0, 1}, {0, 0, -10}).scene();
  const TimeBase& time = scene.timeline.time;
  scene.timeline.camera.eye_track = Track({Interpolation::linear,
                                           3,
                                           false,
                                           time.ticks_per_second(),
                                           {time.frame_ticks(0), time.frame_ticks(1)},
                                           {0, 0, 1, 0, 0, -1}});
  scene.image.channels = {Channel::velocity, Channel::object_id};
  const FrameBuffer frame = by_reference(scene);
  for_each_pixel(frame, [&](int x, int y) {
    EXPECT_NE(id(frame, Channel::object_id, x, y), 0u);
    EXPECT_EQ(value(frame, Channel::velocity, 0, x, y), 0.0f);
    EXPECT_EQ(value(frame, Channel::velocity, 1, x, y), 0.0f);
  });
}

// Triangles, an object each, that turn, morph and come nearer under a camera that moves, with texture coordinates that
// say which point of a triangle a pixel shows: where a pixel goes by its velocity, the next frame shows the same point.
Scene warped_scene(const Projection& projection) {
  test_support::Random random(17);
  SceneBuilder b(160, 120);
  const auto coordinate = [&](double reach) { return static_cast<float>(random.in(-reach, reach)); };
  for (int i = 0; i < 14; ++i) {
    Mesh mesh;
    MorphTarget target;
    target.name = "bent";
    for (int corner = 0; corner < 3; ++corner) {
      const float x = coordinate(1.5), y = coordinate(1.2), z = coordinate(0.8);
      mesh.positions.emplace_back(x, y, z);
      const float dx = coordinate(0.3), dy = coordinate(0.3), dz = coordinate(0.3);
      target.positions.emplace_back(dx, dy, dz);
    }
    mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
    mesh.triangles = {{0, 1, 2}};
    mesh.targets.push_back(target);
    const int object = b.add(mesh, Shading::unlit, glm::dmat4(1.0), {1, 1, 1, 1}, true);
    Timeline& timeline = b.scene().timeline;
    const TimeBase& time = timeline.time;
    const double way_x = random.in(-9, 9), way_y = random.in(-9, 9), way_z = random.in(-9, 9);
    timeline.nodes[static_cast<std::size_t>(object)].translation_track =
        drifting(time, {0, 0, 0}, {way_x, way_y, way_z});
    b.scene().objects[static_cast<std::size_t>(object)].morph.tracks.push_back(
        {0, Track({Interpolation::linear,
                   1,
                   false,
                   time.ticks_per_second(),
                   {time.frame_ticks(0), time.frame_ticks(20)},
                   {0, 1}})});
  }
  b.look({0.3, 0.2, 5}).project(projection);
  Timeline& timeline = b.scene().timeline;
  timeline.camera.eye_track = drifting(timeline.time, timeline.camera.eye, {6, -4, -8});
  b.scene().image.channels = {Channel::velocity, Channel::uv, Channel::object_id};
  return b.scene();
}

TEST_F(ChannelValues, WarpedByVelocityAPixelLandsOnThePointThatItShows) {
  for (const Projection& projection : {Projection(Perspective{}), Projection(Orthographic{-2, 2, -1.5, 1.5, -5, 20})}) {
    const Scene scene = warped_scene(projection);
    const FrameBuffer now = by_reference(scene, 2), next = by_reference(scene, 3);
    int compared = 0;
    double farthest = 0;
    for_each_pixel(now, [&](int x, int y) {
      const std::uint32_t object = id(now, Channel::object_id, x, y);
      if (object == 0) return;
      // From pixel centres: the four around the place, all of which show the object.
      const double to_x = x + double{value(now, Channel::velocity, 0, x, y)},
                   to_y = y - double{value(now, Channel::velocity, 1, x, y)};
      const int left = static_cast<int>(std::floor(to_x)), top = static_cast<int>(std::floor(to_y));
      if (left < 0 || top < 0 || left + 1 >= next.width() || top + 1 >= next.height()) return;
      for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
        if (id(next, Channel::object_id, left + dx, top + dy) != object) return;
      const auto uv = [](const FrameBuffer& frame, int px, int py) -> glm::dvec2 {
        return {value(frame, Channel::uv, 0, px, py), value(frame, Channel::uv, 1, px, py)};
      };
      const glm::dvec2 a = uv(next, left, top), b = uv(next, left + 1, top), c = uv(next, left, top + 1),
                       d = uv(next, left + 1, top + 1);
      const double s = to_x - left, t = to_y - top;
      const glm::dvec2 there = (1 - t) * ((1 - s) * a + s * b) + t * ((1 - s) * c + s * d);
      const glm::dvec2 off = uv(now, x, y) - there, across = b - a, down = c - a;
      const double determinant = across.x * down.y - across.y * down.x;
      const double off_x = (off.x * down.y - off.y * down.x) / determinant,
                   off_y = (across.x * off.y - across.y * off.x) / determinant;
      farthest = std::max({farthest, std::abs(off_x), std::abs(off_y)});
      ++compared;
    });
    // Each frame snaps corners by half of 1/256 pixel at most: together 1/256. What is left of the bound is for the
    // bilinear mean between pixels, of coordinates that are quotients.
    EXPECT_LT(farthest, 0.01);
    EXPECT_GT(compared, 2000);
    RecordProperty("farthest", std::to_string(farthest));
  }
}

}  // namespace
}  // namespace morphcl::test
