#include "host/scene/shot/shot_elastic.hpp"

#include <fmt/format.h>

namespace morphcl {

namespace {

void read_number(const ShotTable& table, const char* key, double min, double max, double& number) {
  const auto value = table.find(key);
  if (!value) return;
  number = value->number();
  if (!(number >= min && number <= max))
    value->fail(fmt::format("{} is {}; {} to {} is possible", key, number, min, max));
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
    elastic.rest = rest->choose("driven", "base") ? EdgeRest::base : EdgeRest::driven;
  if (const auto rule = table.find("rule"))
    elastic.rule = rule->choose("equal", "by_length") ? EdgeStiffness::by_length : EdgeStiffness::equal;
  return elastic;
}

}  // namespace morphcl
