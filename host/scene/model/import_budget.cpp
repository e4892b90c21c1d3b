#include "host/scene/model/import_budget.hpp"

#include <fmt/format.h>

#include "morphcl/error.hpp"

namespace morphcl {

void ImportBudget::charge(std::uint64_t count, std::uint64_t bytes_each, std::string_view place) {
  if (bytes_each != 0 && count > left_ / bytes_each)
    throw Error(
        ErrorKind::bad_input, place,
        fmt::format("{} elements of {} bytes are more than what is left of the {} bytes that one model may take", count,
                    bytes_each, limit_));
  left_ -= count * bytes_each;
}

}  // namespace morphcl
