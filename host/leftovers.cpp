#include "host/leftovers.hpp"

#include <unistd.h>

#include <mutex>
#include <utility>

namespace morphcl {

namespace {

struct LeftoverList {
  std::mutex mutex;
  std::list<LeftoverEntry> entries;
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
  entry_ = list.entries.insert(list.entries.end(), {std::move(path), getpid()});
}

Leftover::Leftover(std::string path, const std::function<void()>& make) {
  LeftoverList& list = leftover_list();
  const std::lock_guard lock(list.mutex);
  entry_ = list.entries.insert(list.entries.end(), {std::move(path), getpid()});
  make();
}

Leftover::~Leftover() {
  LeftoverList& list = leftover_list();
  const std::lock_guard lock(list.mutex);
  list.entries.erase(entry_);
}

std::vector<std::string> claim_leftovers() {
  LeftoverList& list = leftover_list();
  list.mutex.lock();  // and it stays locked
  std::vector<std::string> paths;
  for (const LeftoverEntry& entry : list.entries)
    if (entry.process == getpid()) paths.push_back(entry.path);
  return paths;
}

}  // namespace morphcl
