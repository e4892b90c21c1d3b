// docs/json.md names every field that a command prints with --json, and none that is not printed.
#include <gmock/gmock.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/cube_shot.hpp"
#include "tests/cli/gltf_sample.hpp"
#include "tests/cli/run_tool.hpp"
#include "tests/cli/tool_test.hpp"

namespace morphcl::cli_test {
namespace {

using FieldsByType = std::map<std::string, std::set<std::string>>;

std::vector<std::string> quoted_words(const std::string& text) {
  static const std::regex word("`([^`]*)`");
  std::vector<std::string> words;
  for (std::sregex_iterator at(text.begin(), text.end(), word), end; at != end; ++at) words.push_back((*at)[1]);
  return words;
}

// The rows of the table; a row without a type goes on with those of the row above.
FieldsByType documented_fields() {
  std::ifstream file(MORPHCL_SOURCE_DIR "/docs/json.md");
  FieldsByType fields;
  std::vector<std::string> types;
  static const std::regex row(R"(\| ([^|]*)\| ([^|]*)\| ([^|]*)\| ([^|]*)\|)");
  std::smatch cells;
  for (std::string line; std::getline(file, line);) {
    if (!std::regex_match(line, cells, row)) continue;
    if (const std::vector<std::string> named = quoted_words(cells[1]); !named.empty()) types = named;
    for (const std::string& field : quoted_words(cells[3]))
      for (const std::string& type : types) fields[type].insert(field);
  }
  return fields;
}

// "color_…" stands for all fields that begin so; the longest such name counts.
std::string name_in_table(const std::string& field, const std::set<std::string>& documented) {
  if (documented.contains(field)) return field;
  for (std::size_t end = field.rfind('_'); end != std::string::npos && end > 0; end = field.rfind('_', end - 1))
    if (const std::string prefix = field.substr(0, end + 1) + "…"; documented.contains(prefix)) return prefix;
  return field;
}

class JsonFields : public ToolTest {
 protected:
  // Of every line that is an object, on either stream.
  void read(const std::vector<std::string>& arguments) {
    const ToolResult result = run_tool(arguments, {.folder = folder_});
    std::istringstream lines(result.out + result.err);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with('{')) continue;
      const nlohmann::json object = nlohmann::json::parse(line);
      EXPECT_EQ(object.at("schema"), 1) << line;
      std::set<std::string>& fields = printed_[object.at("type")];
      for (const auto& [name, value] : object.items())
        if (name != "schema" && name != "type") fields.insert(name);
    }
  }

  FieldsByType printed_;
};

std::string model_with_one_of_each() {
  GltfSample sample;
  sample.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
  sample.json["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 5}}});
  sample.json["scenes"][0]["nodes"].push_back(sample.json["nodes"].size() - 1);
  sample.json["extensionsUsed"] = nlohmann::json::array({"VENDOR_unknown"});
  sample.json["extensionsRequired"] = nlohmann::json::array({"VENDOR_unknown"});
  return sample.json.dump();
}

TEST_F(JsonFields, AreThoseOfTheDocumentation) {
  plant("shot.toml", replaced(cube_shot(), "range = \"0-4\"", "range = \"0-2\""));
  plant("model.gltf", model_with_one_of_each());
  plant("data.bin", GltfSample().buffer);
  plant("f.0001.exr/in_the_way", "");  // a folder where a frame is to be: that frame fails
  read({"render", "shot.toml", "-o", "f.####.exr", "--device", "reference", "--json"});
  read({"render", "shot.toml", "-o", "f.####.png", "--device", "reference", "--json"});
  read({"plan", "shot.toml", "--json"});
  read({"plan", "shot.toml", "--visibility", "painter", "--explain", "explained", "--json"});
  plant("morph.toml", replaced(cube_shot(), "mesh = \"cube\"", "mesh = \"pyramid_to_cube\""));
  read({"trace", "morph.toml", "--json"});
  plant("plan.toml",
        replaced(replaced(replaced(cube_shot(), "\"perspective\"", "\"orthographic\""), "fovy_degrees = 45.0\n", ""),
                 "[3.0, 2.4, 5.1]", "[0.0, 0.0, 5.0]"));
  read({"trace", "plan.toml", "--json"});
  read({"trace", "shot.toml", "--pixel", "16,9", "--json"});
  read({"compare", "shot.toml", "--frames", "0", "--device", "reference", "--json"});
  read({"compare", "shot.toml", "--frames", "0", "--truth", "coverage", "--json"});
  read({"devices", "--json"});
  for (const char* file : {"shot.toml", "model.gltf", "f.0000.exr", "f.0000.png"}) read({"info", file, "--json"});

  const FieldsByType documented = documented_fields();
  ASSERT_GT(documented.size(), 10u);
  FieldsByType named;
  for (const auto& [type, fields] : printed_) {
    named[type];
    for (const std::string& field : fields)
      named[type].insert(documented.contains(type) ? name_in_table(field, documented.at(type)) : field);
  }
  for (const auto& [type, fields] : named)
    EXPECT_THAT(fields, testing::ContainerEq(documented.contains(type) ? documented.at(type) : std::set<std::string>{}))
        << "fields of " << type << ": printed, and in docs/json.md";
  for (const auto& [type, fields] : documented) EXPECT_TRUE(named.contains(type)) << type << " is not printed";
}

}  // namespace
}  // namespace morphcl::cli_test
