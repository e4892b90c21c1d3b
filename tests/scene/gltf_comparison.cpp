#include "tests/scene/gltf_comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host/scene/gltf/gltf_import.hpp"
#include "tests/scene/gltf_evaluator.hpp"

namespace morphcl::test {

namespace {

// Values are up to some hundred operations in fp64 away from the file's numbers, each off by 2^-53 of the largest
// number that takes part: 100 * 2^-53 = 1.1e-14. Slerp near a half turn and the sum of the Hermite terms multiply that
// by up to about 10.
constexpr Real relative_bound = 1.2e-13L;

}  // namespace

std::size_t compare_with_evaluator(const std::string& path) {
  TimeBase time;
  time.fps_numerator = 120;
  const ImportedModel model = import_gltf(path, time);
  const GltfEvaluator expected(path, time.fps_numerator, time.ticks_per_frame());
  Timeline timeline;
  timeline.time = time;
  timeline.nodes = model.nodes;
  validate(timeline);

  std::size_t compared = 0;
  Real largest_error = 0;
  const auto compare = [&](Real want, double got, Real magnitude, const std::string& what) {
    const Real error = std::abs(want - got) / std::max<Real>(1, magnitude);
    largest_error = std::max(largest_error, error);
    ++compared;
    EXPECT_LE(error, relative_bound) << path << ": " << what << ": expected " << want << ", actual " << got;
  };
  const std::int64_t last_frame = expected.last_tick() / time.ticks_per_frame() + 2;
  for (std::int64_t frame = -1; frame <= last_frame && !testing::Test::HasFailure(); ++frame) {
    const FrameState state = evaluate(timeline, frame);
    const std::int64_t tick = time.frame_ticks(frame);
    for (std::size_t node = 0; node < expected.node_count(); ++node) {
      const Matrix matrix = expected.node_to_world(node, tick);
      Real magnitude = 0;
      for (const auto& row : matrix)
        for (const Real entry : row) magnitude = std::max(magnitude, std::abs(entry));
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
          compare(matrix[i][j], state.node_to_world[node][j][i], magnitude,
                  "frame " + std::to_string(frame) + ", node " + std::to_string(node) + ", row " + std::to_string(i) +
                      ", column " + std::to_string(j));
    }
    for (std::size_t object = 0; object < model.objects.size(); ++object) {
      const auto node = static_cast<std::size_t>(model.objects[object].node);
      if (node >= expected.node_count()) continue;  // skinned: it hangs from a node of its own
      const std::vector<Real> weights = expected.weights(node, tick);
      const std::vector<double> actual = weights_at(model.objects[object].morph, time, frame);
      EXPECT_EQ(weights.size(), actual.size()) << path;
      for (std::size_t target = 0; target < std::min(weights.size(), actual.size()); ++target)
        compare(weights[target], actual[target], std::abs(weights[target]),
                "frame " + std::to_string(frame) + ", object " + std::to_string(object) + ", weight " +
                    std::to_string(target));
    }
  }
  testing::Test::RecordProperty("largest_relative_error", std::to_string(static_cast<double>(largest_error)));
  return compared;
}

}  // namespace morphcl::test
