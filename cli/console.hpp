// stdout carries results, stderr everything else. A line is whole or not written: one call, one write. It goes out
// at once, so that who reads through a pipe can follow.
#pragma once

#include <string_view>

namespace morphcl::cli {

// To stdout, with a newline; `text` may be of several lines. Control characters, which file names may hold, are
// replaced.
void print_result(std::string_view text);
void print_message(std::string_view line);   // to stderr: "morphcl: LINE", control characters replaced
void print_progress(std::string_view line);  // to stderr, as it is

// Throws Error(write_failed) when a result could not be written: stdout is full or was closed.
void check_results();

bool stderr_is_terminal();
int terminal_columns();  // of the terminal on stderr, as it is now; 80 when it does not say
bool colors_wanted();    // a terminal on stderr, NO_COLOR unset or empty, TERM not "dumb"

}  // namespace morphcl::cli
