#include "cli/usage_words.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "host/scene/shot/nearest_name.hpp"
#include "morphcl/error.hpp"

namespace morphcl::cli {

namespace {

bool is_scene(std::string_view argument) {
  constexpr std::array<std::string_view, 4> endings{".toml", ".gltf", ".glb", ".obj"};
  return std::any_of(endings.begin(), endings.end(),
                     [argument](std::string_view end) { return argument.ends_with(end); });
}

std::string unknown_command(const CLI::App& app, const std::string& name) {
  const std::string what = fmt::format("'{}' is no command of morphcl", printable(name));
  if (is_scene(name)) return what + "; did you mean morphcl render " + printable(name) + "?";
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    commands.push_back(command->get_name());
  return what + suggestion(name, {commands.begin(), commands.end()});
}

// What people type who come from other programs, or from another command of this one.
struct Synonym {
  std::string_view typed, known;
};
constexpr std::array synonyms{Synonym{"--out", "--output"},
                              Synonym{"--output", "--out"},
                              Synonym{"-v", "--verbose"},
                              Synonym{"--silent", "--quiet"},
                              Synonym{"--width", "--size"},
                              Synonym{"--height", "--size"},
                              Synonym{"--resolution", "--size"},
                              Synonym{"-s", "--size"},
                              Synonym{"-f", "--frames"},
                              Synonym{"--start", "--frames"},
                              Synonym{"--end", "--frames"},
                              Synonym{"--range", "--frames"},
                              Synonym{"--msaa", "--samples"},
                              Synonym{"--spp", "--samples"},
                              Synonym{"--antialiasing", "--samples"},
                              Synonym{"--aovs", "--channels"},
                              Synonym{"--passes", "--channels"},
                              Synonym{"--layers", "--channels"},
                              Synonym{"-j", "--threads"},
                              Synonym{"--jobs", "--threads"},
                              Synonym{"--continue", "--resume"},
                              Synonym{"--skip-existing", "--resume"}};

// Without its value, which may stand behind a '='.
std::string unknown_option(const CLI::App& command, std::string_view argument) {
  const std::string_view name = argument.substr(0, argument.find('='));
  std::vector<std::string> options;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& known : option->get_lnames()) options.push_back("--" + known);
  const std::string what = fmt::format("'{}' is no option of morphcl {}", printable(name), command.get_name());
  for (const auto& [typed, known] : synonyms)
    if (typed == name && std::ranges::find(options, known) != options.end())
      return what + fmt::format("; did you mean \"{}\"?", known);
  return what + suggestion(name, {options.begin(), options.end()});
}

}  // namespace

std::string usage_words(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  if (commands.empty()) {
    const std::vector<std::string> rest = app.remaining();
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && rest.empty())
      return "a command is missing, as in morphcl render shot.toml; see morphcl --help";
    if (rest.empty() || rest.front().starts_with('-')) return printable(error.what()) + "; see morphcl --help";
    return unknown_command(app, rest.front()) + "; see morphcl --help";
  }
  const CLI::App& command = *commands.front();
  const std::string help = fmt::format("; see morphcl {} --help", command.get_name());
  const std::vector<std::string> rest = command.remaining();
  const auto option =
      std::find_if(rest.begin(), rest.end(), [](const std::string& one) { return one.starts_with('-'); });
  if (option != rest.end()) return unknown_option(command, *option) + help;
  return printable(error.what()) + help;
}

}  // namespace morphcl::cli
