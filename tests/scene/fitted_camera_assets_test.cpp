// Real models fill the picture, below the folder that MORPHCL_ASSETS names.
#include <gtest/gtest.h>

#include "morphcl/scene.hpp"
#include "tests/scene/outline.hpp"
#include "tests/support/test_data.hpp"

namespace morphcl {
namespace {

TEST(FittedCameraOfAssets, FillsThePicture) {
  for (const char* name : {"gltf/Fox/Fox.glb", "gltf/AnimatedMorphSphere/glTF/AnimatedMorphSphere.gltf"}) {
    SCOPED_TRACE(name);
    LoadOptions options;
    options.allow_outside = true;
    const Scene scene = load_scene(test_support::test_data("MORPHCL_ASSETS") / name, options);
    ASSERT_LT(scene.timeline.camera.node, 0);
    test::expect_fills(scene);
  }
}

}  // namespace
}  // namespace morphcl
