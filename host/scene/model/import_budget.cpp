#include "host/scene/model/import_budget.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {
constexpr std::uint64_t free_bytes = std::uint64_t{192} << 20, growth = 50;
}

ImportBudget::ImportBudget(std::uint64_t bytes) : limit_(bytes), allowed_(std::min(bytes, free_bytes)) {}

void ImportBudget::charge_read(std::uint64_t bytes, std::string_view place) {
  allowed_ += std::min(limit_ - allowed_, bytes > limit_ / growth ? limit_ : bytes * growth);
  charge(bytes, 1, place);
}

void ImportBudget::charge(std::uint64_t count, std::uint64_t bytes_each, std::string_view place) {
  if (bytes_each != 0 && count > (allowed_ - taken_) / bytes_each)
    throw Error(ErrorKind::bad_input, place,
                fmt::format("{} elements of {} bytes are more than what is left of the {} bytes that one model {}",
                            count, bytes_each, allowed_, allowed_ < limit_ ? "of its size may take" : "may take"));
  taken_ += count * bytes_each;
}

}  // namespace morphcl
