// What one import may still take: every byte that is read, and every array that is made, is charged before it is taken.
//
// A model may grow by what it holds: some 50 times the bytes that were read, and 192 MiB whatever it holds. So a small
// file that claims much costs little.
#pragma once

#include <cstdint>
#include <string_view>

namespace morphcl {

class ImportBudget {
 public:
  // `bytes`: the most that any model may take.
  explicit ImportBudget(std::uint64_t bytes);

  std::uint64_t left_to_read() const { return limit_ - taken_; }
  // Takes what was read from files, and allows what it may become.
  void charge_read(std::uint64_t bytes, std::string_view place);
  // Takes count * bytes_each; Error(bad_input) at `place` when that is more than what is left.
  void charge(std::uint64_t count, std::uint64_t bytes_each, std::string_view place);

 private:
  std::uint64_t limit_, allowed_, taken_ = 0;
};

}  // namespace morphcl
