// The demos in a real window of a virtual display, with keys that come through the X server.
#include <unistd.h>

#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "morphcl/exr.hpp"
#include "tests/demos/demo_program.hpp"
#include "tests/demos/expected_frame.hpp"
#include "tests/demos/virtual_display.hpp"

namespace morphcl::viewer_test {
namespace {

constexpr int kWidth = 320, kHeight = 180;
constexpr int kCodeBound = 1;  // of 255: the rounding of the screen's own conversion

class DemoWindow : public DemoProgram {
 protected:
  // Starts the program and waits for its first frame.
  void start(const std::string& program, std::vector<std::string> arguments, const std::string& first_title) {
    display_ = std::make_unique<VirtualDisplay>(folder_);
    arguments.insert(arguments.begin(), program);
    demo_ = std::make_unique<test_support::ChildProcess>(arguments, options(display_->name()));
    const bool started = eventually([&] {
      window_ = display_->xdotool({"search", "--name", first_title});
      return !window_.empty();
    });
    if (!started) throw std::runtime_error("no window \"" + first_title + "\": " + demo_->err());
    display_->xdotool({"windowfocus", "--sync", window_});
  }

  // `device`: "0" an OpenCL device; where the kernels are not the point, the reference saves their compilation.
  void start_morph(const std::string& device = "reference") {
    start(kMorphDemo, {"--size", std::to_string(kWidth) + "x" + std::to_string(kHeight), "--device", device},
          "step 0 of 100");
  }

  // One xdotool call: `count` presses, each released before the next.
  void press(const std::string& key, int count = 1) {
    std::vector<std::string> arguments = {"key", "--delay", "5"};
    arguments.insert(arguments.end(), count, key);
    display_->xdotool(arguments);
  }

  std::string title() const { return display_->xdotool({"getwindowname", window_}); }

  void expect_title(const std::string& part) {
    std::string last;
    EXPECT_TRUE(eventually([&] {
      last = title();
      return last.find(part) != std::string::npos;
    })) << "title is \""
        << last << "\", expected \"" << part << "\"; " << demo_->err();
  }

  // The screen shows this frame of the morph, as the reference renderer draws it at this size.
  void expect_picture(int frame, int width = kWidth, int height = kHeight) {
    expect_screen(srgb_picture(expected_frame(demo_scene("pyramid_to_cube.toml", width, height), frame)));
  }

  void expect_screen(const RgbImage& expected) {
    std::string last;
    EXPECT_TRUE(eventually([&] {
      last = difference(display_->screenshot(), expected, kCodeBound);
      return last.empty();
    })) << last;
  }

  void expect_end() { EXPECT_EQ(demo_->wait(kProgramLimit), 0) << demo_->err(); }

  // False when the demo ended, or the limit passed, before the condition came true.
  bool eventually(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + kProgramLimit;
    while (!condition()) {
      if (!demo_->runs() || std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
  }

  // Processor time of the program so far.
  double cpu_seconds() const {
    std::ifstream file("/proc/" + std::to_string(demo_->pid()) + "/stat");
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    std::istringstream fields(text.substr(text.rfind(')') + 2));
    std::string skipped;
    for (int i = 0; i < 11; ++i) fields >> skipped;  // from state to cmajflt
    long user = 0, system = 0;
    fields >> user >> system;
    return static_cast<double>(user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
  }

  std::unique_ptr<VirtualDisplay> display_;
  std::unique_ptr<test_support::ChildProcess> demo_;  // ends before its display
  std::string window_;
};

TEST_F(DemoWindow, PressesStepThroughTheFramesAndStopAtBothEnds) {
  start_morph("auto");
  expect_picture(0);
  press("k", 37);
  expect_title("step 37 of 100");
  expect_picture(37);
  press("k", 100);
  expect_title("step 100 of 100");
  expect_picture(100);
  press("p", 63);
  expect_title("step 37 of 100");
  expect_picture(37);
  press("p", 50);
  expect_title("step 0 of 100");
  expect_picture(0);
  press("q", 2);
  expect_title("step 2 of 100");
  press("Escape");
  expect_end();
}

TEST_F(DemoWindow, HeldKeysGoOnToTheEndAndBack) {
  start_morph();
  display_->xdotool({"keydown", "k"});
  expect_title("step 100 of 100");
  display_->xdotool({"keyup", "k"});
  expect_picture(100);
  display_->xdotool({"keydown", "p"});
  expect_title("step 0 of 100");
  display_->xdotool({"keyup", "p"});
  expect_picture(0);
}

TEST_F(DemoWindow, SpacePlaysToTheEnd) {
  start_morph();
  press("space");
  expect_title("step 100 of 100");
  expect_picture(100);
}

TEST_F(DemoWindow, ViewsComeBackToTheSamePicture) {
  start_morph();
  press("o");
  expect_title("orthographic");
  press("f");
  expect_title("frustum");
  expect_picture(0);
  for (const auto& [there, back] : {std::pair{"w", "s"}, {"Left", "Right"}, {"Up", "Down"}, {"h", "h"}}) {
    const RgbImage before = display_->screenshot();
    press(there, 3);
    EXPECT_TRUE(eventually([&] { return !difference(display_->screenshot(), before, kCodeBound).empty(); }))
        << there << " changes nothing";
    press(back, 3);
    expect_picture(0);
  }
}

TEST_F(DemoWindow, TheMouseTurnsTheSceneAndTheWheelBringsItNearer) {
  start_morph();
  expect_picture(0);
  const auto changes = [&](const RgbImage& before) {
    return eventually([&] { return !difference(display_->screenshot(), before, kCodeBound).empty(); });
  };
  const auto move_to = [&](int x, int y) {
    display_->xdotool({"mousemove", "--sync", "--window", window_, std::to_string(x), std::to_string(y)});
  };
  RgbImage before = display_->screenshot();
  move_to(100, 80);
  display_->xdotool({"mousedown", "1"});
  move_to(160, 100);
  EXPECT_TRUE(changes(before)) << "dragged";
  move_to(100, 80);
  display_->xdotool({"mouseup", "1"});
  expect_picture(0);
  move_to(160, 100);
  expect_picture(0);
  before = display_->screenshot();
  display_->xdotool({"click", "4"});
  EXPECT_TRUE(changes(before)) << "the wheel";
  display_->xdotool({"click", "5"});
  expect_picture(0);
}

TEST_F(DemoWindow, TheDeckTurnsByItselfUntilItIsStopped) {
  start(kMorphDemo, {"--deck", "--size", "200x200", "--device", "reference"}, "step 0 of 100");
  const RgbImage before = display_->screenshot();
  EXPECT_TRUE(eventually([&] { return !difference(display_->screenshot(), before, kCodeBound).empty(); }));
  press("t");
  press("k", 3);
  expect_title("step 3 of 100");
  const RgbImage stopped = display_->screenshot();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_EQ(difference(display_->screenshot(), stopped, kCodeBound), "");
  press("t");
  EXPECT_TRUE(eventually([&] { return !difference(display_->screenshot(), stopped, kCodeBound).empty(); }));
  press("Escape");
  expect_end();
}

TEST_F(DemoWindow, ANewSizeIsRenderedAnew) {
  start_morph();
  press("k", 37);
  expect_title("step 37");
  display_->xdotool({"windowsize", window_, "401", "257"});
  expect_picture(37, 401, 257);
  display_->xdotool({"windowsize", window_, "240", "199"});
  expect_picture(37, 240, 199);
}

TEST_F(DemoWindow, ExportWritesTheFrameAndNamesIt) {
  start_morph("0");
  press("k", 37);
  press("e");
  expect_title("wrote morph_demo.0037.exr");
  EXPECT_EQ(demo_->out(), "morph_demo.0037.exr\n");
  EXPECT_EQ(read_exr((folder_ / "morph_demo.0037.exr").string()).hash,
            pixel_hash(expected_frame(demo_scene("pyramid_to_cube.toml", kWidth, kHeight), 37)));
}

TEST_F(DemoWindow, AnExportThatFailsIsToldAndTheWindowStays) {
  start_morph();
  std::filesystem::create_directory(folder_ / "morph_demo.0000.exr");  // in the file's place
  press("e");
  expect_title("frame was not written");
  EXPECT_EQ(test_support::lines_of(demo_->err()).size(), 1u) << demo_->err();
  press("k");
  expect_title("step 1 of 100");
}

TEST_F(DemoWindow, NothingIsDoneWhileNothingHappens) {
  start_morph("0");
  expect_picture(0);
  const std::string shown = title();
  constexpr int seconds = 2;
  const double before = cpu_seconds();
  std::this_thread::sleep_for(std::chrono::seconds(seconds));
  // A loop that polls would take all of its processor, or half of it beside another program.
  EXPECT_LT(cpu_seconds() - before, 0.1 * seconds);
  EXPECT_EQ(title(), shown);
}

TEST_F(DemoWindow, AScriptRunsWithoutAKeyboard) {
  start(kMorphDemo, {"--size", "64x36", "--script", "k37", "--device", "reference"}, "step 37 of 100");
  expect_picture(37, 64, 36);
  press("k");
  expect_title("step 38 of 100");
}

TEST_F(DemoWindow, AScriptMayEndTheProgram) {
  display_ = std::make_unique<VirtualDisplay>(folder_);
  test_support::ChildProcess demo(
      {kMorphDemo, "--size", "64x36", "--device", "reference", "--script", "k2,e,space,e,esc"},
      options(display_->name()));
  EXPECT_EQ(demo.wait(kProgramLimit), 0) << demo.err();
  EXPECT_EQ(demo.out(), "morph_demo.0002.exr\nmorph_demo.0100.exr\n");
}

TEST_F(DemoWindow, TeapotsAreTheFrameOfTheShot) {
  start(kTeapots, {"--size", "200x200", "--device", "reference"}, "teapots - orthographic");
  Scene scene = demo_scene("teapots.toml", 200, 200);
  scene.image.background = Background{glm::dvec3(1), glm::dvec3(1)};
  scene.timeline.camera.projection = Orthographic{-5, 5, -5, 5, -10, 10};
  expect_screen(srgb_picture(expected_frame(scene, 0)));
  press("f");
  expect_title("teapots - frustum");
  scene.timeline.camera.projection = Frustum{-2, 2, -2, 2, 3, 10};
  expect_screen(srgb_picture(expected_frame(scene, 0)));
}

}  // namespace
}  // namespace morphcl::viewer_test
