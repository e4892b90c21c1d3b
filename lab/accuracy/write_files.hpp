// The report as files for programs: CSV, a line for each result and timing, and JSON.
#pragma once

#include <string>

#include "lab/accuracy/report.hpp"

namespace morphcl::accuracy {

std::string csv_of(const Report& report);
std::string json_of(const Report& report);              // the whole document
std::string json_line_of(const Report& report);         // on what it was measured, and how: one line
std::string json_of(const OperationReport& operation);  // one line

}  // namespace morphcl::accuracy
