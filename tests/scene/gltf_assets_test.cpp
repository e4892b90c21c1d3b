// Real glTF files and the files of the format's own validator, below the folder that MORPHCL_ASSETS names. Without it
// the program holds no test.
#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "host/scene/gltf/gltf_import.hpp"
#include "morphcl/error.hpp"
#include "morphcl/mesh.hpp"
#include "tests/scene/gltf_comparison.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::test {
namespace {

namespace fs = std::filesystem;

// All .gltf and .glb files below a folder of the assets, sorted; none where there are no assets.
std::vector<std::string> files_below(const std::string& folder) {
  std::vector<std::string> files;
  const char* assets = std::getenv("MORPHCL_ASSETS");
  if (!assets) return files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(assets) / folder))
    if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  const fs::path path = info.param;
  std::string name = path.parent_path().filename().string() + "_" + path.filename().string();
  std::replace_if(name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return std::to_string(info.index) + "_" + name;
}

class ValidatorFile : public testing::TestWithParam<std::string> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ValidatorFile);

// Free of errors in the report, and still refused: each for a reason that the report does not count.
const std::set<std::string> refused_though_valid = {
    "accessor/unknown_type.gltf",    // a warning there: the type is unknown
    "buffer/non_relative_uri.gltf",  // a buffer on the network
};

// Errors that are about what the picture does not need, or that can be read in only one way.
const std::set<std::string> harmless_errors = {
    "EMPTY_ENTITY",
    "ACCESSOR_NORMALIZED_INVALID",
    "ANIMATION_DUPLICATE_TARGETS",  // the first one wins, with a warning
    "ANIMATION_SAMPLER_INPUT_ACCESSOR_WITHOUT_BOUNDS",
    "MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS",
    "BUFFER_DATA_URI_MIME_TYPE_INVALID",
    "BUFFER_MISSING_GLB_DATA",  // no accessor needs the data
    "BUFFER_VIEW_TARGET_OVERRIDE",
    "MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_UNSIGNED_INT",  // of an attribute that is not drawn
    "MESH_PRIMITIVE_ACCESSOR_UNALIGNED",
    "MESH_PRIMITIVE_ACCESSOR_WITHOUT_BYTESTRIDE",
    "MESH_PRIMITIVE_INDICES_ACCESSOR_WITH_BYTESTRIDE",
    "MESH_PRIMITIVE_INVALID_ATTRIBUTE",
    "MESH_PRIMITIVE_INDEXED_SEMANTIC_CONTINUITY",
    "MESH_PRIMITIVE_MORPH_TARGET_NO_BASE_ACCESSOR",  // of an attribute that is not drawn
    "MESH_PRIMITIVE_JOINTS_WEIGHTS_MISMATCH",
    "MESH_PRIMITIVE_TOO_FEW_TEXCOORDS",
    "ROTATION_NON_UNIT",  // scaled to unit length, with a warning
    "UNSATISFIED_DEPENDENCY",
};

TEST_P(ValidatorFile, ImportsWhenFreeOfErrorsAndNeverCrashes) {
  const fs::path path = GetParam();
  const std::string name = (path.parent_path().filename() / path.filename()).string();
  std::ifstream stream(path.string() + ".report.json");
  ASSERT_TRUE(stream) << "no report beside " << path;
  std::set<std::string> errors;
  const nlohmann::json report = nlohmann::json::parse(stream);
  for (const auto& message : report["issues"]["messages"])
    if (message["severity"] == 0) errors.insert(message["code"].get<std::string>());

  std::string refusal;
  try {
    const ImportedModel model = import_gltf(path.string(), TimeBase{});
    for (const Mesh& mesh : model.meshes) validate(mesh);
  } catch (const Error& error) {
    refusal = error.what();
    EXPECT_EQ(refusal.find('\n'), std::string::npos) << refusal;
    EXPECT_NE(refusal.find(path.parent_path().string()), std::string::npos) << refusal;
  }
  if (errors.empty()) {
    EXPECT_EQ(refusal.empty(), !refused_though_valid.contains(name)) << refusal;
    return;
  }
  const bool of_skins = path.parent_path().filename() == "skin" || errors.contains("NODE_SKIN_WITH_NON_SKINNED_MESH");
  const bool of_containers = name == "glb/bom.glb" || name == "glb/unaligned_chunk.glb" ||
                             name == "buffer/zero_bytelength.gltf" || name == "buffer/invalid_uri_data.gltf";
  const bool matters = std::any_of(errors.begin(), errors.end(),
                                   [](const std::string& code) { return !harmless_errors.contains(code); });
  if (matters && !of_skins && !of_containers) {
    EXPECT_FALSE(refusal.empty()) << "accepted with " << *errors.begin();
  }
}

INSTANTIATE_TEST_SUITE_P(Assets, ValidatorFile, testing::ValuesIn(files_below("gltf_validator")), test_name);

class RealFile : public testing::TestWithParam<std::string> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RealFile);

bool ignore_image(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

// Extensions that hold the shape of a mesh and are not read: a file that requires one is refused by its name.
const std::set<std::string> shapes_not_read = {"KHR_draco_mesh_compression", "EXT_meshopt_compression"};

// Read from the JSON alone: neither reader takes part. A .glb begins with 12 bytes and the JSON's length and kind.
std::vector<std::string> required_extensions(const std::string& path) {
  std::string text = test_support::text_of(path);
  if (fs::path(path).extension() == ".glb") {
    std::uint32_t length = 0;
    std::memcpy(&length, text.data() + 12, sizeof length);
    text = text.substr(20, length);
  }
  return nlohmann::json::parse(text).value("extensionsRequired", std::vector<std::string>());
}

// tinygltf reads the structure on its own.
TEST_P(RealFile, HasTheStructureThatTinygltfSees) {
  const std::string path = GetParam();
  for (const std::string& extension : required_extensions(path)) {
    if (!shapes_not_read.contains(extension)) continue;
    try {
      import_gltf(path, TimeBase{});
      FAIL() << "drawn without what " << extension << " holds";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_NE(error.message().find(extension), std::string::npos) << error.what();
    }
    return;
  }
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(ignore_image, nullptr);
  tinygltf::Model expected;
  std::string errors, warnings;
  const bool binary = fs::path(path).extension() == ".glb";
  ASSERT_TRUE(binary ? loader.LoadBinaryFromFile(&expected, &errors, &warnings, path)
                     : loader.LoadASCIIFromFile(&expected, &errors, &warnings, path))
      << errors;
  const ImportedModel model = import_gltf(path, TimeBase{});
  // Skinned meshes hang from a node of their own.
  const auto is_skinned = [&](const Object& object) {
    return static_cast<std::size_t>(object.node) == expected.nodes.size();
  };
  const bool skinned = std::any_of(model.objects.begin(), model.objects.end(), is_skinned);
  ASSERT_EQ(model.nodes.size(), expected.nodes.size() + (skinned ? 1 : 0));
  for (std::size_t i = 0; i < expected.nodes.size(); ++i)
    for (const int child : expected.nodes[i].children)
      EXPECT_EQ(model.nodes[static_cast<std::size_t>(child)].parent, static_cast<int>(i));
  for (std::size_t i = 0; i < model.objects.size(); ++i) {
    const Object& object = model.objects[i];
    EXPECT_NO_THROW(validate(model.meshes[static_cast<std::size_t>(object.mesh)]));
    if (is_skinned(object)) continue;
    const tinygltf::Node& node = expected.nodes[static_cast<std::size_t>(object.node)];
    ASSERT_GE(node.mesh, 0);
    const tinygltf::Mesh& mesh = expected.meshes[static_cast<std::size_t>(node.mesh)];
    const Mesh& drawn = model.meshes[static_cast<std::size_t>(object.mesh)];
    const bool found = std::any_of(mesh.primitives.begin(), mesh.primitives.end(), [&](const auto& primitive) {
      const auto position = static_cast<std::size_t>(primitive.attributes.at("POSITION"));
      return expected.accessors[position].count == drawn.positions.size() &&
             primitive.targets.size() == drawn.targets.size() &&
             primitive.attributes.contains("NORMAL") == !drawn.normals.empty();
    });
    EXPECT_TRUE(found) << "object " << i << " has " << drawn.positions.size()
                       << " vertices, as no primitive of its mesh";
    EXPECT_EQ(model.objects[i].morph.weights.size(), drawn.targets.size());
    if (!mesh.weights.empty() && node.weights.empty()) {
      EXPECT_EQ(model.objects[i].morph.weights, mesh.weights);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Assets, RealFile, testing::ValuesIn(files_below("gltf")), test_name);

class AnimatedFile : public testing::TestWithParam<std::string> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(AnimatedFile);

TEST_P(AnimatedFile, MovesAsTheEvaluatorSays) { EXPECT_GT(compare_with_evaluator(GetParam()), 0u); }

std::vector<std::string> animated_files() {
  std::vector<std::string> files = files_below("gltf/asset_generator/Animation_Node");
  for (const char* folder : {"01_cs_morph", "01_morphed_cube", "01_morphed_triangle", "03_all_animations",
                             "03_animated_cube", "03_skinned_cylinder"})
    for (const std::string& file : files_below(std::string("gltf/blender_roundtrip/") + folder)) files.push_back(file);
  for (const char* folder : {"gltf/SimpleMorph", "gltf/AnimatedMorphCube"})
    for (const std::string& file : files_below(folder)) files.push_back(file);
  return files;
}
INSTANTIATE_TEST_SUITE_P(Assets, AnimatedFile, testing::ValuesIn(animated_files()), test_name);

}  // namespace
}  // namespace morphcl::test
