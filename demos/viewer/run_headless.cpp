#include "demos/viewer/run_headless.hpp"

#include <fmt/format.h>

#include "demos/viewer/script_player.hpp"
#include "host/image/png_file.hpp"

namespace morphcl::viewer {

void run_headless(FrameSource& frames, DemoSession& session, const std::vector<KeyPress>& script, const Size& size,
                  const std::string& out) {
  ScriptPlayer player(script);
  for (bool going_on = true; going_on && !player.done();) {
    going_on = session.press(*player.take_next(), size);
    while (session.state().playing) session.advance();
  }
  if (out.ends_with(".exr")) {
    fmt::print("{}\n", frames.export_frame(session.state().view, size, out));
  } else if (!out.empty()) {
    write_png(out, session.picture(size));
    fmt::print("{}\n", out);
  }
}

}  // namespace morphcl::viewer
