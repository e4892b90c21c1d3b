// What one import may still take: every byte that is read, and every array that is made, is charged before it is taken.
#pragma once

#include <cstdint>
#include <string_view>

namespace morphcl {

class ImportBudget {
 public:
  explicit ImportBudget(std::uint64_t bytes) : limit_(bytes), left_(bytes) {}

  std::uint64_t left() const { return left_; }
  // Takes count * bytes_each; Error(bad_input) at `place` when that is more than what is left.
  void charge(std::uint64_t count, std::uint64_t bytes_each, std::string_view place);

 private:
  std::uint64_t limit_, left_;
};

}  // namespace morphcl
