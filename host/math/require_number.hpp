// Numbers that are checked before they are used.
#pragma once

namespace morphcl {

// Throws Error(usage) "`name` is `value`; it must be `right`" unless `holds`.
void require_number(bool holds, const char* name, double value, const char* right);

}  // namespace morphcl
