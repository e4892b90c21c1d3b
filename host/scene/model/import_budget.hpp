// What one import may still take: every byte that is read, and every array that is made, is charged before it is taken.
//
// A model may grow by what it holds: some 50 times the bytes that were read, and 192 MiB whatever it holds. So a small
// file that claims much costs little. It is asked in every loop that grows with a file, so an import is stopped here.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "morphcl/error.hpp"

namespace morphcl {

class ImportBudget {
 public:
  // `bytes`: the most that any model may take; less where the system leaves this process less. `stop`: see go_on(); it
  // has to outlive this.
  explicit ImportBudget(std::uint64_t bytes, const std::atomic<bool>* stop = nullptr);

  std::uint64_t left_to_read() const { return limit_ - taken_; }
  // Takes what was read from a file, notes its path and allows what it may become.
  void charge_file(const std::string& path, std::uint64_t bytes, std::string_view place);
  // Takes count * bytes_each; an Error at `place` when that is more than what is left: bad_input, or no_device where
  // only this process is too small for the model. Calls go_on().
  void charge(std::uint64_t count, std::uint64_t bytes_each, std::string_view place);

  // Error(interrupted) at `place` once the import is to stop. Costs next to nothing.
  void go_on(std::string_view place) const {
    if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) stop_here(place);
  }

  const std::vector<std::string>& inputs() const { return inputs_; }  // paths of the files that were read

 private:
  [[noreturn]] static void stop_here(std::string_view place);

  std::uint64_t limit_, allowed_, taken_ = 0;
  std::string whose_;                      // names what sets limit_
  ErrorKind kind_ = ErrorKind::bad_input;  // of what is more than limit_
  const std::atomic<bool>* stop_;
  std::vector<std::string> inputs_;
};

}  // namespace morphcl
