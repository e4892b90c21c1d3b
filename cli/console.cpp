#include "cli/console.hpp"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "morphcl/error.hpp"

namespace morphcl::cli {

namespace {
bool environment_says(const char* name, std::string_view value) {
  const char* found = std::getenv(name);
  return found != nullptr && found == value;
}
}  // namespace

void print_result(std::string_view text) {
  std::string safe;
  for (std::size_t begin = 0, end = 0; end != std::string_view::npos; begin = end + 1) {
    end = text.find('\n', begin);
    safe += printable(text.substr(begin, end - begin)) + '\n';
  }
  std::fwrite(safe.data(), 1, safe.size(), stdout);
  std::fflush(stdout);  // what fails here is found by check_results()
}

void print_message(std::string_view line) { print_progress(fmt::format("morphcl: {}", printable(line))); }

void print_progress(std::string_view line) {
  const std::string text = fmt::format("{}\n", line);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void check_results() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw Error(ErrorKind::write_failed, "stdout", "the results could not be written; send them to a place with room");
}

bool stderr_is_terminal() { return isatty(STDERR_FILENO) == 1 && !environment_says("TERM", "dumb"); }

int terminal_columns() {
  constexpr int usual = 80;
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : usual;
}

bool colors_wanted() {
  const char* no_color = std::getenv("NO_COLOR");
  return stderr_is_terminal() && (no_color == nullptr || *no_color == '\0');
}

}  // namespace morphcl::cli
