// The hash of everything that was read for a scene: xxh3-128 over the pieces in reading order, each preceded by its
// length, so that moving a byte from one file to the next changes the hash.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace morphcl {

class ContentHash {
 public:
  ContentHash();
  ~ContentHash();
  ContentHash(ContentHash&&) noexcept;
  ContentHash& operator=(ContentHash&&) noexcept;

  void add(std::string_view bytes);  // one piece: a whole file, or the hex of another ContentHash
  std::string hex() const;           // 32 lower-case digits; more pieces may follow

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace morphcl
