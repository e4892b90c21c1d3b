// What a process has to remove when it ends at once, without running destructors.
#pragma once

#include <sys/types.h>

#include <functional>
#include <list>
#include <string>
#include <vector>

namespace morphcl {

struct LeftoverEntry {
  std::string path;
  pid_t process;  // that made it: a forked child leaves its parent's alone
};

// A file or folder that this process makes for itself and that must not outlive it; made and removed by the owner. It
// is on the list for as long as this lives.
class Leftover {
 public:
  explicit Leftover(std::string path);
  // The same of what `make` makes, which is then either on the list or not made: there is no gap.
  Leftover(std::string path, const std::function<void()>& make);
  ~Leftover();
  Leftover(const Leftover&) = delete;
  Leftover& operator=(const Leftover&) = delete;

  const std::string& path() const { return entry_->path; }

 private:
  std::list<LeftoverEntry>::iterator entry_;
};

// The paths of all that this process made, for who removes them and ends the process by _exit() or exec(). From then on
// no thread of this process makes another one or lets go of one: it waits instead, for ever. Not for signal handlers.
std::vector<std::string> claim_leftovers();

}  // namespace morphcl
