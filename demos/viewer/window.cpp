#include "demos/viewer/window.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

#include "morphcl/error.hpp"

namespace morphcl::viewer {

struct Window::Impl {
  GLFWwindow* handle = nullptr;
  std::vector<KeyEvent> key_events;
  bool damaged = true;
  bool dragging = false;
  double cursor_x = 0, cursor_y = 0;                // of the drag
  double dragged_x = 0, dragged_y = 0, turned = 0;  // pixels and notches that were not taken yet

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (handle != nullptr) glfwDestroyWindow(handle);
    glfwTerminate();
  }
};

namespace {

std::optional<Key> named_key(int glfw_key) {
  switch (glfw_key) {
    case GLFW_KEY_SPACE:
      return Key::play;
    case GLFW_KEY_LEFT:
      return Key::orbit_left;
    case GLFW_KEY_RIGHT:
      return Key::orbit_right;
    case GLFW_KEY_UP:
      return Key::orbit_up;
    case GLFW_KEY_DOWN:
      return Key::orbit_down;
    case GLFW_KEY_ESCAPE:
      return Key::leave;
    default:
      return std::nullopt;
  }
}

// GLFW names keys by their place on a US keyboard; what counts is the letter that is printed on the key. On a keyboard
// without Latin letters the place decides.
std::optional<Key> key_of(int glfw_key, int scancode) {
  if (const auto key = named_key(glfw_key)) return key;
  if (const char* printed = glfwGetKeyName(glfw_key, scancode)) {
    const std::string_view name = printed;
    if (name.size() == 1) return find_key(name);
  }
  if (glfw_key < GLFW_KEY_A || glfw_key > GLFW_KEY_Z) return std::nullopt;
  const char letter = static_cast<char>(glfw_key);
  return find_key(std::string_view(&letter, 1));
}

// The whole part of what is there, which is taken away.
int take_whole(double& amount) {
  const double whole = std::trunc(std::clamp(amount, -1e6, 1e6));
  amount -= whole;
  return static_cast<int>(whole);
}

Error no_window(std::string_view what) {
  const char* description = nullptr;
  glfwGetError(&description);
  return Error(ErrorKind::no_device, "",
               fmt::format("{} ({}); use --headless", what, printable(description ? description : "no reason given")));
}

// GLFW 3.4 tries Wayland first, whose library prints a line of its own where there is none.
void choose_platform() {
#if defined(GLFW_PLATFORM) && defined(__linux__)
  const bool may_be_wayland = std::getenv("WAYLAND_DISPLAY") != nullptr || std::getenv("WAYLAND_SOCKET") != nullptr;
  if (!may_be_wayland) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
}

}  // namespace

Window::Window(const std::string& title, const Size& size) : impl_(std::make_unique<Impl>()) {
  choose_platform();
  if (glfwInit() == GLFW_FALSE) throw no_window("no display");
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  impl_->handle = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
  if (impl_->handle == nullptr) throw no_window("no window with OpenGL on this display");
  glfwSetWindowUserPointer(impl_->handle, impl_.get());
  glfwSetKeyCallback(impl_->handle, [](GLFWwindow* handle, int glfw_key, int scancode, int action, int) {
    const auto key = key_of(glfw_key, scancode);
    // Keys that are held down repeat by our own clock (hold_repeat.hpp).
    if (!key || action == GLFW_REPEAT) return;
    static_cast<Impl*>(glfwGetWindowUserPointer(handle))->key_events.push_back({*key, action == GLFW_PRESS});
  });
  glfwSetWindowRefreshCallback(
      impl_->handle, [](GLFWwindow* handle) { static_cast<Impl*>(glfwGetWindowUserPointer(handle))->damaged = true; });
  glfwSetMouseButtonCallback(impl_->handle, [](GLFWwindow* handle, int button, int action, int) {
    if (button != GLFW_MOUSE_BUTTON_LEFT) return;
    Impl& window = *static_cast<Impl*>(glfwGetWindowUserPointer(handle));
    window.dragging = action == GLFW_PRESS;
    glfwGetCursorPos(handle, &window.cursor_x, &window.cursor_y);
  });
  glfwSetCursorPosCallback(impl_->handle, [](GLFWwindow* handle, double x, double y) {
    Impl& window = *static_cast<Impl*>(glfwGetWindowUserPointer(handle));
    if (!window.dragging) return;
    window.dragged_x += x - std::exchange(window.cursor_x, x);
    window.dragged_y += y - std::exchange(window.cursor_y, y);
  });
  glfwSetScrollCallback(impl_->handle, [](GLFWwindow* handle, double, double notches) {
    static_cast<Impl*>(glfwGetWindowUserPointer(handle))->turned += notches;
  });
  glfwMakeContextCurrent(impl_->handle);
  glfwSwapInterval(1);
}

Window::~Window() = default;

bool Window::should_close() const { return glfwWindowShouldClose(impl_->handle) != GLFW_FALSE; }

Size Window::size() const {
  Size size;
  glfwGetFramebufferSize(impl_->handle, &size.width, &size.height);
  return size;
}

void Window::set_title(const std::string& title) { glfwSetWindowTitle(impl_->handle, title.c_str()); }

static_assert(sizeof(Rgb) == 3, "OpenGL reads the pixels as packed bytes");

void Window::show(const RgbImage& picture) {
  const Size pixels = size();
  glViewport(0, 0, pixels.width, pixels.height);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_DITHER);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  // From the upper left corner downwards: no scaling, no filter, no texture size limit.
  glRasterPos2f(-1.0f, 1.0f);
  glPixelZoom(1.0f, -1.0f);
  glDrawPixels(picture.width, picture.height, GL_RGB, GL_UNSIGNED_BYTE, picture.pixels.data());
  glfwSwapBuffers(impl_->handle);
}

void Window::wait_for_events(double seconds) {
  if (std::isinf(seconds)) {
    glfwWaitEvents();
  } else if (seconds > 0) {
    glfwWaitEventsTimeout(seconds);
  } else {
    glfwPollEvents();
  }
}

std::vector<KeyEvent> Window::take_key_events() { return std::exchange(impl_->key_events, {}); }

MouseMove Window::take_mouse_move() {
  return {take_whole(impl_->dragged_x), take_whole(impl_->dragged_y), take_whole(impl_->turned)};
}

bool Window::take_damage() { return std::exchange(impl_->damaged, false); }

}  // namespace morphcl::viewer
