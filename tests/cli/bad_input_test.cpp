// Shots and models that are wrong: the exit code, one line with the file and the place, and nothing written.
#include <limits>

#include "tests/cli/cube_shot.hpp"
#include "tests/cli/expectations.hpp"
#include "tests/cli/gltf_sample.hpp"
#include "tests/cli/tool_test.hpp"

namespace morphcl::cli_test {
namespace {

constexpr int usage = 2, bad_input = 65, cannot_read = 66;

class BadInput : public ToolTest {
 protected:
  // Renders a planted file with the reference renderer; the tool must end at once, however large the claims of the
  // file.
  void expect_refused(const std::string& scene, int code, const std::string& part) {
    const std::set<std::string> before = files();
    const ToolResult result = run_tool({"render", path(scene), "--device", "reference", "--size", "16x16"},
                                       {.folder = folder_, .limit = std::chrono::seconds(30)});
    expect_one_line_error(result, code, part);
    EXPECT_EQ(files(), before);
  }

  void expect_shot_refused(const std::string& from, const std::string& to, const std::string& part) {
    plant("shot.toml", replaced(cube_shot(), from, to));
    expect_refused("shot.toml", bad_input, "shot.toml:");
    expect_refused("shot.toml", bad_input, part);
  }

  void expect_gltf_refused(const GltfSample& sample, const std::string& part) {
    plant("data.bin", sample.buffer);
    plant("model.gltf", sample.json.dump());
    expect_refused("model.gltf", bad_input, "model.gltf: ");
    expect_refused("model.gltf", bad_input, part);
  }
};

TEST_F(BadInput, TheSamplesThemselvesAreFine) {
  plant("shot.toml", cube_shot());
  plant("data.bin", GltfSample().buffer);
  plant("model.gltf", GltfSample().json.dump());
  for (const char* scene : {"shot.toml", "model.gltf"}) {
    const ToolResult result = run_tool(
        {"render", path(scene), "--device", "reference", "--size", "16x16", "--frames", "0"}, {.folder = folder_});
    EXPECT_EQ(result.code, 0) << result.err;
  }
  EXPECT_EQ(files_ending_in(".exr"), 2u);
}

TEST_F(BadInput, MissingShot) { expect_refused("none.toml", cannot_read, "none.toml"); }
TEST_F(BadInput, MissingModel) { expect_refused("none.glb", cannot_read, "none.glb"); }
TEST_F(BadInput, FolderInsteadOfAShot) {
  std::filesystem::create_directory(folder_ / "shot.toml");
  expect_refused("shot.toml", cannot_read, "shot.toml");
}
TEST_F(BadInput, UnknownExtension) {
  plant("shot.txt", cube_shot());
  expect_one_line_error(run_tool({"plan", path("shot.txt")}), usage, ".toml");
}
TEST_F(BadInput, EmptyShot) {
  plant("shot.toml", "");
  expect_refused("shot.toml", bad_input, "shot.toml");
}

TEST_F(BadInput, TomlSyntax) { expect_shot_refused("fps = 25", "fps = = 25", "shot.toml:6:"); }
TEST_F(BadInput, UnknownKey) { expect_shot_refused("fps = 25", "fsp = 25", "shot.toml:6:"); }
TEST_F(BadInput, WrongType) { expect_shot_refused("fps = 25", "fps = \"fast\"", "shot.toml:6:"); }
TEST_F(BadInput, ImageSizeZero) { expect_shot_refused("[32, 18]", "[0, 18]", "shot.toml:2:"); }
TEST_F(BadInput, ImageSizeAbsurd) { expect_shot_refused("[32, 18]", "[32, 1000000000000]", "shot.toml:2:"); }
TEST_F(BadInput, NearBeyondFar) { expect_shot_refused("near = 0.1", "near = 100.0", "shot.toml:"); }
TEST_F(BadInput, FramesBackwards) { expect_shot_refused("\"0-4\"", "\"5-1\"", "5-1"); }
TEST_F(BadInput, FramesEmpty) { expect_shot_refused("\"0-4\"", "\"\"", "shot.toml:5:"); }
TEST_F(BadInput, FramesColon) { expect_shot_refused("\"0-4\"", "\"0:4\"", ":"); }
TEST_F(BadInput, NotANumber) { expect_shot_refused("eye = [3.0", "eye = [nan", "shot.toml:"); }
TEST_F(BadInput, UnknownMesh) { expect_shot_refused("\"cube\"", "\"cub\"", "cub"); }
TEST_F(BadInput, MissingMeshFile) {
  plant("shot.toml", replaced(cube_shot(), "\"cube\"", "\"none.obj\""));
  const ToolResult result = run_tool({"plan", path("shot.toml")});
  EXPECT_TRUE(result.code == bad_input || result.code == cannot_read) << result.code;
  expect_one_line_error(result, result.code, "none.obj");
}
TEST_F(BadInput, NameUsedTwice) {
  plant("shot.toml", cube_shot() + "[[object]]\nname = \"solid\"\nmesh = \"cube\"\n");
  expect_refused("shot.toml", bad_input, "solid");
}
TEST_F(BadInput, MeshOutsideTheFolderOfTheShot) {
  plant("deep/shot.toml", replaced(cube_shot(), "\"cube\"", "\"../triangle.obj\""));
  plant("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  expect_refused("deep/shot.toml", bad_input, "--allow-outside");
  EXPECT_EQ(run_tool({"plan", path("deep/shot.toml"), "--allow-outside"}).code, 0);
}

TEST_F(BadInput, GltfTruncated) {
  plant("data.bin", GltfSample().buffer);
  const std::string text = GltfSample().json.dump();
  plant("model.gltf", text.substr(0, text.size() / 2));
  expect_refused("model.gltf", bad_input, "model.gltf");
}
TEST_F(BadInput, GltfBufferTruncated) {
  GltfSample sample;
  sample.buffer.resize(50);
  expect_gltf_refused(sample, "buffers[0]");
}
TEST_F(BadInput, GltfBufferMissing) {
  plant("model.gltf", GltfSample().json.dump());
  expect_refused("model.gltf", cannot_read, "data.bin");
}
TEST_F(BadInput, GlbTruncated) {
  plant("model.glb", std::string("glTF\2\0\0\0\377\0\0\0\377\0\0\0JSON{", 21));
  expect_refused("model.glb", bad_input, "model.glb");
}
TEST_F(BadInput, GltfAccessorOutOfBounds) {
  GltfSample sample;
  sample.json["accessors"][1]["count"] = 4;
  expect_gltf_refused(sample, "accessors[1]");
}
TEST_F(BadInput, GltfIndexOutOfRange) {
  GltfSample sample;
  sample.set_index(2, 3);
  expect_gltf_refused(sample, "3");
}
TEST_F(BadInput, GltfPositionNan) {
  GltfSample sample;
  sample.set_position(4, std::numeric_limits<float>::quiet_NaN());
  expect_gltf_refused(sample, "1");
}
TEST_F(BadInput, GltfPositionInfinite) {
  GltfSample sample;
  sample.set_position(8, std::numeric_limits<float>::infinity());
  expect_gltf_refused(sample, "2");
}
TEST_F(BadInput, GltfTargetCountsDiffer) {
  GltfSample sample;
  auto& primitives = sample.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  primitives[1]["targets"].push_back({{"POSITION", 2}});
  expect_gltf_refused(sample, "meshes[0]");
}
TEST_F(BadInput, GltfNodeCycle) {
  GltfSample sample;
  sample.json["nodes"][0]["children"] = {1};
  sample.json["nodes"].push_back({{"children", {0}}});
  expect_gltf_refused(sample, "nodes[");
}
TEST_F(BadInput, GltfBufferOutsideTheFolder) {
  GltfSample sample;
  sample.json["buffers"][0]["uri"] = "../data.bin";
  plant("data.bin", sample.buffer);
  plant("deep/model.gltf", sample.json.dump());
  expect_refused("deep/model.gltf", bad_input, "../data.bin");
  EXPECT_EQ(run_tool({"plan", path("deep/model.gltf"), "--allow-outside"}).code, 0);
}
TEST_F(BadInput, GltfClaimsTwoToTheFortyVertices) {
  GltfSample sample;
  sample.json["accessors"][1]["count"] = 1LL << 40;
  expect_gltf_refused(sample, "accessors[1]");
}
TEST_F(BadInput, GltfSparseAccessorClaimsTwoToTheFortyVertices) {
  GltfSample sample;
  sample.json["accessors"][1].erase("bufferView");
  sample.json["accessors"][1]["count"] = 1LL << 40;
  expect_gltf_refused(sample, "accessors[1]");
}
TEST_F(BadInput, GltfUnknownRequiredExtension) {
  GltfSample sample;
  sample.json["extensionsUsed"] = sample.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  expect_gltf_refused(sample, "KHR_draco_mesh_compression");
}

TEST_F(BadInput, ObjIndexOutOfRange) {
  plant("model.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  expect_refused("model.obj", bad_input, "model.obj:4");
}
TEST_F(BadInput, ObjTargetsWhoseFacesDiffer) {
  plant("neutral.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  plant("smile.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 3 2\n");
  plant("shot.toml", replaced(cube_shot(), "\"cube\"", "\"neutral.obj\"\ntargets = [\"smile.obj\"]"));
  expect_refused("shot.toml", bad_input, "smile.obj");
}

}  // namespace
}  // namespace morphcl::cli_test
