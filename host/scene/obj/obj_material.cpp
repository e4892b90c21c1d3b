#include "host/scene/obj/obj_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "host/lower_case.hpp"
#include "host/scene/model/input_file.hpp"
#include "host/scene/obj/obj_text.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

constexpr std::size_t told_materials = 8, told_name = 60, max_libraries = 1000;

std::string mtl_names(const std::set<std::string>& names) {
  std::string text;
  std::size_t told = 0;
  for (const std::string& name : names) {
    if (told == told_materials) return text + fmt::format(" and {} more", names.size() - told);
    text += (told > 0 ? ", " : "") + printable(name.substr(0, told_name));
    ++told;
  }
  return text;
}

bool ends_library_name(std::string_view word) {
  return lower_case(word.substr(word.size() - std::min<std::size_t>(word.size(), 4))) == ".mtl";
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = text.find_first_not_of(" \t"); at < text.size(); at = text.find_first_not_of(" \t", at)) {
    const std::size_t end = std::min(text.find_first_of(" \t", at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

// The names of a statement, each up to a word that ends in .mtl: names may hold blanks.
std::vector<std::string> library_names(const std::string& statement) {
  std::vector<std::string> names;
  bool open = false;
  for (const std::string& word : words_of(statement)) {
    if (open)
      names.back() += ' ' + word;
    else
      names.push_back(word);
    open = !ends_library_name(word);
  }
  return names;
}

class MtlReader {
 public:
  MtlReader(const ObjFile& file, const ImportLimits& limits, ImportBudget& budget, ContentHash& hash,
            std::vector<std::string>& warnings)
      : file_(file), limits_(limits), budget_(budget), hash_(hash), warnings_(warnings) {
    for (const std::string& name : file.materials) wanted_.insert(name);
  }

  std::vector<ObjMaterial> read() {
    for (const std::string& statement : file_.material_libraries) read_statement(statement);
    tell();
    std::vector<ObjMaterial> result;
    for (const std::string& name : file_.materials) result.push_back(found_[name]);
    return result;
  }

 private:
  void read_statement(const std::string& statement) {
    if (read_library(statement, false)) return;
    const std::vector<std::string> names = library_names(statement);
    for (const std::string& name : names) read_library(name, true);
  }

  // False when there is none of this name; `complain` says why.
  bool read_library(const std::string& name, bool complain) {
    if (!tried_.insert(name).second) return true;
    if (tried_.size() > max_libraries) return true;
    std::string with_slashes = name;
    std::replace(with_slashes.begin(), with_slashes.end(), '\\', '/');
    const std::string base = with_slashes.substr(with_slashes.rfind('/') + 1);
    Refusal first, other;
    if (try_file(name, first) || try_file(with_slashes, other)) return true;
    if (base != with_slashes && try_file(base, other)) {
      if (!first.is_missing)
        warnings_.push_back(fmt::format("{}; {} beside the model is used", first.why, printable(base)));
      return true;
    }
    if (!complain) {
      tried_.erase(name);
      return false;
    }
    warnings_.push_back(fmt::format("{}; the default colour is used", first.why));
    missing_library_ = true;
    return false;
  }

  struct Refusal {
    bool is_missing = true;  // else it may not be read
    std::string why;
  };

  bool try_file(const std::string& name, Refusal& refusal) {
    std::string text, path;
    try {
      path = confined_path(file_.path, name, limits_.allow_outside, file_.path);
      text = read_input_file(path, budget_.left_to_read());
    } catch (const Error& error) {
      refusal = {error.kind() == ErrorKind::cannot_read, error.what()};
      return false;
    }
    budget_.charge_file(path, text.size(), path);
    hash_.add(text);
    read_text(text, path);
    return true;
  }

  void read_text(std::string_view text, const std::string& path) {
    ObjStatements statements(text);
    std::string name;
    ObjMaterial* material = nullptr;  // null in one that no face uses, or that was read before
    bool dissolved = false;           // d was read: it goes before Tr
    while (statements.next()) {
      const std::string_view keyword = statements.keyword();
      if (keyword == "newmtl") {
        name = std::string(statements.remainder());
        const bool is_new = wanted_.contains(name) && !found_.contains(name);
        material = is_new ? &found_[name] : nullptr;
        dissolved = false;
      } else if (!material) {
        continue;
      } else if (keyword == "Kd") {
        material->diffuse = read_color(statements, fmt::format("{}:{}", path, statements.line()));
      } else if (keyword == "d" || (keyword == "Tr" && !dissolved)) {
        dissolved = keyword == "d";
        material->alpha = read_alpha(statements, fmt::format("{}:{}", path, statements.line()));
        if (!dissolved) material->alpha = 1 - material->alpha;
      } else if (keyword == "Ke") {
        for (std::string_view word = statements.word(); !word.empty(); word = statements.word())
          if (const auto value = parse_float(word); value && *value > 0) not_drawn_.insert("emission");
      } else if (keyword.starts_with("map_") || keyword == "bump" || keyword == "disp" || keyword == "decal" ||
                 keyword == "norm" || keyword == "refl") {
        not_drawn_.insert("textures");
      }
    }
  }

  void complain_of_value(const std::string& place, std::string_view word, std::string_view what) {
    if (values_told_++ < told_materials)
      warnings_.push_back(
          fmt::format("{}: '{}' is not {}", printable(place), printable(word.substr(0, told_name)), what));
  }

  // Nothing when it is none that can be drawn. One number stands for all three.
  std::optional<glm::dvec3> read_color(ObjStatements& statements, const std::string& place) {
    std::string_view word = statements.word();
    if (word == "xyz" || word == "spectral") return std::nullopt;
    glm::dvec3 color;
    bool told = false;
    for (int c = 0; c < 3; ++c, word = statements.word()) {
      if (word.empty() && c > 0) {
        color[c] = color[0];
        continue;
      }
      const std::optional<float> value = parse_float(word);
      if (!value) {
        complain_of_value(place, word, "a part of a colour, from 0 to 1; the default colour is used");
        return std::nullopt;
      }
      color[c] = std::clamp<double>(*value, 0, 1);
      if (color[c] != *value && !std::exchange(told, true))
        complain_of_value(place, word, "a part of a colour, from 0 to 1, and is clamped");
    }
    return color;
  }

  double read_alpha(ObjStatements& statements, const std::string& place) {
    std::string_view word = statements.word();
    if (word == "-halo") word = statements.word();
    const std::optional<float> value = parse_float(word);
    if (!value) {
      complain_of_value(place, word, "a number from 0 to 1; 1 is used");
      return statements.keyword() == "d" ? 1 : 0;
    }
    return std::clamp<double>(*value, 0, 1);
  }

  void tell() {
    std::set<std::string> unknown, gone;
    for (const std::string& name : wanted_) {
      const auto found = found_.find(name);
      if (found == found_.end())
        unknown.insert(name);
      else if (found->second.alpha == 0)
        gone.insert(name);
    }
    if (!unknown.empty() && !file_.material_libraries.empty() && !missing_library_)
      warnings_.push_back(fmt::format("{}: no material library holds {}; the default colour is used",
                                      printable(file_.path), mtl_names(unknown)));
    if (!gone.empty())
      warnings_.push_back(fmt::format("{}: alpha is 0 (d 0 or Tr 1), so nothing is drawn of {}", printable(file_.path),
                                      mtl_names(gone)));
    std::string names;
    for (const std::string& what : not_drawn_) names += (names.empty() ? "" : ", ") + what;
    if (!names.empty()) warnings_.push_back("not drawn: " + names);
  }

  const ObjFile& file_;
  const ImportLimits& limits_;
  ImportBudget& budget_;
  ContentHash& hash_;
  std::vector<std::string>& warnings_;
  std::set<std::string> wanted_, tried_, not_drawn_;
  std::map<std::string, ObjMaterial> found_;
  std::size_t values_told_ = 0;
  bool missing_library_ = false;  // said already
};

}  // namespace

std::vector<ObjMaterial> read_materials(const ObjFile& file, const ImportLimits& limits, ImportBudget& budget,
                                        ContentHash& hash, std::vector<std::string>& warnings) {
  return MtlReader(file, limits, budget, hash, warnings).read();
}

}  // namespace morphcl
