// What is wrong with a command line, in words for people.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace morphcl::cli {

// One line: what CLI11 found, or, for a command or an option that does not exist, which of those that do was meant.
std::string usage_words(const CLI::App& app, const CLI::ParseError& error);

}  // namespace morphcl::cli
