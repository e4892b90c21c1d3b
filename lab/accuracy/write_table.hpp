// The report as text of at most 100 columns: a line an operation, or a table an operation and a sentence a family.
#pragma once

#include <string>

#include "lab/accuracy/report.hpp"

namespace morphcl::accuracy {

std::string machine_text(const Report& report);  // a few lines

// A line an operation: the largest error of what morphcl computes over all its inputs, the bound that it is to keep,
// its time, and beside it the same of the form that one would write first. Errors over the bound have a mark.
std::string summary_of(const Report& report);

std::string table_of(const OperationReport& operation);

}  // namespace morphcl::accuracy
