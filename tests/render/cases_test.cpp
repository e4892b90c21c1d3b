// Small files that went wrong once, or could, below the folder that MORPHCL_CASES names: what becomes of each.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "host/render/frame/frame_plan.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/scene.hpp"
#include "tests/render/cases_table.hpp"
#include "tests/render/parity.hpp"
#include "tests/support/test_data.hpp"

namespace morphcl::test {
namespace {

namespace fs = std::filesystem;

fs::path cases_folder() { return test_support::test_data("MORPHCL_CASES"); }

// Frame 0 at 64 x 64 pixels.
std::unique_ptr<FrameBuffer> picture_of(const std::string& file) {
  LoadOptions options;
  options.width = options.height = 64;
  const Scene scene = load_scene((cases_folder() / file).string(), options);
  const Plan plan = Planner(scene).plan(0);
  auto frame = std::make_unique<FrameBuffer>(plan->width, plan->height, plan->channels);
  make_reference_renderer()->render(plan, *frame);
  return frame;
}

// Of the pixels that are covered.
glm::dvec3 mean_color(const FrameBuffer& frame) {
  const std::vector<float> pixels = to_rgba32f(frame);
  glm::dvec3 sum(0);
  double covered = 0;
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x) {
      const float* pixel = &pixels[4 * (static_cast<std::size_t>(y) * frame.width() + x)];
      if (pixel[3] == 0) continue;
      for (int c = 0; c < 3; ++c) sum[c] += pixel[c];
      ++covered;
    }
  return sum / covered;
}

void expect_picture(const std::string& file, const CasePicture& expected) {
  const auto frame = picture_of(file);
  if (!expected.like.empty()) {
    EXPECT_TRUE(same_pixels(*picture_of(expected.like), *frame)) << "expected the picture of " << expected.like;
    return;
  }
  EXPECT_EQ(covered_pixels(*frame), expected.covered);
  if (expected.covered == 0) return;
  const glm::dvec3 color = mean_color(*frame);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(color[c], expected.color[c], 0.005 * std::max(expected.color[c], 0.01));
}

class Cases : public ::testing::TestWithParam<Case> {};

TEST_P(Cases, BecomesWhatIsRight) {
  const Case& row = GetParam();
  try {
    const Scene scene = load_scene((cases_folder() / row.file).string());
    EXPECT_EQ(row.exit_code, 0) << "was read";
    EXPECT_EQ(scene.warnings.size(), row.words.size());
    for (std::size_t i = 0; i < std::min(scene.warnings.size(), row.words.size()); ++i)
      EXPECT_NE(scene.warnings[i].find(row.words[i]), std::string::npos) << scene.warnings[i];
    if (row.exit_code == 0) expect_picture(row.file, row.picture);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), row.exit_code) << error.what();
    ASSERT_EQ(row.words.size(), 1u) << error.what();
    EXPECT_NE(std::string(error.what()).find(row.words[0]), std::string::npos) << error.what();
  }
}

std::string case_name(const ::testing::TestParamInfo<Case>& row) {
  std::string name = row.param.file;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(EveryFile, Cases, ::testing::ValuesIn(cases_table()), case_name);

TEST(CasesTable, HasARowForEveryFile) {
  std::set<std::string> rows;
  for (const Case& row : cases_table()) rows.insert(row.file);
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(cases_folder())) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".obj" && extension != ".gltf" && extension != ".glb" && extension != ".toml") continue;
    ++files;
    EXPECT_TRUE(rows.contains(entry.path().lexically_relative(cases_folder()).generic_string())) << entry.path();
  }
  EXPECT_EQ(files, rows.size());
}

}  // namespace
}  // namespace morphcl::test
