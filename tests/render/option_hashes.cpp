// option_hashes values|pairs|all [reference]: one line a picture, "hash SCENE: OPTIONS", of three scenes with options
// that have every value, every pair of values, or every combination of them. Drawn by a process of its own under the
// environment that a test gives it. An Error is printed and its exit code is the process's.
#include <fmt/format.h>

#include <string_view>

#include "host/image/pixel_hash.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/session.hpp"
#include "tests/render/option_rows.hpp"
#include "tests/render/test_scenes.hpp"

namespace {

using namespace morphcl;

bool is_drawn(const test::TestScene& scene) {
  return scene.name == "across the near plane" || scene.name == "mirrored and two-sided" ||
         scene.name == "orthographic";
}

std::vector<test::OptionRow> rows_of(std::string_view choice) {
  if (choice == "all") return test::all_option_rows();
  return test::covering_option_rows(choice == "pairs" ? 2 : 1);
}

}  // namespace

int main(int count, char** values) {
  if (count < 2) return 2;
  try {
    prepare_process(0);
    const bool reference = count > 2 && std::string_view(values[2]) == "reference";
    const std::shared_ptr<Session> session = reference ? nullptr : Session::open({});
    const auto renderer = reference ? make_reference_renderer(2) : make_device_renderer(session);
    const std::vector<test::OptionRow> rows = rows_of(values[1]);
    for (const test::TestScene& test : test::test_scenes(72, 40, 1))
      for (const test::OptionRow& row : rows) {
        if (!is_drawn(test)) continue;
        const Scene scene = test::with_options(test.scene, row);
        const Plan plan = plan_frame(scene, 0);
        FrameBuffer pixels = plan.make_frame();
        renderer->render(plan, pixels);
        fmt::print("{} {}: {}\n", pixel_hash(pixels), test.name, test::words_for(row));
      }
    if (session) session->store_programs();
  } catch (const Error& error) {
    fmt::print("error {}\n", error.what());
    return error.exit_code();
  }
  return 0;
}
