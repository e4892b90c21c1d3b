#include "host/scene/shot_elastic.hpp"

#include <fmt/format.h>

#include "host/scene/nearest_name.hpp"

namespace morphcl {

namespace {

void read_number(const ShotTable& table, const char* key, double least, double most, double& number) {
  const auto value = table.find(key);
  if (!value) return;
  number = value->number();
  if (!(number >= least && number <= most))
    value->fail(fmt::format("{} is {}; {} to {} is possible", key, number, least, most));
}

// Whether the text is `yes`; it has to be that or `no`.
bool read_choice(const ShotValue& value, const char* no, const char* yes) {
  const std::string& text = value.text();
  if (text != no && text != yes)
    value.fail(fmt::format("unknown {} \"{}\"{}", value.name(), text, suggestion(text, {no, yes})));
  return text == yes;
}

}  // namespace

Elastic read_elastic(const ShotValue& value) {
  const ShotTable table = value.table({"anchor", "stiffness", "damping", "edge_damping", "rest", "rule"});
  Elastic elastic;
  read_number(table, "anchor", min_elastic_anchor, max_elastic_stiffness, elastic.anchor);
  read_number(table, "stiffness", 0, max_elastic_stiffness, elastic.stiffness);
  read_number(table, "damping", 0, max_elastic_damping, elastic.damping);
  read_number(table, "edge_damping", 0, max_elastic_edge_damping, elastic.edge_damping);
  if (const auto rest = table.find("rest"))
    elastic.rest = read_choice(*rest, "driven", "base") ? EdgeRest::base : EdgeRest::driven;
  if (const auto rule = table.find("rule"))
    elastic.rule = read_choice(*rule, "equal", "by_length") ? EdgeStiffness::by_length : EdgeStiffness::equal;
  return elastic;
}

}  // namespace morphcl
