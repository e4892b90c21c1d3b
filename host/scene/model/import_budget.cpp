#include "host/scene/model/import_budget.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/memory_room.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {
constexpr std::uint64_t free_bytes = std::uint64_t{192} << 20, growth = 50;
}

ImportBudget::ImportBudget(std::uint64_t bytes, const std::atomic<bool>* stop)
    : limit_(bytes), whose_("one model may take"), stop_(stop) {
  if (const MemoryRoom room = memory_room(); room.bytes < limit_) {
    limit_ = room.bytes;
    whose_ = room.whose + " leaves";
    kind_ = ErrorKind::no_device;
  }
  allowed_ = std::min(limit_, free_bytes);
}

void ImportBudget::charge_file(const std::string& path, std::uint64_t bytes, std::string_view place) {
  inputs_.push_back(path);
  allowed_ += std::min(limit_ - allowed_, bytes > limit_ / growth ? limit_ : bytes * growth);
  charge(bytes, 1, place);
}

void ImportBudget::charge(std::uint64_t count, std::uint64_t bytes_each, std::string_view place) {
  go_on(place);
  if (bytes_each != 0 && count > (allowed_ - taken_) / bytes_each)
    throw Error(allowed_ < limit_ ? ErrorKind::bad_input : kind_, place,
                fmt::format("{} elements of {} bytes are more than what is left of the {} bytes that {}", count,
                            bytes_each, allowed_, allowed_ < limit_ ? "one model of its size may take" : whose_));
  taken_ += count * bytes_each;
}

void ImportBudget::stop_here(std::string_view place) {
  throw Error(ErrorKind::interrupted, place, "loading was interrupted; run the same command again");
}

}  // namespace morphcl
