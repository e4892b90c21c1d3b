// The report as a whole: complete, the same for the same seed, and written so that programs can read it.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "lab/accuracy/verdict.hpp"
#include "lab/accuracy/write_files.hpp"
#include "lab/accuracy/write_plot.hpp"
#include "lab/accuracy/write_table.hpp"
#include "morphcl/error.hpp"
#include "tests/lab/accuracy/one_operation.hpp"

namespace morphcl::accuracy {
namespace {

using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using testing::quick_report;

Report report_of(const std::vector<std::string>& names, std::uint64_t seed = 1) {
  Settings settings;
  settings.quick = true;
  settings.seed = seed;
  return run_report(settings, names, 0, [](const std::string&, std::size_t, std::size_t) {});
}

TEST(AccuracyReport, HasEveryOperation) {
  EXPECT_THAT(operation_names(), IsSupersetOf({"matrix-rotation",
                                               "matrix-look-at",
                                               "matrix-projection",
                                               "matrix-scale-about",
                                               "matrix-shear",
                                               "matrix-oblique",
                                               "matrix-axonometric",
                                               "compose",
                                               "point-transform",
                                               "divide",
                                               "viewport-snap",
                                               "clip",
                                               "coverage",
                                               "interpolation",
                                               "depth",
                                               "normal",
                                               "slerp",
                                               "lerp",
                                               "hermite",
                                               "spring",
                                               "point-in-polygon",
                                               "whole-frame",
                                               "antialiasing",
                                               "blending"}));
}

// Of the hashes of the quick report that do not lean on the C library, one after the other. The same by every compiler,
// at every optimisation and on every processor; another one only where an operation or its inputs are changed on
// purpose.
std::uint64_t bits_of(const OperationReport& report) {
  std::uint64_t bits = 0;
  for (const Result& result : report.results)
    if (!result.c_library) bits = bits * 31 + result.hash;
  return bits;
}

const std::map<std::string, std::uint64_t> bits_of_operations = {
    {"matrix-rotation", 0xf749ae140fd77e85},
    {"matrix-look-at", 0x8f08eb175d99839a},
    {"matrix-projection", 0xab6ff57edd58ba21},
    {"matrix-oblique", 0x10f4081b5be822c8},
    {"matrix-axonometric", 0x36eca8771c1bfb40},
    {"matrix-scale-about", 0x758025eec4bf45e1},
    {"matrix-shear", 0x708d8256b881bd87},
    {"compose", 0x2c9c849771f8c6b2},
    {"point-transform", 0x8fa20aa0aa5caa6e},
    {"divide", 0xf1cf602a8ab0a8d1},
    {"viewport-snap", 0x5986fd11e951bf80},
    {"clip", 0x7dc2e1bb6dac4ee5},
    {"coverage", 0xe0ad02c5650d4e59},
    {"interpolation", 0x32cf003ad58672f9},
    {"depth", 0x5dd8e88fbc8eac6c},
    {"normal", 0xbf91089d2375b175},
    {"face-normal", 0xd0248caf2d407e79},
    {"lerp", 0x82b5340d4ca22229},
    {"slerp", 0xcdda0f735ad5a5aa},
    {"rotation-angle", 0xf5d48590e8b92403},
    {"hermite", 0x5d443201354bc259},
    {"spring", 0x7924b47d56918ae1},
    {"spring-chain", 0xd2ca153cb4e8b30a},
    {"point-in-polygon", 0x8b9519a819dd26e0},
    {"whole-frame", 0xb70a3f6467174a28},
    {"antialiasing", 0xb0e18aab431743e7},
    {"blending", 0xba7615a2d480bd15},
};

// Every operation by its name, so that one that is wrong is named.
class EveryOperation : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryOperation, IsCompleteAndConfirmed) {
  const OperationReport report = quick_report(GetParam());
  EXPECT_TRUE(report.digits_confirmed);
  EXPECT_EQ(bits_of(report), bits_of_operations.at(GetParam())) << std::hex << "0x" << bits_of(report);
  ASSERT_FALSE(report.families.empty());
  std::set<std::string> first_variants;
  for (const Family& family : report.families) {
    std::set<std::string> variants;
    bool ships = false;
    for (const Result& result : report.results) {
      if (result.family != family.name) continue;
      variants.insert(result.variant);
      ships = ships || result.ships;
      EXPECT_GT(result.compared, 0u);
      EXPECT_TRUE(result.figures.has(report.about.plotted)) << result.variant;
      ASSERT_FALSE(result.timings.empty()) << result.variant;
      for (const Timing& timing : result.timings) {
        EXPECT_GE(timing.runs, 30);
        EXPECT_GT(timing.elements, 0u);
        EXPECT_GT(timing.minimum_ns, 0);
        EXPECT_LE(timing.minimum_ns, timing.median_ns);
        EXPECT_NE(timing.level, "");
      }
    }
    EXPECT_GE(variants.size(), 4u) << family.name;
    EXPECT_TRUE(ships) << "nothing that morphcl computes on " << family.name;
    EXPECT_NE(verdict(report, family.name), "");
    if (first_variants.empty()) first_variants = variants;
    EXPECT_EQ(variants, first_variants) << family.name;
  }
}

std::string test_name(const ::testing::TestParamInfo<std::string>& parameter) {
  std::string name = parameter.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Accuracy, EveryOperation, ::testing::ValuesIn(operation_names()), test_name);

TEST(AccuracyReport, ErrorsFollowFromTheSeedAlone) {
  const OperationReport first = quick_report("lerp"), again = quick_report("lerp"), other = quick_report("lerp", 2);
  ASSERT_EQ(first.results.size(), again.results.size());
  bool differs = false;
  for (std::size_t i = 0; i < first.results.size(); ++i) {
    EXPECT_EQ(first.results[i].hash, again.results[i].hash);
    EXPECT_TRUE(same_digits(first.results[i].figures, again.results[i].figures));
    differs = differs || first.results[i].hash != other.results[i].hash;
  }
  EXPECT_TRUE(differs);
}

TEST(AccuracyReport, AnUnknownOperationIsRefusedWithTheListOfThem) {
  try {
    report_of({"lerp", "lerq"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_THAT(error.what(), HasSubstr("'lerq'"));
    EXPECT_THAT(error.what(), HasSubstr("point-transform"));
  }
}

TEST(AccuracyReport, JsonHoldsEveryFigure) {
  const Report report = report_of({"clip", "normal"});
  const nlohmann::json json = nlohmann::json::parse(json_of(report));
  EXPECT_EQ(json["operations"].size(), 2u);
  EXPECT_TRUE(json["digits_confirmed"]);
  EXPECT_GE(json["reference_bits"], 113);
  EXPECT_EQ(json["confirming_bits"], 2 * json["reference_bits"].get<int>());
  for (const nlohmann::json& operation : json["operations"])
    for (const nlohmann::json& result : operation["results"]) {
      EXPECT_TRUE(result["errors"].contains(operation["target_measure"].get<std::string>())) << result;
      EXPECT_FALSE(result["timings"].empty());
    }
}

TEST(AccuracyReport, CsvHasAColumnForEveryFieldOfEveryLine) {
  const std::string csv = csv_of(report_of({"clip"}));
  std::size_t lines = 0, columns = 0;
  std::istringstream stream(csv);
  for (std::string line; std::getline(stream, line); ++lines) {
    // Names of variants are quoted and hold commas.
    bool quoted = false;
    std::size_t fields = 1;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      if (c == ',' && !quoted) ++fields;
    }
    if (lines == 0) columns = fields;
    EXPECT_EQ(fields, columns) << line;
  }
  EXPECT_GT(lines, 10u);
}

TEST(AccuracyReport, TablesFitOnATerminalOfAHundredColumns) {
  for (const char* name : {"point-transform", "coverage", "depth", "lerp"}) {
    std::istringstream stream(table_of(quick_report(name)));
    for (std::string line; std::getline(stream, line);) {
      const bool sentence = line.starts_with("  ->") || line.starts_with(name) || line.starts_with("  target");
      if (!sentence) {
        EXPECT_LE(line.size(), 100u) << line;
      }
    }
  }
}

TEST(AccuracyReport, ThePlotNamesEveryVariantAndTheTarget) {
  const Report report = report_of({"interpolation"});
  const std::string program = plot_program(report, "it's here.svg");
  for (const Result& result : report.operations[0].results) EXPECT_THAT(program, HasSubstr("'" + result.variant + "'"));
  EXPECT_THAT(program, HasSubstr("set output 'it''s here.svg'"));
  EXPECT_THAT(program, HasSubstr("target 5"));
  EXPECT_THAT(program, HasSubstr("set xlabel 'time, ns an element'"));
}

// Shape (outlined) and colour of each mark that has a name in a plot, plot by plot.
std::vector<std::multimap<std::string, std::string>> marks_by_plot(const std::string& program) {
  std::vector<std::multimap<std::string, std::string>> plots;
  const std::regex mark("pt (\\d+) ps [0-9.]+ lc rgb '(#[0-9a-f]+)' title '([^']*(?:''[^']*)*)'");
  std::istringstream stream(program);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with("plot ")) continue;
    plots.emplace_back();
    for (std::sregex_iterator i(line.begin(), line.end(), mark), end; i != end; ++i)
      plots.back().emplace((*i)[3], std::to_string(std::stoi((*i)[1]) / 2 * 2) + (*i)[2].str());
  }
  return plots;
}

TEST(AccuracyReport, AVariantHasOneMarkInAllPlotsAndSharesItWithNoneBesideIt) {
  const Report report = report_of({"matrix-look-at", "matrix-shear", "matrix-scale-about", "point-transform", "divide",
                                   "clip", "lerp", "normal", "face-normal", "interpolation", "spring"});
  const auto plots = marks_by_plot(plot_program(report, "a.svg"));
  EXPECT_EQ(plots.size(), 11u * (3u + 1u)) << "three families, and the names";
  std::map<std::string, std::set<std::string>> marks_of_variant;
  for (const auto& plot : plots) {
    std::set<std::string> in_plot;
    for (const auto& [variant, mark] : plot) {
      EXPECT_TRUE(in_plot.insert(mark).second) << variant << " looks like another one";
      marks_of_variant[variant].insert(mark);
    }
  }
  EXPECT_GT(marks_of_variant.size(), 40u);
  for (const auto& [variant, marks] : marks_of_variant) EXPECT_EQ(marks.size(), 1u) << variant;
}

TEST(AccuracyReport, TheNamesOfAnOperationAreThoseOfItsPlotsOnceEach) {
  const Report report = report_of({"divide", "blending"});
  const auto plots = marks_by_plot(plot_program(report, "a.svg"));
  ASSERT_EQ(plots.size(), 8u);
  for (std::size_t operation = 0; operation < 2; ++operation) {
    std::map<std::string, std::string> shown;
    for (std::size_t family = 0; family < 3; ++family)
      shown.insert(plots[4 * operation + family].begin(), plots[4 * operation + family].end());
    const auto& names = plots[4 * operation + 3];
    EXPECT_EQ((std::multimap<std::string, std::string>(shown.begin(), shown.end())), names);
  }
}

TEST(AccuracyReport, WhatTheDeviceDrawsHasTheHostsColorAndIsACross) {
  Report report = report_of({"blending"});
  OperationReport& blending = report.operations[0];
  const std::size_t count = blending.results.size();
  for (std::size_t i = 0; i < count; ++i) {
    Result on_device = blending.results[i];
    on_device.variant = "device, " + on_device.variant;
    on_device.place = "device";
    blending.results.push_back(on_device);
  }
  const auto names = marks_by_plot(plot_program(report, "a.svg")).back();
  EXPECT_EQ(names.size(), 14u);
  for (const char* const name : {"front to back, fused", "back to front", "fp64"}) {
    ASSERT_EQ(names.count(name), 1u);
    ASSERT_EQ(names.count(std::string(name) + " (device)"), 1u);
    const std::string on_device = names.find(std::string(name) + " (device)")->second;
    EXPECT_EQ(on_device[0], '0') << "a cross is shape 1";
    EXPECT_EQ(names.find(name)->second.substr(names.find(name)->second.find('#')),
              on_device.substr(on_device.find('#')));
  }
}

TEST(AccuracyReport, TheSummaryHasALineAnOperationAndMarksWhatIsOverItsBound) {
  const Report report = report_of({"lerp", "point-transform"});
  const std::string summary = summary_of(report);
  std::istringstream stream(summary);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    EXPECT_LE(line.size(), 110u) << line;
    lines.push_back(line);
  }
  ASSERT_EQ(lines.size(), 5u) << summary;
  EXPECT_THAT(lines[2], ::testing::MatchesRegex("  lerp +scaled +1\\.6 +2 .*  a \\+ t \\(b - a\\)"));
  EXPECT_THAT(lines[1], ::testing::MatchesRegex("  point-transform +pixels +[0-9.]+  ! +0\\.01 .*  fp32 naive"));
  EXPECT_THAT(lines[3], HasSubstr("! point-transform: over the bound for these inputs: adversarial"));
}

}  // namespace
}  // namespace morphcl::accuracy
