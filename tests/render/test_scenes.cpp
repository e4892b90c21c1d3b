#include "tests/render/test_scenes.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "morphcl/solids.hpp"
#include "morphcl/transform.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/support/random.hpp"

namespace morphcl::test {

namespace {

Mesh with_vertex_colors(Mesh mesh) {
  for (const glm::vec3& p : mesh.positions)
    mesh.colors.push_back(glm::vec4(0.5f + 0.5f * p.x, 0.5f + 0.5f * p.y, 0.5f - 0.5f * p.z, 1));
  for (glm::vec4& color : mesh.colors) color = glm::clamp(color, 0.0f, 1.0f);
  return mesh;
}

Mesh quad(float left, float right, float bottom, float top, float z) {
  Mesh mesh;
  mesh.positions = {{left, bottom, z}, {right, bottom, z}, {right, top, z}, {left, top, z}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

Scene sphere_to_cube(int w, int h) {
  SceneBuilder b(w, h);
  b.add(make_sphere_to_cube({256, 128}), Shading::smooth);
  return b.look({1.6, 1.3, 2.8}).weight(0, 0.37).scene();
}

Scene behind_the_eye(int w, int h) {
  SceneBuilder b(w, h);
  b.add(make_torus({48, 24}), Shading::smooth, place({0, 0, 0}, 2.0), {0.2, 0.6, 0.9, 1}, true);
  return b.look({1.4, 0.05, 0}, {0, 0, 1.4}).point_light({0, 1, 0}, {1, 1, 1}, true).scene();
}

Scene across_the_near_plane(int w, int h) {
  SceneBuilder b(w, h);
  b.add(with_vertex_colors(make_cube()), Shading::smooth, place({0, 0, 0}), {1, 1, 1, 1}, true);
  b.add(make_grid({6, 6}), Shading::flat, place({0, -0.4, 0}, 3.0), {0.4, 0.8, 0.4, 1}, true);
  return b.look({0.9, 0.1, 0.8}, {-1, 0, -1}).project(Perspective{70, 0.3, 50}).scene();
}

Scene far_outside_the_view(int w, int h) {
  SceneBuilder b(w, h);
  b.add(with_vertex_colors(make_grid({1, 1})), Shading::smooth, place({0, -1, 0}, 1e6));
  b.add(make_grid({3, 3}), Shading::flat, place({0, 40, 0}, 1e5), {0.3, 0.3, 0.9, 1}, true);
  return b.look({0, 0, 3}).project(Perspective{60, 0.1, std::numeric_limits<double>::infinity()}).scene();
}

Scene edge_on(int w, int h) {
  SceneBuilder b(w, h);
  b.add(make_grid({5, 5}), Shading::smooth, place({0, 0, 0}), {1, 0.5, 0, 1}, true);
  b.add(make_grid({5, 5}), Shading::flat, place({0, 1e-5, 0}, 0.8), {0, 0.5, 1, 1}, true);
  b.add(quad(-0.002f, 0.002f, -2, 2, 0), Shading::unlit);
  return b.look({0, 0, 3}).scene();
}

Scene coincident(int w, int h) {
  SceneBuilder b(w, h);
  b.add(make_cube(), Shading::unlit, place({0, 0, 0}), {1, 0, 0, 1});
  b.add(make_cube(), Shading::unlit, place({0, 0, 0}), {0, 1, 0, 1});
  b.add(quad(-1, 1, -1, 1, 1), Shading::flat, place({0, 0, 0}), {0, 0, 1, 1});
  // Half of a coincident pair reaches behind the eye and is clipped; the earlier one must win all the same.
  b.add(quad(-50, 50, -50, 50, -2), Shading::unlit, place({0, 0, 0}), {1, 1, 0, 1}, true);
  b.add(quad(-50, 50, -50, 50, -2), Shading::unlit, place({0, 0, 0}), {0, 1, 1, 1}, true);
  return b.look({1.5, 1.1, 3}).scene();
}

Scene sub_pixel(int w, int h) {
  SceneBuilder b(w, h);
  b.add(make_sphere({200, 100}), Shading::smooth, place({0, 0, 0}, 0.3));
  b.add(make_cube(), Shading::flat, place({1, 0, 0}, 1e-4));
  return b.look({0, 0, 8}).scene();
}

Scene mirrored_and_two_sided(int w, int h) {
  SceneBuilder b(w, h);
  glm::dmat4 mirror(1.0);
  mirror[0][0] = -1.0;
  mirror[3][0] = -0.8;
  b.add(make_teapot({6, 6}), Shading::smooth, place({0.8, 0, 0}, 0.6));
  b.add(make_teapot({6, 6}), Shading::smooth, mirror * place({0.4, 0.6, 0}, 0.5), {0.3, 0.8, 0.4, 1}, true);
  b.add(make_teapot({4, 4}), Shading::flat, mirror * place({0.4, -0.6, 0}, 0.5), {0.3, 0.4, 0.9, 1}, true);
  b.add(make_grid({4, 4}), Shading::flat, mirror * place({-0.8, -0.9, 0}, 1.5));
  return b.look({0.5, 1.5, 4})
      .point_light({2, 2, 2}, {2, 1, 0.5}, true)
      .point_light({-2, 1, 1}, {0.1, 0.2, 0.9}, false)
      .scene();
}

// Their faces' normals are lit at each pixel: all ways to be wound and seen, cut by the near plane, with colours.
Scene faces_under_point_lights(int w, int h) {
  SceneBuilder b(w, h);
  const auto without_normals = [](Mesh mesh) {
    mesh.normals.clear();
    for (MorphTarget& target : mesh.targets) target.normals.clear();
    return mesh;
  };
  glm::dmat4 mirror(1.0);
  mirror[0][0] = -1.0;
  b.add(without_normals(make_sphere({12, 6})), Shading::smooth, place({0.8, 0, 0}, 0.6));
  b.add(without_normals(make_torus({8, 6})), Shading::smooth, mirror * place({0.8, 0.6, 0}, 0.5), {0.3, 0.8, 0.4, 1},
        true);
  b.add(without_normals(with_vertex_colors(make_cube())), Shading::smooth, mirror * place({0.8, -0.6, 0}, 0.4));
  b.add(without_normals(quad(-9, 9, -9, 9, -1)), Shading::smooth, place({0, 0, 0}), {0.9, 0.9, 0.9, 1}, true);
  b.add(without_normals(quad(-1, 9, -9, 9, 0)), Shading::smooth,
        glm::dmat4{{0, 0, 1, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}, {-1, 0, 0, 1}});
  b.add(make_cube(), Shading::flat, place({0, 0.9, 0}, 0.3));
  return b.look({0.5, 0.5, 4})
      .point_light({1, 2, 2}, {2, 1, 0.5}, true)
      .point_light({-2, 1, 1}, {0.1, 0.2, 0.9}, false)
      .scene();
}

Scene lines(int w, int h) {
  SceneBuilder b(w, h);
  b.add(make_cube(), Shading::wireframe, place({0, 0, 0}), {1, 1, 1, 1});
  b.add(make_sphere({12, 8}), Shading::wireframe, place({0.4, 0.2, 0.9}), {1, 1, 0, 1});
  b.add(make_grid({10, 10}), Shading::wireframe, place({0, -1, 0}, 30), {0, 1, 0, 1});
  b.add(make_cube(), Shading::flat, place({0.3, 0.1, -0.5}, 0.5));
  return b.look({1.2, 0.6, 1.9}).scene();
}

Scene orthographic(int w, int h) {
  SceneBuilder b(w, h);
  b.add(make_torus({32, 16}), Shading::smooth);
  b.add(with_vertex_colors(make_cube()), Shading::flat, place({0.6, 0.2, 4.5}));
  b.add(make_cube(), Shading::wireframe, place({-0.6, 0.2, 4.0}));
  b.add(make_grid({4, 4}), Shading::smooth, place({0, -0.5, 0}, 300), {0.9, 0.2, 0.2, 1}, true);
  return b.look({0.8, 1.2, 3})
      .project(Orthographic{-1.6, 1.6, -1, 1, -1.5, 20})
      .point_light({1, 2, 1}, {1, 1, 1}, true)
      .scene();
}

// Sheared parallel views: what a line of sight leads to is not what lies straight ahead.
Scene oblique(int w, int h) {
  SceneBuilder b(w, h);
  b.add(make_torus({32, 16}), Shading::smooth);
  b.add(with_vertex_colors(make_cube()), Shading::flat, place({0.6, 0.2, 1.0}, 0.4));
  b.add(make_cube(), Shading::wireframe, place({-0.6, 0.2, 0.5}));
  b.add(make_grid({4, 4}), Shading::smooth, place({0, -0.5, 0}, 300), {0.9, 0.2, 0.2, 1}, true);
  // Seen from in front along the view axis, from behind along the lines of sight, and the other way round.
  glm::dmat4 turned = place({-1.2, 0.2, 0.2}, 0.5);
  for (const double lean : {0.8, -0.8}) {
    turned[0][2] = lean;
    turned[3][1] -= 0.3;
    b.add(quad(-1, 1, -0.7f, 0.6f, 0), Shading::flat, turned, {0.2, 0.6, 0.9, 1}, true);
  }
  return b.look({0, 0, 3})
      .project(Oblique{-1.6, 1.6, -1, 1, -1.5, 20, {0.8, -0.6}, 3})
      .point_light({1, 2, 1}, {1, 1, 1}, true)
      .scene();
}

// A board that is narrower than the image, and lengths over twelve decades.
Scene central_over_twelve_decades(int w, int h) {
  SceneBuilder b(w, h);
  for (int decade = -5; decade <= 5; ++decade) {
    const double size = std::pow(10.0, decade);
    b.add(make_cube(), decade % 2 ? Shading::flat : Shading::smooth,
          place({0.3 * decade * size, 0.1 * decade * size, -3 * size}, 0.2 * size));
  }
  return b.look({0, 0, 0}, {0, 0, -1}).project(CentralProjection{-2, 1, -1, 1, 1e-6, 1e6, 2}).scene();
}

Scene horizontal_perspective(int w, int h) {
  SceneBuilder b(w, h);
  b.add(make_torus({32, 16}), Shading::smooth);
  b.add(make_grid({7, 7}), Shading::flat, place({0, -0.3, 0}, 10));
  return b.look({0.8, 0.5, 2}).project(HorizontalPerspective{80, 0.2, std::numeric_limits<double>::infinity()}).scene();
}

Scene far_plane_cuts(int w, int h) {
  SceneBuilder b(w, h);
  b.add(make_grid({7, 7}), Shading::smooth, place({0, -0.3, 0}, 10));
  return b.look({0, 0.5, 3}).project(Frustum{-0.1, 0.3, -0.05, 0.1, 0.2, 4.0}).scene();
}

Scene many_layers(int w, int h) {
  SceneBuilder b(w, h);
  for (int i = 0; i < 64; ++i) {
    const double depth = -2.0 - 0.5 * (i * 37 % 64);
    glm::dmat4 transform = place({0.02 * i, 0.01 * i, depth}, 1.2 * -depth / (1 + i % 5));
    transform[0][2] = 0.1 * (i % 3);
    b.add(quad(-1, 1, -0.7f, 0.6f, 0), i % 2 ? Shading::smooth : Shading::unlit, transform,
          {0.1 + i / 80.0, 0.5, 1 - i / 80.0, 1});
  }
  return b.look({0, 0, 0}, {0, 0, -1}).scene();
}

Scene many_targets(int w, int h) {
  SceneBuilder b(w, h);
  Mesh mesh = with_vertex_colors(make_sphere({24, 12}));
  std::mt19937 random(7);
  std::uniform_real_distribution<float> delta(-0.2f, 0.2f);
  for (int t = 0; t < 300; ++t) {
    MorphTarget target;
    target.name = "target" + std::to_string(t);
    const bool moves = t % 3 != 0, turns = t % 4 == 0, colors = t % 5 == 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      if (moves) target.positions.push_back({delta(random), delta(random), delta(random)});
      if (turns) target.normals.push_back({delta(random), delta(random), delta(random)});
      if (colors) target.colors.push_back({delta(random), delta(random), delta(random), 0});
    }
    mesh.targets.push_back(std::move(target));
  }
  b.add(mesh, Shading::smooth);
  for (int t = 0; t < 300; t += 7) b.weight(0, t % 2 ? -0.5 : 1.7, t);
  return b.look({0, 1, 4}).scene();
}

Scene opposed_normals(int w, int h) {
  SceneBuilder b(w, h);
  Mesh mesh = make_sphere({32, 16});
  MorphTarget target;
  target.name = "inside out";
  target.form = TargetForm::absolute;
  for (const glm::vec3& n : mesh.normals) target.normals.push_back(-n);
  mesh.targets.push_back(target);
  b.add(mesh, Shading::smooth);
  return b.look({0, 0, 3}).weight(0, 0.5).scene();
}

Scene without_lights(int w, int h) {
  SceneBuilder b(w, h);
  b.add(with_vertex_colors(make_cube()), Shading::smooth);
  b.add(make_torus({16, 8}), Shading::flat, place({0, 1, 0}));
  b.no_lights().scene().timeline.ambient = {0.3, 0.5, 0.7};
  return b.look({2, 2, 3}).scene();
}

Scene many_objects(int w, int h) {
  SceneBuilder b(w, h);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> at(-8, 8);
  for (int i = 0; i < 400; ++i) {
    CompositeTransform transform;
    transform.scale(glm::dvec3(0.1 + 0.02 * (i % 10)))
        .rotate_about_axis({0, 0, 0}, {1, at(random), at(random)}, 10.0 * i);
    transform.translate({at(random), at(random), at(random)});
    b.add(i % 3 ? make_cube() : make_pyramid_to_cube(), i % 4 ? Shading::flat : Shading::smooth,
          i % 3 ? transform.matrix() : transform.matrix() * place({-1, -1, -0.65}, 0.01),
          {0.2 + 0.001 * i, 0.5, 0.9, 1});
  }
  return b.look({0, 0, 0.5}, {1, 0.2, -1}).scene();
}

Scene degenerate(int w, int h) {
  SceneBuilder b(w, h);
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}, {1e30f, 0, 0}, {0, 1e30f, 0}, {0, 0, -1e30f}};
  mesh.triangles = {{0, 1, 2}, {0, 0, 0}, {0, 3, 1}, {0, 4, 5}, {4, 5, 6}, {0, 1, 6}};
  b.add(mesh, Shading::flat, glm::dmat4(1.0), {1, 1, 1, 1}, true);
  b.add(make_cube(), Shading::smooth, place({0, 0, -5}, 0.0));
  b.add(make_cube(), Shading::wireframe, place({0, 0, -5}, 0.0));
  return b.look({0.3, 0.4, 3}).scene();
}

Scene before_a_background(int w, int h) {
  Scene scene = sphere_to_cube(w, h);
  scene.image.background = Background{{0.1, 0.3, 0.9}, {0.7, 0.6, 0.5}};
  return scene;
}

}  // namespace

Scene pyramid_to_cube(int w, int h) {
  SceneBuilder b(w, h);
  b.add(make_pyramid_to_cube(), Shading::flat, place({-2, -2, -1.3}, 0.02));
  Timeline& timeline = b.look({1.5, -3.0, 2.0}).scene().timeline;
  timeline.camera.up = {0, 0, 1};
  const auto ticks = [&](std::int64_t frame) { return timeline.time.frame_ticks(frame); };
  b.scene().objects[0].morph.tracks.push_back(
      {0,
       Track({Interpolation::linear, 1, false, timeline.time.ticks_per_second(), {ticks(0), ticks(100)}, {0.0, 1.0}})});
  timeline.nodes[0].rotation_track = Track({Interpolation::linear,
                                            4,
                                            true,
                                            timeline.time.ticks_per_second(),
                                            {ticks(0), ticks(100)},
                                            {0, 0, 0, 1, 0, 0, 0.6, 0.8}});
  b.scene().frames = {{0, 100, 1}};
  return b.scene();
}

Mesh needles(std::size_t count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> along(-1, 1), thickness(-0.002f, 0.002f);
  Mesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    for (int corner = 0; corner < 3; ++corner)
      mesh.positions.push_back({along(random), thickness(random), along(random) * 3});
    const auto first = static_cast<std::uint32_t>(3 * i);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

Scene triangle_soup(unsigned seed, int triangles, int w, int h) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(-1, 1);
  const auto vector = [&] {  // z first: bounds on the soups' thinnest triangles were found for these soups
    const float z = unit(random), y = unit(random), x = unit(random);
    return glm::vec3(x, y, z);
  };
  Mesh mesh;
  for (int t = 0; t < triangles; ++t) {
    const float size = std::exp2(-8.0f * std::abs(unit(random))), reach = 4.0f * (t % 17 == 0 ? 100.0f : 1.0f);
    const glm::vec3 middle = reach * vector();
    for (int i = 0; i < 3; ++i) {
      mesh.positions.push_back(middle + reach * size * vector());
      const float normal_y = unit(random), normal_x = unit(random);
      mesh.normals.push_back(glm::normalize(glm::vec3(normal_x, normal_y, 1.5f)));
      mesh.colors.push_back(0.5f + 0.5f * glm::vec4(vector(), 1));
    }
    const auto first = static_cast<unsigned>(3 * t);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  SceneBuilder b(w, h);
  b.add(mesh, seed % 2 ? Shading::smooth : Shading::flat, glm::dmat4(1.0), {1, 1, 1, 1}, seed % 3 != 0);
  b.point_light({0.5, 1, 0.2}, {1, 0.8, 0.6}, seed % 2 == 0);
  if (seed % 4 == 3) b.project(Orthographic{-2, 2, -1.5, 1.5, -1, 6});
  return b.look({0.1, 0.2, 0.9}).scene();
}

std::vector<TestScene> test_scenes(int w, int h, int more_soup) {
  std::vector<TestScene> scenes = {
      {"pyramid to cube", pyramid_to_cube(w, h), {0, 1, 37, 50, 99, 100}},
      {"sphere to cube", sphere_to_cube(w, h), {0}},
      {"behind the eye", behind_the_eye(w, h), {0}},
      {"across the near plane", across_the_near_plane(w, h), {0}},
      {"far outside the view", far_outside_the_view(w, h), {0}},
      {"edge-on", edge_on(w, h), {0}},
      {"coincident", coincident(w, h), {0}},
      {"sub-pixel", sub_pixel(w, h), {0}},
      {"mirrored and two-sided", mirrored_and_two_sided(w, h), {0}},
      {"faces under point lights", faces_under_point_lights(w, h), {0}},
      {"lines", lines(w, h), {0}},
      {"orthographic", orthographic(w, h), {0}},
      {"oblique", oblique(w, h), {0}},
      {"central over twelve decades", central_over_twelve_decades(w, h), {0}},
      {"horizontal perspective", horizontal_perspective(w, h), {0}},
      {"far plane cuts", far_plane_cuts(w, h), {0}},
      {"many layers", many_layers(w, h), {0}},
      {"many targets", many_targets(w, h), {0}},
      {"opposed normals", opposed_normals(w, h), {0}},
      {"without lights", without_lights(w, h), {0}},
      {"many objects", many_objects(w, h), {0}},
      {"degenerate", degenerate(w, h), {0}},
      {"nothing", SceneBuilder(w, h).scene(), {0}},
      {"before a background", before_a_background(w, h), {0}},
  };
  for (const unsigned seed : {1u, 2u, 3u, 4u, 7u})
    scenes.push_back({"soup " + std::to_string(seed), triangle_soup(seed, seed == 1 ? 3000 : more_soup, w, h), {0}});
  return scenes;
}

Scene transparent(Scene scene, unsigned seed) {
  test_support::Random random(seed);
  for (Object& object : scene.objects) {
    if (random.in(0, 1) < 0.5) object.material.base_color.a = random.in(0.1, 1);
    Mesh& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
    if (random.in(0, 1) < 0.3) {
      if (mesh.colors.empty()) mesh.colors.assign(mesh.positions.size(), glm::vec4(1));
      for (glm::vec4& color : mesh.colors) color.a = static_cast<float>(random.in(0, 1));
      if (random.in(0, 1) < 0.5) object.material.alpha_mode = AlphaMode::mask;
    }
  }
  return scene;
}

}  // namespace morphcl::test
