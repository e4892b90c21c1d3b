#include "host/leftovers.hpp"

#include <mutex>
#include <utility>

namespace morphcl {

namespace {

struct LeftoverList {
  std::mutex mutex;
  std::list<std::string> paths;
};

// Never destroyed: leftovers may go later than static objects do.
LeftoverList& leftover_list() {
  static LeftoverList& list = *new LeftoverList;
  return list;
}

}  // namespace

Leftover::Leftover(std::string path) {
  LeftoverList& list = leftover_list();
  const std::lock_guard lock(list.mutex);
  entry_ = list.paths.insert(list.paths.end(), std::move(path));
}

Leftover::Leftover(std::string path, const std::function<void()>& make) {
  LeftoverList& list = leftover_list();
  const std::lock_guard lock(list.mutex);
  entry_ = list.paths.insert(list.paths.end(), std::move(path));
  make();
}

Leftover::~Leftover() {
  LeftoverList& list = leftover_list();
  const std::lock_guard lock(list.mutex);
  list.paths.erase(entry_);
}

std::vector<std::string> claim_leftovers() {
  LeftoverList& list = leftover_list();
  list.mutex.lock();  // and it stays locked
  return {list.paths.begin(), list.paths.end()};
}

}  // namespace morphcl
