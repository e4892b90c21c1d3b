// The report as text of at most 100 columns: a table an operation, and a sentence a family.
#pragma once

#include <string>

#include "lab/accuracy/report.hpp"

namespace morphcl::accuracy {

std::string machine_text(const Report& report);  // a few lines
std::string table_of(const OperationReport& operation);

}  // namespace morphcl::accuracy
