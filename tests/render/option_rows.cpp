#include "tests/render/option_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "tests/render/channel_scenes.hpp"

namespace morphcl::test {

namespace {

constexpr std::array<ChannelSet, 6> channel_choices = {
    default_channels,
    color_alone,
    depth_alone,
    ChannelSet{Channel::color, Channel::normal, Channel::position, Channel::velocity, Channel::uv, Channel::albedo},
    ChannelSet{Channel::object_id, Channel::material_id, Channel::coverage, Channel::crypto_object,
               Channel::crypto_material},
    every_channel};
constexpr std::array<AlphaMode, 3> alpha_modes = {AlphaMode::opaque, AlphaMode::blend, AlphaMode::mask};
constexpr std::array<const char*, 3> alpha_names = {"opaque", "blend", "mask"};

// A choice of as many options as the strength is: (option, value, other option, its value); one option stands twice.
using Choice = std::tuple<std::size_t, int, std::size_t, int>;
std::vector<Choice> choices_of(const OptionRow& row, int strength) {
  std::vector<Choice> choices;
  for (std::size_t i = 0; i < row.size(); ++i)
    for (std::size_t j = strength == 1 ? i : i + 1; j < (strength == 1 ? i + 1 : row.size()); ++j)
      choices.emplace_back(i, row[i], j, row[j]);
  return choices;
}

// Two of three objects let through what lies behind them: as a whole, or at each vertex as it comes.
void give_alpha(Scene& scene, AlphaMode mode) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    Object& object = scene.objects[i];
    object.material.alpha_mode = mode;
    if (i % 3 == 1) object.material.base_color.a = 0.6;
    if (i % 3 != 0) continue;
    Mesh& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
    if (mesh.colors.empty()) mesh.colors.assign(mesh.positions.size(), glm::vec4(1));
    for (std::size_t v = 0; v < mesh.colors.size(); ++v) mesh.colors[v].a = static_cast<float>(v % 7) / 6;
  }
}

}  // namespace

std::vector<OptionRow> all_option_rows() {
  std::vector<OptionRow> rows = {OptionRow{}};
  for (std::size_t i = 0; i < option_values.size(); ++i) {
    std::vector<OptionRow> longer;
    for (OptionRow row : rows)
      for (row[i] = 0; row[i] < option_values[i]; ++row[i]) longer.push_back(row);
    rows = std::move(longer);
  }
  return rows;
}

std::vector<OptionRow> covering_option_rows(int strength) {
  const std::vector<OptionRow> all = all_option_rows();
  std::set<Choice> missing;
  for (const OptionRow& row : all)
    for (const Choice& choice : choices_of(row, strength)) missing.insert(choice);
  std::vector<OptionRow> rows;
  while (!missing.empty()) {
    OptionRow best{};
    std::ptrdiff_t most = 0;
    for (const OptionRow& row : all) {
      const std::vector<Choice> choices = choices_of(row, strength);
      const auto count =
          std::count_if(choices.begin(), choices.end(), [&](const Choice& c) { return missing.contains(c); });
      if (count <= most) continue;
      most = count;
      best = row;
    }
    for (const Choice& choice : choices_of(best, strength)) missing.erase(choice);
    rows.push_back(best);
  }
  return rows;
}

std::string words_for(const OptionRow& row) {
  return fmt::format("samples {}, {}, {}, {}, {}, {}, {}", sample_counts[static_cast<std::size_t>(row[0])],
                     name_of(depth_formats[static_cast<std::size_t>(row[1])]),
                     names_of(channel_choices[static_cast<std::size_t>(row[2])]),
                     row[3] ? "background" : "no background", alpha_names[static_cast<std::size_t>(row[4])],
                     row[5] ? "lines" : "faces", row[6] ? "precise" : "plain");
}

Scene with_options(Scene scene, const OptionRow& row) {
  scene = with_channels(std::move(scene), channel_choices[static_cast<std::size_t>(row[2])],
                        sample_counts[static_cast<std::size_t>(row[0])]);
  scene.image.depth_format = depth_formats[static_cast<std::size_t>(row[1])];
  if (row[3]) scene.image.background = Background{{0.1, 0.3, 0.9}, {0.7, 0.6, 0.5}};
  give_alpha(scene, alpha_modes[static_cast<std::size_t>(row[4])]);
  if (row[5])
    for (Object& object : scene.objects) {
      object.material.shading = Shading::wireframe;
      object.material.line_width = 2.5;
    }
  if (row[6]) scene.accuracy_pixels = 1e-9;
  return scene;
}

}  // namespace morphcl::test
