// Models made by others, below the folder that MORPHCL_ASSETS names: every frame, device against reference.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "host/render/frame/frame_plan.hpp"
#include "morphcl/job.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/scene.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/shared_session.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_data.hpp"

namespace morphcl::test {
namespace {

std::string asset(const std::string& name) { return test_support::test_data("MORPHCL_ASSETS") / name; }

void expect_parity_of_every_frame(const std::string& path) {
  LoadOptions options;
  options.allow_outside = true;
  options.width = 240;
  options.height = 135;
  const Scene scene = load_scene(path, options);
  const Planner planner(scene);
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  for (const std::int64_t frame : frame_numbers(scene.frames)) {
    const Plan plan = planner.plan(frame);
    FrameBuffer expected(plan->width, plan->height, plan->channels), actual(plan->width, plan->height, plan->channels);
    reference->render(plan, expected);
    device->render(plan, actual);
    ASSERT_TRUE(same_pixels(expected, actual)) << "frame " << frame;
    EXPECT_GT(covered_pixels(expected), 100u) << "frame " << frame;
  }
}

class Model : public ::testing::TestWithParam<const char*> {};

TEST_P(Model, EveryFrameHasTheReferencesBits) { expect_parity_of_every_frame(asset(GetParam())); }

INSTANTIATE_TEST_SUITE_P(
    AssetParity, Model,
    ::testing::Values("gltf/AnimatedMorphCube/glTF/AnimatedMorphCube.gltf",
                      "gltf/AnimatedMorphSphere/glTF/AnimatedMorphSphere.gltf",
                      "gltf/SimpleMorph/glTF/SimpleMorph.gltf", "gltf/sparse_morph/singleBlendshapeCube_sparse.glb",
                      "gltf/asset_generator/Node_NegativeScale/Node_NegativeScale_01.gltf",
                      "gltf/asset_generator/Mesh_PrimitiveVertexColor/Mesh_PrimitiveVertexColor_00.gltf",
                      "obj/spot.obj"));

TEST(AssetParity, AFaceWithTwoTargets) {
  const test_support::TemporaryFolder folder;
  const std::string shot = (folder / "face.toml").string();
  std::ofstream(shot) << "[frames]\nrange = \"0-10\"\n[[object]]\nname = \"face\"\nmesh = \""
                      << asset("obj_face/generic_neutral_mesh.obj") << "\"\ntargets = [\""
                      << asset("obj_face/jawOpen.obj") << "\", \"" << asset("obj_face/browInnerUp_L.obj")
                      << "\"]\n[[object.track]]\ntarget = \"morph.jawOpen\"\nkeys = [[0, 0.0], [10, 1.0]]\n"
                      << "[[object.track]]\ntarget = \"morph.browInnerUp_L\"\nkeys = [[0, 1.0], [10, 0.0]]\n";
  expect_parity_of_every_frame(shot);
}

}  // namespace
}  // namespace morphcl::test
